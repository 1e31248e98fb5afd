"""Joints that nothing holds, fingers that never close, and limits that cannot be kept, each beside its sound twin."""

from __future__ import annotations

from pathlib import Path

import pytest
from smoking import smoked, target_of

from urdfctl.rules.smoke.common import GRIPPER, GRIPPER_CONTROLLER, REACHER, REACHER_CONTROLLER
from urdfctl.smoke.statics.shared_joints import shared_joint_troubles
from urdfctl.smoke.tasks import ControllerTask, MotionFamily

CODES = ("UC988", "UC989", "UC990", "UC991")
GZ = ("mock_components/GenericSystem", "gz_ros2_control/GazeboSimSystem")
WITHOUT_BEND = REACHER_CONTROLLER.replace("turn, bend, reach", "turn, reach")
WITHOUT_REACH = REACHER_CONTROLLER.replace("turn, bend, reach", "turn, bend")


def found(folder: Path, robot: str, controllers: str = REACHER_CONTROLLER) -> list[str]:
    files = {"robot.urdf": robot.strip(), "controllers.yaml": controllers}
    result = smoked(target_of(folder, files), distro="jazzy")
    return [
        f"{one.code} {one.message.split(chr(39))[1]}" for one in result.linted.outcome.diagnostics if one.code in CODES
    ]


def without(joint: str, robot: str = REACHER) -> str:
    """Return a robot whose hardware does not know a joint."""
    before, _, rest = robot.partition("<ros2_control")
    head, _, tail = rest.partition(f'<joint name="{joint}">')
    return f"{before}<ros2_control{head}{tail.partition('</joint>')[2]}"


# -- loose joints ----------------------------------------------------------------------------------------------------


def test_a_joint_between_commanded_ones_hangs_loose(tmp_path: Path) -> None:
    assert found(tmp_path, without("bend"), WITHOUT_BEND) == ["UC988 bend"]


@pytest.mark.parametrize(
    "robot",
    [
        REACHER,
        without("bend", REACHER.replace('xyz="0 1 0"', 'xyz="0 1 0"/><dynamics friction="40"')),
        without("bend", REACHER.replace('<axis xyz="0 1 0"/>', '<axis xyz="0 1 0"/><mimic joint="turn"/>')),
        without(
            "bend",
            REACHER.replace(
                "<ros2_control", '<gazebo reference="bend"><springStiffness>9</springStiffness></gazebo><ros2_control'
            ),
        ),
        without(
            "bend",
            REACHER.replace(
                "<ros2_control",
                '<gazebo><plugin name="p" filename="p"><joint_name>bend</joint_name></plugin></gazebo><ros2_control',
            ),
        ),
        without("bend", REACHER).replace(
            "<ros2_control", '<transmission name="t"><joint name="bend"/></transmission><ros2_control', 1
        ),
    ],
    ids=["hardware", "friction", "mimic", "spring", "plugin", "transmission"],
)
def test_what_is_held_does_not_hang_loose(robot: str, tmp_path: Path) -> None:
    assert found(tmp_path, robot, WITHOUT_BEND) == []


@pytest.mark.parametrize(("plugin", "expected"), [(GZ[0], []), (GZ[1], ["UC988 reach"])])
def test_the_last_joint_of_a_chain_hangs_loose_in_a_simulator(plugin: str, expected: list[str], tmp_path: Path) -> None:
    assert found(tmp_path, without("reach").replace(GZ[0], plugin), WITHOUT_REACH) == expected


def test_a_pendulum_on_an_arm_is_meant_to_swing(tmp_path: Path) -> None:
    robot = (
        without("reach")
        .replace(GZ[0], GZ[1])
        .replace('name="reach" type="prismatic"', 'name="reach" type="continuous"')
    )
    assert "UC988 reach" not in found(tmp_path, robot, WITHOUT_REACH)


# -- fingers ---------------------------------------------------------------------------------------------------------


