"""Parse XML into a located tree, with expat."""

from __future__ import annotations

import re
import sys
from pyexpat import ExpatError, ParserCreate, XMLParserType

from urdfctl.source.dom import CDATA, COMMENT, TEXT, Cloning, Document, DocumentType, Element, Instruction, Node, Text
from urdfctl.source.problem import Problem, ProblemKind, ReadError
from urdfctl.source.span import BOM, Call, Place, SourceText

MAX_DEPTH = 200
_LONGEST_NAME = 40
_OPEN_REFERENCE = rb"&#?\w*[^\w;]?\Z"
_BOMS_OF_UTF_16 = (b"\xff\xfe", b"\xfe\xff")


LATE_DECLARATION = "declaration"
"""The subject of a problem with text before `<?xml ...?>`."""
_BLANKS_AND_DECLARATION = rb"\s+<\?xml\s[^>]*\?>"


def parse(
    source: SourceText,
    cloning: Cloning | None = None,
    call: Call | None = None,
    *,
    declarations: bool = False,
    late_declaration: bool = False,
) -> Document:
    """Return the tree of one file.

    cloning: the state of the expansion that elements record.
    call: the call that the elements come from, such as an include.
    declarations: allow a DOCTYPE with declarations, although entities can expand a small file without limit.
    late_declaration: like tinyxml2, skip blanks before `<?xml ...?>`.

    Raises ReadError if the file is not well-formed, has a DOCTYPE that is not allowed, or is nested more than 200 deep.
    """
    if source.data.startswith(_BOMS_OF_UTF_16):
        message, hint = "the file is UTF-16; xacro and urdfdom read UTF-8", "save it as UTF-8"
        raise ReadError(Problem(ProblemKind.XML_SYNTAX, Place(source, 0, end=0), message, hint=hint))
    builder = _Builder(source, cloning or Cloning(), call, declarations=declarations)
    late = re.match(_BLANKS_AND_DECLARATION, source.data) if late_declaration else None
    data = b" " * late.end() + source.data[late.end() :] if late else source.data
    try:
        builder.parser.Parse(data, True)  # noqa: FBT003 (expat's call)
    except ExpatError as error:
        raise ReadError(_syntax_problem(source, builder, error)) from None
    if builder.document.documentElement is None:  # pragma: no cover (expat raises an error first)
        raise ReadError(Problem(ProblemKind.XML_SYNTAX, Place(source, 0, end=0), "no element found"))
    return builder.document


