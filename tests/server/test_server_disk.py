"""What the editor's texts, the files on disk and the folder of the window each decide."""

from __future__ import annotations

from pathlib import Path

import pytest
from editor import Editor, in_editor
from folder import Folder

from urdfctl.server.analysis.workspace import EditorSettings, Workspace

MANIFEST = "<package><name>parts</name></package>"
ROBOT = """<robot name="r" xmlns:xacro="http://www.ros.org/wiki/xacro">
  <xacro:include filename="$(find parts)/wheel.xacro"/>
  <link name="base"/>
  <link name="wheel"/>
  <joint name="hinge" type="fixed"><parent link="base"/><child link="wheel"/></joint>
</robot>
"""
PARTS = '<robot xmlns:xacro="http://www.ros.org/wiki/xacro"/>'
FILES = {
    "arm/package.xml": "<package><name>arm</name></package>",
    "arm/urdf/robot.xacro": ROBOT,
    "pieces/package.xml": MANIFEST,
    "pieces/wheel.xacro": PARTS,
}


def codes(live: Workspace) -> set[str]:
    return {one.code for found in live.check().findings.values() for one in found}


def test_a_manifest_counts_before_it_is_saved(folder: Folder) -> None:
    folder.write({".git/HEAD": "", **FILES})
    live = Workspace(str(folder.path), EditorSettings())
    assert "UC003" not in codes(live)
    live.changed(str(folder.path / "pieces/package.xml"), MANIFEST.replace("parts", "other").encode())
    assert "UC003" in codes(live)
    live.changed(str(folder.path / "pieces/package.xml"), None)
    assert "UC003" not in codes(live)


def test_a_text_that_was_never_saved_is_no_file(folder: Folder) -> None:
    folder.write({".git/HEAD": "", **FILES})
    wheel = folder.path / "pieces/wheel.xacro"
    wheel.unlink()
    live = Workspace(str(folder.path), EditorSettings())
    missing = codes(live)
    live.changed(str(wheel), PARTS.encode())
    assert codes(live) == missing
    wheel.write_text(PARTS, encoding="utf-8")
    live.saved(str(wheel))
    assert codes(live) < missing


def test_packages_are_found_from_the_folder_of_the_window(
    folder: Folder, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    """Without a repository or a workspace around it, only the folder that a command runs in tells where they are."""
    (tmp_path / "elsewhere").mkdir()
    inner = Folder(tmp_path / "window")
    inner.write(FILES)
    monkeypatch.chdir(tmp_path / "elsewhere")
    live = Workspace(str(inner.path), EditorSettings())
    assert "UC003" not in codes(live)


def test_an_editor_that_does_not_watch_files_tells_of_those_that_it_saves(folder: Folder) -> None:
    folder.write({".git/HEAD": "", **FILES})
    (folder.path / "pieces/wheel.xacro").unlink()

    async def use(editor: Editor) -> list[bool]:
        await editor.open("pieces/wheel.xacro", PARTS)
        before = await editor.checked()
        await editor.save("pieces/wheel.xacro", PARTS)
        after = await editor.checked()
        return ["arm/urdf/robot.xacro" in found for found in (before, after)]

    assert in_editor(folder.path, use) == [True, False]


def test_what_the_baseline_of_the_configuration_knows_is_not_shown(folder: Folder) -> None:
    folder.write({"r.urdf": "<robot name='r'><link name='a'/><link name='a'/></robot>", "urdfctl.toml": ""})
    assert Workspace(str(folder.path), EditorSettings()).check().findings
    folder.run("lint", "r.urdf", "--write-baseline", "known.json")
    folder.write({"urdfctl.toml": "baseline = 'known.json'\n"})
    assert Workspace(str(folder.path), EditorSettings()).check().findings == {}
