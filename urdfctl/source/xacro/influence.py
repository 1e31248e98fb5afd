"""Trace values in a source text: the YAML files that they were read from, and the arguments that chose the files.

It reads only texts, after the expansion, so that it costs nothing where nobody asks. A property with several
definitions is not traced: the texts do not say which one was in scope. `tracing` records it during the expansion, for
`urdfctl why`.
"""

from __future__ import annotations

import os
import re
from collections.abc import Collection, Iterator, Mapping, Sequence
from fnmatch import fnmatchcase
from types import MappingProxyType

from urdfctl.source.disk.shown import current_folder
from urdfctl.source.span import Call, Place
from urdfctl.source.xml.dom import Element
from urdfctl.startup.records import NamedTuple

_PARTS = r"\$\(\s*arg\s+([^\s()]+)\s*\)|\$\{([^{}]*)\}|\$\([^()]*\)"
_LOAD = r"load_yaml\(\s*(?:([A-Za-z_]\w*)|'([^']*)'|\"([^\"]*)\")\s*\)"
_ASKED = r"\$\(\s*arg\s+([^\s()]+)\s*\)"
_QUOTED = r"\barg\(\s*['\"]([^'\"]+)"
_EVALUATED = r"\$\{([^{}]*)\}|\$\(\s*eval\b(.*)\)"
_FOUND = r"\$\(find\s+([^)]*)"
_DECIDING = {
    "xacro:include": ("filename",),
    "xacro:if": ("value",),
    "xacro:unless": ("value",),
    "xacro:call": ("macro",),
    "xacro:property": ("name", "value", "default"),
    "xacro:arg": ("default",),
    "xacro:element": ("xacro:name",),
    "xacro:attribute": ("name", "value"),
}
_TEXT = r"'[^']*'|\"[^\"]*\""
_NAME = r"(?<![\w.])[A-Za-z_]\w*"
_WHOLE = r"\s*\$\{\s*([A-Za-z_]\w*)\s*\}\s*"
_MOST_STEPS = 200
_DEEPEST = 20


class Influence(NamedTuple):
    """The YAML files that a value was read from, and the arguments that their choice depends on."""

    files: tuple[str, ...] = ()
    arguments: tuple[str, ...] = ()

    def in_words(self) -> str:
        """Return the influence as a sentence; empty if no file is known."""
        if not self.files:
            return ""
        files = " and ".join(f"'{os.path.relpath(file, current_folder())}'" for file in self.files)
        names = " and ".join(f"'{name}'" for name in self.arguments)
        word = "argument" if len(self.arguments) == 1 else "arguments"
        return f"the value comes from {files}" + (f", chosen by the {word} {names}" if names else "")


def no_influence(_place: Place) -> Influence:
    """Return an empty influence, for a place whose values are not traced."""
    return Influence()


def no_origin(place: Place) -> Place:
    """Return the place itself, for one whose values are not traced."""
    return place


class _Scoped(NamedTuple):
    """A source text, and the macro call in which its names are looked up."""

    text: str
    call: Call | None


