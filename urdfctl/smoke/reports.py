"""The report formats of smoke tests: those of lint, with the result of each controller."""

from __future__ import annotations

from collections.abc import Callable, Iterator, Sequence
from typing import Any

from urdfctl.catalog.distros import in_words
from urdfctl.diagnostic import Diagnostic, Severity
from urdfctl.lint.results import Report
from urdfctl.model.stage import CONTROLLER_STAGES, Stage
from urdfctl.names import shortened
from urdfctl.output.printing import visible
from urdfctl.report import render
from urdfctl.report.common import as_json, in_command, shown
from urdfctl.report.json_report import document
from urdfctl.report.text import Piece, pieces
from urdfctl.smoke.results import ControllerResult, Curve, RobotResult, Verdict
from urdfctl.source.disk.files import is_launch
from urdfctl.startup.records import NamedTuple

_STYLES = {
    Verdict.PASSED: "bold green",
    Verdict.FAILED: "bold red",
    Verdict.WARNED: "bold yellow",
    Verdict.SKIPPED: "dim",
}


_UNDECLARED = "no controllers are declared for this robot"
_MOVED = ": {} may move it, which is not tested"
_NOTHING = "nothing was tested: no controllers found; name their file with --controllers"
_NO_ROBOT = "nothing was tested: there is no robot in URDF or xacro here; models in SDF are not read"
_LAUNCHES = "nothing was tested: name a launch file that starts a robot, such as {}"
_DESCRIPTIONS = "nothing was tested: the launch file starts no robot: name one, such as {}"
_NONE_STARTED = "nothing was tested: no known robot is started"
_LACKING = "nothing was tested: add what is missing"
_UNUSED = "nothing was tested: no robot uses {}: urdfctl smoke {} --controllers {}"
_ONLY_READING = "; none of them moves a joint: name the files of others with --controllers"
_READING = ("started", "read")
_PROPOSED = ", or see what 'urdfctl gen-all {}' proposes"


class SmokeReport(NamedTuple):
    """The results of a run: the smoke test of each robot, and the findings of all as a report of lint.

    unused: the controller files that no robot uses, if nothing was tested.
    instead: the launch files, or else the descriptions, beside launch files that start no robot.
    """

    robots: tuple[RobotResult, ...]
    found: Report
    allow_empty: bool = False
    unused: tuple[str, ...] = ()
    instead: tuple[str, ...] = ()

    @property
    def is_empty(self) -> bool:
        """Whether no controller was tested, and that is an error."""
        return not self.allow_empty and not any(robot.controllers for robot in self.robots)

    @property
    def is_interrupted(self) -> bool:
        """Whether Ctrl-C ended the run before all was tested."""
        return any(robot.interrupted for robot in self.robots)

    def count(self, verdict: Verdict) -> int:
        """Return the number of controllers with a verdict."""
        return sum(robot.count(verdict) for robot in self.robots)


def render_smoke(report: SmokeReport, name: str) -> str:
    """Return the report in one of `SMOKE_FORMATS`."""
    return SMOKE_FORMATS[name](report)


# -- text ------------------------------------------------------------------------------------------------------------


def text_pieces(report: SmokeReport) -> Iterator[Piece]:
    """Yield the lines of the robots with their controllers, the findings, and a summary. Quiet: only the findings."""
    if report.found.quiet:
        yield from pieces(report.found)
        return
    for robot in report.robots:
        yield from robot_pieces(robot)
    if report.robots and report.found.findings:
        yield Piece("\n")
    yield from pieces(report.found)
    yield Piece(visible(summary(report)) + "\n", "bold")


def robot_pieces(robot: RobotResult) -> Iterator[Piece]:
    """Yield a line for a robot, and one for each of its controllers with the stages that it passed."""
    yield Piece(visible(f"{heading(robot)} ({conditions(robot)})") + "\n", "bold")
    if not robot.controllers:
        yield Piece(f"  {visible(_why_nothing(robot))}\n")
    width = max((len(controller.name) for controller in robot.controllers), default=0)
    for controller in robot.controllers:
        yield Piece(f"  {visible(controller.name).ljust(width)}  ")
        yield Piece(controller.verdict.value.ljust(8), _STYLES[controller.verdict])
        told = explanation(controller)
        reason = f"{' ' if controller.verdict is Verdict.FAILED else '  '}{told}" if told else ""
        yield Piece(f" {stages_reached(controller, robot.linted.ros)}{visible(reason)}\n")


def _why_nothing(robot: RobotResult) -> str:
    """Why a robot, or a launch file, has no controllers."""
    if robot.part_of:
        return f"not a robot: it hangs on link '{robot.part_of}', which is in another file"
    if is_launch(robot.linted.path):
        return robot.needs or robot.robotless or _UNDECLARED
    moved = _MOVED.format(robot.movers) if robot.movers else ""
    return "; ".join(part for part in (f"{_UNDECLARED}{moved}", robot.needs) if part)


def explanation(result: ControllerResult) -> str:
    """Return the reason of a verdict, or what led to it; both for a warning, which does not stop the test."""
    both = (result.reason, account(result)) if result.verdict is Verdict.WARNED else (result.reason or account(result),)
    return "; ".join(part for part in both if part)


