"""Evaluate recorded texts again with one number changed, to see what depends on it."""

from __future__ import annotations

import math
import re
from collections.abc import Iterator
from contextlib import contextmanager
from typing import Any

from urdfctl.source.opaque import UNKNOWN
from urdfctl.source.span import SourceSpan, SourceText
from urdfctl.source.xacro.tracing.recording import EvaluatedText, Recorder, YamlKey
from urdfctl.startup.records import NamedTuple

_NUMBER = re.compile(r"(?<![\w.])(?:\d+\.?\d*|\.\d+)(?:[eE][+-]?\d+)?(?![\w.])")
_REFERENCE = re.compile(r"&(?:(lt|gt|amp|quot|apos)|#(\d+)|#x([0-9a-fA-F]+));")
_NAMED = {"lt": "<", "gt": ">", "amp": "&", "quot": '"', "apos": "'"}
_STEP = 0.1
"""By which part of itself a number is changed to see what depends on it."""
_MOST_VALUES = 200
"""So many values of a list or map that was read as a whole are tried one by one."""
_FAILED = object()


class WrittenNumber(NamedTuple):
    """A number that is written in a source, and the step whose text contains it; None for a number in a YAML file."""

    span: SourceSpan
    step: EvaluatedText | None


class Replay:
    """Evaluates steps again in which one number is written differently.

    span: the place of the number.
    text: what is written there instead.
    """

    def __init__(self, recorder: Recorder, span: SourceSpan, text: str) -> None:
        self._recorder, self._span, self._text = recorder, span, text
        self._values: dict[int, Any] = {}
        self._affected: dict[int, bool] = {}
        self.current: EvaluatedText = EvaluatedText("text", "", None, "")

    def value_of(self, step: EvaluatedText) -> Any:
        """Return the value that a step has with the other number; an own value if it has none."""
        if not self._is_affected(step):
            return step.value
        if id(step) not in self._values:
            outer, self.current = self.current, step
            try:
                self._values[id(step)] = self._evaluated(step)
            finally:
                self.current = outer
        value = self._values[id(step)]
        if value is _FAILED:
            raise _Failed
        return value

    def changes(self, step: EvaluatedText) -> bool:
        """Return whether a step has another value with the other number, or none."""
        with self._prepared():
            try:
                value = self.value_of(step)
            except Exception:  # noqa: BLE001 (whatever xacro raises for the other number)
                return True
            return bool(_seen(self._recorder, step, value) != _seen(self._recorder, step, step.value))

    def _is_affected(self, step: EvaluatedText) -> bool:
        known = self._affected.get(id(step))
        if known is None:
            self._affected[id(step)] = False
            known = self._is_in(step) or any(source is self._span.source for source, _ in step.loads)
            known = known or any(self._is_affected(each) for each in step.inputs.values())
            self._affected[id(step)] = known
        return known

    def _is_in(self, step: EvaluatedText) -> bool:
        if step.place is None or step.place.source is not self._span.source:
            return False
        span = step.place.span
        return span.start <= self._span.start and self._span.end <= span.end

    def _evaluated(self, step: EvaluatedText) -> Any:
        if step.kind == "forwarded":
            return self.value_of(next(iter(step.inputs.values())))
        text = self._text_of(step) if self._is_in(step) else step.text
        if "$" in text:
            module = self._recorder.module
            module.filestack = [step.file]
            value = self._recorder.evaluate(text, step.symbols)
        else:
            value = text
        return value if step.is_text else self._recorder.module.Table._eval_literal(value)

    def _text_of(self, step: EvaluatedText) -> str:
        assert step.place is not None  # noqa: S101 (for mypy; see _is_in)
        span = step.place.span
        data = span.source.data
        before, after = data[span.start : self._span.start], data[self._span.end : span.end]
        return _unescaped((before + self._text.encode() + after).decode("utf-8", "replace"))

    @contextmanager
    def _prepared(self) -> Iterator[None]:
        recorder, module = self._recorder, self._recorder.module
        context, stack = module.substitution_args_context, module.filestack
        arguments = context.get("arg")
        recorder.replay, context["arg"] = self, recorder.arguments
        source, start, end = self._span
        changed = SourceText(source.path, source.data[:start] + self._text.encode() + source.data[end:])
        recorder.files.exchange(source, changed)
        try:
            yield
        finally:
            recorder.files.exchange(changed, source)
            recorder.replay, context["arg"], module.filestack = None, arguments, stack


class _Failed(Exception):
    """A step that another one needs has no value."""


def _seen(recorder: Recorder, step: EvaluatedText, value: Any) -> object:
    """The value as far as it counts: that of a condition is true or false."""
    if step.kind == "condition":
        return bool(recorder.module.get_boolean_value(value, step.text))
    return str(value)


# -- numbers in texts ------------------------------------------------------------------------------------------------


def numbers_behind(recorder: Recorder, step: EvaluatedText) -> Iterator[WrittenNumber]:
    """Yield the numbers that the value of a step depends on: each changes it if it changes a little."""
    for number in candidates([*steps_behind(step)]):
        if depends(recorder, step, number.span):
            yield number


