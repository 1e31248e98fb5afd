"""`urdfctl explain LOG --in FOLDER`: run the rules behind each cause on the robots of a folder."""

from __future__ import annotations

import os
from collections.abc import Sequence

from urdfctl.commands.progress import with_progress
from urdfctl.config.file import config_for, with_environ
from urdfctl.config.settings import Settings, passed_on, settings_with
from urdfctl.diagnostic import Diagnostic, Severity
from urdfctl.lint.results import TargetResult
from urdfctl.lint.run import LintRequest, lint, merge
from urdfctl.lint.selection import Selection, selection_with
from urdfctl.logs.digest import Digest, KnownMessage
from urdfctl.logs.evidence import CheckedFolder, FoundCause, RelatedPlace, with_findings
from urdfctl.report.common import relative

_MOST_RELATED = 2


def checked(digest: Digest, folder: str, distro: str | None = None) -> tuple[Digest, CheckedFolder]:
    """Return the digest with the places where rules find its causes in a folder.

    Of each kind, messages with such a place come first. distro: by default the one that the log shows, if it shows one.
    Raises UserError if there is nothing to lint.
    """
    findings = [relative(finding) for finding in _findings(folder, distro or digest.distro or None)]
    found = [_cause(one) for one in findings]
    known = [_with(entry, found) for entry in digest.known]
    kinds = list(dict.fromkeys(entry.kind for entry in known))
    known.sort(key=lambda entry: (kinds.index(entry.kind), not entry.reading.is_found))
    return digest._replace(known=tuple(known)), CheckedFolder(folder, _others(findings, known))


def _cause(finding: Diagnostic) -> FoundCause:
    at, fix = finding.at, finding.fix
    related = tuple(
        RelatedPlace(note.at.file, note.at.line, note.at.column, note.message) for note in finding.notes if note.at
    )
    return FoundCause(
        file=at.file,
        line=at.line,
        column=at.column,
        code=finding.code,
        message=finding.message,
        fixable=bool(fix and fix.safe),
        likely=bool(fix and fix.edits and not fix.safe),
        fix=fix.title if fix else "",
        related=related[:_MOST_RELATED],
    )


def linted(folder: str, distro: str | None) -> list[TargetResult]:
    """Return what lint finds in each robot of a folder. UserError if there is nothing to lint."""
    return list(lint(_request(folder, distro), watch=with_progress).robots)


def _findings(folder: str, distro: str | None) -> list[Diagnostic]:
    """The findings of lint in a folder."""
    request = _request(folder, distro)
    return merge(lint(request, watch=with_progress).results, request)


def _request(folder: str, distro: str | None) -> LintRequest:
    config = with_environ(config_for((folder,)), os.environ)
    settings = settings_with(config, Settings(distro=distro, environ=passed_on(os.environ)))
    return LintRequest((folder,), config, settings, selection_with(config, Selection()))


def _with(known: KnownMessage, found: Sequence[FoundCause]) -> KnownMessage:
    if known.kind == "harmless":
        return known
    values = {value for values in known.values for value in values.values()}
    return known._replace(reading=with_findings(known.reading, found, values))


def _others(findings: Sequence[Diagnostic], known: Sequence[KnownMessage]) -> int:
    """The number of errors that no message has as a cause."""
    codes = {found.code for entry in known for cause in entry.reading.causes for found in cause.found}
    return sum(one.severity is Severity.ERROR and one.code not in codes for one in findings)
