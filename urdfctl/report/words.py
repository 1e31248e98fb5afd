"""The notes and the fix of a finding, as sentences."""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Sequence

from urdfctl.diagnostic import CallStep, Diagnostic, Location, Remark, Repair
from urdfctl.lint.findings.likeness import named
from urdfctl.lint.results import Unjoined
from urdfctl.report.common import shown

MOST_CHAINS = 3
_MOST_STEPS = 8
_MOST_NAMES = 3
_MOST_IN_A_LINE = 10
_MOST_FILES = 4


def notes(diagnostic: Diagnostic) -> Iterator[str]:
    """Yield the places of equal findings, the calls that lead to one (the first three of many), then its notes."""
    if diagnostic.also:
        yield likewise(diagnostic)
    for chain in diagnostic.expanded_from[:MOST_CHAINS]:
        yield _chain(chain)
    if len(diagnostic.expanded_from) > MOST_CHAINS:
        more = len(diagnostic.expanded_from) - MOST_CHAINS
        yield f"and in {more} more call{'s' * (more > 1)}"
    for note in diagnostic.notes:
        yield note.message + (f" ({_where(note.at, diagnostic.at.file)})" if note.at else "")


_NO_ROBOT = "nothing here starts or describes a robot"


def about_unjoined(unjoined: Sequence[Unjoined]) -> str:
    """Return which launch files start controllers without a robot, or what is not here, and what to do."""
    lonely = [each for each in unjoined if each.controls and not each.leftover]  # a finding names what is left over
    parts = []
    if lonely:
        listed = _listed((f"{shown(each.path)} ({missing_fact(each)})" for each in lonely), _MOST_NAMES)
        how = f"to check one with its robot: urdfctl lint ROBOT {shown(lonely[0].path)}"
        parts.append(f"{_starting(lonely)} controllers without a robot that fits: {listed}; {how}")
    for absent in dict.fromkeys(what_it_starts(each) for each in unjoined if not each.controls):
        found = [each for each in unjoined if not each.controls and what_it_starts(each) == absent]
        listed = _listed((shown(each.path) for each in found), _MOST_NAMES)
        parts.append(f"{_starting(found)} {absent}: {listed}")
    return ". ".join(parts)


def _starting(unjoined: Sequence[Unjoined]) -> str:
    return "1 launch file starts" if len(unjoined) == 1 else f"{len(unjoined)} launch files start"


def what_it_starts(unjoined: Unjoined) -> str:
    """Return what a launch file that is joined with no robot starts, and why it is joined with none."""
    if unjoined.controls:
        return f"controllers without a robot: {missing_fact(unjoined)}"
    if unjoined.description:
        why = "does not exist" if unjoined.is_found_nowhere else "was not found"
        return f"a robot whose description '{shown(unjoined.description)}' {why}"
    if unjoined.gone and not unjoined.packages:
        path, why = unjoined.gone
        return f"launch file '{shown(path)}', which {why}"
    if unjoined.packages:
        what = "launch files" if unjoined.includes else "a robot"
        return f"{what} of {_quoted('package', unjoined.packages)}, not in this workspace"
    if unjoined.models:
        files = _listed((f"'{shown(model)}'" for model in unjoined.models), _MOST_NAMES)
        return f"a model from {files}; models in SDF are not checked"
    return f"a robot whose description {_undetermined(unjoined)}"


def _undetermined(unjoined: Unjoined) -> str:
    """Why the description of a launch file is not known."""
    names = unjoined.variables
    if not names:
        return "could not be determined"
    noun = "environment variable" if len(names) == 1 else "environment variables"
    listed = _listed((repr(name) for name in names), _MOST_NAMES)
    return f"depends on {noun} {listed}; give {'it' if len(names) == 1 else 'them'} with --env"


def missing_fact(unjoined: Unjoined) -> str:
    """Return why a launch file is joined with no robot."""
    return _not_known(unjoined) or _not_fitting(unjoined)


