"""Processes of launch files in Python that run `gazebo` itself: they run `gz sim`."""

from __future__ import annotations

import ast
from collections.abc import Iterator, Sequence

from urdfctl.diagnostic import Edit
from urdfctl.migrate.edits.python_edits import PythonFile, keyword, text_of

_PROGRAMS = {"gazebo": (), "gzserver": ("-s",), "gzclient": ("-g",)}
"""The programs of Gazebo Classic, with the options of gz that do the same."""
_VALUES = (
    "-s",
    "--server-plugin",
    "-g",
    "--gui-client-plugin",
    "-e",
    "--physics",
    "--seed",
    "--iters",
    "-o",
    "--profile",
)
"""Options of Gazebo Classic with a value, which gz has not, or with another meaning."""
_PAUSED = ("-u", "--pause")


def command_of(file: PythonFile, call: ast.Call, scope: ast.AST) -> ast.List | None:
    """Return the command of a process that runs Gazebo Classic; None if the process runs something else."""
    given = keyword(call, "cmd")
    command = file.value_of(given.value, scope) if given else None
    is_classic = isinstance(command, ast.List) and command.elts and text_of(command.elts[0]) in _PROGRAMS
    return command if is_classic and isinstance(command, ast.List) else None


def in_gz(file: PythonFile, command: ast.List) -> Edit:
    """Return the edit of a command that runs gz with the same world."""
    program, *words = command.elts
    texts = [text_of(word) for word in words]
    options = list(_PROGRAMS[text_of(program)])
    options += ["-r"] if "-g" not in options and not {*_PAUSED} & {*texts} else []
    options += ["-v4"] if "--verbose" in texts else []
    kept = [file.text(word) for word in _kept(words)]
    world = [] if kept or "-g" in options else ['"empty.sdf"']  # gz waits in its start dialog without a world
    shown = [*(f'"{word}"' for word in ("gz", "sim", *options)), *kept, *world]
    return Edit(file.span(command), f"[{', '.join(shown)}]")


def _kept(words: Sequence[ast.expr]) -> Iterator[ast.expr]:
    """Yield the words of a command line that are no options of Gazebo Classic, nor their values."""
    rest = iter(words)
    for word in rest:
        text = text_of(word)
        if text in _VALUES:
            next(rest, None)
        elif not text.startswith("-"):
            yield word
