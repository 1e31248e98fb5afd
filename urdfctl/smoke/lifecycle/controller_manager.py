"""The lifecycle of each controller as a controller manager leads it, with nothing moving: load, configure, activate.

A controller is stopped for one of two reasons. `urdfctl.control.lifecycle` finds types, claims, chains and conflicts,
in the order in which controllers are started. Errors of lint cover what is wrong in the files.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence

from urdfctl.catalog.distros import generation, since
from urdfctl.control.chains import chained_claims
from urdfctl.control.hardware.gazebo_ros1 import in_gazebo
from urdfctl.control.hardware.interfaces import Absence
from urdfctl.control.lifecycle import Life, Reason, Stop, lives
from urdfctl.control.session import Configured, Session, session_of
from urdfctl.diagnostic import Diagnostic, Severity
from urdfctl.fault import FaultWithMessage
from urdfctl.model.project import Project
from urdfctl.model.stage import CONTROLLER_STAGES, Stage
from urdfctl.names import enumerated
from urdfctl.rules.controllers.collection_empty import collection_empty
from urdfctl.rules.controllers.controller_type_missing import controller_type_missing
from urdfctl.rules.controllers.controller_type_not_in_distro import controller_type_not_in_distro
from urdfctl.rules.controllers.controller_type_of_other_ros import controller_type_of_other_ros
from urdfctl.rules.controllers.controller_type_unknown import controller_type_unknown
from urdfctl.rules.simulation.controllers_file_missing import controllers_file_missing
from urdfctl.rules.simulation.controllers_path_not_expanded import controllers_path_not_expanded
from urdfctl.rules.simulation.controllers_path_relative import controllers_path_relative
from urdfctl.rules.smoke.controller_not_activated import controller_not_activated
from urdfctl.rules.smoke.controller_not_configured import controller_not_configured
from urdfctl.rules.smoke.controller_not_loaded import controller_not_loaded
from urdfctl.rules.smoke.hardware_not_started import hardware_not_started
from urdfctl.rules.smoke.robot_not_spawned import robot_not_spawned
from urdfctl.smoke.lifecycle.lint_errors import (
    LINT_REPORTS_IT,
    concerned_controllers,
    dropped_joints,
    found_by_manager,
    is_common,
    loses_joints,
    stage_stopped,
    stopped_controllers,
    stops_controller,
    stops_every_controller,
    stops_hardware,
    stops_robot,
    stops_whole_file,
)
from urdfctl.smoke.lifecycle.manager_messages import line_of_stage, line_of_stop, reason_of
from urdfctl.smoke.results import ROBOT, ControllerResult, Trouble, Verdict, trouble_of
from urdfctl.startup.records import NamedTuple

_FAULT_OF_STAGE = {
    Stage.LOAD: controller_not_loaded,
    Stage.CONFIGURE: controller_not_configured,
    Stage.ACTIVATE: controller_not_activated,
}
"""The fault that reports a stage that is not passed, before anything moves."""
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

_FILE_IS_NOT_FOUND = frozenset(
    rule.code for rule in (controllers_file_missing, controllers_path_not_expanded, controllers_path_relative)
)
"""Lint's rules on files that a simulator's plugin does not find."""
_OF_HARDWARE = frozenset({Reason.NOT_OFFERED, Reason.NOTHING_TO_CLAIM})
"""What stops a controller because of hardware, of which more may be in a driver or in a part that is not here."""

NOT_MOVED = "not simulated: no physics engine was used"
"""Why a controller that becomes active is not tested further."""
DRIVER_UNKNOWN = {"driver": "it is not in the files; taken to offer what the controllers claim"}
"""What is not tested of controllers whose hardware is a program that no file describes."""
NO_ROBOT, NO_HARDWARE = "the robot description is rejected", "the hardware is rejected"
"""Why no controller becomes active if a fault is not their own."""


class Refusal(NamedTuple):
    """The stage at which a controller is stopped, and why.

    line: the one that the manager prints, or empty.
    cause: the finding of lint that reports it, if one does.
    ends_manager: whether the manager's process ends too.
    blocked_by: what the fault is in if it is not this controller: another controller, the robot, the hardware.
    """

    stage: Stage
    why: str
    line: str = ""
    cause: Diagnostic | None = None
    ends_manager: bool = False
    blocked_by: str = ""


class ControllerLifecycle(NamedTuple):
    """The lifecycle of a controller, as far as it gets without moving.

    configured: the controller, with what it claims and exports.
    name: its name in reports.
    refusal: what stops it; None if it becomes active.
    by_distro: what happens to it in each possible distro, if they differ.
    untested: what of it cannot be tested, by name, with the reason.
    """

    configured: Configured
    name: str
    refusal: Refusal | None
    by_distro: Mapping[str, str] = {}
    untested: Mapping[str, str] = {}

    @property
    def result(self) -> ControllerResult:
        """The result as long as nothing is simulated."""
        declared = self.configured.controller.type
        type_name = declared.text if declared else None
        if self.refusal:
            stage, why, blocked_by = self.refusal.stage, self.refusal.why, self.refusal.blocked_by
            return ControllerResult(self.name, type_name, Verdict.FAILED, stage, why, blocked_by=blocked_by)
        untested = self.untested
        return ControllerResult(self.name, type_name, Verdict.SKIPPED, Stage.ACTIVATE, NOT_MOVED, untested=untested)


class RobotLifecycle(NamedTuple):
    """The lifecycles of a robot's controllers under the manager of one distro.

    causes: the findings of lint at whose places the troubles are, by the subjects of these.
    rejected: why the robot or its hardware is rejected, or empty.
    spawned: False if the robot itself is rejected.
    """

    distro: str
    controllers: tuple[ControllerLifecycle, ...]
    troubles: tuple[Trouble, ...]
    causes: Mapping[str, Diagnostic]
    rejected: str = ""
    spawned: bool = True

    @property
    def ros(self) -> int:
        """1 or 2."""
        return generation(self.distro)


def lifecycle_in(project: Project, distro: str, findings: Sequence[Diagnostic]) -> RobotLifecycle:
    """Return the lifecycles of all controllers of a project in one distro, given lint's findings for that distro."""
    errors = [finding for finding in findings if finding.severity is Severity.ERROR]
    session = session_of(project, distro)
    of_robot = [e for e in errors if stops_robot(e) or (loses_joints(e) and not dropped_joints(e, project))]
    of_hardware = [e for e in errors if stops_hardware(e) or _stops_node_of_hardware(project, session, e)]
    if generation(distro) == 1:
        of_hardware += [error for error in errors if stops_every_controller(error, project)]
    troubles: list[Trouble] = []
    blocked: Refusal | None = None
    if of_robot:
        blocked = Refusal(Stage.LOAD, NO_ROBOT, blocked_by=ROBOT)
        troubles.append(_trouble_of_errors(robot_not_spawned, of_robot))
    elif of_hardware:
        blocked = Refusal(Stage.ACTIVATE, NO_HARDWARE, blocked_by="hardware")
        troubles.append(_trouble_of_errors(hardware_not_started, of_hardware))
    controllers = tuple(_ControllerManager(project, session, findings).controllers(blocked))
    controllers = _with_one_owner(_cascaded(session, _ended_together(controllers)))
    troubles += [_trouble(each, controllers) for each in controllers if each.refusal and not each.refusal.blocked_by]
    causes = {subject_of(finding): finding for finding in findings}
    rejected = (of_robot or of_hardware)[0].message if blocked else ""
    return RobotLifecycle(
        distro=distro,
        controllers=controllers,
        troubles=tuple(troubles),
        causes=causes,
        rejected=rejected,
        spawned=not of_robot,
    )


