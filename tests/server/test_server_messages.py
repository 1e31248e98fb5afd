"""What is no valid message of an editor is refused, and the server goes on."""

from __future__ import annotations

import json
import threading
import time
from collections.abc import Iterator, Mapping

import pytest
from folder import Folder
from raw_editor import (
    ARM,
    AT,
    INVALID_PARAMS,
    INVALID_REQUEST,
    NO_METHOD,
    NOT_INITIALIZED,
    NOT_JSON,
    SECONDS,
    Message,
    Shared,
    asked,
    assert_well,
    code_of,
    names_in,
    raw_editor,
    shared_server,
    ws,
)

from urdfctl.server.analysis.checking import Checking
from urdfctl.server.analysis.workspace import Checked, EditorSettings, Workspace


@pytest.fixture(scope="module")
def shared(tmp_path_factory: pytest.TempPathFactory) -> Iterator[Shared]:
    with shared_server(tmp_path_factory.mktemp("shared")) as server:
        yield server


def test_before_it_is_initialized_the_server_answers_nothing_else(folder: Folder) -> None:
    here = ws(folder)
    with raw_editor() as editor:
        uri = (here / "arm.urdf").as_uri()
        assert code_of(editor.ask("textDocument/hover", asked("textDocument/hover", uri))) == NOT_INITIALIZED
        assert code_of(editor.ask("shutdown", None)) == NOT_INITIALIZED
        editor.open(uri, ARM)
        assert code_of(editor.ask("initialize", {"capabilities": 1})) == INVALID_PARAMS
        assert (
            code_of(editor.ask("initialize", {"processId": None, "capabilities": {}, "rootUri": 1})) == INVALID_PARAMS
        )
        bad = {"uri": "file:///%00", "name": "bad"}
        params = {"processId": None, "rootUri": None, "capabilities": {}, "workspaceFolders": [bad]}
        assert code_of(editor.ask("initialize", params)) == INVALID_PARAMS
        assert code_of(editor.start(here)) is None
        assert code_of(editor.ask("initialize", {**params, "workspaceFolders": None})) == INVALID_REQUEST
        assert_well(editor)


def test_after_shutdown_every_request_is_refused(folder: Folder) -> None:
    here = ws(folder)
    with raw_editor() as editor:
        editor.start(here)
        assert code_of(editor.ask("shutdown", None)) is None
        uri = (here / "arm.urdf").as_uri()
        for method in ("textDocument/hover", "shutdown", "initialize"):
            params = asked("textDocument/hover", uri)
            assert code_of(editor.ask(method, params)) == INVALID_REQUEST
        editor.open(uri, ARM)
        assert editor.answered_twice == []
        editor.tell("exit", None)
        assert editor.process.wait(30) == 0


@pytest.mark.parametrize(
    "body",
    [
        b"{",
        b"",
        b"nonsense",
        b"\xff\xfe",
        b"[" * 100_000,
        b"9" * 10_000,
        b'{"jsonrpc": "2.0", "id": ' + b"9" * 5000 + b"}",
    ],
    ids=lambda body: repr(body[:20]),
)
def test_what_is_not_json_is_answered_with_an_error_and_the_next_request_is_answered(
    shared: Shared, body: bytes
) -> None:
    editor = shared.editor
    editor.answers.pop(None, None)
    editor.send(body)
    if body:  # a message without a body is none
        assert code_of(editor.answer(None)) == NOT_JSON
    assert_well(editor)


@pytest.mark.parametrize(
    ("message", "code"),
    [
        ([], INVALID_REQUEST),
        (1, INVALID_REQUEST),
        ({}, INVALID_REQUEST),
        ([{"jsonrpc": "2.0", "id": 1, "method": "shutdown"}], INVALID_REQUEST),
        ({"jsonrpc": "1.0", "id": 1, "method": "shutdown"}, INVALID_REQUEST),
        ({"id": 1, "method": "shutdown"}, INVALID_REQUEST),
        ({"jsonrpc": "2.0", "id": 1, "method": 1}, INVALID_REQUEST),
        ({"jsonrpc": "2.0", "id": 1, "method": []}, INVALID_REQUEST),
        ({"jsonrpc": "2.0", "id": [], "method": "textDocument/hover"}, INVALID_REQUEST),
        ({"jsonrpc": "2.0", "id": None, "method": "textDocument/hover"}, INVALID_REQUEST),
        ({"jsonrpc": "2.0", "id": True, "method": "textDocument/hover"}, INVALID_REQUEST),
        ({"jsonrpc": "2.0", "id": 1, "method": "textDocument/hover"}, INVALID_PARAMS),
        ({"jsonrpc": "2.0", "id": 1, "method": "textDocument/didOpen", "params": {}}, NO_METHOD),
        ({"jsonrpc": "2.0", "id": 1, "method": "none", "params": {"jsonrpc": "2.0", "id": 2}}, NO_METHOD),
        ({"jsonrpc": "2.0", "id": 1, "method": "none", "params": {"jsonrpc": "2.0", "method": "exit"}}, NO_METHOD),
    ],
    ids=str,
)
def test_a_message_that_is_no_request_of_the_protocol_is_answered_with_an_error(
    shared: Shared, message: object, code: int
) -> None:
    given = message.get("id") if isinstance(message, dict) else None
    identity = given if type(given) in {int, str} else None
    editor = shared.editor
    editor.answers.pop(identity, None)
    editor.send(message)
    assert code_of(editor.answer(identity)) == code
    assert_well(editor)


