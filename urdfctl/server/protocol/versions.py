"""Versions of open texts: what was linted, and what an edit is for, so that an editor ignores what is out of date."""

from __future__ import annotations

from collections.abc import Mapping
from typing import TYPE_CHECKING

from lsprotocol import types

from urdfctl.server.protocol.uris import path_of, uri_of

if TYPE_CHECKING:
    from pygls.workspace import TextDocument


class Versions:
    """The name and the newest version of each file that was opened, and after how many changes it is linted."""

    def __init__(self) -> None:
        self._known: dict[str, tuple[str, int, int | None]] = {}

    def take(self, uri: str, changes: int, version: int | None) -> None:
        """Remember a file's version; None if it was closed. changes: how many changes there are with it."""
        path = path_of(uri)
        if path is not None:
            self._known[path] = uri, changes, version

    def after(self, path: str, changes: int) -> int | None:
        """Return the version that was linted after so many changes; None if there is a newer one, or it is not open."""
        _, needed, version = self._known.get(path, ("", 0, None))
        return version if needed <= changes else None

    def uri_of(self, path: str) -> str:
        """Return a file's URI as the editor writes it, which can differ in links and escapes."""
        return self._known[path][0] if path in self._known else uri_of(path)


def versioned(
    edit: types.WorkspaceEdit, documents: Mapping[str, TextDocument], client: types.ClientCapabilities
) -> types.WorkspaceEdit:
    """Return an edit that is only for the open texts as they are, if the editor understands that."""
    workspace = client.workspace
    wanted = workspace.workspace_edit if workspace else None
    if edit.changes is None or wanted is None or not wanted.document_changes:
        return edit
    versions = {path_of(uri): (uri, document.version) for uri, document in dict(documents).items()}
    parts = []
    for uri, edits in edit.changes.items():
        open_uri, version = versions.get(path_of(uri), (uri, None))
        parts.append(types.TextDocumentEdit(types.OptionalVersionedTextDocumentIdentifier(open_uri, version), edits))
    return types.WorkspaceEdit(document_changes=parts)


def previewed(edit: types.WorkspaceEdit, why: str, client: types.ClientCapabilities) -> types.WorkspaceEdit:
    """Return a versioned edit that the editor shows before it is made, if the editor can do that."""
    workspace = client.workspace.workspace_edit if client.workspace else None
    if edit.document_changes is None or workspace is None or workspace.change_annotation_support is None:
        return edit
    parts: list[types.TextDocumentEdit | types.CreateFile | types.RenameFile | types.DeleteFile] = []
    for part in edit.document_changes:
        if isinstance(part, types.TextDocumentEdit):
            plain = [one for one in part.edits if isinstance(one, types.TextEdit)]
            shown = [types.AnnotatedTextEdit("preview", one.range, one.new_text) for one in plain]
            parts.append(types.TextDocumentEdit(part.text_document, shown))
    note = types.ChangeAnnotation(label=why, needs_confirmation=True)
    return types.WorkspaceEdit(document_changes=parts, change_annotations={"preview": note})
