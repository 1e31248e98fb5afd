"""The options of `urdfctl migrate`."""

from dataclasses import dataclass
from typing import Annotated

import typer

from urdfctl.catalog.distros import MAINTAINED
from urdfctl.cli.options import ReadingOptions

_TARGETS = [distro for distro in MAINTAINED if distro != "noetic"]


@dataclass(kw_only=True)
class MigrateOptions(ReadingOptions):
    """Migrate packages to another ROS distro: from one ROS 2 distro to a later one, from Gazebo Classic to gz, from
    ROS 1 to ROS 2. Shows a diff and writes nothing, unless --in-place or -o is given.

    \b
    Example: urdfctl migrate src/my_robot --to jazzy --in-place
    """

    paths: Annotated[
        list[str] | None,
        typer.Argument(
            help="Packages, or folders with packages. Default: the package around the current folder.",
            metavar="[PATH]...",
            show_default=False,
        ),
    ] = None
    to: Annotated[str | None, typer.Option("--to", help=f"ROS distro to migrate to: {', '.join(_TARGETS)}.")] = None
    source: Annotated[
        str | None, typer.Option("--from", help="ROS distro to migrate from. Default: detected from the files.")
    ] = None
    simulator: Annotated[
        str | None,
        typer.Option(help="Simulator after the migration. Default: the present one, or gz if that does not exist."),
    ] = None
    hardware: Annotated[
        str | None, typer.Option(help="Plugin of the real hardware: PACKAGE/CLASS.", metavar="PLUGIN")
    ] = None
    diff: Annotated[
        bool,
        typer.Option("--diff", help="Show the changes as a diff, the default. Exit with status 1 if there are any."),
    ] = False
    in_place: Annotated[bool, typer.Option("--in-place", help="Change the files.")] = False
    force: Annotated[
        bool,
        typer.Option("--force", help="Change files with uncommitted changes, and write to a folder that is not empty."),
    ] = False
    output: Annotated[
        str | None, typer.Option("-o", "--output", help="Write the migrated packages to this folder.", metavar="DIR")
    ] = None
    only: Annotated[
        list[str] | None,
        typer.Option(help="Migrate only these parts: urdf, yaml, launch, manifest, moveit; NAME,NAME. Repeatable."),
    ] = None
    launch: Annotated[str, typer.Option(help="Form of new launch files: py or xml.")] = "py"
    keep_classic: Annotated[
        bool, typer.Option("--keep-classic", help="Keep Gazebo Classic beside gz, behind a xacro argument.")
    ] = False
    report: Annotated[
        str | None,
        typer.Option(help="Write the report to this file (.md or .json). Default: MIGRATION.md beside the packages."),
    ] = None
    list_changes: Annotated[
        bool, typer.Option("--list", help="List the changes between two distros with their authority, then exit.")
    ] = False
