"""The smoke test of many robots: each is read and judged in one limited worker, and moved in another, fresh one."""

from __future__ import annotations

import os
import tempfile
from collections.abc import Callable, Iterable, Iterator, Mapping, Sequence
from functools import partial

from urdfctl.diagnostic import Diagnostic
from urdfctl.hints import Any
from urdfctl.jobs import dead, shared_loader, target_of
from urdfctl.lint import Selection
from urdfctl.load import Loader, Target
from urdfctl.record import NamedTuple
from urdfctl.serialise import diagnostic_from_json, diagnostic_to_json, linted_from_json, linted_to_json
from urdfctl.settings import Settings
from urdfctl.smoke.anchors import diagnostics_of
from urdfctl.smoke.judgement import changed, judged
from urdfctl.smoke.picture import picture_of
from urdfctl.smoke.planning import plan_of
from urdfctl.smoke.results import ControllerResult, Smoked, Step, Trouble, Verdict
from urdfctl.smoke.trial import MOTION, Plan, Tried, tried
from urdfctl.worker import Died, Limits, processors, run

SECONDS, SECONDS_FOR_JOINT = 30.0, 0.1
"""How long an engine may take: half a minute, and a second for every ten joints."""
_WATCHED = 600.0
"""How long, in s, somebody may watch."""
_SCREEN = ("DISPLAY", "XAUTHORITY", "WAYLAND_DISPLAY")
_MOST_SAID = 300
_LIGHT = "UC918"
_OF_LIGHT = ("UC930", "UC932", "UC933", "UC934", "UC936", "UC937")
"""What an engine, which knows no rotors, makes of a joint that is too light for its gains."""


class Wanted(NamedTuple):
    """What is asked of a smoke test: only the controllers of some names (all where there are none); the engines that
    move the robots, none for the structural part alone (several: each of them); those to be tried where one dies of a
    robot or does not take it; for how long each controller moves, in s; a window to watch; the robot's picture."""

    only: tuple[str, ...] = ()
    engines: tuple[str, ...] = ()
    instead: tuple[str, ...] = ()
    duration: float = MOTION
    gui: bool = False
    picture: bool = False


class Read(NamedTuple):
    """A robot as its first worker gives it back; `plan` is None where nothing is to be moved. What an engine finds is
    told at the `anchors`, but for what comments have `silent`."""

    smoked: Smoked
    plan: Plan | None
    anchors: Mapping[str, Diagnostic] = {}
    told: tuple[Trouble, ...] = ()
    silent: Mapping[str, Sequence[str]] = {}

    @classmethod
    def from_json(cls, data: dict[str, Any]) -> Read:
        """From plain data."""
        results = tuple(ControllerResult.from_json(one) for one in data["controllers"])
        return cls(
            Smoked(linted_from_json(data["linted"]), results, picture=tuple(map(tuple, data["picture"]))),
            Plan.from_json(data["plan"]) if data["plan"] else None,
            {name: diagnostic_from_json(one) for name, one in data["anchors"].items()},
            tuple(Trouble.from_json(one) for one in data["told"]),
            data["silent"],
        )

    def to_json(self) -> dict[str, Any]:
        """As plain data."""
        return {
            "linted": linted_to_json(self.smoked.linted),
            "controllers": [one.to_json() for one in self.smoked.controllers],
            "picture": self.smoked.picture,
            "plan": self.plan.to_json() if self.plan else None,
            "anchors": {name: diagnostic_to_json(one) for name, one in self.anchors.items()},
            "told": self.told,
            "silent": dict(self.silent),
        }


