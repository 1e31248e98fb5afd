"""Replay random edits in a folder, and compare what the live workspace finds with `urdfctl lint --format json`."""

from __future__ import annotations

import json
import os
import random
import shutil
import subprocess
import sys
from collections.abc import Iterator
from contextlib import contextmanager
from pathlib import Path
from typing import Any

from edits import edited
from folder import environment

from urdfctl.lint.findings.grouping import grouped
from urdfctl.lint.live import Outdated
from urdfctl.report.common import as_json, relative
from urdfctl.report.json_report import finding
from urdfctl.server.analysis.workspace import Checked, EditorSettings, Workspace

_TEXTS = (".urdf", ".xacro", ".yaml", ".yml", ".launch", ".launch.py", ".launch.xml", ".srdf", ".xml")
_MOST_BYTES = 200_000
_SETTINGS = ('[lint]\nignore = ["UC105"]\n', 'distro = "jazzy"\n', 'simulator = "gz"\n', "distro = 5\n", "")
Findings = list[dict[str, Any]]


def copied(folder: Path, to: Path) -> Path:
    """Copy a folder without its meshes, as a workspace of its own."""
    copy = to / "workspace"
    left_out = shutil.ignore_patterns(".git", "*.dae", "*.stl", "*.STL", "*.png", "*.obj")
    shutil.copytree(folder, copy, ignore=left_out, ignore_dangling_symlinks=True)
    (copy / ".git").mkdir()
    return copy


def differences(folder: Path, edits: int, seed: int, every: int = 1) -> Iterator[str]:
    """Yield each difference between the live findings and those of `urdfctl lint`, after many random edits.

    every: how many edits come between two comparisons. All edits are linted live.
    """
    session = Session(folder, random.Random(seed))  # noqa: S311
    for number in range(1, edits + 1):
        done = session.edit()
        if number % every == 0 and (difference := session.difference()):
            yield f"edit {number} of seed {seed}, {done}: {difference}"
            session.begin()


class Session:
    """A folder as an editor shows it: some texts are open and not saved, and other programs write files meanwhile."""

    def __init__(self, folder: Path, rng: random.Random) -> None:
        self.folder, self._rng = folder.resolve(), rng
        found = [path for path in sorted(self.folder.rglob("*")) if path.is_file() and path.name.endswith(_TEXTS)]
        self._first = {path: _text(path) for path in found if path.stat().st_size < _MOST_BYTES}
        self._fragments = list(self._first.values())
        self._open: dict[Path, list[str]] = {}
        self._moved: list[tuple[Path, Path]] = []
        self._left = -1
        self.begin()

    def begin(self) -> None:
        """Begin with a new workspace, in which the same texts are open."""
        self.live = Workspace(str(self.folder), EditorSettings(), self._is_outdated)
        for path, texts in self._open.items():
            self.live.changed(str(path), _data(texts[-1]))
        self.checked = self.live.check()

    def edit(self) -> str:
        """Make one random edit and lint it live; return what was done."""
        do = self._rng.choices(list(_ACTIONS), list(_ACTIONS.values()))[0]
        path = self._rng.choice(list(self._first))
        do(self, path)
        if self._rng.random() < 1 / 5:  # another key while the robots are linted
            self._left = self._rng.randrange(3)
            with _ignoring_outdated():
                self.live.check()
            self._left = -1
        if self._rng.random() < 1 / 2:
            self.live.check(str(path))  # the package first, as while somebody types
        self.checked = self.live.check()
        crashed = [one.message for found in self.checked.findings.values() for one in found if one.code == "UC000"]
        assert crashed == [], (crashed, do.__name__, path)
        return f"{do.__name__.strip('_')} {path.relative_to(self.folder)}"

    def difference(self) -> str:
        """Return the first difference between the live findings and those of `urdfctl lint`; empty if none."""
        with self._all_saved():
            expected = linted(self.folder)
            found = _as_json(self.checked, self.folder)
        return _first_difference(found, expected)

    def _is_outdated(self) -> bool:
        self._left -= 1
        return self._left == -1

    @contextmanager
    def _all_saved(self) -> Iterator[None]:
        """Within it, the open texts of files are those on disk. A text that was never saved is in no file."""
        before = {path: path.read_bytes() for path in self._open if path.exists()}
        for path in before:
            path.write_bytes(_data(self._open[path][-1]))
        yield
        for path, data in before.items():
            path.write_bytes(data)

    # -- edits ---------------------------------------------------------------------------------------------------------

    def _show(self, path: Path, text: str) -> None:
        self._open.setdefault(path, [_text(path)]).append(text)
        del self._open[path][:-20]
        self.live.changed(str(path), _data(text))

    def _type(self, path: Path) -> None:
        shown = self._open.get(path, [_text(path)])
        self._show(path, edited(shown[-1], self._rng, self._fragments))

    def _undo(self, path: Path) -> None:
        path = self._rng.choice([*self._open, path])
        texts = self._open.get(path, [_text(path)])
        self._show(path, self._rng.choice([*texts, self._first.get(path, "")]))

    def _take_back(self, path: Path) -> None:
        path = self._rng.choice([*self._open, path])
        self._show(path, self._first.get(path, ""))

    def _save(self, path: Path) -> None:
        for each in self._rng.sample(list(self._open), min(len(self._open), 3)):
            is_new = not each.exists()
            each.write_bytes(_data(self._open[each][-1]))
            self._told(each, is_new=is_new)

    def _close(self, path: Path) -> None:
        for each in self._rng.sample(list(self._open), min(len(self._open), 3)):
            del self._open[each]
            self.live.changed(str(each), None)

    def _write(self, path: Path) -> None:
        """Another program writes a file, which may be open here."""
        is_new = not path.exists()
        text = self._first[path] if self._rng.random() < 1 / 2 else edited(_text(path), self._rng, self._fragments)
        path.write_bytes(_data(text))
        self._told(path, is_new=is_new)

    def _rename(self, path: Path) -> None:
        """A file gets another name on disk, or its old one again; an editor opens it again under it."""
        old, new = path, path.with_name(f"other_{path.name}")
        if self._moved and self._rng.random() < 2 / 3:
            old, new = reversed(self._moved.pop())
        if not old.exists() or new.exists():
            return
        old.rename(new)
        self._moved += [(old, new)] if old in self._first else []
        self.live.forget()
        if old in self._open:
            self._open[new] = self._open.pop(old)
            self.live.changed(str(old), None)
            self.live.changed(str(new), _data(self._open[new][-1]))

    def _delete(self, path: Path) -> None:
        """Another program deletes a file, or creates the one that was deleted."""
        gone = [each for each in self._first if not each.exists()]
        if gone and self._rng.random() < 2 / 3:
            back = self._rng.choice(gone)
            back.write_bytes(_data(self._first[back]))
        elif path.exists():
            path.unlink()
        self.live.forget()

    def _new_file(self, path: Path) -> None:
        """A file that is not on disk is typed."""
        ending = self._rng.choice(_TEXTS)
        self._show(path.with_name(f"new{self._rng.randrange(3)}{ending}"), self._rng.choice(self._fragments))

    def _configure(self, path: Path) -> None:
        (self.folder / "urdfctl.toml").write_text(self._rng.choice(_SETTINGS), encoding="utf-8")
        if linted(self.folder) is None:  # told once, and the folder is linted again when it is right
            (self.folder / "urdfctl.toml").unlink()
        self.begin()

    def _told(self, path: Path, *, is_new: bool) -> None:
        self.live.forget() if is_new else self.live.saved(str(path))


