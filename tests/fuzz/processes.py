"""Forked processes that try inputs, one after the other: what they tell, and what ended them.

A child writes what it finds to a pipe, one line of JSON each, and the input that it is about to try to a page that it
shares with its parent: if the child is killed, the parent knows by which input.
"""

from __future__ import annotations

import faulthandler
import gc
import json
import mmap
import os
import resource
import signal
import struct
import sys
import tempfile
import time
from collections.abc import Callable, Iterator
from contextlib import suppress
from select import select
from typing import Any, NamedTuple

Json = dict[str, Any]
SECONDS = 20.0
"""Processor time for one input, in s: who needs more hangs."""
PATIENCE = 600.0
"""Time on the clock for one input, in s: who needs more waits for something."""
MEMORY = 1 << 30
"""Bytes that a process may use."""
_PAGE = 1 << 18
_HEAD = struct.Struct("<QQ")
UNIT = 1 if sys.platform == "darwin" else 1024
"""Bytes in the unit of ru_maxrss."""


class Ended(NamedTuple):
    """How a child ended.

    seconds: the processor time that it took with its own children, in s.
    number, input: the last input, and which one it was, from 1.
    why: what ended it; empty if it ended by itself.
    """

    seconds: float
    number: int
    input: bytes
    why: str


class Page:
    """The input that a child is about to try, in memory that its parent sees."""

    def __init__(self) -> None:
        self._memory = mmap.mmap(-1, _PAGE)

    def write(self, number: int, data: bytes) -> None:
        """Take the next input."""
        data = data[: _PAGE - _HEAD.size]
        self._memory[: _HEAD.size + len(data)] = _HEAD.pack(number, len(data)) + data

    def read(self) -> tuple[int, bytes]:
        """Return the number of the input, from 1, and the input."""
        number, size = _HEAD.unpack_from(self._memory)
        return number, self._memory[_HEAD.size : _HEAD.size + size]

    def close(self) -> None:
        """Give the memory back."""
        self._memory.close()


Tell = Callable[[Json], None]
Work = Callable[[Page, Tell], None]


class Child:
    """A forked process that works, and tells what it finds."""

    def __init__(self, work: Work) -> None:
        self._page = Page()
        self._traces = tempfile.TemporaryFile()  # noqa: SIM115 (it lives as long as this)
        self._text = bytearray()
        self._seen, self._since = 0, time.monotonic()
        reading, writing = os.pipe()
        sys.stdout.flush()
        sys.stderr.flush()
        self.pid = os.fork()
        if self.pid == 0:
            os.close(reading)
            _be(work, self._page, writing, self._traces.fileno())
        os.close(writing)
        self.pipe = reading

    def told(self) -> tuple[list[Json], Ended | None]:
        """Return what the child has told since, and how it ended; None if it works on. Reads, and so may wait."""
        piece = os.read(self.pipe, 1 << 16)
        self._text += piece
        *lines, rest = bytes(self._text).split(b"\n")
        self._text = bytearray(rest)
        return [json.loads(line) for line in lines], None if piece else self._ended()

    def end_if_it_waits(self) -> None:
        """Kill a child that has been at one input for too long on the clock."""
        number, _ = self._page.read()
        if number != self._seen:
            self._seen, self._since = number, time.monotonic()
        elif time.monotonic() - self._since > PATIENCE:
            os.killpg(self.pid, signal.SIGKILL)

    def kill(self) -> None:
        """Kill the child and all of its own."""
        with suppress(ProcessLookupError):  # it may not be the leader of its group yet
            os.killpg(self.pid, signal.SIGKILL)
        os.kill(self.pid, signal.SIGKILL)
        self._ended()

    def _ended(self) -> Ended:
        os.close(self.pipe)
        _, status, used = os.wait4(self.pid, 0)
        code = os.waitstatus_to_exitcode(status)
        known = {
            0: "",
            -signal.SIGPROF: f"hangs: more than {SECONDS:g} s of processor time",
            -signal.SIGKILL: "is killed",
        }
        why = known.get(code, f"ends with {signal.Signals(-code).name if code < 0 else f'status {code}'}")
        with self._traces:
            where = self._where() if why else ""
        number, data = self._page.read()
        self._page.close()
        return Ended(used.ru_utime + used.ru_stime, number, data, f"{why} {where}".strip())

    def _where(self) -> str:
        """The innermost place in urdfctl's own code where a child was that hung or crashed."""
        self._traces.seek(0)
        lines = self._traces.read().decode("utf-8", "replace").splitlines()
        places = [line.strip() for line in lines if "/urdfctl/" in line and "/tests/" not in line]
        return f"at {places[0].rpartition('/urdfctl/')[2]}" if places else ""


def _be(work: Work, page: Page, pipe: int, traces: int) -> None:
    """Be the child: work, and leave."""
    os.setsid()
    faulthandler.enable(traces)
    faulthandler.register(signal.SIGPROF, traces, all_threads=False, chain=True)
    bounded(resource.RLIMIT_CORE, 0)
    status = 99
    try:
        with os.fdopen(pipe, "wb", buffering=0) as file:

            def tell(fact: Json) -> None:
                file.write(json.dumps(fact).encode() + b"\n")

            work(page, tell)
        status = 0
    finally:
        if status:
            sys.excepthook(*sys.exc_info())  # type: ignore[arg-type]
        os._exit(status)


def bounded(kind: int, limit: int) -> None:
    """Set a limit of this process, as far as the system allows."""
    hard = resource.getrlimit(kind)[1]
    with suppress(ValueError, OSError):  # macOS rejects RLIMIT_AS
        resource.setrlimit(kind, (limit if hard == resource.RLIM_INFINITY else min(limit, hard), hard))


def start_clock() -> None:
    """Give this process its time for one input from now on; the default action of the signal ends it."""
    signal.setitimer(signal.ITIMER_PROF, SECONDS)


def peak(who: int = resource.RUSAGE_SELF) -> int:
    """Return the most memory that this process, or its children, used so far, in bytes."""
    return resource.getrusage(who).ru_maxrss * UNIT


def run_all(works: Iterator[Work], parallel: int) -> Iterator[tuple[Work, list[Json], Ended | None]]:
    """Do work in forked processes, some at a time; yield what each tells, and how it ends.

    works: asked for the next one whenever a process is free; it may be empty and have more later, after one has ended.
    """
    gc.freeze()
    children: dict[int, tuple[Work, Child]] = {}
    try:
        while True:
            while len(children) < parallel and (work := next(works, None)) is not None:
                child = Child(work)
                children[child.pipe] = work, child
            if not children:
                return
            ready, _, _ = select([*children], [], [], 1.0)
            for pipe in ready:
                work, child = children[pipe]
                facts, ended = child.told()
                if ended is not None:
                    del children[pipe]
                yield work, facts, ended
            for _, child in children.values():
                child.end_if_it_waits()
    finally:
        for _, child in children.values():
            child.kill()
