"""An editor for tests that sends whatever it is told to, valid or not, and keeps each answer of `urdfctl server`."""

from __future__ import annotations

import copy
import json
import os
import subprocess
import sys
import tempfile
import threading
from collections.abc import Iterator
from contextlib import contextmanager, suppress
from pathlib import Path
from typing import Any, NamedTuple

import pytest

pytest.importorskip("pygls", reason="pygls is not installed")
from folder import CHECKOUT, Folder

SECONDS = 60.0
"""After this, a test fails that waits for an answer."""
_START = "import sys; from urdfctl.__main__ import main; sys.argv = ['urdfctl', 'server']; sys.exit(main())"
Message = dict[str, Any]
INVALID_PARAMS, INVALID_REQUEST, NOT_INITIALIZED, NO_METHOD, NOT_JSON = -32602, -32600, -32002, -32601, -32700
ARM = """<robot name="arm">
  <link name="base"/>
  <link name="fore"/>
  <joint name="elbow" type="fixed"><parent link="base"/><child link="fore"/></joint>
</robot>
"""
SECRET = ARM.replace("base", "hidden_link")
AT = {"line": 1, "character": 14}
RANGE = {"start": AT, "end": AT}
REQUESTS: dict[str, Message] = {
    "textDocument/hover": {"position": AT},
    "textDocument/definition": {"position": AT},
    "textDocument/references": {"position": AT, "context": {"includeDeclaration": True}},
    "textDocument/prepareRename": {"position": AT},
    "textDocument/rename": {"position": AT, "newName": "root"},
    "textDocument/completion": {"position": AT},
    "textDocument/documentSymbol": {},
    "textDocument/inlayHint": {"range": RANGE},
    "textDocument/codeAction": {"range": RANGE, "context": {"diagnostics": []}},
    "textDocument/codeLens": {},
}


class RawEditor:
    """The other end of a server's pipes.

    answers: what the server answered, by the identity of the request, in order.
    said: the notifications and requests of the server.
    reply: what each request of the server is answered with.
    """

    def __init__(self) -> None:
        self.answers: dict[object, list[Message]] = {}
        self.said: list[Message] = []
        self.reply: Message = {"result": None}
        self._came = threading.Condition()
        self._asked = 0
        self._complaints = tempfile.TemporaryFile()  # noqa: SIM115 (closed by end)
        command = [sys.executable, "-c", _START]
        environ = {**os.environ, "PYTHONPATH": str(CHECKOUT)}
        self.process = subprocess.Popen(
            command, stdin=subprocess.PIPE, stdout=subprocess.PIPE, stderr=self._complaints, env=environ
        )
        self._reading = threading.Thread(target=self._read, daemon=True)
        self._reading.start()

    def _read(self) -> None:
        stream = self.process.stdout
        assert stream is not None
        while header := stream.readline():
            if header.lower().startswith(b"content-length:"):
                size = int(header.partition(b":")[2])
                while stream.readline().strip():
                    pass
                self._take(json.loads(stream.read(size)))
        with self._came:
            self._came.notify_all()

    def _take(self, message: Message) -> None:
        with self._came:
            if "method" not in message:
                self.answers.setdefault(message["id"], []).append(message)
            else:
                self.said.append(message)
                if "id" in message:
                    self.send({"jsonrpc": "2.0", "id": message["id"], **self.reply})
            self._came.notify_all()

    def send(self, message: object) -> None:
        """Send a message as it is; bytes are sent as the body."""
        body = message if isinstance(message, bytes) else json.dumps(message).encode()
        stream = self.process.stdin
        assert stream is not None
        stream.write(b"Content-Length: %d\r\n\r\n%b" % (len(body), body))
        stream.flush()

    def tell(self, method: str, params: object) -> None:
        """Send a notification."""
        self.send({"jsonrpc": "2.0", "method": method, "params": params})

    def begin(self, method: str, params: object) -> str:
        """Send a request, and return its identity."""
        self._asked += 1
        identity = f"{method} {self._asked}"
        self.send({"jsonrpc": "2.0", "id": identity, "method": method, "params": params})
        return identity

    def answer(self, identity: object) -> Message:
        """Wait for the answer to a request."""
        with self._came:
            came = self._came.wait_for(lambda: identity in self.answers or not self._reading.is_alive(), SECONDS)
            assert came, f"no answer to {identity}"
            assert identity in self.answers, f"the server ended before it answered {identity}"
            return self.answers[identity][0]

    def ask(self, method: str, params: object) -> Message:
        """Send a request and return its answer."""
        return self.answer(self.begin(method, params))

    def start(self, *folders: Path, options: object = None) -> Message:
        """Begin the conversation, and show some folders."""
        shown = [{"uri": folder.as_uri(), "name": folder.name} for folder in folders]
        params = {"processId": None, "capabilities": {}, "workspaceFolders": shown or None, "rootUri": None}
        result = self.ask("initialize", {**params, "initializationOptions": options})
        self.tell("initialized", {})
        return result

    def open(self, uri: str, text: str) -> None:
        """Open a text."""
        item = {"uri": uri, "languageId": "xacro", "version": 1, "text": text}
        self.tell("textDocument/didOpen", {"textDocument": item})

    def linted(self, changes: int = 0) -> None:
        """Wait until everything was linted with so many changes of texts and files."""

        def is_told(message: Message) -> bool:
            told = message["params"]
            return message["method"] == "urdfctl/checked" and told["whole"] and told["changes"] >= changes

        with self._came:
            assert self._came.wait_for(lambda: any(map(is_told, self.said)), SECONDS), "nothing was linted"

    @property
    def complaints(self) -> str:
        """What the server wrote to standard error."""
        self._complaints.seek(0)
        return self._complaints.read().decode("utf-8", "replace")

    def end(self) -> None:
        """End the server, whatever it does."""
        self.process.kill()
        self.process.wait()
        self._reading.join()
        for stream in (self.process.stdin, self.process.stdout, self._complaints):
            with suppress(BrokenPipeError):
                stream.close()  # type: ignore[union-attr]

    @property
    def answered_twice(self) -> list[object]:
        """The requests that were answered more than once."""
        return [identity for identity, answers in self.answers.items() if len(answers) > 1]


