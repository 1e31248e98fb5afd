"""Commit a migration step by step: a reviewer reads one kind of change at a time, each with its authority."""

from __future__ import annotations

import os
from collections.abc import Iterator, Sequence

from urdfctl.errors import UserError
from urdfctl.migrate.engine import Migration
from urdfctl.migrate.report import ReportLine
from urdfctl.migrate.step import EntryKind, Step
from urdfctl.migrate.writing import Report, write_changes
from urdfctl.output.change import Change
from urdfctl.run.git import add_commit, has_changes, repository_of

_MOST_LINES = 30
_MENDED = "What lint finds after the other steps"


def check_repositories(folders: Sequence[str]) -> None:
    """Raise UserError unless all folders are in repositories without uncommitted changes."""
    for folder in folders:
        if has_changes(repository_of(folder)):
            raise UserError(f"'{folder}' is in a repository with changes that are not committed; commit them first")


def commit_steps(result: Migration, steps: Sequence[Step], target: str, report: Report | None) -> list[str]:
    """Write the changes of each step and commit them, then the report. Return what prevented it."""
    summaries = {step.name: step.summary for step in steps}
    for name, changes in result.steps:
        lines = [line for line in result.lines if line.step == name and line.kind is not EntryKind.FOR_YOU]
        title = f"Migrate to {target}: {summaries.get(name, _MENDED)} ({name})"
        problems = write_changes(changes, None) or _committed(changes, "\n".join([title, "", *_reasons(lines)]))
        if problems:
            return problems
    if report is None:
        return []
    problems = write_changes((), report)
    path = os.path.realpath(report[0])
    return problems or _committed((Change(path, None, report[1]),), f"Report the migration to {target}")


def _committed(changes: Sequence[Change], message: str) -> list[str]:
    """Commit files, in each repository those that are in it; return what prevented it."""
    by_repository: dict[str, list[str]] = {}
    try:
        for change in changes:
            folder = os.path.dirname(change.file)
            while not os.path.isdir(folder):  # its last file was deleted
                folder = os.path.dirname(folder)
            by_repository.setdefault(repository_of(folder), []).append(change.file)
        for repository, files in by_repository.items():
            add_commit(repository, files, message)
    except UserError as error:
        return [str(error)]
    return []


def _reasons(lines: Sequence[ReportLine]) -> Iterator[str]:
    """What a step did, each kind once, with its authority."""
    found = dict.fromkeys((line.message, line.authority) for line in lines)
    for message, authority in list(found)[:_MOST_LINES]:
        yield f"- {message}{f' ({authority})' if authority else ''}"
    if len(found) > _MOST_LINES:
        yield f"- and {len(found) - _MOST_LINES} more"