class _Builder:
    """Builds the tree from expat's events."""

    def __init__(self, source: SourceText, cloning: Cloning, call: Call | None, *, declarations: bool) -> None:
        self.document = Document()
        self.source = source
        self._cloning = cloning
        self._call = call
        self._declarations = declarations
        self._current: Node = self.document
        self._namespaces: list[tuple[str, str]] = []
        self._in_cdata = self._cdata_continues = False
        self._depth = 0
        self._qualified: dict[str, str] = {}
        self.parser = self._connect()

    def _connect(self) -> XMLParserType:
        # like xacro and urdfdom's tinyxml2, read the file as UTF-8 whatever encoding it declares
        parser = ParserCreate("utf-8", " ")
        parser.namespace_prefixes = True
        parser.buffer_text = True
        parser.ordered_attributes = True
        parser.specified_attributes = True
        parser.StartNamespaceDeclHandler = self._namespace
        parser.StartElementHandler = self._start
        parser.EndElementHandler = self._end
        parser.CharacterDataHandler = self._text
        parser.StartCdataSectionHandler = self._start_cdata
        parser.EndCdataSectionHandler = self._end_cdata
        parser.CommentHandler = self._comment
        parser.ProcessingInstructionHandler = self._instruction
        parser.StartDoctypeDeclHandler = self._doctype
        parser.ExternalEntityRefHandler = lambda *_: 1
        return parser

    def _qualified_name(self, name: str) -> str:
        known = self._qualified.get(name)
        if known is None:
            parts = name.split(" ")
            known = parts[0] if len(parts) == 1 else parts[1] if len(parts) == 2 else f"{parts[2]}:{parts[1]}"  # noqa: PLR2004
            known = self._qualified[name] = sys.intern(known)
        return known

    def _namespace(self, prefix: str | None, uri: str) -> None:
        self._namespaces.append((f"xmlns:{prefix}" if prefix else "xmlns", uri))

    def _start(self, name: str, attributes: list[str]) -> None:
        self._depth += 1
        if self._depth > MAX_DEPTH:
            at = Place(self.source, self.parser.CurrentByteIndex, self._call)
            raise ReadError(Problem(ProblemKind.BUDGET, at, f"elements are nested more than {MAX_DEPTH} levels deep"))
        values: dict[str, str] = {}
        if self._namespaces:
            values.update(self._namespaces)
            self._namespaces.clear()
        for index in range(0, len(attributes), 2):
            values[self._qualified_name(attributes[index])] = attributes[index + 1]
        start = self.parser.CurrentByteIndex
        self._cloning.count += 1
        element = Element(
            tag=self._qualified_name(name),
            attrs=values,
            source=self.source,
            start=start,
            call=self._call,
            cloning=self._cloning,
        )
        self._current.appendChild(element)
        if self._depth == 1:
            self.document.documentElement = element
        self._current = element

    def _end(self, _name: str) -> None:
        self._depth -= 1
        element = self._current
        if isinstance(element, Element):
            element.close = self.parser.CurrentByteIndex
        self._current = element.parentNode or self.document

    def _text(self, data: str) -> None:
        last = self._current.lastChild
        kind = CDATA if self._in_cdata else TEXT
        if isinstance(last, Text) and last.nodeType == kind and (self._cdata_continues or not self._in_cdata):
            last.data += data
        else:
            self._current.appendChild(Text(data, kind))
        self._cdata_continues = self._in_cdata

    def _start_cdata(self) -> None:
        self._in_cdata, self._cdata_continues = True, False

    def _end_cdata(self) -> None:
        self._in_cdata = False

    def _comment(self, data: str) -> None:
        self._current.appendChild(Text(data, COMMENT))

    def _instruction(self, target: str, data: str) -> None:
        self._current.appendChild(Instruction(target, data))

    def _doctype(self, name: str, system: str | None, public: str | None, has_internal_subset: bool) -> None:  # noqa: FBT001 (expat's call)
        if has_internal_subset and not self._declarations:
            start = self.source.data.rfind(b"<!DOCTYPE", 0, self.parser.CurrentByteIndex)
            at = Place(self.source, start, self._call, end=start + len(b"<!DOCTYPE"))
            message = "DOCTYPE declares entities, which urdfctl does not read: they can expand to an unlimited size"
            raise ReadError(Problem(ProblemKind.DOCTYPE, at, message, hint="replace each entity with its text"))
        self.document.appendChild(DocumentType(name, public, system))


def _syntax_problem(source: SourceText, builder: _Builder, error: ExpatError) -> Problem:
    """The problem for expat's error, at the exact byte, with a message that says what to do."""
    offset = max(0, min(builder.parser.ErrorByteIndex, len(source.data)))
    said = str(error).split(": line ")[0]
    subject, message, hint = "", f"not well-formed XML: {said}", ""
    if not source.data.removeprefix(BOM).strip():
        message, offset = "the file is empty", 0
    elif said.startswith("XML or text declaration not at start"):
        message = "the XML declaration <?xml ...?> is not at the start of the file"
        hint = "remove the spaces, lines or comments before it"
        subject = LATE_DECLARATION
    elif said.startswith("junk after document element"):
        message = "text after the end of the root element"
        hint = f"move it before </{_root_name(builder)}>, or remove it"
    elif said.startswith("unbound prefix"):
        return _unbound_prefix(source, offset)
    elif said.startswith("mismatched tag"):
        return _mismatched_tag(source, builder, offset)
    elif said.startswith(("no element found", "unclosed token")):
        message, hint = _unfinished(builder, said)
    elif said.startswith("syntax error"):
        message = "not XML: an XML file starts with a tag"
    elif said.startswith("undefined entity"):
        hint = "XML defines only &amp; &lt; &gt; &quot; &apos;"
    elif said.startswith("not well-formed"):
        message, hint, offset = _invalid_token(source, offset)
    return Problem(
        ProblemKind.XML_SYNTAX, Place(source, offset, end=_token_end(source, offset)), message, subject, hint
    )


