"""How far controllers get, and what stops them: interfaces, chains and conflicts."""

from __future__ import annotations

import pytest
from control_session import ARM, POSITION, STATES, VELOCITY, component, joint, session, transmission, ways

from urdfctl.control.chains import chained_claims
from urdfctl.control.lifecycle import lives
from urdfctl.model.stage import Stage

MANAGER = "controller_manager:\n  ros__parameters: {{{}}}\n"
TRAJECTORY = "joint_trajectory_controller/JointTrajectoryController"
FORWARD = "forward_command_controller/ForwardCommandController"
PID = "pid_controller/PidController"


def yaml(**controllers: tuple[str, str]) -> str:
    """Controllers by name: their type and their parameters."""
    declared = ", ".join(f"{name}: {{type: {kind}}}" for name, (kind, _) in controllers.items())
    sections = "".join(f"{name}:\n  ros__parameters: {{{given}}}\n" for name, (_, given) in controllers.items())
    return MANAGER.format(declared) + sections


def forward(joints: str, interface: str = "position") -> tuple[str, str]:
    return FORWARD, f"joints: [{joints}], interface_name: {interface}"


GAINS = "gains: {elbow: {p: 1.0}}"
ELBOW_PID = (
    PID,
    f"dof_names: [elbow], command_interface: position, reference_and_state_interfaces: [velocity], {GAINS}",
)


def test_a_controller_whose_interfaces_are_offered_gets_to_the_end() -> None:
    made = session(ARM, yaml(arm=forward("shoulder, elbow")))
    assert ways(made) == {"arm": []}
    assert [life.reached for life in lives(made)] == [Stage.ACTIVATE]


def test_an_interface_that_is_not_offered_stops_it_when_it_is_activated() -> None:
    made = session(ARM, yaml(arm=forward("elbow", "effort")))
    assert ways(made) == {"arm": ["activate NOT_OFFERED elbow/effort"]}
    assert [life.reached for life in lives(made)] == [Stage.CONFIGURE]


def test_what_a_driver_may_offer_stops_nothing_for_sure() -> None:
    made = session(component(joint("elbow"), plugin="acme/Driver"), yaml(arm=forward("elbow", "effort")))
    assert ways(made) == {"arm": ["activate NOT_OFFERED elbow/effort"]}
    assert [life.reached for life in lives(made)] == [Stage.ACTIVATE]


def test_parameters_that_do_not_fit_together_stop_it_when_it_is_configured() -> None:
    both = component(joint("elbow", VELOCITY + STATES))
    made = session(
        both, yaml(arm=(TRAJECTORY, "joints: [elbow], command_interfaces: [velocity], state_interfaces: [position]"))
    )
    assert ways(made) == {"arm": ["configure PARAMETERS"]}


def test_a_type_that_is_missing_or_unknown_stops_it_when_it_is_loaded() -> None:
    made = session(ARM, yaml(arm=("acme/Controller", "joints: [elbow]")), started=("arm", "other"))
    assert ways(made) == {"arm": ["load TYPE_UNKNOWN"], "other": ["load TYPE_MISSING"]}
    assert [life.reached for life in lives(made)] == [None, None]


def test_values_that_are_not_known_or_of_a_wrong_type_claim_nothing() -> None:
    assert ways(session(ARM, yaml(arm=forward("$(var x)")))) == {"arm": []}
    made = session(ARM, yaml(arm=(FORWARD, "joints: '[elbow]', interface_name: position")))
    assert made.controllers[0].claims.command == ()
    assert not made.controllers[0].claims.complete


# -- conflicts -------------------------------------------------------------------------------------------------------


def test_two_started_controllers_cannot_have_one_command_interface() -> None:
    both = yaml(one=forward("elbow"), two=forward("elbow, shoulder"))
    made = session(ARM, both, started=("two", "one"))
    assert ways(made) == {"two": [], "one": ["activate CONFLICT elbow/position"]}


@pytest.mark.parametrize("started", [None, ("one",)])
def test_controllers_that_are_not_started_take_nothing_away(started: tuple[str, ...] | None) -> None:
    made = session(ARM, yaml(one=forward("elbow"), two=forward("elbow")), started=started)
    assert not any(ways(made).values())


