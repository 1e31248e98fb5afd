"""What other tools say of the same mistakes: the section at the end of docs/precision.md.

    python tests/bench/rivals.py

A beginner's mistakes (beginners_mistakes.py in the tests' helpers) are planted one at a time in two packages that work.
A tool sees a mistake if it then says something else than of the sound package, and names it if what it says has the
name that is wrong or missing. Needs xacro, check_urdf, catkin_lint and yamllint; one that is not installed is left out.
"""

from __future__ import annotations

import json
import re
import subprocess
import sys
from collections.abc import Callable, Iterator, Mapping, Sequence
from pathlib import Path
from tempfile import TemporaryDirectory
from typing import NamedTuple

HELPERS = Path(__file__).resolve().parents[1] / "helpers"
sys.path.append(str(HELPERS / "packages"))

from beginners_mistakes import GZ_ROBOT, IN_ARM, IN_BASE, ROBOT, Mistake  # noqa: E402 (found by the line above)
from beginners_robots import ARM, BASE  # noqa: E402
from race.packages import Packages  # noqa: E402
from race.process import NotMeasured, environment, program  # noqa: E402

_TEXT = """\
A beginner's mistakes are planted one at a time in two packages that work: a base for noetic and an arm for jazzy.
*Seen*: the tool says something else than of the sound package. *Named*: it says the name that is wrong or missing.
urdfctl is asked for its first finding. Each of the others was made for another purpose; catkin_lint reads packages of
ROS 1 only."""
HEADER = "| | mistakes | seen | named |\n|---|--:|--:|--:|"
_TIMES = re.compile(r"\b\d+(?:\.\d+)? ?m?s\b")
LINT = (sys.executable, "-m", "urdfctl", "lint", ".", "--no-cache", "--format", "json")
PAIR = '"{xacro}" {robot} > out.urdf && "{check}" out.urdf'
Say = Callable[[Path, Mapping[str, str]], str]


class Tally(NamedTuple):
    """How many mistakes a tool was shown, how many it saw, and how many it named."""

    tool: str
    shown: int
    seen: int
    named: int

    def row(self) -> str:
        """Return a line of the table."""
        return f"| {self.tool} | {self.shown} | {self.seen} | {self.named} |"


def section() -> str:
    """Return the section as Markdown, with a row for each tool that is installed."""
    rows = [tally.row() for tally in tallies()]
    return "\n".join(["## Other tools, the same mistakes", "", _TEXT, "", HEADER, *rows, ""])


def tallies() -> Iterator[Tally]:
    """Yield the tally of each tool that is installed."""
    both = ((BASE, IN_BASE, ROBOT), (ARM, IN_ARM, GZ_ROBOT))
    for tool, make, packages in (
        ("urdfctl lint", _urdfctl, both),
        ("xacro && check_urdf", _pair, both),
        ("yamllint", _yamllint, both),
        ("catkin_lint", _catkin_lint, both[:1]),
    ):
        try:
            yield _tally(tool, packages, make)
        except NotMeasured as error:
            sys.stderr.write(f"{tool} is left out: {error}\n")


def _tally(
    tool: str, packages: Sequence[tuple[dict[str, str], list[Mistake], str]], make: Callable[[str], Say]
) -> Tally:
    shown = [(files, mistake, make(robot)) for files, mistakes, robot in packages for mistake in mistakes]
    said = [(_said(files, None, say), _said(files, mistake, say), mistake) for files, mistake, say in shown]
    seen = [(after, mistake) for before, after, mistake in said if after != before]
    return Tally(tool, len(shown), len(seen), sum(mistake.told in after for after, mistake in seen))


def _said(files: Mapping[str, str], mistake: Mistake | None, say: Say) -> str:
    """What a tool says of a package with a mistake, or of the sound one."""
    changed = {mistake.file: files[mistake.file].replace(mistake.right, mistake.wrong, 1)} if mistake else {}
    with TemporaryDirectory() as temp:
        package = Path(temp) / "src" / "package"
        for name, text in {**files, **changed}.items():
            (package / name).parent.mkdir(parents=True, exist_ok=True)
            (package / name).write_text(text, encoding="utf-8")
        found = Packages(package.parent, Path(temp) / "prefixes")
        return _TIMES.sub("", say(package, found.environment(package))).replace(temp, "")


def _run(command: Sequence[str], folder: Path, environ: Mapping[str, str]) -> str:
    done = subprocess.run(command, cwd=folder, env=environ, capture_output=True, text=True, check=False)
    return f"{done.returncode} {done.stdout}{done.stderr}"


def _urdfctl(robot: str) -> Say:
    distro = ("--distro", "noetic" if robot == ROBOT else "jazzy")

    def say(package: Path, _: Mapping[str, str]) -> str:
        linted = subprocess.run([*LINT, *distro], cwd=package, env=environment(), capture_output=True, check=False)
        found = [one["message"] for one in json.loads(linted.stdout)["findings"] if one["severity"] != "info"]
        return found[0] if found else ""

    return say


def _pair(robot: str) -> Say:
    tools = {"xacro": program("xacro", "pip install xacro"), "check": program("check_urdf", "liburdfdom-tools")}
    command = ("sh", "-c", PAIR.format(robot=robot, **tools))
    return lambda package, environ: _run(command, package, environ)


def _yamllint(_: str) -> Say:
    command = (program("yamllint", "pip install yamllint"), "-d", "relaxed", ".")
    return lambda package, environ: _run(command, package, environ)


def _catkin_lint(_: str) -> Say:
    command = (program("catkin_lint", "pip install catkin-lint"), "--offline", "--rosdistro", "noetic", "-W2", ".")
    return lambda package, environ: _run(command, package, environ)


if __name__ == "__main__":
    sys.stdout.write(section())
