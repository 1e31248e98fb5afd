"""`urdfctl smoke --engine ros2`: the verdict of the real controller manager with mock hardware."""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Sequence

from urdfctl.doctor.collecting import run_mock_manager
from urdfctl.doctor.trial import RealResult, RealVerdict, real_results
from urdfctl.errors import UserError
from urdfctl.output.printing import print_text, visible
from urdfctl.output.writing import write_file
from urdfctl.report.common import as_json, shown
from urdfctl.smoke.run import RobotTest

_FORMATS = ("text", "json")
_NOTHING_TESTED = 5


def tested_by_ros2(tests: Iterable[RobotTest], outputs: Sequence[tuple[str, str | None]]) -> int:
    """Report what the real manager says of each robot; return the exit status: 1 if anything does not start."""
    for name, _ in outputs:
        if name not in _FORMATS:
            raise UserError(f"--engine ros2 writes {' or '.join(_FORMATS)}, not {name}")
    found = [
        result
        for test in tests
        if test.result.controllers
        for result in real_results(test.target, test.settings, test.result, run_mock_manager)
    ]
    for name, file in outputs:
        text = _json(found) if name == "json" else "".join(f"{visible(line)}\n" for line in _lines(found))
        if file is not None:
            write_file(file, text, force=True)
        else:
            print_text(text)
    if not found:
        return _NOTHING_TESTED
    return int(any(result.is_refused for result in found))


def _lines(results: Sequence[RealResult]) -> Iterator[str]:
    for result in results:
        yield f"{shown(result.path)}: ros2_control_node as '{result.manager}', with mock hardware"
        if result.reason:
            yield f"  failed  it does not answer: {result.reason}"
            yield from _fix(result.fix)
        for verdict in result.verdicts:
            yield from _of_controller(verdict)
    if not results:
        yield "no controllers to test"


def _of_controller(verdict: RealVerdict) -> Iterator[str]:
    if not verdict.is_refused:
        yield f"  passed  {verdict.controller}: up to {verdict.wanted}"
    else:
        reason = verdict.reason or "the log says nothing of it"
        yield f"  failed  {verdict.controller} at {verdict.refused_at}: {reason}"
        yield from _fix(verdict.fix)
    if verdict.differs:
        simulated = f"refuses it at {verdict.simulated}" if verdict.simulated else "starts it"
        yield f"  differs {verdict.controller}: the simulated manager {simulated}; please report it to urdfctl"


def _fix(fix: str) -> Iterator[str]:
    if fix:
        yield f"          fix: {fix}"


def _json(results: Iterable[RealResult]) -> str:
    robots = [
        {
            "robot": shown(result.path),
            "manager": result.manager,
            "reason": result.reason,
            "controllers": [
                {**verdict._asdict(), "refused_at": verdict.refused_at, "differs": verdict.differs}
                for verdict in result.verdicts
            ],
        }
        for result in results
    ]
    return as_json({"version": 1, "engine": "ros2", "robots": robots}, 1) + "\n"