def subject_of(error: Diagnostic) -> str:
    """Return the subject of a finding that is at the place of a finding of lint."""
    return f"lint:{error.code}:{error.at.start}:{error.at.file}"


def _stops_node_of_hardware(project: Project, session: Session, error: Diagnostic) -> bool:
    """Whether an error in a controller's section stops the hardware of the same name, whose node reads the section too.

    From jazzy on each component has a node, with its name in lower case (hardware_component_interface.cpp).
    """
    if error.code != collection_empty.code or session.distro not in since("jazzy"):
        return False
    offers = (offer for each in (session.hardware.command, session.hardware.state) for offer in each.values())
    nodes = {one.by.lower().replace("/", "_") for offered in offers for one in offered if one.by}
    return any(each.name in nodes for each in concerned_controllers(error, project, session.controllers))


def _labels_of(session: Session) -> dict[int, str]:
    """Return the name of each controller by identity, with its namespace if another controller has the same name."""
    names = [configured.name for configured in session.controllers]
    return {
        id(each): each.name if names.count(each.name) == 1 else f"/{each.controller.full_name.lstrip('/')}"
        for each in session.controllers
    }


class _ControllerManager:
    """The controllers of one session with the errors of lint, each by the controllers that it stops."""

    def __init__(self, project: Project, session: Session, findings: Sequence[Diagnostic]) -> None:
        self._project, self._session = project, session
        errors = [finding for finding in findings if finding.severity is Severity.ERROR]
        self._ros, self._everyone = generation(session.distro), session.controllers
        self._labels = _labels_of(session)
        self._has_driver = generation(session.distro) == 1 and in_gazebo(project) is not Severity.ERROR
        self._is_whole = project.complete and not project.library
        self._unread = next((error for error in errors if error.code in _FILE_IS_NOT_FOUND), None)
        self._about = [(finding, concerned_controllers(finding, project, self._everyone)) for finding in findings]
        self._of_files = [
            (error, stopped_controllers(error, project, self._everyone, self._ros))
            for error in errors
            if stops_controller(error)
        ]

    def controllers(self, blocked: Refusal | None) -> Iterator[ControllerLifecycle]:
        """First the controllers that are started, in their order; then each of the others, as if it were alone."""
        session = self._session
        started = session.started or ()
        ids_started = {id(configured) for configured in started}
        others = tuple(configured for configured in session.controllers if id(configured) not in ids_started)
        alone = session._replace(started=None, controllers=others)
        for life in (*(lives(session) if started else ()), *lives(alone)):
            by_manager = self._refused_by_manager(life)
            refusals = [*self._refused_by_files(life.controller), *by_manager]
            first = min(refusals, key=lambda refusal: CONTROLLER_STAGES.index(refusal.stage), default=None)
            if first is None or (blocked and not first.cause):
                refusal = blocked._replace(stage=first.stage if first else blocked.stage) if blocked else None
            else:
                refusal = _with_line(first, by_manager)
            name, untested = self._labels[id(life.controller)], self._untested(life)
            yield ControllerLifecycle(life.controller, name, refusal, untested=untested)

    def _untested(self, life: Life) -> Mapping[str, str]:
        """What the driver of real hardware of ROS 1 may offer, which registers what it implements."""
        assumed = self._has_driver and any(stop.reason is Reason.NOT_OFFERED for stop in life.stops)
        return DRIVER_UNKNOWN if assumed else {}

    def _refused_by_manager(self, life: Life) -> list[Refusal]:
        """The refusals that the manager works out by itself, with the error of lint that reports each."""
        about = [finding for finding, those in self._about if any(each is life.controller for each in those)]
        errors = {finding.code for finding in about if finding.severity is Severity.ERROR}
        type_is_wrong = not errors.isdisjoint(_TYPE_DOES_NOT_EXIST)
        stops = [stop for stop in life.stops if _is_certain(stop, type_is_wrong=type_is_wrong)]
        is_certain = any(found_by_manager(finding) for finding in about if finding.severity is Severity.ERROR)
        if not is_certain and (self._has_driver or not self._is_whole):
            stops = [stop for stop in stops if stop.reason not in _OF_HARDWARE]
        if not errors and self._may_be_declared(life.controller):
            unread = self._unread
            return [Refusal(Stage.LOAD, unread.message, "", unread)] if unread else []
        return [self._refusal(life.controller, stop, about, alone=len(stops) == 1) for stop in stops]

    def _may_be_declared(self, configured: Configured) -> bool:
        """Whether a started controller may be declared in a file that is not known."""
        controllers = self._project.controllers
        return configured.controller.declared_at is None and controllers is not None and not controllers.complete

    def _refusal(self, configured: Configured, stop: Stop, about: Sequence[Diagnostic], *, alone: bool) -> Refusal:
        cause = _cause_of(stop, about, alone=alone)
        why = reason_of(stop)
        if configured.controller.declared_at is None:
            why = cause.message if cause else "no file declares it"
        return Refusal(stop.stage, why, line_of_stop(configured, stop, self._ros), cause, stop.ends_manager)

    def _refused_by_files(self, configured: Configured) -> Iterator[Refusal]:
        """The refusals for lint's errors about a controller, its file or its manager."""
        for error, those in self._of_files:
            if not any(each is configured for each in those):
                continue
            if is_common(error, self._project, self._everyone):
                yield Refusal(Stage.LOAD, error.message, "", error)
            else:
                stage = stage_stopped(error, configured, self._ros)
                yield Refusal(stage, error.message, line_of_stage(configured, stage, self._ros), error)