class Definitions(NamedTuple):
    """The definitions of an expansion.

    properties, arguments: the texts of each.
    loaded: the files that were loaded.
    written: the elements that define each property.
    """

    properties: Mapping[str, Collection[str]]
    arguments: Mapping[str, str]
    loaded: tuple[str, ...]
    written: Mapping[str, Sequence[Element]] = MappingProxyType({})

    def origin(self, place: Place) -> Place:
        """Return where the value is written that a text takes over as a whole: in a property or the call of a macro.

        The place itself, if the text is more than the name of one of these, or if a property has several texts.
        """
        for _ in range(_DEEPEST):
            name = re.fullmatch(_WHOLE, place.span.text)
            found = self._place_of(name[1], place.call) if name else None
            if found is None:
                break
            place = found
        return place

    def _place_of(self, name: str, call: Call | None) -> Place | None:
        for step in call.chain() if call is not None else ():
            tag = step.source.start_tag(step.offset) if step.kind == "macro" else None
            if tag is not None and name in tag.attributes:
                return step.at[name]
            if step.definition is not None and re.search(rf"(?<!\w){name}\b", step.definition.text):
                return None  # a parameter with a default
        elements = {(one.source.path, one.start): one for one in self.written.get(name, ())}
        if len(elements) != 1:
            return None
        [element] = elements.values()
        return element.at["value" if "value" in element.attrs else "default"]

    def influence_on(self, place: Place) -> Influence:
        """Return what the texts at a place depend on. A property with several definitions is not traced."""
        if not self.loaded:
            return Influence()
        files: dict[str, None] = {}
        arguments: dict[str, None] = {}
        pending = [_Scoped(place.span.text, place.call)]
        for scoped in _each_once(pending):
            for expression in _expressions(scoped.text):
                for pattern, names in self._loads(expression, scoped.call):
                    matching = [path for path in self.loaded if fnmatchcase(path, pattern)]
                    if len(matching) == 1:
                        files.setdefault(matching[0])
                        arguments.update(dict.fromkeys(names))
                bare = re.sub(_TEXT, "", re.sub(_LOAD, "", expression))
                pending += [found for name in re.findall(_NAME, bare) for found in self._definition(name, scoped.call)]
        return Influence(tuple(files), tuple(arguments))

    def arguments_of_file(self, place: Place, expression: str) -> list[str]:
        """Return the arguments in the name of a file that could not be read: the file that an expression loads, or the
        one that is included at a place."""
        if expression:
            loads = [names for _, names in self._loads(expression, place.call)]
            return loads[0] if len(loads) == 1 else []
        names: list[str] = []
        self._pattern(_Scoped(_included(place), place.call), names, _DEEPEST)
        return names

    def arguments_behind(self, place: Place, expression: str) -> set[str]:
        """Return the arguments that an element hangs on, or an expression that was evaluated for it: through
        properties, parameters of macros and the texts of other arguments."""
        texts = list(_deciding(place))
        if expression.startswith("$(find"):
            texts = [text for one in texts for text in re.findall(_FOUND, one)]
        pending = [_Scoped(text, place.call) for text in (*texts, f"${{{expression}}}")]
        found: set[str] = set()
        for scoped in _each_once(pending):
            evaluated = " ".join(part for found_parts in re.findall(_EVALUATED, scoped.text) for part in found_parts)
            words = set(re.findall(_NAME, evaluated))
            asked = {*re.findall(_ASKED, scoped.text), *re.findall(_QUOTED, scoped.text)}
            asked |= words & self.arguments.keys() if "$(eval" in scoped.text else set()
            found |= asked
            pending += [_Scoped(self.arguments[name], None) for name in asked if name in self.arguments]
            pending += [one for name in words for one in self._definitions(name, scoped.call)]
        return found

    def _definitions(self, name: str, call: Call | None) -> list[_Scoped]:
        """All texts that a name may stand for where it is looked up."""
        return self._definition(name, call) or [_Scoped(text, call) for text in self.properties.get(name, ())]

    def _definition(self, name: str, call: Call | None) -> list[_Scoped]:
        """Return the text that defines a name: the argument of a macro call, or a property."""
        for step in call.chain() if call is not None else ():
            tag = step.source.start_tag(step.offset) if step.kind == "macro" else None
            if tag is not None and name in tag.attributes:
                start, end = tag.attributes[name]
                return [_Scoped(step.source.data[start:end].decode("utf-8", "replace"), step.parent)]
        texts = self.properties.get(name, ())
        return [_Scoped(text, call) for text in texts] if len(texts) == 1 else []

    def _loads(self, expression: str, call: Call | None) -> Iterator[tuple[str, list[str]]]:
        """Yield the path patterns of the files that an expression loads, each with its arguments."""
        for name, *literals in re.findall(_LOAD, expression):
            scoped = self._definition(name, call) if name else [_Scoped("".join(literals), call)]
            for one in scoped:
                names: list[str] = []
                yield "*" + self._pattern(one, names, _DEEPEST).lstrip("*"), names

    def _pattern(self, scoped: _Scoped, names: list[str], depth: int) -> str:
        """Return a text with its arguments and properties filled in, and a star for each unknown part. Arguments whose
        own text depends on no other argument are added to `names`."""

        def filling(part: re.Match[str]) -> str:
            argument, expression = part.group(1), part.group(2)
            if argument and argument in self.arguments:
                text = self.arguments[argument]
                if "$(arg" not in text:
                    names.append(argument)
                return self._pattern(_Scoped(text, None), names, depth - 1)
            found = self._definition(expression.strip(), scoped.call) if expression else []
            return self._pattern(found[0], names, depth - 1) if found else "*"

        return re.sub(_PARTS, filling, scoped.text) if depth else "*"


def _each_once(pending: list[_Scoped]) -> Iterator[_Scoped]:
    """Yield the texts of a list that grows meanwhile, the last one first and each once, up to a number of steps."""
    seen: set[_Scoped] = set()
    while pending and len(seen) < _MOST_STEPS:
        scoped = pending.pop()
        if scoped not in seen:
            seen.add(scoped)
            yield scoped


def _deciding(place: Place) -> Iterator[str]:
    """The texts that decide whether what is at a place can be evaluated: not the parameters in a macro call."""
    tag = place.source.start_tag(place.start)
    if tag is None:
        yield place.span.text
        return
    names = _DECIDING.get(tag.name, () if tag.name.startswith("xacro:") else tuple(tag.attributes))
    for name in names:
        start, end = tag.attributes.get(name, (0, 0))
        yield place.source.data[start:end].decode("utf-8", "replace")


def _included(place: Place) -> str:
    """Return the file name of an include; empty if there is no include at a place."""
    tag = place.source.start_tag(place.start)
    if tag is None or tag.name != "xacro:include":
        return ""
    start, end = tag.attributes.get("filename", (0, 0))
    return place.source.data[start:end].decode("utf-8", "replace")


def _expressions(text: str) -> list[str]:
    return [part.group(2) for part in re.finditer(_PARTS, text) if part.group(2)]
