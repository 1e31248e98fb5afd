"""The task of a controller as read from its parameters: joints, gains and wheels, also through other controllers."""

from __future__ import annotations

import math

import pytest
from control_session import POSITION, STATES, VELOCITY, component, joint, session

from urdfctl.smoke.tasks.controller_tasks import drive_of, gains_of, limit_of, loop_of, tasks_of
from urdfctl.smoke.tasks.task import FREE, ControllerTask, MotionFamily, PidGains

EFFORT = '<command_interface name="effort"/>'
HARDWARE = component("".join(joint(name, POSITION + VELOCITY + EFFORT + STATES) for name in ("shoulder", "elbow")))
FORWARD = "forward_command_controller/ForwardCommandController"
PID = "pid_controller/PidController"
TRAJECTORY = "joint_trajectory_controller/JointTrajectoryController"

_LOW = (PidGains(p=10.0, d=1.0, prefix="gains.shoulder."), PidGains(p=11.0, d=1.0, prefix="gains.elbow."))


def tasks(**controllers: tuple[str, str]) -> dict[str, ControllerTask]:
    """Return the tasks of controllers with some types and parameters, by name."""
    declared = "".join(f"    {name}: {{type: {kind}}}\n" for name, (kind, _) in controllers.items())
    sections = "".join(f"{name}:\n  ros__parameters: {{{given}}}\n" for name, (_, given) in controllers.items())
    made = session(HARDWARE, f"controller_manager:\n  ros__parameters:\n{declared}{sections}")
    return {task.controller: task for task in tasks_of(made.controllers)}


def loop(joints: str, held: str = "position", command: str = "effort") -> tuple[str, str]:
    gains = ", ".join(f"{name}: {{p: {10 + n}.0, d: 1.0}}" for n, name in enumerate(joints.split(", ")))
    interfaces = f"command_interface: {command}, reference_and_state_interfaces: [{held}]"
    return PID, f"dof_names: [{joints}], {interfaces}, gains: {{{gains}}}"


def test_a_controller_that_forwards_moves_the_joints_that_it_claims() -> None:
    made = tasks(arm=(FORWARD, "joints: [elbow, shoulder], interface_name: velocity"))["arm"]
    assert (made.family, made.joints, made.interface) == (MotionFamily.FORWARD, ("elbow", "shoulder"), "velocity")
    assert (made.through, made.left_out) == ((), ())


@pytest.mark.parametrize(
    ("held", "family"), [("position", MotionFamily.POSITION_PID), ("velocity", MotionFamily.VELOCITY_PID)]
)
def test_a_pid_controller_holds_what_it_is_given(held: str, family: MotionFamily) -> None:
    made = tasks(low=loop("elbow", held))["low"]
    assert (made.family, made.interface, made.gains) == (
        family,
        "effort",
        (PidGains(p=10.0, d=1.0, prefix="gains.elbow."),),
    )


# -- chains ----------------------------------------------------------------------------------------------------------


def test_a_trajectory_through_loops_moves_their_joints_with_their_gains() -> None:
    high = "joints: [shoulder, elbow], command_joints: [low/shoulder, low/elbow], command_interfaces: [position]"
    made = tasks(low=loop("shoulder, elbow"), high=(TRAJECTORY, f"{high}, state_interfaces: [position, velocity]"))
    task = made["high"]
    assert (task.family, task.joints, task.interface) == (MotionFamily.TRAJECTORY, ("shoulder", "elbow"), "effort")
    assert (task.through, task.gains) == (("low",), _LOW)


@pytest.mark.parametrize(
    ("held", "family"), [("position", MotionFamily.POSITION_PID), ("velocity", MotionFamily.VELOCITY_PID)]
)
def test_a_command_that_is_forwarded_to_a_loop_is_held_by_it(held: str, family: MotionFamily) -> None:
    made = tasks(low=loop("shoulder, elbow", held), high=(FORWARD, f"joints: [low/elbow], interface_name: {held}"))[
        "high"
    ]
    assert (made.family, made.joints, made.interface) == (family, ("elbow",), "effort")
    assert (made.gains, made.through) == (_LOW[1:], ("low",))


