"""Migrate random systems of Gazebo Classic to gz, and count those that start what they started before.

    python tests/bench/migrated_systems.py --count 300 --seed 1

The seeds begin at `--seed`; those of other systems are passed over. The exit status is 1 if a system fails. See
tests/systems.
"""

from __future__ import annotations

import argparse
import re
import sys
from multiprocessing import get_context
from pathlib import Path

HERE = Path(__file__).resolve().parents[1]
sys.path[:0] = [str(one) for one in (HERE, HERE.parent, HERE / "helpers", HERE / "helpers" / "processes")]

from systems.idioms import is_plain  # noqa: E402
from systems.migrated import Migrated, is_migrated, migrated  # noqa: E402


def main() -> int:
    """Migrate systems, and print what is wrong and how many are right."""
    parser = argparse.ArgumentParser(description=(__doc__ or "").splitlines()[0])
    parser.add_argument("--count", type=int, default=100, help="how many seeds to look at")
    parser.add_argument("--seed", type=int, default=1, help="the first seed")
    parser.add_argument("--processes", type=int, default=2)
    given = parser.parse_args()
    seeds = [seed for seed in range(given.seed, given.seed + given.count) if is_migrated(seed)]
    with get_context("spawn").Pool(given.processes) as pool:
        results = list(pool.imap(migrated, seeds))
    failed = [found for found in results if found.wrong]
    ways: dict[str, list[int]] = {}
    for found in failed:
        sys.stdout.write(_told(found))
        for way in {re.sub(r"'[^']*'|/\S+", "...", one.splitlines()[0]) for one in found.wrong}:
            ways.setdefault(way, []).append(found.seed)
    sys.stdout.write(f"{len(results) - len(failed)} of {len(results)} start what they started before\n")
    for way, where in sorted(ways.items(), key=lambda item: -len(item[1])):
        sys.stdout.write(f"{len(where):5} {way}  ({' '.join(map(str, where[:5]))})\n")
    return int(bool(failed))


def _told(found: Migrated) -> str:
    chosen = (f"{name}: {position}" for name, position in found.idioms.items() if not is_plain(name, position))
    return "".join([f"seed {found.seed}: {', '.join(chosen)}\n", *(f"  {one}\n" for one in found.wrong)])


if __name__ == "__main__":
    sys.exit(main())
