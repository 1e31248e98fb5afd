"""The configuration of MoveIt that is written, what a person changed in it, and whether it plans."""

from __future__ import annotations

import math
import random
from pathlib import Path

import pytest
import yaml
from folder import Folder
from generating import command
from planned_arm import INERTIAL, JAZZY, ROW, arm, mechanism, semantic

from urdfctl.model.robot.build_robot import robot_of
from urdfctl.smoke.robot import shapes_of
from urdfctl.smoke.statics.overlaps import overlapping
from urdfctl.source.span import SourceText
from urdfctl.source.xml.parsing import parse

pytest.importorskip("mujoco")


def texts_in(folder: Folder) -> dict[str, str]:
    """Return the text of each file in the package."""
    return {str(path): path.read_text() for path in Path(folder.path, "out").rglob("*") if path.is_file()}


@pytest.fixture(name="written")
def _written(folder: Folder) -> Folder:
    folder.write({"six.urdf": arm()})
    assert command("gen-moveit", "six.urdf", *JAZZY).returncode == 0
    return folder


def test_a_chain_ends_at_its_hand_and_the_hand_is_its_end_effector(written: Folder) -> None:
    root = semantic(written)
    groups = {group.get("name"): [dict(part.attrib) for part in group] for group in root.findall("group")}
    assert groups == {
        "arm": [{"base_link": "base_link", "tip_link": "hand"}],
        "gripper": [{"name": "left_finger_joint"}, {"name": "right_finger_joint"}],
    }
    [effector] = root.findall("end_effector")
    assert effector.attrib == {"name": "gripper", "parent_link": "hand", "group": "gripper", "parent_group": "arm"}
    poses = {
        pose.get("name"): {part.get("name"): part.get("value") for part in pose} for pose in root.findall("group_state")
    }
    assert poses == {
        "home": {name: "0" for name, _, _ in ROW},
        "open": {"left_finger_joint": "0.04"},
        "close": {"left_finger_joint": "0"},
    }


def test_a_joint_whose_limits_allow_no_motion_is_within_a_chain_as_a_fixed_one_is(folder: Folder) -> None:
    still = '<joint name="tool" type="revolute"><limit lower="0" upper="0" effort="1" velocity="1"/><axis xyz="1 0 0"/>'
    folder.write({"six.urdf": arm().replace('<joint name="tool" type="fixed">', still)})
    assert command("gen-moveit", "six.urdf", *JAZZY).returncode == 0
    root = semantic(folder)
    assert [chain.attrib for chain in root.findall("group/chain")] == [{"base_link": "base_link", "tip_link": "hand"}]
    assert [one.get("parent_link") for one in root.findall("end_effector")] == ["hand"]
    assert [one.get("name") for one in root.findall("passive_joint")] == ["tool"]
    assert command("lint", "out", "--fail-on", "warning").returncode == 0


@pytest.mark.parametrize(
    ("distro", "simulator"),
    [
        ("noetic", "none"),
        ("noetic", "gazebo-classic"),
        ("humble", "gz"),
        ("jazzy", "none"),
        ("kilted", "none"),
        ("rolling", "gz"),
    ],
)
def test_what_is_written_has_no_errors_and_is_up_to_date_at_once(folder: Folder, distro: str, simulator: str) -> None:
    folder.write({"six.urdf": arm()})
    words = ("gen-moveit", "six.urdf", "--distro", distro, "--simulator", simulator, "--samples", "100", "-o", "out")
    assert command(*words).returncode == 0
    before = texts_in(folder)
    assert command("lint", "out", "--fail-on", "warning").returncode == 0
    [started] = Path("out/launch").glob("moveit.launch*")
    assert command("lint", str(started), "--fail-on", "warning").returncode == 0
    assert command(*words).returncode == 0
    assert command("gen-check", "out") == (0, "", "")
    assert texts_in(folder) == before