def test_a_loop_around_a_loop_is_not_simulated() -> None:
    high = loop("low/elbow", command="position")
    assert tasks(low=loop("elbow"), high=high)["high"].why == "it closes a control loop around another one"


def test_an_interface_that_the_other_controller_does_not_offer_leads_nowhere() -> None:
    made = tasks(low=loop("elbow"), high=(FORWARD, "joints: [low/shoulder], interface_name: position"))
    assert made["high"].why == "it commands other controllers or devices, not joints"


def test_a_controller_that_follows_trajectories_is_not_followed_further() -> None:
    low = "joints: [elbow], command_interfaces: [position], state_interfaces: [position]"
    made = tasks(low=(TRAJECTORY, low), high=(FORWARD, "joints: [low/elbow], interface_name: position"))
    assert made["high"].family is MotionFamily.STRUCTURAL


def test_joints_that_are_commanded_in_different_ways_are_not_simulated_together() -> None:
    high = "joints: [low/shoulder, elbow], interface_name: position"
    assert tasks(low=loop("shoulder"), high=(FORWARD, high))["high"].why == "it commands joints in different ways"


MINE = "what it moves is unknown: describe controllers of type 'my_controllers/Mine' in urdfctl.toml, [[controllers]]"


@pytest.mark.parametrize(
    ("controllers", "why"),
    [
        (
            {"arm": ("my_controllers/Mine", "joints: [elbow]")},
            MINE,
        ),
        ({"arm": (FORWARD, "joints: [], interface_name: position")}, "it claims no joint"),
    ],
)
def test_why_a_controller_is_not_simulated(controllers: dict[str, tuple[str, str]], why: str) -> None:
    made = tasks(**controllers)["arm"]
    assert (made.family, made.why) == (MotionFamily.STRUCTURAL, why)


def test_a_broadcaster_moves_nothing() -> None:
    assert tasks(states=("joint_state_broadcaster/JointStateBroadcaster", ""))["states"].family is MotionFamily.NOTHING


# -- loops and gains -------------------------------------------------------------------------------------------------


@pytest.mark.parametrize(
    ("type_name", "interface", "family"),
    [
        ("effort_controllers/JointPositionController", "effort", MotionFamily.POSITION_PID),
        ("velocity_controllers/JointPositionController", "velocity", MotionFamily.POSITION_PID),
        ("position_controllers/JointPositionController", "position", MotionFamily.FORWARD),
        ("effort_controllers/JointVelocityController", "effort", MotionFamily.VELOCITY_PID),
        ("velocity_controllers/JointVelocityController", "velocity", MotionFamily.FORWARD),
        ("effort_controllers/JointEffortController", "effort", MotionFamily.FORWARD),
        ("forward_command_controller/ForwardPositionController", "effort", MotionFamily.FORWARD),
    ],
)
def test_a_controller_of_positions_that_commands_something_else_closes_a_loop(
    type_name: str, interface: str, family: MotionFamily
) -> None:
    assert loop_of(MotionFamily.FORWARD, type_name.rpartition("/")[2], type_name, interface, {}) is family
    assert (
        loop_of(MotionFamily.TRAJECTORY, type_name.rpartition("/")[2], type_name, interface, {})
        is MotionFamily.TRAJECTORY
    )


@pytest.mark.parametrize("place", ["gains.j.", "j.pid.", "pid.", "gains.", ""])
def test_gains_are_read_from_wherever_controllers_read_them(place: str) -> None:
    given = {f"{place}p": 1.0, f"{place}i": 2, f"{place}d": 0.5, f"{place}i_clamp": -3.0}
    assert gains_of(given, "j") == PidGains(1.0, 2.0, 0.5, 3.0, prefix=place)
    assert gains_of({f"{place}d": 0.5}, "j") == PidGains(0.0, 0.0, 0.5, prefix=place)


