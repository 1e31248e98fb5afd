"""Convert the catalogue's plain entries to typed entries for one distro."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from typing import Any, TypeVar

from urdfctl.catalog.distros import generation, spanned
from urdfctl.catalog.entries import (
    NOTHING,
    ClaimRule,
    ClaimRules,
    ControllerType,
    ExportRules,
    FormerParameter,
    ParameterCondition,
    ParameterEntry,
    ParameterRule,
    Replacement,
)

Typed = TypeVar("Typed")

Plain = Mapping[str, Any]
_JOINED = ("parameters", "removed_parameters")
_RULE_KEYS = ("id", "kind", "param", "params", "severity", "when", "when_any", "distros")


def distros_of(entry: Plain, ros: int) -> tuple[str, ...]:
    """Return the distros of generation `ros` that an entry is for; all of them if it does not say."""
    return spanned(entry.get("distros", ".."), ros)


def in_distro(entry: Plain, distro: str) -> Plain | None:
    """Return an entry with the overrides for one distro applied; None if the entry is not for the distro."""
    ros = generation(distro)
    if "distros" in entry and distro not in distros_of(entry, ros):
        return None
    if "overrides" not in entry:
        return entry
    own = dict(entry)
    for span, changes in own.pop("overrides").items():
        if distro in spanned(span, ros):
            claims = {**own.get("claims", NOTHING), **changes.get("claims", NOTHING)}
            own |= changes
            if "claims" in changes:
                own["claims"] = claims
    return own


def extension(base: Plain, entry: Plain) -> dict[str, Any]:
    """Return an entry merged with the entry `base` that it extends.

    Its parameters replace those of the base with the same name. Its claims, exports and rules are added to those of the
    base.
    """
    own = {**base, **entry}
    own.pop("base", None)
    own.pop("same_as", None)
    for key in _JOINED:
        own[key] = {**base.get(key, {}), **entry.get(key, {})}
    for key in ("claims", "exports"):
        first, second = base.get(key), entry.get(key, {})
        if first is not None:
            own[key] = {part: [*first.get(part, []), *second.get(part, [])] for part in {**first, **second}}
    own["rules"] = [*base.get("rules", []), *entry.get("rules", [])]
    return own


def package_of(entry: Plain) -> str:
    """Return the package of a controller's entry."""
    package: str = entry.get("package", entry["type"].partition("/")[0])
    return package


def is_external(entry: Plain) -> bool:
    """Return whether a controller's entry is for a type that does not come with ros_control or ros2_control."""
    return "origin" in entry


def controller_type(entry: Plain, distro: str) -> ControllerType | None:
    """Return the controller type of an entry for one distro; None if the entry is not for the distro."""
    own = in_distro(entry, distro)
    if own is None:
        return None
    ros = generation(distro)
    parameters = read_parameters(own.get("parameters", NOTHING), distro)
    claims, exports = own.get("claims"), own.get("exports", NOTHING)
    return ControllerType(
        type=own["type"],
        distro=distro,
        package=package_of(own),
        parameters=parameters,
        former=_former(own, distro, parameters),
        claims=ClaimRules(*_claim_rules(claims, ("command", "state"), distro)) if claims is not None else None,
        exports=ExportRules(*_claim_rules(exports, ("reference", "state"), distro)),
        rules=tuple(_parameter_rule(rule) for rule in own.get("rules", ()) if distro in distros_of(rule, ros)),
        chainable=_flag(own.get("chainable", False), distro),
        broadcaster=own.get("kind") == "broadcaster",
        deprecated=_flag(own.get("deprecated", False), distro),
        replacement=replacement_of(own),
        external=is_external(own),
        since=own.get("since", NOTHING).get(distro),
        hardware_interfaces=tuple(own.get("hardware_interfaces", ())),
        joint_parameters=tuple(own.get("joint_parameters", ())),
        ignored=tuple(own.get("ignored_parameters", ())),
        needs_robot_description=own.get("needs_robot_description", False),
        joints_must_be_in_urdf=own.get("joints_must_be_in_urdf", False),
        publishes_joint_states=own.get("publishes_joint_states", False),
        open=own.get("open", False),
        needs_interface=own.get("needs_interface"),
    )


