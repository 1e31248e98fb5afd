"""What an editor's commands do: they draw, test and migrate the robots of the open file, and choose its variant."""

from __future__ import annotations

import asyncio
import json
import os
import shutil
import subprocess
from collections.abc import Awaitable, Callable
from functools import partial
from pathlib import Path
from typing import Any

import pytest
from editor import Editor, in_editor, path_of, types
from folder import CHECKOUT, Folder
from planned_arm import arm

from urdfctl.server.app import make_server
from urdfctl.smoke.engines.engine import installed
from urdfctl.view.meshes import installed as meshes_are_read

ARM = """<robot name="arm" xmlns:xacro="http://www.ros.org/wiki/xacro">
  <xacro:arg name="prefix" default=""/>
  <xacro:property name="prefix" value="$(arg prefix)"/>
  <link name="base"/>
  <link name="${prefix}fore"/>
  <joint name="${prefix}elbow" type="revolute">
    <parent link="base"/><child link="${prefix}fore"/><axis xyz="0 0 1"/>
    <limit lower="-1" upper="1" effort="1" velocity="1"/>
  </joint>
</robot>
"""
CONFIG = """
[[robot]]
path = "arm.xacro"
matrix = { prefix = ["left_", "right_"] }
"""


class Pages:
    """What the server lets an editor show, and which of several choices its user takes."""

    def __init__(self, editor: Editor, choice: str | None = None) -> None:
        self.texts: dict[str, str] = {}
        self.external: list[bool | None] = []
        self.questions: list[str] = []
        self.edits: list[types.WorkspaceEdit] = []
        self._choice = choice
        editor.client.feature(types.WINDOW_SHOW_DOCUMENT)(partial(self._show))
        editor.client.feature(types.WINDOW_SHOW_MESSAGE_REQUEST)(partial(self._answer))
        editor.client.feature(types.WORKSPACE_APPLY_EDIT)(partial(self._apply))

    def _show(self, params: types.ShowDocumentParams) -> types.ShowDocumentResult:
        path = path_of(params.uri)
        self.texts[path.name] = path.read_text(encoding="utf-8")
        self.external.append(params.external)
        return types.ShowDocumentResult(success=True)

    def _answer(self, params: types.ShowMessageRequestParams) -> types.MessageActionItem | None:
        self.questions += [params.message, *(action.title for action in params.actions or ())]
        return next((action for action in params.actions or () if action.title == self._choice), None)

    def _apply(self, params: types.ApplyWorkspaceEditParams) -> types.ApplyWorkspaceEditResult:
        self.edits.append(params.edit)
        return types.ApplyWorkspaceEditResult(applied=True)


def sample(folder: Folder, name: str = "my_robot") -> Path:
    """A sample robot, in a folder of its own."""
    shutil.copytree(CHECKOUT / "samples" / name, folder.path / name)
    folder.write({f"{name}/.git/HEAD": ""})
    return folder.path / name


async def call(editor: Editor, command: str, name: str, *more: object) -> Any:
    """Call a command for a file."""
    asked = types.ExecuteCommandParams(f"urdfctl.{command}", [editor.document(name).uri, *more])  # type: ignore[list-item]
    return await editor.client.workspace_execute_command_async(asked)


def used(
    path: Path, name: str, use: Callable[[Editor, Pages], Awaitable[Any]], choice: str | None = None, **can: Any
) -> tuple[Any, Pages, list[str]]:
    """What `use` returns in an editor with an open file, what the editor was asked to show, and its messages."""
    pages: list[Pages] = []

    async def run(editor: Editor) -> tuple[Any, list[str]]:
        pages.append(Pages(editor, choice))
        await editor.open(name)
        await editor.checked()
        return await use(editor, pages[0]), editor.messages

    result, messages = in_editor(path, run, can=types.ClientCapabilities(**can))
    return result, pages[0], messages


WINDOW = types.WindowClientCapabilities(show_document=types.ShowDocumentClientCapabilities(support=True))
ROBOT = "urdf/my_robot.xacro"


