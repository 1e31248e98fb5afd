"""A robot at rest: its masses, inertias, limits, mimic joints and start, each against the formula that judges it."""

from __future__ import annotations

import math

import pytest

from urdfctl.model.robot import Robot
from urdfctl.model.robot.build_robot import robot_of
from urdfctl.smoke.robot.description import mechanism_of
from urdfctl.smoke.robot.mechanism import Mechanism
from urdfctl.smoke.robot.shapes import Shapes
from urdfctl.smoke.statics.physics import static_troubles
from urdfctl.smoke.tasks.task import ControllerTask, MotionFamily
from urdfctl.source.span import SourceText
from urdfctl.source.xml.parsing import parse

BODY = '<inertial><mass value="{mass}"/><inertia ixx="{xx}" ixy="0" ixz="0" iyy="{yy}" iyz="0" izz="{zz}"/></inertial>'
BOX = '<collision><geometry><box size="0.02 0.3 0.02"/></geometry></collision>'
TURN = '<axis xyz="0 0 1"/><limit lower="-1" upper="1" effort="10" velocity="2"/>'


def link(name: str, mass: object = 1.0, xx: object = 0.01, yy: object = 0.01, zz: object = 0.01) -> str:
    """Return a link that is 0.3 m long."""
    return f'<link name="{name}">{BODY.format(mass=mass, xx=xx, yy=yy, zz=zz)}{BOX}</link>'


def joint(name: str, parent: str, child: str, inside: str = TURN, kind: str = "revolute") -> str:
    ends = f'<parent link="{parent}"/><child link="{child}"/>'
    return f'<joint name="{name}" type="{kind}">{ends}{inside}</joint>'


def control(interface: str, least: float, most: float) -> str:
    limits = f'<param name="min">{least}</param><param name="max">{most}</param>'
    given = f'<command_interface name="{interface}">{limits}</command_interface>'
    return f'<ros2_control name="c" type="system"><joint name="j">{given}</joint></ros2_control>'


def read(*parts: str) -> tuple[Mechanism, Robot]:
    root = parse(SourceText("/robot.urdf", f'<robot name="r">{"".join(parts)}</robot>'.encode())).documentElement
    assert root is not None
    robot = robot_of(root)
    mechanism = mechanism_of(robot)
    assert mechanism is not None
    return mechanism, robot


def found(
    *parts: str, interface: str = "position", joints: tuple[str, ...] = ("j",), held: tuple[str, ...] = ()
) -> list[str]:
    """Return the codes and subjects of what is wrong with a robot whose joints one controller moves.

    held: the joints in hardware that may obey their velocity limit of 0.
    """
    mechanism, robot = read(*parts)
    task = ControllerTask("arm", MotionFamily.TRAJECTORY, joints, interface)
    return [f"{one.code} {one.subject}" for one in static_troubles(mechanism, [task], robot, Shapes({}), held)]


BASE = '<link name="base"/>'
ARM = BASE + link("arm")
LEVEL = joint("j", "base", "arm")


# -- masses and inertias ---------------------------------------------------------------------------------------------


@pytest.mark.parametrize(
    ("fields", "expected"),
    [
        ({"mass": 0}, []),
        ({"mass": -0.1}, ["UC910 link:arm"]),
        ({"mass": "nan"}, ["UC910 link:arm"]),
        ({"mass": "inf"}, ["UC910 link:arm"]),
        ({"xx": 0, "yy": 0, "zz": 0}, []),
        ({"xx": -1e-6}, ["UC910 link:arm"]),
        ({"yy": -1e-6}, ["UC910 link:arm"]),
        ({"zz": "nan"}, ["UC910 link:arm"]),
    ],
)
def test_masses_and_moments_are_numbers_that_are_not_negative(fields: dict[str, object], expected: list[str]) -> None:
    assert found(BASE, link("arm", **fields), LEVEL) == expected


