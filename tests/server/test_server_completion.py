"""What is offered can be written: no item causes a finding; every second word is typed halfway before."""

from __future__ import annotations

from pathlib import Path

import pytest

pytest.importorskip("pygls", reason="pygls is not installed")

from completing import Insertion, insertions
from editor import Editor, in_editor, types
from folder import CHECKOUT, Folder
from live_replay import copied
from server_names import CONTROLLERS, LAUNCH, MACROS, ROBOT, STARTS, URDF, XACRO, YAML, question

from urdfctl.model.project import Project
from urdfctl.server.analysis.unfinished import closers_of
from urdfctl.server.features.completion import items_at

SAMPLES = CHECKOUT / "samples"
STARTER = LAUNCH.replace("arguments=['turn']", "arguments=[|]")


@pytest.mark.parametrize(
    ("file", "text", "offered", "left_out"),
    [
        (URDF, ROBOT.replace('"macros.xacro"', '"$(find p)/|"'), {"urdf/macros.xacro"}, {"urdf/robot.xacro"}),
        (URDF, ROBOT.replace('"macros.xacro"', '"$(find |)/urdf/macros.xacro"'), {"p"}, set()),
        (XACRO, MACROS.replace("${2 * radius}", "${2 * |}"), {"radius", "pi"}, {"side"}),
        (XACRO, MACROS.replace("<link", """<xacro:property name="ns" value="${'a' + side + '/'}"/><link""")
         .replace('joint name="$', 'joint name="${|}$'), {"ns", "side"}, {"pi"}),
        (XACRO, MACROS.replace('child link="${side}_wheel"', 'child link="|"'),
         {"${side}_wheel"}, {"left_wheel", "base"}),
        (XACRO, MACROS.replace('<parent link="base"/>', '<parent link="|"/>').replace("</xacro:macro>", """
    <xacro:axle of="${side}"/></xacro:macro>
  <xacro:macro name="axle" params="of"><link name="${of}_axle"/></xacro:macro>"""),
         {"${side}_axle", "base"}, {"left_axle", "${of}_axle"}),
        (URDF, ROBOT.replace('<parent link="base"', '<parent link="|"'), {"base", "left_wheel"}, {"head"}),
        (URDF, ROBOT.replace('<state_interface name="position"', '<state_interface name="|"'),
         {"velocity", "effort"}, set()),
        (URDF, ROBOT.replace('<command_interface name="position"', '<command_interface name="|"'),
         {"position"}, {"velocity"}),
        (YAML, CONTROLLERS.replace("100", "100\n    turn:\n      type: |"),
         {"position_controllers/JointGroupPositionController"}, {"diff_drive_controller/DiffDriveController"}),
        (YAML, CONTROLLERS + "other:\n  type: |\n  left_wheel_names: [a]\n",
         {"diff_drive_controller/DiffDriveController"}, {"joint_state_broadcaster/JointStateBroadcaster"}),
        (YAML, CONTROLLERS.replace("position_controllers/JointGroupPositionController",
                                   "imu_sensor_broadcaster/IMUSensorBroadcaster").replace("joints: [neck]", "|"),
         {"sensor_name:"}, set()),
        (STARTS, STARTER.replace("|", "'|'"), {"turn", "--inactive"}, {"--stopped", "--help"}),
        (STARTS, STARTER.replace("|", "'turn', '--in|'"), {"--inactive"}, {"turn"}),
        (STARTS, STARTER.replace("|", "'turn', '-c', '|'"), {"/controller_manager"}, {"turn", "--inactive"}),
    ],
)  # fmt: skip
def test_only_what_fits_the_place_is_offered(
    folder: Folder, file: str, text: str, offered: set[str], left_out: set[str]
) -> None:
    before = text[: text.index("|")]
    at = types.Position(before.count("\n"), len(before) - before.rfind("\n") - 1)
    found = {item.text for item in items_at(question(folder, file, at, typed=text.replace("|", "")))}
    assert (offered - found, left_out & found) == (set(), set())


def test_an_item_replaces_the_word_that_is_typed(folder: Folder) -> None:
    text = ROBOT.replace("<xacro:wheel side", "<xacro:wh side", 1)
    line = text[: text.index("<xacro:wh side")].count("\n")
    asks = question(folder, URDF, types.Position(line, len("  <xacro:wh")), typed=text)
    assert [(item.text, item.replaces) for item in items_at(asks)] == [("xacro:wheel", len("xacro:wh"))]


def test_a_controller_is_written_after_those_that_a_spawner_starts_already(folder: Folder) -> None:
    text = "<launch><node pkg='controller_manager' exec='spawner' args='other '/></launch>"
    asks = question(folder, "launch/more.launch.xml", types.Position(0, text.index("'/>")), typed=text)
    robots = question(folder, STARTS, types.Position(0, 0)).robots
    items = items_at(asks._replace(robots=[robots[0]._replace(project=_without_spawns(robots[0].project))]))
    assert [(item.text, item.replaces) for item in items][:1] == [("turn", 0)]


@pytest.mark.parametrize("typed", ["joints: [", "joints: ['", "joints: [turn, ", "joints:\n      - "])
def test_joints_are_offered_right_after_a_list_of_them_was_opened(tmp_path: Path, typed: str) -> None:
    here, file = copied(SAMPLES / "picker", tmp_path), "config/controllers.yaml"
    saved = (here / file).read_text(encoding="utf-8")
    start = saved.index("joints: [turn")
    before = saved[:start] + typed
    line, column = before.count("\n"), len(before) - before.rfind("\n") - 1

    async def use(editor: Editor) -> list[str]:
        await editor.open(file)
        await editor.checked()
        await editor.type(file, before + saved[saved.index("\n", start) :])
        asked = types.CompletionParams(editor.document(file), types.Position(line, column))
        found = await editor.client.text_document_completion_async(asked)
        assert isinstance(found, list)
        return [item.label for item in found]

    wanted = {"shoulder", "elbow", "wrist"}
    offered = set(in_editor(here, use))
    assert (wanted - offered, offered & {"tool_joint"}) == (set(), set())


@pytest.mark.parametrize(
    ("line", "closers"),
    [
        ("joints: [", "]"),
        ("joints: ['a", "']"),
        ("limits: {a: [1, 2", "]}"),
        ("joints: [a, b]", ""),
        ("note: don't  # [", ""),
        ("a: [b  # ]", "]"),
    ],
)
def test_a_line_of_yaml_is_closed_by_what_it_leaves_open(line: str, closers: str) -> None:
    assert closers_of(line) == closers


def _without_spawns(project: Project) -> Project:
    return project._replace(launch=None)


@pytest.mark.parametrize("name", ["my_robot", "mybot", "radu", "gripper"])
def test_inserting_what_is_offered_causes_no_finding(name: str, tmp_path: Path) -> None:
    """The exhaustive form is tests/bench/exhaustive/test_completion.py."""
    found = list(insertions(copied(SAMPLES / name, tmp_path), number=6, seed=3, each=2))
    assert len(found) > 3
    assert list(map(str, filter(Insertion.is_harmful, found))) == []
