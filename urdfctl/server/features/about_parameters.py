"""What is known about a controller's parameter: its meaning, type, unit, default, limits, and advice."""

from __future__ import annotations

import re

from urdfctl.catalog.entries import ParameterEntry
from urdfctl.catalog.validators import requirement
from urdfctl.generate.controllers.recipes import recipes
from urdfctl.rules.prose import as_markdown

_UNITS = {
    r"(?:^|[._])timeout$|(?:^|[._])timeout_s$|goal_time$|time_from_start_tolerance$": "s",
    r"(?:^|[._])rate$": "Hz",
    r"linear\..*velocity(?:_reverse)?$": "m/s",
    r"linear\..*(?:acceleration|deceleration)(?:_reverse)?$": "m/s²",
    r"linear\..*jerk$": "m/s³",
    r"angular\..*velocity(?:_reverse)?$": "rad/s",
    r"angular\..*(?:acceleration|deceleration)(?:_reverse)?$": "rad/s²",
    r"angular\..*jerk$": "rad/s³",
    r"wheel_separation$|wheels?_radius$|^wheelbase$|_track(?:_width)?$": "m",
    r"^constraints\.(?:<joints>\.)?(?:goal|trajectory)$|^goal_tolerance$": "rad, or m for a prismatic joint",
    r"stopped_velocity_tolerance$|stall_velocity_threshold$": "rad/s, or m/s for a prismatic joint",
    r"^max_effort$": "N m, or N for a prismatic joint",
}
"""Units of numbers by name, as the documentation of ros_controllers and ros2_controllers has them."""
_NUMBERS = frozenset({"double", "int"})


def meaning(kind: str, name: str) -> list[str]:
    """Return what a parameter of a controller type means, in words; nothing if the recipes do not say."""
    known = recipes()
    own = known["parameters"].get(kind) or {}
    for table in (own, *(known["groups"][group] for group in own.get("also", ()))):
        pair = table.get(name)
        if isinstance(pair, list):
            words = [part.strip() for part in str(pair[1]).split(",") if "$" not in part]
            return [", ".join(words)] if any(words) else []
    return []


def unit(parameter: ParameterEntry) -> list[str]:
    """Return the unit of a number; nothing if it is not known, or if it has none."""
    if not _NUMBERS & set(parameter.types):
        return []
    return [name for pattern, name in _UNITS.items() if re.search(pattern, parameter.name)][:1]


def described_parameter(parameter: ParameterEntry, name: str, owner: str) -> str:
    """Return what the catalogue knows about a parameter, as Markdown."""
    lines = [f"**parameter** `{name}` of {owner}", f"type: `{parameter.type}`"]
    lines[1:1] = meaning(owner.partition(" ")[0], parameter.name)
    lines += [f"unit: {name}" for name in unit(parameter)]
    if parameter.required:
        lines.append("required")
    elif parameter.default is not None:
        lines.append(f"default: `{parameter.default}`")
    lines += [requirement(check, limit) for check, limit in parameter.validators.items()]
    if parameter.deprecated:
        lines.append("deprecated" + (f"; use `{parameter.replacement}`" if parameter.replacement else ""))
    if parameter.ignored:
        lines.append("documented, but never read")
    if parameter.note:
        lines.append(parameter.note)
    return as_markdown("  \n".join(lines))
