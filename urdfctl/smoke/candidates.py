"""The lives of controllers if the distro is unknown: one in each possible distro, and what they agree on."""

from __future__ import annotations

import re
from collections.abc import Iterator, Mapping, Sequence

from urdfctl.catalog.distros import in_words
from urdfctl.diagnostic import Diagnostic
from urdfctl.lint.elimination import is_weakened
from urdfctl.lint.engine import lint
from urdfctl.lint.memory import RuleMemory
from urdfctl.lint.selection import Selection
from urdfctl.lint.target import LintedTarget
from urdfctl.model.stage import CONTROLLER_STAGES, Stage
from urdfctl.names import enumerated
from urdfctl.rules.smoke.verdict_depends_on_distro import verdict_depends_on_distro
from urdfctl.smoke.manager import Cycle, Way, life_cycle
from urdfctl.smoke.results import ControllerResult, Trouble, Verdict, trouble_of

_ACTIVE = "becomes active"
_FAILURES = {
    Stage.LOAD: "cannot be loaded",
    Stage.CONFIGURE: "cannot be configured",
    Stage.ACTIVATE: "cannot be activated",
}


def cycle_of(seen: LintedTarget) -> Cycle:
    """Return the lives of the controllers of a linted robot.

    If the distro is unknown, they are judged in each possible one. What differs is a warning that names all of them:
    no distro is chosen because it accepts most. The motion is that of the newest distro in which most of them start.
    """
    project = seen.project
    cycles = [life_cycle(project, distro, errors) for distro, errors in _errors_by_distro(seen)]
    if len(cycles) == 1:
        return cycles[0]
    chosen = max(reversed(cycles), key=lambda cycle: sum(way.refusal is None for way in cycle.ways))
    fates = {way.name: _fates(cycles, way.name) for way in chosen.ways}
    open_ = {name for name, fate in fates.items() if _ACTIVE in fate.values() and len(set(fate.values())) > 1}
    ways = tuple(way._replace(by_distro=fates[way.name]) if way.name in open_ else way for way in chosen.ways)
    rejected_by_all = all(cycle.rejected for cycle in cycles)
    troubles = [
        trouble
        for trouble in chosen.troubles
        if (trouble.controller not in open_ if trouble.controller else rejected_by_all)
    ]
    causes = {subject: error for cycle in cycles for subject, error in cycle.causes.items()}
    return chosen._replace(ways=ways, troubles=(*troubles, *_dependent(ways, cycles)), causes=causes)


def _errors_by_distro(seen: LintedTarget) -> Iterator[tuple[str, Sequence[Diagnostic]]]:
    """Yield each possible distro, with what lint finds in it."""
    project, known = seen.project, seen.result.outcome.diagnostics
    if len(project.distros) == 1 or project.distro or not (project.controllers and project.controllers.controllers):
        yield project.distro or project.distros[-1], known
        return
    weakened = {(each.code, each.at) for each in known if is_weakened(each)}
    memory, sources = RuleMemory(), list(seen.sources.values())
    for distro in project.distros:
        outcome = lint(project._replace(distro=distro, distros=(distro,)), sources, Selection(), memory=memory)
        yield distro, [each for each in outcome.diagnostics if (each.code, each.at) not in weakened]


def _fates(cycles: Sequence[Cycle], name: str) -> dict[str, str]:
    """What happens to a controller in each distro, in words."""
    fates = {}
    for cycle in cycles:
        refusal = next((way.refusal for way in cycle.ways if way.name == name), None)
        why = re.sub(rf"\bin {cycle.distro}\b", "there", refusal.why) if refusal else ""
        fates[cycle.distro] = f"{_FAILURES[refusal.stage]}: {why}" if refusal else _ACTIVE
    return fates


def fates_in_words(fates: Mapping[str, str]) -> str:
    """Return the fates of a controller by distro in words, the best one first; distros of the same fate are joined."""
    ordered = sorted(dict.fromkeys(fates.values()), key=lambda fate: fate != _ACTIVE)
    words = {fate: in_words(distro for distro in fates if fates[distro] == fate) for fate in ordered}
    parts = [(*fate.partition(": "), distros) for fate, distros in words.items()]
    return "; ".join(f"it {what} in {distros}{mark}{why}" for what, mark, why, distros in parts)


def _dependent(ways: Sequence[Way], cycles: Sequence[Cycle]) -> Iterator[Trouble]:
    """A finding for each fate that depends on the distro; controllers that share it are named in a note."""
    found: dict[str, list[str]] = {}
    for way in ways:
        if way.by_distro:
            found.setdefault(fates_in_words(way.by_distro), []).append(way.name)
    for words, (first, *others) in found.items():
        causes = [t for cycle in cycles for t in cycle.troubles if t.controller in (first, None)]
        causes = sorted(causes, key=lambda trouble: trouble.controller is None)
        notes = [trouble.message for trouble in causes[:1] if trouble.message.partition(": ")[2] not in words]
        also = enumerated(f"'{name}'" for name in others)
        notes += [f"the same holds for {also}"] if also else []
        at = causes[0].subject if causes else f"controller:{first}"
        yield trouble_of(verdict_depends_on_distro, at, first, tuple(notes), verdicts=words)


def result_of(way: Way) -> ControllerResult:
    """Return the result of a controller as long as nothing is simulated: warned if it depends on the distro."""
    if not way.by_distro:
        return way.result
    stages = [stage for words in way.by_distro.values() for stage, what in _FAILURES.items() if words.startswith(what)]
    stage = min(stages, key=CONTROLLER_STAGES.index, default=Stage.ACTIVATE)
    reason = f"depends on the ROS distro: {fates_in_words(way.by_distro)}"
    return way.result._replace(verdict=Verdict.WARNED, stage=stage, reason=reason, by_distro=way.by_distro)
