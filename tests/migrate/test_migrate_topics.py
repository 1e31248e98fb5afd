"""The files that name a topic or an action which changes with its controller."""

from __future__ import annotations

import pytest
from folder import Folder
from ros1_packages import arm, migrated, transmission

CONTROLLERS = """\
arm:
  knee_controller:
    type: position_controllers/JointPositionController
    joint: shoulder
  walk:
    type: position_controllers/JointTrajectoryController
    joints: [shoulder]
  own: {type: my_controllers/Own, joint: shoulder}
"""
FILES = {
    "config/c.yaml": CONTROLLERS,
    "urdf/arm.xacro": arm(transmission("PositionJointInterface")),
    "src/move.cpp": 'auto a = "/arm/knee_controller/command";\nauto b = "/arm/other/command";\n',
    "scripts/walk": "#!/usr/bin/env python3\nTOPIC = 'walk/command'\n",
    "scripts/own.py": "TOPIC = '/arm/own/command'\nOTHER = '/arm/walk/commands'\n",
    "launch/arm.launch": """
        <launch>
          <node pkg="arm" type="move" name="move"><remap from="out" to="/arm/knee_controller/command"/></node>
        </launch>
    """,
}


def test_who_names_a_topic_that_changes_is_listed(folder: Folder) -> None:
    report = migrated(folder, FILES)["MIGRATION.md"]
    new = "'/arm/knee_controller/commands' of type std_msgs/msg/Float64MultiArray now: change it here"
    assert f"'/arm/knee_controller/command' is {new}" in report
    assert "  - `src/move.cpp:1`" in report
    assert "  - `launch/arm.launch.py:" in report
    assert "`scripts/walk:2`: 'walk/command' is 'walk/joint_trajectory' of type trajectory_msgs/msg/Joint" in report
    assert "not ~/command of type Float64: change who publishes it (knee_controller)." in report
    assert "trajectories are read from ~/joint_trajectory now, not from ~/command (walk)." in report
    assert "scripts/own.py" not in report
    assert "other/command" not in report


REMAPPED = '<node pkg="arm" type="n" name="n"><remap from="a" to="/drive/cmd_vel"/></node>'
DRIVE = """\
controller_manager:
  ros__parameters:
    drive: {type: diff_drive_controller/DiffDriveController}
drive:
  type: diff_drive_controller/DiffDriveController
  left_wheel: [shoulder]
  right_wheel: [shoulder]
"""


@pytest.mark.parametrize(
    ("target", "now", "where"),
    [
        ("jazzy", "takes geometry_msgs/msg/TwistStamped now", ["src/move.py"]),
        ("humble", "is '/drive/cmd_vel_unstamped' of type geometry_msgs/msg/Twist now", ["src/move.py", "launch/arm"]),
    ],
)
def test_who_publishes_velocities_is_listed_where_their_type_or_topic_changes(
    folder: Folder, target: str, now: str, where: list[str]
) -> None:
    files = {
        "config/c.yaml": DRIVE.partition("drive:\n  type")[1] + DRIVE.partition("drive:\n  type")[2],
        "urdf/arm.xacro": arm(transmission("VelocityJointInterface")),
        "src/move.py": "pub('/drive/cmd_vel')\n",
        "launch/arm.launch": f"<launch>{REMAPPED}</launch>",
    }
    after = migrated(folder, files, "--to", target)
    report = after["MIGRATION.md"]
    assert f"'/drive/cmd_vel' {now}: change it here" in report
    assert [name for name in ("src/move.py", "launch/arm") if f"`{name}" in report.partition("For you")[2]] == where
    assert ("use_stamped_vel: false" in after["config/c.yaml"]) is (target == "humble")


def test_a_drive_whose_velocities_are_stamped_already_reads_them_so(folder: Folder) -> None:
    files = {
        "config/c.yaml": DRIVE.partition("drive:\n  type")[1] + DRIVE.partition("drive:\n  type")[2],
        "urdf/arm.xacro": arm(transmission("VelocityJointInterface")),
        "src/move.py": "from geometry_msgs.msg import TwistStamped\n",
    }
    assert "use_stamped_vel" not in migrated(folder, files, "--to", "humble")["config/c.yaml"]


@pytest.mark.parametrize(("target", "is_told"), [("lyrical", True), ("jazzy", False)])
def test_readers_of_dynamic_joint_states_are_listed_for_distros_without_them(
    folder: Folder, target: str, is_told: bool
) -> None:
    files = {"src/read.cpp": 'auto topic = "/dynamic_joint_states";\n', "urdf/arm.xacro": arm("")}
    report = migrated(folder, {**files, "config/c.yaml": CONTROLLERS}, "--to", target)["MIGRATION.md"]
    assert ("`src/read.cpp:1`: names /dynamic_joint_states" in report) is is_told