def test_the_graph_of_the_open_texts_is_shown_in_a_browser(folder: Folder) -> None:
    async def use(editor: Editor, _: Pages) -> object:
        text = (editor.folder / ROBOT).read_text(encoding="utf-8")
        await editor.type(ROBOT, text.replace('name="my_robot"', 'name="unsaved_robot"'))
        await editor.checked()
        return await call(editor, "graph", ROBOT)

    uri, pages, _ = used(sample(folder), ROBOT, use, window=WINDOW)
    assert "unsaved_robot" in pages.texts["graph.html"]
    assert pages.external == [True]
    assert str(uri).endswith("graph.html")
    assert not path_of(str(uri)).exists()  # gone with the server


@pytest.mark.parametrize(("recording", "shown"), [("now.json", "UC832"), ("../now.json", "")])
def test_a_recording_is_opened_beside_the_files(folder: Folder, recording: str, shown: str) -> None:
    async def use(editor: Editor, _: Pages) -> object:
        return await call(editor, "graph", "config/controllers.yaml", (editor.folder / recording).resolve().as_uri())

    path = sample(folder, "picker")
    shutil.copy(path / "now.json", folder.path / "now.json")
    uri, pages, messages = used(path, "config/controllers.yaml", use, window=WINDOW)
    if shown:
        assert shown in pages.texts["graph.html"]
    else:
        assert uri is None
        assert "is not a file in a folder of this window" in messages[-1]


def test_an_editor_that_cannot_open_files_is_told_the_path(folder: Folder) -> None:
    async def use(editor: Editor, _: Pages) -> object:
        return await call(editor, "graph", ROBOT)

    uri, _, messages = used(sample(folder), ROBOT, use)
    assert messages == [f"urdfctl: see {path_of(str(uri))}"]


@pytest.mark.skipif(not meshes_are_read(), reason="the libraries that read meshes are not installed")
def test_the_robot_is_shown_in_3_d(folder: Folder) -> None:
    async def use(editor: Editor, _: Pages) -> object:
        return await call(editor, "view", ROBOT)

    _, pages, _ = used(sample(folder), ROBOT, use, window=WINDOW)
    assert "in 3-D" in pages.texts["robot.html"]


def test_a_command_without_arguments_is_about_the_file_that_was_looked_at_last(folder: Folder) -> None:
    folder.write({".git/HEAD": "", "arm.xacro": ARM, "other.xacro": ARM})

    async def use(editor: Editor, _: Pages) -> list[str]:
        await editor.open("other.xacro")
        await editor.checked()
        asked = types.ExecuteCommandParams("urdfctl.graph")
        await editor.client.workspace_execute_command_async(asked)
        await values(editor)
        await editor.client.workspace_execute_command_async(asked)
        return [message.split("'")[1] for message in editor.messages]

    told, _, _ = used(folder.path, "arm.xacro", use)
    assert told == ["other.xacro", "arm.xacro"]


def test_what_cannot_be_drawn_is_told(folder: Folder) -> None:
    folder.write({".git/HEAD": "", "arm.xacro": ARM})

    async def use(editor: Editor, _: Pages) -> object:
        return await call(editor, "graph", "arm.xacro")

    result, _, messages = used(folder.path, "arm.xacro", use, window=WINDOW)
    assert result is None
    assert messages == ["urdfctl: the robot of 'arm.xacro' has no controllers and no hardware to draw"]


def test_a_rule_is_explained_once(folder: Folder) -> None:
    folder.write({".git/HEAD": "", "arm.xacro": ARM})

    async def use(editor: Editor, _: Pages) -> object:
        asked = types.ExecuteCommandParams("urdfctl.explain", ["UC201"])
        return await editor.client.workspace_execute_command_async(asked)

    text, pages, messages = used(folder.path, "arm.xacro", use, window=WINDOW)
    assert pages.texts == {"UC201.txt": text}
    assert messages == []
    text, pages, messages = used(folder.path, "arm.xacro", use)
    assert pages.texts == {}
    assert messages == [f"urdfctl: {text}"]


