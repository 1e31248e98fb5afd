"""The life of each controller as a controller manager would see it, without anything moving: load, configure, activate.

What stops a controller comes from two sources: `urdfctl.control.life` for types, claims, chains and conflicts in the
order in which controllers are started; lint's errors for what is wrong in the files.
"""

from __future__ import annotations

from collections.abc import Collection, Iterator, Sequence

from urdfctl.catalog.distros import generation
from urdfctl.control.chains import chained_claims
from urdfctl.control.hardware import Absence
from urdfctl.control.life import Reason, Stage, Stop, lives
from urdfctl.control.session import Configured, Session, session_of
from urdfctl.diagnostic import Diagnostic, Severity
from urdfctl.model.project import Project
from urdfctl.record import NamedTuple
from urdfctl.smoke.results import STEPS, ControllerResult, Step, Trouble, Verdict
from urdfctl.smoke.stages import BY_LIFE, OF_FILES, OF_HARDWARE, OF_ROBOT, concerns, step_of
from urdfctl.smoke.words import told, words_of, words_of_step

CODES = {Step.LOAD: "UC903", Step.CONFIGURE: "UC904", Step.ACTIVATE: "UC905"}
_OF_TYPES = ("UC420", "UC421", "UC422", "UC423")
"""What lint tells of types that surely do not exist: of others it only knows that they are not in the catalogue."""
_PAST = {Step.LOAD: "loaded", Step.CONFIGURE: "configured", Step.ACTIVATE: "activated"}


class Refusal(NamedTuple):
    """What stops a controller: the step, why in our words, and what the manager prints."""

    step: Step
    why: str
    words: str
    told_by: str = ""


class Way(NamedTuple):
    """A controller and what stops it, None where it gets to be active."""

    configured: Configured
    refusal: Refusal | None

    @property
    def result(self) -> ControllerResult:
        """The verdict, as long as nothing was moved."""
        written = self.configured.controller.type
        kind = written.text if written else None
        name = self.configured.name
        if self.refusal:
            return ControllerResult(name, kind, Verdict.FAILED, self.refusal.step, self.refusal.why)
        return ControllerResult(name, kind, Verdict.SKIPPED, Step.ACTIVATE, "structural only: nothing was moved")


class Cycle(NamedTuple):
    """What one distro's manager makes of a robot: not `spawned` where the robot itself is refused."""

    distro: str
    session: Session
    ways: tuple[Way, ...]
    troubles: tuple[Trouble, ...]
    spawned: bool = True

    @property
    def ros(self) -> int:
        """1 or 2."""
        return generation(self.distro)


def life_cycle(project: Project, found: Sequence[Diagnostic]) -> Cycle:
    """The ways of all controllers of a project, of which lint found something."""
    errors = [one for one in found if one.severity is Severity.ERROR]
    session = _best_session(project, errors)
    of_robot = [one for one in errors if one.code.startswith(OF_ROBOT) and one.code not in OF_FILES]
    of_hardware = [one for one in errors if one.code.startswith(OF_HARDWARE)]
    troubles: list[Trouble] = []
    blocked: Refusal | None = None
    if of_robot:
        blocked = Refusal(Step.LOAD, "the robot's description is refused", "")
        troubles.append(_refused("UC901", "the robot cannot be spawned", of_robot))
    elif of_hardware:
        blocked = Refusal(Step.ACTIVATE, "the robot's hardware is refused", "")
        troubles.append(_refused("UC902", "the hardware cannot be started", of_hardware))
    ways = _cascaded(session, tuple(_ways(session, errors, blocked)))
    troubles += [_trouble(way.configured, way.refusal) for way in ways if way.refusal and way.refusal is not blocked]
    return Cycle(session.distro, session, ways, tuple(troubles), blocked is None)


def _best_session(project: Project, errors: Sequence[Diagnostic]) -> Session:
    """What the project's distro makes of it; where it may be for several, the newest that refuses, or does not know,
    the fewest of its controllers."""
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
    assert best is not None  # noqa: S101 (a project has a distro at least)
    return best


