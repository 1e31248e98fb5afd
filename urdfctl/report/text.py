"""Report for people: the source line with a caret, the calls that lead to it, the fix, and a summary."""

from __future__ import annotations

from collections import Counter
from collections.abc import Iterable, Iterator, Sequence

from urdfctl.catalog.distros import APPLIES, span_in_words
from urdfctl.diagnostic import Diagnostic, Severity
from urdfctl.report.common import Report, about_missing_packages, is_robot, relative, shown, visible
from urdfctl.report.concise import place
from urdfctl.report.words import notes
from urdfctl.startup.records import NamedTuple

_WIDEST = 160
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
    """Print the report to the terminal, in colours."""
    print_pieces(pieces(report))


def print_pieces(parts: Iterable[Piece]) -> None:
    """Print parts of a text with their styles to the terminal."""
    from rich.console import Console
    from rich.text import Text

    text = Text()
    for piece in parts:
        text.append(piece.text.encode("utf-8", "surrogateescape").decode("utf-8", "replace"), piece.style)
    Console(highlight=False, soft_wrap=True).print(text, end="")


def pieces(report: Report) -> Iterator[Piece]:
    """Yield the parts of the report."""
    for diagnostic in report.findings:
        yield from _finding(relative(diagnostic))
    if report.statistics:
        yield from _statistics(report)
    yield from _summary(report)


def _finding(diagnostic: Diagnostic) -> Iterator[Piece]:
    yield Piece(f"{place(diagnostic)}: ", "bold")
    yield Piece(f"{diagnostic.severity.value} {diagnostic.code}", _COLOURS[diagnostic.severity])
    yield Piece(f" {visible(diagnostic.message)}\n")
    if diagnostic.excerpt.strip():
        yield from _excerpt(diagnostic)
    for note in notes(diagnostic):
        yield Piece(visible(f"  note: {note}") + "\n")
    if diagnostic.fix:
        yield Piece("  fix: ", "green")
        yield Piece(f"{visible(diagnostic.fix.title)}\n")


def _excerpt(diagnostic: Diagnostic) -> Iterator[Piece]:
    at = diagnostic.at
    text, start = _with_single_columns(diagnostic.excerpt), at.column - diagnostic.excerpt_column
    cut = max(0, start - _WIDEST // 2) if len(text) > _WIDEST else 0
    text, start = text[cut : cut + _WIDEST], start - cut
    end = start + at.end_column - at.column if at.end_line == at.line else len(text.rstrip())
    number = str(at.line)
    margin = " " * len(number)
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
    counts = Counter((finding.code, finding.severity, finding.name) for finding in report.findings)
    for (code, severity, name), count in sorted(counts.items(), key=lambda item: (-item[1], item[0][0])):
        yield Piece(f"{count:>6}  ")
        yield Piece(f"{severity.value:<7} {code}", _COLOURS[severity])
        yield Piece(f" {name}\n")


def _summary(report: Report) -> Iterator[Piece]:
    counts = [
        f"{number} {severity.value if severity is Severity.INFO or number == 1 else severity.value + 's'}"
        for severity in Severity
        if (number := report.count(severity))
    ]
    summary = f"{', '.join(counts) or 'no findings'} in {_scope(report)}{_details(report)}"
    summary += f"; {report.known} hidden by the baseline" if report.known else ""
    yield Piece(visible(summary) + "\n", "bold")
    if report.unused:
        yield Piece(visible(_unused(report.unused)) + "\n")
    yield from _open_distro(report)
    if report.missing_packages:
        yield Piece(visible(about_missing_packages(report.missing_packages)) + "\n")


def _open_distro(report: Report) -> Iterator[Piece]:
    """That the distro is unknown, if that matters: a robot is controlled, or a finding is for some distros only."""
    possible = {distro for target in report.targets if target.distro is None for distro in target.distros}
    controlled = any(target.ros and target.distro is None for target in report.targets)
    partial = (note.message.startswith(APPLIES) for finding in report.findings for note in finding.notes)
    if len(possible) > 1 and (controlled or any(partial)):
        yield Piece(f"ROS distro unknown ({span_in_words(possible)}): use --distro\n")


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
