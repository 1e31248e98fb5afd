"""The options that every command has which reads a robot."""

from __future__ import annotations

import os
from typing import Annotated

import typer

from urdfctl.settings import Settings, passed_on

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
Start = Annotated[str | None, typer.Option(help="The controllers started together: NAME,NAME.")]
Workspace = Annotated[str | None, typer.Option(help="The folder that bounds what may be read.")]
PackagePath = Annotated[list[str] | None, typer.Option(help="A folder with packages, looked at first. Repeatable.")]
Environment = Annotated[list[str] | None, typer.Option(help="Let $(env NAME) see this variable. Repeatable.")]
Trust = Annotated[bool, typer.Option("--trust", help="Read and evaluate whatever the description asks for.")]
Timeout = Annotated[float, typer.Option(help="Seconds for one robot.")]
Memory = Annotated[int, typer.Option(help="MiB for one robot.")]


def settings_from(  # noqa: PLR0913, PLR0917 (one for each option)
    distro: str | None,
    simulator: str | None,
    start: str | None,
    workspace: str | None,
    package_path: list[str] | None,
    env: list[str] | None,
    trust: bool,  # noqa: FBT001
    timeout: float,
    memory: int,
) -> Settings:
    """The settings of a run, from its options and the environment."""
    started = None if start is None else tuple(name.strip() for name in start.split(",") if name.strip())
    return Settings(
        distro,
        simulator,
        started,
        workspace,
        tuple(package_path or ()),
        passed_on(os.environ, tuple(env or ())),
        trust,
        timeout,
        memory << 20,
    )


def split_arguments(words: list[str] | tuple[str, ...]) -> tuple[list[str], dict[str, str]]:
    """Paths and `name:=value` arguments, told apart as xacro does; one without a value is left out, as xacro does."""
    paths, arguments = [], {}
    for word in words:
        name, mark, value = word.partition(":=")
        if not mark:
            paths.append(word)
        elif name.strip() and value.strip():
            arguments[name.strip()] = value.strip()
    return paths, arguments
