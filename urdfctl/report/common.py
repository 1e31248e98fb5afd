"""What the reports share."""

from __future__ import annotations

import os
import re
from typing import NamedTuple

from urdfctl.diagnostic import Diagnostic, Location, Severity
from urdfctl.lint import Linted
from urdfctl.source.files import is_launch, is_yaml


class Report(NamedTuple):
    """What a run found: the robots it looked at (and controllers' files and launch files named alone), the findings in
    their stable order, and how many other files it looked at: macro libraries, fragments and controllers' files in
    folders, which no robot uses."""

    targets: tuple[Linted, ...]
    findings: tuple[Diagnostic, ...]
    others: int = 0

    def count(self, severity: Severity) -> int:
        """How many findings have a severity."""
        return sum(finding.severity is severity for finding in self.findings)


def is_robot(target: Linted) -> bool:
    """Whether a target is a robot, and no controllers' file or launch file alone."""
    return not (is_yaml(target.path) or is_launch(target.path))


def shown(path: str) -> str:
    """A path as reports show it: relative to the current folder where it lies in it, with forward slashes."""
    current = os.getcwd().rstrip(os.sep) + os.sep
    return path.removeprefix(current).replace(os.sep, "/")


def visible(text: str) -> str:
    """A text whose control characters are shown, not obeyed: a stranger's file must not speak to the terminal, and one
    finding is one line."""
    return text.translate(_ESCAPES) if not text.isprintable() else text


_CONTROLS = (*range(0x20), *range(0x7F, 0xA0), *range(0x202A, 0x202F), *range(0x2066, 0x206A))
_ESCAPES = {code: repr(chr(code))[1:-1] for code in _CONTROLS}


def relative(diagnostic: Diagnostic) -> Diagnostic:
    """A diagnostic whose paths are as reports show them."""
    fix = diagnostic.fix
    if fix:
        edits = tuple(edit._replace(file=shown(edit.file)) for edit in fix.edits)
        fix = fix._replace(title=_said(fix.title), edits=edits)
    chains = diagnostic.expanded_from
    return diagnostic._replace(
        message=_said(diagnostic.message),
        at=_located(diagnostic.at),
        expanded_from=tuple(tuple(step._replace(file=shown(step.file)) for step in chain) for chain in chains),
        notes=tuple(
            note._replace(message=_said(note.message), at=_located(note.at) if note.at else None)
            for note in diagnostic.notes
        ),
        fix=fix,
    )


def _said(message: str) -> str:
    """A message whose paths are as reports show them."""
    current = os.getcwd().rstrip(os.sep) + os.sep
    if current == os.sep or current not in message:
        return message
    return re.sub(r"(?<![\w./-])" + re.escape(current), "", message)


def _located(at: Location) -> Location:
    return at._replace(file=shown(at.file))
