"""Where the values in a text of the source come from: the YAML files that were loaded for it, and the arguments that
chose them."""

from __future__ import annotations

import os
import re
from collections.abc import Collection, Iterator, Mapping
from fnmatch import fnmatchcase

from urdfctl.record import NamedTuple
from urdfctl.source.span import Call, Place

_PARTS = re.compile(r"\$\(\s*arg\s+([^\s()]+)\s*\)|\$\{([^{}]*)\}|\$\([^()]*\)")
_LOAD = re.compile(r"load_yaml\(\s*(?:([A-Za-z_]\w*)|'([^']*)'|\"([^\"]*)\")\s*\)")
_TEXT = re.compile(r"'[^']*'|\"[^\"]*\"")
_NAME = re.compile(r"(?<![\w.])[A-Za-z_]\w*")
_MOST_STEPS = 200
_DEEPEST = 20


class Influence(NamedTuple):
    """The YAML files that a value was read from, and the arguments that the choice of these files hangs on."""

    files: tuple[str, ...] = ()
    arguments: tuple[str, ...] = ()

    def in_words(self) -> str:
        """As a sentence; empty where no file is known."""
        if not self.files:
            return ""
        files = " and ".join(f"'{os.path.relpath(file)}'" for file in self.files)
        names = " and ".join(f"'{name}'" for name in self.arguments)
        word = "argument" if len(self.arguments) == 1 else "arguments"
        return f"the value comes from {files}" + (f", chosen by the {word} {names}" if names else "")


def no_influence(_place: Place) -> Influence:
    """Nothing is known of what a place hangs on."""
    return Influence()


class _Scoped(NamedTuple):
    """A text of the source, and the macro call in which its names are looked up."""

    text: str
    call: Call | None


class Definitions(NamedTuple):
    """What an expansion knew: the texts that define each property, each argument's text, and the files it loaded."""

    properties: Mapping[str, Collection[str]]
    arguments: Mapping[str, str]
    loaded: tuple[str, ...]

    def influence_on(self, place: Place) -> Influence:
        """What the texts at a place hang on. A property that is defined in several ways is not followed."""
        if not self.loaded:
            return Influence()
        files: dict[str, None] = {}
        arguments: dict[str, None] = {}
        pending = [_Scoped(place.span.text, place.call)]
        seen: set[_Scoped] = set()
        while pending and len(seen) < _MOST_STEPS:
            scoped = pending.pop()
            if scoped in seen:
                continue
            seen.add(scoped)
            for expression in _expressions(scoped.text):
                for pattern, names in self._loads(expression, scoped.call):
                    matching = [path for path in self.loaded if fnmatchcase(path, pattern)]
                    if len(matching) == 1:
                        files.setdefault(matching[0])
                        arguments.update(dict.fromkeys(names))
                bare = _TEXT.sub("", _LOAD.sub("", expression))
                pending += [found for name in _NAME.findall(bare) for found in self._definition(name, scoped.call)]
        return Influence(tuple(files), tuple(arguments))

    def arguments_of_file(self, place: Place, expression: str) -> list[str]:
        """The arguments in the name of a file that could not be read: of the one that an expression loads, or, where
        none was being evaluated, of the one that is included at a place."""
        if expression:
            loads = [names for _, names in self._loads(expression, place.call)]
            return loads[0] if len(loads) == 1 else []
        names: list[str] = []
        self._pattern(_Scoped(_included(place), place.call), names, _DEEPEST)
        return names

    def _definition(self, name: str, call: Call | None) -> list[_Scoped]:
        """The text that a name stands for where it is looked up: a parameter of a macro's call, or else a property."""
        for step in call.chain() if call is not None else ():
            tag = step.source.start_tag(step.offset) if step.kind == "macro" else None
            if tag is not None and name in tag.attributes:
                start, end = tag.attributes[name]
                return [_Scoped(step.source.data[start:end].decode("utf-8", "replace"), step.parent)]
        texts = self.properties.get(name, ())
        return [_Scoped(text, call) for text in texts] if len(texts) == 1 else []

    def _loads(self, expression: str, call: Call | None) -> Iterator[tuple[str, list[str]]]:
        """The patterns of the paths that an expression loads, each with the arguments in it."""
        for name, *literals in _LOAD.findall(expression):
            scoped = self._definition(name, call) if name else [_Scoped("".join(literals), call)]
            for one in scoped:
                names: list[str] = []
                yield "*" + self._pattern(one, names, _DEEPEST).lstrip("*"), names

    def _pattern(self, scoped: _Scoped, names: list[str], depth: int) -> str:
        """A text with its arguments and properties put in; a star for all that is not known. The arguments whose own
        text hangs on no other one are added to `names`."""

        def filling(part: re.Match[str]) -> str:
            argument, expression = part.group(1), part.group(2)
            if argument and argument in self.arguments:
                text = self.arguments[argument]
                if "$(arg" not in text:
                    names.append(argument)
                return self._pattern(_Scoped(text, None), names, depth - 1)
            found = self._definition(expression.strip(), scoped.call) if expression else []
            return self._pattern(found[0], names, depth - 1) if found else "*"

        return _PARTS.sub(filling, scoped.text) if depth else "*"


def _included(place: Place) -> str:
    """The file's name in an include; empty where something else stands at a place."""
    tag = place.source.start_tag(place.start)
    if tag is None or tag.name != "xacro:include":
        return ""
    start, end = tag.attributes.get("filename", (0, 0))
    return place.source.data[start:end].decode("utf-8", "replace")


def _expressions(text: str) -> list[str]:
    return [part.group(2) for part in _PARTS.finditer(text) if part.group(2)]
