"""Two processes that share a robot find what one finds alone, whatever becomes of the other one."""

from __future__ import annotations

import json
import os
import pickle
import signal
from collections.abc import Callable, Iterator
from pathlib import Path

import pytest
from folder import Folder

from urdfctl import worker
from urdfctl.diagnostic import Severity
from urdfctl.jobs import lint_all
from urdfctl.lint import Linted, Outcome, Selection
from urdfctl.load import Loader, Target
from urdfctl.rule import Finding, Project, rule
from urdfctl.rules import FAMILIES
from urdfctl.serialise import outcome_to_json
from urdfctl.settings import Settings
from urdfctl.sharing.assistant import Assistant, assist
from urdfctl.source.budget import OverBudget
from urdfctl.source.span import SourceText
from urdfctl.worker import Limits

pytestmark = pytest.mark.skipif(not worker.CAN_FORK, reason="this system cannot fork")
LIMITS = Limits(20.0, 2 << 30, {})
CONTROLLERS = """\
controller_manager:
  ros__parameters:
    update_rate: 100
    arm: {type: joint_trajectory_controller/JointTrajectoryController}
    lost: {type: joint_trajectory_controler/JointTrajectoryController}  # urdfctl: ignore[UC42]
arm:
  ros__parameters:
    joints: [joint_1, joint_x]
    command_interfaces: [effort]
    state_interfaces: [position]
    allow_partial_joint_goal: true
"""


def robot(links: int, inside: str = "") -> str:
    joints = "".join(
        f'  <link name="link_{n}"/>\n  <joint name="joint_{n}" type="revolute"><parent link="link_{n - 1}"/>'
        f'<child link="link_{n}"/><axis xyz="0 0 1"/></joint>\n'
        for n in range(1, links)
    )
    control = (
        '  <ros2_control name="all" type="system"><hardware><plugin>mock_components/GenericSystem</plugin></hardware>\n'
        '    <joint name="joint_1"><command_interface name="position"/><state_interface name="position"/></joint>\n'
        "  </ros2_control>  <!-- urdfctl: ignore[UC301] not used -->\n"
    )
    return f'<robot name="arm">\n  <link name="link_0"/>\n{joints}{control}{inside}</robot>\n'


@pytest.fixture
def target(folder: Folder) -> Target:
    folder.write({"arm.urdf": robot(5), "controllers.yaml": CONTROLLERS})
    return Target("arm.urdf", controllers=("controllers.yaml",))


def linted(target: Target, parallel: int) -> Linted:
    [found] = lint_all([target], Settings(environ={}), Selection(), parallel)
    return found


def alone(target: Target) -> Outcome:
    return Loader(Settings(environ={}), Selection()).lint(target).outcome


def codes(outcome: Outcome) -> set[str]:
    return {diagnostic.code for diagnostic in outcome.diagnostics}


def test_a_robot_with_controllers_is_judged_with_an_assistant_as_alone(target: Target) -> None:
    outcome = linted(target, parallel=2).outcome
    assert outcome == alone(target) == linted(target, parallel=1).outcome
    assert {"UC430", "UC440", "UC450"} <= codes(outcome)
    assert [(use.codes, use.used) for use in outcome.suppressions] == [(("UC301",), False), (("UC42",), True)]


def test_a_large_robot_is_judged_by_two_as_alone(folder: Folder) -> None:
    folder.write({"arm.urdf": robot(60), "controllers.yaml": CONTROLLERS})
    for target in (Target("arm.urdf"), Target("arm.urdf", controllers=("controllers.yaml",))):
        outcome = linted(target, parallel=2).outcome
        assert outcome == alone(target)
        assert outcome.diagnostics


def test_no_process_is_left_behind(target: Target) -> None:
    linted(target, parallel=2)
    with pytest.raises(ChildProcessError):
        os.waitpid(-1, os.WNOHANG)


def with_assistant(target: Target, treat: Callable[[int], None] = lambda _: None) -> Outcome:
    """What this process finds with an assistant to whom something is done before it is asked."""
    loader = Loader(Settings(environ={}), Selection())
    loader.assistant = Assistant(LIMITS)
    try:
        loader.assistant.start()
        assert loader.assistant.pid
        treat(loader.assistant.pid)
        return loader.lint(target).outcome
    finally:
        loader.assistant.dismiss()


