#!/usr/bin/env python3
"""Measure `urdfctl server`: how soon findings come after a file is opened and after each keystroke, and its memory.

    python tests/bench/editing.py FOLDER FILE [--keys 40]
    python tests/bench/editing.py ../shared/corpus/UniversalRobots__Universal_Robots_ROS2_Description urdf/ur.urdf.xacro

Printed are medians in ms, beside the time of one `urdfctl lint FILE --no-cache` as a whole process on the same machine,
and the resident set of the server in MB at the end. A key adds or deletes a blank line at the end of the file, so that
everything which depends on the text is linted again. Nothing here judges.
"""

from __future__ import annotations

import argparse
import asyncio
import statistics
import subprocess
import sys
import time
from pathlib import Path

CHECKOUT = Path(__file__).resolve().parents[2]
sys.path[:0] = [str(CHECKOUT), str(CHECKOUT / "tests/helpers/editors")]

from editor import Editor  # noqa: E402


async def measured(folder: Path, name: str, keys: int) -> dict[str, float]:
    """Return the figures of one session."""
    editor = Editor(folder)
    await editor.start()
    await asyncio.sleep(2)  # editors start the server before a file is opened
    started = time.perf_counter()
    await editor.open(name)
    await editor.checked_near()
    opened = time.perf_counter() - started
    await editor.checked()
    text = (folder / name).read_text(encoding="utf-8")
    seconds = []
    for key in range(keys):
        started = time.perf_counter()
        await editor.type(name, text + "\n" * (key % 2))
        await editor.checked_near()
        seconds.append(time.perf_counter() - started)
        await editor.checked()
    memory = _resident(editor.pid)
    await editor.stop()
    return {"opened ms": 1000 * opened, "key ms": 1000 * statistics.median(seconds), "memory MB": memory}


def _resident(pid: int) -> float:
    for line in Path(f"/proc/{pid}/status").read_text(encoding="ascii").splitlines():
        if line.startswith("VmHWM:"):
            return int(line.split()[1]) / 1024
    return 0.0


def lint_ms(folder: Path, name: str, runs: int = 7) -> float:
    """Return the median time of linting the file as a whole process."""
    seconds = []
    for _ in range(runs):
        started = time.perf_counter()
        subprocess.run(
            [sys.executable, "-m", "urdfctl", "lint", name, "--no-cache", "--exit-zero"],
            cwd=folder, env=Editor.environment(), capture_output=True, check=False,
        )  # fmt: skip
        seconds.append(time.perf_counter() - started)
    return 1000 * statistics.median(seconds)


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("folder", type=Path)
    parser.add_argument("file")
    parser.add_argument("--keys", type=int, default=40)
    given = parser.parse_args()
    folder = given.folder.resolve()
    figures = asyncio.run(measured(folder, given.file, given.keys))
    once = lint_ms(folder, given.file)
    print("  ".join(f"{name} {value:.0f}" for name, value in {**figures, "lint ms": once}.items()))
    print(f"as ratios to one lint run: opened {figures['opened ms'] / once:.2f}, key {figures['key ms'] / once:.2f}")


if __name__ == "__main__":
    main()
