"""A campaign that was interrupted, at any moment, goes on where it was, and says how its inputs were spread."""

from __future__ import annotations

import os
import sys
from base64 import b64encode
from pathlib import Path
from typing import Any

import pytest

if sys.platform == "win32":
    pytest.skip("the fuzzers fork", allow_module_level=True)
import phases
from processes import Ended, Json, Page, Tell
from state import COMMANDS, READERS, State

WANTED = {READERS: 100, COMMANDS: 10}


def text(data: bytes) -> str:
    return b64encode(data).decode()


def test_a_state_that_is_saved_comes_back(tmp_path: Path) -> None:
    state = State.begun(tmp_path / "state", "7", WANTED)
    state.count(READERS, "xml").tried = 40
    state.keep("xml", text(b"<a/>"))
    assert state.take("KeyError: 'x'", "KeyError", "xml") == tmp_path / "state.faults" / "7-001-xml"
    state.batches = 3
    state.save()
    again = State.begun(tmp_path / "state", "7", WANTED)
    assert again == state
    assert [*again.inputs_kept()] == [("xml", b"<a/>")]


def test_what_was_kept_after_the_last_saving_is_dropped(tmp_path: Path) -> None:
    state = State.begun(tmp_path / "state", "7", WANTED)
    state.keep("xml", text(b"saved"))
    state.save()
    state.keep("xml", text(b"not saved"))
    again = State.begun(tmp_path / "state", "7", WANTED)
    again.keep("yaml", text(b"later"))
    again.save()
    third = State.begun(tmp_path / "state", "7", WANTED)
    assert [*third.inputs_kept()] == [("xml", b"saved"), ("yaml", b"later")]


def test_a_fault_is_kept_once_and_counted(tmp_path: Path) -> None:
    state = State.begun(tmp_path / "state", "7", WANTED)
    files = [state.take(what, "KeyError at line …", "xml") for what in ("KeyError at line 1", "KeyError at line 2")]
    assert files[0] is not None
    assert files[1] is None
    assert [(fault.what, fault.count) for fault in state.faults] == [("KeyError at line 1", 2)]


def test_a_state_of_another_campaign_is_refused(tmp_path: Path) -> None:
    State.begun(tmp_path / "state", "7", WANTED).save()
    with pytest.raises(ValueError, match="is of a campaign with seed 7"):
        State.begun(tmp_path / "state", "8", WANTED)


def test_two_processes_cannot_go_on_with_one_campaign(tmp_path: Path) -> None:
    state = State.begun(tmp_path / "state", "7", WANTED)
    with state.locked(), pytest.raises(BlockingIOError), State.begun(tmp_path / "state", "7", WANTED).locked():
        pass


def test_the_table_says_how_inputs_were_spread_and_lists_the_faults(tmp_path: Path) -> None:
    state = State.begun(tmp_path / "state", "7", WANTED)
    for kind, name, tried in ((READERS, "xml", 300), (READERS, "yaml", 700), (COMMANDS, "lint", 4)):
        count = state.count(kind, name)
        count.tried, count.seconds, count.slowest, count.peak = tried, tried / 100, 0.5, 90
    state.take("KeyError: 'x'", "KeyError", "xml")
    lines = [" ".join(line.split()) for line in state.table().splitlines()]
    assert lines[1:] == [
        "reader: yaml 700 7.0 10.00 0.50 90 0",
        "reader: xml 300 3.0 10.00 0.50 90 0",
        "all readers 1000 10.0 10.00 0.50 90 0",
        "command: lint 4 0.0 10.00 0.50 90 0",
        "all commands 4 0.0 10.00 0.50 90 0",
        "0.00 hours of processor time, seed 7",
        "1 times, xml: KeyError: 'x'",
        f"shown by {tmp_path}/state.faults/7-001-xml",
        "1 fault",
    ]


class Counting(phases.Phase):
    """Batches of ten inputs, of which those with certain numbers end their process."""

    deadly: tuple[int, ...] = ()

    def __init__(self, state: State) -> None:
        super().__init__(state, READERS, None)

    def batch(self) -> Ten:
        self.flying["counting"] += 10
        return Ten(self.state.batches, self.deadly)

    def take(self, work: Any, fact: Json) -> None:
        self.state.count(READERS, "counting").slowest = fact["slowest"]

    def ended(self, work: Any, ended: Ended) -> None:
        self.flying["counting"] -= 10
        self.state.count(READERS, "counting").tried += ended.number
        if ended.why:
            self.fault(ended.why, ended.why, "counting", ended.input)


class Ten:
    """Tries ten inputs, the last of which in some batches ends the process."""

    def __init__(self, number: int, deadly: tuple[int, ...]) -> None:
        self.number, self.deadly = number, deadly

    def __call__(self, page: Page, tell: Tell) -> None:
        for number in range(1, 11):
            page.write(number, f"{self.number} {number}".encode())
            if self.number in self.deadly and number == 7:
                os._exit(5)
        tell({"slowest": 1.0})


def test_an_input_that_ends_its_process_is_a_fault_and_the_others_are_tried(tmp_path: Path) -> None:
    state = State.begun(tmp_path / "state", "7", WANTED)
    phase = Counting(state)
    phase.deadly = (2, 3)
    phase.run(2)
    assert state.tried(READERS) >= 100
    assert [(fault.what, fault.count) for fault in state.faults] == [("ends with status 5", 2)]
    assert Path(state.faults[0].file).read_bytes() in {b"2 7", b"3 7"}


def test_a_campaign_that_is_interrupted_is_as_far_as_its_state_says(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    state = State.begun(tmp_path / "state", "7", WANTED)

    def interrupt(self: Counting, work: Any, ended: Ended) -> None:
        if state.tried(READERS) >= 50:
            raise KeyboardInterrupt
        Counting.ended(self, work, ended)

    class Interrupted(Counting):
        ended = interrupt

    with pytest.raises(KeyboardInterrupt):
        Interrupted(state).run(1)
    again = State.begun(tmp_path / "state", "7", WANTED)
    assert (again.tried(READERS), again.batches) == (50, 6)
    Counting(again).run(1)
    assert again.tried(READERS) == 100
