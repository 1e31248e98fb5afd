"""The report for people: the source line with a caret, the calls that led there, the way out, and a summary."""

from __future__ import annotations

from collections import Counter
from collections.abc import Iterable, Iterator

from urdfctl.diagnostic import Diagnostic, Severity
from urdfctl.record import NamedTuple
from urdfctl.report.common import Report, is_robot, relative, shown, visible
from urdfctl.report.concise import place
from urdfctl.report.words import notes

_WIDEST = 160
_COLOURS = {Severity.ERROR: "bold red", Severity.WARNING: "bold yellow", Severity.INFO: "bold cyan"}


class Piece(NamedTuple):
    """A part of the text and its style, in rich's words."""

    text: str
    style: str = ""


def render(report: Report) -> str:
    """The report without colours."""
    return "".join(piece.text for piece in pieces(report))


def print_coloured(report: Report) -> None:
    """Print the report on a terminal."""
    print_pieces(pieces(report))


def print_pieces(parts: Iterable[Piece]) -> None:
    """Print parts of a text with their styles on a terminal."""
    from rich.console import Console
    from rich.text import Text

    text = Text()
    for piece in parts:
        text.append(piece.text.encode("utf-8", "surrogateescape").decode("utf-8", "replace"), piece.style)
    Console(highlight=False, soft_wrap=True).print(text, end="")


def pieces(report: Report) -> Iterator[Piece]:
    """The whole report, part by part."""
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
    text, start = _of_one_column_each(diagnostic.excerpt), at.column - diagnostic.excerpt_column
    cut = max(0, start - _WIDEST // 2) if len(text) > _WIDEST else 0
    text, start = text[cut : cut + _WIDEST], start - cut
    end = start + at.end_column - at.column if at.end_line == at.line else len(text.rstrip())
    number = str(at.line)
    margin = " " * len(number)
    yield Piece(f"  {number} | ", "dim")
    yield Piece(f"{text}\n")
    yield Piece(f"  {margin} | ", "dim")
    yield Piece(f"{' ' * start}{'^' * max(min(end, len(text)) - start, 1)}\n", _COLOURS[diagnostic.severity])


def _of_one_column_each(text: str) -> str:
    """A line whose tabs and control characters take one column each, so that the caret stands where it should."""
    text = text.replace("\t", " ")
    return text if text.isprintable() else "".join(c if visible(c) == c else "\ufffd" for c in text)


def _statistics(report: Report) -> Iterator[Piece]:
    """How often each rule found something, the most frequent first."""
    counts = Counter((one.code, one.severity, one.name) for one in report.findings)
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
    told = f"{', '.join(counts) or 'no findings'} in {_what(report)}{_about(report)}"
    told += f"; {report.known} hidden by the baseline" if report.known else ""
    yield Piece(visible(told) + "\n", "bold")


def _what(report: Report) -> str:
    """What was looked at: a single file by its path; variants of one robot are one."""
    paths = {target.path: is_robot(target) for target in report.targets}
    robots = sum(paths.values())
    counts = [f"{robots} robots" if robots != 1 else "1 robot"] if robots or not (paths or report.others) else []
    counts += [_files(len(paths) - robots, "alone")] if len(paths) > robots else []
    counts = [shown(next(iter(paths)))] if len(paths) == 1 else counts
    return " and ".join([*counts, *([_files(report.others, "that no robot uses")] if report.others else [])])


def _files(number: int, which: str) -> str:
    return f"{number} file{'' if number == 1 else 's'} {which}"


def _about(report: Report) -> str:
    """For a single robot, which distro it was judged for and what tells so: of its variants, one that tells it."""
    if len({target.path for target in report.targets}) != 1:
        return ""
    target = next((target for target in report.targets if target.distro_from), report.targets[0])
    distro = target.distro or (f"ROS {target.ros}" if target.ros else "")
    source = f", from {target.distro_from}" if target.distro_from and not target.distro_from.startswith("--") else ""
    partly = "; not all of it could be expanded" if not target.complete else ""
    if target.library:
        partly = "; macros that nothing here calls"
    return f" ({distro}{source}{partly})" if distro else f" ({partly[2:]})" if partly else ""
