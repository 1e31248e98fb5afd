"""Beside whole texts, editors send parts in units of their own, versions, cancelled questions, and news of files."""

from __future__ import annotations

import asyncio
import json
import random
from pathlib import Path

import pytest
from editor import Editor, in_editor, types
from edits import edited
from folder import Folder
from pygls.exceptions import JsonRpcException
from pygls.workspace import PositionCodec

Found = dict[str, list[tuple[str, int, int]]]
NAME = "robot.xacro"
TEXT = """<robot name="r" xmlns:xacro="http://www.ros.org/wiki/xacro">
  <!-- 🤖 --><link name="base"/><!-- é --><link name="base"/>
  <joint name="j" type="revolute">
    <parent link="base"/><child link="arm"/><axis xyz="0 0 1"/>
  </joint>
  <link name="arm"/>
</robot>
"""
UNITS = ["utf-8", "utf-16", "utf-32"]


def ws(folder: Folder, text: str = TEXT) -> Path:
    folder.write({".git/HEAD": ""})
    (folder.path / NAME).write_text(text, encoding="utf-8", newline="")
    return folder.path


def linted(folder: Folder) -> Found:
    """What `urdfctl lint` finds on disk: codes with lines and columns from 0, in code points."""
    ran = folder.run("lint", ".", "--format", "json", "--exit-zero", "--no-cache")
    found: Found = {}
    for finding in json.loads(ran.stdout)["findings"]:
        for place in (finding, *finding["also"]):
            at = place if "line" in place else place["at"]
            found.setdefault(at["file"], []).append((finding["code"], at["line"] - 1, at["column"] - 1))
    return {file: sorted(codes) for file, codes in found.items()}


def changes(before: str, after: str, codec: PositionCodec) -> types.TextDocumentContentChangePartial:
    """The change of a text as an editor sends it: only what differs."""
    start = next((n for n, pair in enumerate(zip(before, after, strict=False)) if len(set(pair)) > 1), None)
    start = min(len(before), len(after)) if start is None else start
    while start and before[start - 1 : start + 1] == "\r\n":
        start -= 1
    tail = 0
    while tail < min(len(before), len(after)) - start and before[-1 - tail] == after[-1 - tail]:
        tail += 1
    end = len(before) - tail
    lines = before.splitlines(keepends=True) or [""]
    place = [position(before, offset) for offset in (start, end)]
    units = [codec.position_to_client_units([*lines, ""], at) for at in place]
    return types.TextDocumentContentChangePartial(types.Range(*units), after[start : len(after) - tail])


def position(text: str, offset: int) -> types.Position:
    before = text[:offset].splitlines(keepends=True)
    is_after_end = not before or before[-1].endswith(("\n", "\r"))
    return types.Position(len(before), 0) if is_after_end else types.Position(len(before) - 1, len(before[-1]))


@pytest.mark.parametrize("unit", UNITS)
@pytest.mark.parametrize("end", ["\n", "\r\n"])
def test_parts_of_texts_in_any_units_give_the_findings_of_the_whole_text(folder: Folder, unit: str, end: str) -> None:
    rng = random.Random(5)  # noqa: S311
    path = ws(folder, TEXT.replace("\n", end))

    async def use(editor: Editor) -> tuple[Found, str]:
        text = TEXT.replace("\n", end)
        await editor.open(NAME, text)
        codec = PositionCodec(types.PositionEncodingKind(unit))
        for _ in range(8):
            after = edited(text, rng)
            await editor.change(NAME, changes(text, after, codec))
            text = after
        last = text.replace("<!-- é", "<!-- é🤖")
        await editor.change(NAME, changes(text, last, codec))
        return await editor.checked(), last

    told, text = in_editor(path, use, [unit])
    (path / NAME).write_text(text, encoding="utf-8", newline="")
    lines = text.splitlines()
    codec = PositionCodec(types.PositionEncodingKind(unit))
    points = {
        file: sorted(
            (code, line, codec.position_from_client_units(lines, types.Position(line, column)).character)
            for code, line, column in found
        )
        for file, found in told.items()
    }
    assert points == linted(folder)


@pytest.mark.parametrize("wanted", [["utf-8", "utf-16"], ["utf-16"], None])
def test_the_server_counts_in_units_that_the_editor_knows(folder: Folder, wanted: list[str] | None) -> None:
    async def use() -> str | None:
        editor = Editor(ws(folder).resolve(), wanted)
        result = await editor.start()
        await editor.stop()
        chosen = result.capabilities.position_encoding
        return str(getattr(chosen, "value", chosen))

    assert asyncio.run(use()) in (wanted or ["utf-16"])


@pytest.mark.parametrize("begin", ["", "\ufeff"])
def test_a_byte_order_mark_and_cr_lf_move_no_finding(folder: Folder, begin: str) -> None:
    path = ws(folder, begin + TEXT.replace("\n", "\r\n"))

    async def use(editor: Editor) -> Found:
        await editor.open(NAME, begin + TEXT.replace("\n", "\r\n"))
        return await editor.checked()

    assert {file: sorted(found) for file, found in in_editor(path, use, ["utf-32"]).items()} == linted(folder)


