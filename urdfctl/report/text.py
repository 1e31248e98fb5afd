"""Report for people: the source line with a caret, the calls that lead to it, the fix, and a summary."""

from __future__ import annotations

import os
from collections.abc import Iterable, Iterator, Sequence

from urdfctl.catalog.distros import APPLIES, span_in_words
from urdfctl.diagnostic import Diagnostic, Remark, Severity
from urdfctl.lint.results import Report
from urdfctl.output.printing import visible
from urdfctl.report.common import about_missing_packages, counted, is_robot, relative, shown
from urdfctl.report.concise import place
from urdfctl.report.words import about_unjoined, fix_in_words, notes
from urdfctl.source.workspaces.packages import package_around
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

    return min(max(get_terminal_size((WIDTH, 24)).columns or WIDTH, _NARROWEST), WIDTH)


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
    """Yield the parts of the report, with a blank line between findings. Lines are at most `width` columns wide."""
    shown_findings = _shown_findings(report)
    common = _common_notes(shown_findings)
    for number, diagnostic in enumerate(shown_findings):
        if number:
            yield Piece("\n")
        notes_left = tuple(note for note in diagnostic.notes if diagnostic.severity not in common.get(note, ()))
        yield from _finding(relative(diagnostic._replace(notes=notes_left)), width)
    if shown_findings and (common or report.statistics or not report.quiet):
        yield Piece("\n")
    for note, severities in common.items():
        yield Piece(wrapped(visible(_common_note(note, severities, shown_findings)), width))
    if report.statistics:
        yield from _statistics(report)
    if not report.quiet:
        yield from _summary(report, width)


def _shown_findings(report: Report) -> Sequence[Diagnostic]:
    """The findings without info, if there is something worse and info was not asked for."""
    worse = [finding for finding in report.findings if finding.severity is not Severity.INFO]
    is_asked = report.verbose or report.fail_on is Severity.INFO
    return report.findings if is_asked or not worse else worse


def _common_notes(findings: Sequence[Diagnostic]) -> dict[Remark, list[Severity]]:
    """The notes that all findings of a severity have, if there are several: they are said once."""
    common: dict[Remark, list[Severity]] = {}
    for severity in Severity:
        alike = [finding for finding in findings if finding.severity is severity]
        for note in alike[0].notes if len(alike) > 1 else ():
            if note.at is None and all(note in one.notes for one in alike):
                common.setdefault(note, []).append(severity)
    return common


def _common_note(note: Remark, severities: Sequence[Severity], findings: Sequence[Diagnostic]) -> str:
    is_of_all = all(finding.severity in severities for finding in findings)
    names = " and ".join(_plural(severity, 2) for severity in severities)
    return f"all {'of these' if is_of_all else names}: {note.message}"


def _finding(diagnostic: Diagnostic, width: int) -> Iterator[Piece]:
    head, kind = f"{place(diagnostic)}: ", f"{diagnostic.severity.value} {diagnostic.code}"
    if len(head) + len(kind) > width:
        yield Piece(f"{head.rstrip()}\n", "bold")
        head = "    "
    yield Piece(head, "bold")
    yield Piece(kind, f"{_COLOURS[diagnostic.severity]}{f' link {diagnostic.url}' if diagnostic.url else ''}")
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
    is_begun, is_ended = cut == 0 and diagnostic.excerpt_column == 1, cut + room >= len(text)
    text, start = text[cut : cut + room], max(0, min(start - cut, room - 1))
    text = _with_ellipses(text, at_start=not is_begun and start > 0, at_end=not is_ended and start < room - 1)
    end = start + at.end_column - at.column if at.end_line == at.line else len(text.rstrip())
    yield Piece(f"  {number} | ", "dim")
    yield Piece(f"{text}\n")
    yield Piece(f"  {margin} | ", "dim")
    yield Piece(f"{' ' * start}{'^' * max(min(end, len(text)) - start, 1)}\n", _COLOURS[diagnostic.severity])


def _with_ellipses(text: str, *, at_start: bool, at_end: bool) -> str:
    """Return a part of a line as wide as before, with an ellipsis where the line goes on."""
    text = f"…{text[1:]}" if at_start else text
    return f"{text[:-1]}…" if at_end else text


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
    if about := about_unjoined(report.unjoined):
        yield Piece(wrapped(visible(about), width))
    yield from _open_distro(report, width)
    if report.uncontrolled:
        hint = f"nothing controls the robot's joints; to generate control: {_generating(report)}"
        yield Piece(wrapped(visible(hint), width))
    if report.missing_packages:
        yield Piece(wrapped(visible(about_missing_packages(report.missing_packages)), width))
    counts = [f"{number} {_plural(severity, number)}" for severity in Severity if (number := report.count(severity))]
    if len(_shown_findings(report)) < len(report.findings):
        counts[-1] += " (--verbose shows it)"
    summary = f"{', '.join(counts) or 'no findings'} in {scope(report)}{_details(report)}"
    summary += f"; {report.known} hidden by the baseline" if report.known else ""
    yield Piece(wrapped(visible(summary + _fixable(report)), width), "bold")


def _generating(report: Report) -> str:
    """The command that generates control for the robot that has none, in a new package beside its own."""
    path = shown(report.uncontrolled)
    around = package_around(os.path.dirname(os.path.abspath(path)))
    name = f"{os.path.basename(path).partition('.')[0]}_control"
    output = shown(os.path.relpath(os.path.join(os.path.dirname(around) if around else os.curdir, name)))
    distros = {target.distro for target in report.targets if target.distro}
    distro = f" --distro {distros.pop()}" if len(distros) == 1 else ""
    return f"urdfctl gen-all {path}{distro} -o {output}"


def _plural(severity: Severity, number: int) -> str:
    return severity.value if severity is Severity.INFO or number == 1 else f"{severity.value}s"


def _fixable(report: Report) -> str:
    """How many findings have a fix that is made by an option."""
    fixes = [finding.fix for finding in report.findings if finding.fix and finding.fix.edits]
    safe = sum(fix.safe for fix in fixes)
    unsafe = len(fixes) - safe
    if safe and unsafe:
        return f"; {safe} fixable with --fix, {unsafe} more with --unsafe-fixes"
    return f"; {len(fixes)} fixable with {'--fix' if safe else '--unsafe-fixes'}" if fixes else ""


def _open_distro(report: Report, width: int) -> Iterator[Piece]:
    """That the distro is unknown, if that matters: a robot is controlled, or a finding is for some distros only."""
    possible = {distro for target in report.targets if target.distro is None for distro in target.distros}
    controlled = any(target.ros and target.distro is None for target in report.targets)
    partial = (note.message.startswith(APPLIES) for finding in report.findings for note in finding.notes)
    if len(possible) > 1 and (controlled or any(partial)):
        names = span_in_words(possible)
        how = 'add --distro NAME, or distro = "NAME" to urdfctl.toml, to check for yours'
        yield Piece(wrapped(f"ROS distro unknown ({names}): {how}", width))


def scope(report: Report) -> str:
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
    partly = "; some parts are not known" if not target.complete else ""
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
