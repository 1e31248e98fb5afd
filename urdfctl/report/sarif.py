"""Report as SARIF 2.1.0, for code scanning and editors.

Suppressed findings and those in a baseline are left out: GitHub shows suppressed results as open alerts
(github/codeql-action issue 1230).
"""

from __future__ import annotations

import os
import re
from collections.abc import Sequence
from functools import lru_cache
from typing import Any
from urllib.parse import quote

from urdfctl import __version__
from urdfctl.diagnostic import CallStep, Diagnostic, Location, Repair, Severity
from urdfctl.fault import Fault
from urdfctl.lint.results import Report
from urdfctl.logs.printed import printed_because_of
from urdfctl.report.common import as_json, as_text, relative
from urdfctl.report.fingerprint import fingerprints
from urdfctl.report.words import fix_in_words, notes
from urdfctl.rules import all_faults
from urdfctl.rules.prose import as_markdown

_SCHEMA = "https://docs.oasis-open.org/sarif/sarif/v2.1.0/errata01/os/schemas/sarif-schema-2.1.0.json"
_ROOT = "%SRCROOT%"
_LEVELS = {Severity.ERROR: "error", Severity.WARNING: "warning", Severity.INFO: "note"}
_LINK = r"\[(?=[^\]]*\]\()"

Json = dict[str, Any]


def render(report: Report) -> str:
    """Return the report as a SARIF log with one run."""
    return as_json({"$schema": _SCHEMA, "version": "2.1.0", "runs": [_run(report)]}, indent=1) + "\n"


def _run(report: Report) -> Json:
    codes = sorted({diagnostic.code for diagnostic in report.findings})
    marks = fingerprints(report.findings, os.getcwd())
    pairs = zip(map(relative, report.findings), marks, strict=True)
    crashed = any(target.outcome.crashed for target in report.targets)
    return {
        "tool": {"driver": _driver(codes, report.findings)},
        "invocations": [{"executionSuccessful": not crashed}],
        "originalUriBaseIds": {_ROOT: {"uri": _uri(os.getcwd().rstrip(os.sep) + os.sep)}},
        "columnKind": "unicodeCodePoints",
        "artifacts": [{"location": _artifact(path)} for path in _files(report)],
        "results": [_result(diagnostic, codes.index(diagnostic.code), mark) for diagnostic, mark in pairs],
    }


def _files(report: Report) -> list[str]:
    """Return the files that were read and those with findings, sorted."""
    read = {path for target in report.targets for path in target.files}
    return sorted(read | {diagnostic.at.file for diagnostic in report.findings})


# -- the rules -------------------------------------------------------------------------------------------------------


def _driver(codes: Sequence[str], findings: Sequence[Diagnostic]) -> Json:
    known = {fault.code: fault for fault in all_faults()}
    names = {diagnostic.code: diagnostic.name for diagnostic in findings}
    return {
        "name": "urdfctl",
        "version": __version__,
        "semanticVersion": __version__,
        "rules": [_rule(known[code]) if code in known else {"id": code, "name": names[code]} for code in codes],
    }


def _rule(fault: Fault) -> Json:
    printed = "; ".join(message.text for message in printed_because_of(fault.code))
    told = f"Printed in the log because of it: {printed}" if printed else ""
    paragraphs = [fault.summary, fault.why, told, f"Authority: {fault.authority}"]
    described = {"fullDescription": _message(fault.why)} if fault.why else {}
    return {
        "id": fault.code,
        "name": fault.name,
        **({"helpUri": fault.url} if fault.url else {}),
        "shortDescription": _message(fault.summary),
        **described,
        "defaultConfiguration": {"level": _LEVELS[fault.severity]},
        "help": {
            "text": "\n\n".join(part for part in paragraphs if part),
            "markdown": "\n\n".join([*(as_markdown(part) for part in paragraphs if part), *_examples(fault)]),
        },
        "properties": {"tags": ["ros", "urdf"], "distros": list(fault.distros)},
    }


def _examples(fault: Fault) -> list[str]:
    return [
        f"**{word}**, `{name}`:\n\n```\n{text.translate({0xAB: None, 0xBB: None}).rstrip()}\n```"
        for word, examples in (("Wrong", fault.bad), ("Right", fault.good))
        for example in examples[:1]
        for name, text in example.files.items()
    ]


