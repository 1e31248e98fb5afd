"""The robots that a project's configuration tells of: which files belong together, and with which arguments."""

from __future__ import annotations

import os
from collections.abc import Iterator, Mapping
from itertools import product
from math import prod

from urdfctl.errors import UserError
from urdfctl.hints import Any
from urdfctl.record import NamedTuple
from urdfctl.suggest import nearest_path

MOST_VARIANTS = 200
Arguments = tuple[tuple[str, str], ...]


class ConfiguredRobot(NamedTuple):
    """A description, each set of arguments that it is to be looked at with, and the controllers' files and launch files
    that belong to it. Paths are from the folder that we stand in."""

    path: str
    variants: tuple[Arguments, ...] = ((),)
    controllers: tuple[str, ...] = ()
    launches: tuple[str, ...] = ()

    @property
    def files(self) -> tuple[str, ...]:
        """All the files that it names."""
        return self.path, *self.controllers, *self.launches


def robots_of(table: Mapping[str, Any], file: str) -> tuple[ConfiguredRobot, ...]:
    """What a configuration file's `[[robot]]` tables say, which fit the schema. UserError where they mean nothing."""
    return tuple(_robot(entry, file, f"robot[{number}]") for number, entry in enumerate(table.get("robot", ())))


def _robot(entry: Mapping[str, Any], file: str, key: str) -> ConfiguredRobot:
    matrix = entry.get("matrix", {})
    if prod(len(values) for values in matrix.values()) > MOST_VARIANTS:
        raise UserError(f"{file}: {key}.matrix: gives more than {MOST_VARIANTS} variants")
    for name in matrix:
        if name in entry.get("args", {}):
            raise UserError(f"{file}: {key}.matrix: '{name}' is given in args too")
    fixed = {name: _text(value) for name, value in entry.get("args", {}).items()}
    chosen = (dict(zip(matrix, map(_text, values), strict=True)) for values in product(*matrix.values()))
    return ConfiguredRobot(
        _file(entry["path"], file, f"{key}.path"),
        tuple(dict.fromkeys(tuple({**fixed, **one}.items()) for one in chosen)),
        tuple(_files(entry, "controllers", file, key)),
        tuple(_files(entry, "launch", file, key)),
    )


def _text(value: object) -> str:
    """A value as xacro takes it from a command line."""
    return str(value).lower() if isinstance(value, bool) else str(value)


def _files(entry: Mapping[str, Any], kind: str, file: str, key: str) -> Iterator[str]:
    for number, path in enumerate(entry.get(kind, ())):
        yield _file(path, file, f"{key}.{kind}[{number}]")


def _file(path: str, file: str, key: str) -> str:
    found = os.path.normpath(os.path.join(os.path.dirname(file), path))
    if not os.path.isfile(found):
        raise UserError(f"{file}: {key}: no such file: '{path}'{nearest_path(found)}")
    return found
