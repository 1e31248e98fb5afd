"""Say for which robots a finding holds, where a file serves several and not all of them have it."""

from __future__ import annotations

from collections.abc import Collection, Iterable, Iterator

from urdfctl.diagnostic import Diagnostic, Remark, Severity
from urdfctl.lint.results import TargetResult

_MOST_NAMES = 3
_Place = tuple[str, str, int]


def with_robots(results: Iterable[TargetResult], but: Collection[str]) -> list[TargetResult]:
    """Return the results, in which the errors and warnings of shared files have a note on the robots that show them.

    but: the codes of findings without such a note.
    """
    results = list(results)
    names = _names(results)
    if len(set(names)) < 2:  # noqa: PLR2004
        return results
    readers: dict[str, set[str]] = {}
    holders: dict[_Place, set[str]] = {}
    for result, name in zip(results, names, strict=True):
        if name:
            for file in result.files:
                readers.setdefault(file, set()).add(name)
            for finding in result.outcome.diagnostics:
                holders.setdefault(_place(finding), set()).add(name)

    def noted(finding: Diagnostic) -> Diagnostic:
        having, all_of_them = holders.get(_place(finding), set()), readers.get(finding.at.file, set())
        is_told = finding.severity is not Severity.INFO and finding.code not in but
        if not is_told or not having or not all_of_them - having:
            return finding
        note = Remark(f"this holds for {_listed(having)}, not for {_listed(all_of_them - having)}")
        return finding._replace(notes=(*finding.notes, note))

    return [
        result._replace(outcome=result.outcome._replace(diagnostics=[noted(one) for one in result.outcome.diagnostics]))
        for result in results
    ]


def _names(results: Iterable[TargetResult]) -> list[str]:
    """The names of the robots, one for each result: their files, with what is given to those that are several robots.

    Empty for what is no robot.
    """
    robots = [result if (result.links or 0) > 1 and not result.library else None for result in results]
    variants: dict[str, set[object]] = {}
    for robot in filter(None, robots):
        variants.setdefault(robot.path, set()).add(robot.arguments)
    return [_name(robot, len(variants[robot.path])) if robot else "" for robot in robots]


def _name(robot: TargetResult, variants: int) -> str:
    given = (f"{name}:={value}" for name, value in robot.arguments) if variants > 1 else ()
    return " ".join([robot.path, *given])


def _place(finding: Diagnostic) -> _Place:
    return finding.code, finding.at.file, finding.at.start


def _listed(names: Collection[str]) -> str:
    return ", ".join(_some(sorted(names)))


def _some(names: list[str]) -> Iterator[str]:
    yield from names[:_MOST_NAMES]
    if len(names) > _MOST_NAMES:
        yield f"and {len(names) - _MOST_NAMES} more"
