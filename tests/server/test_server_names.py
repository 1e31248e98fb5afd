"""Going to a name, finding its uses, renaming it, pointing at it, and completing it, in an editor."""

from __future__ import annotations

import os
import re

import pytest
from editor import Editor, in_editor, types
from folder import Folder
from pygls.exceptions import JsonRpcException
from server_names import CONTROLLERS, FILES, LAUNCH, MACROS, ROBOT, STARTS, URDF, XACRO, YAML, question

from urdfctl.diagnostic import ShownEdit
from urdfctl.errors import UserError
from urdfctl.server.analysis.workspace import EditorSettings, Workspace
from urdfctl.server.features.completion import items_at
from urdfctl.server.features.hover import hover
from urdfctl.server.features.navigation import NamesAround, definitions, renamed
from urdfctl.server.features.symbols import hints_in, symbols_in


def place(text: str, name: str, number: int = 1) -> types.Position:
    """The position of the middle of the n-th place of a name in a text."""
    offset = -1
    for _ in range(number):
        offset = text.index(name, offset + 1)
    offset += len(name) // 2
    return types.Position(text.count("\n", 0, offset), offset - text.rfind("\n", 0, offset) - 1)


def texts(edits: list[ShownEdit]) -> dict[str, str]:
    """The files with some edits."""
    changed = {name: text.encode() for name, text in FILES.items()}
    for edit in sorted(edits, key=lambda one: -one.start):
        name = next(name for name in FILES if edit.file.endswith(name))
        changed[name] = changed[name][: edit.start] + edit.text.encode() + changed[name][edit.end :]
    return {name: text.decode() for name, text in changed.items()}


@pytest.mark.parametrize(
    ("file", "name", "number", "found"),
    [
        (YAML, "neck", 1, ("robot.xacro", 5)),
        (YAML, "turn", 2, ("controllers.yaml", 4)),
        (STARTS, "'turn'", 1, ("controllers.yaml", 4)),
        (URDF, "wheel", 1, ("macros.xacro", 2)),
        (XACRO, "radius", 2, ("macros.xacro", 2)),
        (XACRO, "_wheel", 2, ("macros.xacro", 3)),
        (URDF, "base", 2, ("robot.xacro", 3)),
    ],
)
def test_a_name_leads_to_its_definition(
    folder: Folder, file: str, name: str, number: int, found: tuple[str, int]
) -> None:
    around = NamesAround(question(folder, file, place(FILES[file], name, number)))
    assert {(os.path.basename(at.file), at.line) for at in definitions(around)} == {found}


def test_a_joint_is_renamed_in_all_files(folder: Folder) -> None:
    edits = renamed(NamesAround(question(folder, YAML, place(CONTROLLERS, "neck"))), "pan")
    assert texts(edits) == {name: text.replace("neck", "pan") for name, text in FILES.items()}


def test_a_parameter_with_the_name_of_a_link_is_not_renamed(folder: Folder) -> None:
    robot = ROBOT.replace('"head"', '"joints"')
    edits = renamed(NamesAround(question(folder, URDF, place(robot, '"joints"'), URDF=robot)), "face")
    assert {os.path.basename(edit.file) for edit in edits} == {"robot.xacro"}


def test_a_controller_is_renamed_in_its_file_and_where_it_is_started(folder: Folder) -> None:
    changed = texts(renamed(NamesAround(question(folder, YAML, place(CONTROLLERS, "turn"))), "look"))
    assert changed[YAML] == CONTROLLERS.replace("turn", "look")
    assert changed[STARTS] == LAUNCH.replace("'turn'", "'look'")


def test_the_literal_part_of_a_computed_name_is_renamed_with_all_names_that_come_of_it(folder: Folder) -> None:
    yaml = CONTROLLERS.replace("[neck]", "[neck, left_hinge]")
    asks = question(folder, XACRO, place(MACROS, "_hinge"), YAML=yaml)
    edits = sorted(renamed(NamesAround(asks), "${side}_axle"), key=lambda edit: edit.file)
    assert [(os.path.basename(edit.file), edit.text) for edit in edits] == [
        ("controllers.yaml", "left_axle"),
        ("macros.xacro", "${side}_axle"),
    ]


