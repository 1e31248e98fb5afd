"""Take words out of sound files, insert what is offered in their place, and look for findings that were not there."""

from __future__ import annotations

import os
import random
import re
from collections import Counter
from collections.abc import Iterator, Mapping, Sequence
from itertools import islice, zip_longest
from pathlib import Path
from typing import NamedTuple

from urdfctl.server.analysis.items import OfferedItem
from urdfctl.server.analysis.question import Question
from urdfctl.server.analysis.workspace import Checked, EditorSettings, Workspace
from urdfctl.server.features.completion import items_at
from urdfctl.source.span import SourceText

_IN_XML = {
    "link": r"<(?:parent|child)\s+link=\"([^\"]*)\"|<gazebo\s+reference=\"([^\"]*)\"",
    "mimicked joint": r"<mimic\s+joint=\"([^\"]*)\"",
    "part": r"<joint\s+name=\"([^\"]*)\"",
    "semantic": r"(?:base_link|tip_link|link1|link2)=\"([^\"]*)\"",
    "interface": r"<(?:command|state)_interface\s+name=\"([^\"]*)\"",
    "package": r"\$\(find(?:-pkg-share)?\s+([\w.-]+)\)",
    "file": r"\$\(find(?:-pkg-share)?\s+[\w.-]+\)/([^\"'$)<\s]+)[\"']",
    "argument": r"\$\(arg\s+([\w.-]+)\)",
    "property": r"\$\{(?:[^{}]*[^\w.{}])?([A-Za-z_]\w*)[^{}]*\}",
    "macro": r"<(xacro:(?!arg|property|include|macro|if|unless|insert_block)\w+)",
    "macro parameter": r"<xacro:(?!arg|property|include|macro|if|unless|insert_block)\w+[^<>]*?\s(\w+=\"[^\"]*\")",
    "spawner argument": r"type=\"spawner\"[^<>]*?\sargs=\"(?:[^\"]*\s)?([\w-]+)(?:\s[^\"]*)?\"",
}
_IN_YAML = {
    "type": r"^\s*type:\s*[\"']?([\w/]+)",
    "parameter": r"^ {2,}(?!- )([A-Za-z_]\w*:[ \t]*[^\s#](?:[^#\n]*[^\s#])?)[ \t]*(?:#|$)",
    "element": r"^\s*-\s*[\"']?([\w/.-]+)[\"']?\s*$",
    "element in a row": r"[\[,]\s*[\"']?([A-Za-z_][\w/.-]*)[\"']?\s*(?=[\],])",
    "frame": r"^\s*\w*(?:frame|link)\w*:\s*[\"']?([A-Za-z_][\w.-]*)",
}
_IN_PYTHON = {"spawner argument": r"executable=[\"']spawner[\"'],\s*arguments=\[[^\]]*?[\"']([\w-]+)[\"']"}


Codes = Counter[tuple[str, str]]
"""How many findings of each code are in each file."""


UNDECIDED = {"type": frozenset({"UC431", "UC463", "UC464", "UC465", "UC614"})}
"""Codes that a word alone does not decide: whether a controller has what its type needs, when its parameters,
package.xml and the other controllers are written."""


class Place(NamedTuple):
    """A word of a file that is taken out. start, end: its offsets in the text."""

    kind: str
    start: int
    end: int


Word = tuple[Path, str, Place]
"""A file, its text, and a word in it."""


class Insertion(NamedTuple):
    """What was inserted for a word, and the codes that came with it."""

    file: str
    kind: str
    word: str
    item: str
    line: int
    new: tuple[str, ...]

    def is_harmful(self) -> bool:
        """Return whether a finding came that only what is written next can avoid."""
        return not set(self.new) <= UNDECIDED.get(self.kind, frozenset())

    def __str__(self) -> str:
        return f"{self.file}:{self.line}: {self.kind} '{self.item}' for '{self.word}': {' '.join(self.new)}"


def places(path: Path, text: str) -> list[Place]:
    """Return the words of a file at which something is offered."""
    tables = {".yaml": _IN_YAML, ".yml": _IN_YAML, ".py": _IN_PYTHON}
    found = []
    for kind, pattern in tables.get(path.suffix, _IN_XML).items():
        for match in re.finditer(pattern, text, re.MULTILINE):
            start, end = next(match.span(group) for group in range(1, match.re.groups + 1) if match[group] is not None)
            found.append(Place(kind, start, end))
    return found


