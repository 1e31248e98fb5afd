"""Read the words of a command line without typer, whose import takes a third of a run.

This is for plain options with values. For anything else (`--help`, an unknown option, a missing value) `plain_options`
returns None: typer then reads the words again, by the same declarations, and reports what is wrong.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from typing import Any, TypeVar

from urdfctl.commands.declaring import Option, Options

Of = TypeVar("Of", bound=Options)


def plain_options(options: type[Of], given: Sequence[str]) -> Of | None:
    """Return the options that the words after a command's name set; None if typer has to read them."""
    flags, values = _by_flag(options.declared), dict[str, Any]()
    bare: list[str] = []
    rest = iter(options.plain_words(given))
    for word in rest:
        if not word.startswith("-"):
            bare.append(word)
            continue
        flag, mark, value = word.partition("=")
        if flag not in flags:
            return None
        name, option, switch = flags[flag]
        if option.type is bool:
            if mark:
                return None
            values[name] = switch
            continue
        text = value if mark else next(rest, None)
        if text is None or (not mark and text.startswith("-")) or not _set(values, name, option, text):
            return None
    return options(**values) if _place(values, bare, options.declared) else None


def _by_flag(declared: Mapping[str, Option]) -> dict[str, tuple[str, Option, bool]]:
    """Each flag's option with its name, and what the flag makes of a switch."""
    return {
        **{flag: (name, option, True) for name, option in declared.items() for flag in option.flags},
        **{flag: (name, option, False) for name, option in declared.items() for flag in option.negatives},
    }


def _set(values: dict[str, Any], name: str, option: Option, text: str) -> bool:
    """Set the value of an option; return whether it is one."""
    try:
        value = option.type(text)
    except ValueError:
        return False
    if option.bounds is not None and not option.bounds[0] <= value <= option.bounds[1]:
        return False
    values[name] = (*values.get(name, ()), value) if option.is_list else value
    return True


def _place(values: dict[str, Any], bare: Sequence[str], declared: Mapping[str, Option]) -> bool:
    """Set what is taken without a flag, in its order; return whether there is neither too little nor too much."""
    left = list(bare)
    for name, option in declared.items():
        if option.flags:
            continue
        taken, left = (left, []) if option.is_list else (left[:1], left[1:])
        if not taken and option.is_required:
            return False
        if taken:
            values[name] = tuple(taken) if option.is_list else taken[0]
    return not left
