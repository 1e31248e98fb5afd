"""The [[robot]] tables of a configuration: which files belong together, and with which arguments."""

from __future__ import annotations

import os
from collections.abc import Iterator, Mapping
from itertools import product
from math import prod
from typing import Any

from urdfctl.errors import UserError
from urdfctl.names import nearest_path
from urdfctl.source.disk.gate import admits
from urdfctl.startup.records import NamedTuple

MOST_VARIANTS = 200
Arguments = tuple[tuple[str, str], ...]


class ConfiguredRobot(NamedTuple):
    """A robot in the configuration. Paths are relative to the current folder.

    path: the description.
    variants: the sets of xacro arguments to check it with.
    controllers: the controller files that belong to it.
    launches: the launch files that belong to it.
    """

    path: str
    variants: tuple[Arguments, ...] = ((),)
    controllers: tuple[str, ...] = ()
    launches: tuple[str, ...] = ()

    @property
    def files(self) -> tuple[str, ...]:
        """Return all files that belong to the robot."""
        return self.path, *self.controllers, *self.launches


def robots_of(table: Mapping[str, Any], file: str) -> tuple[ConfiguredRobot, ...]:
    """Return the robots of a configuration that matches the schema. UserError if a file does not exist or a matrix is
    invalid."""
    return tuple(_robot(entry, file, f"robot[{number}]") for number, entry in enumerate(table.get("robot", ())))


def _robot(entry: Mapping[str, Any], file: str, key: str) -> ConfiguredRobot:
    matrix = entry.get("matrix", {})
    if prod(len(values) for values in matrix.values()) > MOST_VARIANTS:
        raise UserError(f"{file}: {key}.matrix: defines more than {MOST_VARIANTS} variants")
    for name in matrix:
        if name in entry.get("args", {}):
            raise UserError(f"{file}: {key}.matrix: '{name}' is also defined in args")
    fixed = {name: _text(value) for name, value in entry.get("args", {}).items()}
    combinations = (dict(zip(matrix, map(_text, values), strict=True)) for values in product(*matrix.values()))
    return ConfiguredRobot(
        _file(entry["path"], file, f"{key}.path"),
        tuple(dict.fromkeys(tuple({**fixed, **values}.items()) for values in combinations)),
        tuple(_files(entry, "controllers", file, key)),
        tuple(_files(entry, "launch", file, key)),
    )


def _text(value: object) -> str:
    """Return a value as it is given to xacro on a command line."""
    return str(value).lower() if isinstance(value, bool) else str(value)


def _files(entry: Mapping[str, Any], kind: str, file: str, key: str) -> Iterator[str]:
    for number, path in enumerate(entry.get(kind, ())):
        yield _file(path, file, f"{key}.{kind}[{number}]")


def _file(path: str, file: str, key: str) -> str:
    joined = os.path.normpath(os.path.join(os.path.dirname(file), path))
    if not admits(joined):
        way_out = "name it on the command line, or use a wider --workspace"
        raise UserError(f"{file}: {key}: file '{path}' is outside the workspace; {way_out}")
    if not os.path.isfile(joined):
        raise UserError(f"{file}: {key}: file '{path}' does not exist{nearest_path(joined)}")
    return joined
