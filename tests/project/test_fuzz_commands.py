"""The fuzzer of whole commands tells each kind of fault, and the sound twin of each has none."""

from __future__ import annotations

import json
import os
import socket
import subprocess
import sys
import time
from collections.abc import Callable
from pathlib import Path
from random import Random

import pytest

if sys.platform == "win32":
    pytest.skip("the fuzzers fork", allow_module_level=True)
import commands
import sessions
from command_lines import Line, line_for
from commands import Place
from revisions import REVISIONS, repository
from seeds import OTHER_TEXTS

import urdfctl.__main__ as urdfctl
from urdfctl.commands import COMMANDS

TREE = {"arm.urdf": b"<robot name='arm'><link name='base'/></robot>", "launch/arm.launch": b"<launch/>"}
LINE = Line("planted", ["planted"], ("made",), programs=("git",))


def faults(monkeypatch: pytest.MonkeyPatch, held: Path, command: Callable[[], int], line: Line = LINE) -> list[str]:
    """Return what is wrong with a command that is run in place of urdfctl's own."""

    def main() -> None:
        status = command()
        sys.stdout.flush()
        sys.stderr.flush()
        os._exit(status)

    monkeypatch.setattr(urdfctl, "main", main)
    place = Place(held, TREE)
    assert (held / "tried" / "out").is_symlink()
    return place.faults(line, place.run(line, Random(1)))  # noqa: S311


def raises() -> int:
    raise KeyError("arm")


def owns_up_to_a_crash() -> int:
    os.write(1, b"urdfctl: this is a bug in urdfctl\n")
    return 0


def has_another_exit_status() -> int:
    return 7


def burns() -> int:
    while time.process_time() >= 0:
        if time.process_time() > 1:
            return 0
    return 0


def burns_in_a_child() -> int:
    if os.fork() == 0:
        burns()
        os._exit(0)
    os.wait()
    return 0


def waits() -> int:
    time.sleep(60)
    return 0


def grows() -> int:
    bytearray(400 << 20)[::4096] = b"x" * ((400 << 20) >> 12)
    return 0


def reads_beside() -> int:
    Path("../secret").read_bytes()
    return 0


def reads_through_a_link_in_a_child() -> int:
    if os.fork() == 0:
        Path("out/secret").read_bytes()
        os._exit(0)
    os.wait()
    return 0


def says_what_it_read() -> int:
    os.write(2, os.environ["PASSWORD"].encode())
    return 0


def replaces_what_a_link_leads_to() -> int:
    Path("to_secret.sarif").write_text("{}")
    return 0


def replaces_a_link() -> int:
    Path("to_secret.sarif").unlink()
    Path("to_secret.sarif").write_text("{}")
    return 0


def changes_a_file() -> int:
    Path("arm.urdf").write_text("")
    return 0


def deletes_a_file() -> int:
    Path("launch/arm.launch").unlink()
    return 0


def leaves_a_file() -> int:
    Path("urdfctl.log").write_text("")
    return 0


def starts_a_program() -> int:
    subprocess.run(["true"], check=False)
    return 0


def uses_the_network() -> int:
    with socket.socket(socket.AF_INET, socket.SOCK_DGRAM) as one:
        one.connect(("127.0.0.1", 9))
    return 0


FAULTS = [
    (raises, "exit status 99"),
    (owns_up_to_a_crash, "exit status 0 [] urdfctl: this is a bug in urdfctl"),
    (has_another_exit_status, "exit status 7"),
    (burns, "hangs: more than 0.5 s of processor time"),
    (burns_in_a_child, "hangs: more than 0.5 s of processor time"),
    (waits, "waits: more than 2 s on the clock"),
    (grows, "needs more memory than "),
    (reads_beside, "reads ../secret, which is outside"),
    (reads_through_a_link_in_a_child, "reads out/secret, which is outside"),
    (says_what_it_read, "prints what is in a file outside of the folder, or a variable"),
    (replaces_what_a_link_leads_to, "changes or leaves secret"),
    (replaces_a_link, "changes or leaves tried/to_secret.sarif"),
    (changes_a_file, "changes or leaves tried/arm.urdf"),
    (deletes_a_file, "changes or leaves tried/launch/arm.launch"),
    (leaves_a_file, "changes or leaves tried/urdfctl.log"),
    (starts_a_program, "starts true"),
    (uses_the_network, "uses the network: socket.connect"),
]


