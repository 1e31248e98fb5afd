"""The server outlives what strangers may put into a folder, and what is typed and asked in it."""

from __future__ import annotations

import os
from pathlib import Path

import pytest
from editor import Editor, in_editor, types
from folder import Folder
from hostile.robots import HIDDEN, TRIED
from sampling import sample

from urdfctl.server.analysis import workspace

WHERE = [types.Position(0, 0), types.Position(0, 30), types.Position(3, 7), types.Position(10_000, 10_000)]
COMMANDS: dict[str, list[str]] = {
    **{f"urdfctl.{name}": [] for name in ("graph", "view", "smoke", "moveit", "chooseVariant")},
    "urdfctl.migrate": ["jazzy"],
}
ARM = """<robot name="arm">
  <link name="base"/>
  <link name="fore"/>
  <joint name="elbow" type="fixed"><parent link="base"/><child link="fore"/></joint>
</robot>
"""


async def ask_everything(editor: Editor, name: str) -> None:
    """Ask the server whatever an editor asks about an open file."""
    document, client = editor.document(name), editor.client
    await client.text_document_document_symbol_async(types.DocumentSymbolParams(document))
    whole = types.Range(types.Position(0, 0), types.Position(10_000, 0))
    await client.text_document_inlay_hint_async(types.InlayHintParams(document, whole))
    context = types.CodeActionContext(diagnostics=[])
    await client.text_document_code_action_async(types.CodeActionParams(document, whole, context))
    for at in WHERE:
        await client.text_document_hover_async(types.HoverParams(document, at))
        await client.text_document_completion_async(types.CompletionParams(document, at))
        await client.text_document_definition_async(types.DefinitionParams(document, at))
        references = types.ReferenceContext(include_declaration=True)
        await client.text_document_references_async(types.ReferenceParams(references, document, at))


async def is_alive(editor: Editor, folder: Path) -> bool:
    """Return whether a server without complaints still sees a fault of a robot in another folder."""
    (folder / "alive").mkdir(exist_ok=True)
    (folder / "alive" / "arm.urdf").write_text(ARM.replace('"fore"/></joint>', '"four"/></joint>'), encoding="utf-8")
    before = editor.folder
    editor.folder = folder / "alive"
    await editor.show_folders(added=[editor.folder], removed=[before])
    found = await editor.checked()
    assert editor.messages == []
    return any(codes for file, codes in found.items() if file == "arm.urdf")


@pytest.mark.parametrize("tried", sample(TRIED, 3))
def test_a_hostile_file_is_opened_typed_into_and_asked_about(folder: Folder, tried: str) -> None:
    _, files = TRIED[tried]
    folder.write({"secret": HIDDEN, "pull/.git/HEAD": "", **{f"pull/{name}": text for name, text in files.items()}})
    (folder.path / "pull" / "out").symlink_to(folder.path)
    main = next(iter(files))

    async def use(editor: Editor) -> str:
        await editor.open(main)
        await editor.checked()
        await ask_everything(editor, main)
        text = files[main]
        await editor.type(main, f"{text[: len(text) // 2]}<{text[len(text) // 2 :]}")
        await editor.checked()
        await ask_everything(editor, main)
        shown = repr(editor.findings)
        assert await is_alive(editor, folder.path)
        return shown

    shown = in_editor(folder.path / "pull", use)
    assert "urdfctl crashed" not in shown
    assert HIDDEN not in shown
    assert not (folder.path / "ran").exists()


@pytest.mark.parametrize("tried", sample(TRIED, 12))
def test_the_commands_for_a_hostile_file_end_and_harm_nobody(folder: Folder, tried: str) -> None:
    _, files = TRIED[tried]
    folder.write({"secret": HIDDEN, "pull/.git/HEAD": "", **{f"pull/{name}": text for name, text in files.items()}})
    folder.write({"pull/package.xml": "<package><name>p</name></package>"})
    before = {path: path.read_bytes() for path in folder.path.rglob("*") if path.is_file()}
    (folder.path / "pull" / "out").symlink_to(folder.path)
    main = next(iter(files))

    async def use(editor: Editor) -> str:
        await editor.open(main)
        await editor.checked()
        results = []
        for command, words in COMMANDS.items():
            asked = types.ExecuteCommandParams(command, [editor.document(main).uri, *words])
            results.append(await editor.client.workspace_execute_command_async(asked))
        told = [message for message in editor.messages if not message.startswith("urdfctl: ")]
        editor.messages.clear()
        assert told == []
        assert await is_alive(editor, folder.path)
        return repr(results)

    assert HIDDEN not in in_editor(folder.path / "pull", use)
    assert not (folder.path / "ran").exists()
    assert {path: path.read_bytes() for path in before} == before


