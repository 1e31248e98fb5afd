"""Terms: the values of a launch file's expressions, as far as they are known without running it."""

from __future__ import annotations

import re
from collections.abc import Callable, Mapping, Sequence

from urdfctl.source.opaque import OUTSIDE, UNKNOWN
from urdfctl.source.span import Place
from urdfctl.startup.records import NamedTuple

Plain = str | int | float | bool | None

MOST_ITEMS = 2000
_MOST_OPTIONS = 8


class Constant(NamedTuple):
    """A string, a number, a bool or None, with its place. A string can contain UNKNOWN."""

    value: Plain
    at: Place

    @property
    def text(self) -> str | None:
        """The text; None if the value is not a string."""
        return self.value if isinstance(self.value, str) else None


class UnknownTerm(NamedTuple):
    """An unknown value. `too_long`: it is a text that is longer than any in a real launch file."""

    at: Place
    too_long: bool = False


class Items:
    """A list or tuple. Methods can add items later."""

    __slots__ = ("at", "values")

    def __init__(self, values: Sequence[Term], at: Place) -> None:
        self.values = list(values)
        self.at = at


class Table:
    """A dict with strings as keys.

    entries: the values by key.
    keys: the places of the keys.
    whole: False if there may be further keys, which are unknown.
    """

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
        """Set all entries of another dict."""
        self.entries.update(other.entries)
        self.keys.update(other.keys)
        self.whole = self.whole and other.whole


class ImportedName(NamedTuple):
    """An imported or built-in name; `path` is the full name, e.g. `launch_ros.actions.Node`."""

    path: str
    at: Place


class Called:
    """A recorded call of an imported name, or of a method. The call is not executed.

    name: full name of the function or class, or name of the method.
    arguments, keywords: the positional and keyword arguments.
    of: the term whose method is called; None for a function.
    added: terms that later calls add, such as actions of a launch description.
    """

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
        """Return an argument by its keyword, otherwise by its position; None if it is not given, or is `None`."""
        argument = self.keywords.get(keyword)
        if argument is None and position is not None and position < len(self.arguments):
            argument = self.arguments[position]
        return None if isinstance(argument, Constant) and argument.value is None else argument


class Member(NamedTuple):
    """An attribute of a term."""

    of: Term
    name: str
    at: Place


class Function(NamedTuple):
    """A function that the file defines; `call` returns its result for arguments, keywords and a launch context."""

    name: str
    call: Callable[[Sequence[Term], Mapping[str, Term], Context | None], Term]
    at: Place


class OwnMethod(NamedTuple):
    """A function of a class that the file defines.

    kind: `staticmethod`, `classmethod`, `property`, or empty for a method of its objects.
    """

    function: Function
    kind: str
    at: Place


class OwnClass(NamedTuple):
    """A class that the file defines.

    members: its methods and attributes, and those of the classes that it is derived from.
    fields: those of a dataclass, in order; None for another class.
    """

    name: str
    members: Mapping[str, Term]
    fields: tuple[str, ...] | None
    at: Place


class OwnObject:
    """An object of a class that the file defines, with the attributes that it was given."""

    def __init__(self, of: OwnClass, at: Place) -> None:
        self.of = of
        self.at = at
        self.attributes: dict[str, Term] = {}


class OneOf(NamedTuple):
    """One of several terms; it is unknown which."""

    options: tuple[Term, ...]
    at: Place


class Perhaps(NamedTuple):
    """An optional item: the term may be present or absent."""

    term: Term
    at: Place


_Own = OwnMethod | OwnClass | OwnObject
Term = Constant | UnknownTerm | Items | Table | ImportedName | Called | Member | Function | OneOf | Perhaps | _Own


class Context(NamedTuple):
    """A launch context; `perform` returns the text of a substitution."""

    perform: Callable[[Term], str]


def one_of(options: Sequence[Term], at: Place) -> Term:
    """Return a term that is one of several; the term itself if all are the same, unknown if there are too many."""
    distinct: list[Term] = []
    for option in options:
        for term in option.options if isinstance(option, OneOf) else (option,):
            if not any(is_same(term, known) for known in distinct):
                distinct.append(term)
    if len(distinct) == 1:
        return distinct[0]
    return OneOf(tuple(distinct), at) if 1 < len(distinct) <= _MOST_OPTIONS else UnknownTerm(at)


def is_same(left: Term, right: Term) -> bool:
    """Return whether two terms are known to have the same value; two unknown terms count as the same.

    The folder of a package is the same everywhere, though it is not known.
    """
    if left is right:
        return True
    if isinstance(left, Constant) and isinstance(right, Constant):
        is_equal = type(left.value) is type(right.value) and left.value == right.value
        return is_equal and UNKNOWN not in re.sub(OUTSIDE, "", str(left.value))
    return isinstance(left, UnknownTerm) and isinstance(right, UnknownTerm)


def perhaps(term: Term) -> Term:
    """Return a term as an optional item."""
    return term if isinstance(term, Perhaps) else Perhaps(term, term.at)


def known_text(term: Term | None) -> str | None:
    """Return the text of a term; None if it is not a string or not fully known."""
    text = term.text if isinstance(term, Constant) else None
    return None if text is None or UNKNOWN in text else text


def outside(package: str) -> str:
    """Return the path that represents the unknown folder of a package that is not among the sources."""
    return f"{UNKNOWN}({package})"
