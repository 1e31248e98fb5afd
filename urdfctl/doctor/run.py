"""Examine a recording of a running system beside the files that it should run."""

from __future__ import annotations

import os
from collections.abc import Collection, Iterable, Sequence

from urdfctl.config.settings import Settings
from urdfctl.doctor.checks import CHECKS
from urdfctl.doctor.examination import Ailment, Examination
from urdfctl.doctor.expectation import Expectation, expectation_work
from urdfctl.doctor.log import Log
from urdfctl.doctor.recording import Recording
from urdfctl.errors import UserError
from urdfctl.lint.job import run_on_targets
from urdfctl.lint.results import TargetResult
from urdfctl.load.target import Target
from urdfctl.startup.records import NamedTuple

Pair = tuple[Target, TargetResult]


class DoctorReport(NamedTuple):
    """What is wrong in a running system, causes before consequences, and what is fine.

    launch: the launch file that was taken for the one that was started, or the description; empty if none was found.
    robots: of the files, that it was compared with.
    """

    launch: str
    ailments: tuple[Ailment, ...]
    fine: tuple[str, ...]
    robots: tuple[Pair, ...] = ()


def doctor(recording: Recording, pairs: Sequence[Pair], settings: Settings, log: Log = Log()) -> DoctorReport:  # noqa: B008 (immutable)
    """Return what is wrong in a recorded system.

    pairs: the robots of the files, each with its result. log: what failed, as the system printed it.
    Raises UserError if the files have no robot that fits.
    """
    robots = _started(recording, pairs)
    expected = _expected(robots, settings)
    exam = Examination(recording, tuple(expected), log)
    found = [ailment for check in CHECKS for ailment in check(exam)]
    once = {(one.code, one.message): one for one in reversed(found)}
    ailments = tuple(one for one in found if once.get((one.code, one.message)) is one)
    ordered = sorted(ailments, key=lambda one: -one.severity.weight)
    launch = expected[0].launch or expected[0].robot
    return DoctorReport(launch, tuple(ordered), tuple(_fine(exam, ailments)), tuple(robots))


def _started(recording: Recording, pairs: Sequence[Pair]) -> list[Pair]:
    """The robots of the launch file that fits the recording best."""
    groups: dict[str, list[Pair]] = {}
    for target, result in pairs:
        if result.links:
            groups.setdefault(result.launch or "", []).append((target, result))
    if not groups:
        raise UserError("no robot here: run doctor in the folder of the package that was started, or name its files")
    best = max(groups, key=lambda launch: _fit(recording, groups[launch]))
    return groups[best] if best else groups[best][:1]


def _expected(chosen: Sequence[Pair], settings: Settings) -> list[Expectation]:
    """What the files say of each robot that is started."""
    roots = [os.path.dirname(os.path.abspath(result.path)) for _, result in chosen]
    details = [{"roots": roots[:1]}] * len(chosen)
    answers = run_on_targets(expectation_work, [target for target, _ in chosen], settings, details=details)
    found: list[Expectation] = []
    for answer, (_, result) in zip(answers, chosen, strict=True):
        if not isinstance(answer, dict):
            raise UserError(f"'{result.path}' cannot be read: {answer.reason}")
        if answer["expected"] is not None:
            found.append(Expectation.from_json(answer["expected"]))
    if not found:
        raise UserError(f"'{chosen[0][1].path}' cannot be expanded; to see why, run: urdfctl lint {chosen[0][1].path}")
    return found


def _fit(recording: Recording, group: Iterable[Pair]) -> tuple[bool, int, int]:
    """How well the launch file of some robots fits: by what it spawns and is running, then by what it starts at all."""
    running = {one.name for manager in recording.managers.values() for one in manager.controllers}
    spawned = {name.rpartition("/")[2] for _, result in group if result.bringup for name in result.bringup.spawned}
    is_launched = any(result.launch for _, result in group)
    return is_launched, len(spawned & running) - len(spawned - running), len(spawned)


# -- what is fine ------------------------------------------------------------------------------------------------------


def _fine(exam: Examination, ailments: Collection[Ailment]) -> Iterable[str]:
    for name in exam.managers:
        manager = exam.manager(name)
        if manager.answers:
            active = [one.name for one in manager.controllers if one.state == "active"]
            parts = [one.name for one in manager.hardware if one.state == "active"]
            hardware, controllers = _counted(parts, "active component"), _counted(active, "active controller")
            yield f"'{name}' answers, with {hardware} and {controllers}"
    for topic, states in exam.recording.joint_states.items():
        if states.received and not any(topic in one.message for one in ailments):
            yield f"{topic} comes at {states.rate:.0f} Hz with {_counted(sorted(states.names), 'joint')}"


def _counted(names: Collection[str], what: str) -> str:
    return f"{len(names)} {what}{'' if len(names) == 1 else 's'}"
