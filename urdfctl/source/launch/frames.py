"""The names that are in scope while a launch file in Python is followed, and the lists that it extends."""

from __future__ import annotations

import ast
from collections.abc import Mapping, Sequence

from urdfctl.source.launch.terms import (
    MOST_ITEMS,
    Called,
    Constant,
    Items,
    Perhaps,
    Table,
    Term,
    one_of,
    perhaps,
)
from urdfctl.source.span import Place


class Frame:
    """The state of one function call, or of the file.

    names: the local names with their terms.
    outer: the frame in which the function is defined; None for the file.
    returned: the terms that are returned so far.
    sure: whether the current statement is known to run.
    calls: the depth of nested calls.
    """

    __slots__ = ("calls", "names", "outer", "returned", "sure")

    def __init__(self, names: dict[str, Term], outer: Frame | None, *, sure: bool = True, calls: int = 0) -> None:
        self.names = names
        self.outer = outer
        self.returned: list[Term] = []
        self.sure = sure
        self.calls = calls

    def find(self, name: str) -> Term | None:
        """Return the term of a name in this frame or an outer one; None if the name is not defined."""
        frame: Frame | None = self
        while frame is not None:
            if name in frame.names:
                return frame.names[name]
            frame = frame.outer
        return None


def extend(items: Items, value: Term, frame: Frame) -> None:
    """Add the items of a list to another list, as optional items if the statement may not run."""
    more = value.values if isinstance(value, Items) else [Perhaps(value, value.at)]
    for item in more[:MOST_ITEMS]:
        append(items, item, frame)


def append(items: Items, value: Term, frame: Frame) -> None:
    """Add an item to a list, as an optional item if the statement may not run."""
    if len(items.values) < MOST_ITEMS:
        items.values.append(value if frame.sure else perhaps(value))


def add(called: Called, value: Term, frame: Frame) -> None:
    """Add an action to a launch description, as an optional action if the statement may not run."""
    if len(called.added) < MOST_ITEMS:
        called.added.append(value if frame.sure else perhaps(value))


def bound(
    parameters: ast.arguments, arguments: Sequence[Term], keywords: Mapping[str, Term], at: Place
) -> dict[str, Term]:
    """Return a function's parameters with the arguments of a call. Parameters without an argument are left out."""
    positional = [parameter.arg for parameter in (*parameters.posonlyargs, *parameters.args)]
    names = dict(zip(positional, arguments, strict=False))
    if parameters.vararg:
        names[parameters.vararg.arg] = Items(list(arguments[len(positional) :]), at)
    known = {*positional, *(parameter.arg for parameter in parameters.kwonlyargs)}
    names.update((name, value) for name, value in keywords.items() if name in known)
    if parameters.kwarg:
        rest = Table(at)
        for name, value in keywords.items():
            if name not in known:
                rest.put(Constant(name, value.at), value)
        names[parameters.kwarg.arg] = rest
    return names


def merged(branches: Sequence[dict[str, Term]]) -> dict[str, Term]:
    """Return the names after several branches, of which only one runs."""
    names: dict[str, Term] = {}
    for name in dict.fromkeys(name for branch in branches for name in branch):
        values = [branch[name] for branch in branches if name in branch]
        names[name] = one_of(values, values[0].at)
    return names
