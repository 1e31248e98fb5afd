"""The robot in numbers: what is read from the description, and what follows from the tree of its links."""

from __future__ import annotations

import math

import pytest

from urdfctl.model.robot.build_robot import robot_of
from urdfctl.smoke.robot.description import hinges_of, mechanism_of, numbers_of
from urdfctl.smoke.robot.mechanism import Hinge, Mechanism
from urdfctl.source.span import SourceText
from urdfctl.source.xml.parsing import parse


def read(inside: str) -> Mechanism | None:
    root = parse(SourceText("/robot.urdf", f'<robot name="r">{inside}</robot>'.encode())).documentElement
    assert root is not None
    return mechanism_of(robot_of(root))


def robot(inside: str) -> Mechanism:
    made = read(inside)
    assert made is not None
    return made


def joint(name: str, parent: str, child: str, inside: str = "", kind: str = "revolute") -> str:
    ends = f'<parent link="{parent}"/><child link="{child}"/>'
    return f'<joint name="{name}" type="{kind}">{ends}{inside}</joint>'


def links(*names: str) -> str:
    return "".join(f'<link name="{name}"/>' for name in names)


ARM = links("base", "arm")


def elbow(inside: str = "", more: str = "", kind: str = "revolute") -> Hinge:
    """Return the only joint of a robot with some elements."""
    return robot(ARM + joint("j", "base", "arm", inside, kind) + more).hinges[0]


# -- the tree --------------------------------------------------------------------------------------------------------


@pytest.mark.parametrize(
    "inside",
    [
        links("a", "b"),
        links("a", "b") + joint("j", "a", "b") + joint("k", "b", "a"),
        links("a", "b", "c") + joint("j", "a", "b") + joint("k", "c", "b"),
        links("a", "b", "c") + joint("j", "a", "b") + joint("j", "a", "c"),
        links("a", "b", "b") + joint("j", "a", "b"),
        links("a") + joint("j", "a", "b"),
        links("a", "b", "c") + joint("j", "b", "c") + joint("k", "c", "b"),
    ],
    ids=[
        "two roots",
        "a loop",
        "two parents",
        "one name twice",
        "one link twice",
        "no child",
        "a loop beside the root",
    ],
)
def test_links_that_form_no_tree_are_no_robot(inside: str) -> None:
    assert read(inside) is None


TREE = robot(
    links("c", "a", "b", "base", "tool")
    + joint("to_tool", "b", "tool", kind="fixed")
    + joint("to_b", "a", "b")
    + joint("to_a", "base", "a")
    + joint("to_c", "base", "c", kind="prismatic")
)


def test_the_joints_are_in_order_from_the_root_outwards() -> None:
    assert TREE.root == "base"
    assert [hinge.name for hinge in TREE.hinges] == ["to_a", "to_c", "to_b", "to_tool"]


def test_what_hangs_on_a_link_and_what_it_hangs_on() -> None:
    assert TREE.below("a") == {"a", "b", "tool"}
    assert TREE.body_of("b") == {"b", "tool"}
    assert TREE.body_of("a") == {"a"}
    assert [hinge.name for hinge in TREE.above("tool")] == ["to_tool", "to_b", "to_a"]
    assert TREE.above("base") == []


def test_only_a_root_named_world_is_fixed() -> None:
    assert robot(links("world", "a") + joint("j", "world", "a")).is_fixed
    assert not TREE.is_fixed


# -- joints ----------------------------------------------------------------------------------------------------------


@pytest.mark.parametrize(
    ("text", "expected"),
    [("0.5", 0.5), ("0", 0.0), ("-0.5", 0.0), ("nan", 0.0), ("inf", 0.0), ("1e-3", 1e-3), ("much", 0.0)],
)
def test_damping_and_friction_are_numbers_above_0(text: str, expected: float) -> None:
    both = elbow(f'<dynamics damping="{text}" friction="0.25"/>')
    assert (both.damping, both.friction) == (expected, 0.25)
    assert elbow().damping == 0.0


