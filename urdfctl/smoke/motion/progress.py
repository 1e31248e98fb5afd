"""The results of a simulation before it ends: lines for a terminal, and a file that survives the end of its process."""

from __future__ import annotations

import json
from collections.abc import Iterator

from urdfctl.output.temporary import write_beside
from urdfctl.smoke.motion.engine_agreement import is_error
from urdfctl.smoke.motion.plan import MotionPlan, SimulationResult


def keep(known: SimulationResult, path: str) -> None:
    """Write what is known to a file, whole or not at all."""
    write_beside(path, json.dumps(known._asdict()).encode(), lasting=False)


def kept(path: str) -> SimulationResult:
    """Return what was kept in a file; nothing if there is none."""
    try:
        with open(path, encoding="utf-8") as file:
            return SimulationResult.from_json(json.load(file))
    except OSError:
        return SimulationResult()


def stopped_early(plan: MotionPlan, known: SimulationResult, why: str) -> SimulationResult:
    """Return what is known of a plan whose simulation was stopped: the other controllers were not tested."""
    names = [task.controller for task in plan.tasks]
    done = {*known.moved, *(trouble.controller for trouble in known.troubles)}
    count = sum(name in done for name in names)
    told = f"not tested: {why}; {count} of {len(names)} controllers tested"
    return known._replace(unjudged={**known.unjudged, **{name: told for name in names if name not in done}})


def live_lines(known: SimulationResult, plan: MotionPlan, told: set[str]) -> Iterator[str]:
    """Yield a line for each controller with a result that is not in `told`, and add it there."""
    errors = {trouble.controller: trouble for trouble in reversed(known.troubles) if is_error(trouble)}
    names = [task.controller for task in plan.tasks]
    for name in names:
        done = name in known.moved or name in errors
        if name in told or not (done or name in known.times):
            continue
        told.add(name)
        what = ", ".join(known.tested.get(name, ())) or known.unjudged.get(name, "")
        if name in errors:
            what = f"fails: {errors[name].message}"
        yield f"[{len(told)}/{len(names)}] {name}: {what} ({plan.engine}, {known.times.get(name, 0.0):.2f} s)"
