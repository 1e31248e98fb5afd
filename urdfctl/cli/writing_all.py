"""Write the changes of several files: all of them or none."""

from __future__ import annotations

import os
import sys
from collections.abc import Iterator, Sequence
from contextlib import contextmanager

from urdfctl.cli.journal import journal
from urdfctl.cli.writing import temporary_beside, write_beside
from urdfctl.errors import UserError
from urdfctl.fix.edits import Change


def write_all(changes: Sequence[Change]) -> list[str]:
    """Write, create and delete all files, or none: they were only tested together. Return what prevented it.

    All new contents are written to temporary files first, so that a run that is killed before the last step, which
    only renames and takes no signal but SIGKILL, leaves the files as they were. If it is killed then, the next run
    that writes files restores them from a journal.
    """
    staged: list[tuple[Change, str | None]] = []
    try:
        with journal(changes):
            for change in changes:
                staged.append((change, _staged(change)))  # noqa: PERF401 (what is staged is cleaned up if one fails)
            with _undisturbed():
                _commit(staged)
    except (UserError, OSError) as error:
        return [
            str(error) if isinstance(error, UserError) else f"'{error.filename}' cannot be written: {error.strerror}"
        ]
    finally:
        for _, temporary in staged:
            if temporary is not None and os.path.exists(temporary):
                os.unlink(temporary)
    return []


def _staged(change: Change) -> str | None:
    """Write the new content of a file beside it, and return the path; None for a file to delete."""
    path = change.file
    try:
        current = None
        if os.path.lexists(path):
            with open(path, "rb") as file:
                current = file.read()
        if current != change.before:
            raise UserError(f"'{path}' was changed by another program; it is not overwritten")
        if change.after is None:
            return None
        os.makedirs(os.path.dirname(path), exist_ok=True)
        return temporary_beside(path, change.after)
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
                write_beside(change.file, change.before)
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