def smoke_all(
    targets: Sequence[Target],
    settings: Settings,
    wanted: Wanted,
    parallel: int | None = None,
    chosen: Callable[[list[Smoked]], Iterable[int]] | None = None,
) -> Iterator[Smoked]:
    """The smoke test of each target, in their order; of those only that are chosen once they are judged, by index."""
    parallel = parallel or processors()
    read = list(_read_all(targets, settings, wanted, parallel))
    indices = list(range(len(read)) if chosen is None else chosen([one.smoked for one in read]))
    kept = [read[index] for index in indices]
    runs = [(n, engine) for n, one in enumerate(kept) if one.plan for engine in wanted.engines]
    plans = [plan._replace(engine=engine) for n, engine in runs if (plan := kept[n].plan)]
    found = iter(zip(runs, _try_all(plans, settings, parallel, wanted.instead), strict=True))
    pending = next(found, None)
    for n, one in enumerate(kept):
        smoked = one.smoked
        while pending and pending[0][0] == n:
            smoked = moved(smoked, one, *pending[1])
            pending = next(found, None)
        yield smoked


# -- the first worker: read and judged -------------------------------------------------------------------------------


def _read_all(targets: Sequence[Target], settings: Settings, wanted: Wanted, parallel: int) -> Iterator[Read]:
    loader = shared_loader(targets, settings, Selection())
    jobs = [
        {"target": target._asdict(), "settings": settings.to_json(), "wanted": wanted._asdict()} for target in targets
    ]
    limits = Limits(settings.timeout, settings.memory, settings.environ)
    results = run(jobs, partial(_perform_with, loader), limits, parallel, fresh="urdfctl.smoke.job:perform")
    for target, result in zip(targets, results, strict=True):
        yield Read.from_json(result) if isinstance(result, dict) else Read(Smoked(dead(target, settings, result)), None)


def perform(job: dict[str, Any]) -> dict[str, Any]:
    """The structural part of the smoke test of a job that came as JSON, with the plan for the engine."""
    return _perform_with(Loader(Settings.from_json(job["settings"]), Selection()), job)


def _perform_with(loader: Loader, job: dict[str, Any]) -> dict[str, Any]:
    return read_of(loader, target_of(job), Wanted(**job["wanted"])).to_json()


def read_of(loader: Loader, target: Target, wanted: Wanted) -> Read:
    """A robot read and judged, with the plan for an engine where one is wanted."""
    judgement = judged(loader.seen(target), wanted.only)
    plan = None
    if wanted.engines:
        packages = loader.reading(judgement.seen.linted.path)[1]
        plan, troubles = plan_of(judgement, packages, wanted.duration, gui=wanted.gui)
        judgement = judgement._replace(troubles=(*judgement.troubles, *troubles))
    smoked = judgement.smoked
    robot, mechanism = judgement.seen.project.robot, judgement.mechanism
    if wanted.picture and robot and mechanism:
        smoked = smoked._replace(picture=picture_of(robot, mechanism))
    if plan is None:
        return Read(smoked, None)
    return Read(smoked, plan, judgement.anchors(), judgement.troubles, judgement.silenced())


# -- the second worker: moved ----------------------------------------------------------------------------------------


def _try_all(
    plans: Sequence[Plan], settings: Settings, parallel: int, instead: Sequence[str] = ()
) -> Iterator[tuple[str, Tried | Died]]:
    """What came of each plan, and in which engine. One whose engine dies is tried once more, without meshes; then, as
    one that is refused, in other engines."""
    with tempfile.TemporaryDirectory(prefix="urdfctl-") as folder:
        first = _run(plans, settings, parallel, folder)
        for plan, result in zip(plans, first, strict=True):
            engine, latest = plan.engine, result
            tries = [without_meshes(plan)] if isinstance(result, Died) and "<mesh" in plan.urdf else []
            tries += [plan._replace(engine=name) for name in instead if name != plan.engine]
            for other in tries:
                if isinstance(latest, Tried) and not latest.refused:
                    break
                engine, latest = other.engine, next(_run([other], settings, 1, folder))
            good = isinstance(latest, Tried) and not latest.refused
            yield (engine, latest) if good else (plan.engine, result)


