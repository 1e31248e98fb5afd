"""Comments in migrated files that say what a person must decide."""

from __future__ import annotations

import re
from itertools import takewhile

from urdfctl.diagnostic import Edit
from urdfctl.migrate.step import EntryKind, Proposal, ReportEntry
from urdfctl.source.span import Place, SourceSpan
from urdfctl.source.todo import MARK, has_todos

_OF_XML = (".xacro", ".urdf", ".xml", ".launch", ".srdf", ".sdf", ".world", ".gazebo", ".inc")
_MOST_BEFORE = 1 << 12
_READ_BY_LINT = (".xacro", ".urdf", ".launch", ".launch.xml", ".yaml", ".yml", ".launch.py")


def todo_line(path: str, text: str) -> str:
    """Return a TODO as a comment in the syntax of a file, without line end."""
    if path.endswith(_OF_XML) and not path.endswith((".yaml", ".py")):
        return f"<!-- {MARK} {text.replace('--', '- -')} -->"
    return f"# {MARK} {text}"


def for_you(at: Place, text: str, *, authority: str = "") -> Proposal:
    """Return the proposal to leave a decision to a person: a TODO in the line above a place, and its report line.

    It has no edits if the TODO is there already. The place must begin after the first element of its line at the
    earliest; a TODO is never put inside a start tag.
    """
    source = at.source
    start = source.line_starts()[source.position(_tag_start(at)).line - 1]
    line_end = source.data.find(b"\n", start)
    line = source.data[start : line_end if line_end >= 0 else len(source.data)]
    indent = line[: len(line) - len(line.lstrip())].decode("utf-8", "surrogateescape")
    comment = todo_line(source.path, text)
    entry = ReportEntry(EntryKind.FOR_YOU, text, at, authority=authority)
    if _is_told(source.data[max(start - _MOST_BEFORE, 0) : start], comment):
        return Proposal(entries=(entry,))
    edit = Edit(SourceSpan(source, start, start), f"{indent}{comment}\n")
    return Proposal(edits=(edit,), entries=(entry,))


def _is_told(before: bytes, comment: str) -> bool:
    """Whether a TODO is the last of a text, or one of several at its end, each in a line of its own."""
    wanted = without_punctuation(comment.encode())
    if without_punctuation(before).endswith(wanted):
        return True
    todos = takewhile(has_todos, reversed(before.splitlines()))
    return any(without_punctuation(line) == wanted for line in todos)


def without_punctuation(text: bytes) -> bytes:
    """Return a text to compare: comments get other punctuation, which Gazebo Classic's plugin can pass on in humble."""
    return re.sub(rb"[\s:#-]+", b"", text)


def with_todos(proposal: Proposal) -> Proposal:
    """Return a proposal with a TODO at each place that it leaves to a person: where lint reads comments, and where the
    proposal changes nothing itself."""
    if all(entry.kind is not EntryKind.FOR_YOU for entry in proposal.entries):
        return proposal
    edits = list(proposal.edits)
    for entry in proposal.entries:
        at = entry.at
        if entry.kind is not EntryKind.FOR_YOU or at is None or not at.source.path.endswith(_READ_BY_LINT):
            continue
        if any(entry.message in edit.text or _is_around(edit, at) for edit in edits):
            continue
        edits += for_you(at, entry.message).edits
    return proposal._replace(edits=tuple(edits))


def _is_around(edit: Edit, at: Place) -> bool:
    """Whether an edit replaces the line of a place, or a part of it."""
    source = at.source
    if edit.span.file != source.path or edit.span.start == edit.span.end:
        return False
    starts = source.line_starts()
    line = source.position(_tag_start(at)).line
    end = starts[line] if line < len(starts) else len(source.data)
    return edit.span.start < end and starts[line - 1] < edit.span.end


def _tag_start(at: Place) -> int:
    """The offset of the place, or of the start tag that it is in: a comment inside of a tag is an error."""
    start = at.span.start
    data = at.source.data
    if not at.source.path.endswith(_OF_XML):
        return start
    opened = data.rfind(b"<", 0, start + 1)
    closed = data.rfind(b">", 0, start)
    return opened if opened > closed else start
