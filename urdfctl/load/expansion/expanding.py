"""Expand a description with the arguments that are known, and as well as possible without the others."""

from __future__ import annotations

from collections.abc import Mapping

from urdfctl.load.expansion.description import ExpandedDescription, MakeExpander, expanded_by, is_library, names_twice
from urdfctl.source.opaque import UNKNOWN
from urdfctl.source.problem import ProblemKind
from urdfctl.source.xacro.expanded import HARMLESS
from urdfctl.source.xacro.expansion import Expander


def expanded(
    make: MakeExpander, path: str, arguments: Mapping[str, str], *, fragment: bool = False, alone: bool = True
) -> ExpandedDescription:
    """Return the expansion of a description.

    fragment: True if the description is only a part, which other files include.
    alone: True if nothing says with which arguments it is started. Then those that it needs are unknown.
    """
    expander = make(_kind(fragment, arguments))
    expander.any_argument = alone
    first = expanded_by(expander, path, arguments)
    if any(problem.kind is ProblemKind.PREFIX_MISSING for problem in first.expansion.problems):
        from urdfctl.load.expansion.incomplete import expanded_with_prefixes

        return expanded_with_prefixes(make, path, arguments, alone=alone, first=first)
    is_plain = not first.expander.macros and all(p.kind in HARMLESS for p in first.expansion.problems)
    if is_plain or (first.expansion.complete and not is_library(first.expansion)):
        return _with_distinct_names(make, path, arguments, first) if alone and names_twice(first.expansion) else first
    from urdfctl.load.expansion.incomplete import completed

    return completed(make, path, arguments, alone=alone, first=first)


def _kind(fragment: bool, arguments: Mapping[str, str]) -> type[Expander]:  # noqa: FBT001 (one call)
    if fragment:
        from urdfctl.source.xacro.library import LibraryExpander

        return LibraryExpander
    if any(UNKNOWN in value for value in arguments.values()):
        from urdfctl.source.xacro.unknown import UnknownExpander

        return UnknownExpander
    return Expander


def _with_distinct_names(
    make: MakeExpander, path: str, arguments: Mapping[str, str], first: ExpandedDescription
) -> ExpandedDescription:
    from urdfctl.load.expansion.incomplete import expanded_with_distinct_names

    return expanded_with_distinct_names(make, path, arguments, first=first)
