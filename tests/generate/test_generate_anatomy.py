"""Which joints are wheels, which a hand, and which the chain of an arm."""

from __future__ import annotations

import pytest

from urdfctl.generate.robot.anatomy import Anatomy, anatomy_of
from urdfctl.generate.robot.facts import JointFacts, RobotFacts

LEVEL = (0.0, 1.0, 0.0)
HERE = (0.0, 0.0, 0.1)


def turning(name: str, above: str | None = None, mimic: str | None = None) -> JointFacts:
    """Return a joint that turns."""
    followed = (mimic, 1.0, 0.0) if mimic else None
    return JointFacts(name, link=f"{name}_link", above=above, mimic=followed, mimics=bool(mimic), lower=0.0, upper=1.0)


def endless(name: str, above: str | None = None) -> JointFacts:
    """Return a level joint that turns without end, with something round on it."""
    return JointFacts(name, "continuous", link=f"{name}_link", above=above, axis=LEVEL, at=HERE, radius=0.1)


def anatomy(*joints: JointFacts) -> Anatomy:
    """Return the parts of a robot with these joints."""
    return anatomy_of(RobotFacts("r", joints=joints), joints)


def names_of(parts: Anatomy) -> tuple[list[list[str]], list[list[str]]]:
    """Return the names of the joints in the tools, and in the chains."""
    tools = [[joint.name for joint in tool.joints] for tool in parts.tools]
    return tools, [[joint.name for joint in chain] for chain in parts.chains]


def test_an_arm_of_joints_that_turn_without_end_has_no_wheels() -> None:
    row = ("one", "two", "three", "four", "five", "six")
    parts = anatomy(*(endless(name, above) for name, above in zip(row, (None, *row[:-1]), strict=True)))
    assert parts.base is None
    assert names_of(parts) == ([], [[*row]])


def test_a_wheel_with_rollers_on_its_rim_is_a_wheel() -> None:
    wheels = [endless(name)._replace(at=(0.0, y, 0.1)) for name, y in (("left", 0.2), ("right", -0.2))]
    rollers = [endless(f"{wheel.name}_{n}", wheel.name)._replace(radius=None) for wheel in wheels for n in range(4)]
    base = anatomy(*wheels, *rollers).base
    assert base is not None
    assert [joint.name for joint in base.joints] == ["left", "right"]


@pytest.mark.parametrize(
    ("right", "link", "expected"),
    [
        ((0.1, -0.2, 0.1), "b", ["left", "right"]),
        ((0.1, -0.15, 0.1), "b", []),
        ((0.1, 0.2, 0.1), "b", []),
        ((0.1, -0.15, 0.1), "right_wheel_1", ["right"]),
    ],
)
def test_wheels_of_unknown_size_are_known_by_the_names_of_links_or_as_a_pair(
    right: tuple[float, float, float], link: str, expected: list[str]
) -> None:
    made = endless("left")._replace(at=(0.1, 0.2, 0.1), radius=None)
    base = anatomy(made, endless("right")._replace(at=right, radius=None, link=link)).base
    assert [joint.name for joint in (base.joints if base else ())] == expected


def test_a_pair_of_endless_joints_that_carry_arms_is_no_pair_of_wheels() -> None:
    shoulders = [endless(name)._replace(at=(0.0, y, 1.0), radius=None) for name, y in (("l", 0.2), ("r", -0.2))]
    assert anatomy(*shoulders, turning("l_elbow", "l"), turning("r_elbow", "r")).base is None


@pytest.mark.parametrize(
    ("caster", "chains"),
    [
        (turning("caster"), []),
        (turning("pan")._replace(link="rear_castor"), []),
        (turning("pan"), [["pan"]]),
        (turning("caster", "lift"), [["lift", "caster"]]),
    ],
)
def test_a_caster_that_only_swivels_on_a_driven_base_is_left_free(caster: JointFacts, chains: list[list[str]]) -> None:
    wheels = [endless(name)._replace(at=(0.0, y, 0.1)) for name, y in (("left", 0.2), ("right", -0.2))]
    lift = [turning("lift")] if caster.above else []
    parts = anatomy(*wheels, *lift, caster)
    assert names_of(parts) == ([], chains)
    assert parts.base is not None
    assert parts.base.others == (() if chains else (caster,))