def read_parameters(plain: Mapping[str, Plain], distro: str) -> dict[str, ParameterEntry]:
    """Return the parameters that a distro reads, by name."""
    return _by_name(plain, distro, _parameter)


def replacement_of(entry: Plain) -> Replacement | None:
    """Return the replacement that an entry names, if any."""
    plain = entry.get("replacement")
    return Replacement(plain["type"], plain.get("parameters", NOTHING), plain.get("note")) if plain else None


def _by_name(plain: Mapping[str, Plain], distro: str, convert: Callable[[str, Plain, str], Typed]) -> dict[str, Typed]:
    entries = ((name, in_distro(entry, distro)) for name, entry in plain.items())
    return {name: convert(name, own, distro) for name, own in entries if own is not None}


def _parameter(name: str, own: Plain, distro: str) -> ParameterEntry:
    return ParameterEntry(
        name=name,
        type=own["type"],
        required=own.get("required", False),
        default=own.get("default"),
        validators=own.get("validators", NOTHING),
        useful=own.get("useful", NOTHING),
        floats_only=own.get("floats_only", False),
        lenient=own.get("lenient", False),
        if_absent=own.get("if_absent"),
        deprecated=_flag(own.get("deprecated", False), distro),
        replacement=own.get("replacement"),
        note=own.get("note"),
        since=own.get("since", NOTHING).get(distro),
        ignored=_flag(own.get("ignored", False), distro),
    )


def _former(own: Plain, distro: str, parameters: Mapping[str, ParameterEntry]) -> dict[str, FormerParameter]:
    """Parameters that only other distros, or only earlier releases of this distro, read."""
    ros = generation(distro)
    former = {}
    for name, plain in own.get("parameters", NOTHING).items():
        if name not in parameters:
            former[name] = FormerParameter(
                name, distros_of(plain, ros), None, plain.get("replacement"), plain.get("note")
            )
    for name, plain in own.get("removed_parameters", NOTHING).items():
        if name not in parameters:
            distros = former[name].distros if name in former else ()
            last = plain.get("last_version", NOTHING).get(distro)
            former[name] = FormerParameter(name, distros, last, plain.get("replacement"), plain.get("note"))
    return former


def _claim_rules(plain: Plain, parts: tuple[str, str], distro: str) -> list[tuple[ClaimRule, ...]]:
    ros = generation(distro)
    return [
        tuple(_claim_rule(rule) for rule in plain.get(part, ()) if distro in distros_of(rule, ros)) for part in parts
    ]


def _claim_rule(plain: Plain) -> ClaimRule:
    own = {key: value for key, value in plain.items() if key != "distros"}
    for key in ("components", "names", "interfaces"):
        own[key] = tuple(own.get(key, ()))
    if "interface" in own:
        own["interfaces"] = (own.pop("interface"),)
    for key in ("when", "when_any"):
        own[key] = _conditions(own.get(key, ()))
    return ClaimRule(**own)


def _conditions(plain: Any) -> tuple[ParameterCondition, ...]:
    return tuple(
        ParameterCondition(condition["param"], condition.get("is_set"), condition.get("is")) for condition in plain
    )


def _parameter_rule(plain: Plain) -> ParameterRule:
    params = tuple(plain["params"]) if "params" in plain else (plain["param"],) if "param" in plain else ()
    return ParameterRule(
        id=plain["id"],
        kind=plain["kind"],
        params=params,
        severity=plain.get("severity", "error"),
        when=_conditions(plain.get("when", ())),
        when_any=_conditions(plain.get("when_any", ())),
        details={key: value for key, value in plain.items() if key not in _RULE_KEYS},
    )


def _flag(flag: bool | str, distro: str) -> bool:  # noqa: FBT001 (as written in the entry)
    """The value of a flag for a distro: the flag is for all distros, or a span of distros for which it is true."""
    return flag if isinstance(flag, bool) else distro in spanned(flag, generation(distro))
