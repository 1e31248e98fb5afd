"""What an expression can use at a place of a xacro file: properties, arguments and macro parameters.

xacro is read as it is written, so that an unfinished text and a macro that nobody calls are understood too.
"""

from __future__ import annotations

import re
from collections.abc import Iterable, Iterator, Mapping
from contextlib import suppress
from functools import partial

from urdfctl.server.analysis.xacro_names import ARGUMENT, MACRO, PARAMETER, PROPERTY
from urdfctl.source.disk.files import is_launch
from urdfctl.source.problem import ReadError
from urdfctl.source.span import SourceText
from urdfctl.source.xml.dom import Element
from urdfctl.source.xml.parsing import parse
from urdfctl.startup.records import NamedTuple

NUMBER, TRUTH, TEXT, MAP = "number", "truth", "text", "map"

_PARAMETER = r"(\*{0,2})([A-Za-z_]\w*)(?::?=((?:\^\|?)?(?:'[^']*'|\"[^\"]*\"|\$\{[^}]*\}|\S*)))?"
_EXPRESSION = r"\$\{([^{}]*)\}"
_WORD = r"[A-Za-z_]\w*"
_OF_NUMBERS = frozenset("pi e tau abs acos asin atan atan2 ceil cos degrees exp floor hypot int float len log max min "
                        "pow radians round sin sqrt tan math if else and or not in".split())  # fmt: skip
_COMPARES = r"[\[=<>(]|\b(?:in|not|and|or)\b"
"""What an expression with texts has if its value may be something else than a text."""
_DEPTH = 8


class Defined(NamedTuple):
    """A property, an argument, a macro or one of its parameters.

    value: the text of its value or default; None if it has none.
    macro: the macro that it is defined in, or whose parameter it is; empty at the level of files.
    file: where. start: the byte offset of the element that defines it.
    is_block: whether it is a parameter that takes elements.
    """

    kind: str
    name: str
    value: str | None
    macro: str
    file: str
    start: int
    is_block: bool = False


class Scopes:
    """The definitions in some xacro files."""

    def __init__(self, sources: Iterable[SourceText]) -> None:
        self.all: list[Defined] = []
        self._passed: dict[tuple[str, str], list[str]] = {}
        for source in sources:
            with suppress(ReadError):
                root = parse(source, late_declaration=True).documentElement
                self._read(root, "") if root is not None else None

    def of(self, kind: str) -> Iterator[Defined]:
        """Yield the definitions of a kind."""
        return (one for one in self.all if one.kind == kind)

    def parameters(self, macro: str) -> dict[str, Defined]:
        """Return the parameters of a macro by name."""
        return {one.name: one for one in self.of(PARAMETER) if one.macro == macro}

    def visible(self, file: str, start: int, macro: str) -> Iterator[Defined]:
        """Yield what an expression can use in the element at an offset, inside of a macro or of none."""
        for one in self.all:
            is_parameter = one.kind == PARAMETER and one.macro == macro and not one.is_block
            is_earlier = bool(macro) or one.file != file or one.start < start
            if is_parameter or (one.kind == PROPERTY and one.macro in {"", macro} and is_earlier):
                yield one

    def given(self, one: Defined) -> list[str]:
        """Return the texts that calls pass to a macro parameter, and the value or default that is written."""
        passed = self._passed.get((one.macro, one.name), []) if one.kind == PARAMETER else []
        return [*([one.value] if one.value is not None else []), *passed]

    def nature(self, one: Defined, depth: int = 0) -> str | None:
        """Return whether a definition is a number, a truth value, a text or a map; None if that is not known."""
        if depth > _DEPTH:
            return None
        found = {self.nature_of(value, one.macro, depth) for value in self.given(one)} - {None}
        return next(iter(found)) if len(found) == 1 else None

    def nature_of(self, text: str, macro: str = "", depth: int = 0) -> str | None:
        """Return what the value of a text is, as written in a macro or outside."""
        plain = text.strip().strip("'\"").removeprefix("^|")
        if plain.lower() in {"true", "false"}:
            return TRUTH
        with suppress(ValueError):
            float(plain)
            return NUMBER
        whole = re.fullmatch(_EXPRESSION, plain)
        argument = re.fullmatch(r"\$\(arg\s+([\w.-]+)\)", plain)
        if argument:
            return self._common(ARGUMENT, argument[1], macro, depth)
        if not whole:
            return TEXT if "$" not in plain or re.sub(_EXPRESSION, "", plain).strip() else None
        words = set(re.findall(rf"(?<![\w.'\"]){_WORD}", re.sub(r"'[^']*'|\"[^\"]*\"", "''", whole[1])))
        if re.search(r"\bload_yaml\(|\bdict\(", whole[1]):
            return None if whole[1].rstrip().endswith("]") else MAP
        if "'" in whole[1] or '"' in whole[1]:
            return TEXT if not re.search(_COMPARES, whole[1]) else None
        if "[" in whole[1] or depth > _DEPTH:
            return None
        natures = {self._common(PROPERTY, word, macro, depth + 1) for word in words - _OF_NUMBERS}
        natures |= {NUMBER} if not words - _OF_NUMBERS else set()
        return next(iter(natures)) if len(natures) == 1 else None

    def is_positive(self, one: Defined) -> bool:
        """Return whether a number may be greater than 0: neither its value nor what calls pass is another one."""
        return not any(re.fullmatch(r"\s*(?:-.*|0*\.?0*)\s*", value) for value in self.given(one) if value)

    def _common(self, kind: str, name: str, macro: str, depth: int) -> str | None:
        kinds = {kind, PARAMETER} if kind == PROPERTY else {kind}
        named = [one for one in self.all if one.name == name and one.kind in kinds]
        natures = {self.nature(one, depth + 1) for one in named if one.kind != PARAMETER or one.macro == macro} - {None}
        return next(iter(natures)) if len(natures) == 1 else None

    def _read(self, element: Element, macro: str) -> None:
        tag, attrs = element.tagName, element.attrs
        define = partial(Defined, file=element.source.path, start=element.start)
        name = attrs.get("name", "")
        if tag == "xacro:macro":
            macro = name.removeprefix("xacro:")
            self.all.append(define(MACRO, macro, None, ""))
            for parameter, value, is_block in parameters_of(attrs.get("params", "")):
                self.all.append(define(PARAMETER, parameter, value, macro, is_block=is_block))
        elif tag == "xacro:property":
            self.all.append(define(PROPERTY, name, attrs.get("value"), macro))
        elif tag == "xacro:arg" or (tag == "arg" and is_launch(element.source.path)):
            self.all.append(define(ARGUMENT, name, attrs.get("default", attrs.get("value")), macro))
        else:
            for given, value in attrs.items():
                self._passed.setdefault((tag.removeprefix("xacro:"), given), []).append(value)
        for inner in element.elements():
            self._read(inner, macro)