@pytest.mark.parametrize(
    ("method", "params"),
    [
        ("textDocument/didOpen", {}),
        ("textDocument/didOpen", {"textDocument": {"uri": 1, "languageId": "xacro", "version": 1, "text": ""}}),
        ("textDocument/didOpen", {"textDocument": {"uri": "file:///%00", "languageId": "x", "version": 1, "text": ""}}),
        ("textDocument/didChange", {"textDocument": {"uri": "URI", "version": 2}, "contentChanges": [{"text": 1}]}),
        ("textDocument/didChange", {"textDocument": {"uri": "URI", "version": 2}, "contentChanges": {}}),
        ("textDocument/didChange", {"textDocument": {"uri": "URI2", "version": 2}, "contentChanges": [{"text": ""}]}),
        ("textDocument/didClose", {"textDocument": {"uri": "URI2"}}),
        ("textDocument/didClose", None),
        ("textDocument/didSave", {"textDocument": {"uri": "URI2"}}),
        ("workspace/didChangeWatchedFiles", {"changes": [{"uri": "URI", "type": 9}]}),
        ("workspace/didChangeWatchedFiles", {"changes": 1}),
        ("workspace/didChangeWatchedFiles", {"changes": [{"uri": 1, "type": 1}]}),
        ("workspace/didChangeWatchedFiles", {"changes": [{"uri": "file:///a%00", "type": 1}]}),
        ("workspace/didChangeWatchedFiles", {"changes": [{"uri": "file:///dev/zero", "type": 1}]}),
        (
            "workspace/didChangeWorkspaceFolders",
            {"event": {"added": [{"uri": "file:///%00", "name": ""}], "removed": []}},
        ),
        ("workspace/didChangeConfiguration", {"settings": {"urdfctl": {"distro": 1, "select": [[]], "arguments": []}}}),
        ("workspace/didChangeConfiguration", {}),
        ("$/cancelRequest", {"id": []}),
        ("$/cancelRequest", {"id": "none"}),
        ("$/cancelRequest", None),
        ("$/setTrace", {"value": "loud"}),
        ("window/workDoneProgress/cancel", {"token": "none"}),
        ("none", {"a": 1}),
        ("textDocument/hover", {"textDocument": {"uri": "URI"}, "position": AT}),
        ("initialize", {"processId": None, "rootUri": None, "capabilities": {}}),
    ],
    ids=str,
)
def test_a_notification_that_is_wrong_changes_nothing(shared: Shared, method: str, params: object) -> None:
    uri = shared.uri
    written = json.dumps(params).replace("URI2", f"{uri}2").replace('"URI"', json.dumps(uri))
    editor = shared.editor
    editor.tell(method, json.loads(written))
    end = time.monotonic() + SECONDS
    while "typed_link" not in names_in(editor, uri):
        assert time.monotonic() < end
    shown = [one for one in editor.said if one["method"] == "window/showMessage"]
    assert [one for one in shown if "Error in server" in one["params"]["message"]] == []
    assert_well(editor)


@pytest.mark.parametrize(
    "reply",
    [
        {"result": 1},
        {"result": {"title": 1}},
        {"result": "jazzy"},
        {"error": 1},
        {"error": {"code": "a", "message": 1}},
        {},
        {"error": {"code": -32601, "message": "no"}},
    ],
    ids=str,
)
def test_a_command_ends_whatever_the_editor_answers_to_its_question(shared: Shared, reply: Message) -> None:
    shared.editor.reply = reply
    params = {"command": "urdfctl.migrate", "arguments": [shared.uri]}
    assert shared.editor.ask("workspace/executeCommand", params)["result"] is None
    assert_well(shared.editor)


def test_a_crash_while_linting_is_logged_and_the_next_text_is_linted(
    folder: Folder, monkeypatch: pytest.MonkeyPatch, caplog: pytest.LogCaptureFixture
) -> None:
    here = str(ws(folder))
    check, linted = Workspace.check, threading.Event()
    texts: list[Mapping[str, bytes]] = []

    def crash(self: Workspace, path: str | None = None) -> Checked:
        texts.append(dict(self.texts))
        if len(texts) == 1:
            raise RecursionError
        return check(self, path)

    def changed(workspace: Workspace) -> None:
        if not linted.is_set():
            raise ValueError(workspace.folder)

    monkeypatch.setattr(Workspace, "check", crash)
    checking = Checking(lambda _: [Workspace(here, EditorSettings())], lambda checked, *_: linted.set())
    checking.start()
    checking.change(changed)
    assert linted.wait(SECONDS)
    linted.clear()
    checking.change(lambda workspace: workspace.changed(f"{here}/arm.urdf", ARM.encode()))
    assert linted.wait(SECONDS)
    checking.end()
    assert f"{here}/arm.urdf" in texts[-1]
    assert [record.message for record in caplog.records] == [
        f"urdfctl: a change in '{here}' cannot be taken",
        f"urdfctl: '{here}' cannot be linted",
    ]
