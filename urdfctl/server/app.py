"""The protocol: which message of an editor is answered by what."""

from __future__ import annotations

from functools import partial

from lsprotocol import types

from urdfctl.server.answers import answer_questions
from urdfctl.server.positions import path_of
from urdfctl.server.window import Window
from urdfctl.server.workspace import Wishes, Workspace

WATCHED = "**/*.{urdf,xacro,yaml,yml,launch,xml,py,srdf,toml,txt}"


def make_server() -> Window:
    """Return a server that answers an editor."""
    server = Window()
    _follow_texts(server)
    answer_questions(server)
    return server


def _follow_texts(server: Window) -> None:
    """Register what takes the editor's texts."""

    @server.feature(types.INITIALIZED)
    def initialized(ls: Window, _: types.InitializedParams) -> None:
        folders = [path_of(folder.uri) for folder in ls.workspace.folders.values()]
        root = next((folder for folder in folders if folder), None) or ls.workspace.root_path
        if root:
            ls.begin(root, Wishes())

    @server.feature(types.TEXT_DOCUMENT_DID_OPEN)
    def opened(ls: Window, params: types.DidOpenTextDocumentParams) -> None:
        ls.text_changed(params.text_document.uri, params.text_document.text)

    @server.feature(types.TEXT_DOCUMENT_DID_CHANGE)
    def changed(ls: Window, params: types.DidChangeTextDocumentParams) -> None:
        ls.text_changed(params.text_document.uri, ls.workspace.get_text_document(params.text_document.uri).source)

    @server.feature(types.TEXT_DOCUMENT_DID_CLOSE)
    def closed(ls: Window, params: types.DidCloseTextDocumentParams) -> None:
        ls.text_changed(params.text_document.uri, None)

    @server.feature(types.WORKSPACE_DID_CHANGE_WATCHED_FILES)
    def watched(ls: Window, params: types.DidChangeWatchedFilesParams) -> None:
        for event in params.changes:
            path = path_of(event.uri)
            if ls.checking is not None and path is not None:
                is_known = event.type is types.FileChangeType.Changed
                ls.checking.change(partial(Workspace.saved, path=path) if is_known else Workspace.forget)

    @server.feature(types.SHUTDOWN)
    def ended(ls: Window, *_: object) -> None:
        if ls.checking is not None:
            ls.checking.end()
