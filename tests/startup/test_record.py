"""Our named tuples against typing's."""

from __future__ import annotations

import copy
import typing
from collections.abc import Iterator
from typing import Any

import pytest

from urdfctl.startup.records import NamedTuple


class Ours(NamedTuple):
    """A joint."""

    name: str
    axis: tuple[int, ...] = (1, 0, 0)
    parent: Ours | None = None

    @property
    def folded(self) -> str:
        """The name in small letters."""
        return self.name.lower()

    def __str__(self) -> str:
        return f"joint {self.name}"


class Theirs(typing.NamedTuple):
    """A joint."""

    name: str
    axis: tuple[int, ...] = (1, 0, 0)
    parent: Theirs | None = None

    @property
    def folded(self) -> str:
        """The name in small letters."""
        return self.name.lower()

    def __str__(self) -> str:
        return f"joint {self.name}"


class Nothing(NamedTuple):
    """It has no field."""


def _seen(kind: type[Any]) -> Iterator[object]:
    one = kind("Elbow", parent=kind("Shoulder", (0, 1, 0)))
    yield repr(one).replace(kind.__name__, "Made")
    yield str(one), one.folded, kind.__doc__, len(one), one[0], list(one)
    yield one == tuple(one), hash(one) == hash(tuple(one)), isinstance(one, tuple)
    yield one._replace(name="Wrist")[:2], list(one._asdict())
    yield kind._fields, kind._field_defaults, kind.__match_args__, kind._make(["Wrist", (), None])[0]
    yield copy.deepcopy(one) == one, type(copy.copy(one)) is kind
    match one:
        case kind(name, axis):
            yield name, axis


def test_a_record_is_what_typing_would_have_made_of_it() -> None:
    assert list(_seen(Ours)) == list(_seen(Theirs))


@pytest.mark.parametrize("kind", [Ours, Theirs])
def test_a_record_refuses_what_it_has_no_field_for(kind: type[Any]) -> None:
    for arguments, named in (((), {}), (("a", (), None, 1), {}), (("a",), {"name": "b"}), (("a",), {"type": "fixed"})):
        with pytest.raises(TypeError):
            kind(*arguments, **named)
    with pytest.raises((TypeError, ValueError), match="unexpected field names"):  # TypeError is typing's from 3.13 on
        kind("a")._replace(type="fixed")
    with pytest.raises(AttributeError):
        kind("a").name = "b"
    with pytest.raises(AttributeError):
        kind("a").type = "fixed"


def test_a_record_without_fields_is_an_empty_tuple() -> None:
    assert (Nothing(), repr(Nothing())) == ((), "Nothing()")
