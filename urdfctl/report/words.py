"""The notes and the fix of a finding, as sentences."""

from __future__ import annotations

from collections.abc import Iterator

from urdfctl.diagnostic import Diagnostic, Location, Step

MOST_CHAINS = 4
_MOST_STEPS = 8


def notes(diagnostic: Diagnostic) -> Iterator[str]:
    """Yield the calls that lead to a finding (the first four of many), then its notes."""
    for chain in diagnostic.expanded_from[:MOST_CHAINS]:
        yield _chain(chain)
    if len(diagnostic.expanded_from) > MOST_CHAINS:
        yield f"and in {len(diagnostic.expanded_from) - MOST_CHAINS} more calls"
    for note in diagnostic.notes:
        yield note.message + (f" ({_where(note.at, diagnostic.at.file)})" if note.at else "")


def paragraph(diagnostic: Diagnostic) -> list[str]:
    """Return the lines of a finding: its message, its notes, its fix."""
    lines = [diagnostic.message, *(f"note: {note}" for note in notes(diagnostic))]
    return [*lines, f"fix: {diagnostic.fix.title}"] if diagnostic.fix else lines


def _where(at: Location, current: str) -> str:
    return f"line {at.line}" if at.file == current else f"{at.file}:{at.line}:{at.column}"


def _chain(chain: tuple[Step, ...]) -> str:
    """Return the calls and includes of a chain, innermost first. The middle of a long chain is left out."""
    steps = [_step(step) for step in chain]
    if len(steps) > _MOST_STEPS:
        steps[_MOST_STEPS - 1 : -1] = [f"and {len(steps) - _MOST_STEPS} more calls"]
    return ", ".join(steps)


def _step(step: Step) -> str:
    kind, _, name = step.what.partition(" ")
    place = f"{step.file}:{step.line}:{step.column}"
    if kind == "macro":
        return f"in the call of macro '{name}' at {place}"
    if kind == "uncalled":
        macro = name.removeprefix("macro ")
        return f"in macro '{macro}' ({place}), which is not called in these files: its parameters are unknown"
    if kind == "block":
        return f"inserted as a block at {place}"
    return f"included at {place}"
