"""Numbers and vectors in joints and links: where urdfdom reads them, and which texts each version accepts."""

from __future__ import annotations

import re
from collections.abc import Iterator

from urdfctl.catalog.distros import ALL, until
from urdfctl.model.robot import Joint, Link, Robot, Tag
from urdfctl.rules.common import is_known, is_xacro
from urdfctl.startup.records import NamedTuple

LEXICAL_CAST = until("lunar")
"""Distros whose urdfdom (up to 0.4) uses boost::lexical_cast: it rejects leading blanks, and accepts inf and nan."""
STREAM = tuple(distro for distro in ALL if distro not in LEXICAL_CAST)
"""Distros whose urdfdom (1.0 and later) reads a stream: it accepts leading blanks, and rejects inf and nan."""

VECTOR = 3
SMALLEST_NORMAL = 2.2250738585072014e-308
_DECIMAL = re.compile(r"[+-]?(?:[0-9]+\.?[0-9]*|\.[0-9]+)(?:[eE][+-]?[0-9]+)?")
_PLAIN_TEXT = r"[+-]?[0-9]{1,40}(?:\.[0-9]{0,40})?(?:[eE][+-]?[0-9]{1,2})?"
_PLAIN = re.compile(_PLAIN_TEXT)
_PLAIN_VECTOR = re.compile(f"{_PLAIN_TEXT}(?: {_PLAIN_TEXT}){{2}}")
_BROKEN_ATTRIBUTE = rb"""=\s*(?:"[^"<>]*[\t\n\r]|'[^'<>]*[\t\n\r])"""
_NOT_FINITE = r"(?i)[+-]?(?:inf(?:inity)?|nan)"
_BLANKS = " \t\n\v\f\r"

JOINT_NUMBERS = {
    "limit": ("lower", "upper", "effort", "velocity"),
    "safety_controller": ("k_velocity", "k_position", "soft_lower_limit", "soft_upper_limit"),
    "calibration": ("rising", "falling"),
    "mimic": ("multiplier", "offset"),
    "dynamics": ("damping", "friction"),
}
MOMENTS = ("ixx", "ixy", "ixz", "iyy", "iyz", "izz")
SHAPE_NUMBERS = {"cylinder": ("length", "radius"), "sphere": ("radius",)}
SHAPE_VECTORS = {"box": "size", "mesh": "scale"}


class Field(NamedTuple):
    """An attribute that urdfdom reads as one or more numbers."""

    element: Tag
    """The element with the attribute."""
    attribute: str
    """The attribute's name."""
    text: str
    """The attribute's text, as urdfdom's XML reader returns it."""
    size: int
    """How many numbers are expected."""

    @property
    def label(self) -> str:
        """Return the attribute as messages name it: `'xyz' of <origin>`."""
        return f"'{self.attribute}' of <{self.element.name}>"

    @property
    def shown(self) -> str:
        """Return the text for messages, on one line."""
        return self.text.replace("\r", "").replace("\n", "\\n").replace("\t", "\\t")

    @property
    def values(self) -> list[float]:
        """Return the numbers in the text; an empty list unless it is exactly `size` finite numbers."""
        pieces = self.text.split()
        if len(pieces) != self.size or not all(_DECIMAL.fullmatch(piece) for piece in pieces):
            return []
        return [float(piece) for piece in pieces]


def refusing(field: Field) -> tuple[str, ...]:
    """Return the distros whose urdfdom rejects the attribute."""
    if field.size == 1:
        return _refusing_number(field.text)
    # vectors are split at spaces only, so tabs and line breaks stay in the pieces
    pieces = [piece for piece in field.text.split(" ") if piece]
    if len(pieces) != field.size:
        return ALL
    refused = {distro for piece in pieces for distro in _refusing_number(piece)}
    return tuple(distro for distro in ALL if distro in refused)


def _refusing_number(text: str) -> tuple[str, ...]:
    if _DECIMAL.fullmatch(text):
        return () if abs(float(text)) != float("inf") else ALL
    if _DECIMAL.fullmatch(text.lstrip(_BLANKS)):
        return LEXICAL_CAST
    return STREAM if re.fullmatch(_NOT_FINITE, text) else ALL


def fault_of(field: Field) -> str:
    """Return why an attribute is rejected or what to change, as it follows a colon in a message."""
    return _fault_of_number(field.text) if field.size == 1 else _fault_of_vector(field)


def _fault_of_vector(field: Field) -> str:
    pieces = field.text.split()
    wrong = [piece for piece in pieces if not _DECIMAL.fullmatch(piece)]
    if "," in field.text:
        return f"separate the {field.size} numbers with spaces, not commas"
    if len(pieces) != field.size:
        return f"expected {field.size} numbers, found {len(pieces)}"
    if wrong:
        return f"'{wrong[0]}' is not a number"
    return "separate the numbers with spaces, not tabs or line breaks"


