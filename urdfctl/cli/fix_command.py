"""`urdfctl lint --fix`, `--unsafe-fixes` and `--diff`."""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Sequence

from urdfctl.cli.patch import patch
from urdfctl.cli.wanted import Fixing, Wanted, found_in
from urdfctl.cli.writing import print_bytes, replace_file, tell
from urdfctl.errors import UserError
from urdfctl.fix.rounds import Change, Wishes, fixed
from urdfctl.lint import Linted
from urdfctl.load import Target
from urdfctl.record import NamedTuple
from urdfctl.report.common import said
from urdfctl.settings import Settings


class Done(NamedTuple):
    """How many files were changed, or would be, and what would be left to find; `failed` where they could not all be
    written, so that none is."""

    files: int
    left: tuple[Linted, ...]
    failed: bool = False


def fix(looked_at: Iterable[tuple[Target, Linted]], settings: Settings, wanted: Wanted, fixing: Fixing) -> Done:
    """Mend the files of what was looked at, or show how; tell what is not mended, and why."""
    wishes = Wishes(wanted.selection, wanted.config.ignores, fixing.unsafe)
    result = fixed(tuple(looked_at), settings, wishes, wanted.jobs or None)
    _tell(result.refused)
    if not fixing.as_diff:
        written = _write_all(result.changes)
        return Done(len(result.changes) if written else 0, result.linted, failed=not written)
    print_bytes(patch(result.changes))
    return Done(len(result.changes), result.linted)


def tell_of(files: int, before: Iterable[Linted], after: Iterable[Linted], wanted: Wanted, fixing: Fixing) -> None:
    """Tell how many of the findings are fixed, or would be, and for how many more there is an unsafe fix to try."""
    known, left = len(found_in(before, wanted)), found_in(after, wanted)
    done = f"{'would fix' if fixing.as_diff else 'fixed'} {max(known - len(left), 0)}"
    unsafe = sum(one.fix is not None and bool(one.fix.edits) and not one.fix.safe for one in left)
    more = f"; --unsafe-fixes tries {unsafe} more" if unsafe and not fixing.unsafe else ""
    _tell([f"{done} of {_counted(known, 'finding')} in {_counted(files, 'file')}{more}"])


def _counted(number: int, what: str) -> str:
    return f"{number} {what}" if number == 1 else f"{number} {what}s"


def _write_all(changes: Sequence[Change]) -> bool:
    """Write all files, or none: only together they were tried."""
    written: list[Change] = []
    for change in changes:
        try:
            replace_file(change.file, change.before, change.after)
        except UserError as error:
            _tell([str(error), *_taken_back(written)])
            return False
        written.append(change)
    return True


def _taken_back(written: Iterable[Change]) -> Iterator[str]:
    """Undo what was written; tell of each file where that fails."""
    for change in written:
        try:
            replace_file(change.file, change.after, change.before)
        except UserError as error:
            yield f"{error}, though another fix could not be written"


def _tell(lines: Iterable[str]) -> None:
    for line in lines:
        tell(said(line))
