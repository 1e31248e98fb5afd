"""Every root of the corpus expands to what xacro itself writes, or its problem is told where it stands."""

from __future__ import annotations

from collections import Counter
from functools import lru_cache
from itertools import groupby
from pathlib import Path
from typing import Any

import plain_xacro
import pytest
from corpus import CORPUS, needs_corpus, own_roots, roots, workspace_of
from sampling import sample

from urdfctl.expand.xml_writer import write
from urdfctl.source.disk.files import Files
from urdfctl.source.problem import Problem
from urdfctl.source.workspaces.packages import PackageIndex, Packages
from urdfctl.source.xacro.expanded import Expansion
from urdfctl.source.xacro.expansion import Expander

REPOSITORIES: dict[str, list[dict[str, Any]]] = {
    name: list(of_it) for name, of_it in groupby(roots(), lambda root: str(root["path"]).partition("/")[0])
}
FAILING = [name for name, of_it in REPOSITORIES.items() if not all(root["expands"] for root in of_it)]
NOT_DEFINED = "is not defined: no <xacro:property>, parameter or argument has this name here"
PLACES = {
    "Kinovarobotics__ros2_kortex/kortex_description/robots/gen3_robotiq_2f_85.xacro": (
        "gen3_robotiq_2f_85.xacro:23:12 the macro has no parameter 'sim'"
    ),
    "Kinovarobotics__ros2_kortex/kortex_description/robots/gen3_lite_gen3_lite_2f.xacro": (
        "kortex_robot.xacro:58:16 the macro has no parameter 'gripper'"
    ),
    "RafBerkvens__ua_ros_p3dx/p3dx_description/urdf/pioneer3dx.xacro": f"pioneer3dx.gazebo:29:7 'ns' {NOT_DEFINED}",
    "caesar753__braccio_moveit_gazebo_noetic/braccio_description/urdf/braccio_model.urdf": (
        "braccio_model.urdf:22:9 tag </inertial is not closed before the next '<'"
    ),
    "cambel__ur3/ur_hande_moveit_config/config/ur3e.urdf": ("ur3e.urdf:777:1 text after the end of the root element"),
    "grassjelly__linorobot/urdf/linorobot.urdf": (
        "linorobot.urdf:1:2 the XML declaration <?xml ...?> is not at the start of the file"
    ),
    "chvmp__champ/champ_description/urdf/champ.urdf.xacro": (
        "accessories.urdf.xacro:5:9 package 'hector_sensors_description' was not found in this workspace"
    ),
    "davetcoleman__clam/clam_description/urdf/clam.xacro": f"clam.xacro:41:39 'M_PI' {NOT_DEFINED}",
    "ros-industrial__motoman/motoman_es_support/urdf/es165.xacro": (
        "es165_macro.xacro:176:84 'ros-industrial__motoman/motoman_es_support/urdf/' is a folder, not a file"
    ),
    "grahas__parol6_ros2_control/parol6_bringup/urdf/parol6_with_tools.xacro": (
        "parol6_with_tools.xacro:20:3 package 'parol6' was not found in this workspace"
    ),
    "Xiaochen98__robot_arm_ros2/dofbot_pro_ws/src/dofbot_pro_moveit/config/DOFBOT_Pro-V24.urdf.xacro": (
        "DOFBOT_Pro-V24.urdf.xacro:6:5 package 'dofbot_pro_description' was not found in this workspace; "
        "did you mean 'diffbot_description'?"
    ),
}
"""Looked up by hand: where some of the roots that do not expand fail, and why."""


@lru_cache(3)
def index(workspace: Path) -> PackageIndex:
    return PackageIndex(str(workspace), environ={})


def path_and_arguments(root: dict[str, Any]) -> tuple[str, dict[str, str]]:
    return str(CORPUS / root["path"]), {name: str(value) for name, value in (root.get("args") or {}).items()}


def expansion(root: dict[str, Any], *, strict: bool) -> Expansion:
    path, arguments = path_and_arguments(root)
    workspace = workspace_of(root)
    packages = Packages(path, index(workspace))
    return Expander(Files([str(workspace)], packages.source_of), packages, {}, strict=strict).expand(path, arguments)


def is_as_xacro_writes_it(root: dict[str, Any]) -> bool:
    path, arguments = path_and_arguments(root)
    document = expansion(root, strict=True).document
    return document is not None and write(document, path) == plain_xacro.expand(
        path, Packages(path, index(workspace_of(root))), arguments
    )


def is_in_a_real_line(problem: Problem) -> bool:
    path = Path(problem.at.source.path)
    position = problem.at.source.position(problem.at.span.start)
    lines = path.read_text(encoding="utf-8", errors="replace").splitlines() if path.is_file() else []
    return position.line <= len(lines) and position.column <= len(lines[position.line - 1]) + 1


@pytest.mark.parametrize("root", own_roots(), ids=lambda root: root["id"])
def test_our_own_robots_expand_as_the_index_says(root: dict[str, Any]) -> None:
    found = expansion(root, strict=True)
    assert found.complete == root["expands"]
    if root["expands"]:
        assert found.document is not None
        assert found.document.documentElement is not None
        tags = Counter(element.tagName for element in found.document.documentElement.elements())
        assert {"links": tags["link"], "joints": tags["joint"]} == root["counts"]
        assert is_as_xacro_writes_it(root)
    else:
        assert found.problems
        assert [problem for problem in found.problems if not is_in_a_real_line(problem)] == []


@needs_corpus
@pytest.mark.parametrize("repository", sample(REPOSITORIES, 9))
def test_what_expands_is_byte_for_byte_what_xacro_writes(repository: str) -> None:
    expanding = [root for root in REPOSITORIES[repository] if root["expands"]]
    assert [root["path"] for root in expanding if not is_as_xacro_writes_it(root)] == []


@needs_corpus
@pytest.mark.parametrize("repository", sample(FAILING, 4))
def test_what_does_not_expand_has_a_problem_in_a_real_line(repository: str) -> None:
    failing = [root for root in REPOSITORIES[repository] if not root["expands"]]
    for root in failing:
        for strict in (True, False):
            found = expansion(root, strict=strict)
            assert not found.complete, root["path"]
            assert found.problems, root["path"]
            assert [p for p in found.problems if not is_in_a_real_line(p)] == [], root["path"]


@needs_corpus
@pytest.mark.parametrize("path", sample(PLACES, 3), ids=lambda path: Path(path).name)
def test_a_problem_is_told_where_it_stands(path: str) -> None:
    root = next(root for root in roots() if root["path"] == path)
    assert said(expansion(root, strict=True).problems[-1]) == PLACES[path]


def said(problem: Problem) -> str:
    position = problem.at.source.position(problem.at.span.start)
    message = problem.message.replace(f"{CORPUS}/", "")
    return f"{Path(problem.at.source.path).name}:{position.line}:{position.column} {message}"


def test_the_corpus_is_read_whole_where_it_is_there() -> None:
    found = roots()
    assert not found or sum(root["expands"] for root in found) == 375