def of_reach(reach: float, mass: float = 1.0) -> str:
    """Return a link whose largest moment is that of its mass at some distance."""
    most = mass * reach**2
    return link("arm", mass, most / 2, most, most / 2)


@pytest.mark.parametrize(("reach", "expected"), [(0.009, ["UC957 link:arm"]), (0.011, [])])
def test_the_mass_of_a_link_that_efforts_move_reaches_a_thirtieth_of_its_length(
    reach: float, expected: list[str]
) -> None:
    """The link is 0.3 m long: 0.01 m. A motor that follows positions does not care."""
    assert found(BASE, of_reach(reach), LEVEL, interface="effort") == expected
    assert found(BASE, of_reach(reach), LEVEL, interface="position") == []


@pytest.mark.parametrize(("mass", "expected"), [(0.009, []), (0.011, ["UC957 link:arm"])])
def test_links_of_less_than_ten_grams_are_not_judged_by_their_inertia(mass: float, expected: list[str]) -> None:
    assert found(BASE, of_reach(0.005, mass), LEVEL, interface="effort") == expected


def test_the_links_that_hang_on_a_pushed_one_are_judged_too_and_those_before_it_are_not() -> None:
    robot = (
        BASE + of_reach(0.005).replace('"arm"', '"mast"') + of_reach(0.005) + of_reach(0.005).replace('"arm"', '"hand"')
    )
    joints = joint("k", "base", "mast") + joint("j", "mast", "arm") + joint("w", "arm", "hand", "", "fixed")
    assert found(robot, joints, interface="effort") == ["UC957 link:arm", "UC957 link:hand"]


def test_a_point_has_no_inertia_to_judge() -> None:
    assert found(BASE, of_reach(0.0), LEVEL, interface="effort") == []


def test_a_wrong_mass_is_reported_instead_of_what_follows_from_it() -> None:
    weak = joint("j", "base", "arm", '<axis xyz="0 1 0"/><limit lower="-1" upper="1" effort="0.001" velocity="2"/>')
    lever = link("arm", 1.0).replace("<inertial>", '<inertial><origin xyz="1 0 0"/>')
    assert found(BASE, lever, weak) == ["UC915 joint:j"]
    assert found(BASE, lever.replace('mass value="1.0"', 'mass value="-1.0"'), weak) == ["UC910 link:arm"]


# -- limits ----------------------------------------------------------------------------------------------------------


@pytest.mark.parametrize(
    ("lower", "upper", "velocity", "expected"),
    [
        (-1, 1, 2, []),
        (-1, 1, 0, ["UC914 joint:j"]),
        (0.5, 0.5, 2, ["UC967 joint:j"]),
        (0.5, 0.4, 2, ["UC967 joint:j"]),
        (0.5, 0.5, 0, ["UC914 joint:j"]),
    ],
)
def test_a_joint_needs_a_range_and_a_velocity(lower: float, upper: float, velocity: float, expected: list[str]) -> None:
    limits = f'<axis xyz="0 0 1"/><limit lower="{lower}" upper="{upper}" effort="10" velocity="{velocity}"/>'
    held = () if velocity else ("j",)
    assert found(ARM, joint("j", "base", "arm", limits), held=held) == expected
    assert found(ARM, joint("j", "base", "arm", limits), joints=(), held=held) == []


def test_a_velocity_limit_of_0_holds_a_joint_only_in_hardware_that_obeys_it() -> None:
    limits = '<axis xyz="0 0 1"/><limit lower="-1" upper="1" effort="10" velocity="0"/>'
    assert found(ARM, joint("j", "base", "arm", limits)) == []


def test_a_fixed_joint_needs_neither() -> None:
    assert found(ARM, joint("j", "base", "arm", '<limit lower="0" upper="0" velocity="0"/>', "fixed")) == []


