"""The recipes of recipes.yaml: which type a short name means in a distro, and what is written of its parameters."""

from __future__ import annotations

import os
import re
from collections.abc import Mapping, Sequence
from functools import cache

from urdfctl.catalog.catalog import Catalog
from urdfctl.catalog.entries import ControllerType
from urdfctl.errors import UserError
from urdfctl.generate.options import Options
from urdfctl.hints import Any
from urdfctl.record import NamedTuple
from urdfctl.suggest import did_you_mean

_FILE = os.path.join(os.path.dirname(__file__), "recipes.yaml")
BROADCASTER = "joint_state_broadcaster"
_MARKS = ("each", "several")


class Kind(NamedTuple):
    """A short name of `--type`: what its controller is called, the interface it commands if nothing says otherwise, and
    the roles that its joints have. `each`: one controller for each joint; `several`: it commands several interfaces.
    `fit` are the interfaces that it may command.
    """

    name: str
    label: str
    interface: str | None = None
    roles: tuple[tuple[str, int], ...] = ()
    each: bool = False
    several: bool = False
    fit: tuple[str, ...] = ()


@cache
def recipes() -> dict[str, Any]:
    """The file, read once."""
    import yaml

    with open(_FILE, encoding="utf-8") as file:
        plain: dict[str, Any] = yaml.load(file, getattr(yaml, "CSafeLoader", yaml.SafeLoader))  # noqa: S506 (safe)
    return plain


def kind_of(name: str, catalog: Catalog, options: Options) -> Kind:
    """The kind of a short name, or of a type's full name. UserError where the distro has no such thing."""
    plain = recipes()["kinds"].get(name)
    if plain is None:
        return _kind_of_type(name, catalog, options)
    listed = _listed(plain, options)
    label = plain.get(f"ros{options.ros}_name", plain["name"])
    return _kind(name, plain, listed, label, [key for key in listed if key not in _MARKS])


def _kind(name: str, plain: Mapping[str, Any], listed: Mapping[str, Any], label: str, fit: Sequence[str]) -> Kind:
    roles, default = tuple(plain.get("roles", {}).items()), plain.get("interface")
    interface = default if default in fit or "any" in fit else next(iter(fit), None)
    return Kind(
        name, label, default and interface, roles, bool(listed.get("each")), bool(listed.get("several")), (*fit,)
    )


def type_of(kind: Kind, interfaces: Sequence[str], catalog: Catalog, options: Options) -> ControllerType:
    """The type of controller that a kind means. UserError where the distro has none for the interfaces."""
    plain = recipes()["kinds"].get(kind.name)
    if plain is None:
        return _known(kind.name, catalog, options.distro)
    listed = _listed(plain, options)
    names = listed.get("any") or [name for one in interfaces for name in listed.get(one, ())]
    unknown = [one for one in interfaces if "any" not in listed and one not in listed]
    if unknown:
        choices = ", ".join(key for key in listed if key not in _MARKS)
        raise UserError(
            f"no '{kind.name}' controller commands '{unknown[0]}' in {options.distro}; it may be: {choices}"
        )
    found = [catalog.controller(name, options.distro) for name in names]
    here = [one for one in found if one]
    if not here:
        where = ", ".join(dict.fromkeys(distro for name in names for distro in catalog.distros_of(name)))
        raise UserError(f"{options.distro} has no '{names[0]}', which is in {where}")
    sound = next((one for one in here if not one.deprecated), None)
    return sound or here[0]


def recipe_of(controller: ControllerType) -> Mapping[str, Any] | None:
    """What is written of a type's parameters: [value, comment] by name; None where there is no recipe."""
    own: Mapping[str, Any] | None = recipes()["parameters"].get(controller.type)
    if own is None:
        return None
    found = {name: entry for name, entry in own.items() if name != "also"}
    for group in own.get("also", ()):
        found.update(recipes()["groups"][group])
    return found


def _listed(plain: Mapping[str, Any], options: Options) -> Mapping[str, Any]:
    ros = f"ros{options.ros}"
    listed: Mapping[str, Any] | None = plain.get(f"{ros}_group") if options.group else None
    listed = listed or plain.get(ros)
    if listed is None:
        raise UserError(f"ROS {options.ros} has no controllers of the type '{plain['name']}'")
    return listed


def _kind_of_type(name: str, catalog: Catalog, options: Options) -> Kind:
    kinds: Mapping[str, Any] = recipes()["kinds"]
    if "/" not in name:
        raise UserError(
            f"unknown type '{name}'{did_you_mean(name, kinds)}; known are {', '.join(kinds)}, or a full name"
        )
    _known(name, catalog, options.distro)
    found = [
        (plain, listed, [key for key, names in listed.items() if key not in _MARKS and name in names])
        for plain in kinds.values()
        for listed in (plain.get(f"ros{options.ros}", {}), plain.get(f"ros{options.ros}_group", {}))
    ]
    of_name = [one for one in found if one[2]]
    if not of_name:
        return Kind(name, _snake(name.rpartition("/")[2]))
    plain, listed, _ = of_name[0]
    label = plain["name"] if len(of_name) == 1 else name.partition("/")[0]
    return _kind(name, plain, listed, label, [key for _, _, fit in of_name for key in fit])


def _known(name: str, catalog: Catalog, distro: str) -> ControllerType:
    found = catalog.controller(name, distro)
    if found is None:
        where = catalog.distros_of(name)
        near = did_you_mean(name, catalog.known_types(distro))
        raise UserError(
            f"{distro} has no '{name}', which is in {', '.join(where)}" if where else f"unknown type '{name}'{near}"
        )
    if found.deprecated:
        instead = catalog.replacement(name, distro)
        raise UserError(f"'{name}' is deprecated in {distro}" + (f"; take '{instead.type}'" if instead else ""))
    return found


def _snake(name: str) -> str:
    return re.sub(r"(?<=[a-z0-9])(?=[A-Z])|(?<=[A-Z])(?=[A-Z][a-z])", "_", name).lower()
