"""A folder of literal files to stand in, and the command as a process that runs there."""

from __future__ import annotations

import os
import subprocess
import sys
from collections.abc import Mapping
from pathlib import Path

CHECKOUT = Path(__file__).parents[1]


class Folder:
    """A folder of its own, which is the current one during the test."""

    def __init__(self, path: Path) -> None:
        self.path = path

    def write(self, files: Mapping[str, str | bytes]) -> None:
        """Write files by their names, as they stand: no line end is changed."""
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
        """`urdfctl` with some words, as a process of its own; a variable that is None is taken out."""
        return subprocess.run(
            [sys.executable, "-m", "urdfctl", *words],
            cwd=cwd or self.path,
            env=environment(environ or {}),
            input=text,
            capture_output=True,
            encoding="utf-8",
            errors="surrogateescape",
            timeout=60,
            check=False,
        )


def environment(changes: Mapping[str, str | None]) -> dict[str, str]:
    """This process's environment without what tells of ROS or colours, and with some changes."""
    plain = {name: value for name, value in os.environ.items() if not name.startswith("ROS_") and name not in UNWANTED}
    plain |= {name: value for name, value in changes.items() if value is not None}
    return {name: value for name, value in plain.items() if changes.get(name, "") is not None}


UNWANTED = {"NO_COLOR", "FORCE_COLOR", "COLUMNS", "AMENT_PREFIX_PATH", "COLCON_PREFIX_PATH", "CMAKE_PREFIX_PATH"}
