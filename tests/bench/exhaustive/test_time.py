"""Hostile input at full size takes little processor time. The default tests count its work, at small sizes."""

from __future__ import annotations

import time
from collections.abc import Callable
from contextlib import suppress
from pathlib import Path

import pytest
from expansion import expanded, laid_out, robot
from hostile.logs import LONG_LOGS
from hostile.readers import READERS, REPEATED
from test_graph import many_joints
from test_log_digest import log

from urdfctl.errors import UserError
from urdfctl.graph.build import graph_of
from urdfctl.graph.svg import svg
from urdfctl.graph.text_formats import dot, mermaid
from urdfctl.graph.view import collapsed
from urdfctl.source.disk.gitignore import patterns_of
from urdfctl.source.problem import ReadError
from urdfctl.source.span import SourceText
from urdfctl.source.suppressions import suppressions
from urdfctl.source.yaml.tree import read_yaml

QUOTES = "'a" * 4001


def seconds(act: Callable[[], object]) -> float:
    """Return the processor time of an act."""
    started = time.process_time()
    act()
    return time.process_time() - started


@pytest.mark.parametrize(("name", "piece", "size"), REPEATED)
def test_what_is_repeated_very_often_is_read_or_refused_soon(name: str, piece: str, size: int, tmp_path: Path) -> None:
    def read() -> None:
        with suppress(UserError, ReadError):
            READERS[name]((piece * (size // len(piece))).encode(), tmp_path)

    assert seconds(read) < 5


@pytest.mark.parametrize("name", LONG_LOGS)
def test_a_hostile_log_is_read_soon(name: str) -> None:
    data = LONG_LOGS[name](20_000)
    assert seconds(lambda: log(data)) < 5


@pytest.mark.parametrize("text", ["urdfctl: ignore[UC2]\n", "<!-- urdfctl: ignore[UC2]\n", "-->urdfctl: ignore[UC2]\n"])
def test_many_comments_are_searched_soon(text: str) -> None:
    source = SourceText("/r.urdf", text.encode() * 20_000)
    assert seconds(lambda: suppressions(source)) < 2


def test_many_stars_of_a_gitignore_are_matched_soon() -> None:
    [pattern] = patterns_of("/" + "**/a*a*a*a*b/" * 20 + "c")
    assert seconds(lambda: pattern.matches(["a" * 200] * 200, is_folder=False)) < 5


def test_aliases_of_aliases_are_refused_soon() -> None:
    levels = "".join(f"l{n}: &l{n} [{', '.join([f'*l{n - 1}'] * 10)}]\n" for n in range(1, 30))
    assert seconds(lambda: read_yaml(SourceText("/c.yaml", f"l0: &l0 [x]\n{levels}".encode()))) < 1


@pytest.mark.parametrize(
    "body",
    [
        f"<a>{'$a' * 200_000}</a>",
        f'<xacro:macro name="m" params="a:={"x" * 5000}\' b"><a/></xacro:macro><last/>',
        f'<xacro:macro name="m" params="a:={QUOTES}&quot; b"><a/></xacro:macro>',
        f'<xacro:macro name="m" params="{"a " * 20_000}"><a/></xacro:macro>',
    ],
    ids=["dollars", "an unbalanced quote", "many quotes", "params without end"],
)
def test_a_long_text_in_xacro_is_expanded_or_refused_soon(body: str, tmp_path: Path) -> None:
    path = laid_out(tmp_path, {"r.xacro": robot(body)})
    assert seconds(lambda: expanded(path)) < 2


def test_two_hundred_joints_are_drawn_in_less_than_half_a_second(tmp_path: Path) -> None:
    linted = many_joints(tmp_path, 200)

    def draw() -> None:
        graph = graph_of(linted.project, linted.result.outcome.diagnostics)
        for one in (graph, collapsed(graph)):
            assert all(function(one) for function in (mermaid, dot, svg))

    assert seconds(draw) < 0.5
