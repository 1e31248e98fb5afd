"""Write random systems as workspaces, and count what urdfctl gives back, tells, and tells falsely.

    python tests/bench/systems.py --count 500 --seed 1
    python tests/bench/systems.py --count 500 --switch description
    python tests/bench/systems.py --count 50 --only "split=spawners apart" top=xml
    python tests/bench/systems.py --keep 17 FOLDER
    python tests/bench/systems.py --shrink 17

The seeds begin at `--seed`. The exit status is 1 if a system fails. See tests/systems.
"""

from __future__ import annotations

import argparse
import sys
from collections.abc import Iterable, Sequence
from pathlib import Path

HERE = Path(__file__).resolve().parents[1]
sys.path[:0] = [str(HERE), str(HERE.parent)]
sys.modules.pop("systems", None)  # this file has the name of the package

from systems.campaign import Tried, all_tried, positions, shrunk, table, tried_with, ways, with_only, workspace_of  # noqa: E402


def main() -> int:
    """Try systems, and print the shares and what fails."""
    parser = argparse.ArgumentParser(description=(__doc__ or "").splitlines()[0])
    parser.add_argument("--count", type=int, default=200)
    parser.add_argument("--seed", type=int, default=1, help="the first seed")
    parser.add_argument("--switch", help="show the failures of this switch only, with a line for each")
    parser.add_argument("--only", nargs="+", metavar="SWITCH=POSITION", help="all other switches are plain")
    parser.add_argument("--processes", type=int, default=2)
    parser.add_argument("--keep", nargs=2, metavar=("SEED", "FOLDER"), help="write one workspace into a folder")
    parser.add_argument("--shrink", type=int, metavar="SEED", help="find the switches that one system fails by")
    given = parser.parse_args()
    if given.keep:
        return _keep(int(given.keep[0]), Path(given.keep[1]), _wanted(given.only))
    if given.shrink is not None:
        return _shrink(given.shrink)
    seeds = range(given.seed, given.seed + given.count)
    wanted = _wanted(given.only)
    results = list(all_tried(seeds, given.processes) if wanted is None else with_only(seeds, wanted))
    _say(_summary(results))
    _say(_by_switch(results, given.switch) if given.switch else _failures(results))
    return int(not all(found.is_right for found in results))


def _wanted(words: Sequence[str] | None) -> dict[str, str] | None:
    """The positions that are named, if any is."""
    return None if words is None else {name: position for name, _, position in (word.partition("=") for word in words)}


def _say(lines: Iterable[str]) -> None:
    sys.stdout.write("".join(f"{line}\n" for line in lines))


def _summary(results: Sequence[Tried]) -> Iterable[str]:
    whole = [found for found in results if not found.verdict.missing and not found.crash]
    faulty = [found for found in results if found.fault]
    told = [found for found in faulty if not found.verdict.untold and not found.crash]
    false = [found for found in results if found.verdict.false]
    yield f"given back {_share(len(whole), len(results))}"
    yield f"told       {_share(len(told), len(faulty))}"
    yield f"falsely    {_share(len(false), len(results))}"
    crashed = [found for found in results if found.crash]
    if crashed:
        yield f"crashed    {_share(len(crashed), len(results))}: seed {crashed[0].seed}, {crashed[0].crash}"


def _share(part: int, whole: int) -> str:
    return f"{part} of {whole} ({100 * part / max(1, whole):.1f} %)"


def _failures(results: Sequence[Tried]) -> Iterable[str]:
    yield "\nwhat is wrong, with how many systems and some seeds"
    seeds: dict[str, list[int]] = {}
    for found in results:
        for way in ways(found):
            seeds.setdefault(way, []).append(found.seed)
    for way, where in sorted(seeds.items(), key=lambda item: -len(item[1])):
        yield f"{len(where):5} {way}  ({' '.join(map(str, where[:5]))})"
    yield "\nswitches: systems, failures, lift (times as often as all), seeds"
    for row in table(results):
        if row.failed:
            name = f"{row.switch}: {row.position}"
            yield f"{row.systems:5} {row.failed:5} {row.lift:5.2f}  {name:42} {' '.join(map(str, row.seeds))}"


def _by_switch(results: Sequence[Tried], name: str) -> Iterable[str]:
    for found in results:
        position = dict(positions(found)).get(name)
        if position and not found.is_right:
            yield f"{found.seed:5} {position:20} {'; '.join([*ways(found), found.crash])}"


def _keep(seed: int, folder: Path, wanted: dict[str, str] | None) -> int:
    workspace = workspace_of(seed, wanted)
    workspace.write(folder)
    _say(_told(tried_with(seed, workspace.idioms)))
    return 0


def _shrink(seed: int) -> int:
    _say(_told(shrunk(seed)))
    return 0


def _told(found: Tried) -> Iterable[str]:
    yield f"seed {found.seed}: {found.kind}, {found.fault or 'no fault'}"
    yield from (f"  {name}: {position}" for name, position in positions(found))
    yield from (f"wrong: {way}" for way in ways(found))
    yield from found.verdict.false
    if found.crash:
        yield found.crash


if __name__ == "__main__":
    sys.exit(main())
