"""What an editor offers at a finding: its fix, a comment that ignores it, and an explanation."""

from __future__ import annotations

from pathlib import Path

from editor import Editor, in_editor, types
from folder import Folder

TRANSMISSION = """<robot name="r">
  <link name="a"/>
  <link name="b"/>
  <joint name="j" type="revolute">
    <parent link="a"/><child link="b"/><axis xyz="0 0 1"/>
    <limit lower="0" upper="1" effort="1" velocity="1"/>
  </joint>
  <transmission name="t">
    <type>transmission_interface/SimpleTransmission</type>
    <joint name="j"/>
    <actuator name="m"/>
  </transmission>
</robot>
"""
CONFIG = 'distro = "noetic"\n'
WHOLE = types.Range(types.Position(0, 0), types.Position(99, 0))


def offered(folder: Folder, text: str, only: list[str] | None = None) -> list[types.CodeAction]:
    """The actions for a whole file."""
    folder.write({".git/HEAD": "", "urdfctl.toml": CONFIG, "robot.urdf": text})

    async def use(editor: Editor) -> list[types.CodeAction]:
        await editor.open("robot.urdf")
        await editor.checked()
        context = types.CodeActionContext(diagnostics=[], only=only)  # type: ignore[arg-type]
        asked = types.CodeActionParams(editor.document("robot.urdf"), WHOLE, context)
        return [
            one
            for one in await editor.client.text_document_code_action_async(asked) or []
            if isinstance(one, types.CodeAction)
        ]

    return in_editor(folder.path, use)


def applied(text: str, action: types.CodeAction) -> str:
    """A text with the edits of an action."""
    assert action.edit is not None
    assert action.edit.changes is not None
    [edits] = action.edit.changes.values()
    lines = text.splitlines(keepends=True)
    for edit in sorted(edits, key=lambda one: (one.range.start.line, one.range.start.character), reverse=True):
        start, end = edit.range.start, edit.range.end
        before, after = lines[start.line][: start.character], lines[end.line][end.character :]
        lines[start.line : end.line + 1] = [before + edit.new_text + after]
    return "".join(lines)


def codes(folder: Folder, text: str) -> set[str]:
    (Path(folder.path) / "robot.urdf").write_text(text, encoding="utf-8")
    ran = folder.run("lint", "robot.urdf", "--format", "concise", "--no-cache")
    return {line.split()[2] for line in ran.stdout.splitlines() if line.startswith("robot.urdf:")}


def test_a_quick_fix_mends_its_finding(folder: Folder) -> None:
    actions = offered(folder, TRANSMISSION, ["quickfix"])
    fix = next(one for one in actions if one.title.startswith("UC212: "))
    assert "UC212" in codes(folder, TRANSMISSION)
    assert "UC212" not in codes(folder, applied(TRANSMISSION, fix))


def test_a_comment_ignores_a_finding(folder: Folder) -> None:
    actions = offered(folder, TRANSMISSION)
    ignoring = next(one for one in actions if one.title.startswith("Ignore UC201"))
    assert "UC201" not in codes(folder, applied(TRANSMISSION, ignoring))


def test_all_safe_fixes_are_one_action_that_leaves_none(folder: Folder) -> None:
    text = TRANSMISSION.replace("<robot", '<robot xmlns:xacro="http://www.ros.org/wiki/xacro"')
    text = text.replace(
        '  <link name="a"/>', '  <property name="x" value="1"/>\n  <property name="y" value="2"/>\n  <link name="a"/>'
    )
    folder.write({"robot.urdf": text})
    for action in offered(folder, text, ["source.fixAll"]):
        assert action.kind == types.CodeActionKind.SourceFixAll
        assert folder.run("lint", "robot.urdf", "--diff", "--no-cache").stdout
        mended = applied(text, action)
        folder.write({"robot.urdf": mended})
        assert folder.run("lint", "robot.urdf", "--diff", "--no-cache").stdout == ""


def test_a_rule_is_explained(folder: Folder) -> None:
    folder.write({".git/HEAD": ""})

    async def use(editor: Editor) -> object:
        asked = types.ExecuteCommandParams("urdfctl.explain", ["UC201"])
        return await editor.client.workspace_execute_command_async(asked)

    assert "UC201 transmission-joint-without-interface" in str(in_editor(folder.path, use))
