"""A campaign: so many guided inputs for the readers in process, and so many whole commands; it can be interrupted.

    python tests/fuzz/campaign.py --inputs 1000000 --commands 20000 --processes 1 --seed 1 --state campaign.json

The same line goes on where an interrupted campaign was. At the end it prints how the inputs were spread, the processor
time, and the faults; the exit status is 1 if there are any.
"""

from __future__ import annotations

import argparse
import sys
from pathlib import Path

from phases import run
from state import COMMANDS, READERS, State


def main() -> int:
    """Go on with a campaign until it is complete, and print its table."""
    parser = argparse.ArgumentParser(description=(__doc__ or "").splitlines()[0])
    parser.add_argument("--inputs", type=int, default=1_000_000, help="guided inputs for the readers")
    parser.add_argument("--commands", type=int, default=20_000, help="whole commands")
    parser.add_argument("--processes", type=int, default=1, help="how many work at the same time")
    parser.add_argument("--seed", default="1")
    parser.add_argument("--state", type=Path, required=True, help="file with the state of the campaign")
    parser.add_argument("--table", action="store_true", help="only print the table of what is done so far")
    given = parser.parse_args()
    try:
        state = State.begun(given.state.resolve(), given.seed, {READERS: given.inputs, COMMANDS: given.commands})
        if not given.table:
            with state.locked():
                state = run(state, given.processes)
    except ValueError as error:
        parser.error(str(error))
    except BlockingIOError:
        parser.error(f"another process goes on with {given.state}")
    sys.stdout.write(state.table())
    return int(bool(state.faults))


if __name__ == "__main__":
    sys.exit(main())