def test_an_assistant_that_is_gone_is_done_without(target: Target) -> None:
    def kill(pid: int) -> None:
        os.kill(pid, signal.SIGKILL)
        os.waitid(os.P_PID, pid, os.WEXITED | os.WNOWAIT)

    assert with_assistant(target, kill) == with_assistant(target) == alone(target)


@pytest.mark.parametrize("links", [5, 60])
def test_where_no_more_processes_may_be_made_one_does_it_all(
    folder: Folder, links: int, monkeypatch: pytest.MonkeyPatch
) -> None:
    folder.write({"arm.urdf": robot(links), "controllers.yaml": CONTROLLERS})
    target = Target("arm.urdf", controllers=("controllers.yaml",))
    expected = alone(target)

    def refused() -> int:
        raise BlockingIOError(11, "Resource temporarily unavailable")

    monkeypatch.setattr(os, "fork", refused)
    loader = Loader(Settings(environ={}), Selection())
    loader.may_part, loader.assistant = True, Assistant(LIMITS)
    loader.assistant.start()
    assert loader.lint(target).outcome == expected
    loader.assistant.dismiss()


def test_a_tree_too_deep_to_be_handed_over_is_judged_alone(folder: Folder) -> None:
    depth = 1200
    folder.write({"arm.urdf": robot(5, "<gazebo>" + "<a>" * depth + "</a>" * depth + "</gazebo>\n")})
    folder.write({"controllers.yaml": CONTROLLERS})
    target = Target("arm.urdf", controllers=("controllers.yaml",))
    assert with_assistant(target) == alone(target)


def test_an_assistant_tells_what_the_families_on_controllers_find(target: Target) -> None:
    seen = Loader(Settings(environ={}), Selection()).seen(target)
    asked, answered = os.pipe(), os.pipe()
    text = pickle.dumps((seen.project, list(seen.sources.values()), Selection()))
    with os.fdopen(asked[1], "wb") as asking:
        asking.write(b"%d\n%b" % (len(text), text))
    assist(asked[0], answered[1])
    with os.fdopen(answered[0], "rb") as answer:
        told = json.loads(answer.read())
    of_controllers = [one for one in outcome_to_json(alone(target))["diagnostics"] if one["code"][:3] in ("UC4", "UC7")]
    assert [one for _, diagnostics, _ in told["found"] for one in diagnostics] == of_controllers
    assert len(told["silencing"]) == 1


@rule("UC198", severity=Severity.ERROR, authority="none: a test's own", bad={}, good={})
def ended_by_its_rule(project: Project) -> Iterator[Finding]:
    """A rule that takes too long wherever it is asked."""
    raise OverBudget("it takes longer than 1 s")


def test_a_rule_past_its_time_ends_the_robot_as_in_one_process(folder: Folder, monkeypatch: pytest.MonkeyPatch) -> None:
    urdf = next(number for number, family in enumerate(FAMILIES) if family.prefix == "UC1")
    broken = FAMILIES[urdf]._replace(load=lambda: (ended_by_its_rule,))
    changed = (*FAMILIES[:urdf], broken, *FAMILIES[urdf + 1 :])
    for module in ("urdfctl.rules", "urdfctl.sharing.part", "urdfctl.sharing.parted"):
        monkeypatch.setattr(f"{module}.FAMILIES", changed)
    folder.write({"arm.urdf": robot(60)})
    [diagnostic] = linted(Target("arm.urdf"), parallel=2).outcome.diagnostics
    assert (diagnostic.code, "it takes longer than 1 s" in diagnostic.message) == ("UC014", True)


def test_what_crashes_in_either_process_is_told(folder: Folder, monkeypatch: pytest.MonkeyPatch) -> None:
    @rule("UC199", severity=Severity.ERROR, authority="none: a test's own", bad={}, good={})
    def crashing(project: Project) -> Iterator[Finding]:
        """A rule with a fault of its own."""
        yield Finding(Path("nowhere"), SourceText)  # type: ignore[arg-type]

    changed = tuple(family._replace(load=lambda: (crashing,)) for family in FAMILIES if family.prefix in ("UC1", "UC3"))
    monkeypatch.setattr("urdfctl.sharing.part.FAMILIES", changed)
    monkeypatch.setattr("urdfctl.sharing.parted.FAMILIES", changed)
    folder.write({"arm.urdf": robot(60)})
    outcome = linted(Target("arm.urdf"), parallel=2).outcome
    assert outcome.crashed
    assert [one.code for one in outcome.diagnostics] == ["UC000", "UC000"]
