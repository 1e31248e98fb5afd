"""The life of each controller as a controller manager sees it, with nothing moving: load, configure, activate.

A controller is stopped for one of two reasons. `urdfctl.control.life` finds types, claims, chains and conflicts, in the
order in which controllers are started. Errors of lint cover what is wrong in the files.
"""

from __future__ import annotations

from collections.abc import Collection, Iterator, Sequence

from urdfctl.catalog.distros import generation, since
from urdfctl.control.chains import chained_claims
from urdfctl.control.hardware import Absence
from urdfctl.control.life import Reason, Stop, lives
from urdfctl.control.session import Configured, Session, session_of
from urdfctl.diagnostic import Diagnostic, Severity
from urdfctl.model.project import Project
from urdfctl.model.stage import CONTROLLER_STAGES, Stage, StageDependsOn
from urdfctl.rule import Rule
from urdfctl.rules.controllers.collection_empty import collection_empty
from urdfctl.rules.controllers.controller_type_missing import controller_type_missing
from urdfctl.rules.controllers.controller_type_not_in_distro import controller_type_not_in_distro
from urdfctl.rules.controllers.controller_type_of_other_ros import controller_type_of_other_ros
from urdfctl.rules.controllers.controller_type_unknown import controller_type_unknown
from urdfctl.rules.smoke.family import RULES
from urdfctl.rules.smoke.hardware_not_started import hardware_not_started
from urdfctl.rules.smoke.robot_not_spawned import robot_not_spawned
from urdfctl.smoke.results import ControllerResult, Trouble, Verdict, trouble_of
from urdfctl.smoke.stages import (
    concerns,
    found_by_manager,
    stage_stopped,
    stops_controller,
    stops_hardware,
    stops_parameters,
    stops_robot,
)
from urdfctl.smoke.words import line_of_stage, line_of_stop, reason_of
from urdfctl.startup.records import NamedTuple

_RULE_OF_STAGE: dict[Stage | StageDependsOn | None, Rule] = {
    rule.stage: rule for rule in RULES if rule.stage is not Stage.MOVE
}
"""The rule that reports a stage that is not passed, before anything moves."""
_TYPE_DOES_NOT_EXIST = frozenset(
    rule.code
    for rule in (
        controller_type_missing,
        controller_type_unknown,
        controller_type_not_in_distro,
        controller_type_of_other_ros,
    )
)
"""Lint's rules on types that certainly do not exist. Other unknown types may come from packages outside the catalog."""


NO_ROBOT, NO_HARDWARE = BLOCKED = ("the robot description is rejected", "the hardware is rejected")
"""Why no controller becomes active if a fault is not their own."""


class Refusal(NamedTuple):
    """The stage at which a controller is stopped, why, and the line that the manager prints.

    `reported_as` is the code under which lint reports it, or empty. `ends_manager`: the manager's process ends too.
    """

    stage: Stage
    why: str
    line: str
    reported_as: str = ""
    ends_manager: bool = False


class Way(NamedTuple):
    """A controller and what stops it, None if it becomes active."""

    configured: Configured
    refusal: Refusal | None

    @property
    def result(self) -> ControllerResult:
        """The result as long as nothing is simulated."""
        declared = self.configured.controller.type
        type_name = declared.text if declared else None
        name = self.configured.name
        if self.refusal:
            return ControllerResult(name, type_name, Verdict.FAILED, self.refusal.stage, self.refusal.why)
        reason = "not simulated: no physics engine was used"
        return ControllerResult(name, type_name, Verdict.SKIPPED, Stage.ACTIVATE, reason)


class Cycle(NamedTuple):
    """The lives of a robot's controllers under one distro's manager. `spawned` is False if the robot is rejected."""

    distro: str
    session: Session
    ways: tuple[Way, ...]
    troubles: tuple[Trouble, ...]
    spawned: bool = True

    @property
    def ros(self) -> int:
        """1 or 2."""
        return generation(self.distro)


def life_cycle(project: Project, findings: Sequence[Diagnostic]) -> Cycle:
    """Return the lives of all controllers of a project, given lint's findings."""
    errors = [finding for finding in findings if finding.severity is Severity.ERROR]
    session = _best_session(project, errors)
    of_robot = [error for error in errors if stops_robot(error)]
    of_hardware = [error for error in errors if stops_hardware(error) or _stops_node_of_hardware(session, error)]
    troubles: list[Trouble] = []
    blocked: Refusal | None = None
    if of_robot:
        blocked = Refusal(Stage.LOAD, NO_ROBOT, "")
        troubles.append(_trouble_of_errors(robot_not_spawned, of_robot))
    elif of_hardware:
        blocked = Refusal(Stage.ACTIVATE, NO_HARDWARE, "")
        troubles.append(_trouble_of_errors(hardware_not_started, of_hardware))
    ways = _cascaded(session, _ended_together(tuple(_ways(session, errors, blocked))))
    troubles += [_trouble(way.configured, way.refusal) for way in ways if way.refusal and way.refusal is not blocked]
    return Cycle(session.distro, session, ways, tuple(troubles), blocked is None)


def _stops_node_of_hardware(session: Session, error: Diagnostic) -> bool:
    """Whether an error in a controller's section stops the hardware of the same name, whose node reads the section too.

    From jazzy on each component has a node, with its name in lower case (hardware_component_interface.cpp).
    """
    if error.code != collection_empty.code or session.distro not in since("jazzy"):
        return False
    offers = (offer for each in (session.hardware.command, session.hardware.state) for offer in each.values())
    nodes = {one.by.lower().replace("/", "_") for offered in offers for one in offered if one.by}
    return any(each.name in nodes and concerns(error, each.controller) for each in session.controllers)


