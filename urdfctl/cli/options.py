"""The options that every command has which reads a robot."""

from __future__ import annotations

from typing import Annotated

import typer

Arguments = Annotated[
    list[str] | None,
    typer.Argument(
        help="Robots, controllers.yaml, folders, and name:=value arguments; nothing: the package around this folder.",
        metavar="[PATH]... [NAME:=VALUE]...",
        show_default=False,
    ),
]
Distro = Annotated[str | None, typer.Option(help="The ROS distro, such as noetic or jazzy; else the files tell.")]
Simulator = Annotated[str | None, typer.Option(help="gz, gazebo-classic, mujoco, or none for real hardware.")]
Start = Annotated[str | None, typer.Option(help="The controllers started together, in their order: NAME,NAME, or all.")]
Workspace = Annotated[str | None, typer.Option(help="The folder that bounds what may be read.")]
PackagePath = Annotated[list[str] | None, typer.Option(help="A folder with packages, looked at first. Repeatable.")]
Environment = Annotated[list[str] | None, typer.Option(help="Let $(env NAME) see this variable. Repeatable.")]
Trust = Annotated[bool, typer.Option("--trust", help="Read and evaluate whatever the description asks for.")]
Timeout = Annotated[float, typer.Option(help="Seconds for one robot.")]
Memory = Annotated[int, typer.Option(help="MiB for one robot.")]
ConfigFile = Annotated[
    str | None, typer.Option("--config", help="This urdfctl.toml or pyproject.toml, not the nearest one upwards.")
]
