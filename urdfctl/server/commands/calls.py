"""The commands that an editor can call: each takes the URI of a file, and is about the robots that read it.

Without one they are about the file that the user looked at last.
"""

from __future__ import annotations

import asyncio
import os
from collections.abc import Awaitable, Callable
from functools import partial
from typing import Any

from lsprotocol import types
from pygls.exceptions import JsonRpcInvalidParams

from urdfctl.catalog.distros import MAINTAINED, ROS2
from urdfctl.errors import UserError
from urdfctl.load.target import Target
from urdfctl.output.printing import visible
from urdfctl.output.scratch import scratch_folder
from urdfctl.server.analysis.folders import folder_of
from urdfctl.server.analysis.workspace import Workspace
from urdfctl.server.commands.migrating import edit_of_patch, paths_of_patch
from urdfctl.server.commands.pages import graph_page, view_page
from urdfctl.server.commands.patches import PatchedFile, read_patch
from urdfctl.server.commands.planning import output_for, summary_of, words_for_planning
from urdfctl.server.commands.processes import Ended, run_command
from urdfctl.server.commands.smoking import tested, words_for
from urdfctl.server.protocol.dialogue import pick, progress, say, show_page
from urdfctl.server.protocol.uris import path_of
from urdfctl.server.protocol.window import Window

GRAPH, VIEW, SMOKE = "urdfctl.graph", "urdfctl.view", "urdfctl.smoke"
MIGRATE, PLAN, CHOOSE_VARIANT = "urdfctl.migrate", "urdfctl.moveit", "urdfctl.chooseVariant"
VARIANTS = "urdfctl/variants"
"""The request for the variants of the robots that read a file."""
_NO_URI = "the URI of a file is missing"
_ALL = "all variants"
_AGAIN = "Write it again"
_APPLY, _SHOW = "Change the files", "Show the changes"

About = Callable[[Window, Workspace, str], Awaitable[Any]]
"""Does a command for a file, given by its path."""


def answer_commands(server: Window) -> None:
    """Register the commands."""
    _show(server)
    _change(server)
    _plan(server)
    _choose(server)


def _show(server: Window) -> None:
    @server.command(GRAPH)
    async def graph(window: Window, *words: Any) -> Any:
        recording = _path(words[1]) if words[1:] else ""

        async def show(window: Window, workspace: Workspace, path: str) -> str:
            if recording and not window.shows(recording):
                raise UserError(f"'{visible(recording)}' is not a file in a folder of this window")
            return await show_page(window, "graph.html", await graph_page(workspace, path, recording))

        return await _about(window, words, show)

    @server.command(VIEW)
    async def view(window: Window, *words: Any) -> Any:
        async def show(window: Window, workspace: Workspace, path: str) -> str:
            return await show_page(window, "robot.html", await view_page(workspace, path))

        return await _about(window, words, show)


def _change(server: Window) -> None:
    @server.command(SMOKE)
    async def smoke(window: Window, *words: Any) -> Any:
        return await _about(window, words, _smoke)

    @server.command(MIGRATE)
    async def migrate(window: Window, *words: Any) -> Any:
        return await _about(window, words, partial(_migrate, distro=_distro(words)))


def _plan(server: Window) -> None:
    @server.command(PLAN)
    async def plan(window: Window, *words: Any) -> Any:
        return await _about(window, words, partial(_write_plans, distro=_distro(words)))


def _choose(server: Window) -> None:
    @server.feature(VARIANTS)
    def variants(window: Window, params: Any) -> list[dict[str, Any]]:
        path = _path(params.get("uri") if isinstance(params, dict) else None)
        if window.checking is None or not window.shows(path):
            return []
        return _variants(window.checking.workspace_of(path), path)

    @server.command(CHOOSE_VARIANT)
    async def choose(window: Window, *words: Any) -> Any:
        async def chosen(window: Window, workspace: Workspace, path: str) -> list[dict[str, Any]] | None:
            return await _choose_variant(window, workspace, path, words[1:])

        return await _about(window, words, chosen)


