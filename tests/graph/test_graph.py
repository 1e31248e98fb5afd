"""`urdfctl graph` draws what is wired to what: from topics to joints and back, with lint's errors on the edges."""

from __future__ import annotations

import json
import os
import shutil
import subprocess
import xml.etree.ElementTree as ET
from itertools import pairwise
from pathlib import Path
from typing import Any

import pytest
from folder import Folder
from graph_schema import SCHEMA
from jsonschema import Draft202012Validator

from urdfctl.config.settings import Settings
from urdfctl.graph.build import graph_of
from urdfctl.graph.view import collapsed
from urdfctl.lint.selection import Selection
from urdfctl.lint.target import LintedTarget, lint_target
from urdfctl.load.loader import Loader
from urdfctl.load.target import Target

ROBOT = """\
<robot name="r">
  <link name="base"/><link name="fore"/><link name="hand"/>
  <joint name="elbow" type="revolute"><parent link="base"/><child link="fore"/>
    <limit lower="-1" upper="1" effort="5" velocity="1"/></joint>
  <joint name="wrist" type="revolute"><parent link="fore"/><child link="hand"/>
    <limit lower="-1" upper="1" effort="5" velocity="1"/></joint>
  <ros2_control name="hw" type="system"><hardware><plugin>mock_components/GenericSystem</plugin></hardware>
    <joint name="elbow"><command_interface name="position"/><state_interface name="position"/></joint>
    <joint name="wrist"><command_interface name="position"/><state_interface name="position"/></joint>
  </ros2_control>
</robot>
"""
CONTROLLERS = """\
controller_manager:
  ros__parameters:
    arm: {type: joint_trajectory_controller/JointTrajectoryController}
    fwd: {type: forward_command_controller/ForwardCommandController}
    states: {type: joint_state_broadcaster/JointStateBroadcaster}
arm:
  ros__parameters: {joints: [elbow], command_interfaces: [position], state_interfaces: [position]}
fwd:
  ros__parameters: {joints: [wrist], interface_name: INTERFACE}
"""
CHAINED = """\
controller_manager:
  ros__parameters:
    outer: {type: forward_command_controller/ForwardCommandController}
    inner: {type: pid_controller/PidController}
outer:
  ros__parameters: {joints: [inner/elbow], interface_name: position}
inner:
  ros__parameters:
    dof_names: [elbow]
    command_interface: position
    reference_and_state_interfaces: [position]
    gains: {elbow: {p: 1.0}}
"""


@pytest.fixture
def arm(folder: Folder) -> Folder:
    folder.write({"r.urdf": ROBOT, "c.yaml": CONTROLLERS.replace("INTERFACE", "position")})
    return folder


def graph(folder: Folder, *words: str) -> dict[str, Any]:
    ran = folder.run("graph", "r.urdf", "c.yaml", "--distro", "jazzy", "--format", "json", *words)
    assert ran.returncode == 0, ran.stderr
    found = json.loads(ran.stdout)
    Draft202012Validator(SCHEMA).validate(found)
    return dict(found)


def edges(found: dict[str, Any]) -> set[tuple[str, str]]:
    return {(edge["source"], edge["target"]) for edge in found["edges"]}


def test_the_schema_is_a_schema() -> None:
    Draft202012Validator.check_schema(SCHEMA)


def test_a_command_goes_from_its_topic_to_the_joint_and_its_state_to_a_topic(arm: Folder) -> None:
    way = [
        "input:/fwd/commands", "controller:/fwd", "command:wrist/position", "hardware:hw", "joint:wrist",
        "state:wrist/position", "broadcaster:/states", "output:/joint_states",
    ]  # fmt: skip
    assert set(pairwise(way)) <= edges(graph(arm))


def test_a_controller_that_is_not_started_is_inactive(arm: Folder) -> None:
    found = graph(arm, "--start", "arm,states")
    inactive = {node["id"] for node in found["nodes"] if not node["active"]}
    assert inactive == {"controller:/fwd", "input:/fwd/commands", "command:wrist/position"}
    grey = {(edge["source"], edge["target"]) for edge in found["edges"] if not edge["active"]}
    assert ("controller:/fwd", "command:wrist/position") in grey
    assert ("controller:/arm", "command:elbow/position") not in grey


