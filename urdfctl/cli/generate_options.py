"""The commands that generate files, and their options; each option is declared once."""

import re
from dataclasses import dataclass
from typing import Annotated, ClassVar

import typer

from urdfctl.cli.help import GroupedCommand
from urdfctl.cli.options import TargetOptions
from urdfctl.startup.hints import Any


def _option(flag: str, help: str) -> typer.models.OptionInfo:  # noqa: A002 (typer's own name)
    info: typer.models.OptionInfo = typer.Option(*flag.split(), help=help)
    return info


_Text = str | None
_List = list[str] | None
_TYPES = (
    "Controller type: effort, velocity, position, trajectory, gripper, diff_drive, ackermann, bicycle, tricycle, "
    "mecanum, omni, pid, admittance, imu_broadcaster, ..., or the full name of a type. Repeatable."
)

_CONTROLLER = (
    "A controller and its joints: NAME=TYPE or NAME=TYPE:JOINTS, where JOINTS are names or regular expressions with "
    "commas between them; with its command interfaces, NAME=TYPE[effort]:JOINTS. Repeatable. Without this and --type, "
    "controllers are proposed from the robot."
)


@dataclass(kw_only=True)
class GenerateOptions(TargetOptions):
    """Options of every generator."""

    command: ClassVar[str]

    words: Annotated[
        _List,
        typer.Argument(
            help="A robot, a list of joints (text, CSV, YAML, JSON, or - for standard input), and name:=value "
            "arguments. Default: the robot found in this folder.",
            metavar="[ROBOT|LIST|-] [NAME:=VALUE]...",
            show_default=False,
        ),
    ] = None
    joints: Annotated[_List, _option("--joints", "Joints that match this regular expression. Repeatable.")] = None
    exclude: Annotated[_List, _option("--exclude", "Leave out joints that match this one. Repeatable.")] = None
    joint: Annotated[_List, _option("--joint", "These joints, in this order: NAME,NAME. Repeatable.")] = None
    templates: Annotated[_Text, _option("--templates", "Folder with templates of your own.")] = None
    list_templates: Annotated[bool, _option("--list-templates", "List the templates, then exit.")] = False
    output: Annotated[_Text, _option("-o --output", "Write to this file or folder.")] = None
    force: Annotated[bool, _option("--force", "Overwrite existing files.")] = False
    diff: Annotated[bool, _option("--diff", "Show what would change.")] = False
    check: Annotated[bool, _option("--check", "Write nothing; exit with status 1 if a file is out of date.")] = False


@dataclass(kw_only=True)
class ControllerOptions(GenerateOptions):
    """Options for the controllers and their joints."""

    types: Annotated[_List, _option("--type", _TYPES)] = None
    controller: Annotated[_List, _option("--controller", _CONTROLLER)] = None
    chain: Annotated[
        bool,
        _option("--chain", "Let each --type command the next one; the last one commands the hardware."),
    ] = False
    state: Annotated[_Text, _option("--state", "State interfaces: position,velocity; or none.")] = None
    group: Annotated[bool, _option("--group", "One group controller for all joints, if the distro has one.")] = False
    namespace: Annotated[_Text, _option("--namespace", "Namespace of the robot.")] = None
    name: Annotated[_Text, _option("--name", "Name of the controller.")] = None
    left: Annotated[_List, _option("--left", "Wheels on the left, front first: NAME,NAME. Repeatable.")] = None
    right: Annotated[_List, _option("--right", "Wheels on the right, front first. Repeatable.")] = None
    traction: Annotated[_List, _option("--traction", "Driven wheels, left first. Repeatable.")] = None
    steering: Annotated[_List, _option("--steering", "Joints that steer, left first. Repeatable.")] = None
    sensor: Annotated[_Text, _option("--sensor", "Sensor of a broadcaster.")] = None
    frame: Annotated[_Text, _option("--frame", "Link of the sensor, or of the tool.")] = None
    broadcaster: Annotated[bool, _option("--broadcaster/--no-broadcaster", "Add a joint state broadcaster.")] = True
    rate: Annotated[
        int | None,
        typer.Option(
            "--rate",
            min=1,
            max=100_000,
            help="Update rate of the controller manager, in Hz. Default: 100, or 1000 if a PID loop commands efforts.",
            show_default=False,
        ),
    ] = None


@dataclass(kw_only=True)
class InterfaceOption(GenerateOptions):
    """The command interface of the joints."""

    interface: Annotated[
        _Text, _option("--interface", "Command interface: position, velocity or effort; or NAME,NAME.")
    ] = None


@dataclass(kw_only=True)
class HardwareOption(GenerateOptions):
    """The hardware plugin."""

    hardware: Annotated[
        _Text,
        _option("--hardware", "Hardware: gz, gazebo-classic, mock, mujoco, topic-based, or a plugin."),
    ] = None


@dataclass(kw_only=True)
class InsertOption(GenerateOptions):
    """The file to insert the output into."""

    into: Annotated[_Text, _option("--into", "Insert into this xacro file and change nothing else there.")] = None


