"""Judge a migration: reasons against it, from the findings and the robots before and after."""

from __future__ import annotations

import os
from collections import Counter
from collections.abc import Iterator, Mapping, Sequence

from urdfctl.diagnostic import Diagnostic, Severity
from urdfctl.load.loader import LoadedTarget
from urdfctl.migrate.packages import Linted
from urdfctl.migrate.trial.kinematics import commanded_twice, differences, kinematics
from urdfctl.startup.records import NamedTuple

_MIGRATION = "UC7"
"""The rules about what is old but still works in the target, and about what a migration leaves to a person."""

RobotKey = tuple[str, tuple[tuple[str, str], ...]]
"""The file and the arguments of a robot."""
Kinematics = Mapping[RobotKey, Mapping[str, object]]
"""The kinematics of each whole robot."""


class Objection(NamedTuple):
    """A reason against a migration.

    kind: what identifies it in another attempt.
    message: what would be wrong.
    file: the file that it is in.
    files: the files of the robot that it is about.
    finding: what lint finds, if it is about that.
    """

    kind: tuple[str, str]
    message: str
    file: str
    files: frozenset[str]
    finding: Diagnostic | None = None

    @property
    def is_warning(self) -> bool:
        """Whether it is a warning of lint, which is better than an error."""
        return self.finding is not None and self.finding.severity is Severity.WARNING


class Before(NamedTuple):
    """The state before a migration.

    codes: the findings' codes for the distro to migrate from, and for the target.
    by_file: how many findings of a code each file has for the target.
    kinematics: those of the robots.
    twice: the joints that a robot commands in several places, by the robot.
    """

    codes: frozenset[str]
    by_file: Counter[tuple[str, str]]
    kinematics: Kinematics
    twice: Mapping[RobotKey, frozenset[str]]


def findings_by_file(linted: Linted) -> Counter[tuple[str, str]]:
    """Return how many different findings of a code there are in each file, by code and real path."""
    found = {
        (finding.code, os.path.realpath(finding.at.file), finding.at.start)
        for _, result in linted
        for finding in result.outcome.diagnostics
    }
    return Counter((code, file) for code, file, _ in found)


def before(source: Linted, target: Linted, robots: Sequence[LoadedTarget]) -> Before:
    """Return the state before a migration, from its findings for the distro to migrate from and for the target."""
    codes = {finding.code for _, result in (*source, *target) for finding in result.outcome.diagnostics}
    return Before(frozenset(codes), findings_by_file(target), kinematics_of(robots), _twice_in(robots))


def _twice_in(robots: Sequence[LoadedTarget]) -> dict[RobotKey, frozenset[str]]:
    return {
        (loaded.project.path, loaded.arguments): commanded_twice(loaded.project.robot)
        for loaded in robots
        if loaded.project.robot is not None
    }


def kinematics_of(robots: Sequence[LoadedTarget]) -> Kinematics:
    """Return the kinematics of those robots that are complete."""
    return {
        (loaded.project.path, loaded.arguments): kinematics(loaded.project.robot)
        for loaded in robots
        if loaded.project.robot is not None and loaded.project.complete and not loaded.project.library
    }


def objections(
    state: Before,
    linted: Linted,
    robots: Sequence[LoadedTarget],
    claims: Mapping[str, frozenset[str]],
    moved: frozenset[str],
) -> Iterator[Objection]:
    """Yield the reasons against a migration.

    linted: the findings after it, for the target.
    robots: those after it.
    claims: the codes of which each edited file must have fewer findings.
    moved: the links and joints whose kinematics the report says to change.
    """
    yield from _of_findings(state, linted)
    after = findings_by_file(linted)
    for file, codes in claims.items():
        for code in codes:
            known = state.by_file[code, os.path.realpath(file)]
            if known and after[code, os.path.realpath(file)] >= known:
                yield Objection((code, file), f"{code} would not be gone", file, frozenset({file}))
    yield from _of_robots(state, robots, moved)


def _of_robots(state: Before, robots: Sequence[LoadedTarget], moved: frozenset[str]) -> Iterator[Objection]:
    """A robot that could be expanded still can be, with the same links and joints, and commands no joint twice."""
    now, twice = kinematics_of(robots), _twice_in(robots)
    for loaded in robots:
        key = loaded.project.path, loaded.arguments
        read = frozenset(loaded.sources)
        old, new = state.kinematics.get(key), now.get(key)
        if old is not None and new is None:
            yield Objection(("expands", key[0]), "the robot would not be expanded any more", key[0], read)
        changed = [name for name in differences(old or {}, new or {}) if name.partition(" ")[2] not in moved]
        if changed and old is not None and new is not None:
            yield Objection((changed[0], key[0]), f"{changed[0]} of the robot would change", key[0], read)
        for joint in sorted(twice.get(key, frozenset()) - state.twice.get(key, frozenset())):
            message = f"joint '{joint}' would have commands in two places of <ros2_control>"
            yield Objection((f"commands {joint}", key[0]), message, key[0], read)


def _of_findings(state: Before, linted: Linted) -> Iterator[Objection]:
    """No kind of error or warning may be new, except that the target has something which a later distro drops."""
    for _, result in linted:
        for finding in result.outcome.diagnostics:
            is_known = finding.code in state.codes or finding.code.startswith(_MIGRATION)
            if not is_known and finding.severity is not Severity.INFO:
                file = finding.at.file
                files = frozenset({file, *result.files})
                yield Objection((finding.code, file), _said(finding), file, files, finding)


def errors_in(linted: Linted) -> dict[tuple[str, str], set[str]]:
    """Return the files of the targets that each error is found in, by its code and file; all are real paths."""
    errors: dict[tuple[str, str], set[str]] = {}
    for _, result in linted:
        for one in result.outcome.diagnostics:
            if one.severity is Severity.ERROR:
                files = errors.setdefault((one.code, os.path.realpath(one.at.file)), set())
                files |= {os.path.realpath(file) for file in (one.at.file, *result.files)}
    return errors


def _said(finding: Diagnostic) -> str:
    return f"it would cause {finding.code} at {finding.at.file}:{finding.at.line} ({finding.message})"