def test_a_caster_on_a_robot_without_a_drive_is_a_joint_as_others_are() -> None:
    assert names_of(anatomy(turning("caster"))) == ([], [["caster"]])


def test_the_springs_on_fingers_that_follow_a_motor_are_one_hand_with_it() -> None:
    fingers = [
        part
        for side in ("l", "r")
        for part in (
            turning(f"{side}_proximal", "wrist", "motor"),
            turning(f"{side}_spring", f"{side}_proximal"),
            turning(f"{side}_middle", f"{side}_spring", f"{side}_spring"),
            turning(f"{side}_distal", f"{side}_middle", "motor"),
        )
    ]
    parts = anatomy(turning("shoulder"), turning("wrist", "shoulder"), turning("motor", "wrist"), *fingers)
    assert names_of(parts) == ([["motor", "l_spring", "r_spring"]], [["shoulder", "wrist"]])
    assert not parts.tools[0].single


def test_what_follows_followers_of_a_motor_is_one_hand_with_it() -> None:
    fingers = [turning("pivot", "wrist", "motor"), turning("gear", "wrist", "pivot"), turning("tip", "gear", "gear")]
    parts = anatomy(turning("shoulder"), turning("wrist", "shoulder"), turning("motor", "wrist"), *fingers)
    assert names_of(parts) == ([["motor"]], [["shoulder", "wrist"]])


def test_what_a_follower_of_a_follower_carries_by_another_joint_is_no_hand() -> None:
    parts = anatomy(
        turning("motor"), turning("rod", None, "motor"), turning("beam", "rod", "rod"), *finger("arm", 3, "beam")
    )
    assert parts.tools == ()


@pytest.mark.parametrize("carried", [(turning("pan", "second"), turning("tilt", "pan")), (turning("pan", "lift"),)])
def test_what_carries_an_arm_or_a_head_is_no_hand(carried: tuple[JointFacts, ...]) -> None:
    parts = anatomy(turning("lift"), turning("second", None, "lift"), *carried)
    assert parts.tools == ()


def test_a_joint_beside_a_gripper_does_not_lengthen_the_arm() -> None:
    arm = (turning("shoulder"), turning("elbow", "shoulder"), turning("wrist", "elbow"))
    parts = anatomy(*arm, turning("finger", "wrist"), turning("tilt", "wrist"))
    assert names_of(parts) == ([["finger"]], [["shoulder", "elbow", "wrist"], ["tilt"]])


ARM = (turning("shoulder"), turning("elbow", "shoulder"), turning("wrist", "elbow"))


def finger(name: str, joints: int, above: str = "wrist") -> list[JointFacts]:
    """Return the joints of a finger, one on the other."""
    names = [f"{name}_{number + 1}" for number in range(joints)]
    return [turning(one, on) for one, on in zip(names, [above, *names], strict=False)]


@pytest.mark.parametrize(("left", "right", "thumb"), [(2, 2, 0), (2, 1, 0), (3, 3, 3), (2, 1, 1)])
def test_fingers_of_several_joints_on_one_link_are_one_hand(left: int, right: int, thumb: int) -> None:
    fingers = [*finger("l_finger", left), *finger("r_finger", right), *finger("thumb_finger", thumb)]
    parts = anatomy(*ARM, *fingers)
    assert names_of(parts) == ([[joint.name for joint in fingers]], [["shoulder", "elbow", "wrist"]])
    assert not parts.tools[0].single


def test_a_wrist_that_is_named_after_the_gripper_on_it_remains_in_the_arm() -> None:
    fingers = [*finger("l_finger", 2, "gripper_roll"), *finger("r_finger", 2, "gripper_roll")]
    parts = anatomy(*ARM, turning("gripper_roll", "wrist"), *fingers)
    assert names_of(parts) == (
        [["l_finger_1", "l_finger_2", "r_finger_1", "r_finger_2"]],
        [["shoulder", "elbow", "wrist", "gripper_roll"]],
    )