def test_the_commands_are_above_the_robot_that_they_are_about(folder: Folder) -> None:
    folder.write(
        {".git/HEAD": "", "arm.xacro": f"<!-- an arm -->\n{ARM}", "urdfctl.toml": CONFIG, "other.yaml": "a: 1\n"}
    )

    async def use(editor: Editor, _: Pages) -> list[Any]:
        asked = types.CodeLensParams(editor.document("arm.xacro"))
        lenses = [*(await editor.client.text_document_code_lens_async(asked) or [])]
        target = (await call(editor, "chooseVariant", "arm.xacro", None))[0]["target"]
        await call(editor, "chooseVariant", "arm.xacro", target)
        lenses += await editor.client.text_document_code_lens_async(asked) or []
        await editor.open("other.yaml")
        other = types.CodeLensParams(editor.document("other.yaml"))
        assert not await editor.client.text_document_code_lens_async(other)
        return lenses

    lenses, _, _ = used(folder.path, "arm.xacro", use)
    assert {lens.range.start.line for lens in lenses} == {1}
    commands = ["graph", "view in 3-D", "smoke test", "plan with MoveIt", "migrate"]
    titles = [*commands, "2 variants", *commands, "shown: arm prefix:=left_"]
    assert [lens.command.title for lens in lenses] == titles
    uri = (folder.path / "arm.xacro").resolve().as_uri()
    assert [list(lens.command.arguments) for lens in lenses] == [[uri]] * len(lenses)


# -- planning --------------------------------------------------------------------------------------------------------


@pytest.mark.parametrize(("package", "output"), [("", "six_moveit"), ("robots/six", "robots/six_description_moveit")])
def test_a_package_that_plans_is_written_beside_that_of_the_robot_and_again_when_asked(
    folder: Folder, package: str, output: str
) -> None:
    pytest.importorskip("mujoco")
    manifest = "<package format='3'><name>six_description</name><version>1.0.0</version></package>"
    name = f"{package}/six.urdf".lstrip("/")
    folder.write({".git/HEAD": "", name: arm(), **({f"{package}/package.xml": manifest} if package else {})})

    async def use(editor: Editor, _: Pages) -> object:
        first = await call(editor, "moveit", name, "jazzy")
        return first, await call(editor, "moveit", name, "jazzy")

    (first, second), pages, messages = used(folder.path, name, use, "Write it again")
    assert first["folder"] == second["folder"] == str(folder.path / output)
    assert (folder.path / output / "config/six.srdf").exists()
    assert f"files written to '{folder.path / output}'" in first["summary"]
    assert second["summary"] == f"'{output}' is up to date"
    assert messages[-2:] == [f"urdfctl: {first['summary']}", f"urdfctl: {second['summary']}"]
    assert pages.questions[0].startswith(f"'{output}' exists.")


def test_why_no_package_that_plans_is_written_is_told(folder: Folder) -> None:
    folder.write({".git/HEAD": "", "arm.xacro": ARM.replace('lower="-1" upper="1"', "")})

    async def use(editor: Editor, _: Pages) -> object:
        return await call(editor, "moveit", "arm.xacro", "jazzy")

    result, _, messages = used(folder.path, "arm.xacro", use)
    assert result is None
    assert messages == ["urdfctl: joint 'elbow' has no position limits, which planning needs"]
    assert not (folder.path / "arm_moveit").exists()


# -- smoke tests -----------------------------------------------------------------------------------------------------


def test_a_smoke_test_shows_its_findings_until_the_file_changes(folder: Folder) -> None:
    path = sample(folder)
    config = path / "config/controllers.yaml"
    text = config.read_text(encoding="utf-8").replace("joint: joint1", "joint: joint9")
    config.write_text(text, encoding="utf-8")

    async def use(editor: Editor, _: Pages) -> object:
        before = await editor.checked()
        result = await call(editor, "smoke", ROBOT)
        await asyncio.sleep(0)
        during = {str(file): {str(one.code) for one in found} for file, found in editor.findings.items()}
        await editor.open("config/controllers.yaml")
        await editor.type("config/controllers.yaml", text + "\n# changed\n")
        await editor.checked()
        after = {str(one.code) for one in editor.findings[editor.folder / "config/controllers.yaml"]}
        return result, before, during, after

    (result, before, during, after), _, messages = used(path, ROBOT, use)
    assert "controllers: " in result["summary"]
    assert "failed" in {controller["verdict"] for controller in result["controllers"]}
    assert messages[-1] == "urdfctl: " + result["summary"]
    smoked = {code for codes in during.values() for code in codes if code.startswith("UC9")}
    assert smoked
    assert not {code for found in before.values() for code, _, _ in found} & smoked
    assert not after & smoked