def macro_around(data: bytes, offset: int) -> str:
    """Return the macro that a byte offset of a text is in; empty if it is in none. The text may be unfinished."""
    text = re.sub(rb"<!--.*?-->", lambda one: b" " * len(one[0]), data[:offset], flags=re.DOTALL)
    opened = text.rfind(b"<xacro:macro")
    if opened < 0 or text.rfind(b"</xacro:macro>") > opened:
        return ""
    named = re.match(rb"<xacro:macro[^<>]*?\sname\s*=\s*[\"']([^\"']*)", text[opened:])
    return named[1].decode("utf-8", "replace").removeprefix("xacro:") if named else ""


def parameters_of(params: str) -> Iterator[tuple[str, str | None, bool]]:
    """Yield the parameters of a macro: name, default (None if it must be given), and whether it takes elements."""
    for stars, name, value in re.findall(_PARAMETER, params):
        has_default = re.search(rf"(?:^|\s)\*{{0,2}}{name}:?=", params) is not None
        yield name, (value if has_default else None), bool(stars)


def written_default(value: str) -> str:
    """Return a macro parameter's default as a call writes it; empty if it is what the caller has by that name."""
    text = value.removeprefix("^|").removeprefix("^")
    return text[1:-1] if len(text) > 1 and text[0] == text[-1] and text[0] in "'\"" else text


def is_number_at(tag: str, attribute: str) -> bool:
    """Return whether an attribute of URDF is read as a number, or as several."""
    return attribute in _NUMBERS.get(tag, ())


def is_positive_at(tag: str, attribute: str) -> bool:
    """Return whether an attribute of URDF must be greater than 0."""
    return attribute in {"radius", "length", "size", "ixx", "iyy", "izz"} or (tag, attribute) == ("mass", "value")


_NUMBERS: Mapping[str, frozenset[str]] = {
    tag: frozenset(names.split())
    for tag, names in {
        "origin": "xyz rpy", "axis": "xyz", "mass": "value", "inertia": "ixx ixy ixz iyy iyz izz", "box": "size",
        "cylinder": "radius length", "sphere": "radius", "capsule": "radius length", "mesh": "scale", "color": "rgba",
        "limit": "lower upper effort velocity acceleration jerk", "dynamics": "damping friction",
        "mimic": "multiplier offset", "calibration": "rising falling",
        "safety_controller": "soft_lower_limit soft_upper_limit k_position k_velocity",
    }.items()
}  # fmt: skip
