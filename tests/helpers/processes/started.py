"""What launch files in Python would start, found by running them against a stand-in for launch and launch_ros."""

from __future__ import annotations

import json
import subprocess
import sys
from pathlib import Path
from typing import Any
from xml.etree import ElementTree as ET

_START = Path(__file__).parents[1] / "launch_stand_in" / "start.py"


class NotStarted(Exception):
    """A launch file raises when it runs."""


def packages_below(folder: Path) -> dict[str, str]:
    """The folders of the packages below a folder, by name."""
    found = {ET.parse(path).findtext("name", "").strip(): path.parent for path in folder.rglob("package.xml")}
    return {name: str(path.resolve()) for name, path in found.items()}


def started(launch_file: Path, workspace: Path, *given: str) -> list[dict[str, Any]]:
    """Return what a launch file starts in order: processes, nodes and the launch files of other packages."""
    words = [json.dumps(packages_below(workspace)), str(launch_file.resolve()), *given]
    ran = subprocess.run([sys.executable, str(_START), *words], capture_output=True, text=True, check=False)
    if ran.returncode:
        raise NotStarted(ran.stderr.strip())
    return list(json.loads(ran.stdout))
