"""Count the work of expressions: items of loops, arguments and results of calls, and what operators and methods make.

Each evaluation has an allowance, and so have all of one expansion together. What is counted is refused before it takes
its time or its memory: the operators, calls and loops of an expression are calls of a meter's `guards`.
"""

from __future__ import annotations

import sys
from collections.abc import Callable, Iterable, Iterator, Sequence
from functools import partial
from itertools import chain
from types import BuiltinFunctionType, FunctionType, MethodDescriptorType
from typing import Any

from urdfctl.source.budget import OverBudget
from urdfctl.source.opaque import Opaque
from urdfctl.source.xacro.expressions import guards
from urdfctl.source.xacro.expressions.guards import LONGEST_VALUE, ForbiddenExpression

MOST_OF_EXPRESSION = 500_000
MOST_OF_EXPANSION = 10_000_000
_LETTERS = 32
"""As many letters count as much as one item of a list."""
_BITS = 64
_MOST_ITEMS = 250_000
_FEW = 10
_CONTAINERS = (list, tuple, set, frozenset, dict)
_TOO_LARGE = "the value of the expression is too large"
_WALKED = (str, bytes, *_CONTAINERS)
_QUICK = frozenset((len, isinstance, issubclass, bool))
"""Functions that take no longer for a large argument."""


