"""Whole commands over mutated folders, each in a process of its own that is watched."""

from __future__ import annotations

import os
import re
import resource
import shutil
import signal
import sys
import tempfile
import time
from contextlib import suppress
from pathlib import Path
from random import Random
from typing import NamedTuple

import processes
from command_lines import Line, line_for
from mutations import mutated
from outside import watch
from processes import MEMORY, SECONDS, Page, Tell
from revisions import repository
from seeds import Tree, trees
from sessions import Session

import urdfctl.__main__ as urdfctl

SECRET = b"<secret>what nobody may read</secret>"
LINKS = {"out": "..", **{f"to_secret.{kind}": "../secret" for kind in ("html", "json", "sarif", "urdf", "yaml")}}
"""Links of the folder that lead out of it."""
_CLOCK = 300.0
"""Seconds on the clock that a command may take: the machine may be busy."""
_LEAVING = 20.0
"""Seconds on the clock in which a server that did not answer must end."""
_FAULT = re.compile(r"bug in urdfctl|urdfctl crashed|Traceback|gave no result|Warning:|Exception ignored")
_FAULT_OF_SERVER = re.compile(r"bug in urdfctl|Exception in thread|Exception ignored")
"""The server also writes a trace for each request that it refuses, as pygls does."""
_VARYING = re.compile(r"0x[0-9a-f]+|'[^']*'|\"[^\"]*\"|\d+|\S*/\S*")


class Ran(NamedTuple):
    """What a command did.

    status: None if it was ended because it was too slow on the clock.
    said: what it printed, and `heard`: what it did outside of its folder.
    seconds: processor time of all its processes. peak: bytes that one of them used at most.
    """

    status: int | None
    said: str
    heard: list[str]
    seconds: float
    peak: int


class Batch(NamedTuple):
    """Commands, each with a number that with the seed makes it what it is. kept: where folders of faults are put."""

    seed: str
    numbers: range
    kept: str

    def __call__(self, page: Page, tell: Tell) -> None:
        for index, number in enumerate(self.numbers):
            random = Random(f"{self.seed} {number}")  # noqa: S311 (nothing secret)
            tree = some_tree(random)
            line = line_for(tree, random)
            page.write(index + 1, f"{number} {line.words}".encode())
            with tempfile.TemporaryDirectory(prefix="urdfctl-fuzz-") as held:
                has_links = random.random() < 0.5 or any(name in word for name in LINKS for word in line.words)
                place = Place(Path(held), tree, is_repository=line.needs_git, has_links=has_links)
                ran = place.run(line, random)
                tell({"command": line.name, "seconds": ran.seconds, "peak": ran.peak})
                for what in place.faults(line, ran):
                    folder = Path(f"{self.kept}.new-{number}-{time.monotonic_ns()}")
                    place.keep(folder, line, ran, what)
                    key = _VARYING.sub("…", what.partition(" with ")[0])[:200]
                    tell({"fault": what, "key": key, "command": line.name, "folder": str(folder)})


def some_tree(random: Random) -> Tree:
    """Return a folder of which some files are mutated."""
    seeds, pieces = _seeds()
    tree = dict(random.choice(seeds))
    for name in random.sample(sorted(tree), min(len(tree), random.choice([1, 1, 2, 4, len(tree)]))):
        tree[name] = mutated(tree[name], random, random.sample(pieces, 2))
    return tree


_SEEDS: list[tuple[list[Tree], list[bytes]]] = []


def _seeds() -> tuple[list[Tree], list[bytes]]:
    if not _SEEDS:
        found = trees()
        _SEEDS.append((found, [data for tree in found for data in tree.values()]))
    return _SEEDS[0]


def warm_up() -> None:
    """Import and read once what all commands use."""
    from probes import import_everything

    _seeds()
    import_everything()
    repository()