def _cause_of(stop: Stop, about: Sequence[Diagnostic], *, alone: bool) -> Diagnostic | None:
    """The finding of lint that reports a stop: the only error of the manager's, or one that names the interface."""
    errors = [finding for finding in about if finding.severity is Severity.ERROR]
    if stop.reason in (Reason.TYPE_UNKNOWN, Reason.TYPE_MISSING):
        return next((error for error in errors if error.code in _TYPE_DOES_NOT_EXIST), errors[0] if errors else None)
    of_manager = [error for error in errors if found_by_manager(error)]
    if alone and len({error.code for error in of_manager}) == 1:
        return of_manager[0]
    names = (stop.claim.name, stop.claim.component) if stop.claim else ()
    return next((finding for name in names for finding in about if f"'{name}'" in finding.message), None)


def _ended_together(controllers: tuple[ControllerLifecycle, ...]) -> tuple[ControllerLifecycle, ...]:
    """The lifecycles, in which all controllers stop if one of them ends the manager's process."""
    fatal = next((each for each in controllers if each.refusal and each.refusal.ends_manager), None)
    if fatal is None:
        return controllers
    why = f"controller '{fatal.name}' ends the process of the controller manager"
    ended = Refusal(Stage.ACTIVATE, why, blocked_by=fatal.name)
    return tuple(each if each.refusal else each._replace(refusal=ended) for each in controllers)