class Meter:
    """Counts the work of the expressions of one expansion.

    trust: True to count without limits.
    guards: what the operators, calls and loops of an expression call, in the order of `expressions.GUARDS`.
    """

    def __init__(self, *, trust: bool = False) -> None:
        self._used = 0
        self._until = sys.maxsize if trust else MOST_OF_EXPRESSION
        self._known: dict[int, tuple[Any, int, int]] = {}
        """Containers that names have as values, with their length and size, by `id`."""
        self.guards: tuple[Callable[..., Any], ...] = (
            *(guards.attribute, self._times, guards.power, guards.shifted, self._remainder),
            *(self._plus, self._minus, self._either, self._both, self._one),
            *(self.call, self.counted, self._searched, self.kept),
        )

    def begin(self) -> None:
        """Give the next evaluation its allowance. Raises OverBudget if the expansion has used its own."""
        if self._used > MOST_OF_EXPANSION:
            raise OverBudget("its expressions need more work than one robot may take")
        self._until = self._used + MOST_OF_EXPRESSION

    def spend(self, units: int) -> None:
        """Count work. Raises ForbiddenExpression if the evaluation has used its allowance."""
        self._used += units
        if self._used > self._until:
            raise ForbiddenExpression("the expression needs too much work: it repeats too much")

    def looked_up(self, value: Any) -> Any:
        """Return the value of a name, which is counted once as long as it is the same. For errors, see `checked`."""
        kind = type(value)
        if kind is str and len(value) <= LONGEST_VALUE:
            return value
        if kind is float or kind is int or not isinstance(value, _CONTAINERS):
            return self.checked(value)
        known, length, size = self._known.get(id(value), (None, 0, 0))
        if known is not value or length != len(value):
            size = self._size(value)
            self._known[id(value)] = value, len(value), size
        return self._sized(value, size)

    def checked(self, value: Any) -> Any:
        """Return the value of an expression. ForbiddenExpression if it is too large: the next one could double it."""
        kind = type(value)
        if kind is float or kind is int:
            return value
        if isinstance(value, _CONTAINERS):
            return self._sized(value, self._size(value))
        if isinstance(value, str | bytes) and len(value) > LONGEST_VALUE:
            raise ForbiddenExpression(_TOO_LARGE)
        return value

    def _sized(self, value: Any, size: int) -> Any:
        self.spend(size)
        if size > _MOST_ITEMS:
            raise ForbiddenExpression(_TOO_LARGE)
        return value

    def joined(self, values: Sequence[Any]) -> str:
        """Return the texts of some values as one. ForbiddenExpression if it is too large."""
        if len(values) > _FEW and sum(map(self._letters, values)) > LONGEST_VALUE:
            raise ForbiddenExpression(_TOO_LARGE)
        text = "".join(map(str, values))
        if len(text) > guards.MOST_PLACES:
            self.begin()
            self.spend(len(text) // _LETTERS)
        return str(self.checked(text))

    def _size(self, value: Any) -> int:
        """The work of walking through a value: its items, their items, and texts by their length. More than is left of
        the allowance is not counted to its end.
        """
        if isinstance(value, str | bytes):
            return 1 + len(value) // _LETTERS
        if isinstance(value, int):
            return 1 + value.bit_length() // _BITS
        size = 1
        left = self._until - self._used
        pending = [value] if isinstance(value, _CONTAINERS) else []
        while pending and size <= left:
            container = pending.pop()
            size += len(container)
            for item in _items(container) if size <= left else ():
                kind = type(item)
                if kind is str:
                    size += len(item) // _LETTERS
                elif kind is not float and kind is not int and isinstance(item, _CONTAINERS):
                    pending.append(item)
        return size

    # -- loops -------------------------------------------------------------------------------------------------------

    def counted(self, values: Any) -> Any:
        """Return what a loop or a function goes through. Items of an iterator are counted when they are taken."""
        kind = type(values)
        if hasattr(kind, "__next__"):
            return self._each(values)
        if hasattr(kind, "__len__") and kind is not Opaque:
            self.spend(len(values))
        return values

    def _each(self, values: Iterator[Any]) -> Iterator[Any]:
        for value in values:
            self.spend(1)
            yield value

    def _searched(self, values: Any) -> Any:
        """What `in` searches."""
        if isinstance(values, str | bytes):
            self.spend(len(values) // _LETTERS)
            return values
        return self.counted(values) if isinstance(values, list | tuple) or hasattr(type(values), "__next__") else values

    def kept(self, value: Any) -> Any:
        """Return a value of which an expression may make many."""
        self.spend(1 if type(value) is float else self._size(value))
        return value

    # -- calls -------------------------------------------------------------------------------------------------------

    def call(self, function: Any, /, *arguments: Any, **keywords: Any) -> Any:
        """Return what a function gives. Its arguments and its result count; for a lambda, its body counts."""
        self.spend(1)
        kind = type(function)
        if kind is FunctionType and function.__code__.co_name == "<lambda>":
            result = function(*arguments, **keywords)
            return result if isinstance(result, _CONTAINERS) else self.kept(result)
        if kind is MethodDescriptorType and arguments:
            return self.call(function.__get__(arguments[0]), *arguments[1:], **keywords)
        if (kind is BuiltinFunctionType or kind is type) and function in _QUICK:
            return function(*arguments, **keywords)
        arguments = tuple(map(self._taken, arguments))
        keywords = {name: self._taken(value) for name, value in keywords.items()}
        if kind is BuiltinFunctionType and isinstance(function.__self__, str | bytes | list):
            arguments, keywords = self._for_method(function, arguments, keywords)
        result = function(*arguments, **keywords)
        # what functions of xacro and of ours give is no larger than what they were given, or a file
        return result if kind is FunctionType or type(result) is float else self.kept(result)

    def _taken(self, value: Any) -> Any:
        """An argument of a function, which may go through all that is in it."""
        kind = type(value)
        if kind is float or kind is int:
            return value
        return self.kept(value) if isinstance(value, _WALKED) else self.counted(value)

    def _for_method(self, method: Any, arguments: tuple[Any, ...], keywords: dict[str, Any]) -> Any:
        """The arguments for a method of a text or a list."""
        of = method.__self__
        if isinstance(of, list):
            self.spend(len(of))
            return arguments, {name: self.calling(value) for name, value in keywords.items()}
        self.spend(len(of) // _LETTERS)
        if method.__name__ in guards.LENGTHENING and arguments:
            if method.__name__ == "join":
                arguments = ([*arguments[0]], *arguments[1:])
            guards.check_method(of, method.__name__, (*arguments, *keywords.values()), self._letters)
        return arguments, keywords

    def _letters(self, value: Any) -> int:
        """How many letters the text of a value may have."""
        return len(value) if isinstance(value, str | bytes) else _LETTERS * self._size(value)

    def calling(self, function: Any) -> Any:
        """Return a function that another one is to call, so that each of its calls counts."""
        return partial(self.call, function) if callable(function) else function

    # -- operators ---------------------------------------------------------------------------------------------------

    def _result(self, value: Any) -> Any:
        kind = type(value)
        return value if kind is float or kind is int else self.kept(value)

    def _times(self, left: Any, right: Any) -> Any:
        return self._result(guards.times(left, right))

    def _remainder(self, left: Any, right: Any) -> Any:
        if isinstance(left, str | bytes):
            guards.check_filled(left, self._letters(right))
            return self.kept(left % right)
        return left % right

    def _plus(self, left: Any, right: Any) -> Any:
        return self._result(left + right)

    def _minus(self, left: Any, right: Any) -> Any:
        return self._result(left - right)

    def _either(self, left: Any, right: Any) -> Any:
        return self._result(left | right)

    def _both(self, left: Any, right: Any) -> Any:
        return self._result(left & right)

    def _one(self, left: Any, right: Any) -> Any:
        return self._result(left ^ right)


def _items(container: Any) -> Iterable[Any]:
    """All that is in a container, and the keys of a dict. What YAML's containers wrap is not wrapped again."""
    if isinstance(container, dict):
        return chain(dict.keys(container), dict.values(container))
    return list.__iter__(container) if isinstance(container, list) else container
