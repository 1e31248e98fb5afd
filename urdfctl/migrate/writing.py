"""Write what a migration made: in place, or as a copy of the packages, and the report with it."""

from __future__ import annotations

import os
import shutil
import stat
from collections.abc import Iterator, Sequence

from urdfctl.errors import UserError
from urdfctl.migrate.trial.scratch import Scratch
from urdfctl.output.change import Change, bytes_of
from urdfctl.output.links import destination
from urdfctl.output.scratch import scratch_folder
from urdfctl.output.temporary import new_folder
from urdfctl.output.writing import is_device, write_file
from urdfctl.output.writing_all import write_all
from urdfctl.source.disk.folders import walk

Report = tuple[str, bytes]
"""The path of the report, and its content."""


def write_changes(changes: Sequence[Change], report: Report | None) -> list[str]:
    """Write all files and the report, or none of them. Return what prevented it."""
    if report is None:
        return write_all(changes)
    path, text = destination(report[0]), report[1]
    if is_device(report[0]):
        problems = write_all(changes)
        if not problems:
            write_file(report[0], text, force=True)
        return problems
    return write_all([*changes, Change(path, bytes_of(path), text)])


def write_copy(scratch: Scratch, base: str, output: str, report: Report | None) -> list[str]:
    """Write the migrated packages below a folder, in the same places as below `base`, and the report.

    A folder that does not exist is written as a whole. In one that does, all files are written or none. Return what
    prevented it; raises UserError if the folder cannot be written.
    """
    try:
        if os.path.lexists(output):
            return _write_into(scratch, base, output, report)
        real = destination(output)
        with new_folder(real) as folder:
            _copy(scratch, base, folder)
            if report is not None and _is_below(report[0], real):
                inside = os.path.relpath(destination(report[0]), real)
                write_file(os.path.join(folder, inside), report[1], force=True)
                report = None
    except OSError as error:
        raise UserError(f"'{output}' cannot be written: {error.strerror}") from None
    return write_changes((), report)


def _is_below(path: str, folder: str) -> bool:
    return os.path.realpath(path).startswith(os.path.join(os.path.realpath(folder), ""))


def _write_into(scratch: Scratch, base: str, output: str, report: Report | None) -> list[str]:
    """Write the migrated packages into a folder that exists."""
    with scratch_folder() as folder:
        _copy(scratch, base, folder)
        return write_changes(tuple(_differences(folder, output)), report)


def _copy(scratch: Scratch, base: str, folder: str) -> None:
    """Copy the migrated files into a folder, with their rights. Links stay links."""
    os.makedirs(folder, exist_ok=True)
    for path in scratch.files(with_links=True):
        real = scratch.real(path)
        target = os.path.join(folder, os.path.relpath(real, base))
        os.makedirs(os.path.dirname(target), exist_ok=True)
        if os.path.islink(path):
            os.symlink(_address(real, base), target)
            continue
        shutil.copyfile(path, target)
        if os.path.exists(real):
            shutil.copymode(real, target)


def _address(link: str, base: str) -> str:
    """Where the copy of a link leads: within the copied folder as the link does, otherwise to the same place."""
    written, leads_to = os.readlink(link), os.path.realpath(link)
    if not _is_below(leads_to, base):
        return leads_to
    return os.path.relpath(leads_to, os.path.dirname(link)) if os.path.isabs(written) else written


def _differences(folder: str, output: str) -> Iterator[Change]:
    """Yield the changes that bring a folder to the content of another one; links of the other one are skipped."""
    for current, _, names in walk(folder):
        for name in sorted(names):
            path = os.path.join(current, name)
            if os.path.islink(path):
                continue
            target = destination(os.path.join(output, os.path.relpath(path, folder)))
            old, new = bytes_of(target), bytes_of(path)
            if old != new:
                yield Change(target, old, new, stat.S_IMODE(os.stat(path).st_mode))
