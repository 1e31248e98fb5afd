"""The order of a report, and what explains what: a cause comes before its consequences, or stands for them."""

from __future__ import annotations

from urdfctl.diagnostic import Diagnostic, Finding, Severity, diagnosed
from urdfctl.smoke.diagnostics import unexplained
from urdfctl.smoke.ranking import causes_first
from urdfctl.smoke.results import Trouble
from urdfctl.source.span import Place, SourceText


def found(code: str, severity: Severity = Severity.ERROR, file: str = "a.urdf") -> Diagnostic:
    return diagnosed("", "", severity, Finding(Place(SourceText(file, b"x"), 0, end=1), ""))._replace(code=code)


def order(*findings: Diagnostic) -> list[str]:
    return [finding.code for finding in causes_first(findings)]


def test_what_keeps_controllers_from_starting_comes_first() -> None:
    assert order(found("UC913"), found("UC903", file="z.yaml"), found("UC932")) == ["UC903", "UC913", "UC932"]


def test_a_unit_of_the_model_comes_before_the_efforts_that_follow_from_it() -> None:
    grams = found("UC983", Severity.WARNING, "z.urdf")
    assert order(found("UC977", Severity.WARNING), found("UC952"), grams) == ["UC983", "UC952", "UC977"]


def test_what_a_formula_finds_comes_before_what_an_engine_sees() -> None:
    assert order(found("UC941", file="a.yaml"), found("UC940", file="robot.urdf")) == ["UC940", "UC941"]


def test_a_joint_explains_its_own_motion_and_that_of_its_base_but_not_another_joint() -> None:
    cause = Trouble("UC951", "joint:elbow", "friction", "arm")
    own = Trouble("UC932", "joint:elbow", "does not move", "arm")
    other = Trouble("UC932", "joint:wrist", "does not move", "arm")
    base = Trouble("UC941", "controller:arm", "does not drive", "arm")
    elsewhere = base._replace(controller="other")
    assert unexplained([own, other, base, elsewhere], [cause]) == [other, elsewhere]


def test_a_joint_that_falls_explains_the_motion_of_those_that_it_carries() -> None:
    lift = Trouble("UC915", "joint:lift", "too weak", "torso")
    carried = Trouble("UC933", "joint:elbow", "swings", "arm")
    beside = Trouble("UC933", "joint:head", "swings", "head")
    other = Trouble("UC935", "joint:elbow", "moves the wrong way", "arm")
    found = unexplained([carried, beside, other], [lift], {"joint:lift": {"joint:elbow"}})
    assert found == [beside, other]
    assert unexplained([carried], [lift]) == [carried]