@pytest.mark.parametrize(
    ("file", "name", "new", "reason"),
    [
        (XACRO, "_hinge", "${other}_x", "change only its literal parts, as in '${side}new_hinge'"),
        (XACRO, "_hinge", "x", "is computed from '${side}_hinge' at macros.xacro:4; rename its literal parts there"),
        (URDF, "neck", "right_hinge", "joint 'right_hinge' exists already"),
        (URDF, "neck", "a b", "'a b' is no name for a joint"),
        (URDF, "revolute", "x", "there is no name here that can be renamed"),
    ],
)
def test_a_rename_that_is_not_sure_is_refused_with_the_reason(
    folder: Folder, file: str, name: str, new: str, reason: str
) -> None:
    with pytest.raises(UserError, match=re.escape(reason)):
        renamed(NamesAround(question(folder, file, place(FILES[file], name))), new)


@pytest.mark.parametrize(
    ("file", "name", "words"),
    [
        (
            URDF,
            "neck",
            [
                "**joint** `neck`",
                "revolute, -1 to 1 rad, at most 2 rad/s, at most 5 N m, connects `base` to `head`",
                "controller `turn`",
            ],
        ),
        (XACRO, 'wheel"', ["**macro** `wheel`", "parameters: `side`, `radius:=0.1`"]),
        (XACRO, "radius}", ["**parameter** `radius` of macro `wheel`", "default: `0.1`"]),
        (XACRO, "side}", ["**parameter** `side` of macro `wheel`", "no default: it must be given"]),
        (YAML, "joints", ["**parameter** `joints`", "type: `string_array`", "order of the values in a command"]),
        (YAML, "position_controllers/", ["`position_controllers/JointGroupPositionController` (jazzy)", "in package"]),
        (YAML, "neck", ["revolute, -1 to 1 rad", "controller `turn`: command interface position"]),
        (URDF, '"position"/><s', ["**command interface** `neck/position`", "controller `turn` claims it"]),
        (XACRO, "${2 * radius}", ["`0.2` in the call of `wheel` in line 9", "`0.4` in the call of `wheel` in line 10"]),
    ],
)
def test_pointing_at_something_tells_what_is_known_about_it(
    folder: Folder, file: str, name: str, words: list[str]
) -> None:
    found = hover(question(folder, file, place(FILES[file], name)))
    assert found is not None
    assert [word for word in words if word not in found] == []


@pytest.mark.parametrize(
    ("file", "text", "offered"),
    [
        (URDF, ROBOT.replace("</robot>", '<joint name="x"><parent link="|'), {"base", "head", "left_wheel"}),
        (URDF, ROBOT.replace('    <joint name="neck"><c', '    <joint name="|"><c'), {"neck"}),
        (URDF, ROBOT.replace("</robot>", "<xacro:|"), {"xacro:wheel"}),
        (URDF, ROBOT.replace("</robot>", "<xacro:wheel |"), {'side=""', 'radius="0.1"'}),
        (YAML, CONTROLLERS.replace("[neck]", "[|]"), {"neck"}),
        (YAML, CONTROLLERS.replace("position_controllers/JointGroupPositionController", "|"),
         {"position_controllers/JointGroupPositionController"}),
        (YAML, CONTROLLERS.replace("    joints: [neck]", "    |"), {"joints: [neck]"}),
    ],
)  # fmt: skip
def test_what_can_be_written_is_offered_while_the_text_is_unfinished(
    folder: Folder, file: str, text: str, offered: set[str]
) -> None:
    before = text[: text.index("|")]
    at = types.Position(before.count("\n"), len(before) - before.rfind("\n") - 1)
    items = items_at(question(folder, file, at, typed=text.replace("|", "")))
    assert offered - {item.text for item in items} == set()


