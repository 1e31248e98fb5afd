"""The command as a fork of a process that has imported all of urdfctl: importing is most of a short command's time.

Each run has its own folder, environment and streams, and starts from what is imported, before anything was run.
"""

from __future__ import annotations

import atexit
import gc
import importlib
import json
import os
import pkgutil
import runpy
import signal
import socket
import subprocess
import sys
import tempfile
import threading
import traceback
from collections.abc import Mapping, Sequence
from pathlib import Path
from typing import Any

_LIMIT = 60.0
"""Seconds that a command may take."""


class Prepared:
    """A process that has imported urdfctl. It ends with the tests.

    environ: what it is started with.
    """

    def __init__(self, environ: Mapping[str, str]) -> None:
        self._environ = environ
        self._process, self._socket = _start(environ)
        atexit.register(self.close)

    def fits(self, environ: Mapping[str, str]) -> bool:
        """Whether a process forked from it would be as a new one: Python itself reads some variables when it starts."""
        return _read_at_start(environ) == _read_at_start(self._environ)

    def run(
        self, words: Sequence[str], environ: Mapping[str, str], cwd: str, text: str
    ) -> subprocess.CompletedProcess[str]:
        """Run `urdfctl` with these words, as `subprocess.run` does.

        text: what stands in its standard input.
        """
        with tempfile.TemporaryFile() as stdin:
            stdin.write(text.encode(errors="surrogateescape"))
            stdin.seek(0)
            stdout, stderr = _Output(), _Output()
            job = {"words": list(words), "environ": dict(environ), "cwd": cwd}
            status = self._status(job, [stdin.fileno(), stdout.inlet, stderr.inlet])
            return subprocess.CompletedProcess(list(words), status, stdout.text(), stderr.text())

    def _status(self, job: Mapping[str, Any], streams: list[int]) -> int:
        message = json.dumps(job).encode() + b"\n"
        sent = socket.send_fds(self._socket, [message], streams)
        self._socket.sendall(message[sent:])
        try:
            return int(self._socket.recv(1 << 10))
        except TimeoutError:
            self.close()
            self._process, self._socket = _start(self._environ)
            raise subprocess.TimeoutExpired(job["words"], _LIMIT) from None

    def close(self) -> None:
        """End it, and what was forked from it."""
        self._socket.close()
        os.killpg(self._process.pid, signal.SIGKILL)
        self._process.wait()


def _start(environ: Mapping[str, str]) -> tuple[subprocess.Popen[bytes], socket.socket]:
    ours, its = socket.socketpair()
    with its:
        process = subprocess.Popen(
            [sys.executable, __file__, str(its.fileno())],
            env=environ,
            stdin=subprocess.DEVNULL,
            stdout=subprocess.DEVNULL,
            pass_fds=[its.fileno()],
            start_new_session=True,
        )
    ours.settimeout(_LIMIT)
    return process, ours


def _read_at_start(environ: Mapping[str, str]) -> dict[str, str]:
    return {name: value for name, value in environ.items() if name.startswith(("PYTHON", "LC_", "LANG"))}


class _Output:
    """A pipe that is read while a command writes into it."""

    def __init__(self) -> None:
        self._outlet, self.inlet = os.pipe()
        self._data = bytearray()
        self._reader = threading.Thread(target=self._read, daemon=True)
        self._reader.start()

    def _read(self) -> None:
        while piece := os.read(self._outlet, 1 << 16):
            self._data += piece

    def text(self) -> str:
        """Return what was written, with each end of a line as one, and close the pipe."""
        os.close(self.inlet)
        self._reader.join()
        os.close(self._outlet)
        return self._data.decode(errors="surrogateescape").replace("\r\n", "\n").replace("\r", "\n")


def _serve(connection: socket.socket) -> None:
    """Run commands, one after another, until the tests end."""
    _import_everything()
    while message := _received(connection):
        job, streams = message
        process = os.fork()
        if process == 0:
            connection.close()
            _become(job, streams)
        for stream in streams:
            os.close(stream)
        _, status = os.waitpid(process, 0)
        connection.sendall(str(os.waitstatus_to_exitcode(status)).encode())


def _import_everything() -> None:
    import urdfctl

    for module in pkgutil.walk_packages(urdfctl.__path__, "urdfctl."):
        if not module.name.endswith("__main__"):
            importlib.import_module(module.name)
    gc.collect()
    gc.freeze()


def _received(connection: socket.socket) -> tuple[dict[str, Any], list[int]] | None:
    data, streams, _, _ = socket.recv_fds(connection, 1 << 16, 3)
    while data and not data.endswith(b"\n"):
        data += connection.recv(1 << 16)
    return (json.loads(data), streams) if data else None


def _become(job: Mapping[str, Any], streams: Sequence[int]) -> None:
    """Go on as `python -m urdfctl` does. Never returns."""
    try:
        for number, stream in enumerate(streams):
            os.dup2(stream, number)
            os.close(stream)
        os.environ.clear()
        os.environ.update(job["environ"])
        os.chdir(job["cwd"])
        sys.path[0] = job["cwd"]
        sys.argv[1:] = job["words"]
        runpy.run_module("urdfctl", run_name="__main__", alter_sys=True)
    except BaseException:  # noqa: BLE001 (it must not go on as a second server)
        traceback.print_exc()
    finally:
        sys.stderr.flush()
        os._exit(1)


if __name__ == "__main__":
    sys.path[0] = str(Path(__file__).parents[3])
    _serve(socket.socket(fileno=int(sys.argv[1])))
