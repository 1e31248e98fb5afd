"""What the expressions of a launch file stand for, as far as that can be told without running anything."""

from __future__ import annotations

from collections.abc import Callable, Iterator, Mapping, Sequence

from urdfctl.record import NamedTuple
from urdfctl.source.opaque import UNKNOWN
from urdfctl.source.span import Place

Plain = str | int | float | bool | None

MOST_CHARACTERS = 1 << 16
MOST_ITEMS = 2000
_MOST_OPTIONS = 8


class Constant(NamedTuple):
    """A text, a number, a truth or None, with the place where it is written. A text may hold UNKNOWN."""

    value: Plain
    at: Place

    @property
    def text(self) -> str | None:
        """The text; None where it is none."""
        return self.value if isinstance(self.value, str) else None


class Missing(NamedTuple):
    """What cannot be told."""

    at: Place


class Items:
    """A list or tuple, which methods may lengthen."""

    __slots__ = ("at", "values")

    def __init__(self, values: Sequence[Term], at: Place) -> None:
        self.values = list(values)
        self.at = at


class Table:
    """A dict whose keys are texts; not `whole` where some key is not known."""

    __slots__ = ("at", "entries", "keys", "whole")

    def __init__(self, at: Place) -> None:
        self.at = at
        self.entries: dict[str, Term] = {}
        self.keys: dict[str, Place] = {}
        self.whole = True

    def put(self, key: Term, value: Term) -> None:
        """Set an entry."""
        text = key.text if isinstance(key, Constant) else None
        if text is None or UNKNOWN in text or len(self.entries) >= MOST_ITEMS:
            self.whole = False
        else:
            self.entries[text] = value
            self.keys[text] = key.at

    def take(self, other: Table) -> None:
        """Set all entries of another one."""
        self.entries.update(other.entries)
        self.keys.update(other.keys)
        self.whole = self.whole and other.whole


class Name(NamedTuple):
    """Something that is imported, by its full name: `launch_ros.actions.Node`."""

    path: str
    at: Place


class Called:
    """A call that is not made: of something imported, or of a method `of` a term. Later calls may add to it."""

    __slots__ = ("added", "arguments", "at", "keywords", "name", "of")

    def __init__(
        self, name: str, at: Place, arguments: Sequence[Term] = (), keywords: Mapping[str, Term] | None = None
    ) -> None:
        self.name = name
        self.at = at
        self.arguments = list(arguments)
        self.keywords = dict(keywords or {})
        self.of: Term | None = None
        self.added: list[Term] = []

    @property
    def short(self) -> str:
        """The last part of the name."""
        return self.name.rpartition(".")[2]

    def given(self, keyword: str, position: int | None = None) -> Term | None:
        """An argument by its keyword, else by its position."""
        found = self.keywords.get(keyword)
        if found is None and position is not None and position < len(self.arguments):
            found = self.arguments[position]
        return None if isinstance(found, Constant) and found.value is None else found


class Member(NamedTuple):
    """An attribute of a term."""

    of: Term
    name: str
    at: Place


class Function(NamedTuple):
    """A function of the file: `call` gives what it returns for some arguments."""

    name: str
    call: Callable[[Sequence[Term], Mapping[str, Term], Context | None], Term]
    at: Place


class OneOf(NamedTuple):
    """One of several terms: which one is not known."""

    options: tuple[Term, ...]
    at: Place


class Perhaps(NamedTuple):
    """A term that may be there or not."""

    term: Term
    at: Place


Term = Constant | Missing | Items | Table | Name | Called | Member | Function | OneOf | Perhaps


class Context(NamedTuple):
    """A launch as it runs: what a substitution stands for in it."""

    perform: Callable[[Term], str]


def one_of(options: Sequence[Term], at: Place) -> Term:
    """A term that is one of several; what they all are where they do not differ."""
    flat: list[Term] = []
    for option in options:
        for one in option.options if isinstance(option, OneOf) else (option,):
            if not any(is_same(one, known) for known in flat):
                flat.append(one)
    if len(flat) == 1:
        return flat[0]
    return OneOf(tuple(flat), at) if 1 < len(flat) <= _MOST_OPTIONS else Missing(at)


def is_same(one: Term, other: Term) -> bool:
    """Whether two terms are surely the same."""
    if isinstance(one, Constant) and isinstance(other, Constant):
        return type(one.value) is type(other.value) and one.value == other.value and UNKNOWN not in str(one.value)
    return one is other or (isinstance(one, Missing) and isinstance(other, Missing))


def perhaps(term: Term) -> Term:
    """A term that may be there or not."""
    return term if isinstance(term, Perhaps) else Perhaps(term, term.at)


def known_text(term: Term | None) -> str | None:
    """The text that a term is; None where it is none, or not all known."""
    text = term.text if isinstance(term, Constant) else None
    return None if text is None or UNKNOWN in text else text


def outside(package: str) -> str:
    """The folder of a package that is not among the sources: not known, but for its name."""
    return f"{UNKNOWN}({package})"


def flattened(term: Term | None, depth: int = 0) -> Iterator[Term]:
    """The items of lists in lists."""
    if isinstance(term, Items) and depth < 20:  # noqa: PLR2004 (a list may hold itself)
        for value in term.values:
            yield from flattened(value, depth + 1)
    elif term is not None:
        yield term
