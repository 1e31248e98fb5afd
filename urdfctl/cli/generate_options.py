"""The options of the commands that generate, and which command has which."""

from __future__ import annotations

import inspect
import re
from collections.abc import Callable
from typing import Annotated

import typer
from typer.core import TyperCommand

from urdfctl.cli.options import (
    ConfigFile,
    Distro,
    Environment,
    Memory,
    PackagePath,
    Simulator,
    Timeout,
    Trust,
    Workspace,
)
from urdfctl.hints import Any

_Words = Annotated[
    list[str] | None,
    typer.Argument(
        help="A robot, a list of joints (text, CSV, YAML, or - for standard input), and name:=value; "
        "nothing: the robot found here.",
        metavar="[ROBOT|LIST|-] [NAME:=VALUE]...",
        show_default=False,
    ),
]
_List = list[str] | None
_Text = str | None


def _list(flag: str, text: str) -> tuple[Any, Any]:
    return Annotated[_List, typer.Option(flag, help=f"{text} Repeatable.")], None


def _text(flags: str, text: str) -> tuple[Any, Any]:
    return Annotated[_Text, typer.Option(*flags.split(), help=text)], None


def _flag(flag: str, text: str, *, default: bool = False) -> tuple[Any, Any]:
    return Annotated[bool, typer.Option(flag, help=text)], default


_TYPES = (
    "effort, velocity, position, trajectory, gripper, diff_drive, ackermann, bicycle, tricycle, mecanum, omni, pid, "
    "admittance, imu_broadcaster, ..., or a controller's full name."
)
_OPTIONS: dict[str, tuple[Any, Any]] = {
    "words": (_Words, None),
    "types": _list("--type", _TYPES),
    "joints": _list("--joints", "Only joints that this regular expression matches as a whole."),
    "exclude": _list("--exclude", "Not the joints that this one matches."),
    "joint": _list("--joint", "Just these joints, in this order: NAME,NAME."),
    "interface": _text("--interface", "What the joints are commanded by: position, velocity or effort; or NAME,NAME."),
    "command": _text("--command", "The command interface: position, velocity or effort."),
    "state": _text("--state", "The states that are read: position,velocity; none: nothing is measured."),
    "chain": _flag("--chain", "Each --type commands the next one, and the last the hardware."),
    "hardware": _text("--hardware", "gz, gazebo-classic, mock, mujoco, topic-based, or a plugin's full name."),
    "group": _flag("--group", "One group controller for all joints, where the distro has it."),
    "namespace": _text("--namespace", "The namespace of the robot."),
    "name": _text("--name", "What the controller is called."),
    "left": _list("--left", "The wheels on the left, the front one first: NAME,NAME."),
    "right": _list("--right", "The wheels on the right."),
    "traction": _list("--traction", "The driven wheels, the left one first."),
    "steering": _list("--steering", "The joints that steer, the left one first."),
    "sensor": _text("--sensor", "The sensor of a broadcaster."),
    "frame": _text("--frame", "The link of the sensor, or of the tool."),
    "broadcaster": _flag("--broadcaster/--no-broadcaster", "With the broadcaster of joint states.", default=True),
    "rate": (Annotated[int, typer.Option("--rate", min=1, max=100_000, help="Hz of the controller manager.")], 100),
    "package": _text("--package", "The package that the files will be in."),
    "controllers": _text("--controllers", "The controllers' file, below that package."),
    "macro": _flag("--macro", "A xacro macro and one call for each joint."),
    "form": _text("--form", "ROS 2: python, xml or yaml."),
    "templates": _text("--templates", "A folder with templates of yours, by the same names."),
    "list_templates": _flag("--list-templates", "List the templates, and leave."),
    "output": _text("-o --output", "Write there, not to standard output."),
    "force": _flag("--force", "Overwrite what is there."),
    "diff": _flag("--diff", "Show what would change."),
    "check": _flag("--check", "Change nothing; exit with 1 if what is there is stale."),
    "into": _text("--into", "Insert it into this xacro file, byte for byte the same elsewhere."),
    "distro": (Distro, None),
    "simulator": (Simulator, None),
    "workspace": (Workspace, None),
    "package_path": (PackagePath, None),
    "env": (Environment, None),
    "trust": (Trust, False),
    "timeout": (Timeout, 20.0),
    "memory": (Memory, 2048),
    "config": (ConfigFile, None),
}
_JOINTS = ("words", "joints", "exclude", "joint")
_WRITING = (
    "templates", "list_templates", "output", "force", "diff", "check", "distro", "simulator", "workspace",
    "package_path", "env", "trust", "timeout", "memory", "config",
)  # fmt: skip
_CONTROLLERS = (
    "types", "chain", "interface", "state", "group", "namespace", "name", "left", "right", "traction", "steering",
    "sensor", "frame", "broadcaster", "rate",
)  # fmt: skip
COMMANDS: dict[str, tuple[str, str, tuple[str, ...]]] = {
    "gen-controllers": (
        "Write the controllers' YAML file.",
        "urdfctl gen-controllers robot.xacro --type trajectory --joints 'arm_.*' -o config/controllers.yaml",
        (*_JOINTS, *_CONTROLLERS, *_WRITING),
    ),
    "gen-transmissions": (
        "Write the transmissions of ROS 1, as a xacro file to include.",
        "urdfctl gen-transmissions robot.xacro --interface effort --macro --distro noetic -o urdf/transmissions.xacro",
        (*_JOINTS, *_CONTROLLERS, "macro", *_WRITING, "into"),
    ),
    "gen-ros2-control": (
        "Write the <ros2_control> tag of ROS 2, as a xacro file to include.",
        "urdfctl gen-ros2-control robot.xacro --command position --state position,velocity --hardware mock",
        (*_JOINTS, "command", "hardware", *(o for o in _CONTROLLERS if o != "interface"), *_WRITING, "into"),
    ),
    "gen-gazebo": (
        "Write the simulator's plugin that runs the controllers, as a xacro file to include.",
        "urdfctl gen-gazebo --simulator gz --distro jazzy --package my_robot --into urdf/robot.xacro",
        (*_JOINTS, "namespace", "package", "controllers", *_WRITING, "into"),
    ),
    "gen-launch": (
        "Write a launch file that starts robot and controllers.",
        "urdfctl gen-launch robot.xacro --type trajectory --simulator gz -o launch/control.launch.py",
        (*_JOINTS, *_CONTROLLERS, "package", "controllers", "form", *_WRITING),
    ),
    "gen-all": (
        "Write a package with all of it: robot, controllers, launch file and dependencies.",
        "urdfctl gen-all robot.xacro --type effort --distro jazzy --simulator gz -o my_robot_control",
        (*_JOINTS, "hardware", *_CONTROLLERS, "package", "controllers", "form", "macro", *_WRITING),
    ),
}


