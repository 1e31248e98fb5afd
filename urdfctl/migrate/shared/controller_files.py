"""The sections of controller files as they are written, whether a launch file loads them or not."""

from __future__ import annotations

import os
import re
from collections.abc import Iterator, Mapping, Sequence

from urdfctl.catalog.moves import MANAGER
from urdfctl.migrate.packages import MigratedPackages
from urdfctl.output.change import bytes_of
from urdfctl.source.disk.files import is_yaml
from urdfctl.source.span import SourceText
from urdfctl.source.workspaces.install_maps import read_install_map
from urdfctl.source.workspaces.packages import package_around, package_name
from urdfctl.source.yaml.tree import Mapping as Map
from urdfctl.source.yaml.tree import Scalar, read_yaml
from urdfctl.startup.records import NamedTuple

_PARAMETERS = "ros__parameters"


class FileSection(NamedTuple):
    """The parameters of one node in one file.

    node: the node's name without its namespace.
    type: the type of the controller; MANAGER for the manager; empty if unknown.
    parameters: the map below `ros__parameters`.
    """

    path: str
    node: str
    type: str
    parameters: Map


class TypeName(NamedTuple):
    """The place where a controller gets its type."""

    path: str
    controller: str
    value: Scalar


def sections(packages: MigratedPackages) -> list[FileSection]:
    """Return the sections of all controller files. A type is known from the same file, or else from the package."""
    found = [(path, node, map_) for path in _files(packages) for node, map_ in _nodes(packages, path)]
    around = {path: package_around(path) or path for path in {path for path, _, _ in found}}
    by_file: dict[str, dict[str, str]] = {}
    by_package: dict[str, dict[str, str]] = {}
    for declared in packages.found(type_names):
        by_file.setdefault(declared.path, {})[declared.controller] = declared.value.text
        by_package.setdefault(around[declared.path], {})[declared.controller] = declared.value.text
    return [
        FileSection(path, node, _type(node, by_file.get(path, {}), by_package.get(around[path], {})), map_)
        for path, node, map_ in found
    ]


def type_names(packages: MigratedPackages) -> list[TypeName]:
    """Return the types that controller managers give to controllers."""
    return list(_type_names(packages))


def _type_names(packages: MigratedPackages) -> Iterator[TypeName]:
    for path in _files(packages):
        for node, parameters in _nodes(packages, path):
            if not _is_manager(node):
                continue
            for entry in parameters.entries:
                value = entry.value.get("type") if isinstance(entry.value, Map) else None
                if isinstance(value, Scalar):
                    yield TypeName(path, entry.key.text, value)


def sections_near(known: Sequence[FileSection], source: SourceText, text: bytes) -> dict[str, set[str]]:
    """Return the controllers with parameters, each with its files.

    They are those that a launch file names, or its package's, or those of packages that it needs, or of the only other.
    Of files that have the same parameters for a controller, only the first is returned.

    text: the part of the launch file that names files for all controllers.
    """
    package = package_around(os.path.dirname(source.path))
    around = {path: package_around(os.path.dirname(path)) for path in {one.path for one in known}}
    typed = [one for one in known if one.type]
    named = [one for one in typed if re.search(rb"(?<![\w.-])" + re.escape(os.path.basename(one.path)).encode(), text)]
    beside = [one for one in known if around[one.path] == package]
    mentioned = {path for path in {one.path for one in typed} if _is_mentioned(around[path], source, package)}
    near = [one for one in typed if one.path in mentioned]
    only = typed if len({around[one.path] for one in typed}) == 1 else []
    chosen = [one for one in named if one in beside] or [one for one in named if one in near] or named
    chosen = chosen or beside or near or only
    files: dict[str, dict[bytes, str]] = {}
    for section in chosen:
        files.setdefault(section.node, {}).setdefault(_words(section), section.path)
    return {node: {*by_text.values()} for node, by_text in files.items()}


def _is_mentioned(folder: str | None, launch: SourceText, package: str | None) -> bool:
    """Whether a launch file or its package's manifest names the package in a folder."""
    name = package_name(os.path.join(folder, "package.xml")) if folder else None
    manifest = SourceText(launch.path, bytes_of(os.path.join(package, "package.xml")) or b"") if package else launch
    word = re.compile(rb"(?<![\w-])%s(?![\w-])" % re.escape(name or "").encode())
    return bool(name) and any(word.search(one.data) for one in (launch, manifest))


def _words(section: FileSection) -> bytes:
    """The parameters of a section without blanks and comments, which tells whether two are the same."""
    written = section.parameters.source.data[section.parameters.start : section.parameters.end]
    return b" ".join(re.sub(rb"(?m)(?:^|\s)#.*$", b"", written).split())


def installed_path(packages: MigratedPackages, path: str) -> tuple[str, list[str]]:
    """Return the package of a file and its path in the share folder: as a description names it, or as installed."""
    folder = package_around(path) or os.path.dirname(path)
    own = package_name(os.path.join(folder, "package.xml"))
    pattern = rb"\$\(find (%s)\)/((?:[^<>\"'\s]*/)?%s)" % (
        re.escape(own).encode() if own else rb"[\w-]+",
        re.escape(os.path.basename(path)).encode(),
    )
    for description in packages.files(".xacro", ".urdf"):
        found = re.search(pattern, packages.read(description).data)
        if found:
            return found[1].decode(), found[2].decode().split("/")
    name = own or os.path.basename(folder)
    parts = os.path.relpath(path, folder).split(os.sep)
    rules = read_install_map(folder, name)
    tails = (parts[index:] for index in range(len(parts)))
    return name, next((tail for tail in tails if rules.source_of("/".join(tail)) == os.path.normpath(path)), parts)


def _type(node: str, in_file: Mapping[str, str], in_package: Mapping[str, str]) -> str:
    return MANAGER if _is_manager(node) else in_file.get(node) or in_package.get(node, "")


def _is_manager(node: str) -> bool:
    return node.endswith(MANAGER)


def _files(packages: MigratedPackages) -> Iterator[str]:
    for path in packages.files(".yaml", ".yml"):
        if is_yaml(path) and _PARAMETERS.encode() in packages.read(path).data:
            yield path


def _nodes(packages: MigratedPackages, path: str) -> Iterator[tuple[str, Map]]:
    """The maps below `ros__parameters` in a file, each with the last part of its node's name."""
    pending = [(document, "") for document in read_yaml(packages.read(path)).documents]
    while pending:
        node, name = pending.pop(0)
        if not isinstance(node, Map):
            continue
        for entry in node.entries:
            if entry.key.text == _PARAMETERS and isinstance(entry.value, Map):
                yield name.rpartition("/")[2], entry.value
            else:
                pending.append((entry.value, entry.key.text))