def _token_end(source: SourceText, offset: int) -> int:
    end = source.data.find(b"\n", offset)
    token = source.data[offset : end if end >= 0 else len(source.data)].split(maxsplit=1)
    return offset + (len(token[0]) if token and source.data[offset : offset + 1].strip() else 0)


def _root_name(builder: _Builder) -> str:
    root = builder.document.documentElement
    return root.tagName if root is not None else "robot"


def _open_element(builder: _Builder) -> Element | None:
    return builder._current if isinstance(builder._current, Element) else None


def _unbound_prefix(source: SourceText, offset: int) -> Problem:
    tag = source.start_tag(offset)
    names = [tag.name, *tag.attributes] if tag else []
    prefix = next((name.split(":")[0] for name in names if ":" in name and not name.startswith("xml")), "xacro")
    uri = "http://www.ros.org/wiki/xacro" if prefix == "xacro" else "..."
    return Problem(
        ProblemKind.XML_SYNTAX,
        Place(source, offset),
        f"prefix '{prefix}:' is not declared",
        prefix,
        f'add xmlns:{prefix}="{uri}" to the root element',
    )


def _mismatched_tag(source: SourceText, builder: _Builder, offset: int) -> Problem:
    offset = max(source.data.rfind(b"</", 0, offset + 1), 0)
    opened = _open_element(builder)
    found = _tag_name(source, offset + 2)
    message = f"end tag </{found}> has no matching start tag"
    if opened is not None:
        line = source.position(opened.start).line
        message = f"<{opened.tagName}> in line {line} is not closed: expected </{opened.tagName}>, found </{found}>"
    return Problem(ProblemKind.XML_SYNTAX, Place(source, offset, end=_token_end(source, offset)), message)


def _tag_name(source: SourceText, offset: int) -> str:
    return re.split(rb"[\s>]", source.data[offset : offset + 200], maxsplit=1)[0].decode("utf-8", "replace")


def _unfinished(builder: _Builder, said: str) -> tuple[str, str]:
    opened = _open_element(builder)
    if opened is None:
        return f"not well-formed XML: {said}", ""
    line = builder.source.position(opened.start).line
    return f"<{opened.tagName}> in line {line} has no end tag", f"close it with </{opened.tagName}>"


def _invalid_token(source: SourceText, offset: int) -> tuple[str, str, int]:
    """The message, the hint and the byte offset for an unexpected byte."""
    try:
        source.data.decode("utf-8")
    except UnicodeDecodeError as error:
        return f"byte 0x{source.data[error.start]:02x} is not valid UTF-8", "save the file as UTF-8", error.start
    if b"\x00" in source.data:
        return "the file is binary, not XML", "", source.data.index(b"\x00")
    reference = re.compile(_OPEN_REFERENCE).search(source.data, max(0, offset - _LONGEST_NAME), offset + 1)
    if reference:
        return "a bare '&' is not valid XML", "write &amp;", reference.start()
    if source.data[offset - 1 : offset + 1] == b"</":
        return f"end tag </{_tag_name(source, offset + 1)}> has no matching start tag", "", offset - 1
    byte = source.data[offset : offset + 1]
    opened = source.data.rfind(b"<", 0, offset)
    if byte == b"<" and opened > source.data.rfind(b">", 0, offset):
        return f"tag <{_tag_name(source, opened + 1)} is not closed before the next '<'", "end it with '>'", opened
    return f"not well-formed XML: unexpected {byte.decode('utf-8', 'replace')!r}", "", offset
