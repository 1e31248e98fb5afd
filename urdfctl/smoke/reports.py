"""The forms in which smoke tests are told: lint's, with what became of each controller."""

from __future__ import annotations

from collections.abc import Callable, Iterator, Sequence

from urdfctl.diagnostic import Diagnostic
from urdfctl.hints import Any
from urdfctl.record import NamedTuple
from urdfctl.report import render
from urdfctl.report.common import Report, as_json, shown, visible
from urdfctl.report.json_report import document
from urdfctl.report.text import Piece, pieces
from urdfctl.smoke.results import STEPS, ControllerResult, Smoked, Step, Verdict

_STYLES = {
    Verdict.PASSED: "bold green",
    Verdict.FAILED: "bold red",
    Verdict.WARNED: "bold yellow",
    Verdict.SKIPPED: "dim",
}


class SmokeReport(NamedTuple):
    """What a run of smoke tests gave: each robot's, and the findings of all in the form of lint's report."""

    smoked: tuple[Smoked, ...]
    found: Report

    def count(self, verdict: Verdict) -> int:
        """How many controllers have a verdict."""
        return sum(one.count(verdict) for one in self.smoked)


def written(report: SmokeReport, name: str) -> str:
    """The report in one of the forms of `SMOKE_FORMATS`."""
    return SMOKE_FORMATS[name](report)


# -- text ------------------------------------------------------------------------------------------------------------


def text_pieces(report: SmokeReport) -> Iterator[Piece]:
    """The lines of the controllers, the findings, and a summary."""
    for one in report.smoked:
        yield from robot_pieces(one)
    yield from pieces(report.found)
    yield Piece(visible(summary(report)) + "\n", "bold")


def robot_pieces(one: Smoked) -> Iterator[Piece]:
    """A robot, and a line for each of its controllers: the steps it went through, as a manager's log has them."""
    yield Piece(visible(f"{shown(one.linted.path)} ({how(one)})") + "\n", "bold")
    if not one.controllers:
        yield Piece("  no controller is declared for it\n")
    width = max((len(result.name) for result in one.controllers), default=0)
    for result in one.controllers:
        yield Piece(f"  {visible(result.name).ljust(width)}  ")
        yield Piece(result.verdict.value.ljust(8), _STYLES[result.verdict])
        reason = f"  {result.reason}" if result.reason else ""
        yield Piece(f" {steps(result, one.linted.ros)}{visible(reason)}\n")


def how(one: Smoked) -> str:
    """The distro, the controllers' files and the engine of a test."""
    parts = [one.linted.distro or "", *(shown(path) for path in one.linted.controllers)]
    parts.append(f"{one.engine}, {one.seconds:.1f} s" if one.engine else "nothing moved")
    return ", ".join(part for part in parts if part)


def steps(result: ControllerResult, ros: int | None) -> str:
    """The steps that a controller passed, with a mark before the one that it failed at. ROS 1 configures nothing."""
    names = [step.value for step in STEPS[: STEPS.index(result.stage) + 1] if ros != 1 or step is not Step.CONFIGURE]
    if result.verdict is Verdict.FAILED:
        names[-1] = f"!{names[-1]}"
    return " > ".join(names)


def summary(report: SmokeReport) -> str:
    """How many controllers have which verdict."""
    counts = [f"{report.count(verdict)} {verdict.value}" for verdict in Verdict if report.count(verdict)]
    total = sum(len(one.controllers) for one in report.smoked)
    return f"{total} controller{'s' if total != 1 else ''}: {', '.join(counts)}" if counts else "no controllers"


def _text(report: SmokeReport) -> str:
    return "".join(piece.text for piece in text_pieces(report))


# -- for machines ----------------------------------------------------------------------------------------------------


def _json(report: SmokeReport) -> str:
    controllers = [
        {"robot": shown(one.linted.path), **result.to_json(), "engine": one.engine}
        for one in report.smoked
        for result in one.controllers
    ]
    whole: dict[str, Any] = {**document(report.found), "controllers": controllers}
    return as_json(whole, indent=1) + "\n"


def _junit(report: SmokeReport) -> str:
    """A suite for each robot with a test case for each controller, and lint's suites of the findings."""
    from urdfctl.report.junit import suites_document

    lines = [line for one in report.smoked for line in _suite(one)]
    counts = [report.count(verdict) for verdict in (Verdict.FAILED, Verdict.SKIPPED)]
    total = sum(len(one.controllers) for one in report.smoked)
    return suites_document(report.found, lines, (total, counts[0], counts[1]))


def _suite(one: Smoked) -> Iterator[str]:
    from urdfctl.report.junit import attributes_of

    path = shown(one.linted.path)
    counts = {
        "tests": len(one.controllers),
        "failures": one.count(Verdict.FAILED),
        "errors": 0,
        "skipped": one.count(Verdict.SKIPPED),
    }
    yield f"  <testsuite{attributes_of(name=f'{path} controllers', **counts)}>"
    for result in one.controllers:
        yield f"    <testcase{attributes_of(name=result.name, classname=path, file=path)}>"
        if result.verdict is Verdict.FAILED:
            message = f"{result.stage.value}: {result.reason}"
            yield f"      <failure{attributes_of(message=message, type=result.type or 'no type')}/>"
        elif result.verdict is Verdict.SKIPPED:
            yield f"      <skipped{attributes_of(message=result.reason)}/>"
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
}


def report_of(smoked: Sequence[Smoked], findings: Sequence[Diagnostic]) -> SmokeReport:
    """A report of some smoke tests and their joined findings."""
    return SmokeReport(tuple(smoked), Report(tuple(one.linted for one in smoked), tuple(findings)))
