"""Write the changes of several files: all of them or none."""

from __future__ import annotations

import os
import sys
from collections.abc import Iterable, Iterator, Sequence
from contextlib import contextmanager

from urdfctl.errors import UserError
from urdfctl.output.change import Change, bytes_of, rights_of
from urdfctl.output.journal import journal, remove_empty
from urdfctl.output.links import destination
from urdfctl.output.temporary import new_folder, remove_leftovers, temporary_beside, write_beside
from urdfctl.source.disk.files import folders_upwards


def write_all(changes: Sequence[Change]) -> list[str]:
    """Write, create and delete all files, or none: they were only tested together. Return what prevented it.

    All new contents are written to temporary files first, so that a run that is killed before the last step, which
    only renames and takes no signal but SIGKILL, leaves the files as they were. If it is killed then, the next run
    that writes files restores them from a journal.
    """
    try:
        changes = [_at_its_place(change) for change in changes]
        folders = {os.path.dirname(change.file) for change in changes}
        for folder in folders:
            remove_leftovers(folder)
        missing = _missing(folders)
        with journal(changes, missing), _undone_if_it_fails(missing) as staged:
            for folder in missing:
                os.mkdir(folder)
            for change in changes:
                staged.append((change, _staged(change)))
            with _undisturbed():
                _commit(staged)
    except UserError as error:
        return [str(error)]
    except OSError as error:
        return [f"'{error.filename}' cannot be written: {error.strerror}"]
    return []


def write_folder(path: str, files: Iterable[tuple[str, bytes]]) -> None:
    """Write a folder that does not exist, with some files by their names in it: all of them, or nothing.

    Raises UserError if it cannot be written.
    """
    try:
        with new_folder(destination(path)) as folder:
            for name, data in files:
                inside = os.path.join(folder, name)
                os.makedirs(os.path.dirname(inside), exist_ok=True)
                write_beside(inside, data)
    except OSError as error:
        raise UserError(f"'{path}' cannot be written: {error.strerror}") from None


Staged = list[tuple[Change, str | None]]
"""Changes, each with its temporary file; None for a file to delete."""


def _at_its_place(change: Change) -> Change:
    """A change of the file that its path leads to, with the rights of that file. Raises UserError as `destination`."""
    file = destination(change.file)
    rights = rights_of(file)
    return change._replace(file=file, rights=change.rights if rights is None else rights)


def _missing(folders: Iterable[str]) -> list[str]:
    """The folders that do not exist, of some and of those above them; the outermost first."""
    found = set()
    for folder in folders:
        for each in folders_upwards(folder):
            if os.path.lexists(each):
                break
            found.add(each)
    return sorted(found)


@contextmanager
def _undone_if_it_fails(missing: Sequence[str]) -> Iterator[Staged]:
    """Give the list of what is staged; if the block fails, remove that, and the folders that were missing before it."""
    staged: Staged = []
    try:
        yield staged
    except BaseException:
        for _, temporary in staged:
            if temporary is not None and os.path.exists(temporary):
                os.unlink(temporary)
        remove_empty(missing)
        raise


def _staged(change: Change) -> str | None:
    """Write the new content of a file beside it, and return the path; None for a file to delete."""
    path = change.file
    try:
        if bytes_of(path) != change.before:
            raise UserError(f"'{path}' was changed by another program; it is not overwritten")
        if change.after is None:
            return None
        return temporary_beside(path, change.after, rights=change.rights)
    except OSError as error:
        raise UserError(f"'{path}' cannot be written: {error.strerror}") from None


def _commit(staged: Sequence[tuple[Change, str | None]]) -> None:
    """Give all files their new content; if one fails, restore the others. Raises UserError then."""
    done: list[Change] = []
    for change, temporary in staged:
        try:
            if temporary is None:
                os.unlink(change.file)
            else:
                os.replace(temporary, change.file)
        except OSError as error:
            problem = f"'{change.file}' cannot be written: {error.strerror}"
            raise UserError("; ".join([problem, *_restored(done)])) from None
        done.append(change)


def _restored(done: Sequence[Change]) -> Iterator[str]:
    """Restore what was written; yield an error for each file where that fails."""
    for change in done:
        try:
            if change.before is None:
                os.unlink(change.file)
            else:
                write_beside(change.file, change.before, rights=change.rights)
        except OSError as error:
            yield f"'{change.file}' stays changed: {error.strerror}"


@contextmanager
def _undisturbed() -> Iterator[None]:
    """Keep the signals that end a program waiting, where the system can."""
    if sys.platform == "win32":
        yield
        return
    import signal

    before = signal.pthread_sigmask(signal.SIG_BLOCK, {signal.SIGINT, signal.SIGTERM, signal.SIGHUP})
    try:
        yield
    finally:
        signal.pthread_sigmask(signal.SIG_SETMASK, before)
