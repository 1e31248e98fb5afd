"""`--baseline` and `--write-baseline`: what is known is hidden, and what is known and gone is told of."""

from __future__ import annotations

import os
from collections.abc import Collection

from urdfctl.baseline import Known, compared, read_baseline, written
from urdfctl.cli.writing import tell, write_file
from urdfctl.diagnostic import Diagnostic
from urdfctl.lint import Selection
from urdfctl.record import NamedTuple


class Baseline(NamedTuple):
    """The file of known findings and what it holds; the one `to_write` knows all findings of the run."""

    path: str | None
    known: list[Known]
    to_write: str | None

    def unknown(self, findings: list[Diagnostic], read: Collection[str], selection: Selection) -> list[Diagnostic]:
        """The findings to be told, of a run that read some files and asked some rules. UserError where the file cannot
        be written."""
        if self.to_write is not None:
            write_file(self.to_write, written(findings, self.to_write), force=True)
            known = read_baseline(self.to_write)
            tell(f"{_counted(known)} written to '{self.to_write}'")
            return compared(findings, known, self.to_write, lambda *_: False).new
        if self.path is None:
            return findings

        def looked_at(code: str, file: str) -> bool:
            return selection.admits(code) and (file in read or not os.path.exists(file))

        told = compared(findings, self.known, self.path, looked_at)
        if told.gone:
            what = f"{_counted(told.gone)} known in '{self.path}'"
            tell(f"gone: {what}; --write-baseline {self.path} forgets what is gone")
        return told.new


def opened(path: str | None, to_write: str | None) -> Baseline:
    """The baseline that is asked for. UserError where there is none that can be read."""
    return Baseline(path, read_baseline(path) if path is not None and path != to_write else [], to_write)


def _counted(known: Collection[Known]) -> str:
    number = sum(one.times for one in known)
    return f"{number} finding{'' if number == 1 else 's'}"
