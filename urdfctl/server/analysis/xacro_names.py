"""The names that xacro gives: macros and their parameters, properties and arguments, in one file as it is written."""

from __future__ import annotations

import re
from collections.abc import Collection, Iterable, Iterator
from contextlib import suppress

from urdfctl.source.problem import ReadError
from urdfctl.source.span import SourceSpan, SourceText
from urdfctl.source.xml.dom import COMMENT, Element
from urdfctl.source.xml.parsing import parse

MACRO, PARAMETER, PROPERTY, ARGUMENT = "macro", "parameter", "property", "argument"

XacroName = tuple[str, str, SourceSpan, bool, str]
"""Kind, name, place, whether it is defined there, and the macro of a parameter."""

_EXPRESSION = rb"\$\{([^{}]*)\}"
_IDENTIFIER = rb"(?<![\w.'\"])[A-Za-z_]\w*(?!\w*['\"])"
_ARGUMENT = rb"\$\(arg\s+([\w.-]+)\s*\)"
_STRING = rb"'[^']*'|\"[^\"]*\""
_FORWARDED = rb"(?:^|\s)([A-Za-z_]\w*):?=(\^)"
_PARAMETER = rb"(?:^|\s)(\*{0,2})([A-Za-z_]\w*)"


def xacro_names(sources: Iterable[SourceText]) -> Iterator[XacroName]:
    """Yield the names in some files; none of those that cannot be parsed.

    A tag that is named as a macro of these files is a call also without the prefix, as in old files.
    """
    roots: list[Element] = []
    for source in sources:
        with suppress(ReadError):
            root = parse(source).documentElement
            roots += [root] if root is not None else []
    macros = {name for root in roots for name in _macros(root)}
    for root in roots:
        yield from _of_element(root, {}, macros)


def _macros(element: Element) -> Iterator[str]:
    if element.tagName == "xacro:macro":
        yield element.attrs.get("name", "").removeprefix("xacro:")
    for inner in element.elements():
        yield from _macros(inner)


def _of_element(element: Element, scopes: dict[str, str], macros: Collection[str]) -> Iterator[XacroName]:
    """The names of an element and those below it. scopes: the macros whose parameters are visible, by parameter."""
    tag = element.source.start_tag(element.start)
    if tag is None:
        return
    if element.tagName == "xacro:macro":
        name = element.attrs.get("name", "").removeprefix("xacro:")
        yield MACRO, name, element.at["name"].part(name).span, True, ""
        scopes = dict(scopes)
        for parameter, span in _parameters(element):
            scopes[parameter] = name
            yield PARAMETER, parameter, span, True, name
        yield from ((PROPERTY, parameter, span, False, "") for parameter, span in _forwarded(element))
    elif element.tagName in {"xacro:property", "xacro:arg"}:
        kind = PROPERTY if element.tagName == "xacro:property" else ARGUMENT
        yield kind, element.attrs.get("name", ""), element.at["name"].span, True, ""
    elif element.tagName == "xacro:insert_block":
        name = element.attrs.get("name", "")
        yield (PARAMETER if name in scopes else PROPERTY), name, element.at["name"].span, False, scopes.get(name, "")
    elif (called := element.tagName.removeprefix("xacro:")) in macros or (
        called != element.tagName and called not in _OWN
    ):
        yield from _of_call(element, called)
    for attribute, (start, end) in tag.attributes.items():
        is_bare = attribute == "value" and element.tagName in {"xacro:if", "xacro:unless"}
        yield from _in_text(SourceSpan(element.source, start, end), scopes, is_expression=is_bare)
    child = element.firstChild
    texts = [node for node in element.children() if getattr(node, "nodeType", 0) != COMMENT]
    if texts and not element.elements() and element.close is not None and child is not None:
        yield from _in_text(element.at.content.span, scopes)
    for inner in element.elements():
        yield from _of_element(inner, scopes, macros)


_OWN = frozenset("arg attribute call element if include insert_block macro property unless".split())


def _of_call(element: Element, name: str) -> Iterator[XacroName]:
    start = element.start + 1 + len(element.tagName) - len(name)
    yield MACRO, name, SourceSpan(element.source, start, start + len(name.encode())), False, ""
    if element.close is not None:
        closing = element.close + 2 + len(element.tagName) - len(name)
        span = SourceSpan(element.source, closing, closing + len(name.encode()))
        if span.text == name:
            yield MACRO, name, span, False, ""
    tag = element.source.start_tag(element.start)
    for attribute, (value, _) in tag.attributes.items() if tag else ():
        before = element.source.data.rfind(attribute.encode(), element.start, value)
        yield PARAMETER, attribute, SourceSpan(element.source, before, before + len(attribute.encode())), False, name


def _parameters(macro: Element) -> Iterator[tuple[str, SourceSpan]]:
    """The parameters of a macro: `a b:=1 c:='x y' *block`."""
    tag = macro.source.start_tag(macro.start)
    if tag is None or "params" not in tag.attributes:
        return
    start, end = tag.attributes["params"]
    data = macro.source.data[start:end]
    blank = re.sub(rb":?=\^?\|?(?:" + _STRING + rb"|\$\{[^}]*\}|\S*)", lambda found: b"=" * len(found[0]), data)
    for found in re.finditer(_PARAMETER, blank):
        name = found[2].decode()
        yield name, SourceSpan(macro.source, start + found.start(2), start + found.end(2))


def _forwarded(macro: Element) -> Iterator[tuple[str, SourceSpan]]:
    """The parameters of a macro that are what the caller has by that name: `a:=^`; with the place of the sign."""
    tag = macro.source.start_tag(macro.start)
    if tag is None or "params" not in tag.attributes:
        return
    start, end = tag.attributes["params"]
    for found in re.finditer(_FORWARDED, macro.source.data[start:end]):
        yield found[1].decode(), SourceSpan(macro.source, start + found.start(2), start + found.end(2))


def _in_text(span: SourceSpan, scopes: dict[str, str], *, is_expression: bool = False) -> Iterator[XacroName]:
    """The names in the expressions and substitutions of a text."""
    data = span.source.data[span.start : span.end]
    for found in re.finditer(_ARGUMENT, data):
        place = SourceSpan(span.source, span.start + found.start(1), span.start + found.end(1))
        yield ARGUMENT, place.text, place, False, ""
    parts = [(found.start(1), found[1]) for found in re.finditer(_EXPRESSION, data)]
    if is_expression and not parts and b"$(" not in data:
        parts = [(0, data)]
    for offset, expression in parts:
        plain = re.sub(_STRING, lambda found: b" " * len(found[0]), expression)
        for found in re.finditer(_IDENTIFIER, plain):
            start = span.start + offset + found.start()
            place = SourceSpan(span.source, start, start + len(found[0]))
            name = found[0].decode()
            yield (PARAMETER if name in scopes else PROPERTY), name, place, False, scopes.get(name, "")
