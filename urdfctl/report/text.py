"""Report for people: the source line with a caret, the calls that lead to it, the fix, and a summary."""

from __future__ import annotations

import os
from collections.abc import Iterable, Iterator, Sequence

from urdfctl.catalog.distros import APPLIES, span_in_words
from urdfctl.diagnostic import Diagnostic, Severity
from urdfctl.lint.results import Report
from urdfctl.output.printing import visible
from urdfctl.report.common import about_missing_packages, counted, is_robot, relative, shown
from urdfctl.report.concise import place
from urdfctl.report.words import about_unjoined, fix_in_words, notes
from urdfctl.startup.records import NamedTuple

WIDTH = 120
"""No line is wider, unless it begins with a longer path."""
_NARROWEST = 60
_INDENT = "    "
_MOST_UNUSED = 3
_COLOURS = {Severity.ERROR: "bold red", Severity.WARNING: "bold yellow", Severity.INFO: "bold cyan"}


class Piece(NamedTuple):
    """A part of the text with its style, as rich spells it."""

    text: str
    style: str = ""


def render(report: Report) -> str:
    """Return the report without colours."""
    return "".join(piece.text for piece in pieces(report))


def print_coloured(report: Report) -> None:
    """Print the report to the terminal, in colours and as wide as the terminal."""
    print_pieces(pieces(report, terminal_width()))


def terminal_width() -> int:
    """Return the width of the terminal in columns: between 60 and 120."""
    from shutil import get_terminal_size

    return min(max(get_terminal_size((WIDTH, 24)).columns, _NARROWEST), WIDTH)


def print_pieces(parts: Iterable[Piece]) -> None:
    """Print parts of a text with their styles to the terminal."""
    from rich.console import Console
    from rich.text import Text

    text = Text()
    for piece in parts:
        text.append(piece.text.encode("utf-8", "surrogateescape").decode("utf-8", "replace"), piece.style)
    forced = True if os.environ.get("FORCE_COLOR") else None
    Console(highlight=False, soft_wrap=True, force_terminal=forced).print(text, end="")


def pieces(report: Report, width: int = WIDTH) -> Iterator[Piece]:
    """Yield the parts of the report. Lines are at most `width` columns wide."""
    for diagnostic in report.findings:
        yield from _finding(relative(diagnostic), width)
    if report.statistics:
        yield from _statistics(report)
    if not report.quiet:
        yield from _summary(report, width)


def _finding(diagnostic: Diagnostic, width: int) -> Iterator[Piece]:
    head, kind = f"{place(diagnostic)}: ", f"{diagnostic.severity.value} {diagnostic.code}"
    if len(head) + len(kind) > width:
        yield Piece(f"{head.rstrip()}\n", "bold")
        head = "    "
    yield Piece(head, "bold")
    yield Piece(kind, _COLOURS[diagnostic.severity])
    yield Piece(wrapped(f" {visible(diagnostic.message)}", width, before=len(head) + len(kind)))
    if diagnostic.excerpt.strip():
        yield from _excerpt(diagnostic, width)
    for note in notes(diagnostic):
        yield Piece(wrapped(visible(f"  note: {note}"), width))
    if diagnostic.fix:
        yield Piece("  fix:", "green")
        yield Piece(wrapped(f" {visible(fix_in_words(diagnostic.fix))}", width, before=6))


