"""What the declarations of the commands say, as Markdown in docs/commands and as a manual page.

`python -m urdfctl.commands.document docs` writes the part of each page of docs/commands that is between its two marks,
the tables of docs/commands.md, and docs/urdfctl.1.
"""

from __future__ import annotations

import inspect
import re
import sys
from collections.abc import Iterator
from itertools import groupby
from pathlib import Path

from urdfctl import __version__
from urdfctl.commands import COMMANDS, command_named
from urdfctl.commands.declaring import GROUPS, Option, Options
from urdfctl.commands.exits import exits_of

_BEGIN = "<!-- made by python -m urdfctl.commands.document docs -->"
_END = "<!-- until here -->"
_PART = re.compile(f"{re.escape(_BEGIN)}.*?{re.escape(_END)}", re.DOTALL)


def explanation_of(options: type[Options]) -> tuple[str, list[str]]:
    """Return what a command's help says, and its examples."""
    text, _, examples = inspect.cleandoc(str(options.__doc__)).replace("\b\n", "").partition("Example: ")
    return text.strip(), [line.strip() for line in examples.splitlines() if line.strip()]


def usage_of(name: str, options: type[Options]) -> str:
    """Return the form of a command line."""
    words = [_written(one, attribute) for attribute, one in options.declared.items() if not one.flags]
    return " ".join(["urdfctl", name, "[OPTIONS]", *words])


def _written(argument: Option, attribute: str) -> str:
    """An argument in a command line's form."""
    name = argument.metavar or ("NAME:=VALUE" if argument.help == "name:=value" else attribute.upper())
    text = name if name.startswith("[") or argument.is_required else f"[{name}]"
    return text if not argument.is_list or "..." in text else f"{text}..."


def part_of(name: str) -> str:
    """Return what the declarations say of a command: usage, options and exit status."""
    options = command_named(name).options
    lines = [_BEGIN, "## Usage", "```text", usage_of(name, options), "```", *_arguments(options)]
    for group in GROUPS:
        rows = [_row(one) for one in options.declared.values() if one.flags and one.group == group and not one.hidden]
        if rows:
            lines += ["", f"### {group}", "", "| option | |", "|---|---|", *rows]
    lines += ["", "## Exit status", "", "| status | |", "|---|---|"]
    lines += [f"| {status} | {_escaped(meaning)} |" for status, meaning in exits_of(name)]
    return "\n".join([*lines, _END])


def _arguments(options: type[Options]) -> Iterator[str]:
    for attribute, one in options.declared.items():
        if not one.flags and one.help != "name:=value":
            yield f"\n`{_written(one, attribute)}`: {_escaped(one.help)}"


def _row(option: Option) -> str:
    flags = ", ".join(f"`{flag}`" for flag in (*option.flags, *option.negatives))
    return f"| {flags} | {_escaped(option.help)} |"


def _escaped(text: str) -> str:
    return text.replace("|", "\\|").replace("<", "&lt;")


def overview() -> str:
    """Return the list of commands in their groups, with links to their pages."""
    lines = [_BEGIN]
    for group, names in groupby(COMMANDS, lambda name: COMMANDS[name].group):
        lines += [f"| **{group}** | |", "|---|---|"]
        lines += [f"| [{name}](commands/{name}.md) | {_escaped(COMMANDS[name].summary)} |" for name in names]
        lines.append("")
    return "\n".join([*lines[:-1], _END])


def man_page() -> str:
    """Return the manual page of all commands, in the language of man."""
    lines = [f'.TH URDFCTL 1 "" "urdfctl {__version__}" "User Commands"', ".SH NAME"]
    lines += ["urdfctl \\- lint, smoke\\-test, generate and migrate the control configuration of robots"]
    lines += [".SH SYNOPSIS", ".B urdfctl", "COMMAND [OPTIONS] ..."]
    for group, names in groupby(COMMANDS, lambda name: COMMANDS[name].group):
        lines.append(f".SH {group.upper()}")
        for name in names:
            lines += _man_command(name)
    return "\n".join(lines) + "\n"


def _man_command(name: str) -> Iterator[str]:
    options = command_named(name).options
    text, examples = explanation_of(options)
    yield f".SS {_roff(usage_of(name, options))}"
    yield _roff(" ".join(text.split()))
    for example in examples:
        yield f".PP\n.EX\n{_roff(example)}\n.EE"
    for one in options.declared.values():
        if one.flags and not one.hidden:
            yield f".TP\n.B {_roff(', '.join((*one.flags, *one.negatives)))}\n{_roff(one.help)}"
    yield ".PP\nExit status:"
    for status, meaning in exits_of(name):
        yield f".TP\n.B {status}\n{_roff(meaning.replace('`', ''))}"


def _roff(text: str) -> str:
    """Text as troff reads it: no line begins with a control character."""
    escaped = text.replace("\\", "\\e").replace("-", "\\-")
    return f"\\&{escaped}" if escaped.startswith((".", "'")) else escaped


def pages(docs: Path) -> Iterator[tuple[Path, str]]:
    """Yield each file that has such a part, with the text that it should have."""
    yield docs / "commands.md", _with_part(docs / "commands.md", overview())
    for name in COMMANDS:
        path = docs / "commands" / f"{name}.md"
        yield path, _with_part(path, part_of(name))
    yield docs / "urdfctl.1", man_page()


def _with_part(path: Path, part: str) -> str:
    """The text of a page with another part; a page that does not exist has nothing else."""
    if not path.exists():
        text, examples = explanation_of(command_named(path.stem).options)
        shown = "\n".join(examples)
        return f"# urdfctl {path.stem}\n\n{text}\n\n```\n{shown}\n```\n\n{part}\n"
    return _PART.sub(lambda _: part, path.read_text(encoding="utf-8"), count=1)


if __name__ == "__main__":
    for file, text in pages(Path(sys.argv[1])):
        file.write_text(text, encoding="utf-8")
