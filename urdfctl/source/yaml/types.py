"""The types of YAML scalars, as their readers see them: PyYAML for ROS 1, rcl_yaml_param_parser for ROS 2.

PyYAML follows YAML 1.1, except that a number with an exponent needs both a point and a sign: `1e3` is a string.
rosparam adds `deg(90)` and `rad(pi/2)`. rcl uses strtol and strtod, and has neither null nor dates.
"""

from __future__ import annotations

import math
import re
from functools import lru_cache
from typing import Any

from urdfctl.source.yaml.kinds import ValueKind
from urdfctl.source.yaml.tree import Scalar
from urdfctl.startup.lazy_yaml import yaml
from urdfctl.startup.records import NamedTuple

_SUBSTITUTION = r"\$\(|\$\{|<%|\{\{|<[A-Za-z_][\w.-]*>"
_RCL_TRUE = frozenset("Y y yes Yes YES true True TRUE on On ON".split())
_RCL_FALSE = frozenset("N n no No NO false False FALSE off Off OFF".split())
_C_INT = r"\s*[+-]?(0[xX][0-9a-fA-F]+|0[0-7]*|[1-9]\d*)"
_C_FLOAT = r"\s*[+-]?((\d+\.?\d*|\.\d+)([eE][+-]?\d+)?|(?i:inf(inity)?|nan))"
_C_HEX_FLOAT = r"\s*[+-]?0[xX]([0-9a-fA-F]+\.?[0-9a-fA-F]*|\.[0-9a-fA-F]+)([pP][+-]?\d+)?"
_YAML_FLOAT = r"[+-]?\.(inf|Inf|INF)|\.(nan|NaN|NAN)"
_ANGLE = r"(deg|rad)\([^)]*\)"
_STANDARD = "tag:yaml.org,2002:"
_MOST_DIGITS = 400
_INT64 = range(-(1 << 63), 1 << 63)


class TypedScalar(NamedTuple):
    """The kind and value of a scalar. The value is None if there is none, or if it is unknown."""

    kind: ValueKind
    value: bool | int | float | str | None


def is_literal(text: str) -> bool:
    """Return whether a text has no substitutions: `$(var x)`, `${x}`, `<%= x %>`, `{{ x }}`, or `<x>`,
    which launch files replace."""
    return re.search(_SUBSTITUTION, text) is None


def typed_by_rcl(scalar: Scalar) -> TypedScalar:
    """Return a scalar as get_value of rcl_yaml_param_parser types it.

    It ignores all tags but `!!str`, and rejects an empty plain scalar, which has the kind NULL here.
    """
    text = scalar.text
    if not is_literal(text):
        return TypedScalar(ValueKind.UNKNOWN, None)
    if scalar.style in ("'", '"') or scalar.tag == f"{_STANDARD}str":
        return TypedScalar(ValueKind.STRING, text)
    return _by_rcl(text)


@lru_cache(4096)
def _by_rcl(text: str) -> TypedScalar:
    if text in _RCL_TRUE or text in _RCL_FALSE:
        return TypedScalar(ValueKind.BOOL, text in _RCL_TRUE)
    if not text:
        return TypedScalar(ValueKind.NULL, None)
    integer = _c_integer(text)
    if integer is not None:
        return TypedScalar(ValueKind.INT, integer)
    number = _c_double(text)
    return (
        TypedScalar(ValueKind.STRING, text)
        if number is None
        else TypedScalar(ValueKind.INT if type(number) is int else ValueKind.FLOAT, number)
    )


def _c_integer(text: str) -> int | None:
    """The integer that strtol with base 0 reads from the whole text; None if it fails or exceeds 64 bits."""
    if len(text) > _MOST_DIGITS or not re.fullmatch(_C_INT, text):
        return None
    digits = text.strip().lstrip("+-")
    base = 16 if digits[:2] in ("0x", "0X") else 8 if digits.startswith("0") else 10
    number = int(digits, base) * (-1 if text.strip().startswith("-") else 1)
    return number if number in _INT64 else None


def _c_double(text: str) -> float | None:
    """The number that strtod reads from the whole text; None if it fails or overflows."""
    if re.fullmatch(_YAML_FLOAT, text):
        return float(text.replace(".", ""))
    if len(text) > _MOST_DIGITS:
        return None
    try:
        if re.fullmatch(_C_HEX_FLOAT, text):
            return float.fromhex(text)
        number = float(text) if re.fullmatch(_C_FLOAT, text) else None
    except OverflowError:
        return None
    overflows = number is not None and math.isinf(number) and text.strip("+- \t")[:1] not in "iI"
    return None if overflows else number


def typed_by_pyyaml(scalar: Scalar) -> TypedScalar:
    """Return a scalar as PyYAML's safe loader types it, with rosparam's angles (in rad)."""
    if not is_literal(scalar.text):
        return TypedScalar(ValueKind.UNKNOWN, None)
    tag = scalar.tag
    if tag is None and scalar.style:
        return TypedScalar(ValueKind.STRING, scalar.text)
    if tag in ("!", f"{_STANDARD}str"):
        return TypedScalar(ValueKind.STRING, scalar.text)
    return _by_pyyaml(scalar.text, tag)


@lru_cache(4096)
def _by_pyyaml(text: str, tag: str | None) -> TypedScalar:
    if tag is None and re.fullmatch(_ANGLE, text):
        tag = "!degrees" if text.startswith("deg") else "!radians"
    if tag in ("!degrees", "!radians"):
        return TypedScalar(ValueKind.FLOAT, _angle(text, degrees=tag == "!degrees"))
    tag = tag or _resolver().resolve(yaml.ScalarNode, text, (True, False))
    name = tag.removeprefix(_STANDARD)
    if name not in _PYYAML_KINDS:
        return TypedScalar(ValueKind.OTHER, None)
    kind = _PYYAML_KINDS[name]
    if kind in (ValueKind.STRING, ValueKind.NULL):
        return TypedScalar(kind, text if kind is ValueKind.STRING else None)
    try:
        return TypedScalar(kind, getattr(_constructor(), f"construct_yaml_{name}")(yaml.ScalarNode(tag, text)))
    except (ValueError, KeyError, OverflowError):
        return TypedScalar(ValueKind.OTHER, None)


_PYYAML_KINDS = {
    "null": ValueKind.NULL,
    "bool": ValueKind.BOOL,
    "int": ValueKind.INT,
    "float": ValueKind.FLOAT,
    "str": ValueKind.STRING,
    "value": ValueKind.STRING,
    "binary": ValueKind.STRING,
    "merge": ValueKind.STRING,
}


@lru_cache(1)
def _resolver() -> Any:
    return yaml.resolver.Resolver()


@lru_cache(1)
def _constructor() -> Any:
    return yaml.constructor.SafeConstructor()


def _angle(text: str, *, degrees: bool) -> float | None:
    """An angle in radians, given as a number or a multiple of pi; None for any other expression."""
    inside = text.strip()[4:-1] if text.endswith(")") else text.strip()
    match = re.fullmatch(r"\s*(-?)(?:(\d+\.?\d*|\.\d+)|(pi))\s*(?:([*/])\s*(?:(\d+\.?\d*)|(pi)))?\s*", inside)
    if match is None:
        return None
    sign, number, pi, operator, other, other_pi = match.groups()
    value = math.pi if pi else float(number)
    if operator:
        operand = math.pi if other_pi else float(other)
        if operator == "/" and operand == 0:
            return None
        value = value * operand if operator == "*" else value / operand
    value = -value if sign else value
    return math.radians(value) if degrees else value
