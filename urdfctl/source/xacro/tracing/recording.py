"""What a tracing expansion records: the texts that xacro evaluated, and which other texts each of them looked up."""

from __future__ import annotations

import re
import sys
from collections.abc import Iterator
from types import FrameType, ModuleType
from typing import Any

from urdfctl.source.disk.files import Files
from urdfctl.source.span import Call, Place, SourceText
from urdfctl.source.xml.dom import COMMENT, Element, XmlText
from urdfctl.startup.records import NamedTuple

YamlKey = tuple[SourceText, tuple[str | int, ...]]
"""A value of a YAML file: the file, and the keys that lead to it."""
Key = tuple[str, int, Call | None]
"""An element of an expansion before macros copied it: its file, its offset, and the call that produced it."""


class EvaluatedText:
    """A text that was evaluated, or a constant: the value of an attribute, a property, a parameter or an argument.

    kind: attribute, text, property, parameter, default, argument, given or condition.
    name: of the property, the parameter, the argument or the attribute.
    place: where the text is written; None for an argument that was given.
    text: the text.
    symbols: xacro's names where the text was evaluated.
    file: the file that xacro read then.
    value: the value of the text.
    inputs: what the text looked up, by the table that was asked and the name.
    loads: the YAML values that it read.
    is_text: whether the value stays a text although it looks like a number.
    """

    __slots__ = ("file", "inputs", "is_text", "kind", "loads", "name", "place", "symbols", "text", "value")

    def __init__(self, kind: str, name: str, place: Place | None, text: str) -> None:
        self.kind, self.name, self.place, self.text = kind, name, place, text
        self.symbols: Any = None
        self.file: str | None = None
        self.value: Any = text
        self.inputs: dict[tuple[int, str], EvaluatedText] = {}
        self.loads: dict[YamlKey, None] = {}
        self.is_text = kind in {"attribute", "text", "argument", "given", "condition"}


class XacroCondition(NamedTuple):
    """An `<xacro:if>` or `<xacro:unless>`: where it is, and the properties that are defined in it."""

    key: Key
    close: int
    at: Place
    text: str
    defines: frozenset[str]