@contextmanager
def raw_editor() -> Iterator[RawEditor]:
    """Start a server; end it after the test."""
    editor = RawEditor()
    try:
        yield editor
    finally:
        editor.end()


def asked(method: str, uri: object) -> Message:
    """The parameters of a request about a file."""
    return {"textDocument": {"uri": uri}, **copy.deepcopy(REQUESTS[method])}


def ws(folder: Folder) -> Path:
    """A workspace with one robot; another robot is beside it."""
    folder.write({"ws/.git/HEAD": "", "ws/arm.urdf": ARM, "out/secret.urdf": SECRET})
    return folder.path.resolve() / "ws"


class Shared(NamedTuple):
    """A server that several tests ask, with its workspace and a URI of a file in it."""

    editor: RawEditor
    folder: Path
    uri: str


def code_of(answer: Message) -> int | None:
    """The code of an error; None for a result."""
    assert ("error" in answer) != ("result" in answer)
    return int(answer["error"]["code"]) if "error" in answer else None


def names_in(editor: RawEditor, uri: str) -> list[str]:
    """The names of what a file defines."""
    symbols = editor.ask("textDocument/documentSymbol", asked("textDocument/documentSymbol", uri))
    return [one["name"] for one in symbols["result"]]


def assert_well(editor: RawEditor) -> None:
    """Assert that nothing was answered twice or with a traceback, and that the server still answers."""
    assert editor.answered_twice == []
    assert code_of(editor.ask("textDocument/none", {})) == NO_METHOD
    assert "Traceback" not in editor.complaints
    assert "raceback" not in json.dumps(editor.answers, default=str)


@contextmanager
def shared_server(folder: Path) -> Iterator[Shared]:
    """Start a server for several tests, with an open file in a workspace; its text is not the saved one."""
    here = ws(Folder(folder))
    with raw_editor() as editor:
        editor.start(here)
        editor.open((here / "arm.urdf").as_uri(), ARM.replace("base", "typed_link"))
        editor.linted(changes=1)
        yield Shared(editor, here, (here / "arm.urdf").as_uri())
