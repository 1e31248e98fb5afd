"""Smoke tests for an editor: the findings that `urdfctl smoke --format json` reports, and a summary."""

from __future__ import annotations

import json
import os
from collections import Counter
from typing import Any

from urdfctl.diagnostic import CallStep, Diagnostic, Location, Remark, Repair, Severity
from urdfctl.load.target import Target
from urdfctl.server.commands.processes import pip_install
from urdfctl.smoke.engines import installed
from urdfctl.startup.records import NamedTuple


class Tested(NamedTuple):
    """What a smoke test found.

    findings: by the path of their file.
    controllers: each with its name, its verdict, and the reason for it.
    """

    findings: dict[str, tuple[Diagnostic, ...]]
    controllers: list[dict[str, Any]]
    interrupted: bool

    @property
    def summary(self) -> str:
        """Return how many controllers there are with each verdict."""
        counts = Counter(str(controller["verdict"]) for controller in self.controllers)
        total = len(self.controllers)
        each = ", ".join(f"{count} {verdict}" for verdict, count in counts.items())
        text = f"{total} controller{'' if total == 1 else 's'}: {each}" if total else "there are no controllers to test"
        if self.interrupted:
            text += "; interrupted before all were tested"
        elif total and not installed():
            text += f"; nothing was moved. To install a physics engine: {pip_install('smoke')}"
        return text


def words_for(target: Target, report: str) -> list[str]:
    """Return the words of the command that tests a target. report: the file for the report as a text.

    The names of arguments come from files that may be a stranger's: no word after `--` is an option.
    """
    files = [target.path, *target.controllers, *([target.launch] if target.launch else [])]
    given = [f"{name}:={value}" for name, value in target.arguments]
    engine = "auto" if installed() else "none"
    options = ["--engine", engine, "--format", "json", "--format", f"text={report}", "--progress"]
    return ["smoke", *options, "--", *map(os.path.abspath, files), *given]


def tested(report: bytes, folder: str) -> Tested:
    """Return what a report says. folder: what its paths are relative to."""
    data = json.loads(report)
    findings: dict[str, list[Diagnostic]] = {}
    for finding in data["findings"]:
        found = _diagnostic(finding, folder)
        findings.setdefault(found.at.file, []).append(found)
    return Tested(
        findings={file: tuple(found) for file, found in findings.items()},
        controllers=data["controllers"],
        interrupted=data["interrupted"],
    )


def _diagnostic(data: dict[str, Any], folder: str) -> Diagnostic:
    """The finding that a report describes, without the edits of its fix."""
    return Diagnostic(
        code=data["code"],
        name=data["name"],
        severity=Severity(data["severity"]),
        message=data["message"],
        at=_location(data, folder),
        expanded_from=tuple(
            tuple(CallStep(os.path.join(folder, s["file"]), s["line"], s["column"], s["what"]) for s in chain)
            for chain in data["expanded_from"]
        ),
        notes=tuple(_remark(note, folder) for note in data["notes"]),
        also=tuple(_remark(note, folder) for note in data["also"]),
        fix=Repair(data["fix"]["title"], safe=False) if data["fix"] else None,
        url=data["url"],
    )


def _remark(data: dict[str, Any], folder: str) -> Remark:
    return Remark(data["message"], _location(data, folder) if "file" in data else None)


def _location(data: dict[str, Any], folder: str) -> Location:
    """The place of a finding, or of a note, which has no end."""
    line, column = data["line"], data["column"]
    return Location(
        file=os.path.join(folder, data["file"]),
        line=line,
        column=column,
        end_line=data.get("end_line", line),
        end_column=data.get("end_column", column),
        start=0,
        end=0,
    )
