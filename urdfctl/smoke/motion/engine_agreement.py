"""The agreement of two engines: a controller fails only if both of them see it fail."""

from __future__ import annotations

from collections.abc import Iterator, Sequence

from urdfctl.diagnostic import Severity
from urdfctl.rules import fault_of
from urdfctl.rules.smoke.engines_disagree import engines_disagree
from urdfctl.run.limits import WorkerFailure
from urdfctl.smoke.motion.plan import SimulationResult
from urdfctl.smoke.results import Trouble, trouble_of

_About = tuple[str | None, str]


def is_certain(result: SimulationResult) -> bool:
    """Return whether the result of one engine needs no second one: it found no error, and judged all it could."""
    return not any(map(is_error, result.troubles)) and not result.left_to_others


def is_error(trouble: Trouble) -> bool:
    """Return whether a finding makes its controller fail."""
    return fault_of(trouble.code).severity is Severity.ERROR


def _about(trouble: Trouble) -> _About:
    """What an error is about: a controller, or with its code the robot."""
    return trouble.controller, "" if trouble.controller else trouble.code


def decided(first: SimulationResult, second: SimulationResult) -> SimulationResult:
    """Return what two engines found, of which the second one decides. Errors that only one of them sees are left out.

    A controller that the first engine could not judge is judged by the second one alone.
    """
    seen = {_about(trouble) for trouble in first.troubles if is_error(trouble)}
    alone = {(name, "") for name in first.left_to_others}
    troubles = [t for t in second.troubles if not is_error(t) or _about(t) in seen or _about(t) in alone]
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
                troubles.setdefault(
                    (about, True), trouble_of(engines_disagree, trouble.subject, trouble.controller, (), **fields)
                )
            else:
                troubles[(trouble.code, trouble.subject), False] = trouble
        yield engine, result._replace(troubles=tuple(troubles.values()))
