"""Edits in bytes: what they make of a file, which of them clash, and where the rest comes to stand."""

from __future__ import annotations

import pytest
from hypothesis import given
from hypothesis import strategies as st

from urdfctl.fix.edits import Shift, Splice, Taken, clash, edited

FILE = "/r.urdf"


def splice(start: int, end: int, text: str = "") -> Splice:
    return Splice(FILE, start, end, text)


@st.composite
def files_and_edits(draw: st.DrawFn) -> tuple[bytes, list[Splice]]:
    """Some bytes, and edits in them of which none clash."""
    data = draw(st.binary(max_size=40))
    taken, chosen = Taken(), []
    for _ in range(draw(st.integers(0, 5))):
        start = draw(st.integers(0, len(data)))
        edit = splice(start, draw(st.integers(start, len(data))), draw(st.text(alphabet="xä🤖\n", max_size=5)))
        if taken.take([edit]) and edit not in chosen:
            chosen.append(edit)
    return data, draw(st.permutations(chosen))


def test_bytes_are_replaced_put_in_and_taken_out_in_any_order() -> None:
    edits = [splice(6, 8), splice(0, 1, "J"), splice(3, 3, "ä")]
    assert edited(b"abcdefghi", edits) == "Jbcädefi".encode()


@given(files_and_edits())
def test_the_bytes_outside_the_edits_are_the_same_in_the_same_order(given_: tuple[bytes, list[Splice]]) -> None:
    data, edits = given_
    after = edited(data, edits)
    assert len(after) == len(data) + sum(len(one.text.encode()) - (one.end - one.start) for one in edits)
    shift = Shift(edits)
    kept = [offset for offset in range(len(data)) if not any(one.start <= offset < one.end for one in edits)]
    assert [shift.of(offset) for offset in kept] == sorted(shift.of(offset) or 0 for offset in kept)
    assert all(after[shift.of(offset) or 0] == data[offset] for offset in kept)


@given(files_and_edits())
def test_a_byte_of_the_edited_file_is_either_new_or_comes_from_one_that_stayed(
    given_: tuple[bytes, list[Splice]],
) -> None:
    data, edits = given_
    shift = Shift(edits)
    moved = {shift.of(offset) for offset in range(len(data))} - {None}
    new = {offset for offset in range(len(edited(data, edits))) if shift.is_new(offset)}
    assert not moved & new
    assert moved | new == set(range(len(edited(data, edits))))


@given(files_and_edits())
def test_a_byte_that_is_replaced_is_known_by_where_its_edit_stands(given_: tuple[bytes, list[Splice]]) -> None:
    data, edits = given_
    shift = Shift(edits)
    for edit in edits:
        for offset in range(edit.start, edit.end):
            assert shift.of(offset) is None
            assert shift.replacing(offset) == [edit]
            assert edited(data, edits)[shift.near(offset) :].startswith(edit.text.encode())


@pytest.mark.parametrize(
    ("one", "other", "expected"),
    [
        (splice(1, 3), splice(3, 5), False),
        (splice(1, 4), splice(3, 5), True),
        (splice(1, 5), splice(2, 3), True),
        (splice(2, 2, "a"), splice(2, 2, "b"), True),
        (splice(2, 2, "a"), splice(2, 2, "a"), False),
        (splice(2, 2, "a"), splice(2, 5), True),
        (splice(5, 5, "a"), splice(2, 5), True),
        (splice(1, 1, "a"), splice(2, 5), False),
        (splice(1, 4), Splice("/other.urdf", 1, 4, "x"), False),
    ],
)
def test_edits_clash_that_share_bytes_or_whose_order_is_anybodys_guess(
    one: Splice, other: Splice, expected: bool
) -> None:
    assert clash(one, other) == clash(other, one) == expected


def test_of_edits_that_belong_together_all_are_taken_or_none() -> None:
    taken = Taken()
    assert taken.take([splice(0, 2, "x"), splice(8, 9, "y")])
    assert not taken.take([splice(4, 5, "z"), splice(1, 3, "z")])
    assert taken.take([splice(4, 6, "w")])
    assert taken.take([splice(0, 2, "x")])
    assert not taken.take([splice(20, 22, "a"), splice(21, 23, "b")])


@given(st.lists(st.tuples(st.integers(0, 12), st.integers(0, 4)), max_size=12))
def test_what_is_taken_never_clashes(spans: list[tuple[int, int]]) -> None:
    taken, chosen = Taken(), []
    for number, (start, length) in enumerate(spans):
        edit = splice(start, start + length, str(number))
        fits = not any(clash(edit, other) for other in chosen)
        assert taken.take([edit]) == fits
        chosen += [edit] if fits else []


def test_an_edit_outside_of_the_bytes_is_refused() -> None:
    with pytest.raises(ValueError, match="bytes 3 to 9 do not exist"):
        edited(b"abc", [splice(3, 9)])