@pytest.mark.skipif(not installed(), reason="no physics engine is installed")
def test_a_smoke_test_shows_how_far_it_is_and_can_be_cancelled(folder: Folder) -> None:
    """It is cancelled when the first report comes."""
    kinds: list[str] = []

    async def use(editor: Editor, _: Pages) -> object:
        def report(params: types.ProgressParams) -> None:
            kinds.append(params.value["kind"] if isinstance(params.value, dict) else params.value.kind)
            if kinds == ["begin"]:
                cancelled = types.WorkDoneProgressCancelParams(params.token)
                editor.client.window_work_done_progress_cancel(cancelled)

        editor.client.feature(types.WINDOW_WORK_DONE_PROGRESS_CREATE)(lambda _: None)
        editor.client.protocol.fm.features[types.PROGRESS] = report
        return await call(editor, "smoke", ROBOT)

    window = types.WindowClientCapabilities(work_done_progress=True)
    result, _, messages = used(sample(folder), ROBOT, use, window=window)
    assert kinds[0] == "begin"
    assert kinds[-1] == "end"
    assert result is None or "interrupted" in result["summary"]
    assert "cancelled" in messages[-1] or "interrupted" in messages[-1]


@pytest.mark.skipif(os.name != "posix", reason="processes are listed as POSIX lists them")
def test_a_smoke_test_ends_with_the_server(folder: Folder) -> None:
    async def use(editor: Editor, _: Pages) -> list[str]:
        asking = asyncio.create_task(call(editor, "smoke", ROBOT))
        while not (processes := children(editor.pid)):
            await asyncio.sleep(0.05)
        asking.add_done_callback(lambda task: task.exception())
        return processes

    processes, _, _ = used(sample(folder), ROBOT, use)
    assert processes
    assert not [process for process in processes if Path(f"/proc/{process}").exists()]


def children(pid: int) -> list[str]:
    """The numbers of the processes that a process started."""
    listed = subprocess.run(["ps", "-e", "-o", "pid=,ppid="], capture_output=True, text=True, check=True).stdout
    return [process for process, parent in map(str.split, listed.splitlines()) if parent == str(pid)]


# -- migration -------------------------------------------------------------------------------------------------------


def migrated(folder: Folder, choice: str | None, *distro: str, **can: Any) -> tuple[Any, Pages, list[str]]:
    async def use(editor: Editor, _: Pages) -> object:
        return await call(editor, "migrate", "urdf/mybot.xacro", *distro)

    return used(sample(folder, "mybot"), "urdf/mybot.xacro", use, choice, **can)


def applied(edit: types.WorkspaceEdit) -> None:
    """Make the changes of an edit on disk."""
    for change in edit.document_changes or ():
        if isinstance(change, types.TextDocumentEdit):
            path = path_of(change.text_document.uri)
            lines = path.read_text(encoding="utf-8").split("\n")
            for each in sorted(change.edits, key=lambda one: one.range.start.line, reverse=True):
                start, end = each.range.start, each.range.end
                assert not isinstance(each, types.SnippetTextEdit)
                text = lines[start.line][: start.character] + each.new_text + lines[end.line][end.character :]
                lines[start.line : end.line + 1] = text.split("\n")
            path.write_text("\n".join(lines), encoding="utf-8")
        elif isinstance(change, types.CreateFile):
            path_of(change.uri).parent.mkdir(exist_ok=True)
            path_of(change.uri).touch()
        else:
            assert isinstance(change, types.DeleteFile)
            path_of(change.uri).unlink()


CHANGES = types.WorkspaceEditClientCapabilities(
    document_changes=True, change_annotation_support=types.ChangeAnnotationsSupportOptions()
)


def test_a_migration_is_an_edit_that_needs_confirmation_and_does_what_the_command_does(folder: Folder) -> None:
    workspace = types.WorkspaceClientCapabilities(workspace_edit=CHANGES)
    result, pages, _ = migrated(folder, None, "jazzy", workspace=workspace)
    [edit] = pages.edits
    assert result["applied"]
    assert [annotation.needs_confirmation for annotation in (edit.change_annotations or {}).values()] == [True]
    assert pages.questions == []
    applied(edit)
    folder.run("migrate", str(CHECKOUT / "samples/mybot"), "--to", "jazzy", "-o", "expected")
    there = {str(path.relative_to(folder.path / "expected")) for path in (folder.path / "expected").rglob("*.*")}
    assert "launch/control.launch.py" in there
    for name in there - {"MIGRATION.md"}:
        assert (folder.path / "mybot" / name).read_text() == (folder.path / "expected" / name).read_text(), name


