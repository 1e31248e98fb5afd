"""Claims and exports of controllers by the rules of their catalogue entries."""

from __future__ import annotations

from urdfctl.catalog.catalog import CATALOG
from urdfctl.control.claims import Claim, ClaimFacts, Claims, ExportedInterfaces, claims, exports

ROBOT = ClaimFacts(
    movable_joints=("shoulder", "elbow"),
    state_interfaces=(("shoulder", "position"), ("elbow", "position"), ("imu", "orientation.x"), ("io", "in1")),
)


def claimed(kind: str, distro: str, values: dict[str, object]) -> Claims:
    controller = CATALOG.controller(kind, distro)
    assert controller is not None
    found = claims(controller, "it", values, ROBOT)
    assert found is not None
    return found


def exported(kind: str, distro: str, values: dict[str, object]) -> ExportedInterfaces:
    controller = CATALOG.controller(kind, distro)
    assert controller is not None
    return exports(controller, "it", values)


def names(found: tuple[Claim, ...]) -> list[str]:
    return [claim.name for claim in found]


TRAJECTORY = "joint_trajectory_controller/JointTrajectoryController"
ARM = {"joints": ["a", "b"], "command_interfaces": ["position"], "state_interfaces": ["position", "velocity"]}


def test_each_joint_is_claimed_with_each_interface_and_tells_where_both_are_named() -> None:
    found = claimed(TRAJECTORY, "jazzy", {**ARM})
    assert found.command == (
        Claim("a", "position", "joints", 0, "command_interfaces", 0),
        Claim("b", "position", "joints", 1, "command_interfaces", 0),
    )
    assert names(found.state) == ["a/position", "a/velocity", "b/position", "b/velocity"]
    assert found.complete


def test_another_list_takes_the_place_of_the_joints_where_it_is_given() -> None:
    found = claimed(TRAJECTORY, "jazzy", {**ARM, "command_joints": ["c"]})
    assert found.command == (Claim("c", "position", "command_joints", 0, "command_interfaces", 0),)
    assert names(claimed(TRAJECTORY, "foxy", {**ARM, "command_joints": ["c"]}).command) == ["a/position", "b/position"]


def test_a_whole_name_is_claimed_only_where_the_distro_reads_it() -> None:
    arm = {**ARM, "speed_scaling.state_interface": "speed_scaling/factor"}
    assert claimed(TRAJECTORY, "jazzy", arm).state[-1] == Claim(
        "speed_scaling", "factor", "speed_scaling.state_interface"
    )
    assert "speed_scaling/factor" not in names(claimed(TRAJECTORY, "humble", arm).state)


def test_what_is_not_known_is_not_claimed() -> None:
    found = claimed(TRAJECTORY, "jazzy", {**ARM, "joints": ["a", "$(var prefix)b"]})
    assert names(found.command) == ["a/position"]
    assert not found.complete


def test_a_joint_named_twice_is_claimed_twice() -> None:
    assert names(claimed(TRAJECTORY, "jazzy", {**ARM, "joints": ["a", "a"]}).command) == ["a/position", "a/position"]


def test_conditions_choose_and_defaults_stand_in() -> None:
    wheels: dict[str, object] = {"left_wheel_names": ["l"], "right_wheel_names": ["r"]}
    drive = "diff_drive_controller/DiffDriveController"
    assert names(claimed(drive, "jazzy", wheels).state) == ["l/position", "r/position"]
    assert names(claimed(drive, "jazzy", {**wheels, "position_feedback": False}).state) == ["l/velocity", "r/velocity"]
    assert claimed(drive, "jazzy", {**wheels, "open_loop": True}).state == ()
    assert names(claimed(drive, "humble", {**wheels, "open_loop": True}).state) == ["l/position", "r/position"]
    assert not claimed(drive, "jazzy", {**wheels, "open_loop": "$(var open)"}).complete


def test_a_broadcaster_of_nothing_in_particular_takes_what_is_there() -> None:
    broadcaster = "joint_state_broadcaster/JointStateBroadcaster"
    assert names(claimed(broadcaster, "jazzy", {}).state) == [
        "shoulder/position",
        "elbow/position",
        "imu/orientation.x",
        "io/in1",
    ]
    of_joints = claimed(broadcaster, "rolling", {"map_interface_to_joint_state.effort": "torque"}).state
    assert names(of_joints)[:4] == [f"shoulder/{name}" for name in ("position", "velocity", "effort", "torque")]
    assert all(claim.best_effort for claim in of_joints)
    chosen: dict[str, object] = {"joints": ["elbow"], "interfaces": ["position"]}
    assert names(claimed(broadcaster, "rolling", chosen).state) == ["elbow/position"]


