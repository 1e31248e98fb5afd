"""The protocol: which message of an editor is answered by what."""

from __future__ import annotations

import asyncio
import os
from collections.abc import Iterable
from functools import partial
from typing import Any

from lsprotocol import types
from pygls.lsp.server import LanguageServer

from urdfctl import __version__
from urdfctl.diagnostic import Diagnostic
from urdfctl.errors import UserError
from urdfctl.report.rule_explanation import rule_explanation
from urdfctl.rules import all_rules
from urdfctl.server.actions import EXPLAIN, FIX_ALL, actions_at
from urdfctl.server.checking import Checking
from urdfctl.server.diagnostics import shown_diagnostic
from urdfctl.server.positions import Positions, path_of, uri_of
from urdfctl.server.workspace import Checked, Wishes, Workspace

WATCHED = "**/*.{urdf,xacro,yaml,yml,launch,xml,py,srdf,toml,txt}"


class Server(LanguageServer):
    """The language server of one editor window: the folder that it shows, and what was found in it last."""

    def __init__(self) -> None:
        super().__init__("urdfctl", __version__)
        self.checking: Checking | None = None
        self.findings: dict[str, tuple[Diagnostic, ...]] = {}
        self.last: Checked | None = None
        self._loop: asyncio.AbstractEventLoop | None = None

    # -- the workspace -------------------------------------------------------------------------------------------------

    def begin(self, folder: str, wishes: Wishes) -> None:
        """Lint a folder from now on. A wrong configuration is told, and nothing is linted."""
        self._loop = asyncio.get_running_loop()
        try:
            self.checking = Checking(lambda is_outdated: Workspace(folder, wishes, is_outdated), self._take)
        except UserError as error:
            self.window_show_message(types.ShowMessageParams(types.MessageType.Error, f"urdfctl: {error}"))
            return
        self.checking.start()

    def text_changed(self, uri: str, text: str | None) -> None:
        """Lint with an open file's text; None if it was closed."""
        path = path_of(uri)
        if path is None:
            return
        if self.checking is None:
            self.begin(os.path.dirname(path), Wishes())
        data = None if text is None else text.encode("utf-8", "surrogatepass")
        if self.checking is not None:
            self.checking.change(lambda workspace: workspace.changed(path, data), near=path)

    def positions(self) -> Positions:
        """Return what converts positions, as the texts are now."""
        texts = self.checking.workspace.texts if self.checking else {}
        return Positions(self.workspace.position_codec, lambda path: dict(texts).get(path))

    # -- findings ------------------------------------------------------------------------------------------------------

    def _take(self, checked: Checked, is_whole: bool, changes: int) -> None:  # noqa: FBT001
        """Take the findings from the thread that lints."""
        if self._loop is not None:
            self._loop.call_soon_threadsafe(self._publish, checked, is_whole, changes)

    def _publish(self, checked: Checked, is_whole: bool, changes: int) -> None:  # noqa: FBT001
        if is_whole:
            self.last = checked
        concerned = {*self.findings, *checked.findings} if is_whole else {*checked.findings, *checked.files}
        positions = self.positions()
        for path in sorted(concerned):
            found = checked.findings.get(path, ())
            if found != self.findings.get(path, ()):
                self._send(path, found, positions)
        self.protocol.notify(
            "urdfctl/checked", {"whole": is_whole, "changes": changes, "robots": list(_robots(checked))}
        )

    def _send(self, path: str, found: tuple[Diagnostic, ...], positions: Positions) -> None:
        self.findings[path] = found
        shown = [shown_diagnostic(finding, positions) for finding in found]
        self.text_document_publish_diagnostics(types.PublishDiagnosticsParams(uri_of(path), shown))


def _robots(checked: Checked) -> Iterable[dict[str, Any]]:
    """The robots of a workspace, for the editor's status item."""
    for result in checked.run.robots:
        if result.robot is not None:
            yield {
                "file": result.path,
                "robot": result.robot,
                "arguments": dict(result.arguments),
                "launch": result.launch,
                "distro": result.distro,
                "distro_from": result.distro_from,
                "simulator": result.simulator,
                "files": list(result.files),
            }


def make_server() -> Server:
    """Return a server that answers an editor."""
    server = Server()
    _follow_texts(server)
    _answer_questions(server)
    return server


def _follow_texts(server: Server) -> None:
    """Register what takes the editor's texts."""

    @server.feature(types.INITIALIZED)
    def initialized(ls: Server, _: types.InitializedParams) -> None:
        folders = [path_of(folder.uri) for folder in ls.workspace.folders.values()]
        root = next((folder for folder in folders if folder), None) or ls.workspace.root_path
        if root:
            ls.begin(root, Wishes())

    @server.feature(types.TEXT_DOCUMENT_DID_OPEN)
    def opened(ls: Server, params: types.DidOpenTextDocumentParams) -> None:
        ls.text_changed(params.text_document.uri, params.text_document.text)

    @server.feature(types.TEXT_DOCUMENT_DID_CHANGE)
    def changed(ls: Server, params: types.DidChangeTextDocumentParams) -> None:
        ls.text_changed(params.text_document.uri, ls.workspace.get_text_document(params.text_document.uri).source)

    @server.feature(types.TEXT_DOCUMENT_DID_CLOSE)
    def closed(ls: Server, params: types.DidCloseTextDocumentParams) -> None:
        ls.text_changed(params.text_document.uri, None)

    @server.feature(types.WORKSPACE_DID_CHANGE_WATCHED_FILES)
    def watched(ls: Server, params: types.DidChangeWatchedFilesParams) -> None:
        for event in params.changes:
            path = path_of(event.uri)
            if ls.checking is not None and path is not None:
                is_known = event.type is types.FileChangeType.Changed
                ls.checking.change(partial(Workspace.saved, path=path) if is_known else Workspace.forget)

    @server.feature(types.SHUTDOWN)
    def ended(ls: Server, *_: object) -> None:
        if ls.checking is not None:
            ls.checking.end()


def _answer_questions(server: Server) -> None:
    """Register what answers the editor's questions."""

    @server.feature(types.TEXT_DOCUMENT_CODE_ACTION, types.CodeActionOptions([types.CodeActionKind.QuickFix, FIX_ALL]))
    def actions(ls: Server, params: types.CodeActionParams) -> list[types.CodeAction]:
        found = ls.findings.get(path_of(params.text_document.uri) or "", ())
        wanted = [str(getattr(kind, "value", kind)) for kind in params.context.only or ()]
        return actions_at(found, params.range, ls.positions(), wanted)

    @server.command(EXPLAIN)
    def explain(ls: Server, code: str) -> str:
        rule = next((rule for rule in all_rules() if rule.code == code), None)
        text = rule_explanation(rule) if rule else f"urdfctl has no rule {code}"
        ls.window_show_message(types.ShowMessageParams(types.MessageType.Info, text))
        return text