def _not_known(unjoined: Unjoined) -> str:
    """What is not known of the robot that a launch file starts itself; empty if it starts none."""
    if unjoined.packages:
        what = "launch files that it includes are" if unjoined.includes else "its description is"
        return f"{what} in {_quoted('package', unjoined.packages)}, not in this workspace"
    if unjoined.gone:
        path, why = unjoined.gone
        return f"launch file '{shown(path)}' that it includes {why}"
    if unjoined.description:
        return f"its description '{shown(unjoined.description)}' was not found"
    if unjoined.leftover:
        return "it is written for ROS 1, and its package is built for ROS 2"
    return f"its description {_undetermined(unjoined)}" if unjoined.undescribed else ""


def _not_fitting(unjoined: Unjoined) -> str:
    """Why none of the robots that are here is that of a launch file."""
    joints, controllers = _quoted("joint", unjoined.joints), _quoted("controller", unjoined.controllers)
    if unjoined.robot is None:
        wanted = joints if unjoined.joints else controllers
        return f"no robot here has {wanted}" if unjoined.joints or unjoined.controllers else _NO_ROBOT
    robot = shown(unjoined.robot)
    if unjoined.joints:
        return f"{robot} has no {joints}"
    told = f"nothing declares {controllers} for {robot}"
    return told if unjoined.controllers else f"it is not known to belong to {robot}"


def _quoted(noun: str, names: Sequence[str]) -> str:
    return f"{noun}{'s' * (len(names) > 1)} {_listed((repr(name) for name in names), _MOST_NAMES)}"


def likewise(diagnostic: Diagnostic) -> str:
    """Return the names and lines of the findings that one was joined with, and the files with copies of it."""
    here: list[Remark] = []
    first: dict[str, str] = {}
    for remark in diagnostic.also:
        if remark.at is None or remark.at.file == diagnostic.at.file:
            here.append(remark)
        else:
            first.setdefault(remark.at.file, f"{remark.at.file}:{remark.at.line}")
    elsewhere = _listed(first.values(), _MOST_FILES)
    parts = [_likewise_here(diagnostic, here) if here else "", elsewhere and f"in {elsewhere}"]
    return f"also {', and '.join(filter(None, parts))}"


def _likewise_here(diagnostic: Diagnostic, also: Sequence[Remark]) -> str:
    names = {remark: named(diagnostic.message, remark.message) for remark in also}
    lines = dict.fromkeys(str(remark.at.line) for remark in also if remark.at)
    if set(lines) == {str(diagnostic.at.line)}:  # the names are all that tells them apart
        return _listed(dict.fromkeys(name for name in names.values() if name), _MOST_IN_A_LINE)
    if lines and not any(names.values()):
        return f"in line{'s' * (len(lines) > 1)} {_listed(lines, _MOST_IN_A_LINE)}"
    items = [_item(names[remark], f"line {remark.at.line}" if remark.at else "") for remark in also]
    return _listed(dict.fromkeys(filter(None, items)), _MOST_NAMES)


def _item(name: str, place: str) -> str:
    """A name with its place, or the place alone."""
    return f"{name} ({place})" if name and place else name or place


def _listed(names: Iterable[str], most: int) -> str:
    items = list(names)
    if len(items) > most + 1:
        items[most:] = [f"{len(items) - most} more"]
    return " and ".join([part for part in (", ".join(items[:-1]), items[-1] if items else "") if part])


def paragraph(diagnostic: Diagnostic) -> list[str]:
    """Return the lines of a finding: its message, its notes, its fix."""
    lines = [diagnostic.message, *(f"note: {note}" for note in notes(diagnostic))]
    return [*lines, f"fix: {fix_in_words(diagnostic.fix)}"] if diagnostic.fix else lines


def fix_in_words(fix: Repair) -> str:
    """Return what a fix does, and whether it is safe, made by hand, or why it is unsafe."""
    kind = "by hand" if not fix.edits else "safe" if fix.safe else f"unsafe: {fix.reason}"
    return f"{fix.title} ({kind})"


def _where(at: Location, current: str) -> str:
    return f"line {at.line}" if at.file == current else f"{at.file}:{at.line}:{at.column}"


def _chain(chain: tuple[CallStep, ...]) -> str:
    """Return the calls and includes of a chain, innermost first. The middle of a long chain is left out."""
    steps = [_step(step) for step in chain]
    if len(steps) > _MOST_STEPS:
        steps[_MOST_STEPS - 1 : -1] = [f"and {len(steps) - _MOST_STEPS} more calls"]
    return ", ".join(steps)


def _step(step: CallStep) -> str:
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