@pytest.mark.parametrize(("command", "told"), FAULTS, ids=[command.__name__ for command, _ in FAULTS])
def test_each_kind_of_fault_is_told(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch, command: Callable[[], int], told: str
) -> None:
    monkeypatch.setattr(commands, "SECONDS", 0.5)
    monkeypatch.setattr(commands, "_CLOCK", 2.0 if command is waits else 60.0)
    monkeypatch.setattr(commands, "MEMORY", commands.processes.peak() + (200 << 20))
    found = faults(monkeypatch, tmp_path, command)
    assert any(one.startswith(told) for one in found), found


def makes_what_it_may() -> int:
    Path("made").mkdir()
    Path("made/arm.html").write_text(Path("arm.urdf").read_text())
    Path("made.sarif").write_text("{}")
    Path(os.environ["TMPDIR"], "x").write_text("")
    Path(os.environ["HOME"], ".cache").mkdir()
    subprocess.run(["git", "--version"], check=True)
    return 1


def test_what_a_command_may_do_is_no_fault(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    assert faults(monkeypatch, tmp_path, makes_what_it_may) == []


def test_a_fault_is_kept_with_its_command_and_the_folder_as_it_was(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr(urdfctl, "main", changes_a_file)
    (tmp_path / "held").mkdir()
    place = Place(tmp_path / "held", TREE)
    place.keep(tmp_path / "kept", LINE, place.run(LINE, Random(1)), "changes arm.urdf")  # noqa: S311
    assert (tmp_path / "kept/tried/arm.urdf").read_bytes() == TREE["arm.urdf"]
    assert (tmp_path / "kept/tried/out").is_symlink()
    assert (tmp_path / "kept/what.txt").read_text().startswith("'urdfctl' 'planted'\n\nchanges arm.urdf\n")


def test_every_command_is_tried() -> None:
    made = {line_for(dict(OTHER_TEXTS), Random(number)).name.split()[0] for number in range(1000)}  # noqa: S311
    assert made == {*COMMANDS} - {"rules"}


def test_the_revisions_of_the_repository_are_commits_of_the_trees_as_they_are_written() -> None:
    folder = repository().parent
    listing = ["git", "-C", folder, "ls-tree", "-r", "-z", "--name-only", "above"]
    names = subprocess.run(listing, capture_output=True, check=True).stdout
    assert b"../secret.png" in names.split(b"\0")
    for revision in REVISIONS[3:-4]:
        subprocess.run(["git", "-C", folder, "rev-parse", "--verify", revision], capture_output=True, check=True)


# -- the server --------------------------------------------------------------------------------------------------------


def served(answer: Callable[[dict[str, object]], object]) -> Callable[[], int]:
    """Return a server that answers each request as a function says; None for no answer."""

    def serve() -> int:
        requests, answers = os.fdopen(0, "rb"), os.fdopen(1, "wb")
        while head := requests.readline():
            requests.readline()
            message = json.loads(requests.read(int(head.split()[1])))
            if message["method"] == "exit":
                return 0
            result = answer(message) if "id" in message else None
            if result is not None:
                data = json.dumps({"jsonrpc": "2.0", "id": message["id"], **result}).encode()  # type: ignore[dict-item]
                answers.write(b"Content-Length: %d\r\n\r\n%s" % (len(data), data))
                answers.flush()
        return 0

    return serve


SERVERS = [
    (lambda _: {"result": None}, None),
    (lambda _: {"error": {"code": -32602, "message": "invalid params"}}, None),
    (lambda message: None if message["method"] == "shutdown" else {"result": None}, "is not answered: shutdown"),
    (lambda _: {"error": {"code": -32603, "message": "KeyError: 1"}}, "fails: initialize: KeyError: 1"),
    (lambda message: {"id": 77, "result": message["id"]}, "answers what was not asked"),
    (lambda _: sys.exit(0), "ends before it is told to"),
]


@pytest.mark.parametrize(
    ("answer", "told"), SERVERS, ids=["answers", "refuses", "forgets", "fails", "answers another", "ends"]
)
def test_a_server_must_answer_each_request_once_and_not_fail(
    tmp_path: Path,
    monkeypatch: pytest.MonkeyPatch,
    answer: Callable[[dict[str, object]], object],
    told: str | None,
) -> None:
    monkeypatch.setattr(sessions, "_ANSWER", 0.5)
    found = faults(monkeypatch, tmp_path, served(answer), LINE._replace(name="server"))
    assert any(one.startswith(told) for one in found) if told else found == []


def test_what_is_broken_in_a_message_differs_from_it() -> None:
    session = sessions.Session(Path("/w"), TREE, Random(5))  # noqa: S311
    params = {"textDocument": {"uri": "file:///w/a"}, "position": {"line": 1, "character": 2}}
    assert all(json.dumps(session._broken(params)) != json.dumps(params) for _ in range(200))
