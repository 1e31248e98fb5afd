"""Make the pictures of the documentation: `python docs/pictures/make.py [FOLDER]`.

Only that of a page needs a browser, Chromium; without it, it is left as it is. The terminal and the graph are SVG,
the robot is drawn by `urdfctl view`.
"""

from __future__ import annotations

import os
import re
import shutil
import subprocess
import sys
from pathlib import Path

HERE = Path(__file__).parent
CHECKOUT = HERE.parents[1]
TERMINAL = ("lint", "samples/broken/mybot", "--select", "UC201")
GRAPH = ("graph", "samples/gripper", "--format", "svg")
ROBOT = ("view", "samples/gripper", "--image")
PAGE = ("smoke", "samples/mybot")
_COLUMNS = 120


def main() -> int:
    """Make the pictures in a folder, by default in that of the documentation."""
    folder = Path(sys.argv[1]) if len(sys.argv) > 1 else HERE
    (folder / "lint.svg").write_text(terminal(*TERMINAL), encoding="utf-8")
    (folder / "graph.svg").write_text(run(*GRAPH), encoding="utf-8")
    run(*ROBOT, str((folder / "robot.png").resolve()))
    photograph(PAGE, (folder / "page.png").resolve())
    return 0


def photograph(words: tuple[str, ...], picture: Path) -> None:
    """Write a picture of the page that a command reports, if Chromium is installed."""
    browser = shutil.which("chromium") or shutil.which("chromium-browser")
    if browser is None:
        return
    page = CHECKOUT / "page.html"
    try:
        run(*words, "--report", page.name)
        look = ["--headless", "--no-sandbox", "--disable-gpu", "--hide-scrollbars", "--window-size=1000,1700"]
        command = [browser, *look, f"--screenshot={picture}", page.as_uri()]
        subprocess.run(command, capture_output=True, check=True, timeout=120)  # noqa: S603
    finally:
        page.unlink(missing_ok=True)


def run(*words: str, colour: bool = False) -> str:
    """Return what a command prints."""
    environ = {**os.environ, "COLUMNS": str(_COLUMNS), "SOURCE_DATE_EPOCH": "0"}
    environ |= {"FORCE_COLOR": "1", "TERM": "xterm-256color"} if colour else {"NO_COLOR": "1"}
    command = [sys.executable, "-m", "urdfctl", *words]
    done = subprocess.run(command, cwd=CHECKOUT, env=environ, stdout=subprocess.PIPE, encoding="utf-8", check=False)  # noqa: S603
    if done.returncode not in (0, 1):
        raise SystemExit(f"{' '.join(words)}: exit status {done.returncode}")
    return done.stdout


def terminal(*words: str) -> str:
    """Return a terminal with a command and what it prints, as SVG that loads no font from the network."""
    from rich.console import Console
    from rich.text import Text

    with open(os.devnull, "w", encoding="utf-8") as nowhere:
        console = Console(record=True, width=_COLUMNS, file=nowhere, force_terminal=True)
        console.print(Text(f"$ urdfctl {' '.join(words)}", style="bold"))
        console.print(Text.from_ansi(run(*words, colour=True)))
    picture = console.export_svg(title="urdfctl", unique_id="urdfctl")
    return re.sub(r"@font-face \{.*?\}\s*", "", picture, flags=re.DOTALL) + "\n"


if __name__ == "__main__":
    raise SystemExit(main())