def test_a_shape_without_a_size_is_tested_as_the_point_that_it_is_for_moveit(folder: Folder) -> None:
    folder.write({"six.urdf": arm().replace('<box size="0.04 0.2 0.02"/>', '<box size="0 0 0"/>')})
    assert command("gen-moveit", "six.urdf", *JAZZY).returncode == 0
    pairs = {frozenset((one.get("link1"), one.get("link2"))) for one in semantic(folder).findall("disable_collisions")}
    assert frozenset(("turn_link", "hand")) in pairs


def on_a_lift(*more: str) -> str:
    """Return the arm on a link that slides, beside a head and `more`."""
    limit = '<limit lower="0" upper="0.4" effort="900" velocity="1"/>'
    head = f"""<link name="foot">{INERTIAL}</link><link name="head">{INERTIAL}</link>
  <joint name="torso_lift" type="prismatic"><parent link="foot"/><child link="base_link"/>
    <axis xyz="0 0 1"/>{limit}</joint>
  <joint name="head_pan" type="revolute"><parent link="base_link"/><child link="head"/>
    <axis xyz="0 0 1"/>{limit}</joint>"""
    return arm().replace("</robot>", "".join((head, *more, "</robot>")))


def test_an_arm_on_a_lift_is_a_group_alone_and_with_it(folder: Folder) -> None:
    folder.write({"six.urdf": on_a_lift()})
    assert command("gen-moveit", "six.urdf", *JAZZY).returncode == 0
    chains = {one.get("name"): dict(one[0].attrib) for one in semantic(folder).findall("group")}
    assert chains["arm"] == {"base_link": "base_link", "tip_link": "hand"}
    assert chains["arm_with_torso"] == {"base_link": "foot", "tip_link": "hand"}
    assert command("lint", "out", "--fail-on", "warning").returncode == 0


def test_two_arms_on_a_lift_are_no_groups_with_it(folder: Folder) -> None:
    links = [f'<link name="l{n}">{INERTIAL}</link>' for n in range(5)]
    joints = [
        f"""<joint name="other_{n}" type="revolute"><parent link="{f"l{n - 1}" if n else "base_link"}"/>
        <child link="l{n}"/><axis xyz="0 {n % 2} {1 - n % 2}"/>
        <limit lower="-1" upper="1" effort="9" velocity="1"/></joint>"""
        for n in range(5)
    ]
    folder.write({"six.urdf": on_a_lift(*links, *joints)})
    assert command("gen-moveit", "six.urdf", *JAZZY).returncode == 0
    assert not [one.get("name") for one in semantic(folder).findall("group") if "_with_" in (one.get("name") or "")]


def test_a_controller_does_not_take_the_name_of_a_joint(folder: Folder) -> None:
    folder.write({"six.urdf": arm().replace("left_finger_joint", "gripper_controller")})
    assert command("gen-moveit", "six.urdf", *JAZZY).returncode == 0
    listed = yaml.safe_load(Path("out/config/moveit_controllers.yaml").read_text())["moveit_simple_controller_manager"]
    assert listed["controller_names"] == ["arm_controller", "gripper_motion_controller"]
    assert listed["gripper_motion_controller"]["joints"] == ["gripper_controller"]
    assert command("lint", "out", "--fail-on", "warning").returncode == 0


def test_a_package_does_not_hide_that_of_the_robot_which_it_includes(folder: Folder) -> None:
    manifest = '<package format="3"><name>six</name><version>1.0.0</version><description>d</description></package>'
    folder.write({"src/six/urdf/six.urdf": arm(), "src/six/package.xml": manifest})
    words = ("gen-moveit", "src/six/urdf/six.urdf", "--distro", "jazzy", "--samples", "1")
    ran = command(*words, "-o", "src/more/six")
    said = "'src/more/six' would be a second package 'six' beside the robot's own"
    assert (ran.returncode, ran.stderr.splitlines()[-1]) == (
        2,
        f"urdfctl: {said}: write to another folder, or name it with --package",
    )
    assert not Path("src/more").exists()
    assert command(*words, "-o", "src/six_moveit").returncode == 0
    assert command(*words, "-o", "src/more/six", "--package", "six_plans").returncode == 0


