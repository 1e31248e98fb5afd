"""What the reports share."""

from __future__ import annotations

import os
import re

from urdfctl.diagnostic import Diagnostic, Location, Severity
from urdfctl.lint import Linted
from urdfctl.record import NamedTuple
from urdfctl.source.files import is_launch, is_yaml


class Report(NamedTuple):
    """What a run found: the robots it looked at (and controllers' files and launch files named alone), the findings in
    their stable order, how many other files it looked at (macro libraries, fragments and controllers' files in folders,
    which no robot uses), from which severity on findings make it fail, how many more findings the baseline hides, and
    whether the rules are to be counted."""

    targets: tuple[Linted, ...]
    findings: tuple[Diagnostic, ...]
    others: int = 0
    fail_on: Severity = Severity.ERROR
    known: int = 0
    statistics: bool = False

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


def as_json(value: object, indent: int | None = None) -> str:
    """A value as JSON in which only what is safe to print stands as it is: no control characters, no ends of lines, no
    halves of characters (which file names that are no text bring in)."""
    import json

    text = json.dumps(value, indent=indent, ensure_ascii=False)
    return text if text.isprintable() else re.sub(_UNSAFE_IN_JSON, lambda found: f"\\u{ord(found[0]):04x}", text)


def as_text(text: str) -> str:
    """A text that any encoder takes: halves of characters become question marks in a diamond."""
    return re.sub("[\ud800-\udfff]", "\ufffd", text)


def rebased(path: str, variable: str) -> str:
    """A path as reports show it, from the root of the checkout instead where a pipeline's variable tells it."""
    from urdfctl.fingerprint import path_from

    root = os.environ.get(variable)
    known = root and os.path.abspath(path).startswith(os.path.abspath(root).rstrip(os.sep) + os.sep)
    return path_from(os.path.abspath(path), root) if root and known else path


_UNSAFE_IN_JSON = "[\x7f-\x9f\u2028-\u202e\u2066-\u2069\ud800-\udfff]"
_CONTROLS = (*range(0x20), *range(0x7F, 0xA0), *range(0x2028, 0x202F), *range(0x2066, 0x206A))
_ESCAPES = {code: repr(chr(code))[1:-1] for code in _CONTROLS}


def relative(diagnostic: Diagnostic) -> Diagnostic:
    """A diagnostic whose paths are as reports show them."""
    fix = diagnostic.fix
    if fix:
        edits = tuple(edit._replace(at=_located(edit.at)) for edit in fix.edits)
        fix = fix._replace(title=said(fix.title), edits=edits)
    chains = diagnostic.expanded_from
    return diagnostic._replace(
        message=said(diagnostic.message),
        at=_located(diagnostic.at),
        expanded_from=tuple(tuple(step._replace(file=shown(step.file)) for step in chain) for chain in chains),
        notes=tuple(
            note._replace(message=said(note.message), at=_located(note.at) if note.at else None)
            for note in diagnostic.notes
        ),
        fix=fix,
    )


def said(message: str) -> str:
    """A message whose paths are as reports show them."""
    current = os.getcwd().rstrip(os.sep) + os.sep
    if current == os.sep or current not in message:
        return message
    return re.sub(r"(?<![\w./-])" + re.escape(current), "", message)


def _located(at: Location) -> Location:
    return at._replace(file=shown(at.file))
