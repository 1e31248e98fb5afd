"""A session of an editor with `urdfctl server`: random messages of the protocol, valid or not, over random texts.

Each request must be answered once, with a result or with an error that is not the server's own.
"""

from __future__ import annotations

import json
import os
import re
import select
import time
from collections.abc import Iterator
from pathlib import Path
from random import Random
from typing import Any

from mutations import mutated
from seeds import Tree

Json = dict[str, Any]
_POSITIONS = ["textDocument/hover", "textDocument/definition", "textDocument/completion", "textDocument/prepareRename"]
_DOCUMENTS = ["textDocument/documentSymbol", "textDocument/codeLens", "urdfctl/variants"]
_COMMANDS = ["urdfctl.graph", "urdfctl.view", "urdfctl.chooseVariant", "urdfctl.explain", "urdfctl.nothing"]
_NUMBERS = [0, 1, 5, 30, -1, 10_000, 2**31, 2**64, 1.5, "1", None, True]
_VALUES: list[object] = [None, True, "", "x" * 5000, [], {}, -1, "\ud800", {"uri": None}, ["file:///dev/zero"]]
_URIS = ["file:///dev/zero", "file:///", "file:///%00", "untitled:1", "", "file://host/x", "http://x/"]
_URIS += ["file:///etc/passwd", "file:///tmp", "file:///nowhere/x.urdf"]
_NOTES = ["$/cancelRequest", "$/setTrace", "textDocument/didClose", "textDocument/didSave", "x/y"]
_NOTES += [f"workspace/didChange{what}" for what in ("Configuration", "WatchedFiles", "WorkspaceFolders")]
_HEAD = re.compile(rb"(?:[^\r\n]+\r\n)*?Content-Length: (\d+)\r\n(?:[^\r\n]+\r\n)*\r\n")
_MOST_MESSAGES = 30
_ANSWER = 30.0
"""Seconds on the clock in which a request must be answered."""
_INTERNAL = -32603


