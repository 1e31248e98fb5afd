"""Rename random names of a robot, and compare the expansions before and after."""

from __future__ import annotations

import os
import random
import re
from collections import Counter
from collections.abc import Collection, Iterator

from urdfctl.config.settings import Settings
from urdfctl.errors import UserError
from urdfctl.lint.selection import Selection
from urdfctl.lint.target import LintedTarget, lint_target
from urdfctl.load.loader import Loader
from urdfctl.load.target import Target
from urdfctl.server.analysis.names import names_in
from urdfctl.server.analysis.question import Question
from urdfctl.server.features.navigation import NamesAround, renamed
from urdfctl.source.xml.dom import COMMENT, Element, XmlText

NEW = "renamed_here"


def differences(target: Target, number: int, seed: int) -> Iterator[str]:
    """Yield each name whose renaming changes more than that name. Names that cannot be renamed are passed over."""
    rng = random.Random(seed)  # noqa: S311
    loaded = Loader(Settings()).load(target)
    names = names_in(loaded) if loaded.root is not None and loaded.project.complete else []
    before = lint_target(Loader(Settings()), target, Selection())
    for name in rng.choices(names, k=number) if names else ():
        position = name.span.source.position(name.span.start)
        around = NamesAround(Question([loaded], name.span.source, position.line, position.column))
        written = name.span.text
        new = re.sub(r"\}([\w-]+)", rf"}}\1_{NEW}", written, count=1) if name.is_computed else NEW
        try:
            edits = renamed(around, new)
        except UserError:
            continue
        texts = {os.path.realpath(edit.file): loaded.sources[edit.file].data for edit in edits}
        for edit in sorted(edits, key=lambda one: -one.start):
            real = os.path.realpath(edit.file)
            texts[real] = texts[real][: edit.start] + edit.text.encode() + texts[real][edit.end :]
        olds = [each.text for each in around.all if each.span == name.span] or [name.text]
        after = lint_target(Loader(Settings(), texts), target, Selection())
        if _flat(before, olds) != _flat(after, olds) or _codes(after) - _codes(before):
            yield f"{name.kind} '{name.text}' of {os.path.basename(name.span.file)}:{position.line}"


def _codes(linted: LintedTarget) -> Counter[str]:
    """What is found: a use that was forgotten would name what does not exist."""
    return Counter(finding.code for finding in linted.result.outcome.diagnostics)


Flat = list[tuple[str, tuple[tuple[str, str], ...], str]]


def _flat(linted: LintedTarget, old: Collection[str]) -> Flat:
    """All elements with their attributes and texts, in which all old and new names are one."""
    found: Flat = []
    pending: list[Element] = [linted.root] if linted.root is not None else []
    while pending:
        element = pending.pop()
        pending += element.elements()
        nodes = (node for node in element.children() if isinstance(node, XmlText) and node.nodeType != COMMENT)
        text = "".join(node.data for node in nodes).strip()
        values = sorted((key, _plain(value, old)) for key, value in element.attrs.items())
        found.append((element.tagName, tuple(values), _plain(text, old)))
    return sorted(found)


def _plain(text: str, old: Collection[str]) -> str:
    """A text without the mark of the new name; "old" for a name that is renamed as a whole."""
    plain = text.replace(f"_{NEW}", "")
    return "old" if plain == NEW or plain in old else plain
