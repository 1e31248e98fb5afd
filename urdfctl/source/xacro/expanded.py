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
        """False where a problem or an unknown argument cost a part of the robot, or Webots adds one."""
        whole = self.document is not None and not self.library and not self.partial and not self._is_for_webots
        return whole and all(p.kind in HARMLESS for p in self.problems)

    @property
    def _is_for_webots(self) -> bool:
        """Whether a description only tells Webots which devices a robot of its world has (webots_ros2_driver
        WebotsNode.cpp reads `<webots>`): there are the links and joints."""
        root = self.document.documentElement if self.document else None
        tags = {child.tagName for child in root.elements()} if root else set()
        return "webots" in tags and "link" not in tags
