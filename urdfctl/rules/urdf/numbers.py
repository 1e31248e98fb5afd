"""Which texts urdfdom reads as numbers and vectors, by version, and where in a joint or link it reads them."""

from __future__ import annotations

import re
from collections.abc import Iterator

from urdfctl.catalog.distros import ALL, until
from urdfctl.model.parts import Tag
from urdfctl.model.robot import Joint, Link, Robot
from urdfctl.record import NamedTuple
from urdfctl.rules.common import is_known, is_xacro

LEXICAL_CAST = until("lunar")
"""The distros whose urdfdom (up to 0.4) reads numbers by boost::lexical_cast: no blanks before them, but inf and nan."""
STREAM = tuple(distro for distro in ALL if distro not in LEXICAL_CAST)
"""Those whose urdfdom (from 1.0 on) reads them from a stream: blanks before them, finite ones only."""

VECTOR = 3
SMALLEST_NORMAL = 2.2250738585072014e-308
_DECIMAL = re.compile(r"[+-]?(?:[0-9]+\.?[0-9]*|\.[0-9]+)(?:[eE][+-]?[0-9]+)?")
_PLAIN = re.compile(r"[+-]?[0-9]{1,40}(?:\.[0-9]{0,40})?(?:[eE][+-]?[0-9]{1,2})?")
_PLAIN_VECTOR = re.compile(f"{_PLAIN.pattern} {_PLAIN.pattern} {_PLAIN.pattern}")
_BROKEN_ATTRIBUTE = re.compile(rb"""=\s*(?:"[^"<>]*[\t\n\r]|'[^'<>]*[\t\n\r])""")
_NOT_FINITE = re.compile(r"[+-]?(?:inf(?:inity)?|nan)", re.IGNORECASE)
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
    """An attribute that urdfdom reads as `size` numbers, and its text as urdfdom gets it."""

    element: Tag
    attribute: str
    text: str
    size: int

    @property
    def label(self) -> str:
        """What a message calls it."""
        return f"'{self.attribute}' of <{self.element.name}>"

    @property
    def shown(self) -> str:
        """Its text as a message shows it, on one line."""
        return self.text.replace("\r", "").replace("\n", "\\n").replace("\t", "\\t")

    @property
    def values(self) -> list[float]:
        """Its numbers, where all of its text is so many finite numbers; else none."""
        pieces = self.text.split()
        if len(pieces) != self.size or not all(_DECIMAL.fullmatch(piece) for piece in pieces):
            return []
        return [float(piece) for piece in pieces]


def refusing(field: Field) -> tuple[str, ...]:
    """The distros whose urdfdom does not read an attribute."""
    if field.size == 1:
        return _refusing_number(field.text)
    # vectors are split at blanks only: tabs and line ends stay in the pieces
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
    return STREAM if _NOT_FINITE.fullmatch(text) else ALL


def fault_of(field: Field) -> str:
    """What is wrong with an attribute that is refused, and what would be right."""
    return _fault_of_number(field.text) if field.size == 1 else _fault_of_vector(field)


def _fault_of_vector(field: Field) -> str:
    pieces = field.text.split()
    wrong = [piece for piece in pieces if not _DECIMAL.fullmatch(piece)]
    if "," in field.text:
        return f"has commas; write {field.size} numbers with spaces between them"
    if len(pieces) != field.size:
        return f"has {len(pieces)} numbers; {field.size} are read"
    if wrong:
        return f"holds '{wrong[0]}', which is not a number"
    return "has a tab or line end; spaces stand between the numbers"


def _fault_of_number(text: str) -> str:
    if "${" in text or "$(" in text:
        return "is a xacro expression, and nothing expands it in a plain URDF"
    if not text.strip():
        return "is empty; a number is due"
    if _DECIMAL.fullmatch(text.strip()):
        return "has a space or line end around the number"
    if _DECIMAL.fullmatch(text.replace(",", ".", 1)):
        return "has a comma; the decimal mark is a point"
    if _NOT_FINITE.fullmatch(text.strip()):
        return "is not finite"
    return "is not a number; plain decimals are read, without units or names"


def mended(field: Field) -> tuple[str, bool] | None:
    """The text that was surely meant (True) or most likely so; None where nobody can tell."""
    pieces = field.text.split()
    if len(pieces) == field.size and all(_DECIMAL.fullmatch(piece) for piece in pieces):
        return " ".join(pieces), True
    pieces = field.text.replace(",", " " if field.size > 1 else ".").split()
    if len(pieces) == field.size and all(_DECIMAL.fullmatch(piece) for piece in pieces):
        return " ".join(pieces), False
    return None


def is_subnormal(field: Field) -> bool:
    """Whether a number is so small that sdformat refuses what urdfdom took: below 2.2e-308."""
    return any(0 < abs(value) < SMALLEST_NORMAL for value in field.values)


class Numbers:
    """Gives the attributes of one robot that are read as numbers and are not plainly some: of most nothing can be said,
    and that is quickly seen."""

    def __init__(self, robot: Robot) -> None:
        self._raw = not is_xacro(robot) and bool(_BROKEN_ATTRIBUTE.search(robot.at.source.data))

    def of_joint(self, joint: Joint) -> Iterator[Field]:
        """Those of a joint: urdfdom gives up the whole robot where it cannot read one."""
        for element in _first_of_each(joint.tag):
            if element.name == "origin":
                yield from self._pose(element)
            elif element.name == "axis" and joint.type not in ("fixed", "floating"):
                yield from self._of(element, ("xyz",), VECTOR)
            elif element.name in JOINT_NUMBERS:
                yield from self._of(element, JOINT_NUMBERS[element.name], 1)

    def of_link(self, link: Link) -> Iterator[tuple[Field, str]]:
        """Those of a link's parts, each with the name of the part that urdfdom drops where it cannot read it."""
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
        """The text with its tabs and line ends: XML readers, and so xacro, make blanks of them, urdfdom's does not."""
        if not self._raw or " " not in text:
            return text
        raw = element.at[name].span.text.replace("\r\n", "\n")
        same = len(raw) == len(text) and re.sub("[\t\n\r]", " ", raw) == text
        return raw if same else text


def _first_of_each(tag: Tag) -> Iterator[Tag]:
    """The first child of each name: urdfdom does not look for a second one."""
    seen = set()
    for child in tag.children:
        if child.name not in seen:
            seen.add(child.name)
            yield child
