"""The readable explanation of a log's messages: failures first, harmless messages last."""

from __future__ import annotations

import textwrap
from collections.abc import Iterator, Sequence

from urdfctl import REPOSITORY
from urdfctl.catalog.distros import in_words
from urdfctl.logs.digest import Digest, KnownMessage, Unknown
from urdfctl.logs.evidence import CheckedFolder, LikelyCause
from urdfctl.logs.pattern import filled
from urdfctl.output.printing import visible
from urdfctl.report.log_explanation.next_commands import next_commands
from urdfctl.rules import fault_of

_WIDTH = 110
_LONGEST = 240
_MOST_OTHERS = 4
_MOST_UNKNOWN = 5
_MOST_FOUND = 3
_REPORT = f"To have it explained, report it with the ROS distro and the program that prints it: {REPOSITORY}/issues"
_HEADINGS = {
    "failure": "Failures",
    "consequence": "Consequences of a failure",
    "warning": "Warnings",
    "harmless": "Harmless",
}


def render_log(digest: Digest, *, pasted: bool, complete: bool, files: CheckedFolder | None = None) -> str:
    """Return the explanation: everything about a pasted message, or the essentials of a log.

    complete: whether the whole log was read. files: the folder in which the causes were searched.
    """
    parts = [] if pasted else [_summary(digest, complete=complete)]
    single = pasted and len(digest.known) == 1
    fails = any(known.kind == "failure" for known in digest.known)
    for kind, heading in _HEADINGS.items():
        if kind == "harmless" and digest.unknown:
            parts.append("\n".join(_unknown_errors(digest.unknown, pasted=pasted)))
        chosen = [known for known in digest.known if known.kind == kind]
        if chosen and not single:
            parts.append(f"== {heading} ==")
        brief = not pasted and (kind == "harmless" or (kind == "consequence" and fails))
        parts += ["\n".join([_where(known, pasted=pasted), *_explained(known, brief=brief)]) for known in chosen]
        if pasted:
            parts += [_source(known) for known in chosen if single]
    if pasted and digest.unknown and not digest.known:
        parts.append("\n".join(_paragraph(_REPORT, "", "")))
    commands = next_commands(digest.known, files)
    if commands:
        width = max(len(command.text) for command in commands)
        parts.append("\n".join(["Next:", *(f"  {command.text:<{width}}  {command.purpose}" for command in commands)]))
    return "\n\n".join(parts) + "\n"


def _summary(digest: Digest, *, complete: bool) -> str:
    """The number of lines, and of messages of each kind."""
    kinds = [known.kind for known in digest.known]
    counts = [
        f"{number} {kind}{'s' if number > 1 and kind != 'harmless' else ''}"
        for kind in _HEADINGS
        if (number := kinds.count(kind))
    ]
    messages = ", ".join(counts) if counts else "no known messages"
    more = "" if complete else "; the rest of the log was not read"
    return f"{digest.lines} line{'' if digest.lines == 1 else 's'}: {messages}{more}"


def _where(known: KnownMessage, *, pasted: bool) -> str:
    """The message as the log has it, with its line and count."""
    times = f" ({known.times} times{_others(known.values)})" if known.times > 1 else ""
    return _short(known.text) if pasted else f"line {known.line}{times}: {_short(known.text)}"


def _explained(known: KnownMessage, *, brief: bool) -> Iterator[str]:
    """The meaning, the causes (unless `brief`) and the fix."""
    reading = known.reading
    if known.settled:
        yield from _paragraph(f"Settled in line {known.settled}: nothing to do.")
        return
    if brief and not reading.is_found:
        yield from _paragraph(f"{reading.meaning} {reading.best_fix}")
        return
    yield from _paragraph(reading.meaning)
    if len(reading.causes) == 1:
        yield from _paragraph(reading.causes[0].text + _rules(reading.causes[0]), "  Likely cause: ", "    ")
        yield from _found(reading.causes[0])
    elif reading.causes:
        yield "  Causes, those in your files first:" if reading.is_found else "  Causes, most likely first:"
        for number, cause in enumerate(reading.causes, 1):
            yield from _paragraph(cause.text + _rules(cause), f"    {number}. ", "       ")
            yield from _found(cause)
    yield from _paragraph(reading.best_fix, "  Fix: ", "    ")


def _source(known: KnownMessage) -> str:
    message = known.message
    return "\n".join(_paragraph(f"Printed by {message.by} ({in_words(message.distros)}): {message.authority}", "", ""))


def _found(cause: LikelyCause) -> Iterator[str]:
    """Where the rules found a cause in the user's files."""
    for found in cause.found[:_MOST_FOUND]:
        place = f"{visible(found.file)}:{found.line}:{found.column}"
        yield from _paragraph(f"{place}: {found.message} ({found.code})", "       found: ", "              ")
        for one in found.related:
            there = f"{visible(one.file)}:{one.line}:{one.column}"
            yield from _paragraph(f"{there}: {one.message}", "              see: ", "                   ")
        if found.fix:
            yield from _paragraph(found.fix, "              fix: ", "                   ")
    if len(cause.found) > _MOST_FOUND:
        yield f"       and {len(cause.found) - _MOST_FOUND} more"


def _rules(cause: LikelyCause) -> str:
    named = ", ".join(f"{code} {fault_of(code).name}" for code in cause.rules)
    return f" -> {named}" if named else ""


def _others(values: Sequence[dict[str, str]]) -> str:
    """The other values of a message that occurs several times."""
    if len(values) == 1:
        return ""
    names = [name for name in values[0] if len({occurrence.get(name) for occurrence in values}) > 1]
    if not names:
        return ""
    others = list(dict.fromkeys(occurrence[names[0]] for occurrence in values[1:] if names[0] in occurrence))
    if not others:
        return ""
    shown = ", ".join(f"'{visible(value[:60])}'" for value in others[:_MOST_OTHERS])
    return f", also with {shown}" + (f" and {len(others) - _MOST_OTHERS} more" if len(others) > _MOST_OTHERS else "")


def _unknown_errors(unknown: Sequence[Unknown], *, pasted: bool) -> Iterator[str]:
    yield "== Unknown lines ==" if not pasted or len(unknown) > 1 else "urdfctl does not know this message:"
    for error in unknown[:_MOST_UNKNOWN]:
        yield _short(error.text) if pasted else f"line {error.line}: {_short(error.text)}"
        if error.nearest is not None:
            yield f"  did you mean: {visible(error.nearest.pattern.shown)}"
            yield from _paragraph(filled(error.nearest.message.meaning, {}))
    if len(unknown) > _MOST_UNKNOWN:
        yield f"and {len(unknown) - _MOST_UNKNOWN} more"


def _paragraph(text: str, first: str = "  ", other: str = "  ") -> list[str]:
    return textwrap.wrap(
        visible(text), _WIDTH, initial_indent=first, subsequent_indent=other, break_long_words=False,
        break_on_hyphens=False,
    )  # fmt: skip


def _short(text: str) -> str:
    text = visible(text)
    return text if len(text) <= _LONGEST else f"{text[:_LONGEST]}…"