def test_in_noetic_the_robot_moves_without_hardware_or_in_its_simulator(folder: Folder) -> None:
    folder.write({"six.urdf": arm()})
    words = ("gen-moveit", "six.urdf", "--distro", "noetic", "--samples", "10", "-o", "out")
    assert command(*words).returncode == 0
    launch = Path("out/launch/moveit.launch").read_text()
    assert 'unless="$(arg fake)"' in launch
    fakes = yaml.safe_load(Path("out/config/fake_controllers.yaml").read_text())
    assert [one["joints"] for one in fakes["controller_list"]] == [[name for name, _, _ in ROW], ["left_finger_joint"]]
    assert fakes["initial"] == [{"group": "arm", "pose": "home"}, {"group": "gripper", "pose": "open"}]
    real = yaml.safe_load(Path("out/config/moveit_controllers.yaml").read_text())["controller_list"]
    assert [one["action_ns"] for one in real] == ["follow_joint_trajectory", "gripper_cmd"]
    pilz = yaml.safe_load(Path("out/config/pilz_industrial_motion_planner_planning.yaml").read_text())
    assert pilz["planning_plugin"] == "pilz_industrial_motion_planner::CommandPlanner"
    assert command(*words, "--force", "--simulator", "gazebo-classic").returncode == 0
    assert "fake" not in Path("out/launch/moveit.launch").read_text()


def test_gen_all_writes_the_same_files_beside_its_own(written: Folder) -> None:
    assert command("gen-all", "six.urdf", "--moveit", *JAZZY[:-1], "all").returncode == 0
    ours, theirs = Path(written.path, "all"), Path(written.path, "out")
    assert {path.relative_to(ours) for path in ours.rglob("*")} == {
        path.relative_to(theirs) for path in theirs.rglob("*")
    }
    pair = [Path(folder, "config/six.srdf").read_text().splitlines() for folder in (ours, theirs)]
    assert pair[0][2:] == pair[1][2:]


def test_no_pair_that_never_touches_overlaps_in_other_poses(written: Folder) -> None:
    pairs = {frozenset((one.get("link1"), one.get("link2"))) for one in semantic(written).findall("disable_collisions")}
    root = parse(SourceText("six.urdf", arm().encode())).documentElement
    assert root is not None
    robot, chance = robot_of(root), random.Random(7)  # noqa: S311 (it samples poses)
    found = mechanism()
    met = set()
    for _ in range(50):
        positions = {hinge.name: chance.uniform(*hinge.span) for hinge in found.hinges if hinge.moves}
        met |= {frozenset(pair) for pair in overlapping(found, shapes_of(robot, lambda _: None), positions)}
    assert met
    assert not met & pairs
    assert frozenset(("base_link", "hand")) not in pairs


def test_each_pose_in_reach_is_solved_within_the_written_limits(written: Folder) -> None:
    """Damped least squares from the written chain: what MoveIt's solver does."""
    numpy = pytest.importorskip("numpy")
    [chain] = semantic(written).findall("group/chain")
    found, names = mechanism(), [name for name, _, _ in ROW]
    limits = yaml.safe_load(Path(written.path, "out/config/joint_limits.yaml").read_text())["joint_limits"]
    assert {*names} < {*limits}
    tip = chain.get("tip_link") or ""

    def place(angles: object) -> object:
        pose = found.poses(dict(zip(names, angles, strict=True)))[tip]  # type: ignore[call-overload]
        return numpy.array([*pose.place, *(part for row in pose.turn for part in row)])

    chance = random.Random(3)  # noqa: S311 (it samples poses)
    for _ in range(5):
        goal_angles = numpy.array([chance.uniform(-1.5, 1.5) for _ in names])
        goal, angles = place(goal_angles), goal_angles + numpy.array([chance.uniform(-0.3, 0.3) for _ in names])
        for _ in range(60):
            here = place(angles)
            slope = numpy.array([(place(angles + 1e-6 * row) - here) / 1e-6 for row in numpy.eye(6)]).T
            angles = angles + numpy.linalg.solve(slope.T @ slope + 1e-6 * numpy.eye(6), slope.T @ (goal - here))
        assert numpy.abs(place(angles) - goal).max() < 1e-3
        assert numpy.abs(angles).max() < math.pi


