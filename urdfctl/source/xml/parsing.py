"""Parse XML into a located tree, with expat."""

from __future__ import annotations

import re
import sys
from pyexpat import ExpatError, ParserCreate, XMLParserType

from urdfctl.source.problem import Problem, ProblemKind, ReadError
from urdfctl.source.span import Call, Place, SourceText
from urdfctl.source.xml.dom import (
    CDATA,
    COMMENT,
    TEXT,
    Cloning,
    Document,
    DocumentType,
    Element,
    Instruction,
    XmlNode,
    XmlText,
)

MAX_DEPTH = 200
_BOMS_OF_UTF_16 = (b"\xff\xfe", b"\xfe\xff")
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
    builder = TreeBuilder(source, cloning or Cloning(), call, declarations=declarations)
    late = re.match(_BLANKS_AND_DECLARATION, source.data) if late_declaration else None
    data = b" " * late.end() + source.data[late.end() :] if late else source.data
    try:
        builder.read(data)
    except ExpatError as error:
        from urdfctl.source.conflicts import merge_conflict
        from urdfctl.source.xml.mistakes import syntax_problem

        conflict = merge_conflict(source)
        if conflict is not None:
            raise ReadError(conflict) from None
        open_element = builder.current if isinstance(builder.current, Element) else None
        at, said = builder.parser.ErrorByteIndex, str(error)
        raise ReadError(syntax_problem(source, at, said, builder.document.documentElement, open_element)) from None
    if builder.document.documentElement is None:  # pragma: no cover (expat raises an error first)
        raise ReadError(Problem(ProblemKind.XML_SYNTAX, Place(source, 0, end=0), "no element found"))
    return builder.document


class TreeBuilder:
    """Builds the tree of one file from expat's events.

    document: what was read. current: the element that is still open after an error.
    """

    def __init__(self, source: SourceText, cloning: Cloning, call: Call | None, *, declarations: bool) -> None:
        self.document = Document()
        self.source = source
        self._cloning = cloning
        self._call = call
        self._declarations = declarations
        self.current: XmlNode = self.document
        self._namespaces: list[tuple[str, str]] = []
        self._in_cdata = self._cdata_continues = False
        self._depth = 0
        self._qualified: dict[str, str] = {}
        self.parser = self._connect()

    def read(self, data: bytes) -> None:
        """Read the bytes of the file. Raises ExpatError, and ReadError for what `parse` refuses."""
        self.parser.Parse(data, True)  # noqa: FBT003 (expat's call)

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
        self.current.appendChild(element)
        if self._depth == 1:
            self.document.documentElement = element
        self.current = element

    def _end(self, _name: str) -> None:
        self._depth -= 1
        element = self.current
        if isinstance(element, Element):
            element.close = self.parser.CurrentByteIndex
        self.current = element.parentNode or self.document

    def _text(self, data: str) -> None:
        last = self.current.lastChild
        kind = CDATA if self._in_cdata else TEXT
        if isinstance(last, XmlText) and last.nodeType == kind and (self._cdata_continues or not self._in_cdata):
            last.data += data
        else:
            self.current.appendChild(XmlText(data, kind))
        self._cdata_continues = self._in_cdata

    def _start_cdata(self) -> None:
        self._in_cdata, self._cdata_continues = True, False

    def _end_cdata(self) -> None:
        self._in_cdata = False

    def _comment(self, data: str) -> None:
        self.current.appendChild(XmlText(data, COMMENT))

    def _instruction(self, target: str, data: str) -> None:
        self.current.appendChild(Instruction(target, data))

    def _doctype(self, name: str, system: str | None, public: str | None, has_internal_subset: bool) -> None:  # noqa: FBT001 (expat's call)
        if has_internal_subset and not self._declarations:
            start = self.source.data.rfind(b"<!DOCTYPE", 0, self.parser.CurrentByteIndex)
            at = Place(self.source, start, self._call, end=start + len(b"<!DOCTYPE"))
            message = "DOCTYPE declares entities, which urdfctl does not read: they can expand to an unlimited size"
            raise ReadError(Problem(ProblemKind.DOCTYPE, at, message, hint="replace each entity with its text"))
        self.document.appendChild(DocumentType(name, public, system))
