"""The options of the commands that generate files. Several commands share most of them: `of` names those that have one.

Their order is that of the command in the first line of a generated file.
"""

from __future__ import annotations

import re
from collections.abc import Sequence
from typing import ClassVar

from urdfctl.commands.answering import AnswerOptions
from urdfctl.commands.declaring import CONTROLLERS, JOINTS, OTHER, OUTPUT, Reads, argument, option
from urdfctl.commands.options import TargetOptions

_TYPES = (
    "Controller type: effort, velocity, position, trajectory, gripper, diff_drive, ackermann, bicycle, tricycle, "
    "mecanum, omni, pid, admittance, imu_broadcaster, ..., or the full name of a type. Repeatable."
)
_CONTROLLER = (
    "A controller and its joints: NAME=TYPE or NAME=TYPE:JOINTS, where JOINTS are names or regular expressions with "
    "commas between them; with its command interfaces, NAME=TYPE[effort]:JOINTS. Repeatable. Without this and --type, "
    "controllers are proposed from the robot."
)
_INTERFACES = ("position", "velocity", "effort")
_HARDWARE = ("gz", "gazebo-classic", "mock", "mujoco", "topic-based")
_WITH_CONTROLLERS = (
    "gen-controllers",
    "gen-transmissions",
    "gen-ros2-control",
    "gen-launch",
    "gen-all",
    "gen-moveit",
)
PACKAGES = ("gen-all", "gen-moveit")
"""The commands that write a package."""
_INSERTED = ("gen-transmissions", "gen-ros2-control", "gen-gazebo")
_INSTALLED = ("gen-gazebo", "gen-launch", *PACKAGES)


