"""The two halves of a campaign: guided inputs for the readers, and whole commands. Each runs in a process of its own.

The first imports urdfctl with probes, the second as it is.
"""

from __future__ import annotations

import os
import shutil
import signal
import sys
import tempfile
import time
from base64 import b64decode
from collections import Counter
from collections.abc import Callable, Iterator
from functools import partial
from pathlib import Path
from types import FrameType
from typing import Any

import processes
from processes import Ended, Json, Work
from state import COMMANDS, READERS, State

sys.path.append(str(Path(__file__).parents[1]))
"""For what the tests share with the fuzzers; what runs in a phase is imported when it begins."""
_INPUTS, _SECONDS = 3000, 60.0
"""How many inputs a forked process tries, and how long at most, in s."""
_COMMANDS = 20
_SAVED_EVERY = 10.0


class Phase:
    """Hands out batches of inputs for the readers until there are enough, and takes what is found.

    seconds: after this time on the clock no other batch begins; None for no such limit. It counts from `run` on.
    """

    def __init__(self, state: State, kind: str, seconds: float | None) -> None:
        self.state, self.kind, self.seconds = state, kind, seconds
        self.flying: Counter[str] = Counter()
        self.began = 0.0

    @property
    def is_over(self) -> bool:
        enough = self.state.tried(self.kind) + self.flying.total() >= self.state.wanted[self.kind]
        return enough or (self.seconds is not None and time.monotonic() - self.began >= self.seconds)

    def __iter__(self) -> Iterator[Work]:
        return self

    def __next__(self) -> Work:
        if self.is_over:
            raise StopIteration
        self.state.batches += 1
        return self.batch()

    def run(self, parallel: int) -> None:
        """Do the batches in forked processes until it is over; the state is saved meanwhile."""
        self.began = saved = time.monotonic()
        try:
            for work, facts, ended in processes.run_all(self, parallel):
                for fact in facts:
                    self.take(work, fact)
                if ended is not None:
                    self.ended(work, ended)
                    if time.monotonic() - saved > _SAVED_EVERY:
                        self.state.save()
                        saved = time.monotonic()
        finally:
            self.state.save()

    def batch(self) -> Work:
        """Return the next batch."""
        raise NotImplementedError

    def take(self, work: Any, fact: Json) -> None:
        """Take what a batch has told."""
        raise NotImplementedError

    def ended(self, work: Any, ended: Ended) -> None:
        """Take how the process of a batch ended."""
        raise NotImplementedError

    def fault(self, what: str, key: str, where: str, data: bytes) -> None:
        """Take a fault that one file shows."""
        file = self.state.take(what, f"{where}: {key}", where)
        if file is not None:
            file.write_bytes(data)


class Reading(Phase):
    """Guided inputs."""

    def __init__(self, state: State, seconds: float | None) -> None:
        import probes

        probes.install()
        probes.import_everything()
        import guided

        super().__init__(state, READERS, seconds)
        self.guided, self.probes = guided, probes.REACHED
        self.readers = guided.READERS
        guided.warm_up()
        self.pools = {name: guided.seeds_of(reader) for name, reader in self.readers.items()}
        for name, data in state.inputs_kept():
            self.pools[name].append(data)
        self.known: dict[str, bytearray] = {}
        self.again: set[str] = set()

    def batch(self) -> Work:
        total = sum(reader.share for reader in self.readers.values())
        quota = {name: self.state.wanted[READERS] * one.share / total for name, one in self.readers.items()}
        name = min(quota, key=lambda name: (self._tried(name) + self.flying[name]) / quota[name])
        number, pool = f"{self.state.seed} {self.state.batches}", self.pools[name]
        is_new = name not in self.known
        known = bytes(self.known.setdefault(name, bytearray(len(self.probes))))
        inputs = min(_INPUTS, max(1, int(quota[name] + 1 - self._tried(name) - self.flying[name])))
        if is_new and self._tried(name):
            self.again.add(number)
            return self.guided.Batch(name, number, pool, known, len(pool), 0, _SECONDS)
        self.flying[name] += inputs
        seconds = _SECONDS if self.seconds is None else self.seconds / len(quota) / 2
        first = 0 if is_new and self.seconds is None else len(pool)
        return self.guided.Batch(name, number, list(pool), known, inputs, first, seconds)

    def _tried(self, name: str) -> int:
        return self.state.count(READERS, name).tried

    def take(self, work: Any, fact: Json) -> None:
        count = self.state.count(READERS, work.reader)
        if "kept" in fact:
            known = self.known[work.reader]
            if any(not known[index] for index in fact["reached"]):
                for index in fact["reached"]:
                    known[index] = 1
                data = b64decode(fact["kept"])
                if work.number not in self.again and data not in self.pools[work.reader]:
                    self.pools[work.reader].append(data)
                    self.state.keep(work.reader, fact["kept"])
        elif "fault" in fact:
            self.fault(fact["fault"], fact["key"], work.reader, b64decode(fact["input"]))
        else:
            count.slowest = max(count.slowest, fact["slowest"])
            count.peak = max(count.peak, fact["peak"] >> 20)

    def ended(self, work: Any, ended: Ended) -> None:
        count = self.state.count(READERS, work.reader)
        count.seconds += ended.seconds
        if work.number in self.again:
            self.again.discard(work.number)
        else:
            self.flying[work.reader] -= work.inputs
            count.tried += ended.number
        if ended.why:
            self.fault(ended.why, self.guided.key_of(ended.why), work.reader, ended.input)