def gripper(*, axis: str = "0 -1 0", multiplier: str = "1", aside: str = "0 0.02 0", other: str = "0 -0.02 0") -> str:
    return (
        GRIPPER.replace('<child link="one"/>', f'<child link="one"/><origin xyz="{aside}"/>')
        .replace('<child link="two"/>', f'<child link="two"/><origin xyz="{other}"/>')
        .replace('<axis xyz="0 -1 0"/>', f'<axis xyz="{axis}"/>')
        .replace('multiplier="1"', f'multiplier="{multiplier}"')
        .replace('lower="0" upper="0.04"', 'lower="-0.04" upper="0.04"')
    )


@pytest.mark.parametrize(
    ("robot", "expected"),
    [
        (gripper(), []),
        (gripper(axis="0 1 0", multiplier="-1"), []),
        (gripper(multiplier="-1"), ["UC989 thumb"]),
        (gripper(axis="0 1 0"), ["UC989 thumb"]),
        (gripper(axis="0 1 0", aside="0.02 0 0", other="-0.02 0 0"), []),
        (gripper(axis="1 0 0"), []),
    ],
    ids=["mirrored axis", "mirrored factor", "both", "none", "two columns", "at right angles"],
)
def test_fingers_close_if_they_move_towards_each_other(robot: str, expected: list[str], tmp_path: Path) -> None:
    assert found(tmp_path, robot, GRIPPER_CONTROLLER) == expected


# -- limits ----------------------------------------------------------------------------------------------------------


@pytest.mark.parametrize(
    ("lower", "upper", "expected"),
    [
        (-1.5, 1.5, []),
        (0.1, 1.5, []),
        (0, 0, []),
        (1, -1, ["UC990 bend"]),
        (1, 1, ["UC990 bend"]),
        (2.5, 3, ["UC990 bend"]),
        (-4, -2, ["UC990 bend"]),
        (1, 1.5, ["UC990 bend"]),
    ],
)
def test_soft_limits_leave_a_range_around_the_start(
    lower: float, upper: float, expected: list[str], tmp_path: Path
) -> None:
    limits = f'soft_lower_limit="{lower}" soft_upper_limit="{upper}"'
    safety = f'<safety_controller k_position="20" k_velocity="10" {limits}/>'
    assert found(tmp_path, REACHER.replace("<!-- bend -->", safety)) == expected


@pytest.mark.parametrize(
    ("limits", "expected"),
    [
        ('lower="-1" upper="1" ', ["UC991 turn"]),
        ('lower="-3.14" upper="3.14" ', []),
        ('lower="-1e16" upper="1e16" ', []),
        ('lower="0" upper="0" ', []),
        ("", []),
    ],
)
def test_a_continuous_joint_has_no_limits_of_less_than_a_turn(limits: str, expected: list[str], tmp_path: Path) -> None:
    robot = REACHER.replace('name="turn" type="revolute"', 'name="turn" type="continuous"')
    assert found(tmp_path, robot.replace('lower="-3" upper="3" ', limits)) == expected


# -- two controllers -------------------------------------------------------------------------------------------------


@pytest.mark.parametrize(
    ("first", "second", "expected"),
    [
        (("turn", "bend"), ("bend", "reach"), ["UC993"]),
        (("turn", "bend"), ("turn", "bend"), []),
        (("turn", "bend", "reach"), ("bend", "reach"), []),
        (("turn",), ("bend", "reach"), []),
    ],
)
def test_controllers_that_share_some_joints_are_no_alternatives(
    first: tuple[str, ...], second: tuple[str, ...], expected: list[str]
) -> None:
    tasks = [
        ControllerTask(name, MotionFamily.TRAJECTORY, joints, "position")
        for name, joints in (("a", first), ("b", second))
    ]
    assert [trouble.code for trouble in shared_joint_troubles(tasks)] == expected
