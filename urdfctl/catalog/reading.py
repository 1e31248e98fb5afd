"""Makes typed entries, as one distro has them, of the catalogue's plain ones."""

from __future__ import annotations

from collections.abc import Callable, Mapping

from urdfctl.catalog.distros import generation, spanned
from urdfctl.catalog.entries import (
    NOTHING,
    ClaimRule,
    ClaimRules,
    Condition,
    ControllerType,
    ExportRules,
    FormerParameter,
    Parameter,
    ParameterRule,
    Replacement,
)
from urdfctl.hints import TYPE_CHECKING, Any

if TYPE_CHECKING:
    from typing import TypeVar

    Made = TypeVar("Made")

Plain = Mapping[str, Any]
_JOINED = ("parameters", "removed_parameters")
_RULE_KEYS = ("id", "kind", "param", "params", "severity", "when", "when_any", "distros")


def distros_of(entry: Plain, ros: int) -> tuple[str, ...]:
    """The distros that have what an entry tells of; all of its generation where it says nothing."""
    return spanned(entry.get("distros", ".."), ros)


def in_distro(entry: Plain, distro: str) -> Plain | None:
    """An entry as one distro has it, its overrides applied; None where the distro has it not."""
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
    """An entry that extends another: its parameters go over the other's, its claims, exports and rules come on top."""
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


def controller_type(entry: Plain, distro: str) -> ControllerType | None:
    """A type of controller as one distro has it, None where it has it not."""
    own = in_distro(entry, distro)
    if own is None:
        return None
    ros = generation(distro)
    parameters = read_parameters(own.get("parameters", NOTHING), distro)
    claims, exports = own.get("claims"), own.get("exports", NOTHING)
    return ControllerType(
        own["type"],
        distro,
        own.get("package", own["type"].partition("/")[0]),
        parameters,
        _former(own, distro, parameters),
        ClaimRules(*_claim_rules(claims, ("command", "state"), distro)) if claims is not None else None,
        ExportRules(*_claim_rules(exports, ("reference", "state"), distro)),
        tuple(_parameter_rule(rule) for rule in own.get("rules", ()) if distro in distros_of(rule, ros)),
        _flag(own.get("chainable", False), distro),
        own.get("kind") == "broadcaster",
        _flag(own.get("deprecated", False), distro),
        replacement_of(own),
        "origin" in own,
        own.get("since", NOTHING).get(distro),
        tuple(own.get("hardware_interfaces", ())),
        tuple(own.get("joint_parameters", ())),
        tuple(own.get("ignored_parameters", ())),
        own.get("needs_robot_description", False),
        own.get("joints_must_be_in_urdf", False),
        own.get("publishes_joint_states", False),
    )


def read_parameters(plain: Mapping[str, Plain], distro: str) -> dict[str, Parameter]:
    """The parameters that a distro reads, by name."""
    return _by_name(plain, distro, _parameter)


def replacement_of(entry: Plain) -> Replacement | None:
    """What an entry says takes its place."""
    plain = entry.get("replacement")
    return Replacement(plain["type"], plain.get("parameters", NOTHING), plain.get("note")) if plain else None


def _by_name(plain: Mapping[str, Plain], distro: str, made: Callable[[str, Plain, str], Made]) -> dict[str, Made]:
    found = ((name, in_distro(entry, distro)) for name, entry in plain.items())
    return {name: made(name, own, distro) for name, own in found if own is not None}


def _parameter(name: str, own: Plain, distro: str) -> Parameter:
    return Parameter(
        name,
        own["type"],
        own.get("required", False),
        own.get("default"),
        own.get("validators", NOTHING),
        own.get("useful", NOTHING),
        own.get("floats_only", False),
        own.get("if_absent"),
        _flag(own.get("deprecated", False), distro),
        own.get("replacement"),
        own.get("note"),
        own.get("since", NOTHING).get(distro),
        _flag(own.get("ignored", False), distro),
    )


def _former(own: Plain, distro: str, parameters: Mapping[str, Parameter]) -> dict[str, FormerParameter]:
    """Parameters that only other distros read, and those that only earlier releases of this one read."""
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


def _conditions(plain: Any) -> tuple[Condition, ...]:
    return tuple(Condition(one["param"], one.get("is_set"), one.get("is")) for one in plain)


def _parameter_rule(plain: Plain) -> ParameterRule:
    params = tuple(plain["params"]) if "params" in plain else (plain["param"],) if "param" in plain else ()
    return ParameterRule(
        plain["id"],
        plain["kind"],
        params,
        plain.get("severity", "error"),
        _conditions(plain.get("when", ())),
        _conditions(plain.get("when_any", ())),
        {key: value for key, value in plain.items() if key not in _RULE_KEYS},
    )


def _flag(flag: bool | str, distro: str) -> bool:  # noqa: FBT001 (as it stands in the entry)
    """Whether something holds for a distro: it is said for all, or for the distros of a span."""
    return flag if isinstance(flag, bool) else distro in spanned(flag, generation(distro))
