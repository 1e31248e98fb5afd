"""One editor window: its folders, its open texts, and the findings that it was sent."""

from __future__ import annotations

import asyncio
import logging
import os
from collections.abc import Callable, Iterable, Iterator, Mapping
from contextlib import contextmanager, suppress
from functools import partial
from typing import TYPE_CHECKING, Any

from lsprotocol import types
from pygls.exceptions import FeatureRequestError, JsonRpcException, JsonRpcInternalError, JsonRpcParseError

from urdfctl import __version__
from urdfctl.diagnostic import Diagnostic
from urdfctl.errors import UserError
from urdfctl.lint.results import TargetResult
from urdfctl.output.scratch import ScratchFolder, scratch_folder
from urdfctl.server.analysis.attempts import Attempts
from urdfctl.server.analysis.checking import Checking
from urdfctl.server.analysis.folders import FoundByFolder
from urdfctl.server.analysis.question import Question
from urdfctl.server.analysis.variants import robot_name
from urdfctl.server.analysis.workspace import Checked, EditorSettings, Workspace, text_on_disk
from urdfctl.server.protocol.diagnostics import shown_diagnostic
from urdfctl.server.protocol.messages import Server
from urdfctl.server.protocol.positions import Positions
from urdfctl.server.protocol.uris import is_readable_in, path_of
from urdfctl.server.protocol.versions import Versions, versioned
from urdfctl.source.span import SourceText

if TYPE_CHECKING:
    from pygls.server import ServerErrors

_log = logging.getLogger(__name__)


