"""Guided inputs for one reader: what reaches new code is kept, and changed further."""

from __future__ import annotations

import gc
import os
import re
import resource
import tempfile
import time
import traceback
import warnings
from base64 import b64encode
from collections.abc import Iterator, Sequence
from contextlib import suppress
from functools import lru_cache
from itertools import chain, islice
from pathlib import Path
from random import Random
from typing import NamedTuple

import processes
from mutations import mutated
from outside import watch
from package import PACKAGE
from probes import REACHED
from processes import MEMORY, Page, Tell
from readers import ANSWERS, READERS, Reader, of_package
from seeds import trees

from urdfctl.source.budget import OverBudget
from urdfctl.source.disk.shown import forget_files

MOST_BYTES = 6000
MOST_SEEDS = 500
SLOW = 0.25
"""An input that takes longer, in s, is not changed further."""
SECRET = b"<secret>what nobody may read</secret>"
_GROWTH = 300 << 20
"""By how many bytes a process may grow before another one goes on."""
_EVERY = 200
"""Inputs between two collections of garbage."""
_NUMBERS = re.compile(r"0x[0-9a-f]+|'[^']*'|\"[^\"]*\"|\d+")


@lru_cache(1)
def _files() -> list[tuple[str, bytes]]:
    return [item for tree in [of_package(), *trees()] for item in tree.items()]


def seeds_of(reader: Reader) -> list[bytes]:
    """Return what the inputs of a reader begin with: the small files of its kind, the package's own first."""
    fitting = (data for name, data in _files() if name == reader.file or name.endswith(reader.ends))
    own = [PACKAGE[reader.file]] if reader.file else []
    return [*islice(dict.fromkeys(data for data in chain(own, fitting) if len(data) <= MOST_BYTES), MOST_SEEDS)]


def warm_up() -> None:
    """Read the package in this process with each reader, so that forks share what is imported and read once."""
    before = os.getcwd()
    with tempfile.TemporaryDirectory(prefix="urdfctl-fuzz-") as held:
        os.chdir(lay_out(PACKAGE, Path(held)))
        for name, reader in READERS.items():
            data = seeds_of(reader)[0]
            for number in range(30 if name == "robot" else 1):
                with suppress(Exception):
                    reader.read(data, Random(number))  # noqa: S311 (nothing secret)
        os.chdir(before)


class Batch(NamedTuple):
    """Some inputs for one reader.

    number: tells this batch from others: the same number and seeds give the same inputs.
    inputs: how many to try; those of `seeds` from `first` on are tried as they are before any is changed.
    seconds: after this time on the clock, no other input is tried.
    """

    reader: str
    number: str
    seeds: Sequence[bytes]
    known: bytes
    inputs: int
    first: int = 0
    seconds: float = 60.0

    def __call__(self, page: Page, tell: Tell) -> None:
        """Try the inputs, and tell what is kept, what is wrong, and at last how many were tried."""
        with tempfile.TemporaryDirectory(prefix="urdfctl-fuzz-") as held:
            try:
                _Trials(self, page, tell, Path(held)).all()
            finally:
                os.chdir("/")


