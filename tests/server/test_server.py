"""`urdfctl server`: what an editor is told while the user types."""

from __future__ import annotations

import asyncio
from pathlib import Path

from editor import Editor, in_editor, types
from folder import Folder

Found = dict[str, list[tuple[str, int, int]]]

MACROS = """<robot xmlns:xacro="http://www.ros.org/wiki/xacro">
  <xacro:macro name="wheel" params="name">
    <link name="${name}"/>
    <joint name="${name}_hinge" type="continuous">
      <parent link="base"/><child link="${name}"/><axis xyz="0 1 0"/>
    </joint>
  </xacro:macro>
</robot>
"""
ROBOT = """<robot name="r" xmlns:xacro="http://www.ros.org/wiki/xacro">
  <xacro:include filename="macros.xacro"/>
  <link name="base"/>
  <xacro:wheel name="left"/>
</robot>
"""


def ws(folder: Folder, **files: str) -> Path:
    """A workspace with one package."""
    given = {"package.xml": "<package><name>p</name></package>", "urdf/macros.xacro": MACROS, "urdf/robot.xacro": ROBOT}
    folder.write({".git/HEAD": "", **given, **{name.replace("__", "/"): text for name, text in files.items()}})
    return folder.path


def errors(found: Found) -> dict[str, list[str]]:
    return {file: [code for code, _, _ in codes if code != "UC602"] for file, codes in found.items()}


def test_a_fault_is_told_while_it_is_typed_and_forgotten_when_it_is_mended(folder: Folder) -> None:
    async def use(editor: Editor) -> list[Found]:
        await editor.open("urdf/robot.xacro")
        states = [await editor.checked()]
        for text in (ROBOT.replace('"base"', '"basis"'), ROBOT):
            await editor.type("urdf/robot.xacro", text)
            states.append(await editor.checked())
        return states

    before, wrong, mended = in_editor(ws(folder), use)
    assert wrong != before
    assert "UC116" in {code for found in wrong.values() for code, _, _ in found}
    assert mended == before


def test_a_change_in_a_macro_is_told_in_the_robot_that_calls_it(folder: Folder) -> None:
    async def use(editor: Editor) -> Found:
        await editor.open("urdf/macros.xacro")
        await editor.checked()
        await editor.type("urdf/macros.xacro", MACROS.replace('params="name"', 'params="name radius"'))
        return await editor.checked()

    found = in_editor(ws(folder), use)
    assert any(code == "UC007" or line == 3 for code, line, _ in found["urdf/robot.xacro"])


def test_closing_a_file_without_saving_brings_its_findings_on_disk_back(folder: Folder) -> None:
    async def use(editor: Editor) -> tuple[Found, Found]:
        await editor.open("urdf/robot.xacro")
        before = await editor.checked()
        await editor.type("urdf/robot.xacro", "<robot")
        await editor.checked()
        await editor.close("urdf/robot.xacro")
        return before, await editor.checked()

    before, after = in_editor(ws(folder), use)
    assert before == after


def test_a_file_that_another_program_deletes_is_missed(folder: Folder) -> None:
    async def use(editor: Editor) -> Found:
        await editor.open("urdf/robot.xacro")
        await editor.checked()
        (editor.folder / "urdf/macros.xacro").unlink()
        await editor.told(types.FileChangeType.Deleted, "urdf/macros.xacro")
        return await editor.checked()

    assert "UC002" in {code for code, _, _ in in_editor(ws(folder), use)["urdf/robot.xacro"]}


def test_columns_are_counted_in_the_units_of_the_editor(folder: Folder) -> None:
    """A sign outside of the basic plane has two units in UTF-16, and four in UTF-8."""
    text = ROBOT.replace("<link name", "<!-- 🤖 --><xacro:nothing/><link name")

    def use(editor: Editor) -> object:
        async def asked() -> int:
            await editor.open("urdf/robot.xacro", text)
            found = await editor.checked()
            return next(column for _, line, column in found["urdf/robot.xacro"] if line == 2)

        return asked()

    columns = {
        unit: in_editor(ws(folder), use, [unit])  # type: ignore[arg-type]
        for unit in ("utf-16", "utf-8", "utf-32")
    }
    assert columns["utf-16"] - columns["utf-32"] == 1
    assert columns["utf-8"] - columns["utf-32"] == 3


def test_a_wrong_configuration_is_told_in_one_message(folder: Folder) -> None:
    async def use(editor: Editor) -> list[str]:
        await editor.open("urdf/robot.xacro")
        while not editor.messages or not editor.problems:
            await asyncio.sleep(0.05)
        return [*editor.messages, *editor.problems]

    message, *others, problem = in_editor(ws(folder, **{"urdfctl.toml": "distro = 7\n"}), use)
    assert "urdfctl.toml: distro" in message
    assert others == []
    assert "is not linted: urdfctl.toml: distro" in problem


def test_the_editor_chooses_the_distro_and_the_variant_that_is_shown(folder: Folder) -> None:
    text = ROBOT.replace('name="left"', 'name="$(arg side)"').replace(
        "  <xacro:i", '  <xacro:arg name="side"/>\n  <xacro:i'
    )

    async def use(editor: Editor) -> list[object]:
        await editor.open("urdf/robot.xacro", text)
        found = await editor.checked()
        [robot] = editor.robots
        return [found, f"{robot.distro} from {robot.distro_from}", robot.arguments.side]

    path = ws(folder)
    (path / "urdf/robot.xacro").write_text(text, encoding="utf-8")
    _, distro, side = in_editor(path, use, wishes={"distro": "humble", "arguments": {"side": "left"}, "other": [1]})
    assert (distro, side) == ("humble from the editor's settings", "left")


def test_a_mended_configuration_is_read_again(folder: Folder) -> None:
    async def use(editor: Editor) -> Found:
        await editor.open("urdf/robot.xacro", "<robot name='r'><link")
        while not editor.messages:
            await asyncio.sleep(0.05)
        (editor.folder / "urdfctl.toml").write_text("", encoding="utf-8")
        await editor.told(types.FileChangeType.Changed, "urdfctl.toml")
        while not editor.robots and not editor.findings:
            await asyncio.sleep(0.05)
        return {str(path.name): [(str(one.code), 0, 0) for one in found] for path, found in editor.findings.items()}

    assert "robot.xacro" in in_editor(ws(folder, **{"urdfctl.toml": "distro = 7\n"}), use)
