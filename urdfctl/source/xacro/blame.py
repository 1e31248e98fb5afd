"""Find out what xacro was evaluating when it failed, from the frames of its traceback."""

from __future__ import annotations

import sys
from types import FrameType, TracebackType

from urdfctl.source.opaque import UNKNOWN
from urdfctl.source.span import Place, SourceText
from urdfctl.source.xml.dom import COMMENT, Element, XmlNode, XmlText
from urdfctl.startup.records import NamedTuple


class Blame(NamedTuple):
    """The part of the description that xacro evaluated when it failed.

    attribute: of the element, if known.
    properties: those that were looked up, innermost last.
    """

    node: XmlNode | None
    attribute: str | None
    properties: tuple[str, ...] = ()

    @property
    def element(self) -> Element | None:
        """Return the element, or the one around the text."""
        node = self.node if isinstance(self.node, Element) else self.node.parentNode if self.node else None
        return node if isinstance(node, Element) else None

    def place(self, filestack: list[str]) -> Place:
        """Return the place of the attribute, or of the element or the file if the attribute is unknown."""
        if self.element is None:
            return Place(SourceText(filestack[-1] if filestack else "", b""), 0, end=0)
        return self.element.at[self.attribute] if self.attribute else self.element.at


def blame_of(error: BaseException) -> Blame:
    """Return the node in the innermost evaluating frame of a traceback. It costs nothing unless there is an error."""
    node: XmlNode | None = None
    attribute: str | None = None
    properties: list[str] = []
    trace: TracebackType | None = error.__traceback__
    while trace is not None:
        values = trace.tb_frame.f_locals
        function = trace.tb_frame.f_code.co_name
        if function in ("eval_all", "handle_macro_call") and isinstance(values.get("node"), XmlNode):
            node = values["node"]
            name = values.get("name")
            evaluates = trace.tb_next is not None and trace.tb_next.tb_frame.f_code.co_name == "eval_text"
            attribute = name if evaluates and isinstance(node, Element) and name in node.attrs else None
            properties.clear()
        elif function == "_resolve_" and isinstance(values.get("key"), str):
            properties.append(values["key"])
        trace = trace.tb_next
    properties += _looked_up(error.__cause__)
    return Blame(node, attribute, tuple(properties))


def _looked_up(error: BaseException | None) -> list[str]:
    """The properties that were looked up when an exception was raised, and those of its causes, outermost first."""
    names = []
    while error is not None:
        trace = error.__traceback__
        while trace is not None:
            key = trace.tb_frame.f_locals.get("key")
            if trace.tb_frame.f_code.co_name == "_resolve_" and isinstance(key, str):
                names.append(key)
            trace = trace.tb_next
        error = error.__cause__
    return names


def cut_out(blame: Blame, parent: Element, done: list[XmlNode]) -> bool:
    """Remove what could not be evaluated, so that the rest can be; return False if nothing can be removed.

    What comes before it is already evaluated, and must not be again: it is moved to `done`.
    """
    if blame.attribute is not None and blame.element is parent and blame.attribute in parent.attrs:
        parent.attrs[blame.attribute] = UNKNOWN
        return True
    node: XmlNode | None = blame.node
    while node is not None and node.parentNode is not parent:
        node = node.parentNode
    if node is None:
        return False
    done += _taken_from_before(node, parent)
    if isinstance(node, XmlText):
        node.data = UNKNOWN
    else:
        parent.removeChild(node)
    return True


def _taken_from_before(node: XmlNode, parent: Element) -> list[XmlNode]:
    """Remove and return the siblings before a node, without the comments next to it, which xacro removes with it."""
    taken: list[XmlNode] = []
    before = node.previousSibling
    while isinstance(before, XmlText) and (before.nodeType == COMMENT or not before.data.strip()):
        before = before.previousSibling
    while before is not None:
        taken.append(before)
        before = before.previousSibling
    for sibling in taken:
        parent.removeChild(sibling)
    return taken[::-1]


def node_being_evaluated() -> Element | None:
    """Return the element that xacro evaluates now, or the one around the text that it evaluates."""
    frame: FrameType | None = sys._getframe(1)
    while frame is not None:
        if frame.f_code.co_name == "eval_all":
            node = frame.f_locals.get("node")
            if isinstance(node, Element):
                return node
            if isinstance(node, XmlNode) and isinstance(node.parentNode, Element):
                return node.parentNode
        frame = frame.f_back
    return None