class Commanding(Phase):
    """Whole commands."""

    def __init__(self, state: State, seconds: float | None) -> None:
        import commands

        super().__init__(state, COMMANDS, seconds)
        commands.warm_up()
        self.commands = commands
        self.next = state.tried(COMMANDS)

    def batch(self) -> Work:
        left = self.state.wanted[COMMANDS] - self.state.tried(COMMANDS) - self.flying.total()
        count = min(_COMMANDS if self.seconds is None else 4, left)
        numbers = range(self.next, self.next + count)
        self.next += count
        self.flying[str(numbers)] = count
        return self.commands.Batch(self.state.seed, numbers, str(self.state.folder))

    def take(self, work: Any, fact: Json) -> None:
        if "fault" in fact:
            folder = self.state.take(fact["fault"], fact["key"], fact["command"])
            if folder is None:
                shutil.rmtree(fact["folder"])
            else:
                shutil.rmtree(folder, ignore_errors=True)
                os.rename(fact["folder"], folder)
        else:
            count = self.state.count(COMMANDS, fact["command"])
            count.tried += 1
            count.seconds += fact["seconds"]
            count.slowest = max(count.slowest, fact["seconds"])
            count.peak = max(count.peak, fact["peak"] >> 20)

    def ended(self, work: Any, ended: Ended) -> None:
        del self.flying[str(work.numbers)]
        if ended.why:
            self.fault(ended.why, ended.why, "commands", ended.input)


def run(state: State, parallel: int, seconds: float | None = None) -> State:
    """Run both phases, and return the state after them. seconds: for each, on the clock; None for no such limit."""
    for make, kind in ((Reading, READERS), (Commanding, COMMANDS)):
        if state.tried(kind) < state.wanted[kind]:
            status = _in_a_process(partial(_run, make, state, seconds, parallel))
            state = State.begun(state.path, state.seed, state.wanted, state.folder)
            if status:
                sys.exit(status)
    return state


def _run(make: Callable[[State, float | None], Phase], state: State, seconds: float | None, parallel: int) -> None:
    with tempfile.TemporaryDirectory(prefix="urdfctl-fuzz-") as held:
        tempfile.tempdir = held  # what killed processes leave is deleted too
        make(state, seconds).run(parallel)


def _in_a_process(work: Callable[[], None]) -> int:
    """Do something in a forked process, and return its exit status. To end this process ends the other."""
    pid = os.fork()
    if pid == 0:
        signal.signal(signal.SIGTERM, _interrupt)
        status = 1
        try:
            work()
            status = 0
        except KeyboardInterrupt:
            status = 130
        except BaseException:  # noqa: BLE001 (told, and then this process is over)
            sys.excepthook(*sys.exc_info())  # type: ignore[arg-type]
        finally:
            sys.stdout.flush()
            os._exit(status)
    before = signal.signal(signal.SIGTERM, lambda *_: os.kill(pid, signal.SIGTERM))
    try:
        return _waited(pid)
    finally:
        signal.signal(signal.SIGTERM, before)


def _waited(pid: int) -> int:
    while True:
        try:
            return os.waitstatus_to_exitcode(os.waitpid(pid, 0)[1])
        except KeyboardInterrupt:  # the other process gets it too, and saves its state
            continue


def _interrupt(_: int, __: FrameType | None) -> None:
    raise KeyboardInterrupt