def test_an_edge_that_lint_reports_carries_the_rule(arm: Folder) -> None:
    arm.write({"c.yaml": CONTROLLERS.replace("INTERFACE", "effort")})
    [broken] = [edge for edge in graph(arm)["edges"] if edge["rules"]]
    assert (broken["source"], broken["target"]) == ("controller:/fwd", "command:wrist/effort")
    lint = arm.run("lint", "r.urdf", "c.yaml", "--distro", "jazzy", "--format", "concise").stdout
    assert f"error {broken['rules'][0]} " in lint
    shown = arm.run("graph", "r.urdf", "c.yaml", "--distro", "jazzy").stdout
    assert f'-. "{broken["rules"][0]}" .->' in shown
    assert "stroke:#c22a2f,stroke-dasharray" in shown


def test_controllers_in_a_chain_are_connected_by_the_interface_between_them(arm: Folder) -> None:
    arm.write({"c.yaml": CHAINED})
    way = ["controller:/outer", "command:inner/elbow/position", "controller:/inner", "command:elbow/position"]
    assert set(pairwise(way)) <= edges(graph(arm))


def test_planning_groups_lead_to_the_actions_of_their_joints(arm: Folder) -> None:
    arm.write(
        {
            "config/r.srdf": '<robot name="r"><group name="manipulator"><joint name="elbow"/></group></robot>',
            "config/r.urdf": ROBOT,
            "config/ros2_controllers.yaml": CONTROLLERS.replace("INTERFACE", "position"),
            "config/moveit_controllers.yaml": "moveit_simple_controller_manager:\n  controller_names: [arm]\n"
            "  arm: {type: FollowJointTrajectory, action_ns: follow_joint_trajectory, joints: [elbow]}\n",
        }
    )
    ran = arm.run("graph", "config/r.urdf", "config/ros2_controllers.yaml", "--distro", "jazzy", "--format", "json")
    way = ["group:manipulator", "input:/arm/follow_joint_trajectory", "controller:/arm"]
    assert set(pairwise(way)) <= edges(json.loads(ran.stdout))


def test_a_focus_keeps_what_leads_to_a_joint_and_away_from_it(arm: Folder) -> None:
    names = {node["id"] for node in graph(arm, "--focus", "elbow")["nodes"]}
    assert {
        "input:/arm/joint_trajectory",
        "controller:/arm",
        "hardware:hw",
        "joint:elbow",
        "output:/joint_states",
    } < names
    assert not {name for name in names if "wrist" in name or "fwd" in name}


def test_joints_that_are_wired_alike_collapse_to_one(arm: Folder) -> None:
    kept = CONTROLLERS.partition("fwd:\n")[0].replace("[elbow]", "[elbow, wrist]")
    arm.write({"c.yaml": "".join(line for line in kept.splitlines(keepends=True) if "fwd" not in line)})
    found = graph(arm, "--collapse")
    members = {node["kind"]: node["members"] for node in found["nodes"] if node["members"]}
    assert members["joint"] == ["elbow", "wrist"]
    assert members["command"] == ["elbow/position", "wrist/position"]


def test_the_drawing_is_svg_and_the_page_needs_no_network(arm: Folder) -> None:
    words = ("graph", "r.urdf", "c.yaml", "--distro", "jazzy", "--format", "svg=g.svg", "--format", "html=g.html")
    assert arm.run(*words).returncode == 0
    drawing = ET.parse(arm.path / "g.svg").getroot()
    names = [part.get("data-name") for part in drawing.iter() if part.get("data-node")]
    assert len(names) == len(graph(arm)["nodes"])
    page = (arm.path / "g.html").read_text(encoding="utf-8")
    assert 'type="search"' in page
    assert "http://" not in page.replace("http://www.w3.org/2000/svg", "")
    assert "https://" not in page


def test_names_that_would_be_markup_are_texts_in_every_format(arm: Folder) -> None:
    name = "a&lt;b&gt;&quot;]#;c"
    arm.write({"r.urdf": ROBOT.replace('"wrist"', f'"{name}"'), "c.yaml": CONTROLLERS.replace("INTERFACE", "position")})
    for output in ("mermaid", "svg", "html"):
        shown = arm.run("graph", "r.urdf", "c.yaml", "--distro", "jazzy", "--format", output).stdout
        assert "<b>" not in shown
        assert "b" in shown
    assert '[label="a<b>\\"]#;c\\nrevolute"' in arm.run("graph", "r.urdf", "c.yaml", "--format", "dot").stdout