class Session:
    """The pipes to a server, and what is said through them."""

    def __init__(self, folder: Path, tree: Tree, random: Random) -> None:
        self.folder, self.tree, self.random = folder, tree, random
        self.texts = sorted(name for name in tree if not name.startswith("."))
        self._server_in, self._to = os.pipe()
        self._from, self._server_out = os.pipe()
        self._data = b""
        self._number = 0
        self._asked: dict[int, Json] = {}
        self._versions: dict[str, int] = {}

    def be_server(self) -> None:
        """Make the pipes the standard input and output of this process, which becomes the server."""
        os.dup2(self._server_in, 0)
        os.dup2(self._server_out, 1)
        for pipe in (self._to, self._from):
            os.close(pipe)

    def held(self, until: float) -> list[str]:
        """Talk to the server until it has ended; return what is wrong with its answers."""
        os.close(self._server_in)
        os.close(self._server_out)
        self._until = until
        found: list[str] = []
        try:
            for what in self._talk():
                found.append(what)  # noqa: PERF402 (what is found before an exception counts)
        except BrokenPipeError:
            found.append("ends before it is told to")
        except TimeoutError:
            found = found or ["does not read what is sent to it"]
        finally:
            os.close(self._to)
            os.close(self._from)
        return found

    # -- what is said ------------------------------------------------------------------------------------------------

    def _talk(self) -> Iterator[str]:
        folder = {"uri": self.folder.as_uri(), "name": "tried"}
        shown = self.random.choice([[folder], [folder], [], [{"uri": "file:///nowhere", "name": "x"}, folder]])
        can = {"window": {"workDoneProgress": True}, "workspace": {"workspaceEdit": {"documentChanges": True}}}
        wishes = self.random.choice([None, {"distro": "jazzy"}, {"distro": 1, "select": "x", "arguments": [1]}, []])
        self._ask("initialize", {"capabilities": can, "workspaceFolders": shown, "initializationOptions": wishes})
        yield from self._answers()
        self._tell("initialized", {})
        for _ in range(self.random.randint(5, _MOST_MESSAGES)):
            self._say_something()
            if self.random.random() < 0.3:
                yield from self._answers()
        yield from self._answers()
        self._ask("shutdown", None)
        yield from self._answers()
        self._tell("exit", None)

    def _say_something(self) -> None:
        random = self.random
        what = random.random()
        if what < 0.35:
            self._change_a_text()
        elif what < 0.8:
            self._ask(*self._a_question())
        elif what < 0.9:
            method, params = self._a_question()
            self._ask(method, self._broken(params))
        elif what < 0.95:
            params: Json = {"textDocument": {"uri": self._uri()}, "settings": {"urdfctl": {}}}
            self._tell(random.choice(_NOTES), self._broken(params))
        else:
            self._ask(random.choice(["x/y", "workspace/symbol", "textDocument/formatting"]), random.choice(_VALUES))

    def _a_question(self) -> tuple[str, Json]:
        document, position = {"uri": self._uri()}, self._position()
        kind = self.random.randrange(6)
        if kind == 0:
            return self.random.choice(_DOCUMENTS), {"textDocument": document, **document}
        if kind == 1:
            where = {"start": self._position(), "end": self._position()}
            method = self.random.choice(["textDocument/codeAction", "textDocument/inlayHint"])
            return method, {"textDocument": document, "range": where, "context": {"diagnostics": []}}
        if kind == 2:
            name = self.random.choice(["knee", "", "${prefix}x", "a b", None])
            return "textDocument/rename", {"textDocument": document, "position": position, "newName": name}
        if kind == 3:
            words = self.random.choice([[], [document["uri"]], [document["uri"], "x"], ["UC201"], [1], [None, {}]])
            return "workspace/executeCommand", {"command": self.random.choice(_COMMANDS), "arguments": words}
        if kind == 4:
            context = {"includeDeclaration": self.random.choice([True, False, None])}
            return "textDocument/references", {"textDocument": document, "position": position, "context": context}
        return self.random.choice(_POSITIONS), {"textDocument": document, "position": position}

    def _change_a_text(self) -> None:
        name = self.random.choice(self.texts)
        uri = (self.folder / name).as_uri()
        text = mutated(self.tree[name], self.random, [*self.tree.values()]).decode("utf-8", "replace")
        if uri not in self._versions:
            self._versions[uri] = 1
            document: Json = {"uri": uri, "languageId": "xacro", "version": 1, "text": text}
            self._tell("textDocument/didOpen", {"textDocument": document})
            return
        self._versions[uri] += 1
        document = {"uri": uri, "version": self.random.choice([self._versions[uri], None, -1])}
        part = {"range": {"start": self._position(), "end": self._position()}, "text": text[:300]}
        changes = self.random.choice([[{"text": text}], [part], [part, part], []])
        self._tell("textDocument/didChange", {"textDocument": document, "contentChanges": changes})

    def _uri(self) -> str:
        if self.random.random() < 0.1:
            return self.random.choice(_URIS)
        return (self.folder / self.random.choice(self.texts)).as_uri()

    def _position(self) -> Json:
        if self.random.random() < 0.05:
            return {"line": self.random.choice(_NUMBERS), "character": self.random.choice(_NUMBERS)}
        return {"line": self.random.randrange(40), "character": self.random.randrange(120)}

    def _broken(self, params: Json) -> object:
        """Params with a part that is missing or of another kind."""
        if self.random.random() < 0.1:
            return self.random.choice(_VALUES)
        broken = json.loads(json.dumps(params))
        at = broken
        while True:
            key = self.random.choice([*at])
            if isinstance(at[key], dict) and at[key] and self.random.random() < 0.6:
                at = at[key]
                continue
            if self.random.random() < 0.4:
                del at[key]
            else:
                at[key] = self.random.choice(_VALUES)
            return broken

    # -- the protocol ------------------------------------------------------------------------------------------------

    def _ask(self, method: str, params: object) -> None:
        self._number += 1
        number = self._number
        self._asked[number] = {"method": method, "params": params}
        self._send({"id": number, "method": method, "params": params})

    def _tell(self, method: str, params: object) -> None:
        self._send({"method": method, "params": params})

    def _send(self, message: Json) -> None:
        data = json.dumps({"jsonrpc": "2.0", **message}).encode()
        view = memoryview(b"Content-Length: %d\r\n\r\n%s" % (len(data), data))
        while view:
            ready = select.select([self._from], [self._to], [], max(0.0, self._until - time.monotonic()))
            if not any(ready):
                raise TimeoutError
            if ready[0] and not self._receive():
                raise BrokenPipeError
            if ready[1]:
                view = view[os.write(self._to, view[:4096]) :]

    def _answers(self) -> Iterator[str]:
        """Wait for the answers of all requests, and answer those of the server."""
        end = min(self._until, time.monotonic() + _ANSWER)
        while True:
            for message in self._messages():
                yield from self._judged(message)
            if not self._asked:
                return
            left = end - time.monotonic()
            if left <= 0:
                for asked in self._asked.values():
                    yield f"is not answered: {asked['method']} with {json.dumps(asked['params'])[:150]}"
                raise TimeoutError
            if select.select([self._from], [], [], left)[0] and not self._receive():
                raise BrokenPipeError

    def _receive(self) -> bool:
        piece = os.read(self._from, 1 << 16)
        self._data += piece
        return bool(piece)

    def _messages(self) -> Iterator[Json]:
        while (found := _HEAD.match(self._data)) is not None:
            end = found.end() + int(found[1])
            if len(self._data) < end:
                return
            message, self._data = self._data[found.end() : end], self._data[end:]
            yield json.loads(message)

    def _judged(self, message: Json) -> Iterator[str]:
        if "method" in message:
            if "id" in message:
                self._send({"id": message["id"], "result": self.random.choice([None, None, {"success": False}])})
            return
        asked = self._asked.pop(message.get("id"), None)
        if asked is None:
            yield f"answers what was not asked: {message}"[:200]
            return
        error = message.get("error")
        if error and (error.get("code") == _INTERNAL or "Traceback" in json.dumps(error)):
            yield f"fails: {asked['method']}: {str(error.get('message'))[:200]}"
