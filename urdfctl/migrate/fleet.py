"""What a migration did to each of many packages, as one table."""

from __future__ import annotations

import json
import os
from collections.abc import Iterable, Sequence

from urdfctl.migrate.report import NOT_CHANGED, NOT_READ, ReportLine
from urdfctl.migrate.step import EntryKind
from urdfctl.report.pages import page
from urdfctl.source.workspaces.package_folders import package_folders
from urdfctl.source.workspaces.packages import package_name
from urdfctl.startup.records import NamedTuple

_COLUMNS = ("package", "applied", "choices", "left", "skipped", "failed")


class PackageRow(NamedTuple):
    """A package after a migration.

    applied, choices, left: the numbers of lines in its report.
    skipped: the steps that were left out of a file of it.
    failed: its files that cannot be read.
    lines: what is left, skipped or failed.
    """

    package: str
    folder: str
    applied: int
    choices: int
    left: int
    skipped: int
    failed: int
    lines: tuple[ReportLine, ...]

    @property
    def numbers(self) -> tuple[int, ...]:
        """The numbers in the order of the columns."""
        return self.applied, self.choices, self.left, self.skipped, self.failed


def rows_of(folders: Iterable[str], lines: Sequence[ReportLine], base: str) -> list[PackageRow]:
    """Return a row for each package in some folders, by name. base: the folder that paths are relative to."""
    found = sorted({os.path.realpath(package) for folder in folders for package in package_folders(folder)}, key=len)
    own: dict[str, list[ReportLine]] = {folder: [] for folder in found}
    for line in lines:
        around = [folder for folder in found if (line.file + os.sep).startswith(folder + os.sep)]
        if around:
            own[around[-1]].append(line)
    rows = (_row(folder, own[folder], base) for folder in found)
    return sorted(rows, key=lambda row: (row.package, row.folder))


def _row(folder: str, lines: Sequence[ReportLine], base: str) -> PackageRow:
    for_you = [line for line in lines if line.kind is EntryKind.FOR_YOU]
    skipped = [line for line in for_you if line.message.startswith(NOT_CHANGED)]
    failed = [line for line in for_you if line.message.startswith(NOT_READ)]
    return PackageRow(
        package=package_name(os.path.join(folder, "package.xml")) or os.path.basename(folder),
        folder=os.path.relpath(folder, base).replace(os.sep, "/"),
        applied=sum(line.kind is EntryKind.DONE for line in lines),
        choices=sum(line.kind is EntryKind.DECIDED for line in lines),
        left=len(for_you) - len(skipped) - len(failed),
        skipped=len(skipped),
        failed=len(failed),
        lines=tuple(line._replace(file=os.path.relpath(line.file, folder).replace(os.sep, "/")) for line in for_you),
    )


def as_text(rows: Sequence[PackageRow]) -> str:
    """Return the table as text, with the sums in its last line."""
    last = [f"{len(rows)} package{'s' * (len(rows) != 1)}", *map(str, _sums(rows))]
    lines = [list(_COLUMNS), *([row.package, *map(str, row.numbers)] for row in rows), last]
    first, *widths = [max(len(line[column]) for line in lines) for column in range(len(_COLUMNS))]
    shown = []
    for name, *numbers in lines:
        cells = (text.rjust(width) for text, width in zip(numbers, widths, strict=True))
        shown.append("  ".join([name.ljust(first), *cells]))
    return "\n".join(shown) + "\n"


def _sums(rows: Sequence[PackageRow]) -> list[int]:
    return [sum(column) for column in zip(*(row.numbers for row in rows), strict=True)] or [0] * (len(_COLUMNS) - 1)


def as_json(rows: Sequence[PackageRow], target: str) -> str:
    """Return the table as JSON."""
    packages = [
        {**row._asdict(), "lines": [{**line._asdict(), "kind": line.kind.value} for line in row.lines]} for row in rows
    ]
    return json.dumps({"to": target, "packages": packages}, indent=2, ensure_ascii=False) + "\n"


def as_page(rows: Sequence[PackageRow], target: str) -> str:
    """Return the table as a page of HTML, with what is left of each package."""
    title = f"Migration of {len(rows)} package{'s' * (len(rows) != 1)} to {target}"
    return page("migration", title=title, columns=_COLUMNS, rows=rows, sums=_sums(rows))