def test_an_editor_without_a_preview_asks_before_it_changes_files(folder: Folder) -> None:
    can = types.WorkspaceEditClientCapabilities(document_changes=True)
    workspace = types.WorkspaceClientCapabilities(workspace_edit=can)
    result, pages, _ = migrated(folder, "Change the files", "jazzy", workspace=workspace)
    assert pages.questions == ["The migration changes 8 files.", "Change the files", "Show the changes"]
    assert result["applied"]
    [edit] = pages.edits
    assert edit.change_annotations is None


def test_the_changes_can_be_shown_instead(folder: Folder) -> None:
    result, pages, _ = migrated(folder, "Show the changes", "jazzy", window=WINDOW)
    assert not result["applied"]
    assert pages.edits == []
    assert "+find_package(ament_cmake REQUIRED)" in pages.texts["migration.patch"]


def test_the_distro_is_asked_for(folder: Folder) -> None:
    result, pages, _ = migrated(folder, None)
    assert result is None
    assert pages.questions[0] == "Migrate the package to which ROS distro?"
    assert {"jazzy", "rolling"} <= set(pages.questions)


def test_an_unknown_distro_is_told(folder: Folder) -> None:
    _, _, messages = migrated(folder, None, "jazzi")
    assert "unknown distro 'jazzi'; did you mean 'jazzy'?" in messages[-1]


def test_a_file_with_unsaved_changes_is_not_migrated(folder: Folder) -> None:
    async def use(editor: Editor, _: Pages) -> object:
        await editor.open("package.xml", "<package><name>mybot</name></package>")
        return await call(editor, "migrate", "urdf/mybot.xacro", "jazzy")

    result, pages, messages = used(sample(folder, "mybot"), "urdf/mybot.xacro", use)
    assert result is None
    assert pages.edits == []
    assert "package.xml' has unsaved changes; save it before the migration" in messages[-1]


# -- variants --------------------------------------------------------------------------------------------------------


async def values(editor: Editor) -> list[str]:
    """The values beside the expressions of the open file."""
    whole = types.Range(types.Position(0, 0), types.Position(99, 0))
    hints = await editor.client.text_document_inlay_hint_async(
        types.InlayHintParams(editor.document("arm.xacro"), whole)
    )
    return [str(hint.label) for hint in hints or ()]


async def hovered(editor: Editor) -> str:
    """What is shown about the joint's name."""
    at = types.Position(5, 24)
    hover = await editor.client.text_document_hover_async(types.HoverParams(editor.document("arm.xacro"), at))
    assert hover is not None
    assert isinstance(hover.contents, types.MarkupContent)
    return hover.contents.value


def test_the_variants_of_the_open_file_are_listed_and_one_of_them_is_shown(folder: Folder) -> None:
    folder.write({".git/HEAD": "", "arm.xacro": ARM, "urdfctl.toml": CONFIG})

    async def use(editor: Editor, _: Pages) -> Any:
        request = {"uri": editor.document("arm.xacro").uri}
        listed = await editor.client.protocol.send_request_async("urdfctl/variants", request)
        both = await values(editor), await hovered(editor)
        right = next(one for one in listed if one["arguments"]["prefix"] == "right_")
        after = await call(editor, "chooseVariant", "arm.xacro", right["target"])
        chosen = await values(editor), await hovered(editor)
        shown = {robot.arguments.prefix for robot in editor.robots if robot.shown}
        await editor.type("arm.xacro", ARM.replace('"base"/>', '"base" />'))
        await editor.checked()
        typed = await values(editor)
        await call(editor, "chooseVariant", "arm.xacro", None)
        return [one["title"] for one in listed], both, chosen, shown, after, typed, await values(editor)

    (titles, both, chosen, shown, after, typed, again), _, _ = used(folder.path, "arm.xacro", use)
    assert titles == ["arm prefix:=left_", "arm prefix:=right_"]
    assert "= right_fore" not in both[0]
    assert "left_elbow" in both[1]
    assert "right_elbow" in both[1]
    assert "= right_fore" in chosen[0]
    assert "right_elbow" in chosen[1]
    assert "left_elbow" not in chosen[1]
    assert shown == {"right_"}
    assert [one["shown"] for one in after] == [False, True]
    assert typed == chosen[0]
    assert again == both[0]


