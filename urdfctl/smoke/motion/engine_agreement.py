"""The agreement of two engines: a controller fails only if both of them see it fail; else they disagree."""

from __future__ import annotations

from collections.abc import Iterator, Sequence

from urdfctl.diagnostic import Severity
from urdfctl.rules import fault_of
from urdfctl.rules.smoke.engines_disagree import engines_disagree
from urdfctl.run.limits import WorkerFailure
from urdfctl.smoke.motion.plan import MotionPlan, SimulationResult
from urdfctl.smoke.results import Trouble, trouble_of

_About = tuple[str | None, str]


def is_certain(plan: MotionPlan, result: SimulationResult) -> bool:
    """Return whether the result of one engine needs no second one: it found no error, and judged all it could.

    Wheels on the ground are where engines differ: a base is driven in both, if the first one left time for it.
    """
    if any(map(is_error, result.troubles)) or result.left_to_others:
        return False
    return not any(task.drive for task in plan.tasks) or result.seconds > plan.budget / 2


def is_error(trouble: Trouble) -> bool:
    """Return whether a finding makes its controller fail."""
    return fault_of(trouble.code).severity is Severity.ERROR


def _about(trouble: Trouble) -> _About:
    """What an error is about: a controller, or with its code the robot."""
    return trouble.controller, "" if trouble.controller else trouble.code


def decided(first: SimulationResult, second: SimulationResult, engines: tuple[str, str]) -> SimulationResult:
    """Return what two engines found. An error that only one of them sees is a warning that they disagree.

    A controller that the first engine could not judge is judged by the second one alone.

    engines: their names.
    """
    (_, of_first), (_, of_second) = _disagreeing([(engines[0], first), (engines[1], second)])
    doubts = [trouble for trouble in of_first.troubles if trouble.code == engines_disagree.code]
    troubles = [*of_second.troubles, *doubts]
    moved = tuple(dict.fromkeys((*second.moved, *first.moved)))
    unjudged = {name: why for name, why in second.unjudged.items() if name not in moved}
    tested = {**first.tested, **second.tested}
    seconds = first.seconds + second.seconds
    return second._replace(
        troubles=tuple(troubles),
        moved=moved,
        unjudged=unjudged,
        tested=tested,
        untested={**first.untested, **second.untested},
        seconds=seconds,
        times={
            name: first.times.get(name, 0.0) + second.times.get(name, 0.0) for name in {**first.times, **second.times}
        },
        curves=second.curves or first.curves,
    )


def compared(
    results: Sequence[tuple[str, SimulationResult | WorkerFailure]],
) -> list[tuple[str, SimulationResult | WorkerFailure]]:
    """Return the results of several engines; an error that not all of them see is a warning that they disagree.

    They are returned as they are if an engine crashed or rejects the robot.
    """
    good = [
        (engine, result) for engine, result in results if isinstance(result, SimulationResult) and not result.refused
    ]
    return [*_disagreeing(good)] if len(good) == len(results) > 1 else [*results]


def _disagreeing(results: Sequence[tuple[str, SimulationResult]]) -> Iterator[tuple[str, SimulationResult]]:
    errors = [{_about(trouble) for trouble in result.troubles if is_error(trouble)} for _, result in results]
    judged = [{*result.moved, *(t.controller for t in result.troubles)} for _, result in results]
    for n, (engine, result) in enumerate(results):
        troubles: dict[tuple[_About, bool], Trouble] = {}
        for trouble in result.troubles:
            about = _about(trouble)
            others = [m for m in range(len(results)) if m != n and (about[0] is None or about[0] in judged[m])]
            lonely = is_error(trouble) and others and not any(about in errors[m] for m in others)
            if lonely:
                names = " and ".join(results[m][0] for m in others)
                fields = {"engine": engine, "others": names, "what": trouble.message}
                notes = tuple(note for m in others for note in _measured(*results[m], trouble.controller))
                doubt = trouble_of(engines_disagree, trouble.subject, trouble.controller, notes, **fields)
                troubles.setdefault((about, True), doubt._replace(seen=trouble.code))
            else:
                troubles[(trouble.code, trouble.subject), False] = trouble
        yield engine, result._replace(troubles=tuple(troubles.values()))


def _measured(engine: str, result: SimulationResult, controller: str | None) -> Iterator[str]:
    """What an engine measured of a controller that did not fail there."""
    for curve in result.curves:
        if curve.controller == controller and curve.measured and curve.commanded:
            ends = f"{curve.measured[-1]:.3g} of {curve.commanded[-1]:.3g} {curve.unit}"
            yield f"{engine}: {curve.quantity} of '{curve.joint}' ended at {ends}"