def _distro(words: tuple[Any, ...]) -> str | None:
    """The distro that a command is told after its file; None if it is told none."""
    return str(words[1]) if words[1:] else None


async def _about(window: Window, words: tuple[Any, ...], do: About) -> Any:
    """Do a command for its file. What is wrong is told, and the result is None then."""
    path = _path(words[0]) if words else window.looked_at
    if path is None:
        raise JsonRpcInvalidParams(_NO_URI)
    if window.checking is None:
        say(window, "no folder is linted", types.MessageType.Warning)
        return None
    if not window.shows(path):
        say(window, f"'{visible(path)}' is not a file in a folder of this window", types.MessageType.Error)
        return None
    try:
        with window.running():
            return await do(window, window.checking.workspace_of(path), path)
    except UserError as error:
        say(window, str(error), types.MessageType.Error)
        return None
    except asyncio.CancelledError:  # the server ends; pygls waits for an answer
        return None


def _path(uri: object) -> str:
    path = path_of(uri) if isinstance(uri, str) else None
    if path is None:
        raise JsonRpcInvalidParams(_NO_URI)
    return path


# -- smoke tests -----------------------------------------------------------------------------------------------------


async def _smoke(window: Window, workspace: Workspace, path: str) -> dict[str, Any] | None:
    """Test the robot that says most about a file, as it is on disk, and show the findings and a summary."""
    if window.unsaved():
        say(window, "the smoke test uses the saved files; there are unsaved changes", types.MessageType.Warning)
    target = workspace.target_with(path)
    title = f"urdfctl: smoke test of {os.path.basename(target.path)}"
    with scratch_folder() as folder:
        report = os.path.join(folder, "report.txt")
        ended, cancelled = await _run(window, words_for(target, report), workspace.folder, title)
        text = _read(report)
    if not ended.output:
        say(window, "the smoke test was cancelled") if cancelled else _raise(ended)
        return None
    result = tested(ended.output, workspace.folder)
    window.log(text)
    window.take_tested(result.findings)
    failed = any(controller["verdict"] == "failed" for controller in result.controllers)
    say(window, result.summary, types.MessageType.Warning if failed else types.MessageType.Info)
    return {"summary": result.summary, "controllers": result.controllers, "report": text}


async def _run(window: Window, words: list[str], folder: str, title: str) -> tuple[Ended, bool]:
    """Run a command with progress; return how it ended, and whether it was cancelled."""
    cancelled = asyncio.Event()
    async with progress(window, title, cancelled) as report:
        ended = await run_command(words, folder, report, cancelled)
    return ended, cancelled.is_set()


def _raise(ended: Ended) -> None:
    raise UserError(ended.reason)


def _read(path: str) -> str:
    try:
        with open(path, encoding="utf-8") as file:
            return file.read()
    except OSError:
        return ""


# -- migration -------------------------------------------------------------------------------------------------------


async def _migrate(window: Window, workspace: Workspace, path: str, distro: str | None) -> dict[str, Any] | None:
    """Migrate the package around a file, in an edit that the user confirms."""
    if distro is None:
        distros = [name for name in ROS2 if name in MAINTAINED]
        chosen = await pick(window, "Migrate the package to which ROS distro?", distros)
        if chosen is None:
            return None
        distro = distros[chosen]
    title = f"urdfctl: migrate to {distro}"
    ended, cancelled = await _run(window, ["migrate", "--to", distro, "--", path], workspace.folder, title)
    if cancelled:
        say(window, "the migration was cancelled")
        return None
    if ended.status not in {0, 1}:
        raise UserError(ended.reason)
    summary = ended.reason
    files = read_patch(ended.output)
    concerned = {os.path.realpath(changed) for changed in paths_of_patch(files, workspace.folder)}
    if foreign := [changed for changed in concerned if folder_of(changed, [workspace.folder]) is None]:
        raise UserError(f"the migration would change '{visible(min(foreign))}', which is not in the folder")
    if unsaved := concerned & window.unsaved():
        raise UserError(f"'{min(unsaved)}' has unsaved changes; save it before the migration")
    is_applied = await _apply(window, files, workspace.folder, title, ended.output) if files else False
    if not files:
        say(window, summary)
    return {"summary": summary, "applied": is_applied}