# -- the findings ----------------------------------------------------------------------------------------------------


def _result(diagnostic: Diagnostic, rule: int, mark: str) -> Json:
    result: Json = {
        "ruleId": diagnostic.code,
        "ruleIndex": rule,
        "level": _LEVELS[diagnostic.severity],
        "message": _message(_full_message(diagnostic)),
        "locations": [_location(diagnostic.at)],
        "partialFingerprints": {"urdfctl/v1": mark},
    }
    placed = [(note.message, note.at) for note in (*diagnostic.also, *diagnostic.notes) if note.at]
    if placed:
        result["relatedLocations"] = [{"id": n, **_location(at, text)} for n, (text, at) in enumerate(placed, 1)]
    if diagnostic.expanded_from:
        result["codeFlows"] = [_flow(chain, diagnostic) for chain in diagnostic.expanded_from]
    if diagnostic.fix and diagnostic.fix.edits:
        result["fixes"] = [_fix(diagnostic.fix)]
    return result


def _full_message(diagnostic: Diagnostic) -> str:
    """Return the message, the notes without a location, and the fix."""
    bare = diagnostic._replace(expanded_from=(), notes=tuple(note for note in diagnostic.notes if not note.at))
    lines = [diagnostic.message, *(f"note: {note}" for note in notes(bare))]
    return "\n".join([*lines, f"fix: {fix_in_words(diagnostic.fix)}"] if diagnostic.fix else lines)


def _flow(chain: Sequence[CallStep], diagnostic: Diagnostic) -> Json:
    """Return the steps from the outermost call to the finding."""
    steps = [
        {"location": _location(_place(step), _call(step)), "nestingLevel": depth}
        for depth, step in enumerate(reversed(chain))
    ]
    end = {"location": _location(diagnostic.at, diagnostic.message), "nestingLevel": len(chain)}
    return {"threadFlows": [{"locations": [*steps, end]}]}


def _place(step: CallStep) -> Location:
    return Location(file=step.file, line=step.line, column=step.column, end_line=0, end_column=0, start=0, end=0)


def _call(step: CallStep) -> str:
    kind, _, name = step.what.partition(" ")
    if kind == "macro":
        return f"macro '{name}' is called"
    if kind == "uncalled":
        return f"{name}, which is not called in these files"
    return "a block is inserted" if kind == "block" else f"'{name}' is included"


def _fix(fix: Repair) -> Json:
    files = list(dict.fromkeys(edit.file for edit in fix.edits))
    return {
        "description": _message(fix.title),
        "artifactChanges": [
            {
                "artifactLocation": _artifact(file),
                "replacements": [
                    {"deletedRegion": _region(edit.at), "insertedContent": {"text": as_text(edit.text)}}
                    for edit in fix.edits
                    if edit.file == file
                ],
            }
            for file in files
        ],
    }


# -- places and words ------------------------------------------------------------------------------------------------


def _location(at: Location, message: str | None = None) -> Json:
    physical = {"artifactLocation": _artifact(at.file), "region": _region(at)}
    return {"physicalLocation": physical, **({"message": _message(message)} if message is not None else {})}


def _region(at: Location) -> Json:
    """Return a region. A call has only a start."""
    start = {"startLine": at.line, "startColumn": at.column}
    if not at.end_line:
        return start
    end = {"endLine": at.end_line, "endColumn": at.end_column}
    return {**start, **end, "byteOffset": at.start, "byteLength": at.end - at.start}


def _artifact(path: str) -> Json:
    inside = os.path.relpath(path) if _is_inside(path) else None
    return {"uri": _uri(path)} if inside is None else {"uri": _uri(inside), "uriBaseId": _ROOT}


def _is_inside(path: str) -> bool:
    return os.path.abspath(path).startswith(os.getcwd().rstrip(os.sep) + os.sep)


@lru_cache
def _uri(path: str) -> str:
    """Return a path as a URI: absolute if the path is absolute."""
    quoted = quote(os.fsencode(path.replace(os.sep, "/")))
    if not os.path.isabs(path):
        return quoted
    return f"file://{quoted}" if quoted.startswith("/") else f"file:///{quoted}"


def _message(text: str) -> Json:
    """Return a SARIF message. Brackets are escaped, so that names from files do not become links."""
    return {"text": re.sub(_LINK, r"\\[", as_text(text))}
