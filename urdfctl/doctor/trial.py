"""The verdict of the real controller manager with mock hardware on a robot's controllers, beside the simulated one."""

from __future__ import annotations

import json
from collections.abc import Callable, Mapping
from typing import Any

from urdfctl.catalog.distros import generation
from urdfctl.config.settings import Settings
from urdfctl.doctor.expectation import Expectation, ExpectedController, expectation_of
from urdfctl.doctor.log import Log, log_of
from urdfctl.errors import UserError
from urdfctl.expand.xml_writer import write
from urdfctl.lint.job import Work, run_on_targets
from urdfctl.load.target import Target
from urdfctl.smoke.results import ControllerResult, RobotResult, Verdict
from urdfctl.source.xml.dom import Document, Element, XmlText
from urdfctl.startup.records import NamedTuple

_MOCK = "mock_components/GenericSystem"
_STAGES = ("", "load", "configure", "activate")
_MOST_OF_A_LOG = 4 << 20

Run = Callable[[dict[str, Any]], dict[str, Any]]
"""Starts a plan with the real manager, and returns its result."""


class RealVerdict(NamedTuple):
    """How far a controller came.

    passed: the last stage that it passed; empty if it was not loaded.
    wanted: the last stage that the files want.
    reason: what the manager printed about it. fix: what `explain` advises.
    simulated: the stage at which the simulated manager refuses it; empty if it does not.
    """

    controller: str
    passed: str
    wanted: str
    reason: str
    fix: str
    simulated: str

    @property
    def is_refused(self) -> bool:
        """Whether the real manager refuses it."""
        return self.passed != self.wanted

    @property
    def refused_at(self) -> str:
        """The stage at which the real manager refuses it."""
        return _STAGES[_STAGES.index(self.passed) + 1] if self.is_refused else ""

    @property
    def differs(self) -> bool:
        """Whether only one of the managers refuses it."""
        return self.is_refused != bool(self.simulated)


class RealResult(NamedTuple):
    """The result of a robot. reason: why the manager did not answer; empty if it did."""

    path: str
    manager: str
    verdicts: tuple[RealVerdict, ...]
    reason: str = ""
    fix: str = ""

    @property
    def is_refused(self) -> bool:
        """Whether anything does not start."""
        return bool(self.reason) or any(verdict.is_refused for verdict in self.verdicts)


def real_results(target: Target, settings: Settings, simulated: RobotResult, run: Run) -> list[RealResult]:
    """Return what the real managers of a robot say. Raises UserError if it cannot be loaded."""
    if simulated.distro is not None and generation(simulated.distro) == 1:
        raise UserError(f"--engine ros2 tests robots of ROS 2; '{target.path}' is one of {simulated.distro}")
    [answer] = run_on_targets(_plan_work, [target], settings, details=[{"roots": []}])
    if not isinstance(answer, dict):
        raise UserError(f"'{target.path}' cannot be read: {answer.reason}")
    if answer["expected"] is None:
        raise UserError(f"'{target.path}' cannot be expanded; to see why, run: urdfctl lint {target.path}")
    expected = Expectation.from_json(answer["expected"])
    found = []
    for manager in expected.managers:
        controllers = _in_order(expected, manager)
        plan = {
            "manager": manager,
            "description": answer["description"],
            "files": answer["files"],
            "controllers": [{"name": one.name, "activate": one.state != "inactive"} for one in controllers],
        }
        found.append(_judged(target.path, manager, controllers, simulated, run(plan)))
    return found


def _in_order(expected: Expectation, manager: str) -> list[ExpectedController]:
    """The controllers that are started, or all if nothing starts any, those that are commanded by others first."""
    own = [one for one in expected.controllers if one.manager == manager]
    started = [one for one in own if one.state] or own
    names = {one.name for one in started}
    return sorted(started, key=lambda one: any(name in json.dumps(dict(one.parameters)) for name in names - {one.name}))


def _judged(
    path: str,
    manager: str,
    controllers: list[ExpectedController],
    simulated: RobotResult,
    result: Mapping[str, Any],
) -> RealResult:
    log = log_of(str(result.get("log", ""))[-_MOST_OF_A_LOG:].splitlines(), simulated.distro)
    if not result.get("answers"):
        first = log.failures[0] if log.failures else None
        reason = first.text if first else "it offers no services"
        return RealResult(path, manager, (), reason, first.reading.best_fix if first else "")
    refused = {one.name: _refused_at(one) for one in simulated.controllers}
    stages = result.get("stages", {})
    verdicts = [_verdict(one, str(stages.get(one.name, "")), log, refused.get(one.name, "")) for one in controllers]
    return RealResult(path, manager, tuple(verdicts))


def _refused_at(one: ControllerResult) -> str:
    is_refused = one.verdict is Verdict.FAILED and one.stage.value in _STAGES
    return one.stage.value if is_refused else ""


def _verdict(one: ExpectedController, passed: str, log: Log, simulated: str) -> RealVerdict:
    wanted = "configure" if one.state == "inactive" else "activate"
    reason = log.of(one.name) if passed != wanted else None
    return RealVerdict(
        controller=one.name,
        passed=passed,
        wanted=wanted,
        reason=reason.text if reason else "",
        fix=reason.fix if reason else "",
        simulated=simulated,
    )


def _plan_work(work: Work) -> dict[str, Any]:
    """What is started of a target, in a worker: its description with mock hardware, and its controller files."""
    loaded = work.loader.load(work.target)
    expected = expectation_of(loaded, work.loader, work.target, work.details["roots"])
    controllers = loaded.project.controllers
    files = [one.at.source for one in controllers.files if not one.is_moveit] if controllers else []
    return {
        "expected": expected and expected.to_json(),
        "description": with_mock_hardware(loaded.root) if loaded.root is not None else "",
        "files": [source.data.decode("utf-8", "replace") for source in files],
    }


def with_mock_hardware(root: Element) -> str:
    """Return a description in which all hardware is mocked."""
    document = Document()
    document.appendChild(root.cloneNode(deep=True))
    for control in (element for top in document.elements() for element in top.walk() if _is_control(element)):
        control.setAttribute("type", "system")
        for plugin in (one for one in control.walk() if one.tagName == "plugin"):
            for child in list(plugin.childNodes):
                plugin.removeChild(child)
            plugin.appendChild(XmlText(_MOCK))
    return write(document)


def _is_control(element: Element) -> bool:
    return element.tagName == "ros2_control"


__all__ = ["RealResult", "RealVerdict", "real_results", "with_mock_hardware"]
