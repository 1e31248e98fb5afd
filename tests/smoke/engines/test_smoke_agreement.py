"""Two engines: a controller fails only if both see it fail, and what only one of them sees is a warning."""

from __future__ import annotations

from urdfctl.rules.smoke.does_not_turn_left import does_not_turn_left
from urdfctl.rules.smoke.joint_does_not_follow import joint_does_not_follow
from urdfctl.rules.smoke.joint_too_fast import joint_too_fast
from urdfctl.rules.smoke.wheel_measures_differ import wheel_measures_differ
from urdfctl.smoke.diagnostics import unexplained
from urdfctl.smoke.motion.engine_agreement import compared, decided, is_certain
from urdfctl.smoke.motion.plan import MotionPlan, SimulationResult
from urdfctl.smoke.results import Curve, Trouble, trouble_of
from urdfctl.smoke.robot import Mechanism
from urdfctl.smoke.tasks import ControllerTask, Drive, MotionFamily

LATE = trouble_of(joint_does_not_follow, "joint:j", "arm", joint="j", expected=0.2, actual=0.1, unit="rad")
FAST = trouble_of(joint_too_fast, "joint:j", "arm", joint="j", fastest=2.0, limit=1.0, unit="rad")

BOTH = ("pybullet", "mujoco")


def result(*troubles: Trouble, moved: tuple[str, ...] = ("arm",), left: tuple[str, ...] = ()) -> SimulationResult:
    return SimulationResult(tuple(troubles), moved, left_to_others=left)


def codes(tried: SimulationResult) -> list[str]:
    return [trouble.code for trouble in tried.troubles]


ARM = ControllerTask("arm", MotionFamily.TRAJECTORY, ("j",), "position")
BASE = ControllerTask("base", MotionFamily.DIFFERENTIAL, ("l", "r"), "velocity", drive=Drive(("l",), ("r",)))


def plan(*tasks: ControllerTask) -> MotionPlan:
    return MotionPlan("pybullet", "", Mechanism("base", {}, ()), tasks, rate=100.0, fixed=True)


def test_a_result_with_an_error_or_a_controller_that_was_not_judged_is_not_certain() -> None:
    assert is_certain(plan(ARM), result())
    assert is_certain(plan(ARM), result(FAST))
    assert not is_certain(plan(ARM), result(LATE))
    assert not is_certain(plan(ARM), result(left=("arm",)))


def test_a_base_is_driven_in_both_engines_if_the_first_one_leaves_time_for_it() -> None:
    assert not is_certain(plan(ARM, BASE), result())
    assert is_certain(plan(ARM, BASE), result()._replace(seconds=20.0))


def test_a_disagreement_about_what_a_known_finding_explains_is_not_told() -> None:
    measure = trouble_of(
        wheel_measures_differ, "controller:base", "base", measure="wheelbase", expected=1.9, actual=0.95
    )
    turned = trouble_of(does_not_turn_left, "controller:base", "base", expected=0.17, actual=0.3)
    doubts = decided(result(turned, moved=("base",)), result(moved=("base",)), BOTH).troubles
    assert [doubt.code for doubt in doubts] == ["UC963"]
    assert unexplained(doubts, [measure]) == []
    assert unexplained(doubts, []) == list(doubts)


def test_an_error_that_the_second_engine_does_not_see_is_a_warning_with_what_that_measured() -> None:
    curve = Curve("arm", "j", "position", (0.0, 1.0), (0.0, 0.2), (0.0, 0.19))
    [doubt] = decided(result(LATE), result()._replace(curves=(curve,)), BOTH).troubles
    assert (doubt.code, doubt.controller) == ("UC963", "arm")
    assert doubt.message.startswith("pybullet and mujoco disagree; only pybullet reports: controller 'arm'")
    assert doubt.notes == ("mujoco: position of 'j' ended at 0.19 of 0.2 rad",)
    assert decided(result(LATE), result(), BOTH).moved == ("arm",)


def test_an_error_that_only_the_second_engine_sees_is_a_warning() -> None:
    assert sorted(codes(decided(result(), result(LATE, FAST), BOTH))) == ["UC937", "UC963"]


def test_an_error_that_both_engines_see_stays() -> None:
    assert codes(decided(result(LATE), result(LATE), BOTH)) == ["UC932"]


def test_a_controller_that_the_first_engine_cannot_judge_is_judged_by_the_second() -> None:
    assert codes(decided(result(moved=(), left=("arm",)), result(LATE), BOTH)) == ["UC932"]


def test_compared_engines_that_disagree_give_a_warning_that_names_both() -> None:
    (_, first), (_, second) = compared([("pybullet", result(LATE)), ("mujoco", result())])
    assert (codes(first), codes(second)) == (["UC963"], [])
    assert first.troubles[0].message.startswith("pybullet and mujoco disagree; only pybullet reports: controller 'arm'")


def test_compared_engines_that_agree_keep_their_errors() -> None:
    (_, first), (_, second) = compared([("pybullet", result(LATE)), ("mujoco", result(LATE))])
    assert (codes(first), codes(second)) == (["UC932"], ["UC932"])


def test_an_engine_that_could_not_judge_a_controller_does_not_disagree() -> None:
    (_, first), _ = compared([("mujoco", result(LATE)), ("pybullet", result(moved=(), left=("arm",)))])
    assert codes(first) == ["UC932"]


def test_a_controller_that_one_engine_moved_is_not_unjudged() -> None:
    first, second = SimulationResult(moved=("a",)), SimulationResult(unjudged={"a": "too slow", "b": "no range"})
    assert decided(first, second, BOTH).unjudged == {"b": "no range"}
    assert decided(first._replace(times={"a": 0.5}), second._replace(times={"a": 0.25, "b": 1.0}), BOTH).times == {
        "a": 0.75,
        "b": 1.0,
    }
