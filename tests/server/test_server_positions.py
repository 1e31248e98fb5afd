"""Positions in files, between the lines and columns of urdfctl and the units of an editor."""

from __future__ import annotations

import time

import pytest
from editor import types
from hypothesis import given
from hypothesis import strategies as st
from pygls.workspace import PositionCodec

from urdfctl.server.protocol.positions import Positions

UNITS = list(types.PositionEncodingKind)
TEXTS = st.lists(st.sampled_from(["a", "é", "\u2028", "\f", "🤖", "\n", "\r\n", "\r"]), max_size=12).map("".join)


def positions(text: str, unit: types.PositionEncodingKind) -> Positions:
    return Positions(PositionCodec(unit), lambda _: text.encode())


@given(TEXTS, st.sampled_from(UNITS), st.data())
def test_a_position_and_back_is_the_same_place(
    text: str, unit: types.PositionEncodingKind, data: st.DataObject
) -> None:
    found = positions(text, unit)
    line = data.draw(st.integers(1, len(found.lines("r.urdf"))))
    column = data.draw(st.integers(1, 1 + len(found.lines("r.urdf")[line - 1].rstrip("\r\n"))))
    position = found.position_of("r.urdf", line, column)
    assert found.line_and_column("r.urdf", position) == (line, column)


@pytest.mark.parametrize(("unit", "end"), list(zip(UNITS, (7, 5, 4), strict=True)))
def test_a_sign_outside_of_the_basic_plane_has_the_units_of_the_editor(
    unit: types.PositionEncodingKind, end: int
) -> None:
    assert positions('x="🤖"', unit).position_of("r.urdf", 1, 5) == types.Position(0, end)


def test_a_position_behind_the_end_is_the_end() -> None:
    found = positions("ab\ncd", types.PositionEncodingKind.Utf16)
    assert found.line_and_column("r.urdf", types.Position(0, 99)) == (1, 3)
    assert found.line_and_column("r.urdf", types.Position(99, 0)) == (2, 3)


@pytest.mark.parametrize("unit", UNITS)
def test_a_line_of_many_megabytes_takes_no_time(unit: types.PositionEncodingKind) -> None:
    found = positions("é" * (4 << 20), unit)
    began = time.monotonic()
    position = found.position_of("r.urdf", 1, 1 + (4 << 20))
    assert found.line_and_column("r.urdf", position) == (1, 1 + (4 << 20))
    assert time.monotonic() - began < 1
