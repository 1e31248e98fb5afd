"""Input options and output files of the generators."""

from __future__ import annotations

from urdfctl.catalog.distros import generation
from urdfctl.startup.records import NamedTuple


class File(NamedTuple):
    """A generated file: its path relative to the output folder, and its text."""

    name: str
    text: str


class Roles(NamedTuple):
    """The joints of a drive by role. Each side is ordered from front to rear, pairs from left to right."""

    left: tuple[str, ...] = ()
    right: tuple[str, ...] = ()
    traction: tuple[str, ...] = ()
    steering: tuple[str, ...] = ()


class Request(NamedTuple):
    """A controller that is asked for.

    `name` is its name, empty for that of its type; `type` a short name or a full one. `patterns` name its joints, or
    the sensors or gpios that it reads; without any, it gets those that fit. `roles` are the joints of a drive by role.
    `interfaces` are those that it commands, () for those of the other options, of its joints or of its type.
    """

    name: str
    type: str
    patterns: tuple[str, ...] = ()
    roles: Roles | None = None
    interfaces: tuple[str, ...] = ()


class GeneratorOptions(NamedTuple):
    """The user's options. `command` is the command line that generates the files again.

    `types` are short names or full names of controller types, `requests` are controllers with their joints.
    `interfaces` are the interfaces that they command, `states` those that they read: () for none. If `states` or
    `hardware` is None, it is derived from the other options.
    With `chain`, each type commands the next. `rate` is the update rate of the controller manager, in Hz;
    None for the one that the controllers need. `base` is `fixed` or `free`; None for what the robot looks like.

    `controllers_file`, `description` and `package` are the places of the installed files. `robot_file` is the path by
    which a generated xacro file includes the robot, `arguments` are its xacro arguments, and `robot_text` is the
    path and text of a copy of the robot in the package. `model_path` is where a model
    for MuJoCo is written, and `to` the format that a robot is converted to. With `moveit`, MoveIt is configured
    too, with these `planning_groups` beside the proposed ones; `output` is the folder whose SRDF may have a person's
    changes. With `own`, the controllers are those that the robot's plugin loads from a file of its own. `launch` is the
    name under which a launch file is written, if that is not its usual one.
    """

    distro: str
    simulator: str = "none"
    types: tuple[str, ...] = ()
    interfaces: tuple[str, ...] = ()
    states: tuple[str, ...] | None = None
    hardware: str | None = None
    group: bool = False
    namespace: str = ""
    name: str | None = None
    roles: Roles = Roles()
    sensor: str | None = None
    frame: str | None = None
    broadcaster: bool = True
    rate: int | None = None
    package: str | None = None
    controllers_file: str = "config/controllers.yaml"
    description: str | None = None
    robot_file: str = "robot.urdf"
    robot_text: tuple[str, str] | None = None
    model_path: str | None = None
    to: str | None = None
    arguments: tuple[tuple[str, str], ...] = ()
    macro: bool = False
    form: str = "python"
    chain: bool = False
    base: str | None = None
    requests: tuple[Request, ...] = ()
    moveit: bool = False
    planning_groups: tuple[str, ...] = ()
    output: str | None = None
    own: bool = False
    launch: str | None = None
    command: str = "urdfctl"

    @property
    def interface(self) -> str | None:
        """The first requested interface."""
        return self.interfaces[0] if self.interfaces else None

    @property
    def ros(self) -> int:
        """The generation of ROS, 1 or 2."""
        return generation(self.distro)

    @property
    def simulated(self) -> bool:
        """Whether the robot runs in a simulator, which then provides the time."""
        return self.simulator != "none"