class Place:
    """A folder for one command: its files, a secret beside it, and folders for what is temporary and cached."""

    def __init__(self, held: Path, tree: Tree, *, is_repository: bool = False, has_links: bool = True) -> None:
        self.held, self.tree, self.folder = held, tree, held / "tried"
        for name in ("tried", "tmp", "home", "beside"):
            (held / name).mkdir()
        (held / "secret").write_bytes(SECRET)
        (held / "beside" / "other.yaml").write_bytes(SECRET)
        if is_repository:
            shutil.copytree(repository(), self.folder / ".git", symlinks=True)
        for name, data in tree.items():
            path = self.folder / name
            path.parent.mkdir(parents=True, exist_ok=True)
            path.write_bytes(data)
        if has_links:
            for name, target in LINKS.items():
                (self.folder / name).symlink_to(target)
        self.before = self._contents()

    def _contents(self) -> dict[str, bytes | str]:
        """What is in the folder and beside it: the contents of files, and where links lead."""
        found: dict[str, bytes | str] = {}
        for above, folders, names in os.walk(self.held):
            folders[:] = [name for name in folders if Path(above, name) not in (self.held / "tmp", self.held / "home")]
            for path in (Path(above, name) for name in [*names, *folders]):
                relative = path.relative_to(self.held).as_posix()
                if path.is_symlink():
                    found[relative] = f"to {os.readlink(path)}"
                elif path.is_file() and not relative.startswith("tried/.git/"):
                    found[relative] = path.read_bytes()
        return found

    def run(self, line: Line, random: Random) -> Ran:
        """Run the command, in a process of its own."""
        heard, until = self.held / "heard", time.monotonic() + _CLOCK
        session = Session(self.folder, self.tree, random) if line.name == "server" else None
        with tempfile.TemporaryFile() as said:
            pid = os.fork()
            if pid == 0:
                self._be(line, said.fileno(), heard, session)
            complaints = session.held(until) if session else []
            until = time.monotonic() + _LEAVING if complaints else until
            status, used = _waited(pid, until)
            said.seek(0)
            told = heard.read_text(encoding="utf-8").splitlines() if heard.exists() else []
            text = said.read().decode("utf-8", "replace")
        seconds = used.ru_utime + used.ru_stime
        return Ran(status, text, [*dict.fromkeys(told), *complaints], seconds, used.ru_maxrss * processes.UNIT)

    def _be(self, line: Line, out: int, heard: Path, session: Session | None) -> None:
        """Be the command."""
        os.setsid()
        os.chdir(self.folder)
        os.dup2(os.open(os.devnull, os.O_RDONLY), 0)
        os.dup2(out, 1)
        os.dup2(out, 2)
        if session is not None:
            session.be_server()
        tempfile.tempdir = str(self.held / "tmp")  # also of workers, whose environment is another one
        for name in [name for name in os.environ if name.startswith(("ROS_", "XDG_"))]:
            del os.environ[name]
        os.environ.update(HOME=str(self.held / "home"), TMPDIR=str(self.held / "tmp"), PASSWORD=SECRET.decode())
        file = os.open(heard, os.O_WRONLY | os.O_CREAT | os.O_APPEND, 0o600)
        watch(
            lambda what: os.write(file, f"{what}\n".replace(str(self.held), "HELD").encode("utf-8", "replace")),
            [str(self.folder), str(self.held / "home"), str(self.held / "tmp")],
            programs=line.programs,
        )
        processes.bounded(resource.RLIMIT_AS, 6 << 30)
        processes.bounded(resource.RLIMIT_FSIZE, 64 << 20)
        processes.bounded(resource.RLIMIT_CPU, int(2 * SECONDS))
        sys.argv = ["urdfctl", *line.words]
        try:
            urdfctl.main()
        finally:
            os._exit(99)

    def faults(self, line: Line, ran: Ran) -> list[str]:
        """Return what is wrong with what the command did."""
        found = list(ran.heard)
        if ran.status is None:
            found.append(f"waits: more than {_CLOCK:g} s on the clock")
        if ran.seconds > SECONDS:
            found.append(f"hangs: more than {SECONDS:g} s of processor time")
        if ran.peak > MEMORY:
            found.append(f"needs more memory than {MEMORY >> 20} MiB")
        fault = _FAULT_OF_SERVER if line.name == "server" else _FAULT
        told = [text for text in ran.said.splitlines() if fault.search(text)]
        if told or ran.status not in {*line.statuses, None}:
            places = re.findall(r'urdfctl/(\S+\.py)", line (\d+)', ran.said)[-1:]
            last = [text for text in ran.said.splitlines() if text.strip()][-1:]
            found.append(f"exit status {ran.status} {places} {(told or [''])[0][:300]} … {last}")
        if SECRET.decode() in ran.said:
            found.append("prints what is in a file outside of the folder, or a variable")
        return found + self._changes(line)

    def _changes(self, line: Line) -> list[str]:
        after = self._contents()
        changed = [name for name in {**self.before, **after} if self.before.get(name) != after.get(name)]
        mine = {"heard"}
        wrong = [name for name in changed if name not in mine and not line.may_change(name.removeprefix("tried/"))]
        outside = [name for name in changed if name not in mine and not name.startswith("tried/")]
        return [f"changes or leaves {name}" for name in sorted({*wrong, *outside})[:3]]

    def keep(self, folder: Path, line: Line, ran: Ran, what: str) -> None:
        """Keep the folder as it was, with the command and what it said."""
        for name, data in self.tree.items():
            path = folder / "tried" / name
            path.parent.mkdir(parents=True, exist_ok=True)
            path.write_bytes(data)
        for name, content in self.before.items():
            if name.startswith("tried/") and isinstance(content, str):
                (folder / name).symlink_to(content.removeprefix("to "))
        words = " ".join(map(repr, ["urdfctl", *line.words]))
        text = f"{words}\n\n{what}\n\nstatus {ran.status}, {ran.seconds:.1f} s, {ran.peak >> 20} MiB\n\n{ran.said}"
        (folder / "what.txt").write_text(text, encoding="utf-8", errors="surrogateescape")


def _waited(pid: int, until: float) -> tuple[int | None, resource.struct_rusage]:
    """Wait for a process; end it and all of its own at some time on the clock."""
    is_late = False
    while True:
        ended, status, used = os.wait4(pid, 0 if is_late else os.WNOHANG)
        if ended:
            with suppress(ProcessLookupError, PermissionError):
                os.killpg(pid, signal.SIGKILL)
            return None if is_late else os.waitstatus_to_exitcode(status), used
        if time.monotonic() > until:
            os.killpg(pid, signal.SIGKILL)
            is_late = True
        time.sleep(0.002)
