"""Name the mistake behind an error of the XML parser, at the byte to edit."""

from __future__ import annotations

import re

from urdfctl.source.problem import Problem, ProblemKind
from urdfctl.source.span import BOM, Place, SourceText
from urdfctl.source.xml.dom import Element
from urdfctl.startup.records import NamedTuple

LATE_DECLARATION = "declaration"
"""The subject of a problem with text before `<?xml ...?>`."""
_LONGEST_NAME = 40
_OPEN_REFERENCE = re.compile(rb"&#?\w*[^\w;]?\Z")
_OPEN_EXPRESSION = re.compile(rb"\$\{[^{}]*\Z")
_UNQUOTED = re.compile(rb"\s([\w:.-]+)\s*=\s*\Z")
_ATTRIBUTE = re.compile(rb"\s([\w:.-]+)\s*=\s*(\"[^\"]*\"|'[^']*')")
_OPEN_VALUE = re.compile(
    rb"<[\w:.-]+(?:\s+[\w:.-]+\s*=\s*(?:\"[^\"]*\"|'[^']*'))*\s+([\w:.-]+)\s*=\s*(?:\"[^\"]*|'[^']*)\Z"
)
_SWALLOWED = re.compile(rb"(?:.*\S)?\s[\w:.-]+\s*=\s*\Z", re.DOTALL)
_FOLLOWING = re.compile(rb"([A-Za-z_][\w:.-]*)\s*=\s*[\"']")
_UNEQUAL = re.compile(rb"\s+([A-Za-z_][\w:.-]*)\s*")
_OUTSIDE = re.compile(rb"(?:(?!\s+[A-Za-z_][\w:.-]*\s*=|\s*/?>|[<\n]).){1,200}")
_LONGEST_TAG = 4000


class _Mistake(NamedTuple):
    """What is wrong, what to do, and the bytes to edit; without an end, the word at the start."""

    message: str
    hint: str
    start: int
    end: int | None = None


def syntax_problem(
    source: SourceText, offset: int, error: str, root: Element | None, open_element: Element | None
) -> Problem:
    """Return the problem for an error of expat.

    offset: the byte at which expat stopped. error: its message. root: the root element, if it was read.
    open_element: the element that is not closed there.
    """
    offset = max(0, min(offset, len(source.data)))
    said = error.split(": line ", maxsplit=1)[0]
    subject, message, hint = "", f"not well-formed XML: {said}", ""
    end = None
    if not source.data.removeprefix(BOM).strip():
        message, offset = "the file is empty", 0
    elif said.startswith("XML or text declaration not at start"):
        message = "the XML declaration <?xml ...?> is not at the start of the file"
        hint = "remove the spaces, lines or comments before it"
        subject = LATE_DECLARATION
    elif said.startswith("junk after document element"):
        message = "text after the end of the root element"
        hint = f"move it before </{root.tagName if root is not None else 'robot'}>, or remove it"
    elif said.startswith("unbound prefix"):
        return _unbound_prefix(source, offset, root)
    elif said.startswith("mismatched tag"):
        return _mismatched_tag(source, offset, open_element)
    elif said.startswith(("no element found", "unclosed token")):
        message, hint = _unfinished(source, said, open_element)
    elif said.startswith("syntax error"):
        message = "not XML: an XML file starts with a tag"
    elif said.startswith("undefined entity"):
        hint = "XML defines only &amp; &lt; &gt; &quot; &apos;"
    elif said.startswith("not well-formed"):
        message, hint, offset, end = _invalid_token(source, offset)
    at = Place(source, offset, end=_token_end(source, offset) if end is None else end)
    return Problem(ProblemKind.XML_SYNTAX, at, message, subject, hint)


def _token_end(source: SourceText, offset: int) -> int:
    end = source.data.find(b"\n", offset)
    token = source.data[offset : end if end >= 0 else len(source.data)].split(maxsplit=1)
    return offset + (len(token[0]) if token and source.data[offset : offset + 1].strip() else 0)