def test_the_variant_is_asked_for_in_plain_editors(folder: Folder) -> None:
    folder.write({".git/HEAD": "", "arm.xacro": ARM, "urdfctl.toml": CONFIG})

    async def use(editor: Editor, _: Pages) -> object:
        await call(editor, "chooseVariant", "arm.xacro")
        return await values(editor)

    shown, pages, _ = used(folder.path, "arm.xacro", use, "arm prefix:=left_")
    assert pages.questions[1:] == ["all variants", "arm prefix:=left_", "arm prefix:=right_"]
    assert "= left_fore" in shown


def test_variants_of_two_descriptions_with_one_name_have_different_titles(folder: Folder) -> None:
    """Both include the open file."""
    robot = (
        '<robot name="arm" xmlns:xacro="http://www.ros.org/wiki/xacro"><xacro:include filename="part.xacro"/></robot>'
    )
    part = ARM.replace(' name="arm"', "")
    folder.write({".git/HEAD": "", "part.xacro": part, "a.urdf.xacro": robot, "b.urdf.xacro": robot})

    async def use(editor: Editor, _: Pages) -> list[str]:
        request = {"uri": editor.document("part.xacro").uri}
        listed = await editor.client.protocol.send_request_async("urdfctl/variants", request)
        return sorted(one["title"] for one in listed)

    titles, _, _ = used(folder.path, "part.xacro", use)
    assert titles == ["arm in a.urdf.xacro", "arm in b.urdf.xacro"]


def test_a_robot_whose_name_is_unknown_is_called_as_its_file(folder: Folder) -> None:
    robot = ARM.replace('name="arm"', 'name="$(arg robot_name)"', 1)
    folder.write({".git/HEAD": "", "arm.xacro": robot})

    async def use(editor: Editor, _: Pages) -> tuple[list[str], list[str]]:
        request = {"uri": editor.document("arm.xacro").uri}
        listed = await editor.client.protocol.send_request_async("urdfctl/variants", request)
        return [one["title"] for one in listed], [robot.robot for robot in editor.robots]

    found, _, _ = used(folder.path, "arm.xacro", use)
    assert found == (["arm.xacro"], ["arm.xacro"])


def test_an_editor_that_cannot_ask_is_told_the_choices(folder: Folder) -> None:
    folder.write({".git/HEAD": "", "arm.xacro": ARM, "urdfctl.toml": CONFIG})

    async def use(editor: Editor) -> list[str]:
        await editor.open("arm.xacro")
        await editor.checked()
        await call(editor, "chooseVariant", "arm.xacro")
        return editor.messages

    choices = "all variants, arm prefix:=left_, arm prefix:=right_"
    question = "Show the values of which variant?"
    assert in_editor(folder.path, use) == [f"urdfctl: this editor cannot ask: {question} ({choices})"]


def test_a_variant_that_is_none_of_the_files_is_refused(folder: Folder) -> None:
    folder.write({".git/HEAD": "", "arm.xacro": ARM, "urdfctl.toml": CONFIG})

    async def use(editor: Editor, _: Pages) -> object:
        return [await call(editor, "chooseVariant", "arm.xacro", one) for one in ({"path": "b"}, 7, "left_")]

    results, _, messages = used(folder.path, "arm.xacro", use)
    assert results == [None, None, None]
    assert len(messages) == 3


# -- the extension for VS Code ---------------------------------------------------------------------------------------


def test_each_command_is_in_the_palette_of_vs_code_and_in_the_documentation() -> None:
    manifest = json.loads((CHECKOUT / "editors/vscode/package.json").read_text(encoding="utf-8"))
    palette = {each["command"] for each in manifest["contributes"]["commands"]}
    documented = (CHECKOUT / "docs/editors.md").read_text(encoding="utf-8")
    commands = set(make_server().protocol.fm.commands)
    assert commands - palette == {"urdfctl.explain"}  # of a finding; in the palette it is that at the cursor
    assert [command for command in commands if f"`{command}`" not in documented] == []
