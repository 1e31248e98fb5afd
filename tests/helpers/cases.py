"""Golden cases: each folder of tests/cases is linted from within, and what is printed stands in its expected.txt.

The first line of a file `command` gives the arguments of `urdfctl lint`; without one the folder is linted. Samples are
linted from the checkout, so that lines do not depend on where it is. The last line of expected.txt is the exit status.
To write the files anew, and then read the difference:

    python tests/helpers/cases.py --update
"""

from __future__ import annotations

import os
import shlex
import subprocess
import sys
from pathlib import Path

from folder import CHECKOUT, environment

CASES = Path(__file__).parents[1] / "cases"
NAMES = sorted(path.name for path in CASES.iterdir() if path.is_dir())


def said(case: Path) -> str:
    """What `urdfctl lint` prints in a case's folder, and its exit status."""
    command = case / "command"
    words = shlex.split(command.read_text(encoding="utf-8").splitlines()[0]) if command.exists() else ["."]
    ran = subprocess.run(
        [sys.executable, "-m", "urdfctl", "lint", *words],
        cwd=CHECKOUT if words[0].startswith("samples/") else case,
        env=environment({"PYTHONPATH": os.pathsep.join(path for path in sys.path if path)}),
        capture_output=True,
        check=False,
    )
    told = f"{ran.stdout.decode()}{ran.stderr.decode()}exit status {ran.returncode}\n"
    return told.replace(str(CHECKOUT), "<checkout>")


def main() -> None:
    """Write what lint says now."""
    if sys.argv[1:] != ["--update"]:
        sys.exit(__doc__)
    for name in NAMES:
        (CASES / name / "expected.txt").write_bytes(said(CASES / name).encode())


if __name__ == "__main__":
    main()
