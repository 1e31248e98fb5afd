"""Which test modules take long: `pytest -m fast` leaves them out.

    python -m pytest -n 2 --durations=0 > durations.txt
    python tests/helpers/slow_modules.py durations.txt

writes the list again. A new module counts as fast until then.
"""

from __future__ import annotations

import re
import sys
from collections import defaultdict
from pathlib import Path

TESTS = Path(__file__).parents[1]
LIST = TESTS / "slow_modules.txt"
LONGEST = 1.5
"""Seconds, of all tests of a fast module together."""
ALWAYS_FAST = frozenset({"rules/test_rule_examples.py"})
"""Modules that are too important to be left out."""
_TEST = re.compile(r"\s*([\d.]+)s (?:call|setup|teardown)\s+tests/([\w/]+\.py)::")


def slow_modules() -> frozenset[str]:
    """Return the paths of the slow modules, from `tests` on."""
    return frozenset(LIST.read_text(encoding="utf-8").split())


def main(durations: str) -> None:
    """Write the list from what `pytest --durations=0` printed."""
    seconds: defaultdict[str, float] = defaultdict(float)
    for line in Path(durations).read_text(encoding="utf-8").splitlines():
        match = _TEST.match(line)
        if match:
            seconds[match[2]] += float(match[1])
    slow = sorted(name for name, taken in seconds.items() if taken > LONGEST and name not in ALWAYS_FAST)
    LIST.write_text("".join(f"{name}\n" for name in slow), encoding="utf-8")


if __name__ == "__main__":
    main(sys.argv[1])
