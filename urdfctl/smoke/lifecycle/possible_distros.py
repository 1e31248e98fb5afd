"""The lifecycles of controllers if the distro is unknown: one in each possible distro, and what they agree on."""

from __future__ import annotations

import re
from collections.abc import Iterator, Mapping, Sequence

from urdfctl.catalog.distros import BYGONE, in_words
from urdfctl.diagnostic import Diagnostic
from urdfctl.lint.engine import lint
from urdfctl.lint.findings.weakening import is_weakened
from urdfctl.lint.selection import Selection
from urdfctl.lint.target import LintedTarget
from urdfctl.model.stage import CONTROLLER_STAGES, Stage
from urdfctl.names import enumerated
from urdfctl.rules.smoke.verdict_depends_on_distro import verdict_depends_on_distro
from urdfctl.smoke.lifecycle.controller_manager import ControllerLifecycle, RobotLifecycle, lifecycle_in
from urdfctl.smoke.results import ControllerResult, Trouble, Verdict, trouble_of

_ACTIVE = "becomes active"
_FAILURES = {
    Stage.LOAD: "cannot be loaded",
    Stage.CONFIGURE: "cannot be configured",
    Stage.ACTIVATE: "cannot be activated",
}


def lifecycle_of(seen: LintedTarget) -> RobotLifecycle:
    """Return the lifecycles of the controllers of a linted robot.

    If the distro is unknown, they are judged in each possible one. What differs is a warning that names all of them:
    no distro is chosen because it accepts most. The motion is that of the newest distro in which most of them start.
    """
    project = seen.project
    lifecycles = [lifecycle_in(project, distro, errors) for distro, errors in errors_by_distro(seen)]
    if len(lifecycles) == 1:
        return lifecycles[0]
    chosen = max(
        reversed(lifecycles), key=lambda lifecycle: sum(each.refusal is None for each in lifecycle.controllers)
    )
    fates = {each.name: _fates(lifecycles, each.name) for each in chosen.controllers}
    open_ = {name for name, fate in fates.items() if _ACTIVE in fate.values() and len(set(fate.values())) > 1}
    controllers = tuple(
        each._replace(by_distro=fates[each.name]) if each.name in open_ else each for each in chosen.controllers
    )
    rejected_by_all = all(lifecycle.rejected for lifecycle in lifecycles)
    troubles = [
        trouble
        for trouble in chosen.troubles
        if (trouble.controller not in open_ if trouble.controller else rejected_by_all)
    ]
    causes = {subject: error for lifecycle in lifecycles for subject, error in lifecycle.causes.items()}
    return chosen._replace(
        controllers=controllers, troubles=(*troubles, *_dependent(controllers, lifecycles)), causes=causes
    )


def errors_by_distro(seen: LintedTarget) -> Iterator[tuple[str, Sequence[Diagnostic]]]:
    """Yield each possible distro, with what lint finds in it. A bygone one is possible only if no other is."""
    project, known = seen.project, seen.result.outcome.diagnostics
    distros = tuple(distro for distro in project.distros if distro not in BYGONE) or project.distros
    if len(project.distros) == 1 or project.distro or not (project.controllers and project.controllers.controllers):
        yield project.distro or project.distros[-1], known
        return
    weakened = {(each.code, each.at) for each in known if is_weakened(each)}
    sources = list(seen.sources.values())
    for distro in distros:
        outcome = lint(project._replace(distro=distro, distros=(distro,)), sources, Selection())
        yield distro, [each for each in outcome.diagnostics if (each.code, each.at) not in weakened]


def _fates(lifecycles: Sequence[RobotLifecycle], name: str) -> dict[str, str]:
    """What happens to a controller in each distro, in words."""
    fates = {}
    for lifecycle in lifecycles:
        refusal = next((each.refusal for each in lifecycle.controllers if each.name == name), None)
        why = re.sub(rf"\bin {lifecycle.distro}\b", "there", refusal.why) if refusal else ""
        fates[lifecycle.distro] = f"{_FAILURES[refusal.stage]}: {why}" if refusal else _ACTIVE
    return fates


def fates_in_words(fates: Mapping[str, str]) -> str:
    """Return the fates of a controller by distro in words, the best one first; distros of the same fate are joined."""
    ordered = sorted(dict.fromkeys(fates.values()), key=lambda fate: fate != _ACTIVE)
    words = {fate: in_words(distro for distro in fates if fates[distro] == fate) for fate in ordered}
    parts = [(*fate.partition(": "), distros) for fate, distros in words.items()]
    return "; ".join(f"it {what} in {distros}{mark}{why}" for what, mark, why, distros in parts)


def _dependent(controllers: Sequence[ControllerLifecycle], lifecycles: Sequence[RobotLifecycle]) -> Iterator[Trouble]:
    """A finding for each fate that depends on the distro; controllers that share it are named in a note."""
    found: dict[str, list[str]] = {}
    for controller in controllers:
        if controller.by_distro:
            found.setdefault(fates_in_words(controller.by_distro), []).append(controller.name)
    for words, (first, *others) in found.items():
        causes = [t for lifecycle in lifecycles for t in lifecycle.troubles if t.controller in (first, None)]
        causes = sorted(causes, key=lambda trouble: trouble.controller is None)
        notes = [trouble.message for trouble in causes[:1] if trouble.message.partition(": ")[2] not in words]
        also = enumerated(f"'{name}'" for name in others)
        notes += [f"the same holds for {also}"] if also else []
        at = causes[0].subject if causes else f"controller:{first}"
        yield trouble_of(verdict_depends_on_distro, at, first, tuple(notes), verdicts=words)


def result_without_motion(controller: ControllerLifecycle) -> ControllerResult:
    """Return the result of a controller as long as nothing is simulated: warned if it depends on the distro."""
    if not controller.by_distro:
        return controller.result
    stages = [
        stage for words in controller.by_distro.values() for stage, what in _FAILURES.items() if words.startswith(what)
    ]
    stage = min(stages, key=CONTROLLER_STAGES.index, default=Stage.ACTIVATE)
    reason = f"depends on the ROS distro: {fates_in_words(controller.by_distro)}"
    return controller.result._replace(
        verdict=Verdict.WARNED, stage=stage, reason=reason, by_distro=controller.by_distro
    )
