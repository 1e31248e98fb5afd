"""Options of the commands that show a robot: why. Annotations are evaluated here; see options.py."""

from dataclasses import dataclass
from typing import Annotated

import typer

from urdfctl.cli.options import TargetOptions


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