@pytest.mark.parametrize(
    ("interface", "least", "most", "expected"),
    [
        ("position", -0.011, 0.011, []),
        ("position", -0.009, 0.009, ["UC954 joint:j"]),
        ("position", 0.99, 5.0, ["UC954 joint:j"]),
        ("position", 0.97, 5.0, []),
        ("position", 2.0, 3.0, ["UC954 joint:j"]),
        ("position", -5.0, 5.0, []),
        ("velocity", -0.022, 0.022, []),
        ("velocity", -0.018, 0.018, ["UC954 joint:j"]),
        ("effort", -0.11, 0.11, []),
        ("effort", -0.09, 0.09, ["UC954 joint:j"]),
    ],
)
def test_commands_cover_a_hundredth_of_the_range_of_the_joint(
    interface: str, least: float, most: float, expected: list[str]
) -> None:
    """The joint has 2 rad between its limits, 4 rad/s and 20 N m from limit to limit."""
    codes = found(ARM, LEVEL, control(interface, least, most), interface=interface)
    assert [code for code in codes if code.startswith("UC954")] == expected


def test_a_range_of_another_interface_does_not_matter() -> None:
    assert found(ARM, LEVEL, control("velocity", -0.001, 0.001), interface="position") == []


@pytest.mark.parametrize("limit", ["", 'effort="0" velocity="2"'])
def test_a_joint_without_a_limit_of_effort_has_no_range_to_compare(limit: str) -> None:
    turn = f'<axis xyz="0 0 1"/><limit lower="-1" upper="1" {limit}/>'
    codes = found(ARM, joint("j", "base", "arm", turn), control("effort", -0.001, 0.001), interface="effort")
    assert "UC954 joint:j" not in codes


# -- start and mimic joints ------------------------------------------------------------------------------------------


def start(at: float) -> str:
    state = f'<state_interface name="position"><param name="initial_value">{at}</param></state_interface>'
    return f'<ros2_control name="c" type="system"><joint name="j">{state}</joint></ros2_control>'


@pytest.mark.parametrize(
    ("at", "expected"), [(0.0, []), (1.03, []), (1.05, ["UC965 joint:j"]), (-1.05, ["UC965 joint:j"])]
)
def test_a_joint_starts_within_a_fiftieth_of_its_range(at: float, expected: list[str]) -> None:
    """The range is 2 rad, so that 0.04 rad beyond a limit are accepted."""
    assert found(ARM, LEVEL, start(at)) == expected
    assert found(ARM, joint("j", "base", "arm", TURN, "continuous"), start(9.0)) == []
    assert found(ARM, joint("j", "base", "arm", TURN, "fixed"), start(at)) == []


def mimicking(factor: float, offset: float = 0.0, kind: str = "revolute", leader: str = "revolute") -> list[str]:
    """Return what is wrong with a joint from -1 to 1 rad that follows another one of this range."""
    mimic = f'{TURN}<mimic joint="j" multiplier="{factor}" offset="{offset}"/>'
    joints = joint("j", "base", "arm", TURN, leader) + joint("m", "base", "thumb", mimic, kind)
    return found(ARM, link("thumb"), joints)


@pytest.mark.parametrize(
    ("factor", "offset", "expected"),
    [
        (1.0, 0.0, []),
        (1.03, 0.0, []),
        (1.05, 0.0, ["UC953 joint:m"]),
        (-1.05, 0.0, ["UC953 joint:m"]),
        (1.0, 0.03, []),
        (1.0, 0.05, ["UC953 joint:m"]),
        (1.0, -0.05, ["UC953 joint:m"]),
    ],
)
def test_a_mimic_joint_is_asked_to_exceed_its_limits_by_a_fiftieth(
    factor: float, offset: float, expected: list[str]
) -> None:
    assert mimicking(factor, offset) == expected


@pytest.mark.parametrize(
    ("kind", "leader"), [("continuous", "revolute"), ("revolute", "continuous"), ("fixed", "revolute")]
)
def test_joints_that_turn_endlessly_or_not_at_all_cannot_be_asked_for_too_much(kind: str, leader: str) -> None:
    assert mimicking(math.pi, kind=kind, leader=leader) == []