class Recorder:
    """The steps of one expansion."""

    def __init__(self, module: ModuleType, files: Files) -> None:
        self.module: Any = module
        self.files = files
        self.open: list[EvaluatedText] = []
        """The steps that are being evaluated, innermost last."""
        self.last: EvaluatedText | None = None
        self.replay: Any = None
        """What answers the look-ups while texts are evaluated again; None during the expansion."""
        self.evaluate: Any = None
        self.arguments: Any = None
        self.conditions: list[XacroCondition] = []
        self._steps: dict[Key, dict[str, EvaluatedText]] = {}
        self._map, self._list = _yaml_types(self)

    def run(self, step: EvaluatedText, function: Any, *arguments: Any) -> Any:
        """Call a function, whose look-ups are those of a step; return its result, which becomes the step's value."""
        step.file = self.module.filestack[-1]
        self.open.append(step)
        try:
            step.value = function(*arguments)
        finally:
            self.open.pop()
        return step.value

    def step_for(self, text: str) -> EvaluatedText:
        """Return the step of a text that xacro evaluates now."""
        frame: FrameType | None = sys._getframe(2)
        while frame is not None and frame.f_code.co_name not in _EVALUATING:
            frame = frame.f_back
        return self._of_frame(frame, text) if frame is not None else EvaluatedText("text", "", None, text)

    def _of_frame(self, frame: FrameType, text: str) -> EvaluatedText:
        values = frame.f_locals
        if frame.f_code.co_name == "eval_default_arg":
            body, name = values["macro"].body, values["forward_variable"] or ""
            name = name or (frame.f_back.f_locals.get("param", "") if frame.f_back else "")
            return EvaluatedText("default", name, written_default(body, name, text), text)
        node = values.get("node", values.get("elt"))
        if isinstance(node, XmlText):
            step = EvaluatedText("text", "", _place_of_text(node), text.strip())
            return self._kept(node.parentNode, "", step)
        if not isinstance(node, Element):
            return EvaluatedText("text", "", None, text)
        name = _attribute_with(node, text, values.get("name"))
        kind = "parameter" if frame.f_code.co_name == "handle_macro_call" else "attribute"
        if node.tagName in ("xacro:if", "xacro:unless"):
            kind = "condition"
        return self._kept(node, name, EvaluatedText(kind, name, node.at[name], text))

    def _kept(self, node: Any, name: str, step: EvaluatedText) -> EvaluatedText:
        if isinstance(node, Element):
            self._steps.setdefault(key_of(node), {})[name] = step
        return step

    # -- bindings ----------------------------------------------------------------------------------------------------

    def taken_or_constant(self, node: Element, attribute: str, kind: str = "property") -> EvaluatedText:
        """Return the step that just evaluated an attribute, or a new one for a text that needs no evaluation."""
        text = node.attrs.get(attribute, "")
        found = self._steps.get(key_of(node), {}).get(attribute)
        if found is not None and "$" in text:
            return found
        return EvaluatedText(kind, attribute, node.at[attribute], text)

    def step_of_binding(self, key: str) -> EvaluatedText | None:
        """Return the step for a name that xacro defines now; None for blocks and namespaces."""
        frame = sys._getframe(2)
        while frame.f_code.co_name in ("_setitem", "<lambda>", "_bind"):
            frame = frame.f_back  # type: ignore[assignment]
        values, function = frame.f_locals, frame.f_code.co_name
        if function == "grab_property":
            return self._of_property(values["elt"], key)
        if function != "handle_macro_call":
            return None
        if values.get("param") == key:
            return self._of_default(values, key)
        return self._of_parameter(values["node"], key, values.get("value"))

    def _of_property(self, node: Element, key: str) -> EvaluatedText | None:
        attribute = "value" if "value" in node.attrs else "default"
        if attribute not in node.attrs:
            return None
        found = self._steps.get(key_of(node), {}).pop(attribute, None)
        step = found or EvaluatedText("property", key, node.at[attribute], node.attrs[attribute])
        step.kind, step.name, step.is_text = "property", key, False
        return step

    def _of_parameter(self, node: Element, key: str, text: Any) -> EvaluatedText:
        step = self._steps.get(key_of(node), {}).get(key)
        if step is None or not (isinstance(text, str) and "$" in text):
            step = EvaluatedText("parameter", key, node.at[key], text if isinstance(text, str) else "")
        step.is_text = False
        return step

    def _of_default(self, values: dict[str, Any], key: str) -> EvaluatedText:
        macro = values["m"]
        forward, default = macro.defaultmap.get(key, (None, None))
        forwarded = self.binding(values["symbols"], forward) if forward else None
        if forwarded is not None:
            step = EvaluatedText("forwarded", key, macro.body.at["params"], "")
            step.inputs[(0, key)] = forwarded
            return step
        if default is not None and "$" in default and self.last is not None and self.last.kind == "default":
            step = self.last
        else:
            step = EvaluatedText("default", key, written_default(macro.body, key, default or ""), default or "")
        step.name, step.is_text = key, False
        return step

    def binding(self, table: Any, key: str) -> EvaluatedText | None:
        """Return the step behind a name in a table of xacro's or in those around it."""
        while isinstance(table, self.module.Table):
            if dict.__contains__(table, key):
                step: EvaluatedText | None = table.__dict__.get("steps", {}).get(key)
                return step
            table = table.parent
        return None

    # -- YAML --------------------------------------------------------------------------------------------------------

    def tracked(self, value: Any, where: YamlKey) -> Any:
        """Return a value of a YAML file that records which of its parts are read."""
        if self.open:
            self.open[-1].loads[where] = None
        if isinstance(value, dict):
            found = self._map(value)
        elif isinstance(value, list):
            found = self._list(value)
        else:
            return value
        found.__dict__["_where"] = where
        return found

    # -- questions ---------------------------------------------------------------------------------------------------

    def step_of(self, element: Element, attribute: str) -> EvaluatedText:
        """Return the step that gave an attribute of the expanded tree, or its text if the attribute is empty."""
        source, offset, name = element.source, element.start, attribute
        if element.moved and attribute in element.moved:
            (source, offset), name = element.moved[attribute], "value"
        call = element.call
        while True:
            step = self._steps.get((source.path, offset, call), {}).get(name)
            if step is not None or call is None or call.kind != "block":
                break
            call = call.parent
        if step is not None:
            return step
        if attribute:
            return EvaluatedText("attribute", attribute, element.at[attribute], element.attrs.get(attribute, ""))
        texts = (node.data for node in element.children() if isinstance(node, XmlText) and node.nodeType != COMMENT)
        text = "".join(texts).strip()
        return EvaluatedText("text", "", element.at.content.part(text), text)

    def deciding(self, place: Place, properties: frozenset[str]) -> Iterator[EvaluatedText]:
        """Yield the steps that decide whether what is at a place is there: conditions and names of what is called.

        properties: conditions that define one of these decide too, whatever they enclose.
        """
        source, offset, call = place.source, place.start, place.call
        while True:
            for condition in self.conditions:
                path, start, around = condition.key
                is_around = start < offset < condition.close or condition.defines & properties
                if path == source.path and around is call and is_around:
                    yield self._decided_by(condition)
            if call is None:
                return
            source, offset, call = call.source, call.offset, call.parent
            steps = self._steps.get((source.path, offset, call), {})
            yield from (steps[name] for name in ("macro", "filename") if name in steps)

    def _decided_by(self, condition: XacroCondition) -> EvaluatedText:
        found = self._steps.get(condition.key, {}).get("value")
        return found or EvaluatedText("condition", "value", condition.at, condition.text)


