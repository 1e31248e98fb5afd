"""A temporary folder of literal files, and the command as a process in it."""

from __future__ import annotations

import os
import subprocess
import sys
from collections.abc import Mapping
from functools import cache
from pathlib import Path

from prepared import Prepared

CHECKOUT = Path(__file__).parents[2]


class Folder:
    """A temporary folder, which is the current one during the test."""

    def __init__(self, path: Path) -> None:
        self.path = path

    def write(self, files: Mapping[str, str | bytes]) -> None:
        """Write files by name, with their line ends unchanged."""
        for name, content in files.items():
            path = self.path / name
            path.parent.mkdir(parents=True, exist_ok=True)
            path.write_bytes(content.encode() if isinstance(content, str) else content)

    def run(
        self,
        *words: str,
        environ: Mapping[str, str | None] | None = None,
        cwd: Path | str | None = None,
        text: str | None = None,
    ) -> subprocess.CompletedProcess[str]:
        """Run `urdfctl` as a process; an environment variable that is None is removed."""
        variables, place = environment(environ or {}), str(cwd or self.path)
        if sys.platform == "linux" and _prepared().fits(variables):
            return _prepared().run(words, environ=variables, cwd=place, text=text or "")
        return subprocess.run(
            [sys.executable, "-m", "urdfctl", *words],
            cwd=place,
            env=variables,
            input=text,
            capture_output=True,
            encoding="utf-8",
            errors="surrogateescape",
            timeout=60,
            check=False,
        )


@cache
def _prepared() -> Prepared:
    return Prepared(environment({}))


def environment(changes: Mapping[str, str | None]) -> dict[str, str]:
    """Return this process's environment without ROS and colours, with some changes; the checkout is imported first."""
    plain = {name: value for name, value in os.environ.items() if not name.startswith("ROS_") and name not in UNWANTED}
    plain |= {name: value for name, value in changes.items() if value is not None}
    plain["PYTHONPATH"] = checkout_first(plain.get("PYTHONPATH"))
    return {name: value for name, value in plain.items() if changes.get(name, "") is not None}


def checkout_first(python_path: str | None) -> str:
    """Return a PYTHONPATH in which this checkout comes before any other copy of urdfctl."""
    others = [entry for entry in (python_path or "").split(os.pathsep) if entry not in ("", str(CHECKOUT))]
    return os.pathsep.join([str(CHECKOUT), *others])


UNWANTED = {
    *("NO_COLOR", "FORCE_COLOR", "COLUMNS", "AMENT_PREFIX_PATH", "COLCON_PREFIX_PATH", "CMAKE_PREFIX_PATH"),
    "PYTHONDONTWRITEBYTECODE",  # without bytecode each process compiles everything again: three times as slow
}