def insertions(folder: Path, number: int, seed: int, *, each: int = 6) -> Iterator[Insertion]:
    """Yield what is inserted for random words of the files of a folder. number: of words. each: at most so many items.

    The words are of as many kinds as there are.

    Every second word is taken out as a whole; of the others, the first half is there already.
    """
    rng = random.Random(seed)  # noqa: S311
    workspace = Workspace(str(folder), EditorSettings())
    before = workspace.check()
    files = [
        path for path in map(Path, sorted(before.files)) if path.suffix in _SUFFIXES and path.is_relative_to(folder)
    ]
    words: dict[str, list[Word]] = {}
    for path in files:
        with path.open(encoding="utf-8", newline="", errors="surrogateescape") as file:
            text = file.read()
        for place in places(path, text):
            words.setdefault(place.kind, []).append((path, text, place))
    expected = codes(before)
    for path, text, place in mixed(words, number, rng):
        half = rng.choice((0, halfway(text[place.start : place.end])))
        typed = text[: place.start + half] + text[place.end :]
        items, unfinished = offered(workspace, path, typed, place.start + half)
        word = text[place.start : place.end]
        for item in rng.sample(items, min(each, len(items))):
            whole = inserted(typed, place.start + half, filled(item, word))
            workspace.changed(str(path), data(whole))
            new = codes(workspace.check()) - (expected | unfinished)
            line = text.count("\n", 0, place.start) + 1
            yield Insertion(path.name, place.kind, word, item.text, line, tuple(sorted(code for _, code in new)))
        workspace.changed(str(path), None)


def mixed(words: Mapping[str, Sequence[Word]], number: int, rng: random.Random) -> list[Word]:
    """Return random words, in turn one of each kind."""
    shuffled = [rng.sample(of_one_kind, len(of_one_kind)) for _, of_one_kind in sorted(words.items())]
    in_turn = (word for turn in zip_longest(*shuffled) for word in turn if word is not None)
    return list(islice(in_turn, number))


def offered(workspace: Workspace, path: Path, typed: str, offset: int) -> tuple[list[OfferedItem], Codes]:
    """Return what is offered at a place of an unfinished text, and what is found in it.

    Only what begins with the word that is typed there already, as an editor shows it.
    """
    workspace.changed(str(path), data(typed))
    unfinished = codes(workspace.check())
    robots = workspace.robots_with(str(path))
    sources = [source for robot in robots for source in robot.sources.values()]
    read = next((one for one in sources if os.path.realpath(one.path) == os.path.realpath(path)), None)
    is_current = read is not None and read.data == data(typed)
    source = read if read is not None and is_current else SourceText(read.path if read else str(path), data(typed))
    position = source.position(len(data(typed[:offset])))
    question = Question(
        robots, source, position.line, position.column, is_current, packages=workspace.packages_for(str(path))
    )
    items = items_at(question, workspace.attempts(str(path)))
    fitting = [item for item in items if item.text.startswith(typed[offset - item.replaces : offset])]
    return [item for item in fitting if not item.text.endswith(":")], unfinished


def halfway(word: str) -> int:
    """Return how much of a word is typed halfway; of a parameter with its value, half of its name."""
    return len(re.split("[:=]", word)[0]) // 2


def filled(item: OfferedItem, word: str) -> OfferedItem:
    """Return an item in which the user has written the value that it leaves open: the one that was there."""
    value = re.search(r"=\"(.*)\"$", word, re.DOTALL)
    return item._replace(text=f'{item.text[:-1]}{value[1]}"') if value and item.text.endswith('=""') else item


def inserted(typed: str, offset: int, item: OfferedItem) -> str:
    """Return a text with an item."""
    return typed[: offset - item.replaces] + item.text + typed[offset:]


def codes(checked: Checked) -> Codes:
    """Return how many findings of each code are in each file."""
    return Counter((file, finding.code) for file, found in checked.findings.items() for finding in found)


def data(text: str) -> bytes:
    """Return the bytes of a text."""
    return text.encode("utf-8", "surrogateescape")


_SUFFIXES = {".urdf", ".xacro", ".srdf", ".yaml", ".yml", ".launch", ".xml", ".py"}
