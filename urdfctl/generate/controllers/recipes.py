"""The recipes of recipes.yaml: the controller type of a short name in a distro, and the parameters to write."""

from __future__ import annotations

import os
import re
from collections.abc import Mapping, Sequence
from functools import cache
from typing import Any

from urdfctl.catalog.catalog import Catalog
from urdfctl.catalog.entries import ControllerType
from urdfctl.errors import UserError
from urdfctl.generate.options import GeneratorOptions
from urdfctl.names import did_you_mean
from urdfctl.startup.records import NamedTuple

_FILE = os.path.join(os.path.dirname(__file__), "recipes.yaml")
BROADCASTER = "joint_state_broadcaster"
_MARKS = ("each", "several")


class NamedType(NamedTuple):
    """A short name of `--type`, or a full type name with the short name that means it.

    `label` is the name of its controller, `interface` the default command interface, and `roles` the roles of its
    joints with their numbers. `each`: one controller per joint. `several`: it commands several interfaces. `fit` are
    the interfaces that it can command.
    """

    name: str
    label: str
    interface: str | None = None
    roles: tuple[tuple[str, int], ...] = ()
    each: bool = False
    several: bool = False
    fit: tuple[str, ...] = ()
    short: str = ""


@cache
def recipes() -> dict[str, Any]:
    """Return the content of recipes.yaml, which is read once."""
    import yaml

    with open(_FILE, encoding="utf-8") as file:
        plain: dict[str, Any] = yaml.load(file, getattr(yaml, "CSafeLoader", yaml.SafeLoader))  # noqa: S506 (safe)
    return plain


def kind_of(name: str, catalog: Catalog, options: GeneratorOptions) -> NamedType:
    """Return the kind for a short name or a full type name. UserError if the distro does not have it."""
    plain = recipes()["kinds"].get(name)
    if plain is None:
        return _kind_of_type(name, catalog, options)
    listed = _listed(plain, options)
    label = plain.get(f"ros{options.ros}_name", plain["name"])
    return _kind(name, plain, listed, label, [key for key in listed if key not in _MARKS])._replace(short=name)


def _kind(name: str, plain: Mapping[str, Any], listed: Mapping[str, Any], label: str, fit: Sequence[str]) -> NamedType:
    roles, default = tuple(plain.get("roles", {}).items()), plain.get("interface")
    interface = default if default in fit or "any" in fit else next(iter(fit), None)
    return NamedType(
        name=name,
        label=label,
        interface=default and interface,
        roles=roles,
        each=bool(listed.get("each")),
        several=bool(listed.get("several")),
        fit=(*fit,),
    )


def type_of(kind: NamedType, interfaces: Sequence[str], catalog: Catalog, options: GeneratorOptions) -> ControllerType:
    """Return the controller type of a kind. UserError if the distro has none for the interfaces."""
    plain = recipes()["kinds"].get(kind.name)
    if plain is None:
        return _known(kind.name, catalog, options.distro)
    listed = _listed(plain, options)
    names = listed.get("any") or [name for interface in interfaces for name in listed.get(interface, ())]
    unknown = [interface for interface in interfaces if "any" not in listed and interface not in listed]
    if unknown:
        choices = ", ".join(key for key in listed if key not in _MARKS)
        raise UserError(
            f"no '{kind.name}' controller commands '{unknown[0]}' in {options.distro}; choose from: {choices}"
        )
    entries = [catalog.controller(name, options.distro) for name in names]
    available = [entry for entry in entries if entry]
    if not available:
        where = ", ".join(dict.fromkeys(distro for name in names for distro in catalog.distros_of(name)))
        instead = "; leave out --group: other types command all joints, too" if options.group else ""
        raise UserError(f"{options.distro} has no '{names[0]}'; it exists in {where}{instead}")
    return next((entry for entry in available if not entry.deprecated), available[0])


def only_deprecated(kind: NamedType, interface: str, catalog: Catalog, options: GeneratorOptions) -> bool:
    """Return whether a distro has no types of a kind for an interface but deprecated ones, and others for its own."""
    plain = recipes()["kinds"].get(kind.short)
    listed = _listed(plain, options) if plain else {}
    current = {
        name: any(entry and not entry.deprecated for entry in (catalog.controller(t, options.distro) for t in types))
        for name, types in listed.items()
        if name not in _MARKS
    }
    return not current.get(interface, True) and current.get(kind.interface or "", False)


def recipe_of(controller: ControllerType) -> Mapping[str, Any] | None:
    """Return the recipe of a type: [value, comment] by parameter. None if there is no recipe."""
    own: Mapping[str, Any] | None = recipes()["parameters"].get(controller.type)
    if own is None:
        return None
    recipe = {name: entry for name, entry in own.items() if name != "also"}
    for group in own.get("also", ()):
        recipe.update(recipes()["groups"][group])
    return recipe


def _listed(plain: Mapping[str, Any], options: GeneratorOptions) -> Mapping[str, Any]:
    ros = f"ros{options.ros}"
    listed: Mapping[str, Any] | None = plain.get(f"{ros}_group") if options.group else None
    listed = listed or plain.get(ros)
    if listed is None:
        raise UserError(f"ROS {options.ros} has no controllers of type '{plain['name']}'")
    return listed


def _kind_of_type(name: str, catalog: Catalog, options: GeneratorOptions) -> NamedType:
    kinds: Mapping[str, Any] = recipes()["kinds"]
    if "/" not in name:
        raise UserError(
            f"unknown type '{name}'{did_you_mean(name, kinds)}; use a full type name, or one of {', '.join(kinds)}"
        )
    _known(name, catalog, options.distro)
    uses = [
        (short, plain, listed, [key for key, names in listed.items() if key not in _MARKS and name in names])
        for short, plain in kinds.items()
        for listed in (plain.get(f"ros{options.ros}", {}), plain.get(f"ros{options.ros}_group", {}))
    ]
    of_name = [use for use in uses if use[3]]
    if not of_name:
        return NamedType(name, _snake(name.rpartition("/")[2]), short=name)
    short, plain, listed, _ = of_name[0]
    label = plain["name"] if len(of_name) == 1 else name.partition("/")[0]
    kind = _kind(name, plain, listed, label, [key for *_, fit in of_name for key in fit])
    return kind._replace(short=short if len(of_name) == 1 else name)


def _known(name: str, catalog: Catalog, distro: str) -> ControllerType:
    found = catalog.controller(name, distro)
    if found is None:
        where = catalog.distros_of(name)
        near = did_you_mean(name, catalog.known_types(distro))
        raise UserError(
            f"{distro} has no '{name}'; it exists in {', '.join(where)}" if where else f"unknown type '{name}'{near}"
        )
    if found.deprecated:
        instead = catalog.replacement(name, distro)
        raise UserError(f"'{name}' is deprecated in {distro}" + (f"; use '{instead.type}'" if instead else ""))
    return found


def _snake(name: str) -> str:
    return re.sub(r"(?<=[a-z0-9])(?=[A-Z])|(?<=[A-Z])(?=[A-Z][a-z])", "_", name).lower()
