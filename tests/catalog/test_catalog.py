"""The catalogue knows types of controllers, hardware and simulator plugins by distro."""

from __future__ import annotations

import pytest

from urdfctl.catalog.additions import NO_ADDITIONS, Additions
from urdfctl.catalog.catalog import CATALOG, catalog_with
from urdfctl.catalog.distros import ALL, ROS1, ROS2, applies_to, spanned
from urdfctl.catalog.entries import ParameterEntry, Replacement
from urdfctl.catalog.map_parameters import expanded, expected, matching
from urdfctl.model.project import Project

TRAJECTORY = "joint_trajectory_controller/JointTrajectoryController"
GROUP = "position_controllers/JointGroupPositionController"


@pytest.mark.parametrize(
    ("span", "distros"),
    [
        ("humble..", ("humble", "iron", "jazzy", "kilted", "lyrical", "rolling")),
        ("..galactic", ("foxy", "galactic")),
        ("humble..jazzy", ("humble", "iron", "jazzy")),
        ("foxy, iron", ("foxy", "iron")),
        ("noetic, rolling..", ("rolling",)),
        ("..", ROS2),
    ],
)
def test_a_span_names_distros_of_a_generation(span: str, distros: tuple[str, ...]) -> None:
    assert spanned(span, 2) == distros


def test_a_span_names_nothing_but_distros() -> None:
    with pytest.raises(ValueError, match="humbel"):
        spanned("humbel..", 2)


def test_a_controller_is_known_in_its_distros_only() -> None:
    assert CATALOG.controller(GROUP, "jazzy") is not None
    assert CATALOG.controller(GROUP, "rolling") is None
    assert CATALOG.controller("my_controllers/Mine", "jazzy") is None
    assert CATALOG.distros_of(GROUP) == (*ROS1[1:], *ROS2[:6])
    assert CATALOG.distros_of("my_controllers/Mine") == ()


def test_every_known_type_is_found() -> None:
    for distro in ALL:
        for name in CATALOG.known_types(distro):
            controller = CATALOG.controller(name, distro)
            assert controller is not None
            assert controller.type == name
            assert distro in CATALOG.distros_of(name)


def test_what_a_type_was_replaced_by_is_told_where_it_is_to_be_had() -> None:
    assert CATALOG.replacement(GROUP, "rolling") == Replacement(
        "forward_command_controller/ForwardCommandController", {"interface_name": "position"}
    )
    assert CATALOG.replacement("joint_state_controller/JointStateController", "jazzy") == Replacement(
        "joint_state_broadcaster/JointStateBroadcaster"
    )
    assert CATALOG.replacement("effort_controllers/JointTrajectoryController", "humble") == Replacement(
        TRAJECTORY, {"command_interfaces": ["effort"], "state_interfaces": ["position", "velocity"]}
    )
    assert CATALOG.replacement(TRAJECTORY, "noetic") == Replacement("position_controllers/JointTrajectoryController")
    assert CATALOG.replacement(TRAJECTORY, "jazzy") is None
    assert CATALOG.replacement("my_controllers/Mine", "jazzy") is None


def parameters(name: str, distro: str) -> dict[str, ParameterEntry]:
    controller = CATALOG.controller(name, distro)
    assert controller is not None
    return dict(controller.parameters)


def test_parameters_are_those_of_the_distro() -> None:
    assert "open_loop_control" in parameters(TRAJECTORY, "jazzy")
    assert "open_loop_control" not in parameters(TRAJECTORY, "kilted")
    assert parameters(TRAJECTORY, "jazzy")["open_loop_control"].deprecated
    assert not parameters(TRAJECTORY, "humble")["open_loop_control"].deprecated
    assert parameters(TRAJECTORY, "humble")["allow_nonzero_velocity_at_trajectory_end"].default is True
    assert parameters(TRAJECTORY, "jazzy")["allow_nonzero_velocity_at_trajectory_end"].default is False
    assert parameters(TRAJECTORY, "jazzy")["cmd_timeout"].since is None
    assert parameters(TRAJECTORY, "humble")["cmd_timeout"].since == "2.30.0"


def test_a_parameter_is_needed_where_its_default_breaks_its_own_validators() -> None:
    assert not parameters(TRAJECTORY, "humble")["joints"].needed
    assert parameters(TRAJECTORY, "jazzy")["joints"].needed
    assert not parameters(TRAJECTORY, "jazzy")["joints"].required
    assert parameters("forward_command_controller/ForwardCommandController", "rolling")["joints"].required


def test_parameters_that_others_read_are_told_with_what_took_their_place() -> None:
    controller = CATALOG.controller(TRAJECTORY, "kilted")
    assert controller is not None
    former = controller.former["open_loop_control"]
    assert former.distros == ("foxy", "galactic", "humble", "iron", "jazzy")
    assert former.replacement == "interpolate_from_desired_state"
    assert former.last_version is None
    assert controller.former["gains.<joints>.i_clamp"].last_version == "5.6.1"
    assert "joints" not in controller.former


