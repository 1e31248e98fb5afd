"""`--baseline` and `--write-baseline`: hide known findings, and report those that are fixed."""

from __future__ import annotations

import os
from collections.abc import Collection

from urdfctl.cli.writing import print_message, write_file
from urdfctl.diagnostic import Diagnostic
from urdfctl.lint.selection import Selection
from urdfctl.report.baseline import Known, baseline_text, compare, read_baseline
from urdfctl.startup.records import NamedTuple


class Baseline(NamedTuple):
    """The known findings.

    path: the baseline to read.
    to_write: the baseline to write, with all findings of the run.
    """

    path: str | None
    known: list[Known]
    to_write: str | None

    def unknown(self, findings: list[Diagnostic], read: Collection[str], selection: Selection) -> list[Diagnostic]:
        """Return the findings that are not known. Write the baseline, or report how many of its findings are fixed.

        read: the files that the run read.
        selection: the rules that it used.
        Raises UserError if the baseline cannot be written.
        """
        if self.to_write is not None:
            write_file(self.to_write, baseline_text(findings, self.to_write), force=True)
            known = read_baseline(self.to_write)
            print_message(f"{_counted(known)} written to '{self.to_write}'")
            return compare(findings, known, self.to_write, lambda *_: False).new
        if self.path is None:
            return findings

        def was_checked(code: str, file: str) -> bool:
            return selection.admits(code) and (file in read or not os.path.exists(file))

        comparison = compare(findings, self.known, self.path, was_checked)
        if comparison.fixed:
            number = _counted(comparison.fixed)
            print_message(
                f"fixed: {number} in baseline '{self.path}'; --write-baseline {self.path} removes what is fixed"
            )
        return comparison.new


def open_baseline(path: str | None, to_write: str | None) -> Baseline:
    """Return the baseline of a run. UserError if it cannot be read."""
    return Baseline(path, read_baseline(path) if path is not None and path != to_write else [], to_write)


def _counted(known: Collection[Known]) -> str:
    number = sum(finding.times for finding in known)
    return f"{number} finding{'' if number == 1 else 's'}"
