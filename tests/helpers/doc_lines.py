"""The command lines of the documentation, run in a copy of the samples. As a script, it writes what they print anew.

A fenced block without a language holds command lines; what follows three blanks or ` #` explains one. In a block whose
first line starts with `$ `, the lines after a command are its output. A comment before a block says what else is so:

    <!-- not run: it starts the simulator -->     why no line of it can be run here
    <!-- status 1 -->                             the exit status, if it is not 0
    <!-- in samples/picker -->                    the folder in which this block and those after it are run
"""

from __future__ import annotations

import contextlib
import os
import re
import shlex
import shutil
import subprocess
import sys
import tempfile
from collections.abc import Iterator
from pathlib import Path
from typing import NamedTuple

from folder import CHECKOUT
from generating import command

_BLOCK = re.compile(r"((?:^ *<!-- [^\n]* -->\n)*)^( *)```([^\n]*)\n(.*?)^ *```", re.MULTILINE | re.DOTALL)
_SHELL = re.compile(r"&&|[|<>]")
_VARYING = re.compile(r"\d+\.\d+ s\b")
HOME = Path("samples/picker")
"""Where the commands of a page are run, if the page says nothing else."""


class Line(NamedTuple):
    """A command line of a page.

    output: what the page shows after it; None if it shows nothing.
    folder: where it is run.
    why_not: why it cannot be run.
    """

    text: str
    output: str | None
    folder: Path
    status: int
    why_not: str | None


def pages() -> list[Path]:
    """Return the pages that a user reads."""
    found = [CHECKOUT / "README.md", CHECKOUT / "AGENTS.md"]
    found += [*CHECKOUT.glob("docs/*.md"), *CHECKOUT.glob("docs/commands/*.md"), *CHECKOUT.glob("samples/*.md")]
    return sorted(path for path in found if path.exists())


def lines_of(page: Path) -> Iterator[Line]:
    """Yield the command lines of a page, in its order."""
    folder = Path() if page.name == "README.md" else HOME
    for comments, indent, language, body in _BLOCK.findall(page.read_text(encoding="utf-8")):
        said = dict(re.findall(r"<!-- (not run:|status|in) ?(.*?) -->", comments))
        folder = Path(said.get("in", folder))
        if language:
            continue
        rows = [row.removeprefix(indent) for row in body.splitlines()]
        for text, output in _commands(rows):
            yield Line(text, output, folder, int(said.get("status", 0)), said.get("not run:"))


def _commands(rows: list[str]) -> Iterator[tuple[str, str | None]]:
    """The commands of a block, each with what it shows of its output."""
    if not rows[0].startswith("$ "):
        yield from ((re.split(r"\s{3,}|\s+# ", row)[0], None) for row in rows if row.strip())
        return
    starts = [at for at, row in enumerate(rows) if row.startswith("$ ")]
    for at, after in zip(starts, [*starts[1:], len(rows)], strict=True):
        yield rows[at].removeprefix("$ "), "".join(f"{row}\n" for row in rows[at + 1 : after])


def printed_by(line: Line, root: Path) -> tuple[int, str]:
    """Run a line in a copy of the samples; return its exit status, and what it prints (errors only if it fails)."""
    with _within(root / line.folder):
        if _SHELL.search(re.sub(r"'[^']*'|\"[^\"]*\"", "", line.text)):
            ran = subprocess.run(["bash", "-c", _LAUNCHER + line.text], capture_output=True, text=True, check=False)
            return ran.returncode, ran.stdout or ran.stderr
        said = command(*shlex.split(line.text)[1:])
        return said.returncode, said.stdout or (said.stderr if said.returncode else "")


_LAUNCHER = f'urdfctl() {{ PYTHONPATH="{CHECKOUT}" "{sys.executable}" -m urdfctl "$@"; }}\nset -o pipefail\n'


@contextlib.contextmanager
def _within(folder: Path) -> Iterator[None]:
    before = Path.cwd()
    os.chdir(folder)
    try:
        yield
    finally:
        os.chdir(before)


@contextlib.contextmanager
def copied_samples() -> Iterator[Path]:
    """Make a copy of what the pages name, as a clone of the repository with one commit."""
    with tempfile.TemporaryDirectory(prefix="doc_lines.") as folder:
        root = Path(folder).resolve()
        shutil.copytree(CHECKOUT / "samples", root / "samples", ignore=shutil.ignore_patterns("README.md"))
        git = ["git", "-c", "user.name=n", "-c", "user.email=n@example.org", "-C", str(root)]
        for words in (["init", "--quiet"], ["add", "."], ["commit", "--quiet", "-m", "samples"]):
            subprocess.run([*git, *words], check=True, capture_output=True)
        yield root


def steady(text: str) -> str:
    """What does not differ from run to run in what is printed."""
    return _VARYING.sub("0.0 s", text)


def _updated(page: Path) -> str:
    """A page with what its lines print now."""
    text = page.read_text(encoding="utf-8")
    with copied_samples() as root:
        for line in lines_of(page):
            if line.why_not is None:
                _, out = printed_by(line, root)
                if line.output is not None and steady(out) != steady(line.output):
                    text = text.replace(f"$ {line.text}\n{line.output}", f"$ {line.text}\n{out}", 1)
    return text


if __name__ == "__main__":
    for one in [Path(word).resolve() for word in sys.argv[1:]] or pages():
        one.write_text(_updated(one), encoding="utf-8")
