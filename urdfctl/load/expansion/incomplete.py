"""Expand a description that cannot be expanded as it stands: it needs arguments, or lacks the prefix `xacro:`."""

from __future__ import annotations

from collections.abc import Mapping

from urdfctl.load.expansion.description import ExpandedDescription, MakeExpander, expanded_by, is_library, names_twice
from urdfctl.source.opaque import UNKNOWN
from urdfctl.source.problem import Problem, ProblemKind
from urdfctl.source.span import Place, SourceText
from urdfctl.source.xacro.expanded import HARMLESS, Expansion
from urdfctl.source.xacro.expansion import Expander
from urdfctl.source.xacro.leftovers import empty_arguments
from urdfctl.source.xacro.unknown import UnknownExpander

_MOST_ROUNDS = 4


def completed(
    make: MakeExpander, path: str, arguments: Mapping[str, str], *, alone: bool, first: ExpandedDescription
) -> ExpandedDescription:
    """Return the first expansion, or a better one if the description needs arguments or is a macro library."""
    read = first
    if not first.expander.is_library and any(p.kind not in HARMLESS for p in first.expansion.problems):
        read = expanded_with_unknown(make, path, arguments, alone=alone, first=first)
    if first.expander.macros and not read.expander.is_library and is_library(read.expansion):
        from urdfctl.source.xacro.library import LibraryExpander

        return expanded_by(make(LibraryExpander), path, arguments)
    return read


def expanded_with_unknown(
    make: MakeExpander, path: str, arguments: Mapping[str, str], *, alone: bool, first: ExpandedDescription
) -> ExpandedDescription:
    """Return the expansion with unknown values for what the description needs, and one problem that names it.

    It needs arguments that it uses and that have no default, and those whose empty default makes something fail. The
    first expansion is returned if it needs nothing.
    """
    empty: dict[str, None] = {}
    read = first
    for _ in range(_MOST_ROUNDS):
        found = {name: None for name in read.expander.blamed if alone and name not in empty}
        if not found and not (read is first and _asks(first.expansion, alone=alone)):
            break
        empty.update(found)
        expander = make(UnknownExpander)
        expander.any_argument = alone
        read = expanded_by(expander, path, {**arguments, **dict.fromkeys(empty, UNKNOWN)})
    if isinstance(read.expander, UnknownExpander) and read is not first:
        names, variables = read.expander.needed()
        names += [name for name in empty if name not in names]
        if names or variables:
            read.expansion.problems.append(_needs(names, variables, *read))
    return read


def expanded_with_salvage(
    make: MakeExpander, path: str, arguments: Mapping[str, str], *, alone: bool
) -> ExpandedDescription:
    """Return the expansion in which files that are not well-formed are read without their mistakes.

    It tells which files belong to the robot. What it says of the robot itself may be wrong.
    """

    def make_lenient(kind: type[Expander]) -> Expander:
        expander = make(kind)
        expander.salvages = True
        return expander

    kind = UnknownExpander if any(UNKNOWN in value for value in arguments.values()) else Expander
    first = expanded_by(make_lenient(kind), path, arguments)
    return completed(make_lenient, path, arguments, alone=alone, first=first)


def expanded_with_distinct_names(
    make: MakeExpander, path: str, arguments: Mapping[str, str], *, first: ExpandedDescription
) -> ExpandedDescription:
    """Return the expansion with unknown values for the arguments that would make repeated names different.

    A description of two arms takes a prefix for each. Both are empty by default, and every start sets them. The first
    expansion is returned if the names are repeated whatever the arguments are.
    """
    empty = list(empty_arguments(first.expander.declared, arguments))
    for names in ([name for name in empty if "prefix" in name], empty):
        if not names:
            continue
        expander = make(UnknownExpander)
        expander.any_argument = True
        read = expanded_by(expander, path, {**arguments, **dict.fromkeys(names, UNKNOWN)})
        if read.expansion.document is not None and not names_twice(read.expansion):
            read.expansion.problems.append(_needs(names, [], *read))
            return read
    return first


def expanded_with_prefixes(
    make: MakeExpander, path: str, arguments: Mapping[str, str], *, alone: bool, first: ExpandedDescription
) -> ExpandedDescription:
    """Return the expansion in which tags without the prefix are read as if they had it.

    The problems that are gone then follow from the missing prefix.
    """

    def make_lenient(kind: type[Expander]) -> Expander:
        expander = make(kind)
        expander.unprefixed = True
        return expander

    kind = type(first.expander)
    again = expanded_by(make_lenient(kind), path, arguments)
    read = completed(make_lenient, path, arguments, alone=alone, first=again)
    without = completed(make, path, arguments, alone=alone, first=first).expansion.problems
    left = {(problem.kind, problem.subject) for problem in read.expansion.problems}
    gone = [p for p in without if p.kind not in HARMLESS and (p.kind, p.subject) not in left]
    _blame_prefixes(read.expansion.problems, gone)
    return read


def _blame_prefixes(problems: list[Problem], gone: list[Problem]) -> None:
    """Count the problems that are gone as consequences of the missing prefixes: of those in the same file, if any."""
    missing = {p.at.source.path: at for at, p in enumerate(problems) if p.kind is ProblemKind.PREFIX_MISSING}
    for problem in gone if missing else ():
        at = missing.get(problem.at.source.path, next(iter(missing.values())))
        problems[at] = problems[at]._replace(follows=problems[at].follows + 1 + problem.follows)


def _asks(expansion: Expansion, *, alone: bool) -> bool:
    """Whether a value is asked for that nobody gives."""
    kinds = {problem.kind for problem in expansion.problems}
    return ProblemKind.UNDEFINED_VARIABLE in kinds or (alone and ProblemKind.UNDEFINED_ARGUMENT in kinds)


def _needs(arguments: list[str], variables: list[str], expander: Expander, expansion: Expansion) -> Problem:
    needed = " and ".join([*_listed("argument", arguments), *_listed("environment variable", variables)])
    pronoun = "it" if len(arguments) + len(variables) == 1 else "them"
    message = f"needs {needed}; what depends on {pronoun} is not checked"
    hint = f"pass it with --env {variables[0]}" if variables else ""
    hint = f"pass {arguments[0]}:=..., or name a launch file that does" if arguments else hint
    root = expansion.document.documentElement if expansion.document else None
    at = root.at if root is not None else Place(SourceText("", b""), 0, end=0)
    declared = [expander.declared[name].at["name"] for name in arguments if name in expander.declared]
    subject = " ".join((*arguments, *(f"${name}" for name in variables)))
    return Problem(ProblemKind.ARGUMENTS_NEEDED, (*declared, at)[0], message, subject, hint)


def _listed(what: str, names: list[str]) -> list[str]:
    return [f"{what}{'s' if len(names) > 1 else ''} {', '.join(names)}"] if names else []