class Window(Server):
    """The language server of one editor window: the folders that it shows, and what was found in them last."""

    def __init__(self) -> None:
        super().__init__("urdfctl", __version__)
        self.checking: Checking | None = None
        self.findings: dict[str, tuple[Diagnostic, ...]] = {}
        self._loop: asyncio.AbstractEventLoop | None = None
        self._folders: tuple[str, ...] = ()
        self._texts: dict[str, bytes] = {}
        """The open texts, by the real path of their files."""
        self._found = FoundByFolder(())
        self._tested: dict[str, tuple[Diagnostic, ...]] = {}
        self._changes = 0
        self._versions = Versions()
        self._temporary: ScratchFolder | None = None
        self._commands: set[asyncio.Task[object] | None] = set()
        self.can_pick = False
        self.looked_at: str | None = None
        """The file that was opened, changed or asked about last."""
        self._asked = EditorSettings()
        self._problems: tuple[str, ...] = ()

    # -- the workspace -------------------------------------------------------------------------------------------------

    def begin(self, folders: Iterable[str], asked: EditorSettings) -> None:
        """Lint folders from now on, with the texts that are open; the folder of the first open file if there are none.

        A wrong configuration is told once, and its folder is not linted until it changes.
        """
        if self.checking is not None:
            self.checking.end()
        self._loop = asyncio.get_running_loop()
        self._folders, self._asked = tuple(dict.fromkeys(map(os.path.realpath, folders))), asked
        self._found, self.checking = FoundByFolder(self._folders), None
        self._problems = ()
        checking = Checking(self._opened, partial(self._take, self._found))
        if not checking.workspaces:
            self._show(set(self.findings))
            self.tell_robots()
            return
        self.checking, self._versions = checking, Versions()
        checking.start()
        for document in dict(self.workspace.text_documents).values():
            self.text_changed(document.uri, document.source, document.version)

    def _opened(self, is_outdated: Callable[[], bool]) -> list[Workspace]:
        """The folders whose configuration is valid."""
        opened = []
        for folder in self._folders:
            try:
                opened.append(Workspace(folder, self._asked, is_outdated))
            except UserError as error:
                self._problems += (f"'{folder}' is not linted: {error}",)
                self.window_show_message(types.ShowMessageParams(types.MessageType.Error, f"urdfctl: {error}"))
        return opened

    def again(self, asked: EditorSettings | None = None, folders: Iterable[str] | None = None) -> None:
        """Begin again: the configuration file changed, or the editor's settings or folders did."""
        self.begin(self._folders if folders is None else folders, self._asked if asked is None else asked)

    def text_changed(self, uri: str, text: str | None, version: int | None = None) -> None:
        """Lint with an open file's text; None if it was closed."""
        path = path_of(uri)
        if path is None:
            return
        if text is None:  # perhaps the file is open by another name, too
            same = (one for one in dict(self.workspace.text_documents).values() if path_of(one.uri) == path)
            other = next(same, None)
            text, version = (other.source, other.version) if other else (None, None)
        data = None if text is None else text.encode("utf-8", "surrogatepass")
        if data is None:
            self._texts.pop(path, None)
        else:
            self.looked_at, self._texts[path] = path, data
        if path in self._tested and data not in {None, text_on_disk(path)}:
            del self._tested[path]
        if not self._folders:
            self.begin([os.path.dirname(path)], self._asked)
            return
        if self.checking is not None:
            changes = self.checking.change(lambda workspace: workspace.changed(path, data), near=path)
            self._versions.take(uri, changes, version)

    def admits(self, uri: str) -> bool:
        """Return whether an editor may ask about a file: its text is open, or it is a readable file in a folder."""
        path = path_of(uri)
        return path is not None and (path in self._texts or self.shows(path))

    def shows(self, path: str) -> bool:
        """Return whether a real path is that of a readable file in a folder of the window."""
        return is_readable_in(path, self._folders)

    def temporary_folder(self) -> str:
        """Return a folder for files that are shown; it is deleted when the server ends."""
        if self._temporary is None:
            self._temporary = scratch_folder()
        return self._temporary.name

    @contextmanager
    def running(self) -> Iterator[None]:
        """Within it, the current task is a command, which ends at the latest with the server."""
        task = asyncio.current_task()
        self._commands.add(task)
        try:
            yield
        finally:
            self._commands.discard(task)

    async def end(self) -> None:
        """End the commands that run, lint nothing more, and leave no temporary files."""
        commands = [task for task in self._commands if task is not None]
        for task in commands:
            task.cancel()
        await asyncio.gather(*commands, return_exceptions=True)
        if self.checking is not None:
            self.checking.end()
        if self._temporary is not None:
            self._temporary.cleanup()

    def positions(self) -> Positions:
        """Return what converts positions, as the texts are now."""
        return Positions(self.workspace.position_codec, self._texts.get)

    def question(self, uri: str, position: types.Position) -> Question | None:
        """Return what is asked about a place in a file that `admits` takes; None if no folder is linted."""
        path = path_of(uri)
        if path is None or self.checking is None:
            return None
        self.looked_at = path
        workspace = self.checking.workspace_of(path)
        robots, is_chosen = workspace.robots_with(path), workspace.chosen(path) is not None
        sources = [source for robot in robots for source in robot.sources.values()]
        read = next((one for one in sources if os.path.realpath(one.path) == path), None)
        text = self._texts[path] if path in self._texts else text_on_disk(path) or b""
        line, column = self.positions().line_and_column(path, position)
        packages = workspace.packages_for(path)
        if read is not None and read.data == text:
            return Question(robots, read, line, column, is_chosen=is_chosen, packages=packages)
        source = SourceText(read.path if read else path, text)
        return Question(robots, source, line, column, is_current=False, is_chosen=is_chosen, packages=packages)

    def attempts(self, uri: str) -> Attempts | None:
        """Return what lints the robots of a file with other texts of it; None if no folder is linted."""
        path = path_of(uri)
        return None if path is None or self.checking is None else self.checking.workspace_of(path).attempts(path)

    def unsaved(self) -> set[str]:
        """Return the real paths of the open files whose text differs from that on disk."""
        return {path for path, text in self._texts.items() if text != text_on_disk(path)}

    def log(self, text: str) -> None:
        """Write to the editor's log of the server."""
        self.window_log_message(types.LogMessageParams(types.MessageType.Info, text))

    def report_server_error(self, error: Exception, source: ServerErrors) -> None:
        """Answer what is not JSON; log an error in a notification, and show no message for it."""
        if source is JsonRpcException:
            self.protocol.refuse(None, JsonRpcParseError(f"a message is not JSON: {type(error).__name__}"))
        elif isinstance(error, JsonRpcInternalError):
            _log.error("urdfctl: %s\n%s", error.message, "".join((error.data or {}).get("traceback", ())))
        elif source is not FeatureRequestError:
            _log.error("urdfctl: %s", error)

    def refresh(self) -> None:
        """Let the editor ask again for what it shows in files: another variant is shown."""
        workspace = self.client_capabilities.workspace
        if workspace and workspace.inlay_hint and workspace.inlay_hint.refresh_support:
            self.workspace_inlay_hint_refresh(None)
        if workspace and workspace.code_lens and workspace.code_lens.refresh_support:
            self.workspace_code_lens_refresh(None)

    # -- findings ------------------------------------------------------------------------------------------------------

    def _take(self, found: FoundByFolder, checked: Checked, is_last: bool, changes: int) -> None:  # noqa: FBT001
        """Take the findings from the thread that lints."""
        if self._loop is not None:
            with suppress(RuntimeError):  # the server has ended meanwhile, and its loop is closed
                self._loop.call_soon_threadsafe(self._publish, found, checked, is_last, changes)

    def _publish(self, found: FoundByFolder, checked: Checked, is_last: bool, changes: int) -> None:  # noqa: FBT001
        if found is not self._found:  # by a thread whose folders are not shown any more
            return
        found.take(checked)
        self._changes = changes
        self._show(found.files() | checked.files | set(self.findings if is_last else ()))
        self.tell_robots(is_whole=is_last)

    def tell_robots(self, *, is_whole: bool = True) -> None:
        """Tell the editor what was linted and what was not, for its status item. is_whole: whether that is all."""
        workspaces = self.checking.workspaces if self.checking else ()
        robots = [_robot(result, is_shown) for one in workspaces for result, is_shown in one.robots() if result.robot]
        told = {"whole": is_whole, "changes": self._changes, "robots": robots, "problems": self._problems}
        self.protocol.notify("urdfctl/checked", told)

    def take_tested(self, findings: Mapping[str, tuple[Diagnostic, ...]]) -> None:
        """Show the findings of a smoke test instead of those of the last one. In a file that is changed they end."""
        concerned = {*self._tested, *findings}
        self._tested = dict(findings)
        self._show(concerned)

    def _findings(self, path: str) -> tuple[Diagnostic, ...]:
        """The findings in a file, and those of a smoke test that lint does not have."""
        found = self._found.of(path)
        known = {(finding.code, finding.at.line, finding.at.column) for finding in found}
        more = (one for one in self._tested.get(path, ()) if (one.code, one.at.line, one.at.column) not in known)
        return (*found, *more)

    def _show(self, files: Iterable[str]) -> None:
        """Send the findings in some files, if they are not known to the editor."""
        positions = self.positions()
        for path in sorted(files):
            findings = self._findings(path)
            if findings != self.findings.get(path, ()):
                self._send(path, findings, positions)

    def _send(self, path: str, found: tuple[Diagnostic, ...], positions: Positions) -> None:
        self.findings[path] = found
        shown = [shown_diagnostic(finding, positions) for finding in found]
        version = self._versions.after(path, self._changes)
        self.text_document_publish_diagnostics(
            types.PublishDiagnosticsParams(self._versions.uri_of(path), shown, version)
        )

    def versioned(self, edit: types.WorkspaceEdit) -> types.WorkspaceEdit:
        """Return an edit that is only for the open texts as they are, if the editor understands that."""
        return versioned(edit, self.workspace.text_documents, self.client_capabilities)


def _robot(result: TargetResult, is_shown: bool) -> dict[str, Any]:  # noqa: FBT001
    return {
        "file": result.path,
        "robot": robot_name(result),
        "arguments": dict(result.arguments),
        "launch": result.launch,
        "distro": result.distro,
        "distro_from": "the editor's settings" if result.distro_from == "--distro" else result.distro_from,
        "simulator": result.simulator,
        "files": list(result.files),
        "shown": is_shown,
    }
