"""Replay random edits in a folder, and compare what the live workspace finds with a run that knows nothing."""

from __future__ import annotations

import os
import random
import shutil
from collections.abc import Iterator, Mapping
from pathlib import Path

from edits import edited

from urdfctl.diagnostic import Diagnostic
from urdfctl.server.workspace import Wishes, Workspace

_TEXTS = (".urdf", ".xacro", ".yaml", ".launch", ".launch.py", ".launch.xml")
_MOST_BYTES = 200_000
_TAKEN_BACK = 0.3
"""The share of edits that bring the first text of a file back, so that not all files become nonsense."""

Findings = Mapping[str, tuple[Diagnostic, ...]]


def copied(folder: Path, to: Path) -> Path:
    """Copy a folder without its meshes, as a workspace of its own."""
    copy = to / "workspace"
    left_out = shutil.ignore_patterns(".git", "*.dae", "*.stl", "*.STL", "*.png", "*.obj")
    shutil.copytree(folder, copy, ignore=left_out, ignore_dangling_symlinks=True)
    (copy / ".git").mkdir()
    return copy


def differences(folder: Path, edits: int, seed: int) -> Iterator[str]:
    """Yield each difference between the live findings and those of a new workspace, after each of many random edits."""
    rng = random.Random(seed)  # noqa: S311
    files = [path for path in sorted(folder.rglob("*")) if path.is_file() and path.name.endswith(_TEXTS)]
    files = [path for path in files if path.stat().st_size < _MOST_BYTES]
    first = {path: path.read_text(encoding="utf-8", errors="replace") for path in files}
    now = dict(first)
    live = Workspace(str(folder), Wishes())
    live.check()
    for number in range(edits):
        path = rng.choice(files)
        now[path] = first[path] if rng.random() < _TAKEN_BACK else edited(now[path], rng)
        data = now[path].encode("utf-8", "surrogatepass")
        live.changed(str(path), data)
        if rng.random() < 1 / 2:
            live.check(str(path))  # the package first, as while somebody types
        found = live.check().findings
        path.write_bytes(data)
        expected = Workspace(str(folder), Wishes()).check().findings
        if found != expected:
            yield f"edit {number} of {path.relative_to(folder)}: {_difference(found, expected)}"
            live.forget()


def _difference(found: Findings, expected: Findings) -> str:
    for file in sorted({*found, *expected}):
        mine, other = set(found.get(file, ())), set(expected.get(file, ()))
        for finding in sorted(mine ^ other, key=lambda one: one.order):
            whose = "only live" if finding in mine else "missing live"
            return f"{os.path.basename(file)}:{finding.at.line}: {finding.code} {whose}: {finding.message}"
    return "another order"