def test_in_ros_2_other_interfaces_of_a_joint_are_free_and_in_ros_1_they_are_not() -> None:
    two = component(joint("elbow", POSITION + VELOCITY + STATES))
    made = session(two, yaml(one=forward("elbow"), two=forward("elbow", "velocity")), started=("one", "two"))
    assert not any(ways(made).values())
    old = """
        one: {type: position_controllers/JointPositionController, joint: elbow}
        two: {type: effort_controllers/JointEffortController, joint: elbow}
    """
    parts = transmission("elbow") + transmission("elbow", "EffortJointInterface")
    assert ways(session(parts, old, "noetic", ("one", "two"))) == {
        "one": [],
        "two": ["activate CONFLICT elbow/hardware_interface/EffortJointInterface"],
    }


def test_managers_of_different_namespaces_share_nothing() -> None:
    robots = "".join(
        f"{name}:\n  one: {{type: position_controllers/JointPositionController, joint: elbow}}\n" for name in ("a", "b")
    )
    made = session(transmission("elbow"), robots, "noetic", ("/a/one", "/b/one"))
    assert [life.stops for life in lives(made)] == [(), ()]


@pytest.mark.parametrize(("distro", "stage"), [("humble", "configure"), ("jazzy", "configure")])
def test_a_controller_cannot_claim_an_interface_twice(distro: str, stage: str) -> None:
    made = session(ARM, yaml(arm=forward("elbow, elbow")), distro)
    assert ways(made) == {"arm": [f"{stage} CLAIMED_TWICE elbow/position"]}


def test_in_ros_1_a_joint_may_be_named_twice_in_one_interface() -> None:
    arm = "arm: {type: position_controllers/JointGroupPositionController, joints: [elbow, elbow]}"
    assert ways(session(transmission("elbow"), arm, "noetic", ("arm",))) == {"arm": []}


# -- chains ----------------------------------------------------------------------------------------------------------


def chain(preceding: str, **more: tuple[str, str]) -> str:
    return yaml(pid=ELBOW_PID, arm=forward(preceding, "velocity"), **more)


def test_a_controller_may_claim_what_another_one_exports() -> None:
    made = session(ARM, chain("pid/elbow"), started=("pid", "arm"))
    assert ways(made) == {"pid": [], "arm": []}
    [link] = chained_claims(made, made.controllers[1])
    assert (link.following.name, link.is_offered) == ("pid", True)


def test_what_the_other_one_does_not_export_is_missing() -> None:
    assert ways(session(ARM, chain("pid/shoulder")))["arm"] == ["activate NOT_EXPORTED pid/shoulder/velocity"]
    plain = yaml(low=forward("elbow"), arm=forward("low/elbow"))
    assert ways(session(ARM, plain))["arm"] == ["activate NOT_CHAINABLE low/elbow/position"]


def test_a_controller_of_an_unknown_type_may_export_anything() -> None:
    unknown = yaml(low=("acme/Controller", "x: 1"), arm=forward("low/elbow"))
    assert ways(session(ARM, unknown))["arm"] == []


def test_the_other_one_must_be_started_first() -> None:
    late = ["activate NOT_STARTED pid/elbow/velocity"]
    assert ways(session(ARM, chain("pid/elbow"), started=("arm", "pid"), in_order=True))["arm"] == late
    assert ways(session(ARM, chain("pid/elbow"), started=("arm", "pid")))["arm"] == []
    assert ways(session(ARM, chain("pid/elbow"), started=("arm",)))["arm"] == late
    assert ways(session(ARM, chain("pid/elbow")))["arm"] == []


def test_two_cannot_claim_one_reference() -> None:
    made = session(ARM, chain("pid/elbow", hand=forward("pid/elbow", "velocity")), started=("pid", "arm", "hand"))
    assert ways(made)["hand"] == ["activate CONFLICT pid/elbow/velocity"]


def test_controllers_that_claim_each_other_never_start() -> None:
    given = "command_interface: velocity, reference_and_state_interfaces: [velocity]"
    one = (PID, f"dof_names: [two/elbow], {given}, reference_and_state_dof_names: [elbow], {GAINS}")
    two = (one[0], one[1].replace("two/elbow", "one/elbow"))
    assert ways(session(ARM, yaml(one=one, two=two))) == {"one": ["activate CIRCLE"], "two": ["activate CIRCLE"]}


def test_a_controller_named_like_a_joint_hides_it() -> None:
    made = session(ARM, yaml(elbow=forward("elbow")), started=("elbow",))
    assert "activate NOT_CHAINABLE elbow/position" in ways(made)["elbow"]


def test_galactic_knows_no_chains() -> None:
    old = component(joint("elbow"), plugin="fake_components/GenericSystem")
    chained = yaml(low=forward("elbow"), arm=forward("low/elbow"))
    assert ways(session(old, chained, "galactic"))["arm"] == ["activate NOT_OFFERED low/elbow/position"]
