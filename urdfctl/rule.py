"""A rule: a fault with a check, one function that finds it in a project."""

from __future__ import annotations

from collections.abc import Callable, Iterator
from typing import TYPE_CHECKING

from urdfctl.diagnostic import Edit, Finding, Fix, Note, Severity
from urdfctl.fault import Fault, Stage, StageDependsOn
from urdfctl.model.project import Project

if TYPE_CHECKING:
    from typing_extensions import Unpack

    from urdfctl.fault import Declaration

Check = Callable[[Project], Iterator[Finding]]


class Rule(Fault):
    """A fault that lint finds in the files of a robot.

    check: yields the findings in a project.
    whole_robot: it does not run if a part of the robot could not be expanded.
    in_library: whether it runs on a macro library, where both branches of a condition are kept.
    """

    def __init__(
        self,
        check: Check,
        code: str,
        declared: Declaration,
        *,
        whole_robot: bool = False,
        in_library: bool = True,
    ) -> None:
        super().__init__(check, code, **declared)
        self.check = check
        self.whole_robot = whole_robot
        self.in_library = in_library


def rule(
    code: str, *, whole_robot: bool = False, in_library: bool = True, **declared: Unpack[Declaration]
) -> Callable[[Check], Rule]:
    """Make a check a rule. Its name and docstring are those of the fault; for the arguments, see `Rule` and `Fault`."""
    return lambda check: Rule(check, code, declared, whole_robot=whole_robot, in_library=in_library)


__all__ = [
    "Edit",
    "Finding",
    "Fix",
    "Note",
    "Project",
    "Rule",
    "Severity",
    "Stage",
    "StageDependsOn",
    "rule",
]