def test_findings_carry_the_version_that_they_are_about(folder: Folder) -> None:
    async def use(editor: Editor) -> list[int | None]:
        await editor.open(NAME)
        await editor.checked()
        await editor.type(NAME, TEXT.replace('name="arm"', 'name="leg"'))
        await editor.checked()
        return editor.versions

    assert in_editor(ws(folder), use) == [1, 2]


def test_edits_are_for_a_version_if_the_editor_can_tell(folder: Folder) -> None:
    async def use(editor: Editor) -> types.WorkspaceEdit | None:
        await editor.open(NAME)
        await editor.checked()
        at = types.Position(5, 15)
        asked = types.RenameParams(editor.document(NAME), at, "leg")
        return await editor.client.text_document_rename_async(asked)

    understands = types.WorkspaceEditClientCapabilities(document_changes=True)
    can = types.ClientCapabilities(workspace=types.WorkspaceClientCapabilities(workspace_edit=understands))
    edit = in_editor(ws(folder, TEXT.replace('<link name="base"/><!--', "<!--")), use, can=can)
    assert edit is not None
    assert edit.document_changes is not None
    [part] = edit.document_changes
    assert isinstance(part, types.TextDocumentEdit)
    assert part.text_document.version == 1
    assert len(part.edits) == 2


def test_what_cannot_be_renamed_is_refused_before_a_name_is_typed(folder: Folder) -> None:
    text = TEXT.replace('<link name="arm"/>', '<link name="arm${pi}"/>')

    async def use(editor: Editor) -> None:
        await editor.open(NAME, text)
        await editor.checked()
        at = types.Position(5, text.splitlines()[5].index("pi}"))
        with pytest.raises(JsonRpcException, match="property 'pi' is not defined in these files"):
            await editor.client.text_document_prepare_rename_async(types.PrepareRenameParams(editor.document(NAME), at))

    in_editor(ws(folder, text), use)


def test_a_computed_name_is_renamed_with_a_preview(folder: Folder) -> None:
    text = TEXT.replace('<link name="arm"/>', '<xacro:property name="s" value="a"/><link name="${s}rm"/>')

    async def use(editor: Editor) -> tuple[object, types.WorkspaceEdit | None]:
        await editor.open(NAME, text)
        await editor.checked()
        document, at = editor.document(NAME), types.Position(5, text.splitlines()[5].index("rm"))
        asked = types.PrepareRenameParams(document, at)
        offered = await editor.client.text_document_prepare_rename_async(asked)
        return offered, await editor.client.text_document_rename_async(types.RenameParams(document, at, "${s}nkle"))

    understands = types.WorkspaceEditClientCapabilities(
        document_changes=True, change_annotation_support=types.ChangeAnnotationsSupportOptions()
    )
    can = types.ClientCapabilities(workspace=types.WorkspaceClientCapabilities(workspace_edit=understands))
    offered, edit = in_editor(ws(folder, text), use, can=can)
    assert isinstance(offered, types.PrepareRenamePlaceholder)
    assert offered.placeholder == "${s}rm"
    assert edit is not None
    assert edit.document_changes is not None
    assert edit.change_annotations is not None
    assert edit.change_annotations["preview"].needs_confirmation
    [part] = edit.document_changes
    assert isinstance(part, types.TextDocumentEdit)
    assert [one.new_text for one in part.edits if isinstance(one, types.AnnotatedTextEdit)] == ["ankle", "${s}nkle"]


def test_a_file_that_is_opened_by_a_link_has_its_findings_there(folder: Folder, tmp_path: Path) -> None:
    path = ws(folder)
    link = path.parent / f"link_to_{path.name}"
    link.symlink_to(path, target_is_directory=True)

    async def use(editor: Editor) -> list[Path]:
        editor.folder = link
        await editor.open(NAME)
        await editor.checked_near()
        return [file for file, found in editor.findings.items() if found]

    assert link / NAME in in_editor(path, use)


def test_a_question_that_is_cancelled_harms_no_other(folder: Folder) -> None:
    async def use(editor: Editor) -> types.Hover | None:
        await editor.open(NAME)
        await editor.checked()
        asked = types.HoverParams(editor.document(NAME), types.Position(2, 16))
        for number in range(20):
            waiting = editor.client.protocol.send_request("textDocument/hover", asked, msg_id=f"cancelled {number}")
            editor.client.cancel_request(types.CancelParams(id=f"cancelled {number}"))
            waiting.cancel()
        return await editor.client.text_document_hover_async(asked)

    assert "revolute" in str(in_editor(ws(folder), use))


def test_files_that_another_program_writes_are_read_again(folder: Folder) -> None:
    path = ws(folder)

    async def use(editor: Editor) -> list[set[str]]:
        await editor.open(NAME)
        states = [set(await editor.checked())]
        (path / "other.urdf").write_text(TEXT, encoding="utf-8")
        await editor.told(types.FileChangeType.Created, "other.urdf")
        states.append(set(await editor.checked()))
        (path / "other.urdf").write_text('<robot name="r"><link name="a"/></robot>', encoding="utf-8")
        await editor.told(types.FileChangeType.Changed, "other.urdf")
        states.append(set(await editor.checked()))
        (path / NAME).write_text("<robot", encoding="utf-8")  # the open text counts
        await editor.told(types.FileChangeType.Changed, NAME)
        states.append(set(await editor.checked()))
        return states

    assert in_editor(path, use) == [{NAME}, {NAME, "other.urdf"}, {NAME}, {NAME}]
