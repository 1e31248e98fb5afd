"""How far a campaign is, in a file: what was tried, by whom, how long it took, what was found. It can go on from there.

Beside `FILE` are `FILE.kept`, the inputs that reached new code, and `FILE.faults`, a folder with what shows each fault.
"""

from __future__ import annotations

import fcntl
import json
import os
import re
from base64 import b64decode
from collections.abc import Iterator
from contextlib import contextmanager
from dataclasses import asdict, dataclass, field
from pathlib import Path
from typing import Any

READERS, COMMANDS = "readers", "commands"


@dataclass
class Count:
    """What was tried of one reader or command.

    seconds: processor time of all, in s. slowest: of one input, in s. peak: memory that a process used at most, in MiB.
    """

    tried: int = 0
    seconds: float = 0.0
    slowest: float = 0.0
    peak: int = 0
    kept: int = 0


@dataclass
class Fault:
    """What is wrong. where: the first reader or command. file: what shows it. count: how often it was seen."""

    key: str
    what: str
    where: str
    file: str
    count: int = 1


@dataclass
class State:
    """The state of a campaign.

    wanted: how many inputs and commands. folder: where the files that show faults are put.
    batches: how many were begun. kept: how many inputs are kept.
    """

    path: Path
    seed: str
    wanted: dict[str, int]
    folder: Path
    counts: dict[str, dict[str, Count]] = field(default_factory=lambda: {READERS: {}, COMMANDS: {}})
    faults: list[Fault] = field(default_factory=list)
    batches: int = 0
    kept: int = 0

    @classmethod
    def begun(cls, path: Path, seed: str, wanted: dict[str, int], folder: Path | None = None) -> State:
        """Return the state in a file, or a new one. ValueError if the file is of another campaign."""
        state = cls(path, seed, wanted, folder or path.with_name(f"{path.name}.faults"))
        if path.exists():
            data = json.loads(path.read_text(encoding="utf-8"))
            if data["seed"] != seed:
                raise ValueError(f"{path} is of a campaign with seed {data['seed']}")
            counts = data["counts"].items()
            state.counts = {kind: {name: Count(**one) for name, one in each.items()} for kind, each in counts}
            state.faults = [Fault(**one) for one in data["faults"]]
            state.batches, state.kept = data["batches"], data["kept"]
        state._drop_what_was_not_saved()
        return state

    def _drop_what_was_not_saved(self) -> None:
        """Drop the inputs that a killed run kept after it had saved its state for the last time."""
        lines = self._kept.read_bytes().splitlines(keepends=True) if self._kept.exists() else []
        if len(lines) != self.kept:
            self._kept.write_bytes(b"".join(lines[: self.kept]))
            self.kept = min(self.kept, len(lines))

    @contextmanager
    def locked(self) -> Iterator[None]:
        """Hold the file for this process. BlockingIOError if another one goes on with the campaign."""
        with open(self.path.with_name(f"{self.path.name}.lock"), "w", encoding="ascii") as file:
            fcntl.flock(file, fcntl.LOCK_EX | fcntl.LOCK_NB)
            yield

    def save(self) -> None:
        """Write the file, whole or not at all."""
        data: dict[str, Any] = asdict(self)
        del data["path"], data["folder"]
        unfinished = self.path.with_name(f"{self.path.name}.unfinished")
        unfinished.write_text(json.dumps(data, indent=1), encoding="utf-8")
        os.replace(unfinished, self.path)

    def count(self, kind: str, name: str) -> Count:
        return self.counts[kind].setdefault(name, Count())

    def tried(self, kind: str) -> int:
        return sum(count.tried for count in self.counts[kind].values())

    def keep(self, reader: str, data: str) -> None:
        """Keep an input, given in base64."""
        with self._kept.open("a", encoding="ascii") as file:
            file.write(f"{reader}\t{data}\n")
        self.kept += 1
        self.count(READERS, reader).kept += 1

    def inputs_kept(self) -> Iterator[tuple[str, bytes]]:
        """Yield the inputs that were kept, with their readers."""
        for line in self._kept.read_text(encoding="ascii").splitlines() if self._kept.exists() else ():
            reader, _, data = line.partition("\t")
            yield reader, b64decode(data)

    def take(self, what: str, key: str, where: str) -> Path | None:
        """Take a fault; return where to put what shows it, or None if the fault is known."""
        for fault in self.faults:
            if fault.key == key:
                fault.count += 1
                return None
        self.folder.mkdir(exist_ok=True)
        name = re.sub(r"[^\w.]+", "-", where)
        file = self.folder / f"{self.seed}-{len(self.faults) + 1:03}-{name}"
        self.faults.append(Fault(key, what, where, str(file)))
        return file

    @property
    def _kept(self) -> Path:
        return self.path.with_name(f"{self.path.name}.kept")

    def table(self) -> str:
        """Return what was tried by each reader and command, and what was found, as text."""
        lines = [f"{'':32}{'inputs':>9}{'s of CPU':>10}{'ms each':>9}{'slowest s':>10}{'peak MiB':>9}{'kept':>6}"]
        total = 0.0
        for kind, counts in self.counts.items():
            used = sorted((item for item in counts.items() if item[1].tried), key=lambda item: -item[1].tried)
            lines += [_line(f"{kind[:-1]}: {name}", count) for name, count in used]
            seconds = sum(count.seconds for count in counts.values())
            slowest = max((count.slowest for count in counts.values()), default=0.0)
            peak = max((count.peak for count in counts.values()), default=0)
            kept = sum(count.kept for count in counts.values())
            lines.append(_line(f"all {kind}", Count(self.tried(kind), seconds, slowest, peak, kept)))
            total += seconds
        lines.append(f"{total / 3600:.2f} hours of processor time, seed {self.seed}")
        lines += [f"{one.count} times, {one.where}: {one.what}\n    shown by {one.file}" for one in self.faults]
        lines.append(f"{len(self.faults)} fault{'s' * (len(self.faults) != 1)}")
        return "\n".join(lines) + "\n"


def _line(name: str, count: Count) -> str:
    each = 1000 * count.seconds / count.tried if count.tried else 0.0
    return f"{name:32}{count.tried:9}{count.seconds:10.1f}{each:9.2f}{count.slowest:10.2f}{count.peak:9}{count.kept:6}"
