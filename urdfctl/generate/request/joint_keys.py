"""The columns of a joint list: their names, the other names that people give them, and their values."""

from __future__ import annotations

import re
from collections.abc import Iterator, Mapping
from typing import Any

from urdfctl.errors import UserError
from urdfctl.generate.robot.facts import JointFacts
from urdfctl.names import did_you_mean

NUMBERS = ("lower", "upper", "effort", "velocity", "reduction", "radius", "inertia")
GAINS = ("p", "i", "d", "i_clamp")
TEXTS = ("name", "type", "interface", "controller", "controller_type")
GROUPS = ("gains", "pid", "limits", "limit")
KEYS = (*TEXTS, *NUMBERS, *GAINS, "gains", "limits")
LISTS = ("joints", "joint_names", "controller_joint_names", "joint_limits")
"""The keys under which files keep a list of joints."""
URDF_TYPES = ("revolute", "continuous", "prismatic")
_ALSO = {
    "name": ("joint", "joint_name", "jointname", "joints"),
    "type": ("joint_type",),
    "interface": ("command_interface", "hardware_interface", "mode"),
    "controller": ("controller_name", "group"),
    "lower": ("min", "min_position", "lower_limit", "position_min"),
    "upper": ("max", "max_position", "upper_limit", "position_max"),
    "effort": ("max_effort", "effort_limit", "max_torque", "torque"),
    "velocity": ("max_velocity", "velocity_limit", "max_vel"),
    "reduction": ("mechanical_reduction", "gear_ratio", "ratio"),
    "p": ("kp", "p_gain"),
    "i": ("ki", "i_gain"),
    "d": ("kd", "d_gain"),
    "i_clamp": ("i_max", "i_clamp_max"),
}
_MEANS = {**{key: key for key in (*KEYS, *GROUPS)}, **{also: key for key, names in _ALSO.items() for also in names}}
_UNUSED = re.compile(r"has_\w+_limits|(max|min)_(acceleration|jerk|deceleration)|antiwindup|i_clamp_min|comment|notes?")
"""Keys of other programs that say nothing about what is generated."""
_NUMBER = re.compile(r"[+-]?(\d+\.?\d*|\.\d+)([eE][+-]?\d+)?")


def key_of(text: str) -> str | None:
    """Return the key that a column's title means: without unit, case and prefix, e.g. `Effort [Nm]` or `pid.p`."""
    plain = re.sub(r"\s*[\[(].*?[\])]\s*$", "", text.strip()).lower()
    plain = re.sub(r"[\s-]+", "_", re.sub(r"^(pid|gains|limits?)\.", "", plain))
    return _MEANS.get(plain)


def is_name_key(text: str) -> bool:
    """Return whether a column's title means the names of the joints."""
    return key_of(text) == "name"


def joint_of(plain: Mapping[Any, object], source: str) -> JointFacts:
    """Return the joint of a row or an entry. UserError, starting with `source`, if a key or value is wrong."""
    flat = dict(_flat(plain, source))
    if "name" not in flat:
        raise UserError(f"{source}: a joint without a name")
    numbers: dict[str, Any] = {
        key: _number(key, flat[key], source) for key in (*NUMBERS, *GAINS) if flat.get(key) is not None
    }
    gains = tuple((key, numbers.pop(key)) for key in GAINS if key in numbers)
    texts: dict[str, Any] = {key: str(flat[key]) for key in TEXTS[1:] if flat.get(key) is not None}
    kind = texts.get("type")
    if kind and kind not in URDF_TYPES:  # the type of its controller
        texts["controller_type"] = texts.get("controller_type", texts.pop("type"))
    return JointFacts(name_of(flat["name"], source))._replace(**numbers, **texts, gains=gains)


def _flat(plain: Mapping[Any, object], source: str) -> Iterator[tuple[str, object]]:
    for text, value in plain.items():
        key = key_of(str(text))
        if key is None and not _UNUSED.fullmatch(str(text).lower()):
            known = did_you_mean(str(text), KEYS)
            raise UserError(f"{source}: unknown key '{text}'{known}; known: {', '.join(KEYS)}")
        if key in GROUPS and isinstance(value, Mapping):
            yield from _flat(value, source)
        elif key in ("gains", "pid") and isinstance(value, list):
            yield from zip(GAINS, value, strict=False)
        elif key in GROUPS:
            raise UserError(f"{source}: '{text}' must be a mapping such as {{p: 1.0, d: 0.1}}, not '{value}'")
        elif key:
            yield key, value


def name_of(value: object, source: str) -> str:
    """Return a joint's name. UserError if a value cannot be one."""
    if not isinstance(value, str) or not value:
        raise UserError(f"{source}: '{value}' is not a joint name; quote names that YAML reads as another type")
    if _NUMBER.fullmatch(value) or re.search(r"\s", value):
        hint = "; a list with several columns starts with a header, such as name,effort"
        raise UserError(f"{source}: '{value}' is not a joint name{hint if _NUMBER.fullmatch(value) else ''}")
    return value


def _number(key: str, value: object, source: str) -> float:
    try:
        return float(value)  # type: ignore[arg-type]
    except (TypeError, ValueError):
        raise UserError(f"{source}: '{key}' must be a number, not '{value}'") from None
