"""One editor window: its folders, its open texts, and the findings that it was sent."""

from __future__ import annotations

import asyncio
import os
from collections.abc import Callable, Iterable
from functools import partial
from typing import Any

from lsprotocol import types
from pygls.lsp.server import LanguageServer

from urdfctl import __version__
from urdfctl.diagnostic import Diagnostic
from urdfctl.errors import UserError
from urdfctl.server.checking import Checking
from urdfctl.server.diagnostics import shown_diagnostic
from urdfctl.server.folders import FoundByFolder
from urdfctl.server.positions import Positions, path_of, uri_of
from urdfctl.server.question import Question
from urdfctl.server.workspace import Checked, Wishes, Workspace
from urdfctl.source.span import SourceText


class Window(LanguageServer):
    """The language server of one editor window: the folders that it shows, and what was found in them last."""

    def __init__(self) -> None:
        super().__init__("urdfctl", __version__)
        self.checking: Checking | None = None
        self.findings: dict[str, tuple[Diagnostic, ...]] = {}
        self._loop: asyncio.AbstractEventLoop | None = None
        self._folders: tuple[str, ...] = ()
        self._found = FoundByFolder(())
        self._robots: dict[str, list[dict[str, Any]]] = {}
        self._wishes = Wishes()

    # -- the workspace -------------------------------------------------------------------------------------------------

    def begin(self, folders: Iterable[str], wishes: Wishes) -> None:
        """Lint folders from now on, with the texts that are open; the folder of the first open file if there are none.

        A wrong configuration is told once, and its folder is not linted until it changes.
        """
        if self.checking is not None:
            self.checking.end()
        self._loop = asyncio.get_running_loop()
        self._folders, self._wishes = tuple(dict.fromkeys(map(os.path.realpath, folders))), wishes
        self._found, self._robots, self.checking = FoundByFolder(self._folders), {}, None
        checking = Checking(self._opened, partial(self._take, self._found))
        if not checking.workspaces:
            self._show(set(self.findings))
            return
        self.checking = checking
        checking.start()
        for uri, document in dict(self.workspace.text_documents).items():
            self.text_changed(uri, document.source)

    def _opened(self, is_outdated: Callable[[], bool]) -> list[Workspace]:
        """The folders whose configuration is valid."""
        opened = []
        for folder in self._folders:
            try:
                opened.append(Workspace(folder, self._wishes, is_outdated))
            except UserError as error:
                self.window_show_message(types.ShowMessageParams(types.MessageType.Error, f"urdfctl: {error}"))
        return opened

    def again(self, wishes: Wishes | None = None, folders: Iterable[str] | None = None) -> None:
        """Begin again: the configuration file changed, or the editor's settings or folders did."""
        self.begin(self._folders if folders is None else folders, self._wishes if wishes is None else wishes)

    def text_changed(self, uri: str, text: str | None) -> None:
        """Lint with an open file's text; None if it was closed."""
        path = path_of(uri)
        if path is None:
            return
        if not self._folders:
            self.begin([os.path.dirname(path)], self._wishes)
            return
        data = None if text is None else text.encode("utf-8", "surrogatepass")
        if self.checking is not None:
            self.checking.change(lambda workspace: workspace.changed(path, data), near=path)

    def positions(self) -> Positions:
        """Return what converts positions, as the texts are now."""
        texts = self.checking.workspaces[0].texts if self.checking else {}
        return Positions(self.workspace.position_codec, lambda path: dict(texts).get(path))

    def question(self, uri: str, position: types.Position) -> Question | None:
        """Return what is asked about a place in a file; None for what is no file of a folder."""
        path = path_of(uri)
        if path is None or self.checking is None:
            return None
        robots = self.checking.workspace_of(path).robots_with(path)
        sources = [source for robot in robots for source in robot.sources.values()]
        read = next((one for one in sources if os.path.realpath(one.path) == path), None)
        text = self.workspace.get_text_document(uri).source.encode("utf-8", "surrogatepass")
        line, column = self.positions().line_and_column(path, position)
        if read is not None and read.data == text:
            return Question(robots, read, line, column)
        return Question(robots, SourceText(read.path if read else path, text), line, column, is_current=False)

    # -- findings ------------------------------------------------------------------------------------------------------

    def _take(self, found: FoundByFolder, checked: Checked, is_last: bool, changes: int) -> None:  # noqa: FBT001
        """Take the findings from the thread that lints."""
        if self._loop is not None:
            self._loop.call_soon_threadsafe(self._publish, found, checked, is_last, changes)

    def _publish(self, found: FoundByFolder, checked: Checked, is_last: bool, changes: int) -> None:  # noqa: FBT001
        if found is not self._found:  # by a thread whose folders are not shown any more
            return
        found.take(checked)
        if checked.is_whole:
            self._robots[checked.folder] = list(_robots(checked))
        self._show(found.files() | checked.files | set(self.findings if is_last else ()))
        robots = [robot for robots in self._robots.values() for robot in robots]
        self.protocol.notify("urdfctl/checked", {"whole": is_last, "changes": changes, "robots": robots})

    def _show(self, files: Iterable[str]) -> None:
        """Send the findings in some files, if they are not known to the editor."""
        positions = self.positions()
        for path in sorted(files):
            findings = self._found.of(path)
            if findings != self.findings.get(path, ()):
                self._send(path, findings, positions)

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
