"""Write generated files to standard output, to files or into a file, or only compare them."""

from __future__ import annotations

import difflib
import os
import re
import shlex
from collections.abc import Sequence

from urdfctl.errors import UserError
from urdfctl.generate.options import File
from urdfctl.output.answer import CommandAnswer, FileState
from urdfctl.output.change import Change, bytes_of
from urdfctl.output.links import check_output
from urdfctl.output.writing import encoded, would_overwrite, write_file
from urdfctl.output.writing_all import write_all, write_folder
from urdfctl.report.common import relative_message
from urdfctl.source.disk.files import MAX_BYTES, first_bytes, named_bytes
from urdfctl.startup.records import NamedTuple


class Writing(NamedTuple):
    """The output options of a generator."""

    output: str | None
    force: bool
    diff: bool
    check: bool
    into: str | None


def deliver(
    files: Sequence[File], writing: Writing, answer: CommandAnswer, *, many: bool, steps: Sequence[str] = ()
) -> int:
    """Write, show or check the files, and return the exit status: 1 if a check finds a file out of date.

    steps: what to do after files were written, one line each.
    """
    if writing.into is not None:
        return _insert(files[0], writing.into, writing, answer)
    if (writing.check or many) and writing.output is None:
        raise UserError(
            "-o FOLDER is missing; the package is written to it"
            if many
            else "--check requires -o FILE, the file to check"
        )
    if writing.output is None:
        answer.text("".join(file.text for file in files))
        return 0
    placed = [(os.path.join(writing.output, file.name) if many else writing.output, file.text) for file in files]
    check_output(*(path for path, _ in placed))
    stale = [(path, text) for path, text in placed if _text_of(path) != text]
    for path in dict.fromkeys(path for path, _ in placed):
        answer.file(path, FileState.UNCHANGED)
    if writing.diff or writing.check:
        for path, text in stale:
            answer.out_of_date(path, _diff(path, text) if writing.diff else "")
        return int(bool(stale) and writing.check)
    in_the_way = [path for path, _ in stale if would_overwrite(path)]
    if in_the_way and not writing.force:
        raise UserError(f"'{in_the_way[0]}' exists; --force overwrites it, --diff shows what would change")
    _write(stale, writing.output, many=many)
    for path, _ in stale:
        answer.file(path, FileState.WRITTEN)
    if stale and (many or steps):
        answer.message(f"{len(stale)} file{'s' * (len(stale) > 1)} written to '{writing.output}'")
        for step in steps:
            answer.next(step)
    return 0


def _insert(file: File, path: str, writing: Writing, answer: CommandAnswer) -> int:
    """Insert the content of a generated file before the last `</robot>` of another file. Other bytes do not change."""
    before = named_bytes(path)
    line_end = "\r\n" if b"\r\n" in before else "\n"
    block = _block(file.text).replace("\n", line_end).encode("utf-8", "surrogateescape")
    if block in before:
        answer.file(path, FileState.UNCHANGED)
        if not (writing.check or writing.diff):
            answer.message(f"'{path}' has it already; nothing was written")
        return 0
    plain = re.sub(rb"(?s)<!--.*?-->", lambda comment: b" " * len(comment[0]), before)
    at = plain.rfind(b"</robot>")
    if at < 0:
        raise UserError(f"'{path}' has no </robot> to insert before")
    at = plain.rfind(b"\n", 0, at) + 1 if not plain[plain.rfind(b"\n", 0, at) + 1 : at].strip() else at
    text = (before[:at] + block + before[at:]).decode("utf-8", "surrogateescape")
    if writing.diff or writing.check:
        answer.out_of_date(path, _diff(path, text) if writing.diff else "")
        return int(writing.check)
    write_file(path, text, force=True)
    answer.file(path, FileState.WRITTEN)
    first, added = plain.count(b"\n", 0, at) + 1, block.count(b"\n")
    answer.message(f"{added} lines inserted into '{path}' from line {first} on")
    answer.next(f"urdfctl lint {shlex.quote(path)}")
    return 0


def _block(text: str) -> str:
    """Return the content of a generated xacro file, after the comment with its command."""
    comment = next((line for line in text.splitlines() if line.startswith("<!-- made by ")), "")
    body = text[text.index(">", text.index("<robot")) + 1 : text.rindex("</robot>")].strip("\n")
    return f"\n  {comment}\n{body}\n\n"


def _write(files: Sequence[tuple[str, str]], output: str, *, many: bool) -> None:
    """Write all files, or none; a folder that does not exist appears with all of them in it."""
    if many and not os.path.lexists(output):
        write_folder(output, [(os.path.relpath(path, output), encoded(text)) for path, text in files])
        return
    if not many and os.path.isdir(os.path.dirname(output) or os.curdir):
        for path, text in files:
            write_file(path, text, force=True)
        return
    for problem in write_all([_change(path, text) for path, text in files]):
        raise UserError(relative_message(problem))


def _change(path: str, text: str) -> Change:
    try:
        return Change(path, bytes_of(path), encoded(text))
    except OSError as error:
        raise UserError(f"'{path}' cannot be written: {error.strerror}") from None


def _text_of(path: str) -> str | None:
    try:
        return first_bytes(path, MAX_BYTES).decode("utf-8", "surrogateescape")
    except OSError:
        return None


def _diff(path: str, text: str) -> str:
    if "\0" in text:
        return f"{path} differs\n"
    before = (_text_of(path) or "").splitlines(keepends=True)
    return "".join(difflib.unified_diff(before, text.splitlines(keepends=True), path, f"{path} (generated)"))