def test_a_file_has_an_outline(folder: Folder) -> None:
    outline = symbols_in(question(folder, XACRO, types.Position(0, 0)))
    expected = [("wheel", "macro"), ("${side}_wheel", "link"), ("${side}_hinge", "joint")]
    assert [(one.name, one.kind) for one in outline] == expected


def test_a_property_is_defined_in_the_macro_that_it_is_used_in(folder: Folder) -> None:
    axle = """<xacro:macro name="axle" params=""><xacro:property name="gap" value="3"/>
    <link name="${gap}"/></xacro:macro>
  <xacro:property name="gap" value="1"/><xacro:macro name="wheel\""""
    text = MACROS.replace('<xacro:macro name="wheel"', axle)
    asks = question(folder, XACRO, place(text, "{gap}"), typed=text)
    assert [at.line for at in definitions(NamesAround(asks))] == [2]
    assert "written as `3`" in (hover(asks) or "")


@pytest.mark.parametrize(
    ("word", "told"),
    [
        ("{gap", "**property** `gap`  \nwritten as `${2 * 3}`"),
        (" pi ", "**property** `pi`  \na constant of xacro: `3.141592653589793`"),
        ("load)", "**argument** `load`  \ndefault: `7`"),
    ],
)
def test_pointing_at_a_name_of_xacro_tells_its_value(folder: Folder, word: str, told: str) -> None:
    defined = '<xacro:property name="gap" value="${2 * 3}"/><xacro:arg name="load" default="7"/>'
    text = ROBOT.replace('effort="5"', 'effort="${gap * pi + $(arg load)}"').replace("<link", f"{defined}<link", 1)
    found = hover(question(folder, URDF, place(text, word), typed=text))
    assert found is not None
    assert told in found


@pytest.mark.parametrize(
    ("written", "shown"), [("${3 * 4}", "12"), ("${pi / 3}", "1.047"), ("a1.23456789${2}", "a1.234567892")]
)
def test_values_are_shown_where_all_calls_agree(folder: Folder, written: str, shown: str) -> None:
    text = MACROS.replace('effort="1"', f'effort="{written}"')
    asks = question(folder, XACRO, types.Position(0, 0), typed=text)
    assert [(hint.line, hint.value) for hint in hints_in(asks)] == [(6, shown)]


IGNORED = ROBOT.replace("  <link name", "  <!-- urdfctl: ignore[UC116] later -->\n  <link name", 1)
LIMITED = CONTROLLERS.replace("JointGroupPositionController", "GripperActionController").replace(
    "joints: [neck]", "joint: neck\n    stall_timeout: 1.0"
)
TRAJECTORY = CONTROLLERS.replace(
    "position_controllers/JointGroupPosition", "joint_trajectory_controller/JointTrajectory"
)
TRAJECTORY = TRAJECTORY.replace("joints: [neck]", "joints: [neck]\n    command_interfaces: [position]")


@pytest.mark.parametrize(
    ("file", "text", "name", "words"),
    [
        (URDF, IGNORED, "UC116", ["**UC116** unknown-link (error)", "Runtime: rejects the part"]),
        (YAML, LIMITED, "stall_timeout", ["type: `double`", "unit: s", "default: `1.0`"]),
        (
            YAML,
            TRAJECTORY,
            "command_interfaces",
            ["must not contain duplicates", "can contain only 'position'"],
        ),
        (URDF, IGNORED.replace("UC116", "UC126"), "UC126", ["reads an &lt;axis> without `xyz` as 0 0 0"]),
        (URDF, ROBOT.replace('<command_interface name="position"/>', ""), '"position"/>', ["no controller uses it"]),
    ],
)
def test_pointing_at_a_code_tells_of_its_rule_and_at_a_number_its_unit(
    folder: Folder, file: str, text: str, name: str, words: list[str]
) -> None:
    found = hover(question(folder, file, place(text, name), typed=text))
    assert found is not None
    assert [word for word in words if word not in found] == []


