"""The smoke test finds its faults in their bad examples where they are marked, and none in the good ones."""

from __future__ import annotations

from collections.abc import Iterable
from pathlib import Path

import pytest
from smoking import smoked, whole
from smoking_engines import needs_pybullet

from urdfctl.diagnostic import Diagnostic
from urdfctl.fault import Example, Fault, FaultWithMessage
from urdfctl.lint.examples import written
from urdfctl.rules import faults_found_by
from urdfctl.rules.examples import unmarked
from urdfctl.rules.smoke.base_too_slow import base_too_slow
from urdfctl.smoke.results import trouble_of

FAULTS = faults_found_by("smoke")
BAD = {f"{fault.code}-{number}": (fault, example) for fault in FAULTS for number, example in enumerate(fault.bad, 1)}
GOOD = {f"{fault.code}-{number}": (fault, example) for fault in FAULTS for number, example in enumerate(fault.good, 1)}


def is_simulated(code: str) -> bool:
    """Return whether a fault is one that only an engine shows."""
    return "UC920" <= code < "UC950"


def names(examples: Iterable[str], *, simulated: bool) -> list[str]:
    """Return the names of the examples that need an engine, or of the others."""
    return [name for name in examples if is_simulated(name) is simulated]


def found(folder: Path, fault: Fault, example: Example) -> list[Diagnostic]:
    """Return the findings in an example; simulated if the fault needs it."""
    target, settings = written(example, str(folder))
    made = (whole if is_simulated(fault.code) else smoked)(target, **settings._asdict())
    return made.linted.outcome.diagnostics


def assert_found_where_it_is_marked(name: str, folder: Path) -> None:
    fault, example = BAD[name]
    _, marks = unmarked(example.files)
    (folder / "wheel.obj").write_text("v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 99\n", encoding="utf-8")
    findings = [finding for finding in found(folder, fault, example) if finding.code == fault.code]
    assert {(Path(d.at.file).relative_to(folder).as_posix(), d.at.start, d.at.end) for d in findings} == set(marks)


def assert_nothing_is_found(name: str, folder: Path) -> None:
    assert [f"{finding.code} {finding.message}" for finding in found(folder, *GOOD[name])] == []


@pytest.mark.parametrize("name", names(BAD, simulated=False))
def test_a_bad_example_is_found_where_it_is_marked(name: str, tmp_path: Path) -> None:
    assert_found_where_it_is_marked(name, tmp_path)


@pytest.mark.parametrize("name", names(GOOD, simulated=False))
def test_nothing_is_found_in_a_good_example(name: str, tmp_path: Path) -> None:
    assert_nothing_is_found(name, tmp_path)


@needs_pybullet
@pytest.mark.parametrize("name", names(BAD, simulated=True))
def test_a_bad_example_is_found_in_simulation_where_it_is_marked(name: str, tmp_path: Path) -> None:
    assert_found_where_it_is_marked(name, tmp_path)


@needs_pybullet
@pytest.mark.parametrize("name", names(GOOD, simulated=True))
def test_nothing_is_found_in_simulation_in_a_good_example(name: str, tmp_path: Path) -> None:
    assert_nothing_is_found(name, tmp_path)


def test_a_fault_of_the_smoke_test_has_a_message_and_no_check() -> None:
    assert {type(fault) for fault in FAULTS} == {FaultWithMessage}


def test_a_fault_makes_its_message_of_the_facts_that_it_names() -> None:
    assert base_too_slow.facts == ["controller", "speed", "why"]
    trouble = trouble_of(base_too_slow, "controller:base", "base", (), speed="0.01", why="the velocity limits")
    assert trouble.message == "controller 'base' drives the robot at 0.01 m/s at most: the velocity limits"
    with pytest.raises(TypeError, match="why"):
        trouble_of(base_too_slow, "controller:base", "base", (), speed="0.01")