@dataclass(kw_only=True)
class MacroOption(GenerateOptions):
    """The form of xacro."""

    macro: Annotated[bool, _option("--macro", "Write a xacro macro and one call for each joint.")] = False


@dataclass(kw_only=True)
class PlaceOptions(GenerateOptions):
    """The places of the installed files."""

    package: Annotated[_Text, _option("--package", "Package that will contain the files.")] = None
    controllers: Annotated[_Text, _option("--controllers", "Controller file, relative to that package.")] = None


@dataclass(kw_only=True)
class BaseOption(GenerateOptions):
    """How the robot stands in a simulator."""

    base: Annotated[
        _Text,
        _option("--base", "fixed or free: whether the robot is fixed to the world. Default: free with wheels or legs."),
    ] = None


@dataclass(kw_only=True)
class LaunchFormOption(GenerateOptions):
    """The form of the launch file."""

    form: Annotated[_Text, _option("--form", "Form of a ROS 2 launch file: python, xml or yaml.")] = None


@dataclass(kw_only=True)
class GenerateControllers(ControllerOptions, InterfaceOption):
    """Write the controllers' YAML file.

    \b
    Example: urdfctl gen-controllers robot.xacro --type trajectory --joints 'arm_.*' -o config/controllers.yaml
    """

    command = "gen-controllers"


@dataclass(kw_only=True)
class GenerateTransmissions(ControllerOptions, InterfaceOption, MacroOption, InsertOption):
    """Write the ROS 1 transmissions, as a xacro file to include.

    \b
    Example: urdfctl gen-transmissions robot.xacro --interface effort --macro --distro noetic -o urdf/joints.xacro
    """

    command = "gen-transmissions"


@dataclass(kw_only=True)
class GenerateRos2Control(ControllerOptions, HardwareOption, InsertOption):
    """Write the <ros2_control> tag of ROS 2, as a xacro file to include.

    \b
    Example: urdfctl gen-ros2-control robot.xacro --command position --state position,velocity --hardware mock
    """

    command = "gen-ros2-control"

    command_interface: Annotated[_Text, _option("--command", "Command interface: position, velocity or effort.")] = None


@dataclass(kw_only=True)
class GenerateGazebo(PlaceOptions, InsertOption):
    """Write the simulator plugin that runs the controllers, as a xacro file to include.

    \b
    Example: urdfctl gen-gazebo --simulator gz --distro jazzy --package my_robot --into urdf/robot.xacro
    """

    command = "gen-gazebo"

    namespace: Annotated[_Text, _option("--namespace", "Namespace of the robot.")] = None


@dataclass(kw_only=True)
class GenerateLaunch(ControllerOptions, InterfaceOption, PlaceOptions, BaseOption, LaunchFormOption):
    """Write a launch file that starts the robot and its controllers.

    \b
    Example: urdfctl gen-launch robot.xacro --type trajectory --simulator gz -o launch/control.launch.py
    """

    command = "gen-launch"


@dataclass(kw_only=True)
class GenerateAll(
    ControllerOptions, InterfaceOption, HardwareOption, PlaceOptions, BaseOption, LaunchFormOption, MacroOption
):
    """Write a package with all of it: robot, controllers, launch file and dependencies.

    \b
    Example: urdfctl gen-all robot.xacro --type effort --distro jazzy --simulator gz -o my_robot_control
    """

    command = "gen-all"


@dataclass(kw_only=True)
class ConvertRobot(InterfaceOption, BaseOption):
    """Convert a robot to MuJoCo's own format: meshes, an actuator for each commanded joint, mimic joints and sensors.

    \b
    Example: urdfctl convert robot.xacro --to mjcf -o robot.xml
    """

    command = "convert"

    to: Annotated[_Text, _option("--to", "Format to convert to: mjcf.")] = None


GENERATORS: dict[str, type[GenerateOptions]] = {
    generator.command: generator
    for generator in (
        GenerateControllers,
        GenerateTransmissions,
        GenerateRos2Control,
        GenerateGazebo,
        GenerateLaunch,
        GenerateAll,
        ConvertRobot,
    )
}


def short_help(generator: type[GenerateOptions]) -> str:
    """Return the first clause of a generator's summary."""
    summary = (generator.__doc__ or "").partition("\n")[0]
    return re.split("[,:]", summary)[0].rstrip(".") + "."


class OneDashCommand(GroupedCommand):
    """Accepts `-type effort` for `--type effort`: an XML comment that names its command cannot contain `--`."""

    def parse_args(self, ctx: Any, args: list[str]) -> Any:
        """Parse the words with two dashes before long options."""
        return super().parse_args(ctx, [re.sub(r"^-(?=[a-z]{2})", "--", word) for word in args])


@dataclass(kw_only=True)
class CheckGeneratedOptions:
    """Run the command in the first lines of each generated file again; exit with status 1 if one is out of date.

    \b
    Example: urdfctl gen-check config urdf launch
    """

    paths: Annotated[
        _List, typer.Argument(help="Files and folders to search. Default: this folder.", show_default=False)
    ] = None
    update: Annotated[bool, typer.Option("--update", help="Write the files that are out of date.")] = False
