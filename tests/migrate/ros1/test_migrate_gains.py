"""What becomes of the gains by which Gazebo Classic itself moved joints in ROS 1."""

from __future__ import annotations

import pytest
from folder import Folder
from ros1_packages import MANIFEST, PLUGIN, arm, transmission

CONTROLLERS = """\
arm:
  type: position_controllers/JointTrajectoryController
  joints: [shoulder]
gazebo_ros_control:
  pid_gains:
    shoulder: GAINS
"""
ROBOT = arm(transmission("hardware_interface/PositionJointInterface"), PLUGIN)


def migrated(folder: Folder, gains: str, target: str = "humble") -> dict[str, str]:
    """The robot and its controllers after their migration, and the report."""
    folder.write(
        {
            "arm/package.xml": MANIFEST,
            "arm/urdf/arm.xacro": ROBOT,
            "arm/config/c.yaml": CONTROLLERS.replace("GAINS", gains),
        }
    )
    simulator = "gazebo-classic" if target == "humble" else "gz"
    words = ("--from", "noetic", "--to", target, "--simulator", simulator, "-o", "new", "--force")
    ran = folder.run("migrate", "arm", *words)
    assert ran.returncode == 0, ran.stderr
    new = folder.path / "new"
    return {path.name: path.read_text() for path in new.rglob("*") if path.is_file()}


@pytest.mark.parametrize(
    ("gains", "expected"),
    [
        ("{p: 100, i: 0.5, d: 10.0, i_clamp: 3.0}", ("100", "0.5", "10.0", "3.0", "-3.0")),
        ("{p: 100.0, i_clamp_max: 2.0, i_clamp_min: -1.0}", ("100.0", "0.0", "0.0", "2.0", "-1.0")),
        ("{p: 100.0}", ("100.0", "0.0", "0.0", "0.0", "-0.0")),
    ],
)
def test_the_gains_of_a_joint_are_its_parameters_in_humble(
    folder: Folder, gains: str, expected: tuple[str, ...]
) -> None:
    after = migrated(folder, gains)
    names = ("kp", "ki", "kd", "max_integral_error", "min_integral_error")
    lines = [f'<param name="pos_{name}">{value}</param>' for name, value in zip(names, expected, strict=True)]
    written = [line.strip() for line in after["arm.xacro"].splitlines()]
    start = written.index(lines[0])
    assert written[start - 1] == '<joint name="shoulder">'
    assert written[start : start + 6] == [*lines, '<command_interface name="position_pid"/>']
    assert "pid_gains" not in after["c.yaml"]


def test_gz_has_no_such_gains(folder: Folder) -> None:
    after = migrated(folder, "{p: 100.0}", "jazzy")
    assert "pos_kp" not in after["arm.xacro"]
    assert "the gains of Gazebo's joints are dropped" in after["MIGRATION.md"]


def test_gains_of_a_joint_that_no_description_names_are_left_to_a_person(folder: Folder) -> None:
    after = migrated(folder, "{p: 1.0}\n    elbow: {p: 100.0}")
    assert "joint 'elbow' has gains in Gazebo: write pos_kp, pos_ki, pos_kd" in after["MIGRATION.md"]
