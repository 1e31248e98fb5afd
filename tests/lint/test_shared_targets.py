"""Targets that share a robot are expanded and judged once, and their findings are those of a run alone."""

from __future__ import annotations

from typing import Any

import pytest
from folder import Folder

from urdfctl.config.settings import Settings
from urdfctl.lint.selection import Selection
from urdfctl.lint.target import lint_target
from urdfctl.load import known
from urdfctl.load.loader import Loader
from urdfctl.load.target import Target
from urdfctl.source.same import is_same
from urdfctl.source.span import Place, SourceText

ROBOT = """\
<robot name="r" xmlns:xacro="http://www.ros.org/wiki/xacro">
  <xacro:arg name="tip" default="tip"/>
  <link name="base"/>
  <link name="$(arg tip)"/>
  <joint name="j" type="revolute"><parent link="base"/><child link="$(arg tip)"/></joint>
</robot>
"""
LAUNCH = """\
<launch>
  <param name="robot_description" command="xacro $(dirname)/r.xacro tip:={tip}"/>
  <rosparam command="load" file="$(dirname)/c.yaml"/>
  <node pkg="controller_manager" type="spawner" name="s" args="{spawned}"/>
</launch>
"""
CONTROLLERS = "arm: {type: position_controllers/JointPositionController, joint: k}\n"


@pytest.fixture
def expanded(monkeypatch: pytest.MonkeyPatch) -> list[str]:
    """The descriptions that are expanded from now on."""
    paths: list[str] = []
    expand = known.expanded

    def noted(make: Any, path: str, arguments: Any, **options: Any) -> Any:
        paths.append(path.rpartition("/")[2])
        return expand(make, path, arguments, **options)

    monkeypatch.setattr(known, "expanded", noted)
    return paths


def write(folder: Folder, launches: dict[str, str]) -> None:
    folder.write({"r.xacro": ROBOT, "c.yaml": CONTROLLERS, **launches})


def test_launch_files_with_the_same_robot_expand_it_once(folder: Folder, expanded: list[str]) -> None:
    write(folder, {f"{n}.launch": LAUNCH.format(tip="tip", spawned=name) for n, name in enumerate(("arm", "leg"))})
    loader = Loader(Settings())
    together = [lint_target(loader, Target(f"{n}.launch"), Selection()).result for n in range(2)]
    assert expanded == ["r.xacro"]
    alone = [lint_target(Loader(Settings()), Target(f"{n}.launch"), Selection()).result for n in range(2)]
    assert together == alone
    found = [{finding.code for finding in result.outcome.diagnostics} for result in together]
    assert "UC123" in found[0] & found[1], "of the robot: reported in both"
    assert found[0] != found[1], "only one of them spawns a controller that does not exist"


def test_other_arguments_make_another_robot(folder: Folder, expanded: list[str]) -> None:
    write(folder, {f"{tip}.launch": LAUNCH.format(tip=tip, spawned="arm") for tip in ("tip", "hand")})
    loader = Loader(Settings())
    links = [
        [link.name for link in project.robot.links]
        for tip in ("tip", "hand")
        if (project := loader.load(Target(f"{tip}.launch")).project).robot
    ]
    assert links == [["base", "tip"], ["base", "hand"]]
    assert expanded == ["r.xacro", "r.xacro"]


def test_files_read_for_one_target_are_not_those_of_the_next(folder: Folder) -> None:
    write(folder, {"a.launch": LAUNCH.format(tip="tip", spawned="arm")})
    loader = Loader(Settings())
    assert [path.rpartition("/")[2] for path in loader.load(Target("a.launch")).sources] == [
        "r.xacro",
        "c.yaml",
        "a.launch",
    ]
    assert [path.rpartition("/")[2] for path in loader.load(Target("r.xacro")).sources] == ["r.xacro"]


def test_no_rule_runs_on_a_target_that_reads_nothing_in_focus(folder: Folder) -> None:
    write(folder, {"a.launch": LAUNCH.format(tip="tip", spawned="leg")})
    read, other = (str(folder.path / name) for name in ("r.xacro", "other.xacro"))
    for focus, is_linted in (((read,), True), ((other,), False), ((other, str(folder.path)), True), ((), True)):
        result = lint_target(Loader(Settings()), Target("a.launch"), Selection(), focus=focus).result
        assert bool(result.outcome.diagnostics) == is_linted, focus
        assert len(result.files) == 3


def test_values_are_the_same_if_they_are_made_of_the_same_texts_and_places() -> None:
    source, number = SourceText("a", b"abc"), 1.5
    place = Place(source, 0, end=1)
    assert is_same((place, "x", (number,)), (Place(source, 0, end=1), "x", (1.5,)))
    for other in ((Place(source, 0, end=2), "x"), (Place(SourceText("a", b"abc"), 0, end=1), "x"), (place, "y")):
        assert not is_same((place, "x"), other)
    assert not is_same((1,), (True,))
    assert not is_same({"a": 1}, {"a": 1}), "a dictionary is the same only if it is the same object"
