"""The answer of `urdfctl why`, as plain data: the chain from a value back to its sources, and what uses it."""

from __future__ import annotations

from collections.abc import Iterator
from typing import Any

from urdfctl.diagnostic import located
from urdfctl.model.launch import Launch
from urdfctl.source.opaque import UNKNOWN
from urdfctl.source.span import Place, SourceSpan
from urdfctl.source.xacro.tracing.recording import EvaluatedText, Recorder
from urdfctl.source.xacro.tracing.replay import (
    candidates,
    deciding_behind,
    depends,
    inputs_of,
    numbers_behind,
    read_scalars,
    steps_behind,
    yaml_scalars,
)
from urdfctl.trace.address import ValueAddress, address_of

_MOST_LINKS = 100
_MOST_TEXT = 120
_NAMES = {"forwarded": "parameter", "default": "parameter", "given": "argument"}

Json = dict[str, Any]


def answer(recorder: Recorder, value: ValueAddress, launch: Launch | None) -> Json:
    """Return where a value comes from.

    launch: what gives the description its arguments; None if it is no launch file.
    """
    step = recorder.step_of(value.element, value.attribute)
    decided = [
        {**_link(deciding, launch), "numbers": [spanned(number.span) for number in numbers]}
        for deciding, numbers in deciding_behind(recorder, step)
    ]
    return {
        "address": address_of(value),
        "value": readable(value.text),
        "chain": [*_chain(step, launch, depth=0, seen=set())][:_MOST_LINKS],
        "numbers": [spanned(number.span) for number in numbers_behind(recorder, step)],
        "decided_by": decided,
    }


def spanned(span: SourceSpan) -> Json:
    """Return a span as plain data, with its text."""
    at = located(span)
    return {"text": span.text, "file": at.file, "line": at.line, "column": at.column, "end_column": at.end_column}


def readable(text: object) -> str:
    """Return a value as a short text, with a question mark for what is unknown."""
    if isinstance(text, dict | list | tuple):
        count = len(text)
        return f"a {'map' if isinstance(text, dict) else 'list'} of {count} value{'' if count == 1 else 's'}"
    shown = " ".join(str(text).replace(UNKNOWN, "?").split())
    return shown if len(shown) <= _MOST_TEXT else f"{shown[:_MOST_TEXT]}…"


def _chain(step: EvaluatedText, launch: Launch | None, *, depth: int, seen: set[int]) -> Iterator[Json]:
    """Yield the links of a chain, a link before those that it looked up."""
    if id(step) in seen:
        return
    seen.add(id(step))
    yield {**_link(step, launch), "depth": depth}
    for each in inputs_of(step):
        yield from _chain(each, launch, depth=depth + 1, seen=seen)
    yield from ({**link, "depth": depth + 1} for link in _yaml_links(step))


def _link(step: EvaluatedText, launch: Launch | None) -> Json:
    place = step.place if step.kind != "given" else _given_at(step.name, launch)
    found: Json = {
        "kind": _NAMES.get(step.kind, step.kind),
        "name": step.name,
        "text": readable(step.text),
        "value": readable(step.value),
        "given_by": _giver(step, launch),
        "calls": [],
    }
    if place is not None:
        found.update(file=place.span.file, **_position(place), calls=[*_calls(place)])
    return found


def _giver(step: EvaluatedText, launch: Launch | None) -> str:
    """What gives a parameter or argument its value: a default, a launch file, the command line; empty for others."""
    if step.kind == "given" and UNKNOWN in step.text:
        return "not given"
    if step.kind in {"argument", "default"}:
        return "default"
    if step.kind == "given":
        return "launch file" if _given_at(step.name, launch) is not None else "command line"
    return ""


def _given_at(name: str, launch: Launch | None) -> Place | None:
    description = launch.description if launch is not None else None
    return next((word.at for word in (description.names if description else ()) if word.text == name), None)


def _position(place: Place) -> Json:
    at = located(place.span)
    return {"line": at.line, "column": at.column}


def _calls(place: Place) -> Iterator[Json]:
    for call in place.call.chain() if place.call is not None else ():
        line, column = call.source.position(call.offset)
        yield {"kind": call.kind, "name": call.name, "file": call.source.path, "line": line, "column": column}


def _yaml_links(step: EvaluatedText) -> Iterator[Json]:
    """Yield the values of YAML files that a step read, and the files that it loaded."""
    for source, keys in step.loads:
        name = ".".join(str(key) for key in keys)
        spans = yaml_scalars((source, keys))[:2] if keys else [SourceSpan(source, 0, 0)]
        if len(spans) == 1:
            at = spanned(spans[0])
            text = at.pop("text")
            yield {"kind": "yaml", "name": name, "text": text, "value": readable(text), **at, "calls": []}


# -- forward ---------------------------------------------------------------------------------------------------------


def depends_on(recorder: Recorder, value: ValueAddress, span: SourceSpan) -> bool:
    """Return whether a value was evaluated from what is written in a span: a text, or a value of a YAML file.

    If that is a number, it must change the value.
    """
    step = recorder.step_of(value.element, value.attribute)
    steps = [*steps_behind(step)]
    places = [one.place.span for one in steps if one.place is not None and one.kind != "forwarded"]
    if span.file in {source.path for one in steps for source, _ in one.loads}:
        places += read_scalars(steps)
    if not any(_overlap(place, span) for place in places):
        return False
    inside = [number for number in candidates(steps) if _overlap(number.span, span)]
    return not inside or any(depends(recorder, step, number.span) for number in inside)


def _overlap(span: SourceSpan, other: SourceSpan) -> bool:
    is_same = span.file == other.file
    return is_same and span.start < max(other.end, other.start + 1) and other.start < max(span.end, span.start + 1)
