"""The rest of a log decides: waits that end well are harmless, and what is likely comes first."""

from __future__ import annotations

import pytest

from urdfctl.logs.digest import Digest, KnownMessage, digest
from urdfctl.logs.evidence import FoundCause, holds, with_findings

DECLARED = (
    "what(): According to the loaded plugin descriptions the class {plugin} with base class type "
    "hardware_interface::SystemInterface does not exist. Declared types are {types}"
)
WAITS = (
    "[{spawner}] [INFO] [1.0] [s]: waiting for service /controller_manager/list_controllers to become available...\n"
)
DONE = "[{spawner}] [INFO] [2.0] [s]: Configured and activated arm_controller\n"


def log(text: str) -> Digest:
    return digest(text.splitlines(), pasted=False)


def first(text: str) -> KnownMessage:
    return digest([text], pasted=True).known[0]


def test_a_wait_that_ends_well_is_harmless_and_says_where_it_ended() -> None:
    found = log(WAITS.format(spawner="spawner-3") + DONE.format(spawner="spawner-3"))
    waits = next(known for known in found.known if known.message.id == "spawner-waits-for-manager")
    assert (waits.kind, waits.settled) == ("harmless", 2)


@pytest.mark.parametrize(
    "text",
    [
        WAITS.format(spawner="spawner-3"),
        DONE.format(spawner="spawner-3") + WAITS.format(spawner="spawner-3"),
        WAITS.format(spawner="spawner-3") + WAITS.format(spawner="spawner-4") + DONE.format(spawner="spawner-3"),
    ],
)
def test_a_wait_that_does_not_end_is_a_consequence(text: str) -> None:
    assert [known.kind for known in log(text).known if known.message.id == "spawner-waits-for-manager"] == [
        "consequence"
    ]


def test_a_spawner_that_reached_the_manager_no_longer_waits_even_if_it_then_fails() -> None:
    failed = "[spawner-3] [FATAL] [2.0] [s]: Failed loading controller arm_controller\n"
    kinds = {known.message.id: known.kind for known in log(WAITS.format(spawner="spawner-3") + failed).known}
    assert kinds == {"spawner-waits-for-manager": "harmless", "spawner-failed": "consequence"}


def test_a_description_that_arrives_late_is_harmless() -> None:
    found = log(
        "[n-1] [WARN] [1.0] [cm]: Waiting for data on 'robot_description' topic to finish initialization\n"
        "[n-1] [INFO] [2.0] [controller_manager]: Received robot description from topic.\n"
    )
    assert [known.kind for known in found.known] == ["harmless"]


def test_a_description_that_one_process_has_settles_the_wait_of_another() -> None:
    waits = "[j-2] [INFO] [1.0] [j]: Waiting for robot_description to be published on the robot_description topic...\n"
    assert [known.kind for known in log(waits).known] == ["consequence"]
    assert [known.kind for known in log("[r-1] [INFO] [0.9] [r]: got segment base\n" + waits).known] == ["harmless"]


def test_processes_that_die_after_ctrl_c_are_not_reported() -> None:
    died = "[ERROR] [rviz2-3]: process has died [pid 7, exit code -6, cmd 'rviz2'].\n"
    assert [known.kind for known in log(died).known] == ["consequence"]
    assert log("[WARNING] [launch]: user interrupted with ctrl-c (SIGINT)\n" + died).known == ()


def test_gazebo_s_wait_for_the_description_is_harmless_if_the_plugin_goes_on() -> None:
    wait = "[ INFO] [1.0]: gazebo_ros_control plugin is waiting for model URDF in parameter [/d] on the ROS param\n"
    assert [known.kind for known in log(wait).known] == ["consequence"]
    assert [known.kind for known in log(wait + "[ INFO] [2.0]: Loaded gazebo_ros_control.\n").known] == ["harmless"]


@pytest.mark.parametrize(
    ("plugin", "types", "cause", "fix"),
    [
        (
            "arm_hardware/ArmSystem",
            "arm_hardware/ArmSystem mock_components/GenericSystem",
            "spaces or a line break",
            "on one line",
        ),
        (
            "arm_hardware/ArmSystm",
            "arm_hardware/ArmSystem",
            "did you mean 'arm_hardware/ArmSystem'",
            "arm_hardware/ArmSystem",
        ),
        (
            "arm_hardware/ArmSystem",
            "mock_components/GenericSystem",
            "not sourced in this terminal",
            "install/setup.bash",
        ),
        (
            "gz_ros2_control/GazeboSimSystem",
            "mock_components/GenericSystem",
            "do not start ros2_control_node",
            "ros2_control_node",
        ),
    ],
)
def test_the_declared_types_tell_what_is_wrong_with_a_plugin(plugin: str, types: str, cause: str, fix: str) -> None:
    reading = first(DECLARED.format(plugin=plugin, types=types)).reading
    assert cause in reading.causes[0].text
    assert fix in reading.best_fix


