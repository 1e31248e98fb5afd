"""Fuzz for some time: `python tests/fuzz --seconds 300 --seed 1`, one half guided inputs, the other whole commands.

To import and read what all inputs begin with takes some seconds more.
The files and folders that show a fault are kept; the exit status is 1 if there are any. For so many inputs instead of
so much time, see campaign.py.
"""

from __future__ import annotations

import argparse
import sys
import tempfile
from pathlib import Path

from phases import run
from state import COMMANDS, READERS, State

_ENDLESS = 10**9


def main() -> int:
    """Fuzz until the time is over, and print what was tried and found."""
    parser = argparse.ArgumentParser(description=(__doc__ or "").splitlines()[0])
    parser.add_argument("--seconds", type=float, default=60)
    parser.add_argument("--seed", default="1")
    parser.add_argument("--processes", type=int, default=1, help="how many work at the same time")
    parser.add_argument("--keep", type=Path, default=Path("fuzz-faults"), help="folder for what shows a fault")
    given = parser.parse_args()
    with tempfile.TemporaryDirectory(prefix="urdfctl-fuzz-") as held:
        state = State(Path(held, "state"), given.seed, {READERS: _ENDLESS, COMMANDS: _ENDLESS}, given.keep.resolve())
        state = run(state, given.processes, given.seconds / 2)
    sys.stdout.write(state.table())
    return int(bool(state.faults))


if __name__ == "__main__":
    sys.exit(main())
