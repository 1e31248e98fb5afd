"""Order the causes of a message by what its line and the rest of the log show.

A condition is one or more clauses joined by " and " and " or " (" and " binds closer), each with an optional "not "
before it:

- `seen ID`: the message with this id is in the log
- `NAME ~ REGEX`: the value matches; a value that is not printed does not
- `NAME in OTHER`: the value is one of the words of the other value
- `NAME near OTHER`: a word of the other value is similar, and is then known as `{meant}`
- `NAME only REGEX`: every word of the value matches
- `NAME known`: the value is a type of controller in the catalogue; `NAME near known`: it is similar to one
"""

from __future__ import annotations

import re
from collections.abc import Collection, Mapping, Sequence

from urdfctl.catalog.log_messages import LogMessage
from urdfctl.catalog.store import plain
from urdfctl.logs.pattern import filled
from urdfctl.names import nearest
from urdfctl.startup.records import NamedTuple

_PACKAGE = re.compile(r"[a-z][a-z0-9_-]+")
_LEAST_NAME = 3
"""Letters of a value that is looked for in findings."""


class RelatedPlace(NamedTuple):
    """Another line that belongs to a cause, such as that of the hardware that a controller needs."""

    file: str
    line: int
    column: int
    message: str


class FoundCause(NamedTuple):
    """A line of a file in which a rule found a cause.

    message: what is wrong there. fixable: by a safe fix. likely: by a fix that may not be
    what is meant. fix: what to do there; empty if the rule does not say.
    related: other lines that belong to it.
    """

    file: str
    line: int
    column: int
    code: str
    message: str
    fixable: bool = False
    likely: bool = False
    fix: str = ""
    related: tuple[RelatedPlace, ...] = ()


class CheckedFolder(NamedTuple):
    """A folder in which causes were searched. others: how many errors in it cause none of the messages."""

    folder: str
    others: int


class LikelyCause(NamedTuple):
    """A cause with the values of the log.

    rules: the codes of the rules that find it. fix: what to do about it; empty if the message's fix fits.
    found: where the rules found it in the user's files.
    """

    text: str
    rules: tuple[str, ...] = ()
    fix: str = ""
    found: tuple[FoundCause, ...] = ()


class MessageMeaning(NamedTuple):
    """What a message means in a log. causes: most likely first."""

    meaning: str
    causes: tuple[LikelyCause, ...]
    fix: str

    @property
    def is_found(self) -> bool:
        """Whether a rule found a cause in the user's files."""
        return any(cause.found for cause in self.causes)

    @property
    def best_fix(self) -> str:
        """What to do about the first cause."""
        return self.causes[0].fix if self.causes and self.causes[0].fix else self.fix


def reading(message: LogMessage, values: Mapping[str, str], seen: Collection[str], distro: str = "") -> MessageMeaning:
    """Return the meaning, causes and fix of a message with these values, in a log with the messages `seen`.

    distro: the ROS distro, for names of Debian packages.
    """
    values = {**values, **_meant(message, values), "debian": _debian(values.get("package", ""), distro)}
    causes = [cause for cause in message.causes if not cause.only_if or holds(cause.only_if, values, seen)]
    causes.sort(key=lambda cause: not (cause.first_if and holds(cause.first_if, values, seen)))
    likely = [LikelyCause(filled(cause.text, values), cause.rules, filled(cause.fix, values)) for cause in causes]
    return MessageMeaning(filled(message.meaning, values), tuple(likely), filled(message.fix, values))


def with_findings(known: MessageMeaning, findings: Sequence[FoundCause], values: Collection[str]) -> MessageMeaning:
    """Return the reading with the places where rules found its causes, those causes first.

    values: of the log. Findings that name one of them come first, and if no cause was found, they are a cause of their
    own.
    """
    names = [value for value in values if len(value) >= _LEAST_NAME and " " not in value]
    named = [one for one in findings if any(f"'{name}'" in one.message for name in names)]
    ordered = [*named, *(one for one in findings if one not in named)]
    shown: set[FoundCause] = set()
    causes = []
    for cause in known.causes:
        found = tuple(one for one in ordered if one.code in cause.rules and one not in shown)
        shown.update(found)
        causes.append(cause._replace(found=found))
    if not shown and named:
        codes = tuple(dict.fromkeys(one.code for one in named))
        causes.insert(0, LikelyCause("lint finds a fault of the same part in your files", codes, found=tuple(named)))
    rank = {one: number for number, one in enumerate(ordered)}
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
    if relation == "known":
        return value in _known_types()
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
            value = values.get(name, "").strip()
            known = [] if not other else _known_types() if other == "known" else _words(values.get(other, ""))
            if value and known and value not in known:
                meant = nearest(value, known) or ("" if other == "known" else _by_class(value, known))
                return {"meant": meant} if meant else {}
    return {}


def _debian(package: str, distro: str) -> str:
    """The name of the Debian package of a ROS package."""
    name = package if _PACKAGE.fullmatch(package) else "PACKAGE"
    return f"ros-{distro or '$ROS_DISTRO'}-{name.replace('_', '-')}"


def _by_class(value: str, known: Sequence[str]) -> str | None:
    """The known name whose class, behind the package, contains the class of `value` or is contained in it."""
    last = _class(value)
    longest = [name for name in known if last and (_class(name) in last or last in _class(name))]
    return max(longest, key=len, default=None)


def _class(name: str) -> str:
    return re.split(r"[/:]", name)[-1].lower()


def _known_types() -> list[str]:
    """The types of controllers in the catalogue."""
    return [name for ros in (1, 2) for name in plain(ros, "controllers")]


def _words(text: str) -> list[str]:
    return text.replace(",", " ").split()
