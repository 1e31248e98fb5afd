"""The smoke test of many robots: each is prepared in one limited worker, and simulated in another, fresh one."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Iterator, Mapping, Sequence
from itertools import groupby
from operator import itemgetter

from urdfctl.config.settings import Settings
from urdfctl.diagnostic import Diagnostic
from urdfctl.errors import UserError
from urdfctl.lint.job import Work, Workers, failed, run_on_targets, shared_loader
from urdfctl.lint.selection import Selection
from urdfctl.lint.serialising import diagnostic_from_json, diagnostic_to_json, result_from_json, result_to_json
from urdfctl.lint.target import lint_target
from urdfctl.load.loader import Loader
from urdfctl.load.meshes import mesh_path
from urdfctl.load.target import Target
from urdfctl.model.stage import Stage
from urdfctl.report.common import shown
from urdfctl.rules import rule_of
from urdfctl.rules.smoke.engine_died import engine_died
from urdfctl.rules.smoke.engine_refuses_robot import engine_refuses_robot
from urdfctl.run.limits import WorkerFailure, processors
from urdfctl.smoke.agreement import compared
from urdfctl.smoke.anchors import diagnostics_of
from urdfctl.smoke.assignments import TaskFile
from urdfctl.smoke.fitting import Misfit, misfits
from urdfctl.smoke.judgement import changed, judged
from urdfctl.smoke.pairing import has_joints_of_controllers, only_ones, pairs_to_try
from urdfctl.smoke.plan import MOTION, Plan, Tried
from urdfctl.smoke.planning import plan_of
from urdfctl.smoke.results import ROBOT, ControllerResult, Smoked, Trouble, Verdict, trouble_of
from urdfctl.smoke.runs import Runs
from urdfctl.smoke.spare import lenient
from urdfctl.startup.hints import Any
from urdfctl.startup.records import NamedTuple


class Wanted(NamedTuple):
    """The options of a smoke test.

    `only` holds the names of the controllers to test, none for all. Each of the `engines` simulates the robots; without
    any, nothing moves. The engines of `instead` are tried if an engine crashes or rejects a robot. `duration` is the
    time for which each controller moves, in s. `gui` shows a window. `live`
    prints a line for each controller as soon as it was tested. `tasks` holds the user's own tasks as plain data (see
    `TaskFile`), or None.
    """

    only: tuple[str, ...] = ()
    engines: tuple[str, ...] = ()
    instead: tuple[str, ...] = ()
    duration: float = MOTION
    gui: bool = False
    live: bool = False
    tasks: Any = None


class PreparedRobot(NamedTuple):
    """A robot as its first worker returns it.

    `plan` is None if nothing should move. The findings of an engine are placed at the `anchors`, except those whose
    codes are `silent` for a subject. `troubles` holds the findings so far, and `misfits` the tasks that do not fit it.
    `fits`: the robot has all joints that its controllers claim.
    `spare` names the controllers that are most likely not started, with the reason.
    """

    smoked: Smoked
    plan: Plan | None
    anchors: Mapping[str, Diagnostic] = {}
    troubles: tuple[Trouble, ...] = ()
    silent: Mapping[str, Sequence[str]] = {}
    misfits: tuple[Misfit, ...] = ()
    fits: bool = False
    spare: Mapping[str, str] = {}

    @classmethod
    def from_json(cls, data: dict[str, Any]) -> PreparedRobot:
        """Return the robot that plain data holds."""
        results = tuple(ControllerResult.from_json(result) for result in data["controllers"])
        linted = result_from_json(data["linted"])
        return cls(
            smoked=Smoked(linted, results, data["distro"], part_of=data["part_of"]),
            plan=Plan.from_json(data["plan"]) if data["plan"] else None,
            anchors={subject: diagnostic_from_json(anchor) for subject, anchor in data["anchors"].items()},
            troubles=tuple(Trouble.from_json(fields) for fields in data["troubles"]),
            silent=data["silent"],
            misfits=tuple(Misfit(*misfit) for misfit in data["misfits"]),
            fits=data["fits"],
            spare=data["spare"],
        )

    def to_json(self) -> dict[str, Any]:
        """Return the robot as plain data."""
        return {
            "linted": result_to_json(self.smoked.linted),
            "controllers": [result.to_json() for result in self.smoked.controllers],
            "distro": self.smoked.distro,
            "part_of": self.smoked.part_of,
            "plan": self.plan.to_json() if self.plan else None,
            "anchors": {subject: diagnostic_to_json(anchor) for subject, anchor in self.anchors.items()},
            "troubles": self.troubles,
            "silent": dict(self.silent),
            "misfits": self.misfits,
            "fits": self.fits,
            "spare": self.spare,
        }


def smoke_all(
    targets: Sequence[Target],
    settings: Sequence[Settings],
    wanted: Wanted,
    parallel: int | None = None,
    chosen: Callable[[list[Smoked]], Iterable[int]] | None = None,
) -> Iterator[Smoked]:
    """Yield the smoke test of each target, which is read with its own settings, in order.

    `chosen` is given all robots before any moves, and returns the indices of those to go on with.
    """
    parallel = parallel or processors()
    robots = _paired(list(_read_all(targets, settings, wanted, parallel)), targets, settings, wanted, parallel)
    _check_tasks(robots, wanted)
    indices = list(range(len(robots)) if chosen is None else chosen([robot.smoked for robot in robots]))
    kept = [robots[index] for index in indices]
    runs = [(n, engine) for n, robot in enumerate(kept) if robot.plan for engine in wanted.engines]
    limits = settings[0] if settings else Settings()  # the options of the run, which are the same for all
    plans = [plan.within(limits.timeout)._replace(engine=engine) for n, engine in runs if (plan := kept[n].plan)]
    simulations = Runs(limits, parallel, wanted.instead, live=wanted.live)
    results = iter(zip(runs, simulations.results(plans), strict=True))
    pending = next(results, None)
    for n, robot in enumerate(kept):
        smoked, of_robot = robot.smoked, []
        while pending and pending[0][0] == n:
            of_robot.append(pending[1])
            pending = next(results, None)
        for engine, result in _compared(of_robot):
            smoked = moved(smoked, robot, engine, result)
        yield smoked._replace(interrupted=simulations.interrupted)


def _paired(
    robots: list[PreparedRobot], targets: Sequence[Target], settings: Sequence[Settings], wanted: Wanted, parallel: int
) -> list[PreparedRobot]:
    """The robots, in which a launch file that spawns controllers without a robot has the only one that fits it."""
    pairs = pairs_to_try(targets, [robot.smoked for robot in robots])
    own = [settings[pair.position] for pair in pairs]
    tried = list(_read_all([pair.target for pair in pairs], own, wanted, parallel)) if pairs else []
    for index, position in only_ones(pairs, [robot.fits for robot in tried]).items():
        robots[index] = tried[position]._replace(smoked=tried[position].smoked._replace(paired=True))
    return robots


def _compared(results: list[tuple[str, Tried | WorkerFailure]]) -> Sequence[tuple[str, Tried | WorkerFailure]]:
    good = [(engine, result) for engine, result in results if isinstance(result, Tried) and not result.refused]
    return compared(good) if len(good) == len(results) > 1 else results


def _check_tasks(robots: Sequence[PreparedRobot], wanted: Wanted) -> None:
    """Reject tasks that do not fit a robot, or that name what no robot has. UserError with file and line."""
    if not wanted.tasks:
        return
    file = TaskFile.from_json(wanted.tasks)
    found = [misfit for robot in robots for misfit in robot.misfits]
    tasked = sum(robot.plan is not None for robot in robots)
    for misfit in sorted(found):
        if not misfit.absent or found.count(misfit) >= tasked:
            raise UserError(f"{shown(file.path)}:{misfit.line}: {misfit.message}")


# -- the first worker: prepare a robot -------------------------------------------------------------------------------


def _read_all(
    targets: Sequence[Target], settings: Sequence[Settings], wanted: Wanted, parallel: int
) -> Iterator[PreparedRobot]:
    for of_group, pairs in groupby(zip(settings, targets, strict=True), key=itemgetter(0)):
        yield from _read([target for _, target in pairs], of_group, wanted, parallel)


def _read(targets: Sequence[Target], settings: Settings, wanted: Wanted, parallel: int) -> Iterator[PreparedRobot]:
    results = run_on_targets(
        prepare_work,
        targets,
        settings,
        details=[wanted._asdict()] * len(targets),
        workers=Workers(shared_loader(targets, settings), parallel),
    )
    for target, result in zip(targets, results, strict=True):
        if isinstance(result, dict):
            yield PreparedRobot.from_json(result)
        else:
            yield PreparedRobot(Smoked(failed(target, settings, result)), None)


def prepare_work(work: Work) -> dict[str, Any]:
    """Return the prepared robot of a job, in a worker."""
    return prepared_robot(work.loader, work.target, Wanted(**work.details)).to_json()


def prepared_robot(loader: Loader, target: Target, wanted: Wanted) -> PreparedRobot:
    """Return a target as a prepared robot, with the plan for an engine if one is wanted."""
    seen = lint_target(loader, target, Selection())
    packages = loader.reading(seen.result.path)[1]
    given = TaskFile.from_json(wanted.tasks) if wanted.tasks else None
    judgement = judged(seen, wanted.only, lambda address: mesh_path(address, packages, seen.result.path), given)
    plan = None
    if wanted.engines:
        plan, troubles = plan_of(judgement, packages, wanted.duration, gui=wanted.gui)
        judgement = judgement._replace(troubles=(*judgement.troubles, *troubles))
    smoked = judgement.smoked
    mechanism = judgement.mechanism
    names = [way.name for way in judgement.cycle.ways]
    wrong = tuple(misfits(given, mechanism, judgement.tasks, names)) if given and mechanism else ()
    fits = has_joints_of_controllers(seen.project)
    if plan is None:
        return PreparedRobot(smoked, None, misfits=wrong, fits=fits)
    return PreparedRobot(
        smoked=smoked,
        plan=plan,
        anchors=judgement.anchors(),
        troubles=judgement.troubles,
        silent=judgement.silenced(),
        misfits=wrong,
        fits=fits,
        spare=judgement.spare,
    )


# -- both together ---------------------------------------------------------------------------------------------------


def moved(smoked: Smoked, robot: PreparedRobot, engine: str, result: Tried | WorkerFailure) -> Smoked:
    """Return a smoke test with the result of an engine."""
    if isinstance(result, WorkerFailure):
        troubles = [trouble_of(engine_died, ROBOT, engine=engine, why=result.reason)]
        result = _not_simulated(smoked, f"{engine} crashed")
    elif result.refused:
        troubles = [trouble_of(engine_refuses_robot, ROBOT, engine=engine, why=result.refused)]
        result = _not_simulated(smoked, f"{engine} rejects the robot")
    else:
        troubles = _unexplained(result.troubles, robot.troubles)
    diagnostics = smoked.linted.outcome.diagnostics
    messages = {diagnostic.message for diagnostic in diagnostics}
    found = diagnostics_of(troubles, robot.anchors, robot.silent, robot.spare)
    new = [diagnostic for diagnostic in found if diagnostic.message not in messages]
    outcome = smoked.linted.outcome._replace(diagnostics=[*diagnostics, *new])
    after = (_judged(controller, result, troubles) for controller in smoked.controllers)
    controllers = tuple(lenient(each) if each.name in robot.spare else each for each in after)
    name = f"{smoked.engine} and {engine}" if smoked.engine else engine
    seconds = smoked.seconds + result.seconds
    linted = smoked.linted._replace(outcome=outcome)
    return smoked._replace(
        linted=linted, controllers=controllers, engine=name, seconds=seconds, curves=smoked.curves or result.curves
    )


def _not_simulated(smoked: Smoked, why: str) -> Tried:
    return Tried(unjudged={controller.name: f"not simulated: {why}" for controller in smoked.controllers})


def _unexplained(troubles: Sequence[Trouble], known: Sequence[Trouble]) -> list[Trouble]:
    """The findings of an engine without those that known findings about the same controller explain."""
    explained = {(trouble.controller, rule.code) for trouble in known for rule in rule_of(trouble.code).explains}
    same = {(trouble.subject, trouble.code) for trouble in known}
    return [
        trouble
        for trouble in troubles
        if (trouble.controller, trouble.code) not in explained and (trouble.subject, trouble.code) not in same
    ]


def _judged(controller: ControllerResult, result: Tried, troubles: Sequence[Trouble]) -> ControllerResult:
    """The result after simulating: a controller passes only if it moved its joints, or commands nothing."""
    acts = tuple(dict.fromkeys((*controller.tested, *result.tested.get(controller.name, ()))))
    untested = {**controller.untested, **result.untested.get(controller.name, {})}
    seconds = controller.seconds + result.times.get(controller.name, 0.0)
    controller = controller._replace(tested=acts, untested=untested, seconds=seconds)
    if controller.verdict is Verdict.SKIPPED:
        if controller.name in result.moved:
            controller = controller._replace(verdict=Verdict.PASSED, stage=Stage.DEACTIVATE, reason="")
        else:
            controller = controller._replace(reason=result.unjudged.get(controller.name, controller.reason))
    elif controller.verdict is Verdict.WARNED and controller.name in result.moved and not controller.by_distro:
        controller = controller._replace(stage=Stage.DEACTIVATE)
    return changed(controller, troubles)
