"""Options of `urdfctl schema`. Annotations are evaluated here; see options.py."""

from dataclasses import dataclass
from typing import Annotated

import typer


@dataclass(kw_only=True)
class SchemaOptions:
    """Print a schema of controller files, <ros2_control> or URDF for your editor, or check files with it.

    \b
    Example: urdfctl schema controllers --distro jazzy > controllers.schema.json
             urdfctl schema --check config/controllers.yaml --distro jazzy
    """

    kind: Annotated[
        str | None,
        typer.Argument(
            help="controllers: JSON Schema 2020-12 of controller files; ros2_control: XML Schema of a robot with "
            "<ros2_control>; urdf: XML Schema of URDF. Default with --check: from the file.",
            metavar="[controllers|ros2_control|urdf]",
            show_default=False,
        ),
    ] = None
    distro: Annotated[str | None, typer.Option(help="ROS distro. Default: $ROS_DISTRO.", show_default=False)] = None
    checked: Annotated[
        list[str] | None,
        typer.Option("--check", metavar="FILE", help="Check this file, and print what does not fit. Repeatable."),
    ] = None
