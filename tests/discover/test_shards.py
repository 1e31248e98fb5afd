"""`urdfctl lint --shard K/N`: what several machines find is, put together, what one would find."""

from __future__ import annotations

import json
from pathlib import Path

import pytest
from corpus import CORPUS, needs_corpus
from folder import Folder
from sampling import sample

from urdfctl.discover.robots import DiscoveredFiles, discover_files
from urdfctl.discover.shards import Shard, grouped, shard, share
from urdfctl.errors import UserError

ROBOT = """\
<robot name="NAME" xmlns:xacro="http://www.ros.org/wiki/xacro">
  <xacro:include filename="INCLUDED"/>
  <link name="base"/>
  <link name="tip"/>
  <xacro:turning name="NAME"/>
</robot>
"""
LIBRARY = """\
<robot xmlns:xacro="http://www.ros.org/wiki/xacro">
  <xacro:macro name="turning" params="name">
    <joint name="${name}" type="sideways"><parent link="base"/><child link="tip"/></joint>
  </xacro:macro>
</robot>
"""
CONTROLLERS = "arm:\n  type: position_controllers/JointPositionControler\n  joint: elbow\n"
LAUNCH = """\
<launch>
  <param name="robot_description" command="xacro $(find two)/urdf/two.xacro"/>
  <rosparam command="load" file="$(find two)/config/arm.yaml"/>
</launch>
"""


def robot(name: str, included: str) -> str:
    return ROBOT.replace("NAME", name).replace("INCLUDED", included)


def package(name: str) -> str:
    return f"<package><name>{name}</name></package>"


FILES = {
    ".git/HEAD": "",
    "one/package.xml": package("one"),
    "one/urdf/one.xacro": robot("one", "$(find shared)/lib.xacro"),
    "two/package.xml": package("two"),
    "two/urdf/two.xacro": robot("two", "$(find shared)/lib.xacro"),
    "two/config/arm.yaml": CONTROLLERS,
    "two/launch/two.launch": LAUNCH,
    "shared/package.xml": package("shared"),
    "shared/lib.xacro": LIBRARY,
    "three/package.xml": package("three"),
    "three/urdf/three.xacro": robot("three", "lib/turning.xacro"),
    "three/urdf/lib/turning.xacro": LIBRARY + "<!-- urdfctl: ignore[UC105] nothing is here -->\n",
    "four/four.urdf": "<robot name='four'><link name='base'/><link name='base'/><joint/></robot>",
    "five/arm.yaml": CONTROLLERS,
}


def found_by(folder: Folder, *words: str) -> list[object]:
    ran = folder.run("lint", ".", "--format", "json", "--exit-zero", "--distro", "noetic", "--jobs", "1", *words)
    assert ran.returncode == 0, ran.stderr
    return list(json.loads(ran.stdout)["findings"])


@pytest.mark.parametrize("of", sample([2, 1, 7, 3], 2))
def test_the_shares_together_find_what_one_run_finds(folder: Folder, of: int) -> None:
    folder.write(FILES)
    shares = [found_by(folder, "--shard", f"{number}/{of}") for number in range(1, of + 1)]
    whole = [json.dumps(finding) for finding in found_by(folder)]
    assert sorted(json.dumps(finding) for share in shares for finding in share) == sorted(whole)
    assert sum(1 for share in shares if share) == min(of, 4)


@pytest.mark.parametrize("format_", sample(["text", "json", "sarif", "junit"], 2))
def test_it_changes_nothing_how_many_robots_are_looked_at_at_once(folder: Folder, format_: str) -> None:
    folder.write(FILES)
    one = folder.run("lint", ".", "--jobs", "1", "--format", format_).stdout
    assert one
    assert folder.run("lint", ".", "--jobs", "2", "--format", format_).stdout == one


