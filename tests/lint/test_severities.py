"""Each fault that lint finds states what the runtime does with its fault, and its severity follows from that."""

from __future__ import annotations

import re

import pytest
from sampling import assert_each

from urdfctl.fault import Fault, Runtime, Severity
from urdfctl.report.fault_explanation import fault_explanation
from urdfctl.rules import fault_of, faults_found_by

OF_LINT = {fault.code: fault for fault in faults_found_by("lint")}
CONDITION = re.compile(
    r"\b(?:if|unless|since|until|up to|from|without|elsewhere|real hardware|later|earlier|other|with|after|in)\b",
    re.IGNORECASE,
)

SAID_OF = {
    Runtime.REFUSES: r"reject|refus|stops?\b|fails?\b|exits?\b|waits?\b|cannot|gives up|requires|raises|error|"
    r"deactivated|no controller|not (?:be )?(?:loaded|started|activated|initialized|accepted|expanded|found)",
    Runtime.CRASHES: r"crash|exit|throw|exception",
    Runtime.DROPS: r"drop|skip|leaves? (?:it )?out|reads? only|does nothing|stays inactive|ignores|cannot|without|"
    r"knows no|not (?:loaded|load|find|start|work)",
    Runtime.IGNORES: r"ignor|silently|lost|leaves? (?:it )?out|drop|no effect|not (?:read|used|affect)|default|replace|"
    r"only (?:one|the)\b|without a message|hides|missing|nothing",
    Runtime.WARNS: r"warn|prints?\b|\blogs?\b|logged|report|message|error",
}
"""What the explanation or the authority of a rule says if the runtime does this. The rest has no words of its own."""


def test_a_rule_explains_what_it_states_that_the_runtime_does() -> None:
    def check(fault: Fault) -> None:
        said = SAID_OF.get(fault.runtime)
        text = f"{fault.why} {fault.authority}"
        assert said is None or re.search(said, text, re.IGNORECASE), f"no word of '{fault.runtime.value}' in: {text}"

    assert_each(check, OF_LINT)


def test_the_severity_of_a_fault_is_one_that_goes_with_what_the_runtime_does_or_says_why_not() -> None:
    def check(fault: Fault) -> None:
        goes_with_it = fault.severity in fault.runtime.severities
        assert goes_with_it != bool(fault.because), "give `because` if, and only if, the severity is another one"

    assert_each(check, OF_LINT)


def test_a_rule_that_says_refuses_or_crashes_is_an_error_or_says_when_it_is_not() -> None:
    def check(fault: Fault) -> None:
        if re.search(r"\b(?:reject|refuse|crash)", fault.why) and fault.severity is not Severity.ERROR:
            assert fault.because or CONDITION.search(fault.why), "name the condition, or make it an error"

    assert_each(check, OF_LINT)


@pytest.mark.parametrize(
    ("runtime", "severities"),
    [
        (Runtime.REFUSES, {Severity.ERROR}),
        (Runtime.CRASHES, {Severity.ERROR}),
        (Runtime.DROPS, {Severity.ERROR}),
        (Runtime.IGNORES, {Severity.WARNING}),
        (Runtime.MISBEHAVES, {Severity.WARNING}),
        (Runtime.WARNS, {Severity.WARNING, Severity.INFO}),
        (Runtime.WORKS, {Severity.INFO}),
    ],
)
def test_what_breaks_the_robot_is_an_error_and_what_works_is_info(runtime: Runtime, severities: set[Severity]) -> None:
    assert set(runtime.severities) == severities


def test_explain_says_what_the_runtime_does() -> None:
    assert "Runtime: goes on without the part.\n" in fault_explanation(fault_of("UC204"))
    assert "Runtime: does something else than what was meant.\n" in fault_explanation(fault_of("UC932"))
    told = " ".join(fault_explanation(fault_of("UC114")).split())
    assert "warning, because only Gazebo does, and the robot may not run" in told


def test_a_rule_is_explained_where_the_process_works(monkeypatch: pytest.MonkeyPatch) -> None:
    """The server explains rules while another thread lints relative paths."""

    def fails(folder: str) -> None:
        pytest.fail(f"the working directory becomes {folder}")

    monkeypatch.setattr("os.chdir", fails)
    assert "robot.urdf:" in fault_explanation(fault_of("UC204"))
