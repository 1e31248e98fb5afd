"""The commands to run after a log is explained."""

from __future__ import annotations

import re
from collections.abc import Iterable

from urdfctl.logs.digest import KnownMessage
from urdfctl.logs.evidence import CheckedFolder
from urdfctl.startup.records import NamedTuple

_MOST_CODES = 6
_URGENT = ("failure", "consequence")
_ASKS = re.compile(r"\bros2 (control|topic|param|node|service)\b")
"""Advice to ask the running system, which the doctor does."""


class NextCommand(NamedTuple):
    """A command line and its purpose."""

    text: str
    purpose: str


def next_commands(known: Iterable[KnownMessage], files: CheckedFolder | None = None) -> tuple[NextCommand, ...]:
    """Return the commands that find the causes: of the failures, or of the other messages if there are no failures.

    files: the folder in which the causes were already searched.
    """
    known = tuple(known)
    return (*_in_files(known, files), *_in_the_running_system(known))


def _in_the_running_system(known: Iterable[KnownMessage]) -> tuple[NextCommand, ...]:
    """The command to run if only the running system can tell the cause."""
    unknown = [entry for entry in known if entry.kind in _URGENT and not entry.settled and not entry.reading.is_found]
    if not any(_ASKS.search(entry.reading.best_fix) for entry in unknown):
        return ()
    return (NextCommand("urdfctl doctor", "asks the running system, and compares it with your files"),)


def _in_files(known: tuple[KnownMessage, ...], files: CheckedFolder | None) -> tuple[NextCommand, ...]:
    """The commands that find the causes in files."""
    if files is not None:
        return _after_checking(known, files)
    urgent = [entry for entry in known if entry.kind in _URGENT]
    unsettled = [entry for entry in known if not entry.settled]
    codes = list(dict.fromkeys(code for entry in urgent or unsettled for code in entry.rules))
    if not codes:
        return (NextCommand("urdfctl lint robot.xacro controllers.yaml", "finds other errors"),) if urgent else ()
    more = f" and {len(codes) - _MOST_CODES} more" if len(codes) > _MOST_CODES else ""
    shown = ", ".join(codes[:_MOST_CODES]) + more
    controllers = " controllers.yaml" if any(code.startswith("UC4") for code in codes) else ""
    return (
        NextCommand(f"urdfctl lint robot.xacro{controllers}", f"finds {shown} in your files"),
        NextCommand(f"urdfctl explain {codes[0]}", "explains a rule, with an example"),
    )


def _after_checking(known: Iterable[KnownMessage], files: CheckedFolder) -> tuple[NextCommand, ...]:
    """The commands to run after the causes were searched in a folder."""
    found = [found for entry in known for cause in entry.reading.causes for found in cause.found]
    offered = [NextCommand(f"urdfctl explain {found[0].code}", "explains the rule, with an example")] if found else []
    lint = f"urdfctl lint {files.folder}"
    sure = list(dict.fromkeys(one.code for one in found if one.fixable))
    if sure:
        repair = f"{lint} --fix --select {','.join(sure)}"
        offered.append(NextCommand(repair, "repairs what caused it, tested on all robots"))
    likely = list(dict.fromkeys(one.code for one in found if one.likely and one.code not in sure))
    if likely:
        repair = f"{lint} --unsafe-fixes --diff --select {','.join(likely)}"
        offered.append(NextCommand(repair, "shows what most likely repairs it; without --diff it is written"))
    errors = f"{files.others} {'other ' if found else ''}error{'' if files.others == 1 else 's'}"
    purpose = f"shows {errors} in these files" if files.others else "shows all findings in these files"
    return (*offered, NextCommand(lint, purpose))
