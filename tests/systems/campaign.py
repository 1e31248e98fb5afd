"""Many systems: drawn, written, judged; and one system made smaller as long as it still fails."""

from __future__ import annotations

from collections import Counter
from collections.abc import Iterable, Iterator, Sequence
from functools import cache
from multiprocessing import get_context
from typing import NamedTuple

from systems.draw import draw
from systems.idioms import SWITCHES, drawn, is_plain, settled
from systems.judge import Verdict, judged
from systems.possible import Idioms
from systems.render import Workspace, render
from systems.system import System


class Tried(NamedTuple):
    """A system with the verdict on what urdfctl says of it.

    crash: the exception of the generator or of urdfctl, if there was one.
    """

    seed: int
    idioms: Idioms
    kind: str
    fault: str
    verdict: Verdict
    crash: str = ""

    @property
    def is_right(self) -> bool:
        """Whether nothing is wrong."""
        return self.verdict.is_right and not self.crash


def workspace_of(seed: int, wanted: Idioms | None = None) -> Workspace:
    """Return the workspace of a seed, in its own idioms, or in wanted ones with all other switches plain."""
    system = draw(seed)
    return render(system, drawn(system) if wanted is None else settled(system, wanted))


@cache
def _prepare() -> None:
    """Import what urdfctl's workers need before they are forked, once."""
    import urdfctl.load.controller_files
    import urdfctl.load.launch_files  # noqa: F401
    from urdfctl.catalog.store import prepare
    from urdfctl.rules import all_faults

    all_faults()
    prepare()


def tried(seed: int) -> Tried:
    """Judge what urdfctl says of the workspace of a seed."""
    return tried_with(seed, drawn(draw(seed)))


def with_only(seeds: Iterable[int], wanted: Idioms) -> Iterator[Tried]:
    """Judge the systems of those seeds that some positions are possible for, with all other switches plain."""
    for seed in seeds:
        idioms = settled(draw(seed), wanted)
        if all(idioms[name] == position for name, position in wanted.items()):
            yield tried_with(seed, idioms)


def tried_with(seed: int, idioms: Idioms) -> Tried:
    """Judge what urdfctl says of the system of a seed, written in some idioms."""
    _prepare()
    system = draw(seed)
    fault = system.fault.kind if system.fault else ""
    verdict, crash = Verdict(), ""
    try:
        verdict = judged(render(system, idioms))
    except Exception as error:  # noqa: BLE001 (a run goes on, and tells it)
        crash = f"{type(error).__name__}: {error}"
    return Tried(seed, idioms, kind_of(system), fault, verdict, crash)


def kind_of(system: System) -> str:
    """Return what kind of system it is, in words."""
    how = "moveit demo" if system.moveit else system.simulator or "hardware"
    return f"ROS {system.generation} {how}{', two robots' if system.is_fleet else ''}"


class Shares(NamedTuple):
    """What is right about many systems, from 0 to 1.

    given: robots are given back as they are started.
    told: of the planted inconsistencies.
    false: systems of which something is told that is no error.
    """

    given: float
    told: float
    false: float


def shares(results: Sequence[Tried]) -> Shares:
    """Return the shares of some systems."""
    faulty = [found for found in results if found.fault]
    given = sum(not found.verdict.missing and not found.crash for found in results)
    told = sum(not found.verdict.untold and not found.crash for found in faulty)
    false = sum(bool(found.verdict.false) for found in results)
    return Shares(given / max(1, len(results)), told / max(1, len(faulty)), false / max(1, len(results)))


def all_tried(seeds: Sequence[int], processes: int) -> Iterator[Tried]:
    """Judge the systems of some seeds, in order."""
    if processes < 2:
        yield from map(tried, seeds)
        return
    with get_context("spawn").Pool(processes) as pool:
        yield from pool.imap(tried, seeds, chunksize=4)


def shrunk(seed: int) -> Tried:
    """Return a system that fails with as many switches in plain positions as it still fails with, in the same way."""
    found = tried(seed)
    wanted = _worst(found)
    changed = True
    while changed and not found.is_right:
        changed = False
        for name in SWITCHES:
            if is_plain(name, found.idioms[name]):
                continue
            plainer = {key: value for key, value in found.idioms.items() if key != name}
            smaller = tried_with(seed, settled(draw(seed), plainer))
            if wanted in ways(smaller) and smaller.idioms != found.idioms:
                found, changed = smaller, True
    return found


def ways(found: Tried) -> list[str]:
    """Return how a system fails, the worst first."""
    verdict = found.verdict
    false = dict.fromkeys(f"false: {line.split()[0]}" for line in verdict.false)
    crash = ["crash"] if found.crash else []
    return [*crash, *false, *(f"untold: {one}" for one in verdict.untold), *verdict.missing]


def _worst(found: Tried) -> str:
    return next(iter(ways(found)), "")


def positions(found: Tried) -> list[tuple[str, str]]:
    """Return what can explain a failure: switches that are not in their plain position, kind and fault."""
    chosen = [(name, position) for name, position in found.idioms.items() if not is_plain(name, position)]
    return [*chosen, ("kind", found.kind), ("fault", found.fault or "none")]


class Row(NamedTuple):
    """How often systems in one position of a switch fail.

    lift: how many times as often as all.
    """

    switch: str
    position: str
    systems: int
    failed: int
    lift: float
    seeds: tuple[int, ...]


def table(results: Sequence[Tried]) -> list[Row]:
    """Return how often each position fails, the most explaining first."""
    every = Counter(place for found in results for place in positions(found))
    failed = [found for found in results if not found.is_right]
    bad = Counter(place for found in failed for place in positions(found))
    share = len(failed) / max(1, len(results))
    rows = []
    for place, count in every.items():
        seeds = tuple(found.seed for found in failed if place in positions(found))[:4]
        lift = bad[place] / count / share if share else 0.0
        rows.append(Row(*place, count, bad[place], lift, seeds))
    return sorted(rows, key=lambda row: (-row.lift * min(row.failed, 10), row.switch, row.position))
