"""The explanation of a log's messages, for people: the failures first, what is harmless last."""

from __future__ import annotations

import textwrap
from collections.abc import Iterator, Sequence

from urdfctl.catalog.distros import in_words
from urdfctl.catalog.log_messages import Cause
from urdfctl.logs.digest import Digest, Known, Unknown
from urdfctl.logs.pattern import filled
from urdfctl.report.common import visible
from urdfctl.report.log_next import next_commands
from urdfctl.rules import rule_of

_WIDTH = 110
_LONGEST = 240
_MOST_OTHERS = 4
_MOST_UNKNOWN = 5
_HEADINGS = {
    "failure": "What fails",
    "consequence": "What follows from a failure",
    "warning": "What is taken, but wrong or lost",
    "harmless": "What is harmless",
}


def render_log(digest: Digest, *, pasted: bool, complete: bool) -> str:
    """The whole explanation: of a pasted message all that is known, of a log what is needed to go on."""
    parts = [] if pasted else [_summary(digest, complete=complete)]
    told = pasted and len(digest.known) == 1
    fails = any(known.message.kind == "failure" for known in digest.known)
    for kind, heading in _HEADINGS.items():
        if kind == "harmless" and digest.unknown:
            parts.append("\n".join(_not_known(digest.unknown, pasted=pasted)))
        chosen = [known for known in digest.known if known.message.kind == kind]
        if chosen and not told:
            parts.append(f"== {heading} ==")
        brief = not pasted and (kind == "harmless" or (kind == "consequence" and fails))
        parts += ["\n".join([_where(known, pasted=pasted), *_explained(known, brief=brief)]) for known in chosen]
        if pasted:
            parts += [_source(known) for known in chosen if told]
    commands = next_commands(digest.known)
    if commands:
        width = max(len(command.text) for command in commands)
        parts.append("\n".join(["Next:", *(f"  {one.text:<{width}}  {one.purpose}" for one in commands)]))
    return "\n\n".join(parts) + "\n"


def _summary(digest: Digest, *, complete: bool) -> str:
    """How many lines there were, and of what kinds the messages in them are."""
    kinds = [known.message.kind for known in digest.known]
    counts = [
        f"{number} {kind}{'s' if number > 1 and kind != 'harmless' else ''}"
        for kind in _HEADINGS
        if (number := kinds.count(kind))
    ]
    told = ", ".join(counts) if counts else "no message that is known"
    more = "" if complete else "; the log is longer, and was not read to its end"
    return f"{digest.lines} line{'' if digest.lines == 1 else 's'}: {told}{more}"


def _where(known: Known, *, pasted: bool) -> str:
    """The message as it stands in the log, with its place there."""
    times = f" ({known.times} times{_others(known.values)})" if known.times > 1 else ""
    return _short(known.text) if pasted else f"line {known.line}{times}: {_short(known.text)}"


def _explained(known: Known, *, brief: bool) -> Iterator[str]:
    """What it means; unless `brief`, also why it is printed. And what to do."""
    message, values = known.message, known.values[0]
    meaning, fix = filled(message.meaning, values), filled(message.fix, values)
    if brief:
        yield from _paragraph(f"{meaning} {fix}")
        return
    yield from _paragraph(meaning)
    causes = [filled(cause.text, values) + _rules(cause) for cause in message.causes]
    if len(causes) == 1:
        yield from _paragraph(causes[0], "  Likely cause: ", "    ")
    elif causes:
        yield "  Likely causes, in this order:"
        for number, cause in enumerate(causes, 1):
            yield from _paragraph(cause, f"    {number}. ", "       ")
    yield from _paragraph(fix, "  Fix: ", "    ")


def _source(known: Known) -> str:
    message = known.message
    return "\n".join(_paragraph(f"Printed by {message.by} ({in_words(message.distros)}): {message.authority}", "", ""))


def _rules(cause: Cause) -> str:
    named = ", ".join(f"{code} {rule_of(code).name}" for code in cause.rules)
    return f" -> {named}" if named else ""


def _others(values: Sequence[dict[str, str]]) -> str:
    """What other values the message has in further lines."""
    if len(values) == 1:
        return ""
    names = [name for name in values[0] if len({one.get(name) for one in values}) > 1]
    if not names:
        return ""
    others = list(dict.fromkeys(one.get(names[0], "…") for one in values[1:]))
    shown = ", ".join(f"'{visible(one[:60])}'" for one in others[:_MOST_OTHERS])
    return f", also with {shown}" + (f" and {len(others) - _MOST_OTHERS} more" if len(others) > _MOST_OTHERS else "")


def _not_known(unknown: Sequence[Unknown], *, pasted: bool) -> Iterator[str]:
    yield "== What is not known ==" if not pasted or len(unknown) > 1 else "This is no message that urdfctl knows:"
    for one in unknown[:_MOST_UNKNOWN]:
        yield _short(one.text) if pasted else f"line {one.line}: {_short(one.text)}"
        if one.nearest is not None:
            yield f"  did you mean: {visible(one.nearest.pattern.shown)}"
            yield from _paragraph(filled(one.nearest.message.meaning, {}))
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
