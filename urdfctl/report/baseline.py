"""Baseline: a file of known findings, which hides them until they are fixed."""

from __future__ import annotations

import json
import os
from collections import Counter
from collections.abc import Callable, Collection, Iterable, Sequence
from typing import Any

from urdfctl.diagnostic import Diagnostic
from urdfctl.errors import UserError
from urdfctl.lint.selection import Selection
from urdfctl.output.printing import print_message
from urdfctl.output.writing import write_file
from urdfctl.report.fingerprint import mark, message_from, path_from
from urdfctl.source.disk.files import first_bytes
from urdfctl.source.disk.gate import exists
from urdfctl.startup.records import NamedTuple

_VERSION = 1
_CRASH = "UC000"
_SMOKE = "UC9"
"""The family of what smoke finds."""
_MOST_BYTES = 64 << 20
_TEXTS = ("code", "file", "message", "mark")


class KnownFinding(NamedTuple):
    """A finding in a baseline.

    file: relative to the baseline's folder.
    mark: its fingerprint.
    times: how many equal findings there are.
    """

    code: str
    file: str
    message: str
    mark: str
    times: int


class BaselineComparison(NamedTuple):
    """Findings compared with a baseline.

    new: findings that the baseline does not contain.
    known: how many findings it contains.
    fixed: its entries that were not found again, with how many of each.
    """

    new: list[Diagnostic]
    known: int
    fixed: list[KnownFinding]


def read_baseline(path: str) -> list[KnownFinding]:
    """Return the findings in a baseline. UserError if the file is not a baseline."""
    try:
        text = first_bytes(path, _MOST_BYTES + 1)
    except FileNotFoundError:
        raise UserError(f"baseline '{path}' does not exist; --write-baseline {path} creates it") from None
    except OSError as error:
        raise UserError(f"'{path}' cannot be read: {error.strerror}") from None
    if len(text) > _MOST_BYTES:
        raise UserError(f"'{path}' is not a baseline: larger than {_MOST_BYTES >> 20} MiB")
    try:
        whole = json.loads(text)
    except (ValueError, RecursionError) as error:
        raise UserError(f"'{path}' is not a baseline: invalid JSON: {error}") from None
    version = whole.get("version") if isinstance(whole, dict) else None
    if version != _VERSION or not isinstance(whole.get("findings"), list):
        is_other = isinstance(version, int) and version != _VERSION
        problem = f"its version is {version}, not {_VERSION}" if is_other else "it has no version or no findings"
        raise UserError(f"'{path}' is not a baseline that this urdfctl can read: {problem}")
    return [_known(entry, number, path) for number, entry in enumerate(whole["findings"], 1)]


def _known(entry: Any, number: int, path: str) -> KnownFinding:
    is_valid = isinstance(entry, dict) and all(isinstance(entry.get(name), str) for name in _TEXTS)
    times = entry.get("times", 1) if is_valid else 0
    if type(times) is not int or times < 1:
        raise UserError(f"'{path}' is not a baseline: finding {number} has a missing or malformed field")
    return KnownFinding(entry["code"], entry["file"], entry["message"], entry["mark"], times)


def baseline_text(findings: Iterable[Diagnostic], path: str, others: Iterable[KnownFinding] = ()) -> str:
    """Return the text of a baseline at `path` with some findings. Crashes of urdfctl are left out.

    others: what another command found.
    """
    folder = _folder(path)
    counts: Counter[KnownFinding] = Counter()
    for finding in findings:
        if finding.code != _CRASH:
            file = path_from(finding.at.file, folder)
            counts[KnownFinding(finding.code, file, message_from(finding, folder), mark(finding, folder), 0)] += 1
    marks = {known.mark for known in counts}
    counts.update({known._replace(times=0): known.times for known in others if known.mark not in marks})
    entries = [known._replace(times=count)._asdict() for known, count in sorted(counts.items(), key=_by_file)]
    lines = ",\n".join(f"  {json.dumps(entry)}" for entry in entries)
    return f'{{"version": {_VERSION}, "tool": "urdfctl", "findings": [\n{lines}\n]}}\n'


