"""Judge the package that gen-all makes before it is written: by lint and by the smoke test, with an engine if one is
installed."""

from __future__ import annotations

import os
import re
from collections.abc import Iterator, Mapping
from typing import Any

from urdfctl.commands.generate.judging_plans import faults_of_plans, is_of_moveit
from urdfctl.config.settings import Settings
from urdfctl.diagnostic import Diagnostic, Severity
from urdfctl.generate.options import File
from urdfctl.generate.robot.facts import RobotFacts
from urdfctl.lint.job import Work, run_on_targets
from urdfctl.lint.serialising import diagnostic_from_json, diagnostic_to_json
from urdfctl.load.target import Target
from urdfctl.smoke.checked_robot import CheckedRobot
from urdfctl.smoke.engines import installed
from urdfctl.smoke.ranking import causes_first
from urdfctl.smoke.results import RobotResult
from urdfctl.smoke.run import SmokeRequest, judge, load, move
from urdfctl.startup.records import NamedTuple

_ROBOT, _CONTROL, _CONTROLLERS = "urdf/robot.urdf.xacro", "urdf/control.xacro", ".yaml"
_BASE = "urdf/base_"
_BESIDE = ".urdfctl-generated-"
"""The beginning of the names under which the files are read, as if they were beside the robot."""
_INCLUDE = re.compile(r'(<xacro:include filename=")([^"]*)(")')
_OWN_FILE = re.compile(r"\$\(find [^)]+\)/(config/controllers\.yaml)")
"""The controller file as the package names it to the simulator's plugin: the package is not there yet."""
_FATAL = ("UC901", "UC902", "UC903", "UC904", "UC905", "UC910")
"""What keeps the robot or a controller from starting."""
_GAINS = ("UC916", "UC917", "UC918", "UC966", "UC987")
"""What is wrong with gains."""
_NOT_JUDGED = ("UC000", "UC920")
"""A rule or an engine crashed: that says nothing about the robot."""
RATES = (1000, 2000)
"""The update rates, in Hz, for which gains are computed again if those for the default rate are not stable."""


class Judgement(NamedTuple):
    """What the smoke test says of a package that is not written yet.

    fatal: what keeps the robot or a controller from starting.
    gains: the findings about gains.
    others: what keeps something from moving as it should.
    unplanned: the errors in MoveIt's configuration.
    checked: the robot with the plan of its motion; None if it is not known.
    needs: what parts of the robot need that is not here, without which it is not tested.
    """

    fatal: tuple[Diagnostic, ...] = ()
    gains: tuple[Diagnostic, ...] = ()
    others: tuple[Diagnostic, ...] = ()
    unplanned: tuple[Diagnostic, ...] = ()
    checked: CheckedRobot | None = None
    needs: str = ""

    @property
    def refusal(self) -> str:
        """Why the package should not be written, or nothing."""
        if self.fatal:
            return "would not start"
        if self.unplanned:
            return "could not be planned for"
        found = [one for one in (*self.gains, *self.others) if one.code not in _NOT_JUDGED]
        fails = any(one.severity is Severity.ERROR for one in found)
        return "would not move as commanded" if fails else ""

    def lines(self) -> Iterator[str]:
        """Yield a line for what is missing, and for each finding, with its place if that is in a file of the user."""
        if self.needs:
            yield f"parts of the robot are not known, and its package is not tested: {self.needs}"
        told = [*self.fatal, *self.unplanned, *self.gains]
        told += [one for one in self.others if self.refusal or one.severity is Severity.ERROR]
        for finding in causes_first(told):
            own = os.path.basename(finding.at.file).startswith(_BESIDE)
            place = "" if own else f"{os.path.relpath(finding.at.file)}:{finding.at.line}: "
            yield f"{place}{finding.code} {finding.message}"


