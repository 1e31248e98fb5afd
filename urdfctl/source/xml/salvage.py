"""Read what stands around the mistakes in a file that is not well-formed.

Nothing is guessed in their place: the tag, the comment or the reference with the mistake is read as blanks, so that all
else stays where it is. The tree tells which files a description names, not what the robot is.
"""

from __future__ import annotations

import re
from pyexpat import ExpatError, errors

from urdfctl.source.problem import Problem, ReadError
from urdfctl.source.span import Call, SourceText
from urdfctl.source.xml.dom import Cloning, Document, Element
from urdfctl.source.xml.parsing import TreeBuilder, parse

_MOST_MISTAKES = 20
_ROOT = "robot"
_REFERENCE = re.compile(rb"&[^;<&\"'\s]*;?")
_LONGEST_NAME = 40
_NOT_LINES = re.compile(rb"[^\r\n]")


def read_around(
    source: SourceText, cloning: Cloning, call: Call | None, *, declarations: bool
) -> tuple[Document, Problem | None]:
    """Return the tree of a file as `parse` does, or what can be salvaged of it and its first mistake. Raises ReadError
    if nothing can."""
    try:
        return parse(source, cloning, call, declarations=declarations), None
    except ReadError as error:
        document = salvaged(source, cloning, call)
        if document is None:
            raise
        return document, error.problem


def salvaged(source: SourceText, cloning: Cloning, call: Call | None = None) -> Document | None:
    """Return the tree of a description without the tags that are not well-formed; None if too little is left.

    For cloning and call, see `parse`. Elements have their places in the file as it is.
    """
    data = source.data
    for _ in range(_MOST_MISTAKES):
        builder = TreeBuilder(source, cloning, call, declarations=False)
        try:
            builder.read(data)
        except ReadError:
            return None
        except ExpatError as error:
            current = builder.current if isinstance(builder.current, Element) else None
            less = _without(data, error.code, min(builder.parser.ErrorByteIndex, len(data)), current)
            if less is None or less == data:
                return None
            data = less
        else:
            root = builder.document.documentElement
            return builder.document if root is not None and root.tagName == _ROOT else None
    return None


def _without(data: bytes, code: int, at: int, current: Element | None) -> bytes | None:
    """The file without one mistake; None if nothing is known to leave out.

    code, at: expat's error, and the byte where it stopped. current: the element that is open there.
    """
    said = errors.messages[code]
    if said == errors.XML_ERROR_TAG_MISMATCH:
        return _without_mismatch(data, max(data.rfind(b"</", 0, at + 1), 0), current)
    if said == errors.XML_ERROR_NO_ELEMENTS and current is not None:
        return data + b"".join(f"</{name}>".encode() for name in _open_names(current))
    if said == errors.XML_ERROR_JUNK_AFTER_DOC_ELEMENT:
        return _blank(data, at, len(data))
    if said == errors.XML_ERROR_UNDEFINED_ENTITY:
        return _without_reference(data, at)
    if said == errors.XML_ERROR_DUPLICATE_ATTRIBUTE:
        return _without_tag(data, data.rfind(b"<", 0, at + 1), at)
    return _without_token(data, at) if said == errors.XML_ERROR_INVALID_TOKEN else None


def _open_names(current: Element) -> list[str]:
    """The names of the elements that are open, innermost first."""
    names = [current.tagName]
    while isinstance(current.parentNode, Element):
        current = current.parentNode
        names.append(current.tagName)
    return names


def _without_mismatch(data: bytes, end_tag: int, current: Element | None) -> bytes | None:
    """Leave out an end tag that nothing is open for, or else the start tag of the element that it does not close."""
    if current is None:
        return None
    name = re.split(rb"[\s>]", data[end_tag + 2 : end_tag + 200], maxsplit=1)[0].decode("utf-8", "replace")
    if name in _open_names(current)[1:]:
        return _without_tag(data, current.start, current.start)
    return _without_tag(data, end_tag, end_tag)


def _without_token(data: bytes, at: int) -> bytes | None:
    comment = data.rfind(b"<!--", 0, at)
    closed = data.find(b"-->", comment + 4) if comment >= 0 else -1
    if comment >= 0 and closed >= at - len(b"-->"):
        return _blank(data, comment, closed + len(b"-->"))
    without = _without_reference(data, at)
    opened = data.rfind(b"<", 0, at)
    if without is None and opened > data.rfind(b">", 0, at):
        return _without_tag(data, opened, at)
    return without or _blank(data, at, at + 1)


def _without_reference(data: bytes, at: int) -> bytes | None:
    """Leave out the `&` before a byte, with the name behind it; None if there is none."""
    start = data.rfind(b"&", max(0, at - _LONGEST_NAME), at + 1)
    reference = _REFERENCE.match(data, start) if start >= 0 else None
    return _blank(data, *reference.span()) if reference and reference.end() >= at else None


def _without_tag(data: bytes, opened: int, at: int) -> bytes:
    """Leave out a tag: up to its `>`, or up to the next tag if that comes first."""
    following, closed = data.find(b"<", max(at, opened + 1)), data.find(b">", at)
    if following >= 0 and not 0 <= closed < following:
        return _blank(data, opened, following)
    return _blank(data, opened, closed + 1 if closed >= 0 else len(data))


def _blank(data: bytes, start: int, end: int) -> bytes:
    return data[:start] + _NOT_LINES.sub(b" ", data[start:end]) + data[end:]