@pytest.mark.parametrize(
    ("limits", "kind", "span"),
    [
        ('lower="-1" upper="2"', "revolute", (-1.0, 2.0)),
        ('lower="2" upper="1"', "revolute", (2.0, 2.0)),
        ('upper="1"', "revolute", (0.0, 1.0)),
        ('lower="-1" upper="2"', "continuous", (-math.pi, math.pi)),
        ('lower="-inf" upper="2"', "revolute", (-math.pi, math.pi)),
        ('lower="-1" upper="nan"', "revolute", (-math.pi, math.pi)),
    ],
)
def test_the_span_of_a_joint(limits: str, kind: str, span: tuple[float, float]) -> None:
    assert elbow(f"<limit {limits}/>", kind=kind).span == span


@pytest.mark.parametrize(("kind", "unit", "effort"), [("prismatic", "m", "N"), ("revolute", "rad", "N m")])
def test_units_and_motion_depend_on_the_type(kind: str, unit: str, effort: str) -> None:
    hinge = elbow('<axis xyz="0 0 2"/>', kind=kind)
    assert (hinge.unit, hinge.effort_unit, hinge.axis) == (unit, effort, (0.0, 0.0, 1.0))
    moved = hinge.moved(math.pi / 2).at((1.0, 0.0, 0.0))
    assert moved == pytest.approx((1.0, 0.0, math.pi / 2) if kind == "prismatic" else (0.0, 1.0, 0.0))


def test_a_joint_that_mimics_is_where_its_leader_puts_it() -> None:
    mimic = '<axis xyz="0 0 1"/><mimic joint="j" multiplier="2" offset="0.1"/>'
    slide = '<axis xyz="0 0 1"/><limit lower="-1" upper="1"/>'
    made = robot(
        links("base", "arm", "thumb")
        + joint("j", "base", "arm", slide, "prismatic")
        + joint("m", "base", "thumb", mimic, "prismatic")
    )
    assert made.poses({"j": 0.2})["thumb"].place == pytest.approx((0.0, 0.0, 0.5))
    assert made.poses({"m": 0.2})["thumb"].place == pytest.approx((0.0, 0.0, 0.2))
    assert [hinge.name for hinge in made.movable] == ["j"]


def control(*interfaces: str, kind: str = "joint", name: str = "j") -> str:
    return f'<ros2_control name="c" type="system"><{kind} name="{name}">{"".join(interfaces)}</{kind}></ros2_control>'


def interface(name: str, kind: str = "command", **parameters: object) -> str:
    inside = "".join(f'<param name="{key}">{value}</param>' for key, value in parameters.items())
    return f'<{kind}_interface name="{name}">{inside}</{kind}_interface>'


@pytest.mark.parametrize(
    ("given", "expected"),
    [
        (interface("position", min=-1, max=2), (-1.0, 2.0)),
        (interface("position", min=1, max=1), (1.0, 1.0)),
        (interface("position", min=2, max=1), (-math.inf, math.inf)),
        (interface("position", min=2), (-math.inf, math.inf)),
        (interface("position", "state", min=-1, max=2), (-math.inf, math.inf)),
        (interface("velocity", min=-1, max=2), (-math.inf, math.inf)),
    ],
)
def test_the_range_of_a_command_interface(given: str, expected: tuple[float, float]) -> None:
    assert elbow(more=control(given)).range_of("position") == expected
    assert elbow(more=control(given, name="other")).range_of("position") == (-math.inf, math.inf)
    assert elbow(more=control(given, kind="sensor")).range_of("position") == (-math.inf, math.inf)