@pytest.mark.parametrize(
    ("kind", "cause"),
    [
        ("effort_controllers/JointPositionController", "is not installed"),
        ("effort_controllers/JointPositonController", "did you mean 'effort_controllers/JointPositionController'"),
        ("my_controllers/Balance", "not built, or the workspace is not sourced"),
    ],
)
def test_whether_a_type_is_known_tells_a_misspelling_from_a_missing_package(kind: str, cause: str) -> None:
    text = f"Could not load controller 'arm' because controller type '{kind}' does not exist."
    assert cause in first(text).reading.causes[0].text


@pytest.mark.parametrize(
    ("library", "name"),
    [
        ("libign_ros2_control-system.so", "ign_ros2_control::IgnitionROS2ControlPlugin"),
        ("libgz_ros2_control-system.so", "gz_ros2_control::GazeboSimROS2ControlPlugin"),
    ],
)
def test_the_loaded_library_tells_which_class_a_simulator_plugin_has(library: str, name: str) -> None:
    text = (
        f"Failed to load system plugin [x] : could not instantiate from library [{library}] from path [/opt/{library}]."
    )
    assert f'name="{name}"' in first(text).reading.best_fix


@pytest.mark.parametrize(
    ("before", "cause"),
    [
        ("[ INFO] [1.0]: Loaded gazebo_ros_control.\n", "looks in another namespace"),
        ("[FATAL] [1.0]: Could not initialize robot simulation interface\n", "simulated hardware failed to start"),
    ],
)
def test_what_gazebo_printed_tells_why_a_spawner_finds_no_manager(before: str, cause: str) -> None:
    found = log(
        before + "[WARN] [2.0]: Controller Spawner couldn't find the expected controller_manager ROS interface.\n"
    )
    spawner = next(known for known in found.known if known.message.id == "spawner-without-manager")
    assert cause in spawner.reading.causes[0].text


@pytest.mark.parametrize(
    ("before", "cause"),
    [
        (
            "[n-1] [Err] [x.cc:1] Failed to load system plugin [gz] : couldn't find shared library.\n",
            "simulator has no",
        ),
        ("[n-1] what(): no 'ros2_control' tag found in the URDF\n", "the description was rejected"),
        (
            "[n-1] [WARN] [1] [c]: Waiting for data on 'robot_description' topic to finish initialization\n",
            "no robot desc",
        ),
    ],
)
def test_what_failed_before_tells_why_a_spawner_waits(before: str, cause: str) -> None:
    found = log(before + WAITS.format(spawner="spawner-3"))
    spawner = next(known for known in found.known if known.message.id == "spawner-waits-for-manager")
    assert cause in spawner.reading.causes[0].text


def test_the_distro_is_the_one_in_the_log_s_paths() -> None:
    assert log("[n-1] File '/opt/ros/humble/lib/x', line 3").distro == "humble"
    assert log("[n-1] File '/opt/ros/nowhere/lib/x', line 3").distro == ""


@pytest.mark.parametrize(
    ("condition", "expected"),
    [
        ("a ~ ^x", True),
        ("not a ~ ^x", False),
        ("missing ~ x", False),
        ("a in b", True),
        ("c in b", False),
        ("b only ^[xy]", True),
        ("seen other", True),
        ("seen nothing", False),
        ("a ~ ^x and seen nothing", False),
        ("seen nothing or a ~ ^x", True),
    ],
)
def test_conditions_compare_values_and_messages(condition: str, expected: bool) -> None:
    assert holds(condition, {"a": "x1", "b": "x1, y2", "c": "z"}, {"other"}) is expected


def test_what_was_found_comes_first_and_what_names_a_value_of_the_log_before_that() -> None:
    known = first("Could not find resource 'elbow' in 'hardware_interface::EffortJointInterface'.")
    other = FoundCause("arm.urdf", 3, 5, "UC201", "transmission of 'wrist' has no interface")
    same = FoundCause("arm.yaml", 4, 7, "UC461", "controller needs 'elbow' in the EffortJointInterface")
    reading = with_findings(known.reading, [other, same], known.values[0].values())
    assert [cause.found for cause in reading.causes[:3]] == [(same,), (other,), ()]


def test_a_finding_about_a_name_in_the_log_is_a_cause_of_its_own_if_no_rule_found_one() -> None:
    known = first("Could not find resource 'elbow' in 'hardware_interface::EffortJointInterface'.")
    found = FoundCause("arm.urdf", 3, 5, "UC999", "joint 'elbow' is odd")
    assert with_findings(known.reading, [found], known.values[0].values()).causes[0].found == (found,)
    assert not with_findings(known.reading, [found._replace(message="odd")], known.values[0].values()).is_found
