"""Rename random names of a robot, and compare the expansions before and after."""

from __future__ import annotations

import os
import random
from collections.abc import Iterator, Mapping
from pathlib import Path

from urdfctl.config.settings import Settings
from urdfctl.errors import UserError
from urdfctl.load.loader import LoadedTarget, Loader
from urdfctl.load.target import Target
from urdfctl.server.names import JOINT, LINK, names_in
from urdfctl.server.navigation import NamesAround, renamed
from urdfctl.server.question import Question
from urdfctl.source.dom import COMMENT, Element, Text

NEW = "renamed_here"


def differences(path: Path, number: int, seed: int) -> Iterator[str]:
    """Yield each name whose renaming changes more than that name. Names that cannot be renamed are passed over."""
    rng = random.Random(seed)  # noqa: S311
    loaded = Loader(Settings()).load(Target(str(path)))
    names = names_in(loaded) if loaded.root is not None and loaded.project.complete else []
    for name in rng.choices(names, k=number) if names else ():
        position = name.span.source.position(name.span.start)
        around = NamesAround(Question([loaded], name.span.source, position.line, position.column))
        try:
            edits = renamed(around, NEW)
        except UserError:
            continue
        texts = {os.path.realpath(edit.file): loaded.sources[edit.file].data for edit in edits}
        for edit in sorted(edits, key=lambda one: -one.start):
            real = os.path.realpath(edit.file)
            texts[real] = texts[real][: edit.start] + edit.text.encode() + texts[real][edit.end :]
        after = Loader(Settings(), texts).load(Target(str(path)))
        at = around.at
        of_robot = at is not None and at.kind in {LINK, JOINT}
        if _flat(loaded, at.text if of_robot and at else "") != _flat(after, ""):
            yield f"{name.kind} '{name.text}' of {os.path.basename(name.span.file)}:{position.line}"


Flat = list[tuple[str, tuple[tuple[str, str], ...], str]]


def _flat(loaded: LoadedTarget, old: str) -> tuple[Flat, list[str]]:
    """All elements with their attributes and texts, in which the new name is written for an old one, and the kinds of
    problems. An attribute `type` or the robot's name that is equal to the old name is another thing."""

    def named(key: str, value: str, tag: str) -> str:
        is_other = key in {"type", "filename", "plugin"} or (tag, key) in {("robot", "name"), ("sensor", "name")}
        return NEW if old and value == old and not is_other else value

    found: Flat = []
    pending: list[Element] = [loaded.root] if loaded.root is not None else []
    while pending:
        element = pending.pop()
        pending += element.elements()
        attributes: Mapping[str, str] = element.attrs
        nodes = (node for node in element.children() if isinstance(node, Text) and node.nodeType != COMMENT)
        text = "".join(node.data for node in nodes).strip()
        values = sorted((key, named(key, value, element.tagName)) for key, value in attributes.items())
        found.append((element.tagName, tuple(values), named("", text, element.tagName)))
    return sorted(found), [problem.kind.name for problem in loaded.project.problems]
