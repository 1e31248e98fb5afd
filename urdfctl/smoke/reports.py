"""The report formats of smoke tests: those of lint, with the result of each controller."""

from __future__ import annotations

from collections.abc import Callable, Iterator, Sequence

from urdfctl.diagnostic import Diagnostic
from urdfctl.model.stage import CONTROLLER_STAGES, Stage
from urdfctl.report import render
from urdfctl.report.common import Report, as_json, shown, visible
from urdfctl.report.json_report import document
from urdfctl.report.text import Piece, pieces
from urdfctl.smoke.results import ControllerResult, Smoked, Verdict
from urdfctl.startup.hints import Any
from urdfctl.startup.records import NamedTuple

_STYLES = {
    Verdict.PASSED: "bold green",
    Verdict.FAILED: "bold red",
    Verdict.WARNED: "bold yellow",
    Verdict.SKIPPED: "dim",
}


_NOTHING = "nothing was tested: no controllers found; name their file with --controllers"


class SmokeReport(NamedTuple):
    """The results of a run: the smoke test of each robot, and the findings of all as a report of lint."""

    smoked: tuple[Smoked, ...]
    found: Report
    allow_empty: bool = False

    @property
    def is_empty(self) -> bool:
        """Whether no controller was tested, and that is an error."""
        return not self.allow_empty and not any(robot.controllers for robot in self.smoked)

    def count(self, verdict: Verdict) -> int:
        """Return the number of controllers with a verdict."""
        return sum(robot.count(verdict) for robot in self.smoked)


def render_smoke(report: SmokeReport, name: str) -> str:
    """Return the report in one of `SMOKE_FORMATS`."""
    return SMOKE_FORMATS[name](report)


# -- text ------------------------------------------------------------------------------------------------------------


def text_pieces(report: SmokeReport) -> Iterator[Piece]:
    """Yield the lines of the robots with their controllers, the findings, and a summary."""
    for robot in report.smoked:
        yield from robot_pieces(robot)
    yield from pieces(report.found)
    yield Piece(visible(summary(report)) + "\n", "bold")


def robot_pieces(robot: Smoked) -> Iterator[Piece]:
    """Yield a line for a robot, and one for each of its controllers with the stages that it passed."""
    yield Piece(visible(f"{shown(robot.linted.path)} ({how(robot)})") + "\n", "bold")
    if not robot.controllers:
        yield Piece("  no controllers are declared for this robot\n")
    width = max((len(controller.name) for controller in robot.controllers), default=0)
    for controller in robot.controllers:
        yield Piece(f"  {visible(controller.name).ljust(width)}  ")
        yield Piece(controller.verdict.value.ljust(8), _STYLES[controller.verdict])
        told = controller.reason or account(controller)
        reason = f"  {told}" if told else ""
        yield Piece(f" {steps(controller, robot.linted.ros)}{visible(reason)}\n")


def account(result: ControllerResult) -> str:
    """Return what a controller was seen to do, and what was not tested."""
    done = f"tested: {', '.join(result.tested)}" if result.tested else ""
    rest = f"not tested: {', '.join(result.untested)}" if result.untested else ""
    return "; ".join(part for part in (done, rest) if part)


def how(robot: Smoked) -> str:
    """Return the distro, the controller files and the engine of a test."""
    parts = [robot.linted.distro or "", *(shown(path) for path in robot.linted.controllers)]
    parts.append(f"{robot.engine}, {robot.seconds:.1f} s" if robot.engine else "not simulated")
    return ", ".join(part for part in parts if part)


def steps(result: ControllerResult, ros: int | None) -> str:
    """Return the stages of a controller, with a mark before the one at which it failed. ROS 1 has no configuring."""
    reached = CONTROLLER_STAGES[: CONTROLLER_STAGES.index(result.stage) + 1]
    names = [stage.value for stage in reached if ros != 1 or stage is not Stage.CONFIGURE]
    if result.verdict is Verdict.FAILED:
        names[-1] = f"!{names[-1]}"
    return " > ".join(names)


def summary(report: SmokeReport) -> str:
    """Return the number of controllers, in all and by verdict."""
    counts = [f"{report.count(verdict)} {verdict.value}" for verdict in Verdict if report.count(verdict)]
    total = sum(len(robot.controllers) for robot in report.smoked)
    return f"{total} controller{'s' if total != 1 else ''}: {', '.join(counts)}" if counts else _NOTHING


def _text(report: SmokeReport) -> str:
    return "".join(piece.text for piece in text_pieces(report))


# -- for programs ----------------------------------------------------------------------------------------------------


def _json(report: SmokeReport) -> str:
    controllers = [
        {"robot": shown(robot.linted.path), **controller.to_json(), "engine": robot.engine}
        for robot in report.smoked
        for controller in robot.controllers
    ]
    data: dict[str, Any] = {**document(report.found), "controllers": controllers}
    return as_json(data, indent=1) + "\n"


def _junit(report: SmokeReport) -> str:
    """A suite for each robot with a test case for each controller, followed by lint's suites of the findings."""
    from urdfctl.report.junit import suites_document

    lines = [line for robot in report.smoked for line in _suite(robot)]
    failed, skipped = (report.count(verdict) for verdict in (Verdict.FAILED, Verdict.SKIPPED))
    rest = sum(len(untested(robot)) for robot in report.smoked)
    total = sum(len(robot.controllers) for robot in report.smoked) + rest
    skipped += rest
    if report.is_empty:
        lines += _empty_suite()
        total, failed = total + 1, failed + 1
    return suites_document(report.found, lines, (total, failed, skipped))


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


def _suite(robot: Smoked) -> Iterator[str]:
    from urdfctl.report.junit import attributes_of

    path = shown(robot.linted.path)
    rest = untested(robot)
    counts = {
        "tests": len(robot.controllers) + len(rest),
        "failures": robot.count(Verdict.FAILED),
        "errors": 0,
        "skipped": robot.count(Verdict.SKIPPED) + len(rest),
    }
    yield f"  <testsuite{attributes_of(name=f'{path} controllers', **counts)}>"
    for controller in robot.controllers:
        yield f"    <testcase{attributes_of(name=controller.name, classname=path, file=path)}>"
        if controller.verdict is Verdict.FAILED:
            message = f"{controller.stage.value}: {controller.reason}"
            yield f"      <failure{attributes_of(message=message, type=controller.type or 'no type')}/>"
        elif controller.verdict is Verdict.SKIPPED:
            yield f"      <skipped{attributes_of(message=controller.reason)}/>"
        yield "    </testcase>"
    for name, why in rest:
        yield f"    <testcase{attributes_of(name=name, classname=path, file=path)}>"
        yield f"      <skipped{attributes_of(message=why)}/>"
        yield "    </testcase>"
    yield "  </testsuite>"


def untested(robot: Smoked) -> list[tuple[str, str]]:
    """Return what was not tested of each controller, as a name and the reason."""
    return [(f"{result.name}: {what}", why) for result in robot.controllers for what, why in result.untested.items()]


def _as_lint(name: str) -> Callable[[SmokeReport], str]:
    return lambda report: render(report.found, name)


SMOKE_FORMATS: dict[str, Callable[[SmokeReport], str]] = {
    "text": _text,
    "json": _json,
    "junit": _junit,
    "sarif": _as_lint("sarif"),
    "github": _as_lint("github"),
}


def report_of(smoked: Sequence[Smoked], findings: Sequence[Diagnostic]) -> SmokeReport:
    """Return a report of some smoke tests and their joined findings."""
    return SmokeReport(tuple(smoked), Report(tuple(robot.linted for robot in smoked), tuple(findings)))