def _excerpt(diagnostic: Diagnostic, width: int) -> Iterator[Piece]:
    at = diagnostic.at
    number = str(at.line)
    margin = " " * len(number)
    room = width - len(f"  {number} | ")
    text, start = _with_single_columns(diagnostic.excerpt), at.column - diagnostic.excerpt_column
    cut = min(max(0, start - room // 2), max(0, len(text) - room)) if len(text) > room else 0
    text, start = text[cut : cut + room], max(0, min(start - cut, room - 1))
    end = start + at.end_column - at.column if at.end_line == at.line else len(text.rstrip())
    yield Piece(f"  {number} | ", "dim")
    yield Piece(f"{text}\n")
    yield Piece(f"  {margin} | ", "dim")
    yield Piece(f"{' ' * start}{'^' * max(min(end, len(text)) - start, 1)}\n", _COLOURS[diagnostic.severity])


def _with_single_columns(text: str) -> str:
    """Return a line in which tabs and control characters take one column each, so that the caret is aligned."""
    text = text.replace("\t", " ")
    return text if text.isprintable() else "".join(c if visible(c) == c else "\ufffd" for c in text)


def _statistics(report: Report) -> Iterator[Piece]:
    """Yield the number of findings of each rule, most frequent first."""
    for count, severity, code, name in counted(report):
        yield Piece(f"{count:>6}  ")
        yield Piece(f"{severity.value:<7} {code}", _COLOURS[severity])
        yield Piece(f" {name}\n")


def _summary(report: Report, width: int) -> Iterator[Piece]:
    """Yield what was not checked, then the numbers of findings and fixes."""
    if report.unused:
        yield Piece(wrapped(visible(_unused(report.unused)), width))
    if report.unjoined:
        yield Piece(wrapped(visible(about_unjoined(report.unjoined)), width))
    yield from _open_distro(report)
    if report.uncontrolled:
        hint = f"nothing controls the robot's joints; to generate control: urdfctl gen-all {shown(report.uncontrolled)}"
        yield Piece(wrapped(visible(hint), width))
    if report.missing_packages:
        yield Piece(wrapped(visible(about_missing_packages(report.missing_packages)), width))
    counts = [
        f"{number} {severity.value if severity is Severity.INFO or number == 1 else severity.value + 's'}"
        for severity in Severity
        if (number := report.count(severity))
    ]
    summary = f"{', '.join(counts) or 'no findings'} in {_scope(report)}{_details(report)}"
    summary += f"; {report.known} hidden by the baseline" if report.known else ""
    yield Piece(wrapped(visible(summary + _fixable(report)), width), "bold")


def _fixable(report: Report) -> str:
    """How many findings have a fix that is made by an option."""
    fixes = [finding.fix for finding in report.findings if finding.fix and finding.fix.edits]
    safe = sum(fix.safe for fix in fixes)
    unsafe = len(fixes) - safe
    if safe and unsafe:
        return f"; {safe} fixable with --fix, {unsafe} more with --unsafe-fixes"
    return f"; {len(fixes)} fixable with {'--fix' if safe else '--unsafe-fixes'}" if fixes else ""


def _open_distro(report: Report) -> Iterator[Piece]:
    """That the distro is unknown, if that matters: a robot is controlled, or a finding is for some distros only."""
    possible = {distro for target in report.targets if target.distro is None for distro in target.distros}
    controlled = any(target.ros and target.distro is None for target in report.targets)
    partial = (note.message.startswith(APPLIES) for finding in report.findings for note in finding.notes)
    if len(possible) > 1 and (controlled or any(partial)):
        names = span_in_words(possible)
        yield Piece(
            f'ROS distro unknown ({names}): add --distro NAME, or distro = "NAME" to urdfctl.toml, to check for yours\n'
        )


def _scope(report: Report) -> str:
    """Return the path of a single file, or the numbers of robots and files. Variants of a robot count once."""
    paths = {target.path: is_robot(target) for target in report.targets}
    robots = sum(paths.values())
    counts = [f"{robots} robots" if robots != 1 else "1 robot"] if robots or not (paths or report.unused) else []
    counts += [_files(len(paths) - robots, "without a robot")] if len(paths) > robots else []
    counts = [shown(next(iter(paths)))] if len(paths) == 1 else counts
    return " and ".join(counts or [_files(len(report.unused), "")])


def _unused(paths: Sequence[str]) -> str:
    """The files that no robot uses, by name: three, and how many more."""
    names = [shown(path) for path in paths[:_MOST_UNUSED]]
    more = f" and {len(paths) - _MOST_UNUSED} more" if len(paths) > _MOST_UNUSED else ""
    return f"{_files(len(paths), 'not used by any robot')}: {', '.join(names)}{more}"


def _files(number: int, which: str) -> str:
    return f"{number} file{'' if number == 1 else 's'} {which}".rstrip()


def _details(report: Report) -> str:
    """Return a single robot's distro, where that comes from, and whether the robot is complete."""
    if len({target.path for target in report.targets}) != 1:
        return ""
    target = next((target for target in report.targets if target.distro_from), report.targets[0])
    distro = target.distro or (f"ROS {target.ros}" if target.ros else "")
    source = f", from {target.distro_from}" if target.distro_from and not target.distro_from.startswith("--") else ""
    partly = "; some parts could not be expanded" if not target.complete else ""
    if target.library:
        partly = "; macros not called in these files"
    return f" ({distro}{source}{partly})" if distro else f" ({partly[2:]})" if partly else ""


def wrapped(text: str, width: int, before: int = 0) -> str:
    """Return a text in lines of at most `width` columns, further lines indented, with a newline at the end.

    Names that are wider are cut: a finding must not disturb the layout of a terminal. before: how many columns of the
    first line are taken.
    """
    if before + len(text) <= width:
        return f"{text}\n"
    lines: list[str] = []
    rest, room = text, width - before
    while len(rest) > room:
        cut = rest.rfind(" ", 1, room + 1)
        is_start = not rest[:cut].strip() if cut > 0 else True
        if is_start:  # no space where the line could end
            cut = 0 if lines == [] and before else room
        lines.append(rest[:cut].rstrip())
        rest, room = _INDENT + rest[cut:].lstrip(), width
    return "\n".join([*lines, rest]) + "\n"