def test_a_type_that_extends_another_has_its_parameters_and_claims_too() -> None:
    controller = CATALOG.controller("ur_controllers/ScaledJointTrajectoryController", "humble")
    assert controller is not None
    assert controller.claims is not None
    assert {"joints", "speed_scaling_interface_name"} <= set(controller.parameters)
    assert [rule.for_each or rule.names_from for rule in controller.claims.state] == [
        "joints",
        "speed_scaling_interface_name",
    ]


def test_groups_of_parameters_stand_below_their_prefix() -> None:
    ros1 = parameters("effort_controllers/JointTrajectoryController", "noetic")
    assert ros1["gains.<joints>.p"] == ParameterEntry("gains.<joints>.p", "double", if_absent="crash")
    assert ros1["gains.<joints>.i_clamp"].default == 0.0
    assert ros1["constraints.<joints>.goal"].default == 0.0
    assert parameters("effort_controllers/JointPositionController", "noetic")["pid.p"].required


def test_a_map_parameter_stands_for_one_for_each_element() -> None:
    assert expanded("gains.<joints>.p", {"joints": ["a", "b", "$(var c)", 1]}) == ("gains.a.p", "gains.b.p")
    assert expanded("gains.<joint>.p", {"joint": "a"}) == ("gains.a.p",)
    assert expanded("gains.<joints>.p", {}) == ()
    named = expected(parameters(TRAJECTORY, "jazzy"), {"joints": ["elbow"]})
    assert named["gains.elbow.p"].name == "gains.<joints>.p"
    assert "gains.<joints>.p" not in named
    assert named["joints"].type == "string_array"


@pytest.mark.parametrize(
    ("name", "found"),
    [
        ("joints", ("joints", None)),
        ("gains.elbow.p", ("gains.<joints>.p", "elbow")),
        ("gains.arm.elbow.p", ("gains.<joints>.p", "arm.elbow")),
        ("gains.elbow.pp", None),
        ("jonts", None),
    ],
)
def test_the_parameter_that_a_name_is_of_is_found(name: str, found: tuple[str, str | None] | None) -> None:
    assert matching(name, parameters(TRAJECTORY, "jazzy")) == found


def test_all_that_stands_below_a_parameter_of_free_form_is_of_it() -> None:
    chain = parameters("chained_filter_controller/ChainedFilter", "jazzy")
    assert matching("filter_chain.filter1.type", chain) == ("filter_chain", None)
    assert matching("j/position.filter_chain.filter1.type", chain) == ("<input_interfaces>.filter_chain", "j/position")


def test_hardware_is_known_with_the_interfaces_that_it_allows() -> None:
    gazebo = CATALOG.hardware("gz_ros2_control/GazeboSimSystem", "jazzy")
    assert gazebo is not None
    assert gazebo.command_interfaces == ("position", "velocity", "effort")
    assert gazebo.simulator == "gz"
    assert gazebo.host == "gz"
    assert CATALOG.hardware("gz_ros2_control/GazeboSimSystem", "galactic") is None
    renamed = CATALOG.hardware("ign_ros2_control/IgnitionSystem", "humble")
    assert renamed is not None
    assert renamed.deprecated
    assert CATALOG.hardware("ign_ros2_control/IgnitionSystem", "kilted") is None
    classic = CATALOG.hardware("gazebo_ros2_control/GazeboSystem", "galactic")
    assert classic is not None
    assert classic.command_interfaces == ("position", "velocity", "effort")
    mock = CATALOG.hardware("mock_components/GenericSystem", "jazzy")
    assert mock is not None
    assert mock.command_interfaces is None
    assert CATALOG.hardware_replacement("fake_components/GenericSystem", "jazzy") == "mock_components/GenericSystem"
    assert CATALOG.hardware("my_driver/Mine", "jazzy") is None
    for distro in ALL:
        for name in CATALOG.known_hardware(distro):
            assert CATALOG.hardware(name, distro) is not None


def test_simulator_plugins_are_known_with_the_children_that_they_read() -> None:
    [control] = [plugin for plugin in CATALOG.simulator_plugins("kilted") if plugin.hosts_control]
    assert control.filenames == ("gz_ros2_control-system", "libgz_ros2_control-system.so")
    assert control.children["parameters"].required
    assert "hold_joints" in control.children
    assert "robot_param" not in control.children
    classic = {plugin.id: plugin for plugin in CATALOG.simulator_plugins("noetic")}
    assert classic["gazebo_ros_diff_drive"].children["leftJoint"].names == "joint"
    assert classic["gazebo_ros_control"].hosts_control