@pytest.mark.skipif(os.name != "posix", reason="pipes and links are made as POSIX makes them")
def test_links_in_a_circle_pipes_devices_and_bytes_are_no_obstacle(folder: Folder) -> None:
    folder.write({"pull/.git/HEAD": "", "pull/arm.urdf": ARM})
    pull = folder.path / "pull"
    (pull / "around.urdf").symlink_to(pull / "around.urdf")
    (pull / "above").symlink_to(folder.path)
    (pull / "zeros.urdf").symlink_to("/dev/zero")
    os.mkfifo(pull / "pipe.xacro")
    (pull / "bytes.urdf").write_bytes(bytes(range(256)) * 4000)

    async def use(editor: Editor) -> bool:
        for name in ("arm.urdf", "around.urdf", "zeros.urdf", "pipe.xacro", "bytes.urdf", "above/pull/arm.urdf"):
            await editor.open(name, ARM)
            await editor.type(name, "\0\ud7ff\u2028" + ARM)
            await editor.checked()
            await ask_everything(editor, name)
            await editor.close(name)
        return await is_alive(editor, folder.path)

    assert in_editor(pull, use)


def test_a_file_and_its_folder_that_are_deleted_while_they_are_open(folder: Folder) -> None:
    folder.write({"pull/.git/HEAD": "", "pull/urdf/arm.urdf": ARM})

    async def use(editor: Editor) -> bool:
        await editor.open("urdf/arm.urdf")
        await editor.checked()
        (editor.folder / "urdf/arm.urdf").unlink()
        await editor.told(types.FileChangeType.Deleted, "urdf/arm.urdf")
        await editor.checked()
        await ask_everything(editor, "urdf/arm.urdf")
        (editor.folder / "urdf").rmdir()
        await editor.type("urdf/arm.urdf", ARM.replace("elbow", "knee"))
        await editor.checked()
        await ask_everything(editor, "urdf/arm.urdf")
        (editor.folder / ".git/HEAD").unlink()
        (editor.folder / ".git").rmdir()
        editor.folder.rmdir()
        await editor.type("urdf/arm.urdf", ARM)
        await editor.checked()
        await ask_everything(editor, "urdf/arm.urdf")
        return await is_alive(editor, folder.path)

    assert in_editor(folder.path / "pull", use)


@pytest.mark.parametrize("name", ["unnamed", "no/such/folder/arm.urdf", "a name%20 with ü.urdf"])
def test_a_file_that_is_not_on_disk_is_typed_and_asked_about(folder: Folder, name: str) -> None:
    folder.write({"pull/.git/HEAD": ""})

    async def use(editor: Editor) -> bool:
        await editor.open(name, "")
        for length in (1, 40, len(ARM)):
            await editor.type(name, ARM[:length])
            await editor.checked()
            await ask_everything(editor, name)
        await editor.close(name)
        return await is_alive(editor, folder.path)

    assert in_editor(folder.path / "pull", use)


def test_no_question_waits_for_a_robot_that_takes_long_to_read(folder: Folder, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(workspace, "PATIENCE", 0.5)
    folder.write({"slow.urdf": f"<robot name='r'>{'<a/>' * 500_000}</robot>", "quick.urdf": ARM})
    here = workspace.Workspace(str(folder.path), workspace.EditorSettings())
    [slow] = here.robots_with(str(folder.path / "slow.urdf"))
    [quick] = here.robots_with(str(folder.path / "quick.urdf"))
    assert slow.root is None
    assert quick.root is not None