def test_two_arms_with_a_gripper_each_are_no_fingers() -> None:
    sides = [[turning(f"{side}_arm", "torso"), turning(f"{side}_gripper", f"{side}_arm")] for side in "lr"]
    parts = anatomy(turning("torso"), *sides[0], *sides[1])
    assert names_of(parts) == ([["l_gripper"], ["r_gripper"]], [["torso"], ["l_arm"], ["r_arm"]])


def test_a_word_in_the_names_of_all_joints_makes_no_hand_of_two_arms() -> None:
    arms = [*finger("claw_l", 2, "claw_torso"), *finger("claw_r", 2, "claw_torso")]
    tools, chains = names_of(anatomy(turning("claw_torso"), *arms))
    assert tools == [["claw_l_2"], ["claw_r_2"]]
    assert chains == [["claw_torso"], ["claw_l_1"], ["claw_r_1"]]


def jaw(name: str, side: float, low: float, high: float, axis: tuple[float, float, float] = LEVEL) -> JointFacts:
    """Return a joint on the wrist, to one side of it, that turns between two limits."""
    return turning(name, "wrist")._replace(at=(side, 0.0, 0.5), axis=axis, lower=low, upper=high)


@pytest.mark.parametrize(
    ("left", "right"),
    [
        (jaw("a", -0.03, -0.1, 0.8), jaw("b", 0.03, -0.8, 0.1)),
        (jaw("a", -0.03, 0.0, 0.8), jaw("b", 0.03, 0.0, 0.8, (0.0, -1.0, 0.0))),
        (jaw("a", 0.0, 0.0, 0.8), jaw("b", 0.0, -0.8, 0.0)),  # on one pin
    ],
)
def test_two_joints_that_turn_towards_each_other_at_the_end_of_an_arm_are_a_gripper(
    left: JointFacts, right: JointFacts
) -> None:
    assert names_of(anatomy(*ARM, left, right)) == ([["a", "b"]], [["shoulder", "elbow", "wrist"]])


@pytest.mark.parametrize(
    ("name", "joints", "hand"),
    [("bar", 1, True), ("bar", 2, True), ("bar", 3, False), ("arm", 2, False)],
)
def test_jaws_may_carry_a_few_joints_that_are_not_of_an_arm(name: str, joints: int, hand: bool) -> None:
    left, right = jaw("a", -0.03, 0.0, 0.8), jaw("b", 0.03, -0.8, 0.0)
    parts = anatomy(*ARM, left, *finger(f"l_{name}", joints, "a"), right, *finger(f"r_{name}", joints, "b"))
    assert [len(tool.joints) for tool in parts.tools] == [2 * joints + 2] * hand


@pytest.mark.parametrize(
    ("left", "right"),
    [
        (jaw("a", -0.03, 0.0, 0.8), jaw("b", 0.03, 0.0, 0.8)),  # both turn to the same side
        (jaw("a", -0.03, -0.8, 0.8), jaw("b", 0.03, -0.8, 0.8)),  # a head and an antenna may
        (jaw("a", -0.03, 0.0, 0.8, (1.0, 0.0, 0.0)), jaw("b", 0.03, -0.8, 0.0, (1.0, 0.0, 0.0))),  # on one axle
        (jaw("a", -0.03, 0.0, 0.8), jaw("b", 0.03, -0.8, 0.0, (0.0, 0.0, 1.0))),  # about other axes
        (jaw("a", -0.03, 0.0, 4.0), jaw("b", 0.03, -4.0, 0.0)),  # more than half a turn
        (jaw("a", -0.03, 0.0, 0.8), jaw("b", 0.03, -0.8, 0.0)._replace(type="prismatic")),
    ],
)
def test_a_fork_of_two_joints_that_do_not_close_is_no_gripper(left: JointFacts, right: JointFacts) -> None:
    assert names_of(anatomy(*ARM, left, right)) == ([], [["shoulder", "elbow", "wrist"], ["a"], ["b"]])


