"""Group equal findings: one finding, with the places of the others.

Findings of one file are equal if their words are. In several files they are one fault if these were copied from each
other, so that the findings are on the same line of text; if one cause is outside of them: a missing package or mesh;
or if all are written in the same old way.
"""

from __future__ import annotations

from collections import Counter
from collections.abc import Callable, Iterable, Sequence

from urdfctl.catalog.distros import APPLIES
from urdfctl.diagnostic import Diagnostic, Remark, Repair, Severity, ShownEdit
from urdfctl.lint.findings.likeness import shape

MOST_ERRORS = 3
"""Up to this many equal errors in a file are shown one by one, each with its line: each must be repaired."""
MOST_OF_A_RULE = 10
"""From this many findings of a rule in a file on, all of one severity are one finding, equal or not."""

MOST_IN_SOME_DISTROS = 2
"""The same for warnings that depend on the distro, which is unknown: they say more about that than about the file."""

Group = list[Diagnostic]
Key = Callable[[Diagnostic], object]


def _package(finding: Diagnostic) -> object:
    return finding.message.partition(" (")[0]


def _folder(finding: Diagnostic) -> object:
    """The folder of the mesh that is the last name of a message before its hint."""
    return finding.message.partition("; did you mean")[0].rpartition("/")[0].rpartition("'")[2]


def _message(finding: Diagnostic) -> object:
    return finding.message


def _install_rules(finding: Diagnostic) -> object:
    """The manifest of the package."""
    return next((note.at.file for note in finding.notes if note.at), finding.at.file)


_OUTSIDE: dict[str, Key] = {
    "UC003": _package,
    "UC149": _folder,
    "UC150": _package,
    "UC359": _message,
    "UC615": _install_rules,
}
"""What is missing or wrong outside of the files, by rule: findings in several files are one fault if it is the same."""

_HABIT = "UC018"
"""The rule on a way to write that older distros took: in all files of a workspace it is one matter."""


def grouped(findings: Iterable[Diagnostic]) -> list[Diagnostic]:
    """Return the findings, with equal ones of a file joined, in the order of their first places.

    At one place, also those of different severity are joined: the worst is shown.
    """
    groups = _joined([[finding] for finding in findings], _likeness)
    groups = [part for group in groups for part in _apart(group)]
    groups = _joined(groups, _place)
    counts = Counter(_rule_in_file(group[0]) for group in groups)

    def of_many(finding: Diagnostic) -> object:
        place = _rule_in_file(finding)
        most = MOST_IN_SOME_DISTROS if _depends_on_distro(finding) else MOST_OF_A_RULE
        return (place, finding.severity) if counts[place] > most else finding.order

    if max(counts.values(), default=0) > MOST_IN_SOME_DISTROS:
        groups = _joined(groups, of_many)
    groups = _joined(groups, _copy)
    return sorted(map(_one, groups), key=lambda finding: finding.order)


def _apart(group: Group) -> list[Group]:
    """A few errors stay apart: each is shown with its line."""
    is_short = len(group) <= MOST_ERRORS and group[0].severity is Severity.ERROR
    return [[finding] for finding in group] if is_short else [group]


def _rule_in_file(finding: Diagnostic) -> tuple[str, str, bool]:
    return finding.code, finding.at.file, _depends_on_distro(finding)


def _depends_on_distro(finding: Diagnostic) -> bool:
    return finding.severity is not Severity.ERROR and bool(_applies(finding))


def _applies(finding: Diagnostic) -> tuple[str, ...]:
    return tuple(note.message for note in finding.notes if note.message.startswith(APPLIES))


def _likeness(finding: Diagnostic) -> object:
    """What equal findings have in common: rule, file, severity, words, kind of fix, and the distros they apply to."""
    if finding.code in _OUTSIDE:
        return finding.code, finding.severity, _OUTSIDE[finding.code](finding)
    if finding.code == _HABIT and finding.severity is not Severity.ERROR:
        return finding.code, finding.severity, _kind(finding), _applies(finding)
    words = shape(finding.message)
    return finding.code, finding.at.file, finding.severity, words, _kind(finding), _applies(finding)


def _copy(finding: Diagnostic) -> object:
    """What findings in files that were copied from each other have in common: also the line of text, but for blanks.

    Each error keeps its place, because all must be repaired, and so does what a fix repairs file by file.
    """
    has_edits = finding.fix is not None and finding.fix.edits
    if finding.severity is Severity.ERROR or has_edits or finding.code in _OUTSIDE or not finding.excerpt:
        return finding.order
    text = "".join(finding.excerpt.split())
    return finding.code, finding.severity, shape(finding.message), _kind(finding), text


def _kind(finding: Diagnostic) -> tuple[bool, bool] | None:
    """Whether its fix is safe, and whether it can be made automatically; None without a fix."""
    return (finding.fix.safe, bool(finding.fix.edits)) if finding.fix else None


def _place(finding: Diagnostic) -> object:
    """What equal findings at one place have in common."""
    at = finding.at
    if finding.severity is Severity.ERROR:
        return finding.order
    return finding.code, at.file, at.start, at.end, shape(finding.message), _kind(finding)


def _joined(groups: Sequence[Group], key: Key) -> list[Group]:
    """Groups of one rule with the same key as one group."""
    joined: dict[object, Group] = {}
    of_rule = Counter(group[0].code for group in groups)
    for group in groups:
        first = group[0]
        joined.setdefault(key(first) if of_rule[first.code] > 1 else first.order, []).extend(group)
    return list(joined.values())


def _one(group: Group) -> Diagnostic:
    if len(group) == 1:
        return group[0]
    first = max(group, key=lambda finding: finding.severity.weight)
    others = tuple(Remark(finding.message, finding.at) for finding in group if finding is not first)
    if len({_applies(finding) for finding in group}) > 1:
        first = first._replace(notes=tuple(note for note in first.notes if not note.message.startswith(APPLIES)))
    return first._replace(also=others, fix=_fix([finding.fix for finding in group if finding.fix]))


def _fix(fixes: Sequence[Repair]) -> Repair | None:
    """Return one fix that makes the edits of all. Edits that cannot be made together are left to a second run."""
    if len(fixes) < 2:  # noqa: PLR2004 (one fix stays as it is)
        return fixes[0] if fixes else None
    edits = _together([edit for fix in fixes for edit in fix.edits])
    titles = {fix.title for fix in fixes}
    places = len({edit.at for fix in fixes for edit in fix.edits})
    title = fixes[0].title
    if len(titles) > 1:
        title += f", and {len(fixes) - 1} more like it"
    elif places > 1:
        title += f" in {places} places"
    doubt = next((fix.doubt for fix in fixes if fix.doubt), "")
    return Repair(title, all(fix.safe for fix in fixes), edits, doubt)


def _together(edits: Sequence[ShownEdit]) -> tuple[ShownEdit, ...]:
    """Return edits that do not overlap. Texts that are inserted at one place are joined."""
    kept: dict[tuple[str, int, int], ShownEdit] = {}
    end: dict[str, int] = {}
    for edit in sorted(dict.fromkeys(edits), key=lambda edit: (edit.file, edit.start, edit.end)):
        place = edit.file, edit.start, edit.end
        if place in kept and edit.start == edit.end:
            kept[place] = edit._replace(text=kept[place].text + edit.text)
        elif edit.start >= end.get(edit.file, 0):
            kept[place] = edit
            end[edit.file] = edit.end
    return tuple(kept.values())
