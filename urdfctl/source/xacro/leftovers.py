"""Find what xacro silently ignores: tags without its prefix, braces without the dollar sign, unused arguments."""

from __future__ import annotations

import os
import re
from collections.abc import Collection, Iterable, Iterator, Mapping

from urdfctl.names import did_you_mean, nearest
from urdfctl.source.disk.gate import is_folder, matching
from urdfctl.source.problem import Problem, ProblemKind
from urdfctl.source.span import Place, SourceText
from urdfctl.source.xacro.prefixes import ANYTHING_GOES, lacks_prefix, without_prefix
from urdfctl.source.xml.dom import COMMENT, Document, Element, XmlText

_ASKED = rb"\$\(\s*arg\s+([^\s()]+)|\barg\(\s*['\"]([^'\"]+)|\$\(\s*eval\b([^<>]*)"
_NAMES = ("name", "reference", "prefix")
_BRACES = r"(?<!\$)\{\s*(\w+)\s*\}"


def leftovers(
    document: Document, sources: Iterable[SourceText], macros: Collection[str], properties: Collection[str]
) -> Iterator[Problem]:
    """Yield the problems of an expanded tree, given the names of the macros and properties that are defined."""
    known = {source.path for source in sources}
    pending = [document.documentElement] if document.documentElement is not None else []
    while pending:
        element = pending.pop()
        for child in element.elements():
            if lacks_prefix(child, macros) and child.source.path in known:
                yield without_prefix(child, (), macros)
            elif child.tagName not in ANYTHING_GOES:
                pending.append(child)
        if any("{" in value for value in element.attrs.values()):
            yield from _braces(element, properties)


def _braces(element: Element, properties: Collection[str]) -> Iterator[Problem]:
    for attribute, value in element.attrs.items():
        for match in re.finditer(_BRACES, value):
            name = match.group(1)
            if name in properties:
                message = f"'{match.group(0)}' is not expanded: an expression starts with '$', as in '${{{name}}}'"
                hint = f"write ${{{name}}}"
                yield Problem(ProblemKind.BRACES, element.at[attribute], message, name, hint)


def repeated_condition(node: Element) -> Iterator[Problem]:
    """Yield the problem of two `<xacro:if>` in a row with the same condition that add the same, by tags and names. One
    of them was probably meant to be an `<xacro:unless>`."""
    following = node.nextSibling
    while isinstance(following, XmlText) and (following.nodeType == COMMENT or not following.data.strip()):
        following = following.nextSibling
    if not isinstance(following, Element) or following.tagName != node.tagName:
        return
    if _condition(node) == _condition(following) and _named(node) == _named(following):
        other = "xacro:unless" if node.tagName == "xacro:if" else "xacro:if"
        added = ">, <".join(child.tagName for child in node.elements())
        message = f"two <{node.tagName}> in a row have the same condition, and each adds <{added}>"
        yield Problem(ProblemKind.CONDITION_REPEATED, following.at, message, hint=f"change one of them to <{other}>")


def _condition(node: Element) -> str:
    return "".join(node.attrs.get("value", "").split())


def _named(node: Element) -> list[tuple[str, str | None]]:
    """The children of an element, each with what makes it another one beside others of its tag: its name, or the
    first name in it."""
    return [(child.tagName, next(_names(child), None)) for child in node.elements()]


def _names(element: Element) -> Iterator[str]:
    yield from (element.attrs[name] for name in _NAMES if name in element.attrs)
    for child in element.elements():
        yield from _names(child)


def unused_arguments(
    declared: Mapping[str, Element],
    given: Collection[str],
    sources: Iterable[SourceText],
    at: Place,
    undefined: Collection[str] = (),
) -> Iterator[Problem]:
    """Yield the arguments that are declared or given, but that no text uses.

    undefined: the arguments that are already reported as used but not declared.
    """
    used = set(_names_asked_for(sources))
    for name, element in declared.items():
        if name not in used:
            message = f"argument '{name}' is declared but not used in any file of this robot"
            missing = nearest(name, used - set(declared))
            if missing in undefined:
                continue
            also = f"; '{missing}' is used but not declared" if missing else ""
            hint = f"rename it to '{missing}'" if missing else ""
            yield Problem(ProblemKind.UNUSED_ARGUMENT, element.at["name"], message + also, name, hint)
    for name in given:
        if name not in declared and name not in used:
            message = f"argument '{name}' is given, but the description does not declare it"
            yield Problem(ProblemKind.UNKNOWN_ARGUMENT, at, message + did_you_mean(name, declared), name)


def empty_arguments(declared: Mapping[str, Element], given: Collection[str]) -> dict[str, Element]:
    """Return the arguments that are empty by default and not given, each with its declaration."""
    return {
        name: element
        for name, element in declared.items()
        if name not in given and not element.attrs.get("default", "-").strip()
    }


def placeholders(
    path: str, declared: Mapping[str, Element], given: Collection[str], behind: Collection[str]
) -> Iterator[str]:
    """Yield the arguments behind a missing file whose default only stands for a value: with others, files exist. They
    come in the order of their declarations.

    path: the missing file. behind: the arguments that its name depends on.
    """
    from glob import escape

    folder = os.path.dirname(path)
    while not is_folder(folder) and folder != os.path.dirname(folder):
        folder = os.path.dirname(folder)
    rest = escape(os.path.relpath(path, folder))
    defaults = {name: escape(tag.attrs.get("default", "")) for name, tag in declared.items() if name in behind}
    found = {name: text for name, text in defaults.items() if name not in given and text and text in rest}
    for text in sorted(found.values(), key=len, reverse=True):
        rest = rest.replace(text, "*")
    is_pattern = found and re.search(r"[\w.]", rest.replace("*", "").replace(os.sep, ""))
    if is_pattern and matching(os.path.join(escape(folder), rest)):
        yield from found


def empty_default(declared: Element, name: str) -> Problem:
    """Return the problem of an argument that is empty by default and leaves a file name empty."""
    message = f"argument '{name}' is empty by default, but a file name needs it; xacro fails unless it is given"
    hint = "remove the default, so that xacro requires the argument; or set it to an existing file"
    return Problem(ProblemKind.ARGUMENT_UNUSABLE, declared.at["name"], message, name, hint)


def _names_asked_for(sources: Iterable[SourceText]) -> Iterator[str]:
    """Yield the names in `$(arg x)` and `arg('x')`, and all words of a `$(eval ...)`, which can use bare names."""
    for source in sources:
        for argument, quoted, expression in re.findall(_ASKED, source.data):
            yield from (word.decode(errors="replace") for word in (argument, quoted, *re.findall(rb"\w+", expression)))