def _unbound_prefix(source: SourceText, offset: int, root: Element | None) -> Problem:
    tag = source.start_tag(offset)
    names = [tag.name, *tag.attributes] if tag else []
    prefix = next((name.split(":")[0] for name in names if ":" in name and not name.startswith("xml")), "xacro")
    uri = "http://www.ros.org/wiki/xacro" if prefix == "xacro" else "..."
    used = Place(source, offset)
    at = root.at if root is not None else used
    message = f"prefix '{prefix}:' is not declared in the root element"
    hint = f'add xmlns:{prefix}="{uri}" to the root element'
    return Problem(ProblemKind.XML_SYNTAX, at, message, prefix, hint, used=used if at.start != offset else None)


def _mismatched_tag(source: SourceText, offset: int, open_element: Element | None) -> Problem:
    offset = max(source.data.rfind(b"</", 0, offset + 1), 0)
    found = _tag_name(source, offset + 2)
    message = f"end tag </{found}> has no matching start tag"
    if open_element is not None:
        name, line = open_element.tagName, source.position(open_element.start).line
        message = f"<{name}> in line {line} is not closed: expected </{name}>, found </{found}>"
    return Problem(ProblemKind.XML_SYNTAX, Place(source, offset, end=_token_end(source, offset)), message)


def _tag_name(source: SourceText, offset: int) -> str:
    return re.split(rb"[\s>]", source.data[offset : offset + 200], maxsplit=1)[0].decode("utf-8", "replace")


def _unfinished(source: SourceText, said: str, open_element: Element | None) -> tuple[str, str]:
    if open_element is None:
        return f"not well-formed XML: {said}", ""
    line = source.position(open_element.start).line
    return f"<{open_element.tagName}> in line {line} has no end tag", f"close it with </{open_element.tagName}>"


def _invalid_token(source: SourceText, offset: int) -> _Mistake:
    """The mistake behind an unexpected byte."""
    data = source.data
    try:
        data.decode("utf-8")
    except UnicodeDecodeError as error:
        return _Mistake(f"byte 0x{data[error.start]:02x} is not valid UTF-8", "save the file as UTF-8", error.start)
    if b"\x00" in data:
        return _Mistake("the file is binary, not XML", "", data.index(b"\x00"))
    opened = data.rfind(b"<", 0, offset)
    is_in_tag = opened > data.rfind(b">", 0, offset)
    mistake = _in_comment(source, offset) or _ampersand(data, offset)
    if mistake is None and data[offset : offset + 1] == b"<":
        mistake = _in_value(data, opened, offset)
    if mistake is None and is_in_tag:
        mistake = _in_tag(data, opened, offset)
    if mistake is not None:
        return mistake
    if data[offset - 1 : offset + 1] == b"</":
        return _Mistake(f"end tag </{_tag_name(source, offset + 1)}> has no matching start tag", "", offset - 1)
    byte = data[offset : offset + 1]
    if byte == b"<" and is_in_tag:
        return _Mistake(
            f"tag <{_tag_name(source, opened + 1)} is not closed before the next '<'", "end it with '>'", opened
        )
    return _Mistake(f"not well-formed XML: unexpected {byte.decode('utf-8', 'replace')!r}", "", offset)


def _in_comment(source: SourceText, offset: int) -> _Mistake | None:
    """`--` in a comment, or a comment in a comment."""
    data = source.data
    dashes = data.rfind(b"--", 0, offset + 2)
    closed = data.rfind(b"-->", 0, dashes) + 1
    start = data.find(b"<!--", closed)
    if dashes < 0 or start < 0 or dashes < start + 4 or offset - dashes > len(b"-->"):
        return None
    line = source.position(start).line
    inner = data.find(b"<!--", start + 4, offset + 2)
    if inner >= 0:
        message = f"a comment inside the comment that begins in line {line}; XML comments cannot be nested"
        return _Mistake(message, "end the outer comment before it, or remove the inner '<!--' and '-->'", inner)
    message = f"'--' in the comment that begins in line {line}; XML does not allow it inside a comment"
    return _Mistake(message, "write a single '-', or another separator", dashes, dashes + 2)