_ACTIONS = {
    Session._type: 60,
    Session._undo: 8,
    Session._take_back: 14,
    Session._save: 5,
    Session._close: 5,
    Session._write: 5,
    Session._rename: 2,
    Session._delete: 2,
    Session._new_file: 1,
    Session._configure: 0.3,
}
"""What is done, and how often."""


@contextmanager
def _ignoring_outdated() -> Iterator[None]:
    try:
        yield
    except Outdated:
        return


def linted(folder: Path) -> Findings | None:
    """Return what `urdfctl lint --format json` finds in a folder; None if its configuration is not valid."""
    words = ("lint", ".", "--format", "json", "--exit-zero", "--no-cache")
    ran = subprocess.run(
        [sys.executable, "-m", "urdfctl", *words],
        cwd=folder, env=environment({}), capture_output=True, encoding="utf-8", check=False,
    )  # fmt: skip
    if ran.returncode == 0:
        return sorted(json.loads(ran.stdout)["findings"], key=_key)
    assert ran.returncode == 2, ran.stderr
    return [] if "nothing to lint" in ran.stderr else None


def _as_json(checked: Checked, folder: Path) -> Findings:
    """The findings as a report says them. A report groups equal ones, for which they must be in order."""
    before = Path.cwd()
    os.chdir(folder)
    try:
        everything = sorted((one for found in checked.findings.values() for one in found), key=lambda one: one.order)
        shown = as_json([finding(relative(one)) for one in grouped(everything)])
    finally:
        os.chdir(before)
    return sorted(json.loads(shown), key=_key)


def _key(found: dict[str, Any]) -> str:
    return json.dumps(found, sort_keys=True)


def _first_difference(live: Findings, expected: Findings | None) -> str:
    only_live = [one for one in live if one not in (expected or [])]
    missing = [one for one in expected or [] if one not in live]
    for whose, found, others in (("only live", only_live, missing), ("missing live", missing, only_live)):
        for one in found:
            place = f"{one['file']}:{one['line']}: {one['code']}"
            same = [each for each in others if all(each[name] == one[name] for name in ("code", "file", "line"))]
            if same:
                parts = (f"{name}: {one[name]} against {same[0][name]}" for name in one if one[name] != same[0][name])
                return f"{place} {' '.join(parts)}"
            return f"{place} {whose}: {one['message']}"
    return "" if len(live) == len(expected or []) else "other numbers"


def _text(path: Path) -> str:
    return path.read_bytes().decode("utf-8", "replace") if path.exists() else ""


def _data(text: str) -> bytes:
    return text.encode("utf-8", "surrogatepass")
