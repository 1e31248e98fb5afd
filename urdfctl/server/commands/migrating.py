"""What `urdfctl migrate` would change, as an edit that the user confirms."""

from __future__ import annotations

import os
from collections.abc import Iterator, Sequence

from lsprotocol import types

from urdfctl.errors import UserError
from urdfctl.server.commands.patches import PatchedFile
from urdfctl.server.protocol.uris import uri_of
from urdfctl.source.disk.files import MAX_BYTES, first_bytes

_ANNOTATION = "migrate"

Operation = types.TextDocumentEdit | types.CreateFile | types.RenameFile | types.DeleteFile


def edit_of_patch(files: Sequence[PatchedFile], folder: str, label: str, *, is_annotated: bool) -> types.WorkspaceEdit:
    """Return the edit that makes the changes of a patch.

    folder: what the paths of the patch are relative to.
    is_annotated: whether the editor shows annotated edits for confirmation.
    Raises UserError if a file has bytes that an editor cannot hold, or cannot be read.
    """
    changes = [operation for file in files for operation in _operations(file, folder, is_annotated=is_annotated)]
    annotation = types.ChangeAnnotation(label, needs_confirmation=True)
    return types.WorkspaceEdit(
        document_changes=changes, change_annotations={_ANNOTATION: annotation} if is_annotated else None
    )


def paths_of_patch(files: Sequence[PatchedFile], folder: str) -> list[str]:
    """Return the paths of the files that a patch changes."""
    return [os.path.join(folder, os.fsdecode(file.path)) for file in files]


def _operations(file: PatchedFile, folder: str, *, is_annotated: bool) -> Iterator[Operation]:
    [path] = paths_of_patch([file], folder)
    uri = uri_of(path)
    annotation = _ANNOTATION if is_annotated else None
    if file.is_deleted:
        yield types.DeleteFile(uri, annotation_id=annotation)
        return
    if file.is_new:
        yield types.CreateFile(uri, annotation_id=annotation)
    edits = [*_text_edits(file, b"" if file.is_new else _text_on_disk(path))]
    if edits:
        shown = [
            types.AnnotatedTextEdit(_ANNOTATION, edit.range, edit.new_text) if is_annotated else edit for edit in edits
        ]
        yield types.TextDocumentEdit(types.OptionalVersionedTextDocumentIdentifier(uri, None), shown)


def _text_on_disk(path: str) -> bytes:
    try:
        return first_bytes(path, MAX_BYTES)
    except OSError as error:
        raise UserError(f"'{path}' cannot be read: {error.strerror}") from None


def _text_edits(file: PatchedFile, before: bytes) -> Iterator[types.TextEdit]:
    """The edits of a file's lines; the whole text where the editor has other lines than the patch."""
    lines = before.split(b"\n")
    if b"\r" in before.replace(b"\r\n", b""):
        yield types.TextEdit(
            types.Range(types.Position(0, 0), types.Position(len(lines) + before.count(b"\r"), 0)),
            _text(file.applied(before), file),
        )
        return
    for edit in file.edits:
        start, end = _place(edit.start, lines), _place(edit.end, lines)
        yield types.TextEdit(types.Range(start, end), _text(edit.text, file))


def _place(line: int, lines: Sequence[bytes]) -> types.Position:
    """The beginning of a line; the end of the text if there is no such line."""
    if line < len(lines):
        return types.Position(line, 0)
    return types.Position(len(lines) - 1, len(lines[-1]))


def _text(data: bytes, file: PatchedFile) -> str:
    try:
        return data.decode("utf-8")
    except UnicodeDecodeError:
        name = os.fsdecode(file.path)
        raise UserError(f"'{name}' is not UTF-8: migrate it with `urdfctl migrate` in a terminal") from None