def test_pointing_at_a_finding_tells_of_its_rule(folder: Folder) -> None:
    question(folder, URDF, types.Position(0, 0))  # writes the files
    text = ROBOT.replace('<parent link="base"/><child link="head"/>', '<parent link="basis"/><child link="head"/>')

    async def use(editor: Editor) -> str:
        await editor.open(URDF, text)
        await editor.checked()
        asked = types.HoverParams(editor.document(URDF), place(text, "basis"))
        return str(await editor.client.text_document_hover_async(asked))

    assert "**UC116** unknown-link" in in_editor(folder.path, use)


def test_pointing_at_an_interface_tells_of_the_controllers_of_all_namespaces(folder: Folder) -> None:
    spaces = [f"/{side}/controller_manager:{CONTROLLERS.partition(':')[2]}" for side in ("left", "right")]
    yaml = "".join(space.replace("\nturn:", f"\n{space.split('/c')[0]}/turn:") for space in spaces)
    sides = "".join(f"        Node(package='controller_manager', executable='ros2_control_node', namespace='{side}', "
                    "parameters=[os.path.join(share, 'config', 'controllers.yaml')]),\n"
                    for side in ("left", "right"))  # fmt: skip
    launch = LAUNCH.replace("        Node(package='controller_manager', executable='sp", f"{sides}#")
    found = hover(question(folder, URDF, place(ROBOT, '"position"/><s'), YAML=yaml, STARTS=launch))
    assert found is not None
    assert "controller `/left/turn` claims it" in found
    assert "controller `/right/turn` claims it" in found


@pytest.mark.parametrize("name", ["urdf/macros.xacro", "package.xml"])
def test_what_another_program_writes_is_known_to_the_next_question(folder: Folder, name: str) -> None:
    question(folder, URDF, types.Position(0, 0))  # writes the files
    workspace = Workspace(str(folder.path), EditorSettings())
    workspace.check()
    robot = str(folder.path / URDF)
    before = workspace.robots_with(robot)
    assert workspace.robots_with(robot) is before
    workspace.saved(str(folder.path / name))
    assert workspace.robots_with(robot) is not before


def test_the_server_answers_each_kind_of_question(folder: Folder) -> None:
    question(folder, URDF, types.Position(0, 0))  # writes the files

    async def use(editor: Editor) -> list[str]:
        for name in FILES:
            await editor.open(name)
        await editor.checked()
        document, at, client = editor.document(YAML), place(CONTROLLERS, "neck"), editor.client
        at_type = place(CONTROLLERS, "position_controllers/")
        whole = types.Range(types.Position(0, 0), types.Position(99, 0))
        context = types.ReferenceContext(include_declaration=True)
        wrong = types.RenameParams(editor.document(URDF), place(ROBOT, "neck"), "a b")
        with pytest.raises(JsonRpcException, match="is no name for a joint"):
            await client.text_document_rename_async(wrong)
        answers = [
            await client.text_document_definition_async(types.DefinitionParams(document, at)),
            await client.text_document_references_async(types.ReferenceParams(context, document, at)),
            await client.text_document_rename_async(types.RenameParams(document, at, "pan")),
            await client.text_document_hover_async(types.HoverParams(document, at)),
            await client.text_document_completion_async(types.CompletionParams(document, at_type)),
            await client.text_document_document_symbol_async(types.DocumentSymbolParams(document)),
            await client.text_document_inlay_hint_async(types.InlayHintParams(editor.document(XACRO), whole)),
        ]
        return [str(answer) for answer in answers]

    defined, used, edited, about, offered, outline, hints = in_editor(folder.path, use)
    assert "robot.xacro" in defined
    assert used.count("robot.xacro:") == 2
    assert edited.count("new_text='pan'") == 3
    assert "revolute" in about
    assert "position_controllers/JointGroupPositionController" in offered
    assert "turn" in outline
    assert hints == "()"
