"""`why` lists what a value depends on: changing a listed number changes the value, changing another does not."""

from __future__ import annotations

import os
import random
import re
from collections.abc import Iterator, Mapping
from functools import lru_cache
from pathlib import Path
from typing import Any

from corpus import CORPUS, own_roots, roots, workspace_of
from sampling import WHOLE

from urdfctl.source.disk.files import Files
from urdfctl.source.span import Call, SourceSpan, SourceText
from urdfctl.source.workspaces.packages import PackageIndex, Packages
from urdfctl.source.xacro.expansion import Expander
from urdfctl.source.xacro.tracing.expansion import TracingExpander
from urdfctl.source.xacro.tracing.replay import deciding_behind, numbers_behind
from urdfctl.source.xml.dom import Element

ATTRIBUTES = 1000 if WHOLE else 40
"""How many attributes are tried."""
NUMBER = re.compile(rb"(?<![\w.])(?:\d+\.?\d*|\.\d+)(?:[eE][+-]?\d+)?(?![\w.])")
NUMERIC = re.compile(r"\s*[-+]?[\d.]+(?:e[-+]?\d+)?(?:\s+[-+]?[\d.]+(?:e[-+]?\d+)?)*\s*", re.IGNORECASE)
SIGNIFICANT = 10
"""A digit far behind the first ones may not change a double at all."""
NEAR = 400
"""Half of the numbers that are not listed are looked for within so many bytes of one that is."""


@lru_cache(3)
def index(workspace: Path) -> PackageIndex:
    return PackageIndex(str(workspace), environ={})


def expander(workspace: Path, path: str, kind: type[Expander], held: Mapping[str, bytes]) -> Expander:
    packages = Packages(path, index(workspace))
    return kind(Files([str(workspace)], packages.source_of, held), packages, {})


def key_of(element: Element) -> tuple[object, ...]:
    calls: list[object] = []
    call: Call | None = element.call
    while call is not None:
        calls.append((call.source.path, call.offset))
        call = call.parent
    return (element.source.path, element.start, *calls)


def values(root: Element) -> dict[tuple[object, ...], tuple[Element, str, str]]:
    """All attributes of an expanded tree, by where they come from."""
    found: dict[tuple[object, ...], tuple[Element, str, str]] = {}
    pending = [root]
    while pending:
        element = pending.pop()
        pending += element.elements()
        for name, value in element.attrs.items():
            key: tuple[object, ...] = (key_of(element), name)
            while key in found:
                key = (*key, "again")
            found[key] = element, name, value
    return found


def other_digits(data: bytes, start: int, end: int) -> Iterator[bytes]:
    """The data with a number a little larger and a little smaller, as long as before."""
    text = data[start:end]
    mantissa = re.match(rb"[\d.]*", text)
    places = [at for at in range(mantissa.end() if mantissa else 0) if text[at : at + 1] in b"123456789"]
    at = start + (places[:SIGNIFICANT][-1] if places else 0)
    digit = int(data[at : at + 1].replace(b".", b"0"))
    for other in (digit + 1, digit - 1):
        if 0 <= other <= 9 and data[at : at + 1] != b".":
            yield data[:at] + str(other).encode() + data[at + 1 :]


class Robot:
    """A description of the corpus, as it is and with one number changed."""

    def __init__(self, root: Mapping[str, Any]) -> None:
        self.path, self.workspace = str(CORPUS / root["path"]), workspace_of(root)
        self.arguments = {name: str(value) for name, value in (root.get("args") or {}).items()}
        self.expander = expander(self.workspace, self.path, TracingExpander, {})
        document = self.expander.expand(self.path, self.arguments).document
        assert document is not None
        assert document.documentElement is not None
        self.values = values(document.documentElement)
        self.numeric = [key for key, (_, _, value) in self.values.items() if NUMERIC.fullmatch(value)]

    def changed(self, key: tuple[object, ...], span: SourceSpan) -> list[bool]:
        """Whether an attribute changes, for each way to write a number a little differently."""
        found = []
        for data in other_digits(span.source.data, span.start, span.end):
            document = (
                expander(self.workspace, self.path, Expander, {os.path.realpath(span.file): data})
                .expand(self.path, self.arguments)
                .document
            )
            root = document.documentElement if document else None
            if root is not None:
                after = values(root).get(key)
                found.append(after is None or after[2] != self.values[key][2])
        return found


def unlisted(robot: Robot, listed: list[SourceSpan], chance: random.Random) -> SourceSpan | None:
    sources: list[SourceText] = [s for s in robot.expander.files.sources() if not s.path.endswith("package.xml")]
    near = chance.choice(listed) if listed and chance.random() < 0.5 else None
    source = near.source if near else chance.choice(sources)
    start = near.start - NEAR if near else source.data.find(b"?>")
    spans = [SourceSpan(source, *found.span()) for found in NUMBER.finditer(source.data, max(0, start))]
    spans = [span for span in spans if span not in listed and (near is None or span.start < near.start + NEAR)]
    return chance.choice(spans) if spans else None


def wrong(robot: Robot, chance: random.Random) -> Iterator[str | None]:
    """For a listed number and another one of a random attribute: what is wrong with it, or None."""
    key = chance.choice(robot.numeric)
    element, name, value = robot.values[key]
    recorder = robot.expander.recorder
    step = recorder.step_of(element, name)
    listed = [number.span for number in numbers_behind(recorder, step)]
    deciding = [number.span for _, numbers in deciding_behind(recorder, step) for number in numbers]
    said = f"{robot.path}: {element.source.path}:{element.source.position(element.start).line} {name}={value!r}"
    for kind, span in (
        ("", chance.choice(listed) if listed else None),
        ("not ", unlisted(robot, listed + deciding, chance)),
    ):
        if span is not None and (outcomes := robot.changed(key, span)):
            place = f"{span.file}:{span.source.position(span.start).line} {span.text!r}"
            yield f"{said}: {place} is {kind}listed" if any(outcomes) == bool(kind) else None


def test_numbers_that_why_lists_change_the_value_and_others_do_not() -> None:
    chance = random.Random(19)  # noqa: S311 (a sample)
    of_corpus = [root for root in (*own_roots(), *roots()) if root["expands"] and not root["path"].endswith(".urdf")]
    robots = [Robot(root) for root in chance.sample(of_corpus, min(len(of_corpus), ATTRIBUTES // 4))]
    robots = [robot for robot in robots if robot.numeric]
    outcomes = [outcome for number in range(ATTRIBUTES) for outcome in wrong(robots[number % len(robots)], chance)]
    failures = [outcome for outcome in outcomes if outcome]
    print(f"{len(outcomes) - len(failures)} of {len(outcomes)} right")
    assert len(outcomes) > 1.5 * ATTRIBUTES
    assert len(failures) <= 0.01 * len(outcomes), "\n".join(failures)