def _ways(session: Session, errors: Sequence[Diagnostic], blocked: Refusal | None) -> Iterator[Way]:
    """First the controllers that are started, in their order; then each of the others, as if it were alone."""
    ros = generation(session.distro)
    started = session.started or ()
    names = {id(one) for one in started}
    alone = session._replace(started=None, controllers=tuple(c for c in session.controllers if id(c) not in names))
    of_life: dict[int, list[Refusal]] = {}
    for life in (*(lives(session) if started else ()), *lives(alone)):
        named = any(error.code in _OF_TYPES and concerns(error, life.controller.controller) for error in errors)
        stops = [stop for stop in life.stops if _is_sure(stop, named=named)]
        lint_says = {one.code for one in errors if one.code in BY_LIFE and concerns(one, life.controller.controller)}
        told_by = lint_says.pop() if len(lint_says) == len(stops) == 1 else ""
        of_life[id(life.controller)] = [
            Refusal(Step(stop.stage.value), told(stop), words_of(life.controller, stop, ros), told_by) for stop in stops
        ]
    everyone = (*started, *alone.controllers)
    of_files = [
        one for one in errors if one.code in OF_FILES or (one.code.startswith("UC4") and one.code not in BY_LIFE)
    ]
    of_all = [error for error in of_files if not any(concerns(error, one.controller) for one in everyone)]
    for one in everyone:
        refusals = [*_of_files(one, of_files, of_all, ros), *of_life[id(one)]]
        first = min(refusals, key=lambda refusal: STEPS.index(refusal.step), default=None)
        yield Way(one, _in_its_words(first, of_life[id(one)]) if first else blocked)


def _cascaded(session: Session, ways: tuple[Way, ...]) -> tuple[Way, ...]:
    """The ways with those that need an interface of a controller that never becomes active."""
    while True:
        refused = {id(way.configured) for way in ways if way.refusal}
        found = tuple(way if way.refusal else way._replace(refusal=_starved(session, way, refused)) for way in ways)
        if found == ways:
            return ways
        ways = found


def _starved(session: Session, way: Way, refused: Collection[int]) -> Refusal | None:
    for one in chained_claims(session, way.configured):
        if id(one.following) in refused:
            stop = Stop(Stage.ACTIVATE, Reason.NOT_OFFERED, one.claim, one.kind)
            why = f"it needs '{one.claim.name}' of controller '{one.following.name}', which never becomes active"
            return Refusal(Step.ACTIVATE, why, words_of(way.configured, stop, 2))
    return None


def _is_sure(stop: Stop, *, named: bool) -> bool:
    """Whether a stop is one: a driver may offer more than is known, and a type may come from another package."""
    return stop.absence is Absence.SURE and (stop.reason is not Reason.TYPE_UNKNOWN or named)


def _in_its_words(first: Refusal, of_life: Sequence[Refusal]) -> Refusal:
    """A refusal with what the manager prints where it says more than that it did not go well; nothing where its file
    is refused before the manager is asked."""
    if first.told_by in OF_FILES:
        return first._replace(words="")
    return first._replace(words=next((one.words for one in of_life if one.step is first.step), first.words))


def _of_files(
    one: Configured, errors: Sequence[Diagnostic], of_all: Sequence[Diagnostic], ros: int
) -> Iterator[Refusal]:
    """What lint found wrong in the files: of a controller, or of the file or the manager, which stops all of them."""
    for error in errors:
        common = error.code in OF_FILES or error in of_all
        if common or concerns(error, one.controller):
            step = Step.LOAD if common else step_of(error, one, ros)
            yield Refusal(step, error.message, words_of_step(one, step, ros), error.code)


def _trouble(one: Configured, refusal: Refusal) -> Trouble:
    message = f"controller '{one.name}' is not {_PAST[refusal.step]}: {refusal.why}"
    notes = [f"the controller manager says: {refusal.words}"] if refusal.words else []
    if refusal.told_by:
        notes.append(f"urdfctl lint tells of it as {refusal.told_by}")
    return Trouble(CODES[refusal.step], f"controller:{one.name}", message, one.name, tuple(notes))


def _refused(code: str, what: str, errors: Sequence[Diagnostic]) -> Trouble:
    first, others = errors[0], len(errors) - 1
    notes = [f"urdfctl lint tells of it as {first.code}"]
    if others:
        notes.append(f"lint finds {others} more error{'s' if others > 1 else ''} of this kind")
    return Trouble(code, f"lint:{first.code}", f"{what}: {first.message}", None, tuple(notes))
