"""The protocol: which message of an editor is answered by what."""

from __future__ import annotations

import os
from functools import partial

from lsprotocol import types

from urdfctl.config.file import NAMES
from urdfctl.server.analysis.workspace import EditorSettings, Workspace
from urdfctl.server.answers import answer_questions
from urdfctl.server.commands.calls import answer_commands
from urdfctl.server.commands.lenses import answer_lenses
from urdfctl.server.protocol.uris import path_of
from urdfctl.server.protocol.window import Window

WATCHED = "**/*.{urdf,xacro,yaml,yml,launch,xml,py,srdf,toml,txt}"


def make_server() -> Window:
    """Return a server that answers an editor."""
    server = Window()
    _begin(server)
    _follow_texts(server)
    answer_questions(server)
    answer_commands(server)
    answer_lenses(server)
    return server


def _begin(server: Window) -> None:
    """Register what says which folder is linted, and how."""
    settings: list[EditorSettings] = []

    @server.feature(types.INITIALIZE)
    def asked(ls: Window, params: types.InitializeParams) -> None:
        options = params.initialization_options
        settings.append(EditorSettings.from_json(options))
        ls.can_pick = isinstance(options, dict) and options.get("pick") is True

    @server.feature(types.INITIALIZED)
    def initialized(ls: Window, _: types.InitializedParams) -> None:
        root = ls.workspace.root_path
        ls.begin(_folders(ls) or ([root] if root else []), settings[-1])
        _watch(ls)

    @server.feature(types.WORKSPACE_DID_CHANGE_WORKSPACE_FOLDERS)
    def other_folders(ls: Window, _: types.DidChangeWorkspaceFoldersParams) -> None:
        ls.again(folders=_folders(ls))

    @server.feature(types.WORKSPACE_DID_CHANGE_CONFIGURATION)
    def configured(ls: Window, params: types.DidChangeConfigurationParams) -> None:
        given = params.settings.get("urdfctl") if isinstance(params.settings, dict) else None
        if given is not None:
            ls.again(EditorSettings.from_json(given))


def _folders(server: Window) -> list[str]:
    """The folders that the editor shows."""
    paths = (path_of(folder.uri) for folder in server.workspace.folders.values())
    return [path for path in paths if path]


def _follow_texts(server: Window) -> None:
    """Register what takes the editor's texts."""

    @server.feature(types.TEXT_DOCUMENT_DID_OPEN)
    def opened(ls: Window, params: types.DidOpenTextDocumentParams) -> None:
        ls.text_changed(params.text_document.uri, params.text_document.text, params.text_document.version)

    @server.feature(types.TEXT_DOCUMENT_DID_CHANGE)
    def changed(ls: Window, params: types.DidChangeTextDocumentParams) -> None:
        document = params.text_document
        ls.text_changed(document.uri, ls.workspace.get_text_document(document.uri).source, document.version)

    @server.feature(types.TEXT_DOCUMENT_DID_CLOSE)
    def closed(ls: Window, params: types.DidCloseTextDocumentParams) -> None:
        ls.text_changed(params.text_document.uri, None)

    @server.feature(types.TEXT_DOCUMENT_DID_SAVE)
    def saved(ls: Window, params: types.DidSaveTextDocumentParams) -> None:
        if not _watches(ls):
            _written(ls, params.text_document.uri)

    @server.feature(types.WORKSPACE_DID_CHANGE_WATCHED_FILES)
    def watched(ls: Window, params: types.DidChangeWatchedFilesParams) -> None:
        for event in params.changes:
            _written(ls, event.uri, is_same_file=event.type is types.FileChangeType.Changed)

    @server.feature(types.SHUTDOWN)
    async def ended(ls: Window, *_: object) -> None:
        await ls.end()


def _written(server: Window, uri: str, *, is_same_file: bool = True) -> None:
    """Take what is on disk now. is_same_file: whether the file existed before, and exists."""
    path = path_of(uri)
    if path is not None and os.path.basename(path) in NAMES:
        server.again()
    elif server.checking is not None and path is not None:
        server.checking.change(partial(Workspace.saved, path=path) if is_same_file else Workspace.forget)


def _watches(server: Window) -> bool:
    """Return whether the editor can tell what is written to disk, by itself or by other programs."""
    workspace = server.client_capabilities.workspace
    watching = workspace.did_change_watched_files if workspace else None
    return watching is not None and bool(watching.dynamic_registration)


def _watch(server: Window) -> None:
    """Ask the editor to tell what is written to disk, if it can."""
    if not _watches(server):
        return
    options = types.DidChangeWatchedFilesRegistrationOptions([types.FileSystemWatcher(WATCHED)])
    asked = types.Registration("files", types.WORKSPACE_DID_CHANGE_WATCHED_FILES, options)
    server.client_register_capability(types.RegistrationParams([asked]))