def _run(plans: Sequence[Plan], settings: Settings, parallel: int, folder: str) -> Iterator[Tried | Died]:
    """Each result; of a death with the end of what the engine printed."""
    jobs = [{"plan": plan.to_json(), "said": os.path.join(folder, f"said-{n}")} for n, plan in enumerate(plans)]
    joints = max((len(plan.mechanism.hinges) for plan in plans), default=0)
    watched = any(plan.gui for plan in plans)
    screen = {name: os.environ[name] for name in _SCREEN if watched and name in os.environ}
    seconds = _WATCHED if watched else SECONDS + joints * SECONDS_FOR_JOINT
    limits = Limits(seconds, settings.memory, {**settings.environ, **screen})
    results = run(jobs, perform_trial, limits, parallel, fresh="urdfctl.smoke.job:perform_trial")
    for job, result in zip(jobs, results, strict=True):
        if isinstance(result, Died):
            said = _said(str(job["said"]))
            yield result._replace(why=f"{result.why}{f'; it said: {said}' if said else ''}")
        else:
            yield Tried.from_json(result)


def perform_trial(job: dict[str, Any]) -> dict[str, Any]:
    """The trial of a job that came as JSON; what the engine prints, in C, goes to a file, and others that it writes
    beside that one."""
    with open(job["said"], "wb") as file:
        os.dup2(file.fileno(), 1)
        os.dup2(file.fileno(), 2)
    os.chdir(os.path.dirname(job["said"]))
    return tried(Plan.from_json(job["plan"]))._asdict()


def _said(path: str) -> str:
    try:
        with open(path, encoding="utf-8", errors="replace") as file:
            lines = [line for line in file.read()[-_MOST_SAID * 4 :].splitlines() if "build time" not in line]
    except OSError:
        return ""
    return " ".join(" ".join(lines).split())[-_MOST_SAID:]


def without_meshes(plan: Plan) -> Plan:
    """A plan whose robot collides with nothing that is a mesh."""
    lines = [line for line in plan.urdf.splitlines() if "<mesh" not in line]
    return plan._replace(urdf="\n".join(lines), shapeless=True)


# -- both together ---------------------------------------------------------------------------------------------------


def moved(smoked: Smoked, read: Read, engine: str, result: Tried | Died) -> Smoked:
    """A smoke test with what an engine made of the robot."""
    if isinstance(result, Died):
        troubles: list[Trouble] = [Trouble("UC920", "robot", f"{engine} died of the robot: {result.why}")]
        result = Tried(unjudged={one.name: f"structural only: {engine} died" for one in smoked.controllers})
    elif result.refused:
        troubles = [Trouble("UC921", "robot", f"{engine} does not take the robot: {result.refused}")]
        result = Tried(
            unjudged={one.name: f"structural only: {engine} refuses the robot" for one in smoked.controllers}
        )
    else:
        calm = {one.controller for one in read.told if one.code == _LIGHT}
        troubles = [one for one in result.troubles if one.controller not in calm or one.code not in _OF_LIGHT]
    found = smoked.linted.outcome.diagnostics
    told = {one.message for one in found}
    new = [one for one in diagnostics_of(troubles, read.anchors, read.silent) if one.message not in told]
    outcome = smoked.linted.outcome._replace(diagnostics=[*found, *new])
    results = tuple(_judged(one, result, troubles) for one in smoked.controllers)
    name = f"{smoked.engine} and {engine}" if smoked.engine else engine
    seconds = smoked.seconds + result.seconds
    linted = smoked.linted._replace(outcome=outcome)
    return smoked._replace(
        linted=linted, controllers=results, engine=name, seconds=seconds, curves=smoked.curves or result.curves
    )


def _judged(one: ControllerResult, result: Tried, troubles: Sequence[Trouble]) -> ControllerResult:
    """A verdict after moving: only what moved, or commands nothing, has passed."""
    if one.verdict is Verdict.SKIPPED:
        if one.name in result.moved:
            one = one._replace(verdict=Verdict.PASSED, stage=Step.DEACTIVATE, reason="")
        else:
            one = one._replace(reason=result.unjudged.get(one.name, one.reason))
    return changed(one, troubles)
