"""Options of the commands that show a robot: why, diff, graph, view. Annotations are evaluated here; see options.py."""

from dataclasses import dataclass
from typing import Annotated

import typer

from urdfctl.cli.options import Paths, ReadingOptions, TargetOptions


@dataclass(kw_only=True)
class WhyOptions(TargetOptions):
    """Show where a value of a robot comes from, and what uses it.

    \b
    Example: urdfctl why urdf/robot.xacro joint:elbow/limit/@velocity prefix:=left_
             urdfctl why config/joint_limits.yaml:12
    """

    words: Annotated[
        list[str],
        typer.Argument(
            help="The robot (or its launch file) and a value in it, such as joint:NAME/limit/@velocity; or the place "
            "FILE:LINE[:COL] of a value; and name:=value arguments.",
            metavar="[ROBOT] VALUE [NAME:=VALUE]...",
            show_default=False,
        ),
    ]
    output_format: Annotated[
        str, typer.Option("--format", help="Output format: text or json. FORMAT=FILE writes a file.")
    ] = "text"


@dataclass(kw_only=True)
class DiffOptions(ReadingOptions):
    """Show what changed between two robots: their models, not their text. Order, blanks and macros are no difference.

    \b
    Example: urdfctl diff origin/main: urdf/robot.xacro --format markdown
             urdfctl diff urdf/robot.xacro model:=small urdf/robot.xacro model:=big
    """

    words: Annotated[
        list[str],
        typer.Argument(
            help="Two files, folders, or git revisions with a path (HEAD~1:urdf/robot.xacro; HEAD~1: takes the path of "
            "the other side), each with its name:=value arguments.",
            metavar="A [NAME:=VALUE]... B [NAME:=VALUE]...",
            show_default=False,
        ),
    ]
    diff_formats: Annotated[
        list[str] | None,
        typer.Option("--format", help="Output format. FORMAT=FILE writes a file. Repeatable."),
    ] = None
    areas: Annotated[
        str | None,
        typer.Option(
            "--fail-on", help="Exit with status 1 on changes in these areas, e.g. limits,joints,interfaces; or any."
        ),
    ] = None


@dataclass(kw_only=True)
class GraphOptions(TargetOptions):
    """Draw what is wired to what: topics, controllers, interfaces, hardware and joints, with lint's errors in red.

    \b
    Example: urdfctl graph launch/bringup.launch.py --format html=graph.html
    """

    paths: Paths = None
    graph_formats: Annotated[
        list[str] | None,
        typer.Option("--format", help="Output format. FORMAT=FILE writes a file. Repeatable. Default: mermaid."),
    ] = None
    focus: Annotated[
        list[str] | None, typer.Option(help="Show only what leads to this joint, controller or topic, or away from it.")
    ] = None
    collapse: Annotated[
        bool | None,
        typer.Option(
            "--collapse/--no-collapse",
            help="Show joints with the same wiring as one. Default: with more than 30 joints, except in json.",
        ),
    ] = None
    start: Annotated[
        str | None, typer.Option(help="Controllers that are started together, in this order: NAME,NAME, or all.")
    ] = None


@dataclass(kw_only=True)
class ViewOptions(TargetOptions):
    """Show the robot in 3-D, its joints coloured by how they are controlled: a page that needs no network.

    \b
    Example: urdfctl view urdf/robot.xacro -o robot.html
    """

    paths: Paths = None
    output: Annotated[
        str | None, typer.Option("-o", "--output", help="Write the page to this file. Default: robot.html.")
    ] = None
    image: Annotated[str | None, typer.Option(help="Write a picture (PNG) to this file, without a page.")] = None
    start: Annotated[
        str | None, typer.Option(help="Controllers that are started together, in this order: NAME,NAME, or all.")
    ] = None
