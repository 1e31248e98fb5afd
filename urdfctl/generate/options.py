"""What is asked of the generators, and what they give."""

from __future__ import annotations

from urdfctl.catalog.distros import generation
from urdfctl.record import NamedTuple


class File(NamedTuple):
    """A generated file: its name, below the folder that it belongs in, and its text."""

    name: str
    text: str


class Roles(NamedTuple):
    """The joints of a drive by what they do, each side from front to rear, pairs from left to right."""

    left: tuple[str, ...] = ()
    right: tuple[str, ...] = ()
    traction: tuple[str, ...] = ()
    steering: tuple[str, ...] = ()


class Options(NamedTuple):
    """What the user asks for. `command` is how to say it again; `rate` is the controller manager's, in Hz.

    `types` are short names or full names of controllers' types; `interfaces` are what they command, `states` what they
    read: () for nothing, None (like `hardware`) where the rest decides. `chain`: each type commands the next.
    `controllers_file`, `description` and `package` tell where the files will be found when they run; `robot_file` is
    how a xacro file beside them includes the robot, and `arguments` what it is given.
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
    rate: int = 100
    package: str | None = None
    controllers_file: str = "config/controllers.yaml"
    description: str | None = None
    robot_file: str = "robot.urdf"
    arguments: tuple[tuple[str, str], ...] = ()
    macro: bool = False
    form: str = "python"
    chain: bool = False
    command: str = "urdfctl"

    @property
    def interface(self) -> str | None:
        """The first interface that is asked for."""
        return self.interfaces[0] if self.interfaces else None

    @property
    def ros(self) -> int:
        """1 or 2."""
        return generation(self.distro)

    @property
    def simulated(self) -> bool:
        """Whether a simulator keeps the time."""
        return self.simulator != "none"
