"""A small document tree whose elements know their place in the source.

It implements only the part of `xml.dom.minidom`'s interface that the xacro package uses, so that xacro works on it
unchanged. Names in camelCase are minidom's. Siblings form a linked list, so that insertion and removal take constant
time.
"""

from __future__ import annotations

from collections.abc import Iterator

from urdfctl.source.span import Call, Place, SourceText
from urdfctl.source.xacro.private.stand_ins import NotFoundErr
from urdfctl.startup.records import NamedTuple

ELEMENT, TEXT, CDATA, INSTRUCTION, COMMENT, DOCUMENT, DOCTYPE = 1, 3, 4, 7, 8, 9, 10


_NOT_FOUND = NotFoundErr()
"""Created once: xacro asks every element for an attribute that few have, and creating an exception is slow."""


class XmlNode:
    """The base class of all nodes: a parent, siblings and children."""

    __slots__ = ("firstChild", "lastChild", "nextSibling", "parentNode", "previousSibling")

    nodeType = 0

    def __init__(self) -> None:
        self.parentNode: XmlNode | None = None
        self.previousSibling: XmlNode | None = None
        self.nextSibling: XmlNode | None = None
        self.firstChild: XmlNode | None = None
        self.lastChild: XmlNode | None = None

    def _unlink(self) -> None:
        parent, before, after = self.parentNode, self.previousSibling, self.nextSibling
        if parent is None:
            return
        if before is not None:
            before.nextSibling = after
        else:
            parent.firstChild = after
        if after is not None:
            after.previousSibling = before
        else:
            parent.lastChild = before
        self.parentNode = self.previousSibling = self.nextSibling = None

    def removeChild(self, child: XmlNode) -> XmlNode:
        """Remove a child and return it. Raises NotFoundErr if the node is not a child."""
        if child.parentNode is not self:
            raise NotFoundErr
        child._unlink()
        return child

    def appendChild(self, child: XmlNode) -> XmlNode:
        """Append a node to the children and return it; it is removed from its previous parent."""
        if child.parentNode is not None:
            child._unlink()
        last = self.lastChild
        child.parentNode = self
        child.previousSibling = last
        if last is None:
            self.firstChild = child
        else:
            last.nextSibling = child
        self.lastChild = child
        return child

    def insertBefore(self, child: XmlNode, reference: XmlNode | None) -> XmlNode:
        """Insert a node before the child `reference` and return it; None appends it.

        Raises NotFoundErr if `reference` is not a child.
        """
        if reference is None:
            return self.appendChild(child)
        if reference.parentNode is not self:
            raise NotFoundErr
        child._unlink()
        before = reference.previousSibling
        child.parentNode = self
        child.previousSibling = before
        child.nextSibling = reference
        reference.previousSibling = child
        if before is None:
            self.firstChild = child
        else:
            before.nextSibling = child
        return child

    @property
    def childNodes(self) -> list[XmlNode]:
        """The children, in order."""
        return list(self.children())

    def children(self) -> Iterator[XmlNode]:
        """Yield the children in order. The tree must not change during the iteration."""
        child = self.firstChild
        while child is not None:
            yield child
            child = child.nextSibling

    def elements(self) -> list[Element]:
        """Return the children that are elements, in order."""
        elements = []
        child = self.firstChild
        while child is not None:
            if isinstance(child, Element):
                elements.append(child)
            child = child.nextSibling
        return elements

    def cloneNode(self, deep: bool = False) -> XmlNode:
        """Return a copy of the node and its descendants, whatever `deep` is."""
        raise NotImplementedError


class XmlText(XmlNode):
    """A text, a CDATA section or a comment, depending on `nodeType`."""

    __slots__ = ("data", "nodeType")
    nodeName = "#text"

    def __init__(self, data: str, node_type: int = TEXT) -> None:
        self.parentNode = self.previousSibling = self.nextSibling = self.firstChild = self.lastChild = None
        self.data = data
        self.nodeType = node_type

    def cloneNode(self, deep: bool = False) -> XmlText:
        return XmlText(self.data, self.nodeType)


class Instruction(XmlText):
    """A processing instruction."""

    __slots__ = ("target",)

    def __init__(self, target: str, data: str) -> None:
        super().__init__(data, INSTRUCTION)
        self.target = target

    def cloneNode(self, deep: bool = False) -> Instruction:
        return Instruction(self.target, self.data)


class DocumentType(XmlNode):
    """A DOCTYPE without an internal subset."""

    __slots__ = ("name", "public", "system")
    nodeType = DOCTYPE

    def __init__(self, name: str, public: str | None, system: str | None) -> None:
        super().__init__()
        self.name, self.public, self.system = name, public, system


class _Attribute(NamedTuple):
    value: str