class _OneDash(TyperCommand):
    """Takes `-type effort` for `--type effort`: a comment of XML may not hold two dashes, and says what made a file."""

    def parse_args(self, ctx: Any, args: list[str]) -> Any:
        return super().parse_args(ctx, [re.sub(r"^-(?=[a-z]{2})", "--", word) for word in args])


def add_commands(app: typer.Typer) -> None:
    """Add the commands to the application."""
    for name, (summary, example, options) in COMMANDS.items():
        short = re.split("[,:]", summary)[0].rstrip(".") + "."
        app.command(name, cls=_OneDash, short_help=short, help=f"{summary}\n\n\b\nExample: {example}")(
            _command(name, options)
        )
    about = "Make generated files again, each by the command that its first lines name; exit with 1 if one is stale."
    short = "Tell whether generated files are up to date."
    app.command("gen-check", short_help=short, help=f"{about}\n\n\b\nExample: urdfctl gen-check config urdf launch")(
        _check_command
    )


def _check_command(
    paths: Annotated[
        list[str] | None,
        typer.Argument(help="Files, and folders to look through; nothing: this one.", show_default=False),
    ] = None,
    update: Annotated[bool, typer.Option("--update", help="Write what is stale again.")] = False,  # noqa: FBT002
) -> None:
    from urdfctl.cli.generate_again import run_again

    raise typer.Exit(run_again(paths or [], update=update))


def _command(name: str, options: tuple[str, ...]) -> Callable[..., None]:
    def run(**given: Any) -> None:
        from urdfctl.cli.generate_command import run_generate

        raise typer.Exit(run_generate(name, given))

    parameters = [
        inspect.Parameter(key, inspect.Parameter.KEYWORD_ONLY, default=_OPTIONS[key][1], annotation=_OPTIONS[key][0])
        for key in options
    ]
    run.__signature__ = inspect.Signature(parameters)  # type: ignore[attr-defined]
    run.__annotations__ = {key: _OPTIONS[key][0] for key in options}
    return run
