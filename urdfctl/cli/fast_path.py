"""Read the words of `urdfctl lint` without typer, whose import takes a third of a run.

For anything but plain options with values (`--help`, an unknown option, a missing value) this returns None: typer then
reads the words again and reports what is wrong. `lint_table.py` is generated from the options that typer reads.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence

from urdfctl.cli.lint_table import DEFAULTS, FLAGS, REPEATABLE, VALUES
from urdfctl.startup.hints import TYPE_CHECKING, Any

if TYPE_CHECKING:
    from urdfctl.cli.options import LintOptions

_TYPES: dict[str, Callable[[str], Any]] = {"str": str, "int": int, "float": float}


class _Options:
    """The attributes of LintOptions, without its import."""


def lint_options(words: Sequence[str]) -> LintOptions | None:
    """Return the options that the words of a lint command set; None if typer has to read them."""
    given = plain_options(words)
    if given is None:
        return None
    options: Any = _Options()
    options.__dict__.update(DEFAULTS)
    options.__dict__.update(given)
    return options  # type: ignore[no-any-return]


def plain_options(words: Sequence[str]) -> dict[str, Any] | None:
    """Return the options that the words set, by name; None if typer has to read them."""
    options: dict[str, Any] = {}
    paths: list[str] = []
    rest = iter(words)
    for word in rest:
        if not word.startswith("-"):
            paths.append(word)
            continue
        flag, mark, value = word.partition("=")
        if flag in FLAGS and not mark:
            options[FLAGS[flag]] = True
        elif flag in VALUES or flag in REPEATABLE:
            given = value if mark else next(rest, None)
            if given is None or (not mark and given.startswith("-")) or not _set(options, flag, given):
                return None
        else:
            return None
    return {"paths": paths, **options}


def _set(options: dict[str, Any], flag: str, given: str) -> bool:
    if flag in REPEATABLE:
        options.setdefault(REPEATABLE[flag], []).append(given)
        return True
    name, type_name = VALUES[flag]
    try:
        options[name] = _TYPES[type_name](given)
    except ValueError:
        return False
    return True


def table() -> str:
    """Return the text of lint_table.py."""
    import inspect

    from typer.main import get_command

    from urdfctl.cli.app import app
    from urdfctl.cli.options import LintOptions

    flags: dict[str, str] = {}
    values: dict[str, tuple[str, str]] = {}
    repeatable: dict[str, str] = {}
    lint: Any = get_command(app).commands["lint"]  # type: ignore[attr-defined]
    for parameter in lint.params:
        for flag in parameter.opts if parameter.param_type_name == "option" and parameter.name != "help" else ():
            if parameter.is_flag:
                flags[flag] = parameter.name
            elif parameter.multiple:
                repeatable[flag] = parameter.name
            else:
                values[flag] = parameter.name, type(parameter.type("7")).__name__
    defaults = {name: found.default for name, found in inspect.signature(LintOptions).parameters.items()}
    return (
        '"""The options of `lint`, as fast_path.py needs them.\n\n'
        "Generated from options.py: python -m urdfctl.cli.fast_path > urdfctl/cli/lint_table.py\n"
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

    sys.stdout.write(table())