def judged(made: list[File], robot: RobotFacts, settings: Settings, *, repaired: bool = False) -> Judgement:
    """Return what is wrong with the files of a package for a robot at rest; nothing if that cannot be known.

    repaired: whether the package has a copy of the robot that differs from it.
    """
    if robot.file is None:
        return Judgement()
    path = os.path.abspath(robot.file)
    texts = dict(_texts(made, path, repaired=repaired))
    description = _beside(path, _ROBOT)
    controllers = tuple(name for name in texts if name.endswith(_CONTROLLERS) and not is_of_moveit(name))
    target = Target(description, controllers=controllers)
    [result] = run_on_targets(judge_work, [target], settings, details=[{"texts": texts}])
    if not isinstance(result, dict):
        return Judgement()
    checked = CheckedRobot.from_json(result)
    unplanned = tuple(map(diagnostic_from_json, result["unplanned"]))
    needs = "" if _BESIDE in checked.result.needs else checked.result.needs
    return _judgement(checked.result)._replace(checked=checked, unplanned=unplanned, needs=needs)


def with_motion(judgement: Judgement, robot: RobotFacts, settings: Settings) -> Judgement:
    """Return a judgement with what an engine finds when the controllers move; the same if no engine is installed, or if
    the robot has no masses, without which no engine moves it. KeyboardInterrupt: after Ctrl-C, nothing is written."""
    is_movable = any(joint.inertia for joint in robot.joints)
    if judgement.checked is None or judgement.fatal or not is_movable or not installed():
        return judgement
    [result] = move([judgement.checked], _request(), settings)
    if result.interrupted:
        raise KeyboardInterrupt
    return _judgement(result)._replace(unplanned=judgement.unplanned, needs=judgement.needs)


def _request() -> SmokeRequest:
    return SmokeRequest(engines=installed()[:1], instead=installed()[1:])


def _judgement(result: RobotResult) -> Judgement:
    found = [one for one in result.linted.outcome.diagnostics if one.severity is not Severity.INFO]
    return Judgement(
        fatal=tuple(one for one in found if one.code in _FATAL),
        gains=tuple(one for one in found if one.code in _GAINS),
        others=tuple(one for one in found if one.code not in (*_FATAL, *_GAINS)),
    )


def _texts(made: list[File], path: str, *, repaired: bool) -> Iterator[tuple[str, str]]:
    """The description and the controllers, by the paths under which they are read."""
    names = (f"urdf/{os.path.basename(path)}", f"{_BASE}{os.path.basename(path)}")
    copy = next((file.name for file in made if repaired and file.name in names), "")
    for file in made:
        if file.name == _ROBOT:
            copied = _beside(path, copy) if copy else path
            text = _including(file.text, [copied, _beside(path, _CONTROL)])
            yield _beside(path, _ROBOT), text
        elif file.name == _CONTROL:
            yield _beside(path, file.name), _OWN_FILE.sub(lambda found: _beside(path, found[1]), file.text)
        elif file.name == copy or os.path.basename(file.name) == "controllers.yaml" or is_of_moveit(file.name):
            yield _beside(path, file.name), file.text


def _including(text: str, paths: list[str]) -> str:
    """A description that includes other files than it says, in this order."""
    parts = _INCLUDE.split(text)
    for number, path in zip(range(2, len(parts), 4), paths, strict=False):
        parts[number] = path
    return "".join(parts)


def _beside(path: str, name: str) -> str:
    return os.path.join(os.path.dirname(path), _BESIDE + os.path.basename(name))


def judge_work(work: Work) -> dict[str, Any]:
    """Return a robot whose files are in memory after the checks without an engine, in a worker."""
    texts: Mapping[str, str] = work.details["texts"]
    loader = work.loader.with_overlay({os.path.realpath(path): text.encode() for path, text in texts.items()})
    seen = load(loader, work.target)
    planned = [path for path in texts if is_of_moveit(path)]
    unplanned = faults_of_plans(seen, loader, planned) if any(path.endswith(".srdf") for path in planned) else []
    return {**judge(seen, loader, _request()).to_json(), "unplanned": [*map(diagnostic_to_json, unplanned)]}
