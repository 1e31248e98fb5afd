"""What the expansion of a file gives, and which problems it survives whole."""

from __future__ import annotations

from urdfctl.source.problem import Problem, ProblemKind
from urdfctl.source.xml.dom import Document
from urdfctl.startup.records import NamedTuple

HARMLESS = {
    ProblemKind.LATE_DECLARATION,
    ProblemKind.XACRO_WARNING,
    ProblemKind.DUPLICATE_MACRO,
    ProblemKind.MACRO_OF_OTHER_FILE,
    ProblemKind.ARGUMENT_UNUSABLE,
    ProblemKind.UNUSED_ARGUMENT,
    ProblemKind.UNKNOWN_ARGUMENT,
    ProblemKind.MANIFEST_MISSING,
    ProblemKind.CONDITION_REPEATED,
    ProblemKind.PREFIX_MISSING,
    ProblemKind.BRACES,
}
"""Problems that do not remove a part of the robot."""


class Expansion(NamedTuple):
    """The expansion of one file.

    document: the expanded tree; None if there is none.
    problems: the problems that were found.
    library: True for a macro library, whose macros were called with unknown values.
    """

    document: Document | None
    problems: list[Problem]
    library: bool = False
    partial: bool = False
    """Whether parts are left out because an argument is unknown."""

    @property
    def complete(self) -> bool:
        """False where a problem or an unknown argument cost a part of the robot."""
        whole = self.document is not None and not self.library and not self.partial
        return whole and all(p.kind in HARMLESS for p in self.problems)
