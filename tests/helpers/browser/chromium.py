"""A browser for tests: opens pages, acts in them as a user does, and tells what their policy refused."""

from __future__ import annotations

import json
import os
import shutil
import signal
import sys
import time
from collections.abc import Iterator
from contextlib import contextmanager
from pathlib import Path
from tempfile import TemporaryDirectory
from typing import Any

import pytest

if sys.platform != "win32":
    import fcntl

BROWSER = next(filter(None, map(shutil.which, ("chromium", "chromium-browser", "google-chrome"))), None)
needs_browser = pytest.mark.skipif(BROWSER is None or os.name != "posix", reason="Chromium is not installed")
SECONDS = 60.0
_OPTIONS = [
    *("--headless=new", "--no-sandbox", "--disable-gpu", "--disable-dev-shm-usage", "--hide-scrollbars"),
    *("--no-first-run", "--disable-extensions", "--disable-background-networking", "--remote-debugging-pipe"),
    *("--use-angle=swiftshader", "--enable-unsafe-swiftshader", "--window-size=1200,900"),
]


class Page:
    """A page of a browser. refused: what its policy did not let happen; said: what its scripts reported or threw."""

    def __init__(self, browser: Browser, session: str) -> None:
        self._browser, self.session = browser, session
        self.refused: list[str] = []
        self.said: list[str] = []

    def run(self, expression: str) -> Any:
        """Return the value of an expression in the page; a promise is waited for."""
        params = {"expression": expression, "returnByValue": True, "awaitPromise": True, "userGesture": True}
        found = self._browser.ask("Runtime.evaluate", params, self.session)
        assert "exceptionDetails" not in found, found["exceptionDetails"]
        return found["result"].get("value")

    def open(self, path: Path) -> None:
        """Open a file, and wait until it is loaded."""
        self._browser.ask("Page.navigate", {"url": path.as_uri()}, self.session)
        end = time.monotonic() + SECONDS
        while self.run("document.readyState") != "complete" or self.run("location.href") == "about:blank":
            assert time.monotonic() < end
        self.run("new Promise(done => setTimeout(done, 100))")

    def take(self, method: str, params: dict[str, Any]) -> None:
        """Take an event of the browser."""
        if method == "Log.entryAdded":
            entry = params["entry"]
            (self.refused if "Content Security Policy" in entry["text"] else self.said).append(entry["text"])
        elif method == "Runtime.exceptionThrown":
            self.said.append(json.dumps(params["exceptionDetails"]))
        elif method == "Runtime.consoleAPICalled":
            self.said.append(json.dumps(params["args"]))


class Browser:
    """A browser whose messages go through pipes."""

    def __init__(self, profile: str) -> None:
        assert BROWSER is not None
        read_end, self._out = os.pipe()
        self._in, write_end = os.pipe()
        nowhere = os.open(os.devnull, os.O_RDWR)
        # it reads from 3 and writes to 4; what is copied there must not be 3 or 4 itself
        copies = [fcntl.fcntl(end, fcntl.F_DUPFD, 10) for end in (nowhere, nowhere, read_end, write_end)]
        actions = [(os.POSIX_SPAWN_DUP2, copy, number) for number, copy in enumerate(copies, start=1)]
        command = [BROWSER, *_OPTIONS, f"--user-data-dir={profile}", "about:blank"]
        self._pid = os.posix_spawn(BROWSER, command, os.environ, file_actions=actions)
        for end in (read_end, write_end, nowhere, *copies):
            os.close(end)
        self._rest, self._asked = b"", 0
        self._pages: dict[str, Page] = {}

    def ask(self, method: str, params: dict[str, Any], session: str | None = None) -> Any:
        """Ask the browser, and return its answer."""
        self._asked += 1
        message = {"id": self._asked, "method": method, "params": params}
        os.write(self._out, json.dumps({**message, **({"sessionId": session} if session else {})}).encode() + b"\0")
        while True:
            answer = self._next()
            if answer.get("id") == self._asked:
                assert "error" not in answer, answer
                return answer["result"]
            if answer.get("sessionId") in self._pages:
                self._pages[answer["sessionId"]].take(answer["method"], answer["params"])

    def _next(self) -> Any:
        while b"\0" not in self._rest:
            part = os.read(self._in, 1 << 16)
            assert part, "the browser ended"
            self._rest += part
        message, _, self._rest = self._rest.partition(b"\0")
        return json.loads(message)

    def page(self) -> Page:
        """Return a new page."""
        target = self.ask("Target.createTarget", {"url": "about:blank"})["targetId"]
        session = self.ask("Target.attachToTarget", {"targetId": target, "flatten": True})["sessionId"]
        page = self._pages[session] = Page(self, session)
        for name in ("Page", "Runtime", "Log"):
            self.ask(f"{name}.enable", {}, session)
        return page

    def end(self) -> None:
        """End the browser."""
        os.kill(self._pid, signal.SIGKILL)
        os.waitpid(self._pid, 0)
        os.close(self._out)
        os.close(self._in)


@contextmanager
def browser() -> Iterator[Browser]:
    """Start a browser; end it after the test."""
    with TemporaryDirectory(ignore_cleanup_errors=True) as profile:
        started = Browser(profile)
        try:
            yield started
        finally:
            started.end()
