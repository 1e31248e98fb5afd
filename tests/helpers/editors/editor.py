"""An editor for tests: opens and changes files through `urdfctl server`, and keeps the findings that it is sent."""

from __future__ import annotations

import asyncio
import os
import sys
from collections.abc import Awaitable, Callable, Sequence
from functools import partial
from pathlib import Path
from typing import Any, TypeVar

import pytest

pytest.importorskip("pygls", reason="pygls is not installed")
from lsprotocol import types
from pygls.lsp.client import LanguageClient

CHECKOUT = Path(__file__).parents[3]
SECONDS = 120.0
"""After this, a test fails that waits for a server which no longer answers."""
Result = TypeVar("Result")


class Editor:
    """One window with one folder."""

    def __init__(
        self,
        folder: Path,
        encodings: list[str] | None = None,
        wishes: object = None,
        can: types.ClientCapabilities | None = None,
    ) -> None:
        self.folder = folder
        self.encodings = encodings
        self.wishes = wishes
        self.can = can or types.ClientCapabilities()
        self.client = LanguageClient("editor", "1")
        self.findings: dict[Path, list[types.Diagnostic]] = {}
        self.robots: list[Any] = []
        self.messages: list[str] = []
        self.problems: list[str] = []
        self.versions: list[int | None] = []
        """The versions of the texts that the findings were sent for."""
        self._versions: dict[Path, int] = {}
        self._sent = 0
        self._near = asyncio.Event()
        self._whole = asyncio.Event()
        self.client.feature(types.TEXT_DOCUMENT_PUBLISH_DIAGNOSTICS)(partial(self._take))
        self.client.feature(types.WINDOW_SHOW_MESSAGE)(lambda params: self.messages.append(params.message))
        self.client.feature("urdfctl/checked")(partial(self._checked))

    def _take(self, params: types.PublishDiagnosticsParams) -> None:
        self.findings[path_of(params.uri)] = list(params.diagnostics)
        self.versions.append(params.version)

    def _checked(self, params: Any) -> None:
        self.problems = list(params.problems)
        if params.changes == self._sent:
            self._near.set()
        if params.whole and params.changes == self._sent:
            self.robots = list(params.robots)
            self._whole.set()

    def _sends(self) -> None:
        self._sent += 1
        self._near.clear()
        self._whole.clear()

    async def start(self) -> types.InitializeResult:
        """Start the server of this checkout and show it the folder."""
        code = "import sys; from urdfctl.__main__ import main; sys.argv = ['urdfctl', 'server']; sys.exit(main())"
        await self.client.start_io(sys.executable, "-c", code, env=self.environment())
        self.can.general = types.GeneralClientCapabilities(position_encodings=self.encodings)  # type: ignore[arg-type]
        folder = types.WorkspaceFolder(self.folder.as_uri(), "folder")
        result = await self.client.initialize_async(
            types.InitializeParams(
                capabilities=self.can,
                process_id=os.getpid(),
                initialization_options=self.wishes,
                workspace_folders=[folder],
            )
        )
        self.client.initialized(types.InitializedParams())
        return result

    async def stop(self) -> None:
        """Close the window."""
        await self.client.shutdown_async(None)
        self.client.exit(None)
        await self.client.stop()

    async def open(self, name: str, text: str | None = None) -> None:
        """Open a file of the folder, or a new one with this text."""
        path = self.folder / name
        shown = path.read_text(encoding="utf-8") if text is None else text
        self._versions[path] = 1
        self._sends()
        item = types.TextDocumentItem(uri=path.as_uri(), language_id="xacro", version=1, text=shown)
        self.client.text_document_did_open(types.DidOpenTextDocumentParams(item))

    async def type(self, name: str, text: str) -> None:
        """Replace the text of an open file, without saving it."""
        await self.change(name, types.TextDocumentContentChangeWholeDocument(text))

    async def change(self, name: str, change: types.TextDocumentContentChangeEvent) -> None:
        """Change the text of an open file, as a whole or in part."""
        path = self.folder / name
        self._versions[path] += 1
        self._sends()
        version = types.VersionedTextDocumentIdentifier(uri=path.as_uri(), version=self._versions[path])
        self.client.text_document_did_change(types.DidChangeTextDocumentParams(version, [change]))

    async def save(self, name: str, text: str) -> None:
        """Write a file and say so."""
        (self.folder / name).write_text(text, encoding="utf-8")
        self._sends()
        self.client.text_document_did_save(types.DidSaveTextDocumentParams(self.document(name)))

    async def close(self, name: str) -> None:
        """Close a file without saving it."""
        self._sends()
        self._versions.pop(self.folder / name)
        document = types.TextDocumentIdentifier((self.folder / name).as_uri())
        self.client.text_document_did_close(types.DidCloseTextDocumentParams(document))

    async def show_folders(self, *, added: Sequence[Path] = (), removed: Sequence[Path] = ()) -> None:
        """Show more folders, or fewer. The server then takes all open texts again."""
        self._sent = len(self._versions)
        self._near.clear()
        self._whole.clear()
        both = ([types.WorkspaceFolder(path.as_uri(), path.name) for path in paths] for paths in (added, removed))
        event = types.WorkspaceFoldersChangeEvent(*both)
        self.client.workspace_did_change_workspace_folders(types.DidChangeWorkspaceFoldersParams(event))

    async def told(self, kind: types.FileChangeType, name: str) -> None:
        """Tell the server that another program created, changed or deleted a file."""
        self._sends()
        event = types.FileEvent((self.folder / name).as_uri(), kind)
        self.client.workspace_did_change_watched_files(types.DidChangeWatchedFilesParams([event]))

    async def checked(self) -> dict[str, list[tuple[str, int, int]]]:
        """Wait until everything is linted; return the findings by file: codes with lines and columns, from 0."""
        await asyncio.wait_for(self._whole.wait(), SECONDS)
        return {
            os.path.relpath(path, self.folder): [
                (str(found.code), found.range.start.line, found.range.start.character) for found in findings
            ]
            for path, findings in sorted(self.findings.items())
            if findings
        }

    async def checked_near(self) -> None:
        """Wait until the package of the last changed file is linted."""
        await asyncio.wait_for(self._near.wait(), SECONDS)

    @property
    def pid(self) -> int:
        """The number of the server's process."""
        server = self.client._server
        assert server is not None
        return server.pid

    @staticmethod
    def environment() -> dict[str, str]:
        """The environment in which the server and other commands are those of this checkout."""
        return {**os.environ, "PYTHONPATH": str(CHECKOUT)}

    def document(self, name: str) -> types.TextDocumentIdentifier:
        """Return a file as requests name it."""
        return types.TextDocumentIdentifier((self.folder / name).as_uri())


def path_of(uri: str) -> Path:
    """Return the path of a file's URI."""
    from pygls import uris

    return Path(uris.to_fs_path(uri) or "")


def in_editor(
    folder: Path,
    use: Callable[[Editor], Awaitable[Result]],
    encodings: list[str] | None = None,
    wishes: object = None,
    can: types.ClientCapabilities | None = None,
) -> Result:
    """Return what `use` returns for an editor that shows a folder."""

    async def run() -> Result:
        editor = Editor(folder.resolve(), encodings, wishes, can)
        await editor.start()
        try:
            return await use(editor)
        finally:
            await editor.stop()

    return asyncio.run(run())