def test_the_controllers_of_the_demo_start_and_move(written: Folder) -> None:
    ran = command("smoke", "out")
    assert (ran.returncode, ran.stdout.splitlines()[-1]) == (0, "3 controllers: 3 passed")


def test_what_a_person_changed_is_kept_and_said(written: Folder) -> None:
    path = Path(written.path, "out/config/six.srdf")
    own = """  <group_state name="work" group="arm"><joint name="elbow" value="1"/></group_state>
  <group_state name="old" group="arm"><joint name="gone" value="1"/></group_state>
  <disable_collisions link1="base_link" link2="elbow_link" reason="a cover is between them"/>
</robot>"""
    text = path.read_text().replace('<joint name="elbow" value="0"/>', '<joint name="elbow" value="0.5"/>')
    path.write_text(text.replace("</robot>", own))
    assert "exists; --force overwrites it" in command("gen-moveit", "six.urdf", *JAZZY).stderr
    ran = command("gen-moveit", "six.urdf", *JAZZY, "--force")
    assert ran.stderr.splitlines()[:4] == [
        "urdfctl: kept the pose 'home' of 'arm' of 'out/config/six.srdf'",
        "urdfctl: kept the pose 'work' of 'arm' of 'out/config/six.srdf'",
        "urdfctl: kept the pair base_link, elbow_link (a cover is between them) of 'out/config/six.srdf'",
        "urdfctl: left out the pose 'old' of 'arm': the robot has no joint 'gone'",
    ]
    assert '<joint name="elbow" value="0.5"/>' in path.read_text()
    assert command("gen-check", "out") == (0, "", "")


def test_without_fcl_meshes_are_hulls_which_is_said_and_with_it_nothing_is(
    folder: Folder, monkeypatch: pytest.MonkeyPatch
) -> None:
    pytest.importorskip("fcl")
    corners = "".join(f"v {x} {y} {z}\n" for x in (0, 1) for y in (0, 1) for z in (0, 1))
    faces = "".join(
        f"f {a} {b} {c}\n" for a, b, c in ((1, 2, 3), (1, 5, 2), (1, 3, 5), (8, 7, 6), (8, 6, 4), (8, 4, 7))
    )
    mesh = arm().replace('<box size="0.04 0.2 0.02"/>', '<mesh filename="hand.obj" scale="0.04 0.2 0.02"/>')
    folder.write({"six.urdf": mesh, "hand.obj": corners + faces})
    said = "meshes are tested for collisions as their convex hulls, which touch more often (hand)"
    assert said not in command("gen-moveit", "six.urdf", *JAZZY).stderr
    monkeypatch.setattr("urdfctl.smoke.engines.contacts.tests_surfaces", lambda: False)
    assert said in command("gen-moveit", "six.urdf", *JAZZY, "--force").stderr


@pytest.mark.parametrize(
    ("words", "said"),
    [
        (("--group", "arm=base_link:hnd"), "--group arm: the robot has no link 'hnd'; did you mean 'hand'?"),
        (("--group", "arm=hand:base_link"), "--group arm: no chain leads from 'hand' to 'base_link'"),
        (("--group", "arm=tool0:hand"), "--group arm: no joint moves between 'tool0' and 'hand'"),
        (("--group", "arm=pan,tilt"), "--group arm: the robot has no joint 'tilt'"),
        (("--group", "arm"), "--group must be NAME=BASE:TIP or NAME=JOINT,JOINT, not 'arm'"),
        (("--namespace", "one"), "MoveIt's configuration has no namespace; leave out --namespace"),
        (
            ("--type", "velocity"),
            "no controller of the robot is one that MoveIt uses: it needs --type trajectory or gripper",
        ),
        (
            ("--distro", "melodic"),
            "melodic has not the MoveIt that is written for; use noetic, humble or a later distro",
        ),
    ],
)
def test_what_is_asked_wrongly_is_one_line_and_writes_nothing(
    folder: Folder, words: tuple[str, ...], said: str
) -> None:
    folder.write({"six.urdf": arm()})
    ran = command("gen-moveit", "six.urdf", *JAZZY, "--samples", "1", *words)
    assert (ran.returncode, ran.stderr.splitlines()[-1]) == (2, f"urdfctl: {said}")
    assert not Path(folder.path, "out").exists()


