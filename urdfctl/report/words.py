"""What people are told of a finding beside its message."""

from __future__ import annotations

from collections.abc import Iterator

from urdfctl.diagnostic import Diagnostic, Location, Step

MOST_CHAINS = 4
_MOST_STEPS = 8


def notes(diagnostic: Diagnostic) -> Iterator[str]:
    """The calls that led to it, of many the first four, and its notes."""
    for chain in diagnostic.expanded_from[:MOST_CHAINS]:
        yield _way(chain)
    if len(diagnostic.expanded_from) > MOST_CHAINS:
        yield f"and in {len(diagnostic.expanded_from) - MOST_CHAINS} more calls"
    for note in diagnostic.notes:
        yield note.message + (f" ({_where(note.at, diagnostic.at.file)})" if note.at else "")


def paragraph(diagnostic: Diagnostic) -> list[str]:
    """The lines of all that is said of it: its message, the notes, the fix."""
    said = [diagnostic.message, *(f"note: {note}" for note in notes(diagnostic))]
    return [*said, f"fix: {diagnostic.fix.title}"] if diagnostic.fix else said


def _where(at: Location, current: str) -> str:
    return f"line {at.line}" if at.file == current else f"{at.file}:{at.line}:{at.column}"


def _way(chain: tuple[Step, ...]) -> str:
    """The steps of a way, innermost first; of a very long one the two ends."""
    steps = [_step(step) for step in chain]
    if len(steps) > _MOST_STEPS:
        steps[_MOST_STEPS - 1 : -1] = [f"and so on, {len(steps) - _MOST_STEPS} times more"]
    return ", ".join(steps)


def _step(step: Step) -> str:
    kind, _, name = step.what.partition(" ")
    place = f"{step.file}:{step.line}:{step.column}"
    if kind == "macro":
        return f"in the call of macro '{name}' at {place}"
    if kind == "uncalled":
        macro = name.removeprefix("macro ")
        return f"in macro '{macro}' ({place}), which nothing here calls: its parameters are not known"
    if kind == "block":
        return f"inserted as a block at {place}"
    return f"included at {place}"
