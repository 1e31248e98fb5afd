"""Controllers that are configured for a robot, but most likely not started with it: their errors are warnings."""

from __future__ import annotations

from collections.abc import Iterable

from urdfctl.control.hardware import Kind
from urdfctl.model.project import Project
from urdfctl.rules.smoke.wheel_measures_differ import wheel_measures_differ
from urdfctl.smoke.manager import Cycle, Way
from urdfctl.smoke.results import ControllerResult, Trouble, Verdict

NOT_STARTED = "the launch file does not start this controller"
ANOTHER_FITS = "'{}' commands the same joints and fits the robot, and no launch file says which of them is started"


def spare_controllers(project: Project, cycle: Cycle, troubles: Iterable[Trouble]) -> dict[str, str]:
    """Return the controllers that are most likely not started, each with the reason.

    These are the ones that the launch file neither starts nor loads. Without a launch file, they are drives that have
    the measures of another robot, if another controller of the same joints has those of this one.
    """
    launch = project.launch
    if launch is not None:
        loaded = {name.rpartition("/")[2] for spawn in launch.spawns for name, _ in spawn.names}
        absent = (way.name for way in cycle.ways if way.name.rpartition("/")[2] not in loaded)
        return {} if project.started is None else dict.fromkeys(absent, NOT_STARTED)
    misfits = {trouble.controller for trouble in troubles if trouble.code == wheel_measures_differ.code}
    fitting = {_commanded(way): way.name for way in cycle.ways if way.name not in misfits}
    others = ((way.name, fitting.get(_commanded(way))) for way in cycle.ways if way.name in misfits)
    return {name: ANOTHER_FITS.format(other) for name, other in others if other}


def lenient(result: ControllerResult) -> ControllerResult:
    """Return the result of a controller that is not started: warned where it would fail."""
    if result.verdict is not Verdict.FAILED:
        return result
    return result._replace(verdict=Verdict.WARNED, reason=f"most likely not started; it would fail: {result.reason}")


def _commanded(way: Way) -> frozenset[str]:
    return frozenset(claim.name for claim in way.configured.claimed(Kind.COMMAND))
