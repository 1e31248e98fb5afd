"""Kill runs while they write, and say what they leave: `python tests/helpers/processes/killing.py SCENARIO SIGNAL`.

A run ends before its first change to the disk, then before its second, and so on until one gets to its end. After each,
the next run writes to the same place.
"""

from __future__ import annotations

import os
import shutil
import signal
import sys
from collections.abc import Callable, Iterator
from pathlib import Path

_CHANGING = ("os.rename", "os.remove", "os.rmdir", "os.mkdir", "os.link", "os.symlink", "os.chmod", "os.truncate")
_WRITING = os.O_WRONLY | os.O_RDWR | os.O_CREAT
TEMPORARY = ".urdfctl-"


def end_at(number: int, below: Path, by: int) -> Callable[[], int]:
    """Send this process a signal before its change of that number, from 0, to what is below a folder.

    Return a function that says how many changes there were.
    """
    process, count = os.getpid(), 0

    def watch(event: str, arguments: tuple[object, ...]) -> None:
        nonlocal count
        if os.getpid() == process and _changes(event, arguments, str(below)):
            count += 1
            if count == number + 1:
                os.kill(process, by)

    sys.addaudithook(watch)
    return lambda: count


def _changes(event: str, arguments: tuple[object, ...], below: str) -> bool:
    if event == "open":
        flags = arguments[2]
        return isinstance(flags, int) and bool(flags & _WRITING) and str(arguments[0]).startswith(below)
    return event in _CHANGING and any(str(argument).startswith(below) for argument in arguments[:2])


def forked(do: Callable[[], object]) -> int:
    """Do something in a process of its own, and return its exit status; that of a signal is negative."""
    process = os.fork()
    if process == 0:
        try:
            do()
            os._exit(0)
        except KeyboardInterrupt:
            os._exit(130)
        finally:
            os._exit(1)
    return os.waitstatus_to_exitcode(os.waitpid(process, 0)[1])


def tree(folder: Path) -> dict[str, bytes]:
    """The files below a folder by name, and its empty folders."""
    paths = sorted(folder.rglob("*"))
    return {
        str(path.relative_to(folder)): path.read_bytes() if path.is_file() else b"folder"
        for path in paths
        if path.is_file() or not any(path.iterdir())
    }


def without_temporary(found: dict[str, bytes]) -> dict[str, bytes]:
    """What is in a folder but temporary files; a folder with nothing else counts as empty."""
    return {
        name: data for name, data in found.items() if not any(part.startswith(TEMPORARY) for part in Path(name).parts)
    }


# -- what is written ---------------------------------------------------------------------------------------------------


def _in_place() -> None:
    from urdfctl.migrate.writing import write_changes
    from urdfctl.output.change import Change

    told = [("a", b"1", b"2"), ("deep/b", b"1", b"2"), ("gone", b"1", None), ("new/deep/c", None, b"2")]
    changes = [Change(os.path.abspath(name), before, after) for name, before, after in told]
    assert write_changes(changes, ("MIGRATION.md", b"2")) == []


def _package() -> None:
    from urdfctl.generate.files.writing import Writing, deliver
    from urdfctl.generate.options import File
    from urdfctl.output.answer import CommandAnswer

    writing = Writing("src/made", force=True, diff=False, check=False, into=None)
    deliver([File(name, "2") for name in ("config/c.yaml", "package.xml")], writing, CommandAnswer(), many=True)


def _one_file() -> None:
    from urdfctl.generate.files.writing import Writing, deliver
    from urdfctl.generate.options import File
    from urdfctl.output.answer import CommandAnswer

    writing = Writing("config/deep/c.yaml", force=True, diff=False, check=False, into=None)
    deliver([File("c.yaml", "2")], writing, CommandAnswer(), many=False)


_SOME = {"a": b"1", "deep/b": b"1", "gone": b"1"}
_PACKAGE = {"src/made/config/c.yaml": b"2", "src/made/package.xml": b"2"}
Scenario = tuple[Callable[[], None], dict[str, bytes], dict[str, bytes]]
SCENARIOS: dict[str, Scenario] = {
    "in-place": (_in_place, _SOME, {"a": b"2", "deep/b": b"2", "new/deep/c": b"2", "MIGRATION.md": b"2"}),
    "new-package": (_package, {"a": b"1"}, {"a": b"1", **_PACKAGE}),
    "package-again": (_package, {"src/made/package.xml": b"1", "src/own": b"1"}, {"src/own": b"1", **_PACKAGE}),
    "one-file": (_one_file, {"a": b"1"}, {"a": b"1", "config/deep/c.yaml": b"2"}),
    "one-file-again": (_one_file, {"config/deep/c.yaml": b"1"}, {"config/deep/c.yaml": b"2"}),
}
"""What writes, and the files before and after it."""


def faults(name: str, by: int) -> Iterator[str]:
    """Kill a scenario at each of its changes; yield what is neither old nor new then, and what the next run leaves."""
    run, before, after = SCENARIOS[name]
    base = Path.cwd()
    work, cache = base / "work", base / "cache"
    os.environ["XDG_CACHE_HOME"] = str(cache)
    for number in range(1000):
        for path in (work, cache):
            shutil.rmtree(path, ignore_errors=True)
            path.mkdir()
        for file, data in before.items():
            (work / file).parent.mkdir(parents=True, exist_ok=True)
            (work / file).write_bytes(data)
        os.chdir(work)
        status = forked(lambda number=number: (end_at(number, base, by), run()))
        at = f"{name}, {signal.Signals(by).name} at change {number}"
        yield from _faults_after(at, work, (before, after), run)
        if any(path.is_file() for path in cache.rglob("*")):
            yield f"{at}: the next run leaves {[str(path) for path in cache.rglob('*')]}"
        if status == 0:
            print(f"{at}: all changes made")
            return
        if status not in {-by, 130}:
            yield f"{at}: ended with status {status}"


def _faults_after(
    at: str, work: Path, states: tuple[dict[str, bytes], dict[str, bytes]], run: Callable[[], None]
) -> Iterator[str]:
    from urdfctl.output.journal import restore_unfinished

    forked(restore_unfinished)
    left = without_temporary(tree(work))
    if left not in states:
        yield f"{at}: {left} is neither old nor new"
    if left == states[0]:
        forked(run)
    if tree(work) != states[1]:
        yield f"{at}: the next run leaves {tree(work)}"


if __name__ == "__main__":
    found = list(faults(sys.argv[1], signal.Signals[sys.argv[2]]))
    print("\n".join(found))
    sys.exit(1 if found else 0)