class GenerateOptions(TargetOptions, AnswerOptions):
    """Options of every generator, with the defaults of those that not every generator has."""

    command: ClassVar[str]

    words: tuple[str, ...] = argument(
        "A robot, a list of joints (text, CSV, YAML, JSON, or - for standard input), and name:=value arguments. "
        "Default: the robot found in this folder.",
        metavar="[ROBOT|LIST|-] [NAME:=VALUE]...",
    )
    joints: tuple[str, ...] = option(JOINTS, "Joints that match this regular expression.", metavar="REGEX")
    exclude: tuple[str, ...] = option(JOINTS, "Leave out joints that match this one.", metavar="REGEX")
    joint: tuple[str, ...] = option(JOINTS, "These joints, in this order: NAME,NAME.", metavar="NAME,...")
    templates: str | None = option(OUTPUT, "Folder with templates of your own.", metavar="FOLDER", reads=Reads.PLACE)
    list_templates: bool = option(OUTPUT, "List the templates, then exit.")
    output: str | None = option(
        OUTPUT, "Write to this file or folder.", "-o", "--output", metavar="PATH", reads=Reads.TARGET
    )
    force: bool = option(OUTPUT, "Overwrite existing files.")
    diff: bool = option(OUTPUT, "Show what would change.")
    check: bool = option(OUTPUT, "Write nothing; exit with status 1 if a file is out of date.")
    into: str | None = option(
        OUTPUT,
        "Insert into this xacro file and change nothing else there.",
        metavar="FILE",
        reads=Reads.TARGET,
        of=_INSERTED,
    )
    macro: bool = option(
        OUTPUT, "Write a xacro macro and one call for each joint.", of=("gen-transmissions", *PACKAGES)
    )
    form: str | None = option(
        OUTPUT,
        "Form of a ROS 2 launch file: python, xml or yaml.",
        choices=("python", "xml", "yaml"),
        of=("gen-launch", *PACKAGES),
    )
    fix_inertia: bool = option(
        OUTPUT,
        "Copy the robot, with the nearest inertia that a body can have in place of impossible ones.",
        of=("gen-all",),
    )
    base: str | None = option(
        OTHER,
        "fixed or free: whether the robot is fixed to the world. Default: free with wheels or legs.",
        of=("gen-launch", *PACKAGES, "convert"),
    )
    package: str | None = option(OUTPUT, "Package that will contain the files.", metavar="NAME", of=_INSTALLED)
    controllers: str | None = option(
        CONTROLLERS,
        "Controller file, relative to that package.",
        metavar="FILE",
        reads=Reads.PLACE,
        of=_INSTALLED,
    )
    hardware: str | None = option(
        CONTROLLERS,
        "Hardware: gz, gazebo-classic, mock, mujoco, topic-based, or a plugin.",
        choices=_HARDWARE,
        is_open=True,
        of=("gen-ros2-control", *PACKAGES),
    )
    interface: str | None = option(
        CONTROLLERS,
        "Command interface: position, velocity or effort; or NAME,NAME.",
        choices=_INTERFACES,
        is_open=True,
        of=("gen-controllers", "gen-transmissions", "gen-launch", *PACKAGES, "convert"),
    )
    types: tuple[str, ...] = option(CONTROLLERS, _TYPES, "--type", metavar="TYPE", of=_WITH_CONTROLLERS)
    controller: tuple[str, ...] = option(CONTROLLERS, _CONTROLLER, metavar="NAME=TYPE[:JOINTS]", of=_WITH_CONTROLLERS)
    chain: bool = option(
        CONTROLLERS,
        "Let each --type command the next one; the last one commands the hardware.",
        of=_WITH_CONTROLLERS,
    )
    state: str | None = option(
        CONTROLLERS,
        "State interfaces: position,velocity; or none.",
        metavar="NAME,...",
        of=_WITH_CONTROLLERS,
    )
    group: bool = option(
        CONTROLLERS,
        "One group controller for all joints, if the distro has one.",
        of=[name for name in _WITH_CONTROLLERS if name != "gen-moveit"],
    )
    planning_groups: tuple[str, ...] = option(
        JOINTS,
        "A planning group: NAME=BASE:TIP for the chain between two links, or NAME=JOINT,JOINT; others are proposed, "
        "one for each controller. Repeatable.",
        "--group",
        metavar="NAME=BASE:TIP",
        of=("gen-moveit",),
    )
    moveit: bool = option(OTHER, "Configure MoveIt too, as gen-moveit does.", of=("gen-all",))
    samples: int = option(
        OTHER,
        "Poses in which the links are tested for collisions, for MoveIt.",
        default=10_000,
        bounds=(1, 10_000_000),
        metavar="N",
        of=PACKAGES,
    )
    seed: int = option(OTHER, "Seed of these poses.", default=0, bounds=(0, 2**31 - 1), metavar="N", of=PACKAGES)
    namespace: str | None = option(
        CONTROLLERS, "Namespace of the robot.", metavar="NAME", of=(*_WITH_CONTROLLERS, "gen-gazebo")
    )
    name: str | None = option(CONTROLLERS, "Name of the controller.", metavar="NAME", of=_WITH_CONTROLLERS)
    left: tuple[str, ...] = option(
        JOINTS, "Wheels on the left, front first: NAME,NAME.", metavar="NAME,...", of=_WITH_CONTROLLERS
    )
    right: tuple[str, ...] = option(
        JOINTS, "Wheels on the right, front first.", metavar="NAME,...", of=_WITH_CONTROLLERS
    )
    traction: tuple[str, ...] = option(JOINTS, "Driven wheels, left first.", metavar="NAME,...", of=_WITH_CONTROLLERS)
    steering: tuple[str, ...] = option(
        JOINTS, "Joints that steer, left first.", metavar="NAME,...", of=_WITH_CONTROLLERS
    )
    sensor: str | None = option(CONTROLLERS, "Sensor of a broadcaster.", metavar="NAME", of=_WITH_CONTROLLERS)
    frame: str | None = option(CONTROLLERS, "Link of the sensor, or of the tool.", metavar="NAME", of=_WITH_CONTROLLERS)
    broadcaster: bool = option(CONTROLLERS, "Add a joint state broadcaster.", default=True, of=_WITH_CONTROLLERS)
    rate: int | None = option(
        CONTROLLERS,
        "Update rate of the controller manager, in Hz. Default: 100, or 1000 if a PID loop commands efforts.",
        bounds=(1, 100_000),
        metavar="HZ",
        of=_WITH_CONTROLLERS,
    )
    command_interface: str | None = option(
        CONTROLLERS,
        "Command interface: position, velocity or effort.",
        "--command",
        choices=_INTERFACES,
        is_open=True,
        of=("gen-ros2-control",),
    )
    to: str | None = option(OUTPUT, "Format: mjcf for MuJoCo, sdf for gz.", choices=("mjcf", "sdf"), of=("convert",))

    def __init_subclass__(cls, *, command: str = "") -> None:
        super().__init_subclass__(command=command)
        cls.command = command

    @classmethod
    def plain_words(cls, given: Sequence[str]) -> Sequence[str]:
        """Return words with `--type` for `-type`: an XML comment that names its command cannot contain `--`."""
        return [re.sub(r"^-(?=[a-z]{2})", "--", word) for word in given]
