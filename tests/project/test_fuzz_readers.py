"""The fuzzer of readers tells each kind of fault by the input that shows it, and keeps what reaches new code."""

from __future__ import annotations

import os
import subprocess
import sys
import time
import warnings
from base64 import b64decode
from collections.abc import Callable
from pathlib import Path
from random import Random
from typing import Any

import pytest

if sys.platform == "win32":
    pytest.skip("the fuzzers fork", allow_module_level=True)
import guided
import probes
import processes
from readers import READERS, Reader

from urdfctl.errors import UserError

BRANCHES = '''
"""Says something."""
from __future__ import annotations


def sign(number):
    """Return the sign of a number."""
    if number < 0:
        return "minus"
    for _ in range(number):
        continue
    return "plus"
'''


def test_a_probe_tells_which_branch_was_reached_and_changes_nothing(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(probes, "REACHED", reached := bytearray())
    names: dict[str, Any] = {"__probes__": reached}
    exec(probes.with_probes(BRANCHES.encode(), "branches.py"), names)  # noqa: S102 (what stands above)
    sign: Callable[[int], str] = names["sign"]
    assert (names["__doc__"], sign.__doc__) == ("Says something.", "Return the sign of a number.")

    def reached_by(number: int) -> list[int]:
        reached[:] = bytes(len(reached))
        assert sign(number) == ("minus" if number < 0 else "plus")
        return [index for index, is_reached in enumerate(reached) if is_reached]

    assert len(reached) == 5
    assert reached_by(-1) != reached_by(0) != reached_by(1)
    assert reached_by(1) == reached_by(5)


def raises(data: bytes) -> None:
    raise KeyError(data)


def burns(_: bytes) -> None:
    while time.process_time() > 0:
        pass


def grows(_: bytes) -> None:
    bytearray(300 << 20)[::4096] = b"x" * ((300 << 20) >> 12)


def reads_beside(_: bytes) -> None:
    Path("../secret").read_bytes()


def reads_through_a_link(_: bytes) -> None:
    Path("out/secret").read_bytes()


def writes_beside(_: bytes) -> None:
    Path("../made").write_bytes(b"")


def starts(_: bytes) -> None:
    subprocess.run(["true"], check=False)


def dies(_: bytes) -> None:
    os.abort()


def warns(_: bytes) -> None:
    warnings.warn("odd", SyntaxWarning, stacklevel=1)


def refuses(_: bytes) -> None:
    raise UserError("this is no robot")


def reads_its_own(_: bytes) -> None:
    Path("urdf/arm.xacro").read_bytes()
    Path("made").write_bytes(b"")


def tried(monkeypatch: pytest.MonkeyPatch, bad: Callable[[bytes], None]) -> list[str]:
    """Return the faults that are found with three inputs, of which the second is read badly."""

    def read(data: bytes, _: Random) -> None:
        if data == b"bad":
            bad(data)

    monkeypatch.setitem(READERS, "planted", Reader("", (), read, 1))
    batch = guided.Batch("planted", "1", [b"good", b"bad", b"fair"], b"", 3)
    faults, ended = outcome_of(batch)
    assert all(data == b"bad" for _, data in faults)
    return [what for what, _ in faults] + ([ended.why] if ended.why else [])


def outcome_of(batch: guided.Batch) -> tuple[list[tuple[str, bytes]], processes.Ended]:
    faults: list[tuple[str, bytes]] = []
    for _, facts, ended in processes.run_all(iter([batch]), 1):
        faults += [(fact["fault"], b64decode(fact["input"])) for fact in facts if "fault" in fact]
        if ended is not None:
            assert ended.why == "" or ended.input == b"bad"
            return faults, ended
    raise AssertionError("the process did not end")


FAULTS = [
    (raises, "KeyError: b'bad'"),
    (burns, "hangs: more than 0.3 s of processor time"),
    (grows, "needs more memory than "),
    (reads_beside, "reads ../secret, which is outside"),
    (reads_through_a_link, "reads out/secret, which is outside"),
    (writes_beside, "writes ../made, which is outside"),
    (starts, "starts true"),
    (dies, "ends with SIGABRT"),
    (warns, "warns: SyntaxWarning('odd')"),
]


@pytest.mark.parametrize(("bad", "told"), FAULTS, ids=[bad.__name__ for bad, _ in FAULTS])
def test_each_kind_of_fault_is_told_with_its_input(
    monkeypatch: pytest.MonkeyPatch, bad: Callable[[bytes], None], told: str
) -> None:
    monkeypatch.setattr(processes, "SECONDS", 0.3 if bad is burns else 5)
    monkeypatch.setattr(guided, "MEMORY", processes.peak() + (100 << 20))
    [what, *_] = tried(monkeypatch, bad)
    assert what.startswith(told)


@pytest.mark.parametrize("good", [refuses, reads_its_own], ids=lambda good: good.__name__)
def test_a_refusal_is_an_answer_and_the_packages_own_files_may_be_read(
    monkeypatch: pytest.MonkeyPatch, good: Callable[[bytes], None]
) -> None:
    assert tried(monkeypatch, good) == []


def test_inputs_that_reach_new_code_are_kept_and_lead_further(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(guided, "REACHED", reached := bytearray(8))

    def read(data: bytes, _: Random) -> None:
        for index, letter in enumerate(b"fuzz"):
            if data[index : index + 1] != bytes([letter]):
                return
            reached[index] = 1

    monkeypatch.setitem(READERS, "planted", Reader("", (), read, 1))
    monkeypatch.setattr(guided, "mutated", with_one_other_byte)
    kept: list[bytes] = []
    batch = guided.Batch("planted", "1", [b"...."], b"", 20_000, 0)
    for _, facts, _ in processes.run_all(iter([batch]), 1):
        kept += [b64decode(fact["kept"]) for fact in facts if "kept" in fact]
    assert kept[-1] == b"fuzz"
    assert len(kept) <= 4


def with_one_other_byte(data: bytes, random: Random, _: object) -> bytes:
    at = random.randrange(4)
    return data[:at] + bytes([random.randrange(256)]) + data[at + 1 :]


@pytest.mark.parametrize("name", READERS)
def test_each_reader_reads_what_it_begins_with(name: str, tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    reader = READERS[name]
    folder = guided.lay_out(guided.PACKAGE, tmp_path)
    monkeypatch.chdir(folder)
    seeds = guided.seeds_of(reader)
    assert seeds
    if reader.file:
        assert seeds[0] == guided.PACKAGE[reader.file]
    reader.read(seeds[0], Random(seeds[0]))  # noqa: S311 (nothing secret)