def _fault_of_number(text: str) -> str:
    if "${" in text or "$(" in text:
        return "a xacro expression is not expanded in a plain URDF"
    if not text.strip():
        return "expected a number"
    if _DECIMAL.fullmatch(text):
        return "the number is too large"
    if _DECIMAL.fullmatch(text.strip()):
        return "remove the space or line break around the number"
    if _DECIMAL.fullmatch(text.replace(",", ".", 1)):
        return "use a decimal point, not a comma"
    if re.fullmatch(_NOT_FINITE, text.strip()):
        return "expected a finite number"
    return "expected a plain decimal number, without a unit or name"


def corrected(field: Field) -> tuple[str, bool] | None:
    """Return the corrected text, and True if it is certain; None if the text cannot be corrected."""
    pieces = field.text.split()
    if len(pieces) == field.size and all(_DECIMAL.fullmatch(piece) for piece in pieces):
        return (" ".join(pieces), True) if " ".join(pieces) != field.text else None
    pieces = field.text.replace(",", " " if field.size > 1 else ".").split()
    if len(pieces) == field.size and all(_DECIMAL.fullmatch(piece) for piece in pieces):
        return " ".join(pieces), False
    return None


def is_subnormal(field: Field) -> bool:
    """Return whether a number is below 2.2e-308, which urdfdom accepts and sdformat rejects."""
    return any(0 < abs(value) < SMALLEST_NORMAL for value in field.values)


class Numbers:
    """Finds the attributes of one robot that are read as numbers but do not look like plain ones.

    A quick pattern skips most attributes.
    """

    def __init__(self, robot: Robot) -> None:
        self._raw = not is_xacro(robot) and bool(re.search(_BROKEN_ATTRIBUTE, robot.at.source.data))

    def of_joint(self, joint: Joint) -> Iterator[Field]:
        """Yield those of a joint. urdfdom rejects the whole robot if it cannot read one."""
        for element in _first_of_each(joint.tag):
            if element.name == "origin":
                yield from self._pose(element)
            elif element.name == "axis" and joint.type not in ("fixed", "floating"):
                yield from self._of(element, ("xyz",), VECTOR)
            elif element.name in JOINT_NUMBERS:
                yield from self._of(element, JOINT_NUMBERS[element.name], 1)

    def of_link(self, link: Link) -> Iterator[tuple[Field, str]]:
        """Yield those of a link, each with the name of the part that urdfdom drops if it cannot read it."""
        inertial = next(link.tag.named("inertial"), None)
        if inertial is not None:
            for element in _first_of_each(inertial):
                names = {"mass": ("value",), "inertia": MOMENTS}.get(element.name, ())
                yield from ((field, "inertial") for field in self._of(element, names, 1))
                if element.name == "origin":
                    yield from ((field, "inertial") for field in self._pose(element))
        for part in link.tag.children:
            if part.name in ("visual", "collision"):
                yield from ((field, part.name) for field in self._of_shape(part))

    def _of_shape(self, part: Tag) -> Iterator[Field]:
        for element in _first_of_each(part):
            if element.name == "origin":
                yield from self._pose(element)
            elif element.name == "geometry" and element.children:
                shape = element.children[0]
                yield from self._of(shape, SHAPE_NUMBERS.get(shape.name, ()), 1)
                if shape.name in SHAPE_VECTORS:
                    yield from self._of(shape, (SHAPE_VECTORS[shape.name],), VECTOR)

    def _pose(self, origin: Tag) -> Iterator[Field]:
        return self._of(origin, ("xyz", "rpy"), VECTOR)

    def _of(self, element: Tag, names: tuple[str, ...], count: int) -> Iterator[Field]:
        plain = _PLAIN if count == 1 else _PLAIN_VECTOR
        for name in names:
            text = element.attributes.get(name)
            if text is None or (plain.fullmatch(text) and not self._raw):
                continue
            text = self._as_read(element, name, text)
            if is_known(text) and not plain.fullmatch(text):
                yield Field(element, name, text, count)

    def _as_read(self, element: Tag, name: str, text: str) -> str:
        """The text with its tabs and line breaks: xacro's XML reader turns them into spaces, urdfdom's does not."""
        if not self._raw or " " not in text:
            return text
        raw = element.at[name].span.text.replace("\r\n", "\n")
        same = len(raw) == len(text) and re.sub("[\t\n\r]", " ", raw) == text
        return raw if same else text


def _first_of_each(tag: Tag) -> Iterator[Tag]:
    """The first child of each name: urdfdom ignores the others."""
    seen = set()
    for child in tag.children:
        if child.name not in seen:
            seen.add(child.name)
            yield child
