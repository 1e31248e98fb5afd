"""An editor may show several folders in one window: each is linted as its own configuration says."""

from __future__ import annotations

from pathlib import Path

from editor import Editor, in_editor
from folder import Folder

ROBOT = """<robot name="{name}">
  <link name="base"/>
  <link name="tip"/>
  <joint name="j" type="fixed"><parent link="base"/><child link="tip"/></joint>
  <transmission name="t">
    <type>transmission_interface/SimpleTransmission</type>
    <joint name="j"/>
  </transmission>
  <gazebo reference="bas"/>
</robot>
"""
SHARED = """<robot xmlns:xacro="http://www.ros.org/wiki/xacro">
  <xacro:macro name="wheel" params="name"><link name="${name}"/></xacro:macro>
</robot>
"""
USER = """<robot name="user" xmlns:xacro="http://www.ros.org/wiki/xacro">
  <xacro:include filename="$(find shared)/wheel.xacro"/>
  <link name="base"/>
  <xacro:wheel name="left"/>
  <joint name="j" type="fixed"><parent link="base"/><child link="left"/></joint>
</robot>
"""


def ws(folder: Folder) -> tuple[Path, Path]:
    """Two folders; the second one does not want to hear of transmissions."""
    folder.write(
        {
            "one/.git/HEAD": "",
            "one/robot.urdf": ROBOT.format(name="one"),
            "two/.git/HEAD": "",
            "two/robot.urdf": ROBOT.format(name="two"),
            "two/urdfctl.toml": 'ignore = ["UC2"]\n',
        }
    )
    return (folder.path / "one").resolve(), (folder.path / "two").resolve()


def codes(editor: Editor) -> dict[str, set[str]]:
    """The codes of transmissions that are shown in each folder's file."""
    return {
        path.parent.name: {str(found.code) for found in findings if str(found.code).startswith("UC2")}
        for path, findings in editor.findings.items()
    }


def test_each_folder_is_linted_with_its_own_configuration(folder: Folder) -> None:
    one, two = ws(folder)

    async def use(editor: Editor) -> tuple[dict[str, set[str]], set[str]]:
        await editor.checked()
        await editor.show_folders(added=[two])
        await editor.checked()
        return codes(editor), {robot.robot for robot in editor.robots}

    found, robots = in_editor(one, use)
    assert found["one"]
    assert not found["two"]
    assert robots == {"one", "two"}


def test_a_folder_that_is_no_longer_shown_has_no_findings(folder: Folder) -> None:
    one, two = ws(folder)

    async def use(editor: Editor) -> tuple[list[int], list[int]]:
        await editor.checked()
        await editor.show_folders(added=[two])
        await editor.checked()
        both = [len(found) for found in editor.findings.values()]
        await editor.show_folders(removed=[one])
        await editor.checked()
        return both, [len(found) for path, found in editor.findings.items() if path.parent == one]

    both, left = in_editor(one, use)
    assert len(both) == 2
    assert all(both)
    assert left == [0]


def test_without_any_folder_nothing_is_left_of_the_findings(folder: Folder) -> None:
    one, _ = ws(folder)

    async def use(editor: Editor) -> dict[str, set[str]]:
        await editor.checked()
        await editor.show_folders(removed=[one])
        await editor.open("robot.urdf")
        await editor.close("robot.urdf")
        await editor.checked()
        await editor.show_folders(removed=[one])
        return codes(editor)

    assert in_editor(one, use)["one"]  # linted again for the file that was opened without a folder


def test_a_folder_inside_another_one_is_linted_as_its_own_configuration_says(folder: Folder) -> None:
    one, two = ws(folder)

    async def use(editor: Editor) -> dict[str, set[str]]:
        await editor.checked()
        await editor.show_folders(added=[two])
        await editor.checked()
        return codes(editor)

    found = in_editor(one.parent, use)
    assert found["one"]
    assert not found["two"]


def test_a_file_is_linted_for_the_robots_of_all_folders_while_it_is_typed(folder: Folder) -> None:
    """The macro is in a package of one folder, and the call in that of another."""
    package = "<package><name>{}</name></package>"
    folder.write(
        {
            ".git/HEAD": "",
            "shared/package.xml": package.format("shared"),
            "shared/wheel.xacro": SHARED,
            "user/package.xml": package.format("user"),
            "user/robot.xacro": USER,
        }
    )
    shared, user = (folder.path / "shared").resolve(), (folder.path / "user").resolve()

    async def use(editor: Editor) -> list[dict[str, list[tuple[str, int, int]]]]:
        await editor.checked()
        await editor.show_folders(added=[user])
        await editor.open("wheel.xacro")
        states = [await editor.checked()]
        for text in (SHARED.replace('"name">', '"name radius">'), SHARED):
            await editor.type("wheel.xacro", text)
            states.append(await editor.checked())
        return states

    before, broken, mended = in_editor(shared, use)
    assert set(broken) - set(before) == {"../user/robot.xacro"}
    assert mended == before


def test_a_wrong_configuration_in_one_folder_does_not_keep_the_other_from_being_linted(folder: Folder) -> None:
    one, two = ws(folder)
    (two / "urdfctl.toml").write_text("distro = 7\n", encoding="utf-8")

    async def use(editor: Editor) -> tuple[list[str], dict[str, set[str]]]:
        await editor.checked()
        await editor.show_folders(added=[two])
        await editor.checked()
        return editor.messages, codes(editor)

    [message], found = in_editor(one, use)
    assert "urdfctl.toml: distro" in message
    assert found["one"]
