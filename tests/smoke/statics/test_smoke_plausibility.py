"""Numbers in another unit, each beside a sound number that looks like it."""

from __future__ import annotations

import pytest

from urdfctl.model.robot.build_robot import robot_of
from urdfctl.rules.smoke.common import REACHER
from urdfctl.smoke.robot.description import mechanism_of
from urdfctl.smoke.robot.shapes import shapes_of
from urdfctl.smoke.statics.plausibility import plausibility_troubles
from urdfctl.source.span import SourceText
from urdfctl.source.xml.parsing import parse


def found(*changes: tuple[str, str]) -> list[str]:
    """Return the codes and subjects of what is unlikely about an arm in which some texts are replaced."""
    text = REACHER.strip()
    for old, new in changes:
        assert old in text, old
        text = text.replace(old, new)
    root = parse(SourceText("/robot.urdf", text.encode())).documentElement
    assert root is not None
    robot = robot_of(root)
    mechanism = mechanism_of(robot)
    assert mechanism is not None
    troubles = plausibility_troubles(mechanism, robot, shapes_of(robot), shapes_of(robot, None, "visual"))
    return [f"{one.code} {one.subject}" for one in troubles]


def test_an_arm_is_plausible() -> None:
    assert found() == []


@pytest.mark.parametrize(
    ("lower", "upper", "expected"),
    [
        ("-2", "2", []),
        ("-6.2832", "6.2832", []),
        ("-125", "125", ["UC978 joint:bend"]),
        ("0", "90", ["UC978 joint:bend"]),
        ("-1.57", "90", []),
        ("-12.5", "12.5", []),
        ("-50.27", "50.27", []),
        ("-1000", "1000", []),
        ("-1e16", "1e16", []),
    ],
)
def test_limits_in_degrees_are_halves_beyond_two_turns(lower: str, upper: str, expected: list[str]) -> None:
    assert found(('lower="-2" upper="2"', f'lower="{lower}" upper="{upper}"')) == expected


@pytest.mark.parametrize(
    ("rpy", "expected"),
    [
        ("0 0.3 0", []),
        ("0 6.2832 0", []),
        ("0 7.854 0", []),
        ("0 45 0", ["UC980 joint:bend"]),
        ("0 -90 0", ["UC980 joint:bend"]),
        ("180 0 0", ["UC980 joint:bend"]),
        ("0 1e9 0", []),
    ],
)
def test_a_rotation_in_degrees_is_more_than_a_turn(rpy: str, expected: list[str]) -> None:
    assert found(('rpy="0 0.3 0"', f'rpy="{rpy}"')) == expected


@pytest.mark.parametrize(
    ("upper", "expected"),
    [("0.2", []), ("2.5", []), ("200", ["UC979 joint:reach"]), ("1e6", [])],
)
def test_travel_in_millimetres_is_much_longer_than_the_robot(upper: str, expected: list[str]) -> None:
    assert found(('upper="0.2"', f'upper="{upper}"')) == expected


def test_a_joint_of_a_place_in_the_world_may_travel_far() -> None:
    rail = 'name="bolted" type="prismatic"><limit lower="-300" upper="300" effort="9" velocity="1"/>'
    assert found(('name="bolted" type="fixed">', rail)) == []


@pytest.mark.parametrize(
    ("old", "new", "expected"),
    [
        ('size="0.03 0.03 0.06"', 'size="30 30 60"', ["UC981 link:hand"]),
        ('size="0.03 0.03 0.06"', 'size="0.03 0.03 30"', []),
        ('size="0.03 0.03 0.06"', 'size="0.001 0.001 0.001"', []),
        ('size="0.03 0.03 0.06"', 'size="0.6 0.6 0.6"', []),
        ('xyz="0 0 0.24"', 'xyz="0 0 240"', ["UC981 joint:reach"]),
        ('xyz="0 0 0.24"', 'xyz="0 0 1.5"', []),
        ('<origin xyz="0 0 0.12"/><mass', '<origin xyz="0 0 120"/><mass', ["UC981 link:fore"]),
        ('<origin xyz="0 0 0.12"/><mass', '<origin xyz="0 0 2"/><mass', ["UC982 link:fore"]),
        ('<origin xyz="0 0 0.12"/><mass', '<origin xyz="0.3 0 0.12"/><mass', []),
    ],
)
def test_lengths_fit_the_robot(old: str, new: str, expected: list[str]) -> None:
    assert found((old, new)) == expected


@pytest.mark.parametrize(
    ("mass", "expected"),
    [("0.2", []), ("2", []), ("200", ["UC983 link:hand"]), ("20000000", [])],
)
def test_a_mass_in_grams_is_denser_than_any_material(mass: str, expected: list[str]) -> None:
    assert found(('mass value="0.2"', f'mass value="{mass}"')) == expected