def many_joints(folder: Path, number: int) -> LintedTarget:
    """A chain of joints that one controller commands, linted."""
    names = [f"j{n}" for n in range(1, number + 1)]
    joints = "".join(
        f'<link name="l{n}"/><joint name="j{n}" type="revolute"><parent link="l{n - 1}"/><child link="l{n}"/>'
        '<limit lower="-1" upper="1" effort="1" velocity="1"/></joint>'
        for n in range(1, number + 1)
    )
    interfaces = '<command_interface name="position"/><state_interface name="position"/>'
    parts = "".join(f'<joint name="{name}">{interfaces}</joint>' for name in names)
    plugin = "<hardware><plugin>mock_components/GenericSystem</plugin></hardware>"
    control = f'<ros2_control name="hw" type="system">{plugin}{parts}</ros2_control>'
    (folder / "r.urdf").write_text(f'<robot name="r"><link name="l0"/>{joints}{control}</robot>')
    kept = CONTROLLERS.partition("fwd:\n")[0].replace("[elbow]", f"[{', '.join(names)}]")
    (folder / "c.yaml").write_text("".join(line for line in kept.splitlines(keepends=True) if "fwd" not in line))
    target = Target(str(folder / "r.urdf"), controllers=(str(folder / "c.yaml"),))
    return lint_target(Loader(Settings(distro="jazzy")), target, Selection(select=("UC4",)))


def test_two_hundred_joints_of_a_controller_collapse_to_one(tmp_path: Path) -> None:
    linted = many_joints(tmp_path, 200)
    found = graph_of(linted.project, linted.result.outcome.diagnostics)
    assert len([edge for edge in found.edges if edge.kind == "claims"]) == 200
    assert len(collapsed(found).nodes) < 12


MODULES = os.environ.get("URDFCTL_NODE_MODULES")
PARSE = """
import {{ JSDOM }} from "{modules}/jsdom/lib/api.js";
const dom = new JSDOM("<body></body>");
globalThis.window = dom.window; globalThis.document = dom.window.document;
const mermaid = (await import("{modules}/mermaid/dist/mermaid.core.mjs")).default;
let text = ""; for await (const part of process.stdin) text += part;
await mermaid.parse(text);
"""


@pytest.mark.skipif(
    not MODULES or shutil.which("node") is None,
    reason="npm install mermaid jsdom, and name its node_modules in URDFCTL_NODE_MODULES",
)
def test_mermaid_itself_can_parse_the_flowchart(arm: Folder, tmp_path: Path) -> None:
    (tmp_path / "parse.mjs").write_text(PARSE.format(modules=MODULES))
    for name in ("wrist", "end", "a&lt;b&gt;&quot;]#;c", "1-2.3/x"):
        arm.write({"r.urdf": ROBOT.replace('"wrist"', f'"{name}"')})
        shown = arm.run("graph", "r.urdf", "c.yaml", "--distro", "jazzy").stdout
        ran = subprocess.run(
            ["node", "parse.mjs"], input=shown, cwd=tmp_path, text=True, capture_output=True, check=False
        )
        assert ran.returncode == 0, ran.stderr + shown


@pytest.mark.parametrize(
    ("words", "said"),
    [
        (("r.urdf", "c.yaml", "--focus", "elbo"), "'elbo' is not in the graph; did you mean 'elbow'?"),
        (("none.urdf",), "file or folder 'none.urdf' does not exist"),
        (("r.urdf", "--format", "sgv"), "unknown format 'sgv'; known are mermaid, dot, svg, html, json"),
        (("plain.urdf",), "'plain.urdf' has no controllers and no hardware; name its launch or controller files"),
    ],
)
def test_what_cannot_be_drawn_gets_one_line(arm: Folder, words: tuple[str, ...], said: str) -> None:
    arm.write({"plain.urdf": '<robot name="p"><link name="a"/></robot>'})
    ran = arm.run("graph", *words)
    assert (ran.returncode, ran.stderr.replace(f"{arm.path}/", "")) == (2, f"urdfctl: {said}\n")
