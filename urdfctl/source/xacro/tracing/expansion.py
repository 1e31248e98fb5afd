"""Record, while xacro expands a description, which text each value was evaluated from, and what that text looked up.

`influence` estimates from the texts what a value may depend on, at no cost for a run of lint. A tracing expander knows
it, because it was there: which of several properties of a name was in scope, which branch was taken, which key of a
YAML file was read.
"""

from __future__ import annotations

from collections.abc import Mapping
from functools import cached_property, partial
from types import FrameType
from typing import Any

from urdfctl.source.opaque import AnyArgument
from urdfctl.source.xacro.expansion import Expander
from urdfctl.source.xacro.tracing.recording import EvaluatedText, Recorder, XacroCondition, key_of
from urdfctl.source.xml.dom import Element


class TracingExpander(Expander):
    """Expands like the expander that it is mixed into, and keeps a Recorder of its evaluations in `recorder`."""

    @cached_property
    def recorder(self) -> Recorder:
        """What is recorded; nothing of a plain URDF."""
        return Recorder(self.module, self.files)

    def install(self) -> None:
        """Replace the helpers of the private xacro."""
        super().install()
        recorder = self.recorder
        module: Any = self.module
        table = module.Table
        evaluate, look_up = module.eval_text, table.__getitem__
        resolve, bind = table._resolve_, table._setitem
        wrap = module.YamlListWrapper.wrap
        module.eval_text = partial(_eval_text, recorder, evaluate)
        table.__getitem__ = lambda self, key: _look_up(recorder, look_up, self, key)
        table._resolve_ = lambda self, key: _resolve(recorder, resolve, self, key)
        table._setitem = lambda self, *binding, unevaluated: _bind(recorder, bind, (self, *binding), unevaluated)
        recorder.evaluate = evaluate
        module.YamlListWrapper = type("Yaml", (), {"wrap": staticmethod(partial(_wrap_yaml, recorder, wrap))})

    def _arguments(self, given: Mapping[str, str]) -> dict[str, str]:
        values = super()._arguments(given)
        recorded = self.recorder.arguments = _Arguments(self.recorder, values)
        if hasattr(self, "_values"):
            self._values = recorded
        return recorded

    def _check_attrs(self, node: Element, required: list[str], optional: list[str]) -> Any:
        if node.tagName in ("xacro:if", "xacro:unless"):
            close = node.close if node.close is not None else node.start
            text = node.attrs.get("value", "")
            found = XacroCondition(key_of(node), close, node.at["value"], text, _defined_in(node))
            self.recorder.conditions.append(found)
        return super()._check_attrs(node, required, optional)


def _defined_in(node: Element) -> frozenset[str]:
    """Return the names of the properties that are defined somewhere in an element."""
    names, pending = set(), [node]
    while pending:
        element = pending.pop()
        pending += element.elements()
        if element.tagName == "xacro:property":
            names.add(element.attrs.get("name", ""))
    return frozenset(names)


class _Arguments(AnyArgument):
    """The arguments of a description; it records who reads them. An unknown one is as in the dictionary it copies."""

    def __init__(self, recorder: Recorder, values: dict[str, str]) -> None:
        super().__init__(values)
        self._recorder, self._are_any = recorder, isinstance(values, AnyArgument)
        self.steps = {
            name: EvaluatedText(kind="given", name=name, place=None, text=value) for name, value in values.items()
        }

    def __missing__(self, name: str) -> str:
        if self._are_any:
            return super().__missing__(name)
        raise KeyError(name)

    def __getitem__(self, name: str) -> str:
        recorder = self._recorder
        if recorder.replay is not None:
            step = recorder.replay.current.inputs.get((id(self), name))
            return super().__getitem__(name) if step is None else str(recorder.replay.value_of(step))
        value = super().__getitem__(name)
        if recorder.open:
            step = self.steps.setdefault(name, EvaluatedText(kind="given", name=name, place=None, text=value))
            recorder.open[-1].inputs[(id(self), name)] = step
        return value

    def __setitem__(self, name: str, value: str) -> None:
        node = _evaluated_node()
        if node is not None and node.tagName == "xacro:arg":
            step = self._recorder.taken_or_constant(node, "default")
            step.kind, step.name, step.is_text = "argument", name, True
            self.steps[name] = step
        super().__setitem__(name, value)


def _evaluated_node() -> Element | None:
    import sys

    frame: FrameType | None = sys._getframe(2)
    while frame is not None and frame.f_code.co_name != "eval_all":
        frame = frame.f_back
    node = frame.f_locals.get("node") if frame is not None else None
    return node if isinstance(node, Element) else None


# -- the replaced helpers of xacro -----------------------------------------------------------------------------------


def _eval_text(recorder: Recorder, evaluate: Any, text: Any, symbols: Any) -> Any:
    if recorder.replay is not None or recorder.open or not text or "$" not in text:
        return evaluate(text, symbols)
    step = recorder.step_for(text)
    step.symbols = symbols
    value = recorder.run(step, evaluate, text, symbols)
    recorder.last = step
    return value


def _look_up(recorder: Recorder, look_up: Any, table: Any, key: str) -> Any:
    if recorder.replay is not None:
        step = recorder.replay.current.inputs.get((id(table), key))
        return look_up(table, key) if step is None else recorder.replay.value_of(step)
    value = look_up(table, key)
    if recorder.open:
        step = recorder.binding(table, key)
        if step is not None:
            recorder.open[-1].inputs[(id(table), key)] = step
    return value


def _resolve(recorder: Recorder, resolve: Any, table: Any, key: str) -> Any:
    step = table.__dict__.get("steps", {}).get(key)
    if recorder.replay is not None or step is None or key not in table.unevaluated:
        return resolve(table, key)
    step.symbols = table
    return recorder.run(step, resolve, table, key)


def _bind(recorder: Recorder, bind: Any, binding: tuple[Any, str, Any], unevaluated: bool) -> None:  # noqa: FBT001 (xacro's signature)
    table, key, value = binding
    step = recorder.step_of_binding(key)
    if step is not None:
        table.__dict__.setdefault("steps", {})[key] = step
        step.symbols = step.symbols if step.symbols is not None else table
    bind(table, key, value, unevaluated=unevaluated)
    if step is not None:
        step.value = dict.get(table, key)


def _wrap_yaml(recorder: Recorder, wrap: Any, item: Any) -> Any:
    import sys

    if sys._getframe(1).f_code.co_name != "_load_yaml":
        return wrap(item)
    source = recorder.files.read(recorder.module.filestack[-1])
    return recorder.tracked(item, (source, ()))
