"""What xacro passes over without a word: tags without its prefix, braces without the dollar, arguments nobody uses."""

from __future__ import annotations

import re
from collections.abc import Collection, Iterable, Iterator, Mapping

from urdfctl.source.dom import COMMENT, Document, Element, Text
from urdfctl.source.problem import Problem, ProblemKind
from urdfctl.source.span import Place, SourceText
from urdfctl.suggest import did_you_mean, nearest

_DIRECTIVES = frozenset("arg attribute call element if include insert_block macro property unless".split())
_OF_URDF = frozenset(
    "actuator axis box calibration capsule child collision color command_interface contact cylinder dynamics gazebo "
    "geometry gpio group hardware hardwareInterface inertia inertial joint limit link mass material "
    "mechanicalReduction mesh mimic offset origin param parent plugin robot role ros2_control safety_controller sensor "
    "sphere state_interface texture transmission type verbose visual".split()
)
_ANYTHING_GOES = frozenset({"gazebo", "sensor", "plugin"})
_ASKED = rb"\$\(\s*arg\s+([^\s()]+)|\barg\(\s*['\"]([^'\"]+)|\$\(\s*eval\b([^<>]*)"
_BRACES = r"(?<!\$)\{\s*(\w+)\s*\}"


def leftovers(
    document: Document, sources: Iterable[SourceText], macros: Collection[str], properties: Collection[str]
) -> Iterator[Problem]:
    """The problems of an expanded tree, given the names of the macros and properties that were defined on the way."""
    known = {source.path for source in sources}
    suspects = (_DIRECTIVES | set(macros)) - _OF_URDF
    pending = [document.documentElement] if document.documentElement is not None else []
    while pending:
        element = pending.pop()
        for child in element.elements():
            if child.tagName in suspects and child.source.path in known:
                yield _without_prefix(child, child.tagName in macros)
            elif child.tagName not in _ANYTHING_GOES:
                pending.append(child)
        if any("{" in value for value in element.attrs.values()):
            yield from _braces(element, properties)


def _without_prefix(element: Element, is_macro: bool) -> Problem:  # noqa: FBT001 (one call)
    name = element.tagName
    what = f"<{name}> is a macro's name" if is_macro else f"<{name}> is a word of xacro's"
    message = f"{what}, and without the prefix 'xacro:' it is not expanded"
    return Problem(ProblemKind.PREFIX_MISSING, element.at, message, name, f"write <xacro:{name}>")


def _braces(element: Element, properties: Collection[str]) -> Iterator[Problem]:
    for attribute, value in element.attrs.items():
        for match in re.finditer(_BRACES, value):
            name = match.group(1)
            if name in properties:
                message = f"'{match.group(0)}' stays as it is: an expression begins with a dollar, '${{{name}}}'"
                hint = f"write ${{{name}}}"
                yield Problem(ProblemKind.BRACES, element.at[attribute], message, name, hint)


def repeated_condition(node: Element) -> Iterator[Problem]:
    """The problem of an `<xacro:if>` that is followed by one of the same condition and the same content: one of the two
    is meant to be an `<xacro:unless>`."""
    following = node.nextSibling
    while isinstance(following, Text) and (following.nodeType == COMMENT or not following.data.strip()):
        following = following.nextSibling
    if not isinstance(following, Element) or following.tagName != node.tagName:
        return
    ours, theirs = [c.tagName for c in node.elements()], [c.tagName for c in following.elements()]
    if (
        "".join(node.attrs.get("value", "").split()) == "".join(following.attrs.get("value", "").split())
        and ours == theirs
    ):
        other = "xacro:unless" if node.tagName == "xacro:if" else "xacro:if"
        message = f"two <{node.tagName}> of the same condition follow each other, and each brings <{'>, <'.join(ours)}>"
        yield Problem(ProblemKind.CONDITION_REPEATED, following.at, message, hint=f"one of them may be an <{other}>")


def unused_arguments(
    declared: Mapping[str, Element], given: Collection[str], sources: Iterable[SourceText], at: Place
) -> Iterator[Problem]:
    """The arguments that are declared, or given, and that none of the texts asks for."""
    used = set(_names_asked_for(sources))
    for name, element in declared.items():
        if name not in used:
            message = f"argument '{name}' is declared, and none of the files that were read uses it"
            missing = nearest(name, used - set(declared))
            also = f"; '{missing}' is used, and not declared" if missing else ""
            hint = f"is '{missing}' meant?" if missing else ""
            yield Problem(ProblemKind.UNUSED_ARGUMENT, element.at["name"], message + also, name, hint)
    for name in given:
        if name not in declared and name not in used:
            message = f"argument '{name}' is given, and the description has none of that name"
            yield Problem(ProblemKind.UNKNOWN_ARGUMENT, at, message + did_you_mean(name, declared), name)


def empty_default(declared: Element, name: str) -> Problem:
    """The problem of an argument that is empty by default, and with which a file's name then comes to nothing."""
    message = f"argument '{name}' is empty by default, and the name of a file needs it: expanding without it fails"
    hint = "leave the default out: then xacro asks for the argument; or name a file that serves"
    return Problem(ProblemKind.ARGUMENT_UNUSABLE, declared.at["name"], message, name, hint)


def _names_asked_for(sources: Iterable[SourceText]) -> Iterator[str]:
    """The names in `$(arg x)` and `arg('x')`, and every word of a `$(eval ...)`, where one may stand by itself."""
    for source in sources:
        for argument, quoted, expression in re.findall(_ASKED, source.data):
            yield from (word.decode(errors="replace") for word in (argument, quoted, *re.findall(rb"\w+", expression)))
