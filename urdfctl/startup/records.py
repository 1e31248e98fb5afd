"""A replacement for `typing.NamedTuple` whose classes are created in a tenth of the time.

Saves: a run creates about a hundred of these classes before it reads a file, and `typing` compiles every annotation and
every constructor. Here annotations stay strings. The constructors of all classes with the same number of fields share
one code object, with the names of the fields replaced. Type checkers see `typing.NamedTuple`.
"""

from __future__ import annotations

import functools
from typing import TYPE_CHECKING, Any

if TYPE_CHECKING:
    from typing import NamedTuple as NamedTuple  # noqa: PLC0414 (so that it is exported)
else:
    from operator import itemgetter
    from types import CodeType, FunctionType

    try:
        from _collections import _tuplegetter
    except ImportError:  # pragma: no cover (another Python than CPython and PyPy)

        def _tuplegetter(index: int, doc: str | None) -> property:
            return property(itemgetter(index), doc=doc)

    class _Record(tuple):
        """The base class of all named tuples."""

        __slots__ = ()

        @classmethod
        def _make(cls, values):
            return cls(*values)

        def _replace(self, **changes):
            replaced = tuple.__new__(type(self), map(changes.pop, self._fields, self))
            if changes:
                raise ValueError(f"Got unexpected field names: {list(changes)!r}")
            return replaced

        def _asdict(self):
            return dict(zip(self._fields, self, strict=True))

        def __getnewargs__(self):
            return tuple(self)

        def __repr__(self) -> str:
            fields = (f"{name}={value!r}" for name, value in zip(self._fields, self, strict=True))
            return f"{type(self).__name__}({', '.join(fields)})"

    class _Maker(type):
        """The metaclass: creates a subclass of tuple from a class's annotations and their defaults."""

        def __new__(mcs, name: str, _bases: object, space: dict[str, Any]) -> type[_Record]:
            fields = tuple(space.get("__annotations__", ()))
            defaults = {field: space.pop(field) for field in fields if field in space}
            space["__new__"] = _constructor(fields, tuple(defaults.values()))
            for index, field in enumerate(fields):
                space[field] = _tuplegetter(index, None)
            space.update(_fields=fields, _field_defaults=defaults, __match_args__=fields, __slots__=())
            return type(name, (_Record,), space)

    def _constructor(fields: tuple[str, ...], defaults: tuple[object, ...]) -> FunctionType:
        code = _code(len(fields)).replace(co_varnames=("cls", *fields))
        return FunctionType(code, {"make": tuple.__new__}, "__new__", defaults)

    @functools.cache
    def _code(size: int) -> CodeType:
        names = "".join(f"field{index}, " for index in range(size))
        constructor = eval(f"lambda cls, {names}: make(cls, ({names}))")  # noqa: S307 (no text from outside)
        return constructor.__code__

    class _Base:
        """The object that a class lists as its base to become a named tuple."""

        def __mro_entries__(self, _bases: tuple[object, ...]) -> tuple[type, ...]:
            return (_SHELL,)

    _SHELL = type.__new__(_Maker, "NamedTuple", (), {})
    NamedTuple = _Base()