def account(result: ControllerResult) -> str:
    """Return what a controller was seen to do, and what was not tested."""
    done = f"tested: {', '.join(result.tested)}" if result.tested else ""
    rest = f"not tested: {', '.join(result.untested)}" if result.untested else ""
    return "; ".join(part for part in (done, rest) if part)


def heading(robot: RobotResult) -> str:
    """Return the robot of a test, after the launch file that starts it, with the arguments that this is given."""
    path, launch, bringup = shown(robot.linted.path), robot.linted.launch, robot.linted.bringup
    if not launch or shown(launch) == path:
        return path
    given = (f"{name}:={value}" for name, value in (bringup.arguments if bringup else ()))
    return f"{' '.join((shown(launch), *given))}: {path}"


def conditions(robot: RobotResult) -> str:
    """Return the controller files, the distro and what it is known from, and the engine of a test."""
    engine = f"{robot.engine}, {robot.seconds:.1f} s" if robot.engine else "not simulated"
    paired = "paired by its joints: the launch file loads no robot" if robot.paired else ""
    parts = [", ".join(shown(path) for path in robot.linted.controllers), _distro(robot), paired, engine]
    return "; ".join(part for part in parts if part)


def _distro(robot: RobotResult) -> str:
    """The distro whose manager was modelled, with the evidence for it; or those that are possible."""
    linted = robot.linted
    if linted.distro:
        named = not linted.distro_from or linted.distro_from.startswith("--")
        return linted.distro if named else f"{linted.distro} from {linted.distro_from}"
    if not robot.controllers or not robot.distro:
        return ""
    tested = f", tested as {robot.distro}" if robot.engine else ""
    return f"ROS distro unknown: {in_words(linted.distros)}{tested}"


def stages_reached(result: ControllerResult, ros: int | None) -> str:
    """Return the stages that a controller reached; it may fail at the last one. ROS 1 has no configuring."""
    reached = CONTROLLER_STAGES[: CONTROLLER_STAGES.index(result.stage) + 1]
    stages = " > ".join(stage.value for stage in reached if ros != 1 or stage is not Stage.CONFIGURE)
    return f"{stages} failed:" if result.verdict is Verdict.FAILED else stages


def summary(report: SmokeReport) -> str:
    """Return the number of controllers, in all and by verdict."""
    counts = [f"{report.count(verdict)} {verdict.value}" for verdict in Verdict if report.count(verdict)]
    total = sum(len(robot.controllers) for robot in report.robots)
    if not counts:
        return _what_next(report)
    rest = "; interrupted before all were tested" if report.is_interrupted else _only_reading(report)
    return f"{total} controller{'s' if total != 1 else ''}: {', '.join(counts)}{rest}"


def _only_reading(report: SmokeReport) -> str:
    """That nothing moved although all controllers passed, as they only read states, and what makes others."""
    tested = [(robot.linted.path, result.tested) for robot in report.robots for result in robot.controllers]
    if any(each != _READING for _, each in tested) or is_launch(tested[0][0]):
        return ""
    return _ONLY_READING + _PROPOSED.format(in_command(tested[0][0]))


def _what_next(report: SmokeReport) -> str:
    """Why nothing was tested, and the command with which something is: for the robot with the most joints that move."""
    every = (robot.linted for robot in report.robots if not robot.part_of)
    whole = {linted.path: linted for linted in every if not is_launch(linted.path)}
    if report.unused and whole:
        first, others = shown(report.unused[0]), len(report.unused) - 1
        which = f"'{first}'{f' (and {others} more)' if others else ''}"
        return _UNUSED.format(which, in_command(*whole) if len(whole) == 1 else "ROBOT", in_command(report.unused[0]))
    if not report.robots and not report.unused:
        return _NO_ROBOT
    if report.robots and not whole:
        if any(robot.needs for robot in report.robots):
            return _LACKING
        if report.instead:
            kind = _LAUNCHES if is_launch(report.instead[0]) else _DESCRIPTIONS
            return kind.format(shortened([shown(path) for path in report.instead], 2))
        if any(robot.robotless for robot in report.robots):
            return _NONE_STARTED
    most = max(whole.values(), key=lambda linted: linted.idle, default=None)
    return _NOTHING + (_PROPOSED.format(in_command(most.path)) if most else "")


def _text(report: SmokeReport) -> str:
    return "".join(piece.text for piece in text_pieces(report))


# -- for programs ----------------------------------------------------------------------------------------------------


def _json(report: SmokeReport) -> str:
    controllers = [
        {"robot": shown(robot.linted.path), **controller.to_json(), "engine": robot.engine}
        for robot in report.robots
        for controller in robot.controllers
    ]
    curves = [
        {"robot": shown(robot.linted.path), **curve._asdict()} for robot in report.robots for curve in robot.curves
    ]
    measured = [{"robot": shown(robot.linted.path), **_measured(c)} for robot in report.robots for c in robot.curves]
    data: dict[str, Any] = {
        **document(report.found),
        "controllers": controllers,
        "measurements": measured,
        "curves": curves,
        "interrupted": report.is_interrupted,
    }
    return as_json(data, indent=1) + "\n"