@pytest.mark.parametrize(
    ("naming", "named", "other"),
    [
        ("a/r.xacro", '<robot><xacro:include filename="lib/x.xacro"/></robot>', "a/lib/x.xacro"),
        ("a/r.xacro", '<robot><xacro:include filename="../b/x.xacro"/></robot>', "b/x.xacro"),
        ("a/r.xacro", '<robot><xacro:include filename="$(find b)/urdf/x.xacro"/></robot>', "b/urdf/x.xacro"),
        ("a/r.xacro", '<robot><xacro:include filename="$(find b)/x.xacro"/></robot>', "b/description/x.xacro"),
        ("a/r.xacro", '<robot><xacro:include filename="$(find b)/${kind}.xacro"/></robot>', "b/x.xacro"),
        ("a/r.xacro", '<robot><xacro:include filename="${folder}/x.xacro"/></robot>', "b/x.xacro"),
        ("a/r.xacro", "<robot><p value=\"${load_yaml('../b/x.yaml')}\"/></robot>", "b/x.yaml"),
        ("a/r.launch", '<launch><include file="$(find b)/x.launch"/></launch>', "b/x.launch"),
        ("a/r.launch", '<launch><param command="xacro $(arg robot)"/><arg default="x.urdf"/></launch>', "b/x.urdf"),
        ("a/r_launch.py", "robot = os.path.join(get('b'), 'urdf', 'x.xacro')", "b/urdf/x.xacro"),
        ("a/r.yaml", "robot: package://b/x.urdf", "b/x.urdf"),
    ],
)
def test_files_stay_together_that_one_may_read_from_the_other(
    folder: Folder, naming: str, named: str, other: str
) -> None:
    folder.write(
        {"a/package.xml": package("a"), "b/package.xml": package("b"), naming: named, other: "<robot/>", "b/y.xml": ""}
    )
    paths = [str(folder.path / path) for path in (naming, other, "b/y.xml")]
    assert sorted(grouped(paths)) == sorted([sorted(paths[:2]), paths[2:]])


def test_files_stay_together_that_read_the_same_file_which_no_run_looks_at(folder: Folder) -> None:
    one, two = '<robot><xacro:include filename="x.gazebo"/></robot>', '<robot><p yaml="x.gazebo"/></robot>'
    folder.write({"one.xacro": one, "two.xacro": two, "x.gazebo": "<robot/>", "three.xacro": "<robot/>"})
    assert [[Path(path).name for path in group] for group in grouped(["one.xacro", "two.xacro", "three.xacro"])] == [
        ["one.xacro", "two.xacro"],
        ["three.xacro"],
    ]


def test_files_stay_together_that_want_the_same_file_which_is_not_there(folder: Folder) -> None:
    text = '<robot><xacro:include filename="$(find gone)/x.xacro"/></robot>'
    folder.write({"a/one.xacro": text, "b/two.xacro": text})
    assert len(grouped(["a/one.xacro", "b/two.xacro"])) == 1


def test_a_comment_ties_nothing(folder: Folder) -> None:
    folder.write(
        {"one.xacro": '<robot><!-- <xacro:include filename="two.xacro"/> --></robot>', "two.xacro": "<robot/>"}
    )
    assert len(grouped(["one.xacro", "two.xacro"])) == 2


def test_what_is_named_beside_a_single_robot_stays_with_it(folder: Folder) -> None:
    folder.write({"arm.urdf": "<robot/>", "arm.yaml": CONTROLLERS})
    found = discover_files(["arm.urdf", "arm.yaml"])
    sizes = sorted(len(share(found, Shard(number, 2))) for number in (1, 2))
    assert sizes == [0, 2]


def test_a_share_of_nothing_is_nothing() -> None:
    assert share(DiscoveredFiles(), Shard(1, 3)) == set()


@needs_corpus
def test_each_file_of_the_corpus_is_in_one_share_and_the_shares_are_alike() -> None:
    folders = [str(path) for path in sorted(CORPUS.iterdir()) if path.is_dir()]
    found = discover_files(sample(folders, 8))
    shares = [share(found, Shard(number, 3)) for number in (1, 2, 3)]
    everything = {str(Path(path).absolute()) for path in found.paths()}
    assert set().union(*shares) == everything
    assert sum(map(len, shares)) == len(everything)
    assert max(map(len, shares)) < 2 * min(map(len, shares))


@pytest.mark.parametrize("text", ["", "3", "0/2", "3/2", "1/0", "a/b", "1/2/3", "-1/2", "1/1001", "²/3"])
def test_what_is_no_share_is_refused(text: str) -> None:
    with pytest.raises(UserError, match="--shard must be K/N"):
        shard(text)


def test_a_baseline_is_not_written_from_a_share(folder: Folder) -> None:
    folder.write(FILES)
    ran = folder.run("lint", ".", "--shard", "1/2", "--write-baseline", "known.json")
    expected = "urdfctl: --write-baseline requires the whole run and cannot be used with --shard\n"
    assert (ran.returncode, ran.stderr) == (2, expected)


def test_the_shares_of_what_is_shown_are_all_of_it(folder: Folder) -> None:
    robot = '<robot name="{}"><link name="a"/><link name="b"/></robot>'
    folder.write({f"{name}.urdf": robot.format(name) for name in "stuvw"})
    shares = [folder.run("show", ".", "--shard", f"{number}/2").stdout for number in (1, 2)]
    assert all(shares)
    assert sorted("".join(shares).splitlines()) == sorted(folder.run("show", ".").stdout.splitlines())