class _Trials:
    def __init__(self, batch: Batch, page: Page, tell: Tell, held: Path) -> None:
        self.batch, self.page, self.tell = batch, page, tell
        self.reader = READERS[batch.reader]
        self.random = Random(batch.number)  # noqa: S311 (nothing secret)
        self.pool = list(batch.seeds)
        self.known = batch.known
        self.tried, self.slowest = 0, 0.0
        self.said: set[str] = set()
        self.heard: list[str] = []
        self.watching = False
        self.folder = lay_out(PACKAGE, held)
        tempfile.tempdir = str(held / "tmp")
        os.mkdir(tempfile.tempdir)
        os.chdir(self.folder)
        REACHED[:] = batch.known.ljust(len(REACHED), b"\0")
        self.known = bytes(REACHED)
        warnings.simplefilter("always")
        for hidden in (DeprecationWarning, PendingDeprecationWarning, ImportWarning, ResourceWarning):
            warnings.simplefilter("ignore", hidden)  # as Python does by default
        warnings.showwarning = lambda message, *_, **__: self._hear(f"warns: {message!r}")
        watch(self._hear, [str(self.folder), tempfile.tempdir])
        processes.bounded(resource.RLIMIT_AS, _mapped() + 2 * MEMORY)
        processes.bounded(resource.RLIMIT_FSIZE, 64 << 20)

    def all(self) -> None:
        began, at_start = time.monotonic(), processes.peak()
        gc.freeze()
        gc.disable()
        for data in islice(self._inputs(), self.batch.inputs):
            self._try(data)
            peak = processes.peak()
            if peak > MEMORY:
                self._fault(f"needs more memory than {MEMORY >> 20} MiB", data)
            if peak - at_start > _GROWTH or time.monotonic() - began > self.batch.seconds:
                break
            if self.tried % _EVERY == 0:
                gc.collect()
        self.tell({"tried": self.tried, "slowest": self.slowest, "peak": processes.peak()})

    def _inputs(self) -> Iterator[bytes]:
        yield from self.batch.seeds[self.batch.first :] if self.batch.first < len(self.batch.seeds) else ()
        while True:
            others = [self.random.choice(self.pool) for _ in range(2)]
            yield mutated(self._parent(), self.random, others)[:MOST_BYTES]

    def _parent(self) -> bytes:
        """An input to change: one of all, or twice as often one of the newest, the shorter of two."""
        newest = self.pool[-max(20, len(self.pool) // 5) :] if self.random.random() < 0.6 else self.pool
        return min(self.random.choice(newest), self.random.choice(newest), key=len)

    def _try(self, data: bytes) -> None:
        self.tried += 1
        random = Random(data)  # noqa: S311 (the same input finds the same fault again)
        self.page.write(self.tried, data)
        if self.reader.file:
            Path(self.reader.file).write_bytes(data)
        forget_files()
        began = time.process_time()
        processes.start_clock()
        self.watching = True
        try:
            with suppress(*ANSWERS, OverBudget):
                self.reader.read(data, random)
        except MemoryError:
            self._fault(f"needs more memory than {MEMORY >> 20} MiB at once", data)
        except BaseException as error:  # noqa: BLE001 (whatever it is, it is a fault)
            self._fault(_described(error), data)
        self.watching = False
        took = time.process_time() - began
        self.slowest = max(self.slowest, took)
        for what in self.heard:
            self._fault(what, data)
        self.heard.clear()
        if self.known != REACHED:
            if took < SLOW:
                new = [index for index, (old, now) in enumerate(zip(self.known, REACHED, strict=True)) if old != now]
                self.pool.append(data)
                self.tell({"kept": b64encode(data).decode(), "reached": new})
            self.known = bytes(REACHED)

    def _fault(self, what: str, data: bytes) -> None:
        what = what.replace(str(self.folder.parent), "HELD")
        key = key_of(what)
        if key not in self.said:
            self.said.add(key)
            self.tell({"fault": what, "key": key, "input": b64encode(data).decode()})

    def _hear(self, what: str) -> None:
        if self.watching:
            self.heard.append(what)


def key_of(what: str) -> str:
    """Return what is the same in two reports of one fault: the words without names and numbers."""
    return _NUMBERS.sub("…", what)[:300]


def _described(error: BaseException) -> str:
    places = [frame for frame in traceback.extract_tb(error.__traceback__) if "/tests/" not in frame.filename]
    last = places[-1] if places else traceback.extract_tb(error.__traceback__)[-1]
    ours = next((frame for frame in reversed(places) if "/urdfctl/" in frame.filename), last)
    where = f"{ours.filename.rpartition('/urdfctl/')[2]}:{ours.lineno} in {ours.name}"
    return f"{type(error).__name__}: {str(error)[:200]} at {where}"


def lay_out(tree: dict[str, bytes], held: Path) -> Path:
    """Write a package into a folder, beside a file that nothing in it may read; return the package's folder."""
    (held / "secret").write_bytes(SECRET)
    folder = held / "arm"
    for name, data in tree.items():
        path = folder / name
        path.parent.mkdir(parents=True, exist_ok=True)
        path.write_bytes(data)
    (folder / "out").symlink_to(held)
    return folder


def _mapped() -> int:
    """The bytes of address space that this process has mapped, as far as the system tells."""
    statm = Path("/proc/self/statm")
    return int(statm.read_text().split()[0]) * resource.getpagesize() if statm.exists() else 4 * MEMORY