def _best_session(project: Project, errors: Sequence[Diagnostic]) -> Session:
    """The session in the project's distro. If several are possible: the newest of those in which the fewest controllers
    are rejected or unknown."""
    distros = (project.distro,) if project.distro else tuple(reversed(project.distros))
    best, fewest = None, 0
    for distro in distros:
        session = session_of(project, distro)
        ways = _ways(session, errors, None) if len(distros) > 1 else ()
        refused = sum(way.refusal is not None or way.configured.type is None for way in ways)
        if best is None or refused < fewest:
            best, fewest = session, refused
        if not fewest:
            break
    assert best is not None  # noqa: S101 (a project has at least one distro)
    return best


def _ways(session: Session, errors: Sequence[Diagnostic], blocked: Refusal | None) -> Iterator[Way]:
    """First the controllers that are started, in their order; then each of the others, as if it were alone."""
    ros = generation(session.distro)
    started = session.started or ()
    ids_started = {id(configured) for configured in started}
    others = tuple(configured for configured in session.controllers if id(configured) not in ids_started)
    alone = session._replace(started=None, controllers=others)
    of_life: dict[int, list[Refusal]] = {}
    for life in (*(lives(session) if started else ()), *lives(alone)):
        about = [error for error in errors if concerns(error, life.controller.controller)]
        type_is_wrong = any(error.code in _TYPE_DOES_NOT_EXIST for error in about)
        stops = [stop for stop in life.stops if _is_certain(stop, type_is_wrong=type_is_wrong)]
        codes = {error.code for error in about if found_by_manager(error)}
        code = codes.pop() if len(codes) == len(stops) == 1 else ""
        of_life[id(life.controller)] = [
            Refusal(stop.stage, reason_of(stop), line_of_stop(life.controller, stop, ros), code, stop.ends_manager)
            for stop in stops
        ]
    everyone = (*started, *alone.controllers)
    of_files = [error for error in errors if stops_controller(error)]
    of_all = [error for error in of_files if not any(concerns(error, c.controller) for c in everyone)]
    for configured in everyone:
        refusals = [*_of_files(configured, of_files, of_all, ros), *of_life[id(configured)]]
        first = min(refusals, key=lambda refusal: CONTROLLER_STAGES.index(refusal.stage), default=None)
        yield Way(configured, _with_line(first, of_life[id(configured)]) if first else blocked)


def _ended_together(ways: tuple[Way, ...]) -> tuple[Way, ...]:
    """The ways, in which all controllers stop if one of them ends the manager's process."""
    fatal = next((way for way in ways if way.refusal and way.refusal.ends_manager), None)
    if fatal is None:
        return ways
    why = f"controller '{fatal.configured.name}' ends the process of the controller manager"
    ended = Refusal(Stage.ACTIVATE, why, "")
    return tuple(way if way.refusal else way._replace(refusal=ended) for way in ways)


def _cascaded(session: Session, ways: tuple[Way, ...]) -> tuple[Way, ...]:
    """The ways, in which controllers that need an interface of a controller that never becomes active stop too."""
    while True:
        refused = {id(way.configured) for way in ways if way.refusal}
        changed = tuple(way if way.refusal else way._replace(refusal=_starved(session, way, refused)) for way in ways)
        if changed == ways:
            return ways
        ways = changed


def _starved(session: Session, way: Way, refused: Collection[int]) -> Refusal | None:
    for chained in chained_claims(session, way.configured):
        if id(chained.following) in refused:
            stop = Stop(Stage.ACTIVATE, Reason.NOT_OFFERED, chained.claim, chained.kind)
            why = (
                f"it needs '{chained.claim.name}' of controller '{chained.following.name}', which never becomes active"
            )
            return Refusal(Stage.ACTIVATE, why, line_of_stop(way.configured, stop, 2))
    return None


def _is_certain(stop: Stop, *, type_is_wrong: bool) -> bool:
    """A driver may offer more than is known, and an unknown type may come from another package."""
    return stop.absence is Absence.SURE and (stop.reason is not Reason.TYPE_UNKNOWN or type_is_wrong)


def _with_line(first: Refusal, of_life: Sequence[Refusal]) -> Refusal:
    """A refusal with the most specific line that the manager prints, or none if the file is rejected before."""
    if first.reported_as and stops_parameters(first.reported_as):
        return first._replace(line="")
    return first._replace(line=next((refusal.line for refusal in of_life if refusal.stage is first.stage), first.line))


def _of_files(
    configured: Configured, errors: Sequence[Diagnostic], of_all: Sequence[Diagnostic], ros: int
) -> Iterator[Refusal]:
    """Lint's errors about a controller, and those about its file or the manager, which stop all controllers."""
    for error in errors:
        common = stops_parameters(error.code) or error in of_all
        if common or concerns(error, configured.controller):
            stage = Stage.LOAD if common else stage_stopped(error, configured, ros)
            yield Refusal(stage, error.message, line_of_stage(configured, stage, ros), error.code)


def _trouble(configured: Configured, refusal: Refusal) -> Trouble:
    name = configured.name
    notes = [f"the controller manager says: {refusal.line}"] if refusal.line else []
    if refusal.reported_as:
        notes.append(f"urdfctl lint reports it as {refusal.reported_as}")
    return trouble_of(_RULE_OF_STAGE[refusal.stage], f"controller:{name}", name, tuple(notes), why=refusal.why)


def _trouble_of_errors(rule: Rule, errors: Sequence[Diagnostic]) -> Trouble:
    first, others = errors[0], len(errors) - 1
    notes = [f"urdfctl lint reports it as {first.code}"]
    if others:
        notes.append(f"lint reports {others} more error{'s' if others > 1 else ''} of this kind")
    return trouble_of(rule, f"lint:{first.code}", notes=tuple(notes), why=first.message)
