"""Typer's command line, from the declarations of the commands: help, completion, and errors in what was typed."""

from __future__ import annotations

import inspect
from collections.abc import Callable, Sequence
from functools import cache
from typing import Annotated, Any

import typer
from typer.core import TyperCommand, TyperGroup
from typer.main import get_command

from urdfctl.commands import COMMANDS, command_named
from urdfctl.commands.declaring import GROUPS, Command, Option, Options
from urdfctl.commands.reach import run_command
from urdfctl.commands.slips import command_hint
from urdfctl.errors import UserError

_CONTEXT = {"help_option_names": ["-h", "--help"], "max_content_width": 120}
_HELP = "Lint, smoke-test, expand and explain the control configuration of robots in URDF and xacro, without ROS."


class Commands(TyperGroup):
    """The commands in their groups, with an answer to words that are none. Only the one that is typed is imported."""

    def list_commands(self, ctx: Any) -> list[str]:  # noqa: ARG002 (the same for each context)
        """Return the names of the commands."""
        return list(COMMANDS)

    def get_command(self, ctx: Any, cmd_name: str) -> Any:  # noqa: ARG002
        """Return a command as a list shows it: with its name and its summary."""
        return TyperCommand(cmd_name, short_help=COMMANDS[cmd_name].summary) if cmd_name in COMMANDS else None

    def resolve_command(self, ctx: Any, args: list[str]) -> Any:
        """Return the command that the first word names. UserError if it is clear what else is meant."""
        if args[0] in COMMANDS:
            return args[0], typed_command(args[0]), args[1:]
        hint = command_hint(args[0])
        if hint is not None:
            raise UserError(hint)
        return super().resolve_command(ctx, args)

    def format_commands(self, ctx: Any, formatter: Any) -> None:  # noqa: ARG002
        """Write the commands in their groups, one under the other."""
        width = max(map(len, COMMANDS))
        for group in dict.fromkeys(listed.group for listed in COMMANDS.values()):
            rows = [(name.ljust(width), one.summary) for name, one in COMMANDS.items() if one.group == group]
            with formatter.section(group):
                formatter.write_dl(rows)


class GroupedCommand(TyperCommand):
    """A command whose help shows its options in groups."""

    options: type[Options]

    def parse_args(self, ctx: Any, args: list[str]) -> Any:
        """Parse the words."""
        return super().parse_args(ctx, list(self.options.plain_words(args)))

    def format_options(self, ctx: Any, formatter: Any) -> None:
        """Write the arguments, then the options in groups."""
        records: dict[str, list[tuple[str, str]]] = {name: [] for name in ("Arguments", *GROUPS)}
        for parameter in self.get_params(ctx):
            record = parameter.get_help_record(ctx)
            if record is not None:
                declared = self.options.declared.get(parameter.name or "")
                is_option = parameter.param_type_name == "option"
                records[(declared.group if declared else GROUPS[-1]) if is_option else "Arguments"].append(record)
        used = {name: entries for name, entries in records.items() if entries}
        options = [name for name in used if name != "Arguments"]
        for name, entries in used.items():
            with formatter.section("Options" if options == [name] else name):
                formatter.write_dl(entries)


@cache
def typed_command(name: str) -> GroupedCommand:
    """Return a command as typer reads it."""
    command = command_named(name)
    alone = typer.Typer(add_completion=False, rich_markup_mode=None, context_settings=_CONTEXT)
    alone.command(name, cls=GroupedCommand, short_help=COMMANDS[name].summary)(_callback(command))
    typed: Any = get_command(alone)
    typed.options = command.options
    return typed  # type: ignore[no-any-return]


def _callback(command: Command) -> Callable[..., None]:
    """The function that typer calls: its signature says which options there are."""
    declared = command.options.declared

    def called(**values: Any) -> None:
        lists = {name: tuple(value) if declared[name].is_list else value for name, value in values.items() if value}
        falsy = {name: value for name, value in values.items() if not value and value is not None}
        given = {name: value for name, value in {**falsy, **lists}.items() if value != declared[name].default}
        raise typer.Exit(run_command(command, command.options(**given)))

    parameters = [_parameter(name, option) for name, option in declared.items()]
    vars(called)["__signature__"] = inspect.Signature(parameters)
    called.__doc__ = command.options.__doc__
    return called


def _parameter(name: str, option: Option) -> inspect.Parameter:
    """An option as a parameter of a function, in the way that typer reads it."""
    kind: Any = list[str] if option.is_list else option.type
    default = None if option.is_list else option.default
    if not option.flags:
        info = typer.Argument(help=option.help, metavar=_metavar(option), show_default=False)
    else:
        least, greatest = option.bounds or (None, None)
        info = typer.Option(
            *map("/".join, zip(option.flags, option.negatives, strict=True)) if option.negatives else option.flags,
            help=option.help,
            metavar=None if option.type is bool else _metavar(option) or "VALUE",
            min=least,
            max=greatest,
            hidden=option.hidden,
            autocompletion=_completing(option.choices) if option.choices else None,
        )
    return inspect.Parameter(
        name,
        inspect.Parameter.KEYWORD_ONLY,
        default=inspect.Parameter.empty if option.is_required else default,
        annotation=Annotated[kind if option.is_required or default is not None else kind | None, info],
    )


def _metavar(option: Option) -> str | None:
    if option.metavar or not option.choices:
        return option.metavar
    return f"[{'|'.join(option.choices)}{'|...' if option.is_open else ''}]"


def _completing(choices: Sequence[str]) -> Callable[[str], list[str]]:
    def completed(incomplete: str) -> list[str]:
        return [choice for choice in choices if choice.startswith(incomplete)]

    return completed


def _version(requested: bool) -> None:  # noqa: FBT001 (typer's callback)
    if requested:
        from urdfctl import __version__

        typer.echo(f"urdfctl {__version__}")
        raise typer.Exit


app = typer.Typer(
    name="urdfctl",
    no_args_is_help=True,
    cls=Commands,
    rich_markup_mode=None,
    pretty_exceptions_enable=False,
    context_settings=_CONTEXT,
    help=_HELP,
)


@app.callback(help=_HELP)
def main(
    version: Annotated[
        bool, typer.Option("--version", "-V", callback=_version, is_eager=True, help="Show the version and exit.")
    ] = False,
) -> None:
    """Take the options that stand before a command."""


def run_by_typer(words: Sequence[str]) -> int:
    """Run a command line, given without the program's name, and return the exit status: 2 if it is wrong."""
    try:
        app(list(words), prog_name="urdfctl")
    except SystemExit as leaving:
        return leaving.code if isinstance(leaving.code, int) else 0
    return 0
