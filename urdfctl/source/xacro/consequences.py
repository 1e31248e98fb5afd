"""Keep the problems of one expansion: each once, and without those that only follow from an earlier one."""

from __future__ import annotations

from urdfctl.source.budget import MAX_PROBLEMS, OverBudget
from urdfctl.source.opaque import UNKNOWN
from urdfctl.source.problem import Problem, ProblemKind
from urdfctl.source.xml.dom import Element

_ABOUT_NAMES = {
    ProblemKind.UNDEFINED_NAME,
    ProblemKind.UNKNOWN_MACRO,
    ProblemKind.UNDEFINED_ARGUMENT,
    ProblemKind.XACRO,
}
OF_FILES = {ProblemKind.FILE_NOT_FOUND, ProblemKind.FILE_UNREADABLE}
OF_VALUES = {
    *OF_FILES,
    ProblemKind.OUTSIDE_WORKSPACE,
    ProblemKind.PACKAGE_NOT_FOUND,
    ProblemKind.PACKAGE_ABSENT,
    ProblemKind.CONDITION,
    ProblemKind.EXPRESSION,
    ProblemKind.UNKNOWN_MACRO,
    ProblemKind.XACRO,
}
"""The kinds of problems that an argument may cause whose value is empty."""
_ONCE_PER_FILE = (ProblemKind.PREFIX_MISSING,)
"""The kinds of problems that are mended in each file by itself. Others are reported once in a description."""
_DEFINING = frozenset(f"xacro:{name}" for name in ("include", "if", "unless", "property", "arg", "macro"))


def may_define_names(element: Element | None) -> bool:
    """Return whether names may be missing if an element could not be evaluated."""
    return element is not None and element.tagName in _DEFINING


class Problems:
    """The problems met so far. Once something that may define names could not be evaluated, problems about names are
    only counted."""

    def __init__(self) -> None:
        self.all: list[Problem] = []
        self._seen: set[tuple[ProblemKind, str, str, str]] = set()
        self._cause: int | None = None
        self.may_lack_names = False
        """Whether something that may define or use names could not be evaluated."""
        self.left_out = False
        """Whether something that may define or use names was ignored because a value is unknown."""

    def add(self, problem: Problem) -> None:
        """Add a problem, if it is new. Raises OverBudget if there are too many."""
        if self._is_new(problem):
            self.all.append(problem)
            if len(self.all) > MAX_PROBLEMS:
                raise OverBudget(f"more than {MAX_PROBLEMS} problems")

    def add_failure(self, problem: Problem, element: Element | None) -> None:
        """Add the problem because of which an element could not be evaluated.

        It is only counted if it most likely follows from an earlier one, and ignored if it is about an unknown
        value.
        """
        first, self.may_lack_names = not self.may_lack_names, self.may_lack_names or may_define_names(element)
        if UNKNOWN in problem.message:
            self.left_out = self.left_out or may_define_names(element)
            return
        if not first and _is_about_names(problem):
            self._count(problem)
            return
        before = len(self.all)
        self.add(problem)
        if first and self.may_lack_names and len(self.all) > before:
            self._cause = before

    def add_gap(self, problem: Problem) -> None:
        """Add the problem because of which parts of a file are left out, which may define names."""
        if not self.may_lack_names:
            self.may_lack_names, self._cause = True, len(self.all)
        self.add(problem)

    def _count(self, problem: Problem) -> None:
        if self._cause is not None and self._is_new(problem):
            cause = self.all[self._cause]
            self.all[self._cause] = cause._replace(follows=cause.follows + 1)

    def _is_new(self, problem: Problem) -> bool:
        file = problem.at.source.path if problem.kind in _ONCE_PER_FILE else ""
        key = (problem.kind, problem.subject, problem.message, file)
        if key in self._seen:
            return False
        self._seen.add(key)
        return True


def _is_about_names(problem: Problem) -> bool:
    to_forward = problem.kind is ProblemKind.MACRO_CALL and "no property" in problem.message
    return problem.kind in _ABOUT_NAMES or to_forward
