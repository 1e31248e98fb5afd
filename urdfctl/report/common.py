"""Helpers for all output formats: paths, escaping, JSON."""

from __future__ import annotations

import os
import re

from urdfctl.diagnostic import Diagnostic, Location, Remark, Severity
from urdfctl.lint.results import Report, TargetResult
from urdfctl.output.printing import INVISIBLE
from urdfctl.source.disk.files import is_launch, is_yaml


def about_missing_packages(names: tuple[str, ...]) -> str:
    """The line about packages that are not in the workspace; empty where there are none."""
    if not names:
        return ""
    first, last = ", ".join(names[:-1]), names[-1]
    if not first:
        return f"1 package is not in this workspace: {last}; what it defines is not checked"
    return f"{len(names)} packages are not in this workspace: {first} and {last}; what they define is not checked"


def counted(report: Report) -> list[tuple[int, Severity, str, str]]:
    """Return the number of findings of each rule with its severity, code and name, most frequent first."""
    keys = [(finding.severity, finding.code, finding.name) for finding in report.findings]
    counts = [(keys.count(key), *key) for key in dict.fromkeys(keys)]
    return sorted(counts, key=lambda item: (-item[0], item[2]))


def is_robot(target: TargetResult) -> bool:
    """Return whether a target is a robot, not a controller file or launch file without one."""
    return not (is_yaml(target.path) or is_launch(target.path))


def shown(path: str, folder: str | None = None) -> str:
    """Return a path as reports show it: relative if it is in a folder (default: the current one), with forward
    slashes."""
    return path.removeprefix(_inside(folder)).replace(os.sep, "/")


def in_command(path: str) -> str:
    """Return a path as a command takes it from the current folder."""
    from shlex import quote

    return quote(shown(path))


def _inside(folder: str | None) -> str:
    """How the paths of a folder's files begin."""
    return (folder or os.getcwd()).rstrip(os.sep) + os.sep


def as_json(value: object, indent: int | None = None) -> str:
    """Return a value as JSON that is safe to print: control characters, line separators and surrogates are escaped.
    Surrogates come from file names that are not valid UTF-8."""
    import json

    text = json.dumps(value, indent=indent, ensure_ascii=False)
    return text if text.isprintable() else re.sub(_UNSAFE_IN_JSON, lambda match: json.dumps(match[0])[1:-1], text)


def as_text(text: str) -> str:
    """Return a text that can be encoded: surrogates become U+FFFD, the replacement character."""
    return re.sub("[\ud800-\udfff]", "\ufffd", text)


def rebased(path: str, variable: str) -> str:
    """Return a path as reports show it, relative to the checkout if the environment variable names its root."""
    from urdfctl.report.fingerprint import path_from

    root = os.environ.get(variable)
    known = root and os.path.abspath(path).startswith(os.path.abspath(root).rstrip(os.sep) + os.sep)
    return path_from(os.path.abspath(path), root) if root and known else path


_UNSAFE_IN_JSON = f"[\ud800-\udfff{''.join(f'{chr(first)}-{chr(last)}' for first, last in INVISIBLE)}]"


def relative(diagnostic: Diagnostic, folder: str | None = None) -> Diagnostic:
    """Return a diagnostic with paths as reports show them: relative to a folder, by default the current one."""
    fix = diagnostic.fix
    if fix:
        edits = tuple(edit._replace(at=_located(edit.at, folder)) for edit in fix.edits)
        fix = fix._replace(title=relative_message(fix.title, folder), edits=edits)
    chains = diagnostic.expanded_from
    return diagnostic._replace(
        message=relative_message(diagnostic.message, folder),
        at=_located(diagnostic.at, folder),
        expanded_from=tuple(tuple(step._replace(file=shown(step.file, folder)) for step in chain) for chain in chains),
        notes=tuple(_relative_remark(note, folder) for note in diagnostic.notes),
        fix=fix,
        also=tuple(_relative_remark(remark, folder) for remark in diagnostic.also),
    )


def _relative_remark(remark: Remark, folder: str | None) -> Remark:
    at = _located(remark.at, folder) if remark.at else None
    return remark._replace(message=relative_message(remark.message, folder), at=at)


def relative_message(message: str, folder: str | None = None) -> str:
    """Return a message with paths as reports show them: relative to a folder, by default the current one."""
    begins = _inside(folder)
    if begins == os.sep or begins not in message:
        return message
    return re.sub(r"(?:(?<![\w./-])|(?<=\bfile://))" + re.escape(begins), "", message)


def _located(at: Location, folder: str | None) -> Location:
    return at._replace(file=shown(at.file, folder))