def candidates(steps: list[EvaluatedText]) -> list[WrittenNumber]:
    """Return the numbers in the texts of some steps, and in the YAML values that they have read."""
    found = [*_written_in(steps)]
    for span in read_scalars(steps):
        places = (match.span() for match in _NUMBER.finditer(span.text))
        found += [
            WrittenNumber(SourceSpan(span.source, span.start + start, span.start + end), None) for start, end in places
        ]
    return found


def depends(recorder: Recorder, step: EvaluatedText, span: SourceSpan) -> bool:
    """Return whether the value of a step changes if a number changes a little, up or down."""
    return any(Replay(recorder, span, other).changes(step) for other in neighbours(span.text))


def steps_behind(step: EvaluatedText) -> Iterator[EvaluatedText]:
    """Yield a step and all that it looked up, directly or through others, the nearest first."""
    seen: set[int] = set()
    pending = [step]
    for one in pending:
        if id(one) not in seen:
            seen.add(id(one))
            yield one
            pending += inputs_of(one)


def inputs_of(step: EvaluatedText) -> list[EvaluatedText]:
    """Return what a step looked up, in the order of its text."""
    return sorted(step.inputs.values(), key=lambda each: step.text.find(each.name))


def neighbours(text: str) -> tuple[str, ...]:
    """Return numbers a little above and below a number without a sign."""
    if re.fullmatch(r"\d+", text):
        number = int(text)
        return (str(number + 1), str(number - 1)) if number else ("1",)
    value = float(text)
    return (repr(value * (1 + _STEP)), repr(value * (1 - _STEP))) if value and math.isfinite(value) else ("0.1",)


def _written_in(steps: list[EvaluatedText]) -> Iterator[WrittenNumber]:
    for step in steps:
        if step.place is None or step.kind == "forwarded":
            continue
        span = step.place.span
        if _unescaped(span.text) != step.text or UNKNOWN in step.text:
            continue
        for found in _NUMBER.finditer(span.text):
            start = span.start + len(span.text[: found.start()].encode())
            yield WrittenNumber(SourceSpan(span.source, start, start + len(found.group())), step)


def read_scalars(steps: list[EvaluatedText]) -> list[SourceSpan]:
    """Return the places of the scalars in YAML files that some steps have read, together: of a map of which one value
    was read, only that one."""
    read = dict.fromkeys(where for step in steps for where in step.loads)
    spans: dict[SourceSpan, None] = {}
    for source, keys in read:
        if not any(one is source and len(other) > len(keys) and other[: len(keys)] == keys for one, other in read):
            spans.update(dict.fromkeys(yaml_scalars((source, keys))[:_MOST_VALUES]))
    return list(spans)


def yaml_scalars(where: YamlKey) -> list[SourceSpan]:
    """Return the places of the scalars in a value of a YAML file; of one, if it is a scalar itself."""
    from urdfctl.source.yaml.tree import Mapping, Scalar, read_yaml

    source, keys = where
    nodes: list[Any] = list(read_yaml(source).documents[:1])
    for key in keys:
        nodes = [found for node in nodes for found in _children(node, key)]
    spans = []
    for node in nodes:
        if isinstance(node, Scalar):
            spans.append(node.at.span)
        else:
            nodes += [e.value for e in node.entries] if isinstance(node, Mapping) else node.items
    return spans


def _children(node: Any, key: str | int) -> list[Any]:
    from urdfctl.source.yaml.tree import Mapping, Scalar, Sequence

    if isinstance(node, Sequence):
        return [node.items[key]] if isinstance(key, int) and key < len(node.items) else []
    if isinstance(node, Scalar):
        return []
    found = node.get(str(key))
    if found is not None:
        return [found]
    merged = node.get("<<")
    parts = merged.items if isinstance(merged, Sequence) else [merged] if isinstance(merged, Mapping) else []
    return [found for part in parts for found in _children(part, key)][:1]


def _unescaped(text: str) -> str:
    """Return the value of an attribute whose source text is given."""

    def character(reference: re.Match[str]) -> str:
        name, decimal, hexadecimal = reference.groups()
        return _NAMED[name] if name else chr(int(decimal) if decimal else int(hexadecimal, 16))

    blanks = text.replace("\r\n", " ").replace("\n", " ").replace("\r", " ").replace("\t", " ")
    return _REFERENCE.sub(character, blanks)


def deciding_behind(recorder: Recorder, step: EvaluatedText) -> Iterator[tuple[EvaluatedText, list[WrittenNumber]]]:
    """Yield the conditions and the names of macros and files that decide whether a step, or what it looked up, is
    there, each with the numbers on which the decision depends."""
    seen: set[int] = set()
    for one in [*steps_behind(step)]:
        names = frozenset(each.name for each in one.inputs.values())
        for deciding in recorder.deciding(one.place, names) if one.place is not None else ():
            if id(deciding) not in seen:
                seen.add(id(deciding))
                yield deciding, [*numbers_behind(recorder, deciding)]
