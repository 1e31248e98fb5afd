"""Read the words of `urdfctl lint` and `urdfctl smoke` without typer, whose import takes a third of a run.

For anything but plain options with values (`--help`, an unknown option, a missing value) this returns None: typer then
reads the words again and reports what is wrong. `lint_table.py` and `smoke_table.py` are generated from the options
that typer reads.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from importlib import import_module
from types import ModuleType

from urdfctl.startup.hints import Any

COMMANDS = ("lint", "smoke")
_TYPES: dict[str, Callable[[str], Any]] = {"str": str, "int": int, "float": float}


class _Options:
    """The attributes of LintOptions or SmokeOptions, without its import."""


def options_of(command: str, words: Sequence[str]) -> Any | None:
    """Return the options that the words of one of `COMMANDS` set; None if typer has to read them."""
    table = table_of(command)
    given = plain_options(words, table)
    if given is None:
        return None
    options: Any = _Options()
    options.__dict__.update(table.DEFAULTS)
    options.__dict__.update(given)
    return options


def table_of(command: str) -> ModuleType:
    """Return the generated table of a command's options."""
    return import_module(f"urdfctl.cli.{command}_table")


def plain_options(words: Sequence[str], table: ModuleType) -> dict[str, Any] | None:
    """Return the options that the words set, by name; None if typer has to read them."""
    options: dict[str, Any] = {}
    paths: list[str] = []
    rest = iter(words)
    for word in rest:
        if not word.startswith("-"):
            paths.append(word)
            continue
        flag, mark, value = word.partition("=")
        if flag in table.FLAGS and not mark:
            options[table.FLAGS[flag]] = True
        elif flag in table.VALUES or flag in table.REPEATABLE:
            given = value if mark else next(rest, None)
            if given is None or (not mark and given.startswith("-")) or not _set(options, flag, given, table):
                return None
        else:
            return None
    return {"paths": paths, **options}


def _set(options: dict[str, Any], flag: str, given: str, table: ModuleType) -> bool:
    if flag in table.REPEATABLE:
        options.setdefault(table.REPEATABLE[flag], []).append(given)
        return True
    name, type_name = table.VALUES[flag]
    try:
        options[name] = _TYPES[type_name](given)
    except ValueError:
        return False
    return True


def table_text(command: str) -> str:
    """Return the text of the table of one of `COMMANDS`."""
    import inspect

    from typer.main import get_command

    from urdfctl.cli import options
    from urdfctl.cli.app import app

    flags: dict[str, str] = {}
    values: dict[str, tuple[str, str]] = {}
    repeatable: dict[str, str] = {}
    typed: Any = get_command(app).commands[command]  # type: ignore[attr-defined]
    for parameter in typed.params:
        for flag in parameter.opts if parameter.param_type_name == "option" and parameter.name != "help" else ():
            if parameter.is_flag:
                flags[flag] = parameter.name
            elif parameter.multiple:
                repeatable[flag] = parameter.name
            else:
                values[flag] = parameter.name, type(parameter.type("7")).__name__
    signature = inspect.signature(getattr(options, f"{command.title()}Options"))
    defaults = {name: found.default for name, found in signature.parameters.items()}
    return (
        f'"""The options of `{command}`, as fast_path.py needs them.\n\n'
        f"Generated from options.py: python -m urdfctl.cli.fast_path {command} > urdfctl/cli/{command}_table.py\n"
        '"""\n\nfrom __future__ import annotations\n\n'
        f"FLAGS = {_dict(flags)}\nREPEATABLE = {_dict(repeatable)}\nVALUES = {_dict(values)}\n"
        f"DEFAULTS: dict[str, object] = {_dict(defaults)}\n"
    )


def _dict(entries: dict[str, Any]) -> str:
    return "".join(["{\n", *(f"    {_quoted(key)}: {_quoted(value)},\n" for key, value in entries.items()), "}"])


def _quoted(value: object) -> str:
    return repr(value).replace("'", '"')


if __name__ == "__main__":
    import sys

    sys.stdout.write(table_text(sys.argv[1] if len(sys.argv) > 1 else COMMANDS[0]))