def test_two_legs_that_mirror_each_other_are_no_gripper() -> None:
    hips = [jaw("a", -0.03, 0.0, 0.8)._replace(above=None), jaw("b", 0.03, -0.8, 0.0)._replace(above=None)]
    assert names_of(anatomy(*hips)) == ([], [["a"], ["b"]])


@pytest.mark.parametrize(
    ("links", "tools"), [(2, [["l_gear", "l_finger", "r_gear", "r_finger"]]), (4, [["l_finger"], ["r_finger"]])]
)
def test_gears_that_carry_fingers_at_the_end_of_an_arm_are_a_hand_with_them(links: int, tools: list[list[str]]) -> None:
    sides: list[JointFacts] = []
    for side in "lr":
        names = [f"{side}_gear", *(f"{side}_bar_{n}" for n in range(links - 2)), f"{side}_finger"]
        sides += [turning(one, on) for one, on in zip(names, ["wrist", *names], strict=False)]
    assert names_of(anatomy(*ARM, *sides))[0] == tools


def led(name: str, above: str = "wrist") -> list[JointFacts]:
    """Return a joint, and one on it that follows it."""
    return [turning(name, above), turning(f"{name}_end", name, name)]


def test_fingers_on_one_link_whose_ends_follow_them_are_one_hand() -> None:
    parts = anatomy(*ARM, *led("a"), *led("b"), *led("c"))
    assert names_of(parts) == ([["a", "b", "c"]], [["shoulder", "elbow", "wrist"]])


def test_two_grippers_of_a_motor_and_a_follower_beside_it_remain_two() -> None:
    pairs = [turning("a", "wrist"), turning("b", "wrist", "a"), turning("c", "wrist"), turning("d", "wrist", "c")]
    assert names_of(anatomy(*ARM, *pairs))[0] == [["a"], ["c"]]


def test_joints_with_the_names_of_fingers_are_a_hand_beside_a_thumb_and_say_nothing_elsewhere() -> None:
    digits = [*finger("thumb", 2), *led("index", "wrist"), *led("middle", "wrist"), turning("ring", "wrist")]
    assert names_of(anatomy(*ARM, *digits))[0] == [["thumb_1", "thumb_2", "index", "middle", "ring"]]
    legs = [*finger("front", 3, "spine"), *finger("middle", 3, "spine")]
    assert names_of(anatomy(turning("spine"), *legs))[0] == []


SIX = ("pan", "tilt", "elbow", "roll", "bend", "turn")


@pytest.mark.parametrize(
    ("root", "joints"),
    [
        ([turning("axis")._replace(type="prismatic")], 6),
        ([turning("x")._replace(type="prismatic"), turning("y", "x")._replace(type="prismatic")], 6),
        ([turning("left_lift")], 6),
        ([turning("torso")], 5),
    ],
)
def test_a_lift_or_a_rail_below_an_arm_is_a_chain_of_its_own(root: list[JointFacts], joints: int) -> None:
    row = SIX[:joints]
    arm = [turning(name, above) for name, above in zip(row, (root[-1].name, *row), strict=False)]
    assert names_of(anatomy(*root, *arm))[1] == [[joint.name for joint in root], [*row]]


@pytest.mark.parametrize(
    ("root", "joints"),
    [
        ([turning("axis")._replace(type="prismatic")], 4),
        ([turning("shoulder_lift")], 6),
        ([turning("base")], 6),
    ],
)
def test_a_joint_at_the_root_of_an_arm_is_a_part_of_it(root: list[JointFacts], joints: int) -> None:
    row = SIX[:joints]
    arm = [turning(name, above) for name, above in zip(row, (root[-1].name, *row), strict=False)]
    assert names_of(anatomy(*root, *arm))[1] == [[root[0].name, *row]]
