"""The places of findings: each at what it is about, and none where a comment suppresses it."""

from __future__ import annotations

import pytest

from urdfctl.diagnostic import Diagnostic, Finding, Severity, diagnosed
from urdfctl.smoke.diagnostics import diagnostics_of, placed_diagnostics, suppressed_codes
from urdfctl.smoke.results import Trouble
from urdfctl.source.span import Place, SourceText

TEXT = """<robot name="r">
  <link name="base"/>
  <link name="arm"/> <!-- urdfctl: ignore[UC957] -->
</robot>
"""
SOURCE = SourceText("/r.urdf", TEXT.encode())


def at(words: str) -> Place:
    start = TEXT.index(words)
    return Place(SOURCE, start, end=start + len(words))


PLACES = [("robot", at("<robot")), ("link:base", at('<link name="base"/>')), ("link:arm", at('<link name="arm"/>'))]
SMALL = Trouble("UC957", "link:arm", "link 'arm' is too small", None)


def lines(troubles: list[Trouble], suppressed: dict[str, list[str]] | None = None) -> list[tuple[str, int]]:
    return [(one.code, one.at.line) for one in diagnostics_of(troubles, placed_diagnostics(PLACES), suppressed or {})]


def test_a_finding_is_where_its_subject_is_or_at_the_robot() -> None:
    elsewhere = SMALL._replace(subject="link:unknown")
    assert lines([SMALL, elsewhere, SMALL._replace(subject="link:base")]) == [("UC957", 3), ("UC957", 1), ("UC957", 2)]


def test_only_wanted_subjects_and_the_robot_have_places() -> None:
    assert set(placed_diagnostics(PLACES)) == {"robot", "link:base", "link:arm"}
    assert set(placed_diagnostics(PLACES, ["link:arm", "joint:j"])) == {"robot", "link:arm"}
    assert set(placed_diagnostics(PLACES, [])) == {"robot"}


def test_the_first_place_of_a_subject_counts() -> None:
    again = [*PLACES, ("link:base", at("</robot>"))]
    assert placed_diagnostics(again)["link:base"].at.line == 2


@pytest.mark.parametrize(("code", "kept"), [("UC957", []), ("UC950", [("UC950", 3)])])
def test_a_comment_suppresses_its_code_on_its_line(code: str, kept: list[tuple[str, int]]) -> None:
    suppressed = suppressed_codes(PLACES, {}, [SOURCE])
    assert suppressed == {"link:arm": ["UC957"]}
    assert lines([SMALL._replace(code=code)], suppressed) == kept


def error_at(path: str) -> Diagnostic:
    place = Place(SourceText(path, TEXT.encode()), at('<link name="arm"/>').span.start, end=len(TEXT))
    return diagnosed("UC101", "", Severity.ERROR, Finding(place, ""))


def test_a_comment_suppresses_what_an_error_of_lint_on_its_line_causes() -> None:
    causes = {"lint:here": error_at("/r.urdf"), "lint:elsewhere": error_at("/other.urdf")}
    assert suppressed_codes([], causes, [SOURCE]) == {"lint:here": ["UC957"]}
    assert suppressed_codes(PLACES, causes, []) == {}
