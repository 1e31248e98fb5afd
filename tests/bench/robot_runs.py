"""What lint and smoke say about the robots of a folder: errors, and the joints that move."""

from __future__ import annotations

import json
import re
import subprocess
import sys
from pathlib import Path
from typing import Any, NamedTuple

HERE = Path(__file__).resolve().parents[2]
_SECONDS = 600


class LintError(NamedTuple):
    """An error that lint reports, with the file's path in the folder."""

    code: str
    file: str
    message: str


def errors_in(folder: Path, distro: str | None = None) -> set[LintError]:
    """Return the errors of a folder, for a distro or for the one that its files indicate."""
    report = _report("lint", folder, distro)
    errors = (finding for finding in report["findings"] if finding["severity"] == "error")
    return {
        LintError(one["code"], _relative(one["file"], folder), one["message"].replace(f"{folder}/", ""))
        for one in errors
    }


def moved_joints(folder: Path, distro: str | None = None) -> set[str]:
    """Return the joints that a controller moves in a simulation without failing."""
    report = _report("smoke", folder, distro)
    moved = {(one["robot"], one["name"]) for one in report["controllers"] if one["verdict"] in ("passed", "warned")}
    return {one["joint"] for one in report["measurements"] if (one["robot"], one["controller"]) in moved}


def runs_of(before: Path, after: Path, distro: str, *, came_from: str | None = None) -> dict[str, Any]:
    """Return what lint and smoke say of a migrated folder: errors, joints that move, and those that no longer do.

    came_from: the distro before the migration; None for the one that the files indicate.
    """
    known = set(map(_fault, errors_in(before)))
    errors = [error for error in sorted(errors_in(after, distro)) if _fault(error) not in known]
    moved = moved_joints(before, came_from), moved_joints(after, distro)
    return {"errors": errors, "moved": [sorted(joints) for joints in moved], "lost": sorted(moved[0] - moved[1])}


def _fault(error: LintError) -> tuple[str, str]:
    """The error in any file, and of a launch file in any form."""
    return error.code, re.sub(r"\.launch\.(py|xml)\b", ".launch", error.message)


def _report(command: str, folder: Path, distro: str | None) -> dict[str, Any]:
    words = [sys.executable, "-m", "urdfctl", command, str(folder), "--format", "json", "--exit-zero"]
    words += ["--workspace", str(folder)]  # packages laid out without their .git are one workspace all the same
    words += ["--distro", distro] if distro else []
    run = subprocess.run(words, cwd=HERE, capture_output=True, text=True, check=False, timeout=_SECONDS)
    empty = {"findings": [], "controllers": [], "measurements": []}
    return json.loads(run.stdout) if run.stdout.strip() else empty


def _relative(path: str, folder: Path) -> str:
    return str(Path(path).resolve().relative_to(folder.resolve())) if Path(path).is_absolute() else path