def test_a_simulator_plugin_is_found_by_its_library_however_that_is_written() -> None:
    for filename in ("gz-sim-diff-drive-system", "libgz-sim-diff-drive-system.so", "ignition-gazebo-diff-drive-system"):
        plugin = CATALOG.simulator_plugin(filename, "jazzy")
        assert plugin is not None
        assert plugin.names == ("gz::sim::systems::DiffDrive",)
        assert plugin.old_names == ("ignition::gazebo::systems::DiffDrive",)
    assert CATALOG.simulator_plugin("libgazebo_ros2_control.so", "jazzy") is None
    assert CATALOG.distros_of_library("libgazebo_ros2_control.so") == ("foxy", "galactic", "humble", "iron")
    assert CATALOG.distros_of_library("libmine.so") == ()


def test_transmissions_are_known_with_their_ends_and_roles() -> None:
    for distro in ("noetic", "jazzy"):
        differential = CATALOG.transmission("transmission_interface/DifferentialTransmission", distro)
        assert differential is not None
        assert (differential.joints, differential.actuators) == (2, 2)
        assert differential.joint_roles == ("joint1", "joint2")
    assert CATALOG.transmission("transmission_interface/SimpleTransmission", "foxy") is None
    pr2 = CATALOG.transmission("pr2_mechanism_model/SimpleTransmission", "indigo")
    assert pr2 is not None
    assert pr2.legacy
    assert "transmission_interface/SimpleTransmission" in CATALOG.known_transmissions("humble")


def test_what_the_controller_manager_reads_is_known() -> None:
    assert CATALOG.manager_parameters("jazzy")["update_rate"].validators == {"gt": 0}
    assert CATALOG.manager_parameters("humble")["update_rate"].validators == {"nonzero": True}
    assert CATALOG.controller_keys("jazzy")["type"].required
    assert "is_async" in CATALOG.common_parameters("jazzy")
    assert CATALOG.manager_parameters("noetic") == {}
    assert CATALOG.filters("jazzy")["control_filters/ExponentialFilterDouble"]["alpha"].required
    assert "torque" in CATALOG.standard_interfaces("jazzy")
    assert "torque" not in CATALOG.standard_interfaces("humble")
    assert CATALOG.sensor_interfaces("jazzy")["range"] == ("range",)


def test_the_users_entries_go_over_the_catalogues() -> None:
    mine = {"type": "my_controllers/Mine", "extends": TRAJECTORY, "parameters": {"speed": {"type": "double"}}}
    theirs = {"type": TRAJECTORY, "parameters": {}}
    ours = CATALOG.extended(Additions((mine,), ({"type": "my_driver/Mine", "command_interfaces": ["effort"]},)))
    controller = ours.controller("my_controllers/Mine", "jazzy")
    assert controller is not None
    assert {"speed", "joints"} <= set(controller.parameters)
    assert controller.package == "joint_trajectory_controller"
    assert "my_controllers/Mine" in ours.known_types("jazzy")
    assert CATALOG.controller("my_controllers/Mine", "jazzy") is None
    driver = ours.hardware("my_driver/Mine", "jazzy")
    assert driver is not None
    assert driver.command_interfaces == ("effort",)
    replaced = ours.extended(Additions((theirs,))).controller(TRAJECTORY, "jazzy")
    assert replaced is not None
    assert replaced.parameters == {}


def test_an_entry_may_extend_the_catalogues_own_of_the_same_type() -> None:
    more = {"type": TRAJECTORY, "extends": TRAJECTORY, "parameters": {"patched": {"type": "bool"}}}
    patched = CATALOG.extended(Additions((more,))).controller(TRAJECTORY, "jazzy")
    assert patched is not None
    assert {"patched", "joints"} <= set(patched.parameters)


def test_entries_that_extend_each_other_are_none() -> None:
    circle = ({"type": "a/A", "extends": "b/B"}, {"type": "b/B", "extends": "a/A"})
    assert CATALOG.extended(Additions(circle)).distros_of("a/A") == ()


def test_a_project_has_the_catalogue_with_the_users_entries() -> None:
    additions = Additions(({"type": "my_controllers/Mine"},))
    assert Project(None).catalog is CATALOG
    assert Project(None, additions=additions).catalog.controller("my_controllers/Mine", "jazzy") is not None
    assert catalog_with(additions) is catalog_with(additions)
    assert catalog_with(NO_ADDITIONS).controller("my_controllers/Mine", "jazzy") is None


@pytest.mark.parametrize(
    ("distros", "note"),
    [
        (("kilted", "lyrical", "rolling"), "applies to kilted and later"),
        (("foxy", "galactic", "humble", "iron"), "applies from foxy to iron"),
        (("foxy", "galactic"), "applies to foxy, galactic"),
        (ROS1, "applies to ROS 1"),
        ((*ROS1, "foxy"), "applies to ROS 1, foxy"),
        (("kinetic", "humble", "iron", "jazzy"), "applies to kinetic, humble to jazzy"),
        (ALL, "applies to all distros"),
    ],
)
def test_a_note_names_the_distros_of_a_finding(distros: tuple[str, ...], note: str) -> None:
    assert applies_to(distros) == note