def _cascaded(session: Session, controllers: tuple[ControllerLifecycle, ...]) -> tuple[ControllerLifecycle, ...]:
    """The lifecycles, in which controllers stop too that need an interface of one that never becomes active."""
    while True:
        refused = {id(each.configured): each for each in controllers if each.refusal}
        changed = tuple(
            each if each.refusal else each._replace(refusal=_starved(session, each, refused)) for each in controllers
        )
        if changed == controllers:
            return controllers
        controllers = changed


def _starved(
    session: Session, controller: ControllerLifecycle, refused: Mapping[int, ControllerLifecycle]
) -> Refusal | None:
    for chained in chained_claims(session, controller.configured):
        following = refused.get(id(chained.following))
        if following is not None and following.refusal is not None:
            why = f"it needs '{chained.claim.name}' of controller '{following.name}', which never becomes active"
            return Refusal(Stage.ACTIVATE, why, blocked_by=following.refusal.blocked_by or following.name)
    return None


def _with_one_owner(controllers: tuple[ControllerLifecycle, ...]) -> tuple[ControllerLifecycle, ...]:
    """The lifecycles, in which an error that stops several controllers is reported for the first of them."""
    owners: dict[str, str] = {}
    owned = []
    for controller in controllers:
        refusal = controller.refusal
        if refusal and refusal.cause and not refusal.blocked_by:
            owner = owners.setdefault(subject_of(refusal.cause), controller.name)
            if owner != controller.name:
                controller = controller._replace(refusal=refusal._replace(blocked_by=owner))  # noqa: PLW2901 (another one of it)
        owned.append(controller)
    return tuple(owned)


def _is_certain(stop: Stop, *, type_is_wrong: bool) -> bool:
    """A driver may offer more than is known, and an unknown type may come from another package."""
    return stop.absence is Absence.SURE and (stop.reason is not Reason.TYPE_UNKNOWN or type_is_wrong)


def _with_line(first: Refusal, by_manager: Sequence[Refusal]) -> Refusal:
    """A refusal with the most specific line that the manager prints, or none if the file is rejected before."""
    if first.cause and stops_whole_file(first.cause.code):
        return first
    return first._replace(
        line=next((refusal.line for refusal in by_manager if refusal.stage is first.stage), first.line)
    )


def _trouble(controller: ControllerLifecycle, controllers: Sequence[ControllerLifecycle]) -> Trouble:
    refusal, name = controller.refusal, controller.name
    assert refusal is not None  # noqa: S101 (only refused controllers have one)
    notes = [f"the controller manager says: {refusal.line}"] if refusal.line else []
    if refusal.cause:
        notes.append(f"{LINT_REPORTS_IT}{refusal.cause.code}")
    others = [f"'{other.name}'" for other in controllers if other.refusal and other.refusal.blocked_by == name]
    if others:
        notes.append(f"it also stops controller{'s' if len(others) > 1 else ''} {enumerated(others, 'and')}")
    subject = subject_of(refusal.cause) if refusal.cause else f"controller:{name}"
    return trouble_of(_FAULT_OF_STAGE[refusal.stage], subject, name, tuple(notes), why=refusal.why)


def _trouble_of_errors(fault: FaultWithMessage, errors: Sequence[Diagnostic]) -> Trouble:
    first, others = errors[0], len(errors) - 1
    notes = [f"{LINT_REPORTS_IT}{first.code}"]
    if others:
        notes.append(f"lint reports {others} more error{'s' if others > 1 else ''} of this kind")
    return trouble_of(fault, subject_of(first), notes=tuple(notes), why=first.message)