def test_the_gains_of_the_joint_come_before_common_ones() -> None:
    assert gains_of({"gains.j.p": 1.0, "pid.p": 2.0, "p": 3.0}, "j").p == 1.0
    assert gains_of({"gains.other.p": 1.0, "p": 3.0}, "j").p == 3.0
    assert gains_of({"gains.j.p": "high", "gains.j.i": True}, "j") == PidGains(prefix="gains.j.")


@pytest.mark.parametrize(
    ("given", "feed"),
    [
        ({"gains.j.ff_velocity_scale": 0.5}, 0.5),
        ({"gains.j.feedforward_gain": 0.6}, 0.6),
        ({"velocity_ff.j": 0.7}, 0.7),
        ({"gains.j.ff_velocity_scale": 0.0, "velocity_ff.j": 0.7}, 0.7),
        ({}, 0.0),
    ],
)
def test_a_part_of_the_velocity_is_fed_forward(given: dict[str, float], feed: float) -> None:
    assert gains_of(given, "j").feed == feed
    assert gains_of({**given, "gains.j.p": 1.0}, "j").feed == feed


# -- wheels ----------------------------------------------------------------------------------------------------------


@pytest.mark.parametrize(
    ("given", "limit"),
    [
        ({"linear.x.max_velocity": 0.5}, 0.5),
        ({"linear.x.max_velocity": -0.5}, 0.5),
        ({"linear.x.max_velocity": 0.5, "linear.x.has_velocity_limits": True}, 0.5),
        ({"linear.x.max_velocity": 0.5, "linear.x.has_velocity_limits": False}, FREE),
        ({"linear.x.max_velocity": 0.0}, FREE),
        ({"linear.x.max_velocity": math.nan}, FREE),
        ({"linear.x.max_velocity": math.inf}, FREE),
        ({}, FREE),
    ],
)
def test_the_limit_of_a_controller_on_its_own_command(given: dict[str, object], limit: float) -> None:
    assert limit_of(given, "linear.x", "velocity") == limit


def test_the_measures_of_two_sides_are_read_with_their_multipliers() -> None:
    given = {
        "left_wheel_names": ["l"],
        "right_wheel_names": ["r"],
        "wheel_radius": 0.1,
        "wheel_separation": 0.4,
        "wheel_separation_multiplier": 1.5,
        "left_wheel_radius_multiplier": 1.1,
        "wheel_radius_multiplier": 0.9,
    }
    made = drive_of(MotionFamily.DIFFERENTIAL, given)
    assert (made.left, made.right) == (("l",), ("r",))
    assert (made.separation, made.radius_of("l"), made.radius_of("r")) == pytest.approx((0.6, 0.11, 0.09))
    assert drive_of(MotionFamily.DIFFERENTIAL, {"wheel_separation": 0.4}).separation == 0.4


@pytest.mark.parametrize(
    ("front", "driven", "steered", "radius"), [(True, "back", "ahead", 0.2), (False, "ahead", "back", 0.1)]
)
def test_the_older_names_of_steered_bases_depend_on_which_wheels_steer(
    front: bool, driven: str, steered: str, radius: float
) -> None:
    given = {
        "front_steering": front,
        "rear_wheels_names": ["back"],
        "front_wheels_names": ["ahead"],
        "rear_wheels_radius": 0.2,
        "front_wheels_radius": 0.1,
        "rear_wheel_track": 0.5,
        "front_wheel_track": 0.4,
        "wheelbase": 1.0,
    }
    made = drive_of(MotionFamily.STEERED, given)
    assert (made.driven, made.steered, made.radius, made.wheelbase) == ((driven,), (steered,), radius, 1.0)
    assert (made.track, made.steering_track) == ((0.5, 0.4) if front else (0.4, 0.5))