class _AttributeMap:
    """The part of minidom's NamedNodeMap that xacro uses."""

    __slots__ = ("_values",)

    def __init__(self, values: dict[str, str]) -> None:
        self._values = values

    def items(self) -> list[tuple[str, str]]:
        return list(self._values.items())

    def keys(self) -> list[str]:
        return list(self._values)

    def __len__(self) -> int:
        return len(self._values)


class Document(XmlNode):
    """The root of the tree: the root element, and the comments and instructions before and after it."""

    __slots__ = ("documentElement",)
    nodeType = DOCUMENT

    def __init__(self) -> None:
        super().__init__()
        self.documentElement: Element | None = None


class Cloning:
    """State of the expansion that copied elements record; the expansion sets and reads it.

    call: the macro call that is being expanded.
    insertion: the `insert_block` element that is being expanded.
    count: the number of elements created so far.
    """

    __slots__ = ("call", "count", "insertion")

    def __init__(self) -> None:
        self.call: Call | None = None
        self.insertion: Element | None = None
        self.count = 0


class Element(XmlNode):
    """An element with its place in the source.

    tagName, nodeName: the qualified name.
    attrs: the attributes by qualified name.
    source: the file that contains the element.
    start: byte offset of the start tag.
    close: byte offset of the end tag; None if the element has none.
    call: the innermost call that produced the element; None if it was written where it is.
    cloning: shared state of the expansion.
    moved: attributes that come from another element, with the source and byte offset of that element's start tag.
    """

    __slots__ = ("attrs", "call", "cloning", "close", "moved", "nodeName", "source", "start", "tagName")
    nodeType = ELEMENT

    def __init__(
        self,
        tag: str,
        attrs: dict[str, str],
        source: SourceText,
        start: int,
        call: Call | None,
        cloning: Cloning,
    ) -> None:
        self.parentNode = self.previousSibling = self.nextSibling = self.firstChild = self.lastChild = None
        self.tagName = self.nodeName = tag
        self.attrs = attrs
        self.source = source
        self.start = start
        self.close: int | None = None
        self.call = call
        self.cloning = cloning
        self.moved: dict[str, tuple[SourceText, int]] | None = None

    @property
    def attributes(self) -> _AttributeMap:
        return _AttributeMap(self.attrs)

    def hasAttribute(self, name: str) -> bool:
        return name in self.attrs

    def getAttribute(self, name: str) -> str:
        return self.attrs.get(name, "")

    def setAttribute(self, name: str, value: str) -> None:
        self.attrs[name] = value

    def removeAttribute(self, name: str) -> None:
        if name not in self.attrs:
            raise _NOT_FOUND.with_traceback(None)
        del self.attrs[name]

    def getAttributeNode(self, name: str) -> _Attribute | None:
        value = self.attrs.get(name)
        return None if value is None else _Attribute(value)

    def walk(self) -> Iterator[Element]:
        """Yield this element and all in it, in the order of the file. The tree must not change during the iteration."""
        pending = [self]
        while pending:
            element = pending.pop()
            yield element
            pending += reversed(element.elements())

    def cloneNode(self, deep: bool = False) -> Element:
        """Return a copy that records the macro call or the `insert_block` that produced it."""
        top = self.cloning.call
        if self.tagName == "xacro:macro":
            return self._copy(top, None)
        return self._copy(None, _BlockCalls(top, self.cloning.insertion, {}))

    def _copy(self, call: Call | None, block: _BlockCalls | None) -> Element:
        if block is not None:
            call = block.for_text_of(self.call)
        self.cloning.count += 1
        copy = Element(
            tag=self.tagName,
            attrs=self.attrs.copy(),
            source=self.source,
            start=self.start,
            call=call,
            cloning=self.cloning,
        )
        copy.nodeName, copy.close, copy.moved = self.nodeName, self.close, self.moved
        last: XmlNode | None = None
        child = self.firstChild
        while child is not None:
            twin = child._copy(call, block) if isinstance(child, Element) else child.cloneNode()
            twin.parentNode = copy
            twin.previousSibling = last
            if last is None:
                copy.firstChild = twin
            else:
                last.nextSibling = twin
            last = twin
            child = child.nextSibling
        copy.lastChild = last
        return copy

    @property
    def at(self) -> Place:
        """The place of the element in the source."""
        return Place(self.source, self.start, self.call, close=self.close, attributes=self.moved)


class _BlockCalls(NamedTuple):
    """The calls of kind `block` for the elements of an inserted block: one for each call that produced some of them."""

    via: Call | None
    site: Element | None
    blocks: dict[int, Call]

    def for_text_of(self, written_by: Call | None) -> Call | None:
        if self.site is None:
            return written_by
        key = id(written_by)
        if key not in self.blocks:
            name = self.via.name if self.via is not None else ""
            self.blocks[key] = Call("block", name, self.site.source, self.site.start, written_by)
        return self.blocks[key]