async def _apply(window: Window, files: list[PatchedFile], folder: str, title: str, patch: bytes) -> bool:
    """Let the user confirm the changes, and make them: in the editor's own preview if it has one. Return whether they
    were made."""
    workspace = window.client_capabilities.workspace
    can = workspace.workspace_edit if workspace else None
    can_change = can is not None and bool(can.document_changes)
    is_annotated = can is not None and can.change_annotation_support is not None
    if not can_change or not is_annotated:
        count = f"{len(files)} file{'' if len(files) == 1 else 's'}"
        choices = [_APPLY, _SHOW] if can_change else [_SHOW]
        chosen = await pick(window, f"The migration changes {count}.", choices)
        if chosen is None or choices[chosen] == _SHOW:
            if chosen is not None:
                await show_page(window, "migration.patch", patch.decode("utf-8", "surrogateescape"))
            return False
    edit = edit_of_patch(files, folder, title, is_annotated=is_annotated)
    done = await window.workspace_apply_edit_async(types.ApplyWorkspaceEditParams(edit, title))
    return done.applied


# -- planning --------------------------------------------------------------------------------------------------------


async def _write_plans(window: Window, workspace: Workspace, path: str, distro: str | None) -> dict[str, Any] | None:
    """Write a package that plans with MoveIt for the robot that says most about a file, as it is on disk."""
    if window.unsaved():
        say(window, "the package is made from the saved files; there are unsaved changes", types.MessageType.Warning)
    target = workspace.target_with(path)
    output = output_for(target, workspace.folder)
    shown = os.path.relpath(output, workspace.folder)
    is_there = os.path.exists(output)
    if is_there:
        told = f"'{visible(shown)}' exists. What you changed in its SRDF is kept, other changes are not."
        if await pick(window, told, [_AGAIN]) is None:
            return None
    words = words_for_planning(target, output, distro or workspace.settings.distro, is_there=is_there)
    ended, cancelled = await _run(window, words, workspace.folder, f"urdfctl: plan with MoveIt in {shown}")
    if cancelled:
        say(window, "no package was written: it was cancelled")
        return None
    if ended.status:
        raise UserError(ended.reason)
    window.log("\n".join(ended.problems))
    summary = summary_of(ended.problems) or f"'{visible(shown)}' is up to date"
    say(window, summary)
    return {"summary": summary, "folder": output}


# -- variants --------------------------------------------------------------------------------------------------------


def _variants(workspace: Workspace, path: str) -> list[dict[str, Any]]:
    chosen = workspace.chosen(path)
    return [variant.to_json(is_shown=variant.target == chosen) for variant in workspace.variants(path)]


async def _choose_variant(
    window: Window, workspace: Workspace, path: str, words: tuple[Any, ...]
) -> list[dict[str, Any]] | None:
    """Show a variant of the robots that read a file: the given one, all if None is given, or else what the user picks.
    Return the variants."""
    variants = workspace.variants(path)
    if not words:
        if not variants:
            raise UserError(f"no robot reads '{os.path.basename(path)}'")
        number = await pick(window, "Show the values of which variant?", [_ALL, *(one.title for one in variants)])
        if number is None:
            return None
        target = variants[number - 1].target if number else None
    else:
        target = _target(words[0])
        if target is not None and target not in {one.target for one in variants}:
            raise UserError(f"'{os.path.basename(path)}' has no such variant")
    workspace.choose(path, target)
    window.tell_robots()
    window.refresh()
    return _variants(workspace, path)


def _target(data: Any) -> Target | None:
    """The target of a variant as the editor got it."""
    if data is None:
        return None
    try:
        return Target.from_json(data)
    except (KeyError, TypeError, ValueError):
        raise UserError("a variant must be the 'target' of one that was listed, or null") from None
