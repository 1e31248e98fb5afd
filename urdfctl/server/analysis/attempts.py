"""Items tried out before they are offered: each is inserted, and the robots are linted with it, while time allows."""

from __future__ import annotations

import re
import sys
import time
from collections import Counter
from collections.abc import Callable, Iterable, Iterator, Mapping, Sequence
from itertools import chain

from urdfctl.diagnostic import Diagnostic
from urdfctl.server.analysis.items import OfferedItem
from urdfctl.server.analysis.question import Question
from urdfctl.server.analysis.unfinished import finished
from urdfctl.startup.records import NamedTuple

SECONDS = 0.4
"""Processor time for the items of one place: so long a user does not notice, and it suffices for about twenty items."""
_SECONDS_OF = {"type": 0.15}
"""The same for kinds whose items were tried already in another way: with the claims and parameters of a controller."""
_MOST_ITEMS = 60
_LONGEST_WORD = 200

Codes = Counter[tuple[str, str]]
"""How many findings of each code are in each file."""
_LATER: Mapping[str, frozenset[str]] = {"type": frozenset({"UC431", "UC463", "UC464", "UC465", "UC614"})}
"""Codes, by the kind of an item, of what a user writes next: the parameters of a controller after its type, the package
that it is in, the other controllers."""


class Attempts(NamedTuple):
    """Lints the robots that read a file, with other texts of it.

    lint: returns what is found in robot number N with a text of the file; None if it took more seconds the last time.
    robots: how many robots there are.
    saved: returns what was found in robot number N when all texts were saved.
    on_disk: the text of the file as it was saved; None if it never was.
    """

    lint: Callable[[int, bytes, float], Sequence[Diagnostic] | None]
    robots: int
    saved: Callable[[int], Codes]
    on_disk: bytes | None = None


def codes_of(findings: Iterable[Diagnostic]) -> Codes:
    """Return how many findings of each code are in each file."""
    return Counter((finding.at.file, finding.code) for finding in findings)


def harmless(question: Question, items: Sequence[OfferedItem], attempts: Attempts) -> list[OfferedItem]:
    """Return the items without those that cause a finding, in order; those that need more to be written are last.

    A finding counts that is neither in the text as it is, nor was there before, nor comes with all items: what else is
    not saved yet causes that. Items for which there is no time are kept; doubtful ones only if no item was tried.
    """
    question = finished(question)
    new: dict[OfferedItem, set[str]] = {}
    left = _SECONDS_OF.get(items[0].kind, SECONDS) if items else SECONDS
    for robot in range(attempts.robots if items else 0):
        started = time.thread_time()
        concerned = [item for item in items[:_MOST_ITEMS] if _is_whole(item) and not _refused(item, new)]
        for item, codes in _caused(question, concerned, attempts, robot, left):
            new.setdefault(item, set()).update(codes)
        left -= time.thread_time() - started
        if left <= 0:
            break
    kept = (item for item in items if not _refused(item, new) and (item in new or not (new and item.is_doubtful)))
    return sorted(kept, key=lambda item: bool(new.get(item)))


def _is_whole(item: OfferedItem) -> bool:
    """Return whether nothing is left open in an item, such as the value of a parameter."""
    return not item.text.endswith((":", '=""'))


def _refused(item: OfferedItem, new: Mapping[OfferedItem, set[str]]) -> bool:
    return not new.get(item, set()) <= _LATER.get(item.kind, frozenset())


def _caused(
    question: Question, items: Sequence[OfferedItem], attempts: Attempts, robot: int, seconds: float
) -> Iterator[tuple[OfferedItem, set[str]]]:
    """Yield the items for which there is time, with the codes of what each causes in a robot."""
    end = time.thread_time() + seconds
    now = attempts.lint(robot, question.source.data, seconds)
    if now is None:
        return
    usual = codes_of(finding for finding in now if not _is_at(finding, question)) | attempts.saved(robot)
    found: dict[OfferedItem, Codes] = {}
    for item in items:
        left = end - time.thread_time()
        findings = attempts.lint(robot, inserted(question, item), left) if left > 0 else None
        if findings is None:
            break
        found[item] = codes_of(findings) - usual
    excused = _excused(question, found, attempts.on_disk)
    yield from ((item, {code for _, code in codes - excused}) for item, codes in found.items())


def _excused(question: Question, found: Mapping[OfferedItem, Codes], on_disk: bytes | None) -> Codes:
    """What comes with all items, and what none of them causes: other elements of its list are missing, for example."""
    codes = list(found.values())
    common = _common(codes)
    if all(item.is_element for item in found):
        return Counter(dict.fromkeys(common if len(codes) > 1 else chain(*codes), sys.maxsize))
    return Counter() if _is_all_else_saved(question, on_disk) else common


def _common(found: Sequence[Codes]) -> Codes:
    """Return what several items cause, all of them."""
    if len(found) < 2:  # noqa: PLR2004
        return Counter()
    common = found[0]
    for codes in found[1:]:
        common = common & codes
    return common


def _is_all_else_saved(question: Question, on_disk: bytes | None) -> bool:
    """Return whether the text differs from the saved one only in the line of the place."""
    data, offset = question.source.data, question.offset
    end = data.find(b"\n", offset)
    before, after = data[: data.rfind(b"\n", 0, offset) + 1], data[end:] if end >= 0 else b""
    if on_disk is None or on_disk.count(b"\n") != data.count(b"\n"):
        return False
    return on_disk.startswith(before) and on_disk.endswith(after)


def _is_at(finding: Diagnostic, question: Question) -> bool:
    """Return whether a finding is about the word at the place, which is written only in part."""
    at, data = finding.at, question.source.data
    is_around = at.file == question.file and at.start <= question.offset <= at.end
    return is_around and not data[at.start : at.end].startswith(b"<") and b"\n" not in data[at.start : at.end]


def inserted(question: Question, item: OfferedItem) -> bytes:
    """Return the text of the file with an item in place of the whole word around the place."""
    data, offset = question.source.data, question.offset
    start = question.source.offset(question.line, max(1, question.column - item.replaces))
    word = rb"[\w/.-]*" if "/" in item.text else rb"[\w.-]*"
    rest = re.match(word, data[offset : offset + _LONGEST_WORD])
    return data[:start] + item.text.encode("utf-8", "surrogateescape") + data[offset + (rest.end() if rest else 0) :]
