"""The command line: which command runs what, with which class of options."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from functools import partial
from typing import Annotated, Any

import typer
from typer.core import TyperGroup

from urdfctl.cli.generate_options import (
    GENERATORS,
    CheckGeneratedOptions,
    GenerateOptions,
    OneDashCommand,
    short_help,
)
from urdfctl.cli.help import GroupedCommand
from urdfctl.cli.init_options import InitOptions
from urdfctl.cli.migrate_options import MigrateOptions
from urdfctl.cli.options import ExpandOptions, ExplainOptions, LintOptions, RulesOptions, ShowOptions, SmokeOptions
from urdfctl.cli.schema_options import SchemaOptions
from urdfctl.cli.see_options import DiffOptions, GraphOptions, ViewOptions, WhyOptions
from urdfctl.cli.server_options import ServerOptions
from urdfctl.cli.slips import command_hint
from urdfctl.errors import UserError


def _lint(options: LintOptions) -> int:
    from urdfctl.cli.lint_command import run_lint

    return run_lint(options)


def _smoke(options: SmokeOptions) -> int:
    from urdfctl.cli.smoke_command import run_smoke

    return run_smoke(options)


def _show(options: ShowOptions) -> int:
    from urdfctl.cli.show_command import run_show

    return run_show(options)


def _expand(options: ExpandOptions) -> int:
    from urdfctl.cli.expand_command import run_expand

    return run_expand(options)


def _diff(options: DiffOptions) -> int:
    from urdfctl.cli.diff_command import run_diff

    return run_diff(options)


def _graph(options: GraphOptions) -> int:
    from urdfctl.cli.graph_command import run_graph

    return run_graph(options)


def _view(options: ViewOptions) -> int:
    from urdfctl.cli.view_command import run_view

    return run_view(options)


def _why(options: WhyOptions) -> int:
    from urdfctl.cli.why_command import run_why

    return run_why(options)


def _rules(options: RulesOptions) -> int:
    from urdfctl.cli.rules_command import run_rules
    from urdfctl.cli.words import codes

    return run_rules(options.output_format, codes(options.select))


def _explain(options: ExplainOptions) -> int:
    from urdfctl.cli.explain_command import CheckIn, run_explain

    files = CheckIn(options.folder, options.distro)
    return run_explain(options.what or [], options.output_format, files, options.output_file)


def _init(options: InitOptions) -> int:
    from urdfctl.cli.init_command import run_init

    return run_init(options)


def _migrate(options: MigrateOptions) -> int:
    from urdfctl.cli.migrate_command import run_migrate

    return run_migrate(options)


def _server(options: ServerOptions) -> int:
    from urdfctl.cli.server_command import run_server

    return run_server(options)


def _schema(options: SchemaOptions) -> int:
    from urdfctl.cli.schema_command import run_schema

    return run_schema(options)


def _generate(options: GenerateOptions) -> int:
    from urdfctl.cli.generate_command import run_generate

    return run_generate(options)


def _check_generated(options: CheckGeneratedOptions) -> int:
    from urdfctl.cli.generate_again import run_again

    return run_again(options.paths or [], run_words, update=options.update)


_RUN: dict[type, Callable[[Any], int]] = {
    LintOptions: _lint,
    SmokeOptions: _smoke,
    ShowOptions: _show,
    ExpandOptions: _expand,
    WhyOptions: _why,
    GraphOptions: _graph,
    ViewOptions: _view,
    DiffOptions: _diff,
    RulesOptions: _rules,
    ExplainOptions: _explain,
    CheckGeneratedOptions: _check_generated,
    InitOptions: _init,
    MigrateOptions: _migrate,
    ServerOptions: _server,
    SchemaOptions: _schema,
    **dict.fromkeys(GENERATORS.values(), _generate),
}


def _run(options: object, **_: object) -> None:
    raise typer.Exit(_RUN[type(options)](options))


class Commands(TyperGroup):
    """The commands, with an answer to words that are none."""

    def resolve_command(self, ctx: Any, args: list[str]) -> Any:
        """Return the command that the first word names. UserError if it is clear what else is meant."""
        if self.get_command(ctx, args[0]) is None:
            hint = command_hint(args[0])
            if hint is not None:
                raise UserError(hint)
        return super().resolve_command(ctx, args)


app = typer.Typer(
    name="urdfctl",
    no_args_is_help=True,
    cls=Commands,
    rich_markup_mode=None,
    pretty_exceptions_enable=False,
    context_settings={"help_option_names": ["-h", "--help"], "max_content_width": 120},
    help="Lint, smoke-test, expand and explain the control configuration of robots in URDF and xacro, without ROS.",
    result_callback=_run,
)


def _version(requested: bool) -> None:  # noqa: FBT001 (typer's callback)
    if requested:
        from urdfctl import __version__

        typer.echo(f"urdfctl {__version__}")
        raise typer.Exit


@app.callback()
def main(
    version: Annotated[
        bool, typer.Option("--version", "-V", callback=_version, is_eager=True, help="Show the version and exit.")
    ] = False,
) -> None:
    """Lint, smoke-test, expand and explain the control configuration of robots in URDF and xacro, without ROS."""


_command = partial(app.command, cls=GroupedCommand)
_command("lint", short_help="Find what keeps a robot from starting and moving.")(LintOptions)
_command("smoke", short_help="Load, start and move each controller, without ROS.")(SmokeOptions)
_command("show", short_help="Show what is started together.")(ShowOptions)
_command("expand", short_help="Expand xacro without ROS.")(ExpandOptions)
_command("why", short_help="Show where a value of a robot comes from, and what uses it.")(WhyOptions)
_command("diff", short_help="Show what changed between two robots, as models.")(DiffOptions)
_command("graph", short_help="Draw what is wired to what, with errors in red.")(GraphOptions)
_command("view", short_help="Show the robot in 3-D, in one page.")(ViewOptions)
_command("rules")(RulesOptions)
_command("explain", short_help="Explain a rule, an error message, or a whole log.")(ExplainOptions)
_command("init", short_help="Write a configuration with the robots of a project.")(InitOptions)
_command("migrate", short_help="Migrate packages to another ROS distro.")(MigrateOptions)
_command("schema", short_help="Print a schema for your editor, or check files with it.")(SchemaOptions)
_command("server", short_help="Serve an editor: findings while you type.")(ServerOptions)
for name, generator in GENERATORS.items():
    app.command(name, cls=OneDashCommand, short_help=short_help(generator))(generator)
_command("gen-check", short_help="Check that generated files are up to date.")(CheckGeneratedOptions)


def run_words(words: Sequence[str]) -> int:
    """Run a command line without the program name, and return its exit status."""
    from typer.main import get_command

    status: int = get_command(app).main(list(words), prog_name="urdfctl", standalone_mode=False)
    return status
