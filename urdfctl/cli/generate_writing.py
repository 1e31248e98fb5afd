"""Where generated files go: to standard output, to files, into a file, or nowhere."""

from __future__ import annotations

import difflib
import os
import re
from collections.abc import Sequence

from urdfctl.cli.writing import is_in_the_way, print_text, tell, write_file
from urdfctl.errors import UserError
from urdfctl.generate.options import File
from urdfctl.record import NamedTuple
from urdfctl.source.files import MAX_BYTES, first_bytes, named_bytes


class Writing(NamedTuple):
    """What the options say of it."""

    output: str | None
    force: bool
    diff: bool
    check: bool
    into: str | None


def deliver(files: Sequence[File], writing: Writing, *, many: bool) -> int:
    """Write, show or check the files, and give the exit status: 1 where a check finds them stale."""
    if writing.into is not None:
        return _insert(files[0], writing.into, writing)
    if (writing.check or many) and writing.output is None:
        raise UserError(
            "-o FOLDER is missing: where the package is to be written"
            if many
            else "--check needs -o FILE: the file to be checked"
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
        _make_folder(os.path.dirname(path))
        write_file(path, text, force=writing.force)
    if many and stale:
        tell(_what_next(len(stale), writing.output, files))
    return 0


def _what_next(written: int, folder: str, files: Sequence[File]) -> str:
    """What was written, and how it is started: the launch file's first lines say so."""
    what = f"{written} file{'s' * (written > 1)} written to '{folder}'"
    start = next((found[1] for file in files if (found := re.search(r"Start it: (.*?)(?: -->)?\n", file.text))), None)
    return f"{what}; build the workspace, then: {start}" if start else what


def _insert(file: File, path: str, writing: Writing) -> int:
    """Put what is between the root's tags before the last `</robot>` of a file, whose other bytes stay as they are."""
    before = named_bytes(path)
    line_end = "\r\n" if b"\r\n" in before else "\n"
    block = _block(file.text).replace("\n", line_end).encode("utf-8", "surrogateescape")
    if block in before:
        return 0
    plain = re.sub(rb"(?s)<!--.*?-->", lambda comment: b" " * len(comment[0]), before)
    at = plain.rfind(b"</robot>")
    if at < 0:
        raise UserError(f"'{path}' has no </robot> to insert it before")
    at = plain.rfind(b"\n", 0, at) + 1 if not plain[plain.rfind(b"\n", 0, at) + 1 : at].strip() else at
    text = (before[:at] + block + before[at:]).decode("utf-8", "surrogateescape")
    if writing.diff or writing.check:
        print_text(_diff(path, text) if writing.diff else f"{path} is stale\n")
        return int(writing.check)
    write_file(path, text, force=True)
    return 0


def _block(text: str) -> str:
    """What a xacro file of ours holds, below the comment that says what made it."""
    comment = next((line for line in text.splitlines() if line.startswith("<!-- made by ")), "")
    body = text[text.index(">", text.index("<robot")) + 1 : text.rindex("</robot>")].strip("\n")
    return f"\n  {comment}\n{body}\n\n"


def _make_folder(path: str) -> None:
    try:
        os.makedirs(path or ".", exist_ok=True)
    except OSError as error:
        raise UserError(f"'{path}' cannot be made: {error.strerror}") from None


def _there(path: str) -> str | None:
    try:
        return first_bytes(path, MAX_BYTES).decode("utf-8")
    except (OSError, UnicodeDecodeError):
        return None


def _diff(path: str, text: str) -> str:
    before = (_there(path) or "").splitlines(keepends=True)
    return "".join(difflib.unified_diff(before, text.splitlines(keepends=True), path, f"{path} (generated)"))
