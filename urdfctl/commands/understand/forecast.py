"""`urdfctl explain --in FOLDER` without a log: what the robots of a folder will print when they are started."""

from __future__ import annotations

import json
import re
from collections.abc import Iterator, Sequence

from urdfctl.catalog.log_messages import LogMessage, log_messages
from urdfctl.commands.understand.explain_files import linted
from urdfctl.diagnostic import Diagnostic, Severity
from urdfctl.lint.results import TargetResult
from urdfctl.output.printing import visible
from urdfctl.report.common import relative, shown
from urdfctl.startup.records import NamedTuple

_KINDS = ("failure", "warning", "consequence")
_BLANK = re.compile(r"\{(\w+)[^{}]*\}")


class Expected(NamedTuple):
    """A message that will be printed.

    text: with names in capitals where the files do not say them.
    by: what prints it.
    finding: the error that causes it.
    """

    text: str
    by: str
    finding: Diagnostic


class ExpectedStart(NamedTuple):
    """What one start prints.

    name: the launch file, or the robot if none starts it.
    silent: the errors of which no message is known.
    """

    name: str
    distro: str
    messages: tuple[Expected, ...]
    silent: tuple[Diagnostic, ...]


def forecast(folder: str, distro: str | None, output_format: str) -> str:
    """Return what is expected to be printed at the starts in a folder, as text or json."""
    starts = list(_starts(linted(folder, distro)))
    return _as_json(starts) if output_format == "json" else "".join(_as_text(starts, folder))


def _starts(results: Sequence[TargetResult]) -> Iterator[ExpectedStart]:
    for result in results:
        if not result.links:
            continue
        errors = [one for one in result.outcome.diagnostics if one.severity is Severity.ERROR]
        found = {id(error): _expected(error, result) for error in errors}
        messages = {one.text: one for error in errors for one in found[id(error)]}
        silent = tuple(relative(error) for error in errors if not found[id(error)])
        name = shown(result.launch or result.path)
        yield ExpectedStart(name, result.distro or " or ".join(result.distros), tuple(messages.values()), silent)


def _expected(error: Diagnostic, result: TargetResult) -> list[Expected]:
    """The messages that an error causes first of all."""
    distros = {result.distro} if result.distro else {*result.distros}
    fitting = [
        message
        for message in log_messages()
        if message.kind in _KINDS and error.code in message.rules and distros & {*message.distros}
    ]
    best = min((_rank(message, error) for message in fitting), default=None)
    chosen = [message for message in fitting if _rank(message, error) == best]
    return [Expected(_filled(message.patterns[0], error), message.by, relative(error)) for message in chosen[:1]]


def _rank(message: LogMessage, error: Diagnostic) -> tuple[int, int]:
    return _KINDS.index(message.kind), message.rules.index(error.code)


def _filled(pattern: str, error: Diagnostic) -> str:
    """A message with the names that the finding says: `{joint}` is X where it says "joint 'X'"."""

    def name(blank: re.Match[str]) -> str:
        found = re.search(rf"\b{blank[1]} '([^']+)'", error.message)
        return found[1] if found else blank[1].upper()

    return _BLANK.sub(name, pattern)


def _as_text(starts: Sequence[ExpectedStart], folder: str) -> Iterator[str]:
    if not starts:
        yield f"no robot found in {visible(folder)}\n"
    for start in starts:
        silent = ", ".join(dict.fromkeys(one.code for one in start.silent))
        if not start.messages:
            yield f"{visible(start.name)} ({start.distro}): no message of an error is expected\n"
        else:
            yield f"{visible(start.name)} ({start.distro}) is expected to print:\n"
        for one in start.messages:
            at = one.finding.at
            yield f"\n  {visible(one.text)}\n    printed by {one.by}\n"
            yield f"    {visible(at.file)}:{at.line}:{at.column}: {one.finding.code} {visible(one.finding.message)}\n"
        if silent:
            yield f"\n  no message is known for {silent}\n"
        yield "\n"
    yield f"Next:\n  urdfctl lint {visible(folder)}  shows all findings in these files\n"


def _as_json(starts: Sequence[ExpectedStart]) -> str:
    data = [
        {
            "launch": start.name,
            "distro": start.distro,
            "messages": [{"text": one.text, "by": one.by, **_place(one.finding)} for one in start.messages],
            "silent": [_place(one) for one in start.silent],
        }
        for start in starts
    ]
    return json.dumps({"version": 1, "starts": data}, indent=1) + "\n"


def _place(finding: Diagnostic) -> dict[str, object]:
    at = finding.at
    return {"rule": finding.code, "file": at.file, "line": at.line, "column": at.column, "message": finding.message}