_EVALUATING = ("eval_all", "handle_macro_call", "eval_default_arg", "grab_property", "process_include",
               "handle_dynamic_macro_call")  # fmt: skip


def key_of(element: Element) -> Key:
    """Return what identifies an element before and after it was copied."""
    return element.source.path, element.start, element.call


def _attribute_with(node: Element, text: str, hint: Any) -> str:
    if isinstance(hint, str) and node.attrs.get(hint) is text:
        return hint
    same = [name for name, value in node.attrs.items() if value is text]
    return (same or [name for name, value in node.attrs.items() if value == text] or [""])[0]


def _place_of_text(node: XmlText) -> Place | None:
    parent = node.parentNode
    return parent.at.content.part(node.data.strip()) if isinstance(parent, Element) else None


def written_default(body: Element, name: str, text: str) -> Place:
    """Return the place of a parameter's default in the `params` of a macro."""
    at = body.at["params"]
    span = at.span
    found = re.search(rf"(?:^|\s){re.escape(name)}\s*:?=\s*(?:\^\|?)?(?={re.escape(text)})", span.text)
    if found is None or not text:
        return at
    start = span.start + len(span.text[: found.end()].encode())
    return Place(at.source, start, at.call, end=start + len(text.encode()))


def _yaml_types(recorder: Recorder) -> tuple[Any, Any]:
    """Return a map and a list that record what is read of them. They are kinds of xacro's own."""
    of_map: Any = recorder.module.YamlDictWrapper
    of_list: Any = recorder.module.YamlListWrapper

    class Map(of_map):  # type: ignore[misc]
        def __getattr__(self, item: Any) -> Any:
            if not dict.__contains__(self, item):
                return of_map.__getattr__(self, item)
            source, keys = self.__dict__["_where"]
            return recorder.tracked(dict.__getitem__(self, item), (source, (*keys, item)))

        __getitem__ = __getattr__

        def get(self, item: Any, default: Any = None) -> Any:
            return self[item] if dict.__contains__(self, item) else default

    class List(of_list):  # type: ignore[misc]
        def __getitem__(self, index: Any) -> Any:
            if not isinstance(index, int):
                return of_list.__getitem__(self, index)
            source, keys = self.__dict__["_where"]
            return recorder.tracked(list.__getitem__(self, index), (source, (*keys, index % max(len(self), 1))))

        def __iter__(self) -> Iterator[Any]:
            return (self[index] for index in range(len(self)))

    return Map, List
