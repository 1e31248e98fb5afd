"""The options of `urdfctl init`."""

from dataclasses import dataclass
from typing import Annotated

import typer

from urdfctl.cli.options import TargetOptions


@dataclass(kw_only=True)
class InitOptions(TargetOptions):
    """Write an urdfctl.toml with the robots of a folder, its distro and its simulator.

    \b
    Example: urdfctl init --distro jazzy --simulator gz --pre-commit --workflow
    """

    folder: Annotated[str, typer.Argument(help="Folder of the project. Default: this folder.", show_default=False)] = (
        "."
    )
    pre_commit: Annotated[
        bool | None,
        typer.Option("--pre-commit/--no-pre-commit", help="Add the pre-commit hook.", show_default=False),
    ] = None
    workflow: Annotated[
        bool | None,
        typer.Option("--workflow/--no-workflow", help="Add a workflow for GitHub.", show_default=False),
    ] = None
    force: Annotated[bool, typer.Option("--force", help="Overwrite existing files.")] = False