def _by_file(counted: tuple[KnownFinding, int]) -> tuple[str, str, str, str]:
    known = counted[0]
    return known.file, known.code, known.message, known.mark


def compare(
    findings: Sequence[Diagnostic], known: Iterable[KnownFinding], path: str, was_checked: Callable[[str, str], bool]
) -> BaselineComparison:
    """Compare findings with the baseline at a path.

    was_checked: returns whether the run checked a rule, given by its code, in a file.
    """
    folder = _folder(path)
    left: Counter[str] = Counter()
    entries = list(known)
    for entry in entries:
        left[entry.mark] += entry.times
    new: list[Diagnostic] = []
    for finding in findings:
        fingerprint = mark(finding, folder)
        if left[fingerprint] and finding.code != _CRASH:
            left[fingerprint] -= 1
        else:
            new.append(finding)
    fixed = []
    for entry in entries:
        times = min(left[entry.mark], entry.times)
        left[entry.mark] -= times
        if times and was_checked(entry.code, os.path.normpath(os.path.join(folder, entry.file))):
            fixed.append(entry._replace(times=times))
    return BaselineComparison(new, len(findings) - len(new), fixed)


def _folder(path: str) -> str:
    return os.path.dirname(os.path.abspath(path))


class Baseline(NamedTuple):
    """The known findings.

    paths: the baselines to read, with what they know.
    to_write: the baseline to write, with all findings of the run.
    selection: the rules that the run uses.
    found_by: the command whose findings these are, `lint` or `smoke`. One file may serve both.
    """

    paths: tuple[tuple[str, list[KnownFinding]], ...]
    to_write: str | None
    selection: Selection
    found_by: str

    def unknown(self, findings: list[Diagnostic], read: Collection[str]) -> list[Diagnostic]:
        """Return the findings that are not known. Write the baseline, or report how many of its findings are fixed.

        read: the files that the run read.
        Raises UserError if the baseline cannot be written.
        """
        if self.to_write is not None:
            return self._written(findings, self.to_write)

        def was_checked(code: str, file: str) -> bool:
            is_ours = code.startswith(_SMOKE) == (self.found_by == "smoke")
            return is_ours and self.selection.admits(code) and (file in read or not exists(file))

        for path, known in self.paths:
            comparison = compare(findings, known, path, was_checked)
            if comparison.fixed:
                number = _counted(comparison.fixed)
                print_message(f"fixed: {number} in baseline '{path}'; --write-baseline {path} removes what is fixed")
            findings = comparison.new
        return findings

    def _written(self, findings: list[Diagnostic], path: str) -> list[Diagnostic]:
        others = [known for read, entries in self.paths if read == path for known in entries]
        others = [known for known in others if known.code.startswith(_SMOKE) != (self.found_by == "smoke")]
        write_file(path, baseline_text(findings, path, others), force=True)
        known = read_baseline(path)
        print_message(f"{_counted(known)} written to '{path}'")
        return compare(findings, known, path, lambda *_: False).new


def open_baseline(
    paths: Iterable[str], selection: Selection, *, to_write: str | None = None, found_by: str = "lint"
) -> Baseline:
    """Return the baseline of a run. UserError if it cannot be read.

    paths: the baselines to read.
    to_write: the baseline to write; what the other command found, and is known there, stays in it.
    """
    known = [(path, read_baseline(path)) for path in dict.fromkeys(paths) if path != to_write]
    if to_write is not None:
        known = [(to_write, _readable(to_write))]
    return Baseline(tuple(known), to_write, selection, found_by)


def _readable(path: str) -> list[KnownFinding]:
    """What a baseline that is written anew knows; nothing if it is none yet."""
    try:
        return read_baseline(path)
    except UserError:
        return []


def _counted(known: Collection[KnownFinding]) -> str:
    number = sum(finding.times for finding in known)
    return f"{number} finding{'' if number == 1 else 's'}"
