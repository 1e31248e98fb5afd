"""Order the causes of a message by what its line and the rest of the log show.

A condition is one or more clauses joined by " and " and " or " (" and " binds closer), each with an optional "not "
before it:

- `seen ID`: the message with this id is in the log
- `NAME ~ REGEX`: the value matches; a value that is not printed does not
- `NAME in OTHER`: the value is one of the words of the other value
- `NAME near OTHER`: a word of the other value is similar, and is then known as `{meant}`
- `NAME only REGEX`: every word of the value matches
"""

from __future__ import annotations

import re
from collections.abc import Collection, Mapping, Sequence

from urdfctl.catalog.log_messages import LogMessage
from urdfctl.logs.pattern import filled
from urdfctl.names import nearest
from urdfctl.startup.records import NamedTuple


class Place(NamedTuple):
    """A line of a file in which a rule found a cause. message: what is wrong there."""

    file: str
    line: int
    column: int
    code: str
    message: str


class LikelyCause(NamedTuple):
    """A cause with the values of the log.

    rules: the codes of the rules that find it. fix: what to do about it; empty if the message's fix fits.
    found: where the rules found it in the user's files.
    """

    text: str
    rules: tuple[str, ...] = ()
    fix: str = ""
    found: tuple[Place, ...] = ()


class Reading(NamedTuple):
    """What a message means in a log. causes: most likely first."""

    meaning: str
    causes: tuple[LikelyCause, ...]
    fix: str

    @property
    def best_fix(self) -> str:
        """What to do about the first cause."""
        return self.causes[0].fix if self.causes and self.causes[0].fix else self.fix


def reading(message: LogMessage, values: Mapping[str, str], seen: Collection[str]) -> Reading:
    """Return the meaning, causes and fix of a message with these values, in a log with the messages `seen`."""
    values = {**values, **_meant(message, values)}
    causes = [cause for cause in message.causes if not cause.only_if or holds(cause.only_if, values, seen)]
    causes.sort(key=lambda cause: not (cause.first_if and holds(cause.first_if, values, seen)))
    likely = [LikelyCause(filled(cause.text, values), cause.rules, filled(cause.fix, values)) for cause in causes]
    return Reading(filled(message.meaning, values), tuple(likely), filled(message.fix, values))


def with_findings(known: Reading, places: Sequence[Place], values: Collection[str]) -> Reading:
    """Return the reading with the places where rules found its causes, those causes first.

    values: of the log. Places whose message names one of them come first.
    """
    names = [value for value in values if len(value) > 2]  # noqa: PLR2004 (shorter ones are in any text)
    ordered = sorted(places, key=lambda place: not any(name in place.message for name in names))
    causes = [
        cause._replace(found=tuple(place for place in ordered if place.code in cause.rules)) for cause in known.causes
    ]
    rank = {place: number for number, place in enumerate(ordered)}
    causes.sort(key=lambda cause: rank[cause.found[0]] if cause.found else len(rank))
    return known._replace(causes=tuple(causes))


def holds(condition: str, values: Mapping[str, str], seen: Collection[str]) -> bool:
    """Return whether a condition of the catalogue holds."""
    return any(
        all(_holds(clause.strip(), values, seen) for clause in part.split(" and ")) for part in condition.split(" or ")
    )


def _holds(clause: str, values: Mapping[str, str], seen: Collection[str]) -> bool:
    if clause.startswith("not "):
        return not _holds(clause[4:].strip(), values, seen)
    name, _, rest = clause.partition(" ")
    if name == "seen":
        return rest in seen
    relation, _, other = rest.partition(" ")
    value = values.get(name, "").strip()
    if relation == "in":
        return bool(value) and value in _words(values.get(other, ""))
    if relation == "near":
        return "meant" in values
    if relation == "only":
        return bool(value) and all(re.search(other, word) for word in _words(value))
    return re.search(other, value) is not None


def _meant(message: LogMessage, values: Mapping[str, str]) -> dict[str, str]:
    """The value `meant`: the word that another value, or the name of its class, is similar to."""
    for cause in message.causes:
        for clause in f"{cause.only_if} and {cause.first_if}".split(" and "):
            name, _, other = clause.strip().removeprefix("not ").partition(" near ")
            value, known = values.get(name, "").strip(), _words(values.get(other, "")) if other else []
            if value and value not in known:
                meant = nearest(value, known) or _by_class(value, known)
                return {"meant": meant} if meant else {}
    return {}


def _by_class(value: str, known: Sequence[str]) -> str | None:
    """The known name whose class, behind the package, contains the class of `value` or is contained in it."""
    last = _class(value)
    longest = [name for name in known if last and (_class(name) in last or last in _class(name))]
    return max(longest, key=len, default=None)


def _class(name: str) -> str:
    return re.split(r"[/:]", name)[-1].lower()


def _words(text: str) -> list[str]:
    return text.replace(",", " ").split()