def _ampersand(data: bytes, offset: int) -> _Mistake | None:
    reference = _OPEN_REFERENCE.search(data, max(0, offset - _LONGEST_NAME), offset + 1)
    if reference is None:
        return None
    start = reference.start()
    if _OPEN_EXPRESSION.search(data, max(0, start - _LONGEST_TAG), start):
        is_double = data[start : start + 2] == b"&&"
        name = "&&" if is_double else "&"
        hint = "write 'and'" if is_double else "write &amp;, or 'and' for a condition"
        return _Mistake(f"'{name}' is not valid in XML, nor in an expression of xacro", hint, start, start + len(name))
    return _Mistake("a bare '&' is not valid XML", "write &amp;", start)


def _in_tag(data: bytes, opened: int, offset: int) -> _Mistake | None:
    """A missing quote."""
    start = max(opened, offset - _LONGEST_TAG)
    unquoted = _UNQUOTED.search(data, start, offset)
    if unquoted and data[offset : offset + 1] not in (b'"', b"'"):
        name = unquoted[1].decode()
        word = re.split(rb"[\s\"'/>]", data[offset : offset + 100], maxsplit=1)[0].decode("utf-8", "replace")
        return _Mistake(f"the value of attribute '{name}' has no quotes", f'write {name}="{word}"', offset)
    quotes = list(_ATTRIBUTE.finditer(data, start, offset))
    last = quotes[-1] if quotes else None
    if last and last.end() == offset and _SWALLOWED.match(last[2][1:-1]):
        word = re.split(rb"\s+[\w:.-]+\s*=\s*\Z", last[2][1:-1])[0].decode("utf-8", "replace")
        message = f"the value of attribute '{last[1].decode()}' has no closing quote"
        return _Mistake(message, f'write {last[1].decode()}="{word}"', last.start(2), last.end(2))
    return _outside_quotes(data, last, offset) if last else None


def _outside_quotes(data: bytes, value: re.Match[bytes], offset: int) -> _Mistake | None:
    """Text after the closing quote of a value: the rest of the value, or an attribute without a blank before it."""
    name, between = value[1].decode(), data[value.end() : offset]
    unequal = _UNEQUAL.fullmatch(between)
    if unequal and data[offset : offset + 1] in (b'"', b"'"):
        return _Mistake(f"there is no '=' between attribute '{unequal[1].decode()}' and its value", "", offset)
    if between.strip():
        return None
    following = _FOLLOWING.match(data, offset)
    if following is not None:
        return _Mistake(
            f"there is no blank between attribute '{name}' and attribute '{following[1].decode()}'", "", offset
        )
    rest = _OUTSIDE.match(data, offset)
    if rest is None:
        return None
    whole = (value[2][1:-1] + between + rest[0]).decode("utf-8", "replace").replace('"', "").replace("'", "")
    hint = f'write {name}="{" ".join(whole.split())}"'
    return _Mistake(f"part of the value of attribute '{name}' is outside its quotes", hint, offset)


def _in_value(data: bytes, opened: int, offset: int) -> _Mistake | None:
    """`<` in the value of an attribute, which may only seem to be one because a quote before it is missing."""
    value = _OPEN_VALUE.match(data, max(opened, offset - _LONGEST_TAG), offset)
    if value is None:
        return None
    text = data[value.end(1) : offset].lstrip(b" =\t\"'")
    if b">" in text or b"\n" in text:
        word = re.split(rb"[\s/>]", text, maxsplit=1)[0].decode("utf-8", "replace")
        message = f"the value of attribute '{value[1].decode()}' has no closing quote"
        return _Mistake(message, f'write {value[1].decode()}="{word}"', value.start(1), value.end(1))
    return _Mistake("'<' is not allowed in the value of an attribute", "write &lt;", offset, offset + 1)