@pytest.mark.parametrize(
    ("interfaces", "expected"),
    [
        ((interface("position", "state", initial_value=0.5),), 0.5),
        ((interface("position", initial_value=0.2),), 0.2),
        ((interface("position", initial_value=0.2), interface("position", "state", initial_value=0.5)), 0.5),
        ((interface("position", initial_value=0.2), interface("position", "state")), 0.2),
        ((interface("velocity", "state", initial_value=0.5),), 0.0),
        ((interface("position", "state", initial_value="nan"),), 0.0),
        ((interface("position", "state", initial_value=5),), 1.0),
    ],
)
def test_a_joint_starts_at_its_initial_value_within_its_limits(interfaces: tuple[str, ...], expected: float) -> None:
    assert elbow('<limit lower="-1" upper="1"/>', control(*interfaces)).start == expected


def test_a_joint_without_a_link_is_left_out() -> None:
    root = parse(SourceText("/r.urdf", f'<robot name="r">{links("a")}<joint name="j" type="fixed"/></robot>'.encode()))
    assert root.documentElement is not None
    assert hinges_of(robot_of(root.documentElement)) == []


# -- links -----------------------------------------------------------------------------------------------------------


def shaped(role: str, shape: str) -> float | None:
    """Return the radius of a link."""
    inside = f'<link name="base"><{role}><geometry>{shape}</geometry></{role}></link>'
    return robot(inside).bodies["base"].radius


def test_the_radius_of_a_wheel_is_that_of_its_collision_shape() -> None:
    assert shaped("collision", '<cylinder radius="0.1" length="0.05"/>') == 0.1
    assert shaped("collision", '<sphere radius="0.2"/>') == 0.2
    assert shaped("visual", '<sphere radius="0.2"/>') is None
    assert shaped("collision", '<box size="1 1 1"/>') is None
    assert shaped("collision", '<mesh filename="wheel.stl" radius="0.2"/>') is None


def test_the_inertia_is_turned_into_the_frame_of_the_link() -> None:
    inertia = '<inertia ixx="1" ixy="0" ixz="0" iyy="2" iyz="0" izz="3"/>'
    origin = f'<origin xyz="0 0 0.5" rpy="{math.pi / 2} 0 0"/>'
    body = robot(f'<link name="base"><inertial>{origin}<mass value="4"/>{inertia}</inertial></link>').bodies["base"]
    assert (body.mass, body.centre) == (4.0, (0.0, 0.0, 0.5))
    assert [body.inertia[n][n] for n in range(3)] == pytest.approx([1.0, 3.0, 2.0])


@pytest.mark.parametrize(
    ("inside", "falls"),
    [
        ("<turnGravityOff>true</turnGravityOff>", False),
        ("<turnGravityOff>false</turnGravityOff>", True),
        ("<gravity>0</gravity>", False),
        ("<gravity>true</gravity>", True),
        ("", True),
    ],
)
def test_gazebo_turns_the_gravity_of_a_link_off(inside: str, falls: bool) -> None:
    made = robot(ARM + joint("j", "base", "arm") + f'<gazebo reference="arm">{inside}</gazebo>')
    assert (made.bodies["arm"].falls, made.bodies["base"].falls) == (falls, True)


@pytest.mark.parametrize(
    ("inside", "grip"), [("<mu1>0.4</mu1>", 0.4), ('<mu1 value="0.3"/>', 0.3), ("<mu1>much</mu1>", None), ("", None)]
)
def test_gazebo_gives_the_friction_of_a_link(inside: str, grip: float | None) -> None:
    assert robot(links("base") + f'<gazebo reference="base">{inside}</gazebo>').bodies["base"].grip == grip


@pytest.mark.parametrize(
    ("text", "expected"), [("1 2 3", (1, 2, 3)), ("1", (1, 0, 0)), ("1 2 3 4", (1, 2, 3)), ("a .5 1e1", (0, 0.5, 10))]
)
def test_a_vector_has_three_numbers(text: str, expected: tuple[float, float, float]) -> None:
    assert numbers_of(text) == expected
