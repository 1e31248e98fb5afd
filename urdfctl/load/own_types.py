"""What the packages of a workspace define themselves: controllers with their parameters, and hardware."""

from __future__ import annotations

import os
import re
from collections.abc import Collection, Iterable, Mapping
from typing import TYPE_CHECKING, Any

from urdfctl.catalog.definitions import Definition, definition_of
from urdfctl.model.project import OwnHardware, OwnTypes
from urdfctl.names import is_slip
from urdfctl.source.disk.files import FileProblem, Files
from urdfctl.source.workspaces.plugin_exports import (
    ExportedClass,
    built_classes,
    category_of,
    definition_files,
    exported_classes,
    sources_of_class,
)
from urdfctl.source.yaml.tree import read_yaml
from urdfctl.startup.records import NamedTuple

if TYPE_CHECKING:
    from urdfctl.catalog.entries import ControllerType

_CONTROLLER_BASE = "controller_interface::"
_PLAIN_BASES = ("ControllerInterface", "ChainableControllerInterface")
_HARDWARE_BASES = ("SystemInterface", "ActuatorInterface", "SensorInterface", "RobotHWSim", "RobotHW")
_DECLARES = re.compile(r"\b(?:declare_parameters?|auto_declare|get_parameters?|get_parameter_or|add_pre_set\w+)\s*[<(]")
_PREFIXED = re.compile(r"ParamListener\b[^;]{0,300}?\(\s*(?:this->)?(?:get_node\(\)|node_?)\s*,\s*\S")


class ExportedClasses(NamedTuple):
    """The classes that a package exports."""

    package: str
    folder: str
    classes: tuple[ExportedClass, ...]


def exports_in(packages: Iterable[tuple[str, str]], files: Files) -> list[ExportedClasses]:
    """Return the exports of packages, given by name and folder."""
    found = (ExportedClasses(name, folder, tuple(exported_classes(folder, files))) for name, folder in packages)
    return [exports for exports in found if exports.classes]


def prefixes_of(types: Collection[str]) -> set[str]:
    """Return the packages that types are named after."""
    return {re.split("/|::", name)[0] for name in types}


def own_types(wanted: Collection[str], exports: Iterable[ExportedClasses], files: Files) -> OwnTypes:
    """Return what the packages export that define some types, or similar ones, or whose name is the prefix of one.

    wanted: the names of controllers and hardware.
    """
    prefixes = prefixes_of(wanted)
    controllers: dict[str, Mapping[str, Any]] = {}
    hardware: list[str] = []
    classes: dict[str, OwnHardware] = {}
    for each in exports:
        if each.package not in prefixes and not any(_may_be_meant(one.name, wanted) for one in each.classes):
            continue
        for one in each.classes:
            if one.base.startswith(_CONTROLLER_BASE):
                controllers[one.name] = _controller(one, each, wanted, files)
            elif one.base.endswith(_HARDWARE_BASES):
                hardware.append(one.name)
                if one.name in wanted:
                    classes[one.name] = _hardware(one, each)
    return OwnTypes(controllers, tuple(hardware), classes)


def _hardware(one: ExportedClass, exports: ExportedClasses) -> OwnHardware:
    """How a package makes a hardware class known to pluginlib."""
    return OwnHardware(
        package=exports.package,
        kind=one.kind,
        base=one.base,
        description=os.path.relpath(one.path, exports.folder),
        category=category_of(exports.folder, one.path, one.base.partition("::")[0]),
        built=built_classes(exports.folder),
    )


def _may_be_meant(name: str, wanted: Collection[str]) -> bool:
    """Whether a class is one that is wanted, or one of them may be a misspelling of it, also of its package."""
    last = re.split("/|::", name)[-1]
    return any(other == name or re.split("/|::", other)[-1] == last or is_slip(other, name) for other in wanted)


def without_copies(own: OwnTypes) -> OwnTypes:
    """Return own types without the controllers that the catalogue describes: copies of an upstream package.

    A controller with the type of an upstream one is no copy if its definition has a parameter that upstream has in no
    distro, or lacks one that upstream requires.
    """
    from urdfctl.catalog.catalog import CATALOG

    kept = {
        name: entry
        for name, entry in own.controllers.items()
        if not CATALOG.distros_of(name) or _differs(entry.get("parameters"), _in_each_distro(name))
    }
    return own._replace(controllers=kept)


def _differs(defined: Mapping[str, Any] | None, upstream: Iterable[ControllerType]) -> bool:
    if defined is None:
        return False
    names = {_pattern(name) for name in defined}
    of_distros = [{_pattern(name): each.required for name, each in kind.parameters.items()} for kind in upstream]
    lacking = all(any(required and name not in names for name, required in one.items()) for one in of_distros)
    return lacking or not names <= {name for one in of_distros for name in one}


def _in_each_distro(name: str) -> list[ControllerType]:
    from urdfctl.catalog.catalog import CATALOG

    found = (CATALOG.controller(name, distro) for distro in CATALOG.distros_of(name))
    return [kind for kind in found if kind is not None]


def _pattern(name: str) -> str:
    """A parameter's name without the names of its placeholders."""
    return re.sub("<[^<>]*>", "<>", name)


def _controller(one: ExportedClass, exports: ExportedClasses, wanted: Collection[str], files: Files) -> dict[str, Any]:
    """The catalogue entry of an exported controller; its parameters only if somebody wants to know them."""
    entry: dict[str, Any] = {"type": one.name, "package": exports.package, "origin": "workspace", "open": True}
    if one.name in wanted:
        sources = sources_of_class(exports.folder, one.class_name)
        definition = _definition(one, exports, sources, files)
        if definition is not None:
            entry |= {"parameters": definition.parameters, "open": _reads_more(one, sources)}
    return entry


def _definition(one: ExportedClass, exports: ExportedClasses, sources: str, files: Files) -> Definition | None:
    """The definition of a controller's parameters: its code includes the generated header."""
    if _PREFIXED.search(sources):
        return None
    found = []
    for file in definition_files(exports.folder):
        if re.search(rf'#\s*include\s*["<](?:[\w./-]*/)?{re.escape(file.library)}\.hpp[">]', sources):
            try:
                found.append(definition_of(read_yaml(files.glance(file.path))))
            except FileProblem:
                return None
    if len(found) > 1:
        snake = re.sub(r"(?<=[a-z0-9])(?=[A-Z])", "_", one.class_name).lower()
        found = [each for each in found if each and each.namespace == snake]
    return found[0] if len(found) == 1 else None


def _reads_more(one: ExportedClass, sources: str) -> bool:
    """Whether a controller may read parameters that its definition does not have: it declares some itself, or inherits
    from another controller."""
    base = re.search(rf"class\s+(?:\w+\s+)?{re.escape(one.class_name)}\s*(?:final\s*)?:\s*public\s+([\w:]+)", sources)
    inherits = base is None or base[1].rpartition("::")[2] not in _PLAIN_BASES
    return inherits or _DECLARES.search(sources) is not None