def _measured(curve: Curve) -> dict[str, Any]:
    """What a motion comes to, in the units of its curve: its end, its last error, and the largest one on the way."""
    errors = [did - wanted for wanted, did in zip(curve.commanded, curve.measured, strict=False)]
    return {
        "controller": curve.controller,
        "joint": curve.joint,
        "quantity": curve.quantity,
        "commanded": curve.commanded[-1] if curve.commanded else None,
        "measured": curve.measured[-1] if curve.measured else None,
        "error": round(errors[-1], 5) if errors else None,
        "largest_error": round(max(map(abs, errors)), 5) if errors else None,
    }


def _junit(report: SmokeReport) -> str:
    """A suite for each robot with a test case for each controller, followed by lint's suites of the other findings.

    A fault that keeps several controllers from being tested is one failure, and they are skipped.
    """
    from urdfctl.report.junit import suites_document

    cases = [_cases(robot) for robot in report.robots]
    lines = [line for robot, of_robot in zip(report.robots, cases, strict=True) for line in _suite(robot, of_robot)]
    everyone = [case for of_robot in cases for case in of_robot]
    counts = (len(everyone), *(sum(case.kind == kind for case in everyone) for kind in ("failure", "skipped")))
    if report.is_empty:
        lines += _empty_suite()
        counts = (counts[0] + 1, counts[1] + 1, counts[2])
    told = tuple(
        result.reason
        for robot in report.robots
        for result in robot.controllers
        if result.verdict is Verdict.FAILED and not result.blocked_by
    )
    others = [finding for finding in report.found.findings if not finding.message.endswith(told)]
    found = report.found._replace(findings=tuple(others))
    return suites_document(found, lines, (counts[0], counts[1], counts[2]))


def _empty_suite() -> list[str]:
    from urdfctl.report.junit import attributes_of

    counts = {"tests": 1, "failures": 1, "errors": 0, "skipped": 0}
    return [
        f"  <testsuite{attributes_of(name='controllers', **counts)}>",
        f"    <testcase{attributes_of(name='nothing was tested', classname='urdfctl smoke')}>",
        f"      <failure{attributes_of(message=_NOTHING, type='nothing tested')}/>",
        "    </testcase>",
        "  </testsuite>",
    ]


class _Case(NamedTuple):
    """A test case: its name and time in s, `failure`, `skipped` or nothing, and the text of that."""

    name: str
    seconds: float = 0.0
    kind: str = ""
    message: str = ""
    type: str = ""


def _cases(robot: RobotResult) -> list[_Case]:
    made = []
    for result in robot.controllers:
        if result.verdict is Verdict.SKIPPED or result.blocked_by:
            made.append(_Case(result.name, result.seconds, "skipped", result.reason))
        elif result.verdict is Verdict.FAILED:
            message = f"{result.stage.value}: {result.reason}"
            made.append(_Case(result.name, result.seconds, "failure", message, result.type or "no type"))
        else:
            made.append(_Case(result.name, result.seconds))
        made += [_Case(f"{result.name}: {what}", 0.0, "skipped", why) for what, why in result.untested.items()]
    return made


def _suite(robot: RobotResult, cases: Sequence[_Case]) -> Iterator[str]:
    from urdfctl.report.junit import attributes_of

    path = shown(robot.linted.path)
    counts = {
        "tests": len(cases),
        "failures": sum(case.kind == "failure" for case in cases),
        "errors": 0,
        "skipped": sum(case.kind == "skipped" for case in cases),
    }
    yield f"  <testsuite{attributes_of(name=f'{path} controllers', **counts, time=f'{robot.seconds:.3f}')}>"
    for case in cases:
        start = f"    <testcase{attributes_of(name=case.name, classname=path, file=path, time=f'{case.seconds:.3f}')}"
        if not case.kind:
            yield f"{start}/>"
            continue
        attributes = {"message": case.message, **({"type": case.type} if case.type else {})}
        yield f"{start}>"
        yield f"      <{case.kind}{attributes_of(**attributes)}/>"
        yield "    </testcase>"
    yield "  </testsuite>"


def _as_lint(name: str) -> Callable[[SmokeReport], str]:
    return lambda report: render(report.found, name)


SMOKE_FORMATS: dict[str, Callable[[SmokeReport], str]] = {
    "text": _text,
    "json": _json,
    "junit": _junit,
    "sarif": _as_lint("sarif"),
    "github": _as_lint("github"),
    "gitlab": _as_lint("gitlab"),
}


def report_of(
    robots: Sequence[RobotResult], findings: Sequence[Diagnostic], fail_on: Severity = Severity.ERROR
) -> SmokeReport:
    """Return a report of some smoke tests and their joined findings, which fail from a severity on."""
    targets = tuple(robot.linted for robot in robots)
    return SmokeReport(tuple(robots), Report(targets, tuple(findings), fail_on=fail_on))