def test_each_element_may_have_interfaces_of_its_own() -> None:
    io = "gpio_controllers/GpioCommandController"
    given: dict[str, object] = {"gpios": ["io", "out"], "command_interfaces.out.interfaces": ["o1"]}
    found = claimed(io, "jazzy", given)
    assert found.command == (Claim("out", "o1", "gpios", 1, "command_interfaces.out.interfaces", 0),)
    assert names(found.state) == ["io/in1"]
    assert claimed(io, "jazzy", {**given, "state_interfaces.out.interfaces": ["s"]}).state == (
        Claim("out", "s", "gpios", 1, "state_interfaces.out.interfaces", 0),
    )


def test_a_condition_may_be_of_the_element_at_hand() -> None:
    given: dict[str, object] = {"batteries": ["x", "y"], "interfaces.y.battery_current": True}
    found = claimed("battery_state_broadcaster/BatteryStateBroadcaster", "jazzy", given)
    assert names(found.state) == ["x/battery_voltage", "y/battery_voltage", "y/battery_current"]


def test_a_parameter_that_the_distro_does_not_read_claims_nothing() -> None:
    broadcaster = "joint_state_controller/JointStateController"
    joints = ClaimFacts(state_interfaces=(("elbow", "hardware_interface/JointStateInterface"),))
    old, new = CATALOG.controller(broadcaster, "kinetic"), CATALOG.controller(broadcaster, "noetic")
    assert old is not None
    assert new is not None
    read_by_new = {"publish_rate": 50, "joints": ["shoulder"]}
    assert [claims(each, "it", read_by_new, joints) for each in (old, new)] == [
        Claims(state=(Claim("elbow", "hardware_interface/JointStateInterface", best_effort=True),)),
        Claims(state=(Claim("shoulder", "hardware_interface/JointStateInterface", "joints", 0),)),
    ]


def test_names_are_filled_in() -> None:
    found = claimed("ur_controllers/SpeedScalingStateBroadcaster", "humble", {"tf_prefix": "left_"})
    assert found.state == (Claim("left_speed_scaling", "speed_scaling_factor"),)


def test_ros_1_claims_interfaces_of_its_own_kind() -> None:
    position = "hardware_interface/PositionJointInterface"
    trajectory = claimed("position_controllers/JointTrajectoryController", "noetic", {"joints": ["a"]})
    assert trajectory.command == (Claim("a", position, "joints", 0),)
    steering = claimed("ackermann_steering_controller/AckermannSteeringController", "noetic", {})
    assert names(steering.command) == [
        "rear_wheel_joint/hardware_interface/VelocityJointInterface",
        "front_steer_joint/hardware_interface/PositionJointInterface",
    ]
    fingers = claimed("franka_gazebo/FrankaGripperSim", "noetic", {"arm_id": "panda"})
    assert [claim.component for claim in fingers.command] == ["panda_finger_joint1", "panda_finger_joint2"]


def test_a_chainable_controller_exports_what_others_may_claim() -> None:
    drive: dict[str, object] = {"left_wheel_names": ["l"], "right_wheel_names": ["r"]}
    kind = "diff_drive_controller/DiffDriveController"
    assert names(exported(kind, "jazzy", drive).reference) == ["it/linear/velocity", "it/angular/velocity"]
    assert exported(kind, "humble", drive) == ExportedInterfaces()
    pid = exported(
        "pid_controller/PidController",
        "jazzy",
        {"dof_names": ["a"], "command_interface": "effort", "reference_and_state_interfaces": ["position"]},
    )
    assert names(pid.reference) == ["it/a/position"]
    assert names(pid.state) == ["it/a/position"]
    assert pid.reference[0].parameter == "dof_names"


def test_nothing_is_told_of_what_the_catalogue_does_not_know() -> None:
    controller = CATALOG.controller("ur_controllers/GPIOController", "humble")
    assert controller is not None
    assert claims(controller, "it", {}) is None