NO_TREE = "the links of the robot form no tree with one root"
NOT_WHOLE = "MoveIt needs a whole robot, and this one cannot be expanded"


@pytest.mark.parametrize(
    ("robot", "said"),
    [
        (arm('lower="-1"').replace('lower="-1"', ""), "joint 'pan' has no position limits, which planning needs"),
        (
            arm().replace('<box size="0.04 0.2 0.02"/>', '<mesh filename="gone.stl"/>'),
            "the collision geometry of link 'hand' cannot be tested: 'gone.stl' was not found",
        ),
        (
            arm().replace('<box size="0.04 0.2 0.02"/>', '<box size="0.04 -0.2 0.02"/>'),
            "the collision geometry of link 'hand' cannot be tested: its box has no positive size",
        ),
        (
            arm().replace('<link name="tool0"/>', '<link name="tool0"/><link name="lost"/>'),
            f"{NO_TREE}: no joint carries 'base_link' or 'lost'",
        ),
        (
            arm().replace('<parent link="hand"/>', '<parent link="palm"/>'),
            f"{NO_TREE}: joint 'left_finger_joint' connects link 'palm', which is not defined",
        ),
        (
            arm().replace(
                '<robot name="six">', '<robot name="six" xmlns:xacro="http://ros.org/wiki/xacro"><xacro:hand/>'
            ),
            f"{NOT_WHOLE}: six.urdf:1: macro 'hand' is called before it is defined",
        ),
        ("<sdf version='1.9'/>", "the description has no links: it is no robot"),
    ],
)
def test_a_robot_that_cannot_be_planned_for_is_one_line_and_writes_nothing(
    folder: Folder, robot: str, said: str
) -> None:
    folder.write({"six.urdf": robot})
    ran = command("gen-moveit", "six.urdf", *JAZZY)
    assert (ran.returncode, ran.stderr.splitlines()[-1]) == (2, f"urdfctl: {said}")
    assert not Path(folder.path, "out").exists()


@pytest.mark.parametrize(
    ("words", "said"),
    [
        (("--form", "toml"), "--form must be one of python, xml, yaml, not 'toml'"),
        (("--group", "arm=base_link:hnd"), "--group arm: the robot has no link 'hnd'; did you mean 'hand'?"),
        ((), "MuJoCo is not installed, which tests the links for collisions: pip install 'urdfctl[smoke]'"),
    ],
)
def test_what_is_asked_wrongly_is_said_before_mujoco_is_asked_for(
    folder: Folder, monkeypatch: pytest.MonkeyPatch, words: tuple[str, ...], said: str
) -> None:
    folder.write({"six.urdf": arm()})
    monkeypatch.setattr("urdfctl.smoke.engines.contacts.installed", lambda: ())
    ran = command("gen-moveit", "six.urdf", *JAZZY, *words)
    assert (ran.returncode, ran.stderr.splitlines()[-1]) == (2, f"urdfctl: {said}")
    assert not Path(folder.path, "out").exists()


MISSING_GROUP = "UC660 group 'own' refers to group 'arms', which the SRDF does not define; did you mean 'arm'?"


@pytest.mark.parametrize(
    ("kept", "said"),
    [
        (
            '<group name="own"><group name="arms"/></group>',
            f"{MISSING_GROUP}\nurdfctl: nothing was written, because this robot could not be planned for",
        ),
        ('<group name="own"><chain base_link="base_link" tip_link="hand"/></group>', ""),
    ],
)
def test_what_a_person_wrote_is_linted_with_the_rest_before_anything_is_written(
    kept: str, said: str, folder: Folder
) -> None:
    folder.write({"six.urdf": arm(), "out/config/six.srdf": f'<robot name="six">{kept}</robot>'})
    ran = command("gen-moveit", "six.urdf", *JAZZY, *(() if said else ("--force",)))
    assert ran.returncode == bool(said), ran.stderr
    assert said in ran.stderr
    assert Path("out/config/kinematics.yaml").exists() is not bool(said)
