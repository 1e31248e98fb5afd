"""The simulations of a run: each in a worker of its own, in one engine after the other until one can be believed."""

from __future__ import annotations

import os
from collections.abc import Iterator, Sequence
from typing import Any

from urdfctl.config.settings import Settings
from urdfctl.run.limits import WAITING, Limits, Result, WorkerFailure
from urdfctl.run.pool import Meanwhile, run_jobs
from urdfctl.smoke.motion.engine_agreement import decided, is_certain
from urdfctl.smoke.motion.plan import MotionPlan, SimulationResult
from urdfctl.smoke.motion.progress import keep, kept, live_lines, stopped_early
from urdfctl.smoke.motion.trial import run_trial

STARTING = 60.0
"""What the start of an engine may take on a loaded machine, in s."""
_WATCHED = 600.0
"""The time limit if a window is shown, in s."""
_SCREEN = ("DISPLAY", "XAUTHORITY", "WAYLAND_DISPLAY")
_MOST_OUTPUT = 300
"""At most this many characters of an engine's output are shown."""
INTERRUPTED = "interrupted"


class EngineWorkers:
    """The simulations of a run.

    parallel: how many run at the same time.
    instead: the engines that are tried if an engine crashes or rejects a robot.
    live: whether a line is printed on standard error for each controller.

    `interrupted` is True after Ctrl-C: then nothing more is simulated, and what was tested so far is kept.
    """

    def __init__(self, settings: Settings, parallel: int, instead: Sequence[str] = (), *, live: bool = False) -> None:
        self._settings, self._parallel, self._instead, self._live = settings, parallel, instead, live
        self.interrupted = False

    def results(self, plans: Sequence[MotionPlan]) -> Iterator[tuple[str, SimulationResult | WorkerFailure]]:
        """Yield the engine and the result of each plan.

        If an engine crashes, the plan is tried once more without meshes; then, as if it is rejected, in other engines.
        Before a robot fails, and where a base drives, the first of these engines is asked too.
        """
        if not plans:
            return
        from urdfctl.output.scratch import scratch_folder

        with scratch_folder() as folder:
            first = self.run_plan(plans, self._parallel, folder)
            for plan, result in zip(plans, first, strict=True):
                yield self._settled(plan, result, folder)

    def _settled(
        self, plan: MotionPlan, first: SimulationResult | WorkerFailure, folder: str
    ) -> tuple[str, SimulationResult | WorkerFailure]:
        engine, latest = plan.engine, first
        tries = [without_meshes(plan)] if isinstance(first, WorkerFailure) and "<mesh" in plan.urdf else []
        tries += [plan._replace(engine=name) for name in self._instead if name != plan.engine]
        for other in tries:
            if isinstance(latest, SimulationResult) and not latest.refused:
                break
            engine, latest = other.engine, next(self.run_plan([other], 1, folder))
        if not isinstance(latest, SimulationResult) or latest.refused:
            return plan.engine, first
        if engine != plan.engine or is_certain(plan, latest) or not self._instead or self.interrupted:
            return engine, latest
        return self._asked_again(plan, latest, self._instead[0], folder)

    def _asked_again(
        self, plan: MotionPlan, first: SimulationResult, name: str, folder: str
    ) -> tuple[str, SimulationResult]:
        """The result of two engines, the second of which decides; that of the first one if the second one fails."""
        second = next(self.run_plan([plan._replace(engine=name)], 1, folder))
        if not isinstance(second, SimulationResult) or second.refused or self.interrupted:
            return plan.engine, first
        return f"{plan.engine} and {name}", decided(first, second, (plan.engine, name))

    def run_plan(
        self, plans: Sequence[MotionPlan], parallel: int, folder: str
    ) -> Iterator[SimulationResult | WorkerFailure]:
        """Yield each result; after a crash with the end of the engine's output."""
        paths = [os.path.join(folder, f"output-{n}-{plan.engine}") for n, plan in enumerate(plans)]
        jobs = [
            {"plan": plan.to_json(), "output": path, "live": self._live}
            for plan, path in zip(plans, paths, strict=True)
        ]
        results = run_jobs(
            jobs,
            run_trial_job,
            self.limits_for(plans),
            parallel,
            function_name="urdfctl.smoke.motion.engine_workers:run_trial_job",
            meanwhile=Meanwhile(doing="" if self._live else "moving the robot"),
        )
        for plan, path, result in zip(plans, paths, self._until_interrupted(results, len(jobs)), strict=True):
            if isinstance(result, dict):
                yield SimulationResult.from_json(result)
            elif result.our_fault:
                output = engine_output(path)
                yield result._replace(reason=f"{result.reason}{f'; its output ends with: {output}' if output else ''}")
            else:
                yield stopped_early(plan, kept(_known(path)), result.reason)

    def limits_for(self, plans: Sequence[MotionPlan]) -> Limits:
        """Return what a worker may use for some plans."""
        watched = any(plan.gui for plan in plans)
        screen = {name: os.environ[name] for name in _SCREEN if watched and name in os.environ}
        budget = max((plan.budget for plan in plans), default=0.0)
        seconds = _WATCHED if watched else budget * WAITING + STARTING
        return Limits(seconds, self._settings.memory, {**self._settings.environ, **screen}, waiting=1.0)

    def _until_interrupted(self, results: Iterator[Result], count: int) -> Iterator[Result]:
        """The results, and after Ctrl-C a failure for each that is missing."""
        given = 0
        try:
            for result in results if not self.interrupted else ():
                given += 1
                yield result
        except KeyboardInterrupt:
            self.interrupted = True
        yield from [WorkerFailure(INTERRUPTED)] * (count - given)


def run_trial_job(job: dict[str, Any]) -> dict[str, Any]:
    """Return the result of simulating a job that came as JSON.

    What the engine prints from C goes to a file; files that it writes go to the same folder. What is known after each
    group of controllers goes to a file too, and to the terminal if it should be live.
    """
    terminal = os.dup(2) if job["live"] else None
    with open(job["output"], "wb") as file:
        os.dup2(file.fileno(), 1)
        os.dup2(file.fileno(), 2)
    os.chdir(os.path.dirname(job["output"]))
    plan = MotionPlan.from_json(job["plan"])
    told: set[str] = set()

    def seen(known: SimulationResult) -> None:
        keep(known, _known(job["output"]))
        if terminal is not None:
            for line in live_lines(known, plan, told):
                os.write(terminal, f"{line}\n".encode())

    return run_trial(plan, seen)._asdict()


def _known(output: str) -> str:
    """The file that holds what is known before a simulation ends, beside that of its output."""
    return f"{output}.json"


def engine_output(path: str) -> str:
    """Return the end of what an engine printed into a file; empty if there is none."""
    try:
        with open(path, encoding="utf-8", errors="replace") as file:
            lines = [line for line in file.read()[-_MOST_OUTPUT * 4 :].splitlines() if "build time" not in line]
    except OSError:
        return ""
    return " ".join(" ".join(lines).split())[-_MOST_OUTPUT:]


def without_meshes(plan: MotionPlan) -> MotionPlan:
    """Return a plan without collision meshes."""
    lines = [line for line in plan.urdf.splitlines() if "<mesh" not in line]
    return plan._replace(urdf="\n".join(lines), shapeless=True)
