"""Where generated files go: to standard output, to files, into a file, or nowhere."""

from __future__ import annotations

import difflib
import os
from collections.abc import Sequence
from typing import NamedTuple

from urdfctl.cli.writing import is_in_the_way, print_text, write_file
from urdfctl.errors import UserError
from urdfctl.generate.options import File


class Writing(NamedTuple):
    """What the options say of it."""

    output: str | None
    force: bool
    diff: bool
    check: bool
    into: str | None


def deliver(files: Sequence[File], writing: Writing, *, many: bool) -> int:
    """Write, show or check the files, and give the exit status: 1 where a check finds them stale."""
    if (writing.check or many) and writing.output is None:
        raise UserError(
            "-o names the folder that the files go to" if many else "--check needs -o FILE: the file to be checked"
        )
    if writing.output is None:
        print_text("".join(file.text for file in files))
        return 0
    placed = [(os.path.join(writing.output, file.name) if many else writing.output, file.text) for file in files]
    stale = [(path, text) for path, text in placed if _there(path) != text]
    if writing.diff or writing.check:
        for path, text in stale:
            print_text(_diff(path, text) if writing.diff else f"{path} is stale\n")
        return int(bool(stale) and writing.check)
    in_the_way = [path for path, _ in stale if is_in_the_way(path)]
    if in_the_way and not writing.force:
        raise UserError(f"'{in_the_way[0]}' exists; --force overwrites it, --diff shows what would change")
    for path, text in stale:
        if many:
            _make_folder(os.path.dirname(path))
        write_file(path, text, force=writing.force)
    return 0


def _make_folder(path: str) -> None:
    try:
        os.makedirs(path, exist_ok=True)
    except OSError as error:
        raise UserError(f"'{path}' cannot be made: {error.strerror}") from None


def _there(path: str) -> str | None:
    try:
        with open(path, encoding="utf-8", newline="") as file:
            return file.read()
    except (OSError, UnicodeDecodeError):
        return None


def _diff(path: str, text: str) -> str:
    before = (_there(path) or "").splitlines(keepends=True)
    return "".join(difflib.unified_diff(before, text.splitlines(keepends=True), path, f"{path} (generated)"))
