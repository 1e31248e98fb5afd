"""A node's unread, misspelt and missing parameters."""

from __future__ import annotations

from collections.abc import Collection, Iterator, Mapping
from functools import lru_cache

from urdfctl.catalog.distros import generation
from urdfctl.catalog.entries import FormerParameter, ParameterEntry
from urdfctl.catalog.map_parameters import expected, matching, prefixes
from urdfctl.catalog.validators import problem
from urdfctl.catalog.value_types import type_problem
from urdfctl.control.parameters.readers import Reader, readers_of
from urdfctl.control.parameters.rules import breaches
from urdfctl.model.controllers import Controller, ValueKind
from urdfctl.model.controllers import Parameter as Given
from urdfctl.names import are_opposed, nearest
from urdfctl.rule import Project
from urdfctl.startup.per_object import once_per_object
from urdfctl.startup.records import NamedTuple

OF_EVERY_NODE = ("qos_overrides", "start_type_description_service", "diagnostic_updater", "enable_logger_service")
"""Parameters that rclcpp and its helpers read in any node, in addition to those in the catalogue."""
OF_THE_SPAWNER = ("type", "params_file", "fallback_controllers", "node_options_args", "ros__parameters")
"""Keys of a controller's section that are not for the controller itself."""
_MOST_COMPARED = 20
"""Unread parameters of a node that are compared with known ones; comparing takes long."""
_FEW = 4
"""Up to this many unknown parameters, a controller is never taken for a fork."""
_REQUIRING = ("not_empty", "needs", "any_set", "one_group_set", "length")
"""Kinds of rules on parameters that a missing parameter can break."""


class MissingParameter(NamedTuple):
    """A required parameter that a node does not get."""

    name: str
    refused: bool
    """Whether the controller is refused without it."""
    words: str = ""
    """The message of the broken rule, to follow the name; empty if the parameter is simply required."""


def known_as(reader: Reader, name: str) -> tuple[str, str | None] | None:
    """Return the parameter that a node reads under a full name, and the list element that it is for."""
    given = _known_as(reader)
    return given[name] if name in given else matching(name, reader.known)


@once_per_object
def _known_as(reader: Reader) -> dict[str, tuple[str, str | None] | None]:
    return {parameter.name: matching(parameter.name, reader.known) for parameter in reader.located}


def replacement_of(reader: Reader, parameter: ParameterEntry | FormerParameter) -> str | None:
    """Return what takes the place of a parameter, in words: as a migration writes it, or as the catalogue says."""
    from urdfctl.catalog.moves import replacement_in_words

    kind = reader.type.type if reader.type else "controller_manager"
    return replacement_in_words(kind, parameter.name, reader.distro) or parameter.replacement


def is_ros1(reader: Reader) -> bool:
    """Return whether the node is one of ROS 1, which reads its parameters one by one and ignores all others."""
    return generation(reader.distro) == 1


@once_per_object
def unread(reader: Reader) -> list[Given]:
    """Return the parameters given to this node alone that it does not read; for an unknown map, the map itself."""
    by_name: dict[str, Given] = {}
    for leaf in reader.own.leaves:
        if _is_foreign(reader, leaf.name) or known_as(reader, leaf.name):
            continue
        top = _unknown_part(leaf.name, _starts(reader))
        parameter = reader.own.get(top)
        if parameter is not None:
            by_name[top] = parameter
    return list(by_name.values())


def _is_foreign(reader: Reader, name: str) -> bool:
    """Whether another node reads the parameter, or another rule reports it."""
    first = name.partition(".")[0]
    if first in reader.controllers or ".ros__parameters" in name:
        return True
    if first in OF_EVERY_NODE or (reader.controller is not None and first in OF_THE_SPAWNER):
        return True
    return reader.type is not None and first in reader.type.ignored


@once_per_object
def _starts(reader: Reader) -> dict[str, FormerParameter]:
    """The prefixes, up to a dot, of all names that the node reads now or in other distros, in a form to match with."""
    names = prefixes((*reader.known, *reader.former))
    return {name: FormerParameter(name) for name in names}


def _unknown_part(name: str, starts: Mapping[str, FormerParameter]) -> str:
    """The shortest part of a dotted name that is unknown."""
    parts = name.split(".")
    for size in range(1, len(parts)):
        part = ".".join(parts[:size])
        if matching(part, starts) is None:
            return part
    return name


@lru_cache(maxsize=64)
def _of_last(names: frozenset[str]) -> dict[str, list[str]]:
    by_last: dict[str, list[str]] = {}
    for name in names:
        by_last.setdefault(name.rpartition(".")[2], []).append(name)
    return by_last


@once_per_object
def slips(reader: Reader) -> dict[str, str]:
    """Return for unread parameters the known parameter that they almost certainly mean, both by full name."""
    meant_by: dict[str, str] = {}
    if not unread(reader):
        return meant_by
    candidates = frozenset(
        name for name in (*_expected(reader), *_starts(reader)) if "<" not in name and name not in reader.own
    )
    for parameter in unread(reader)[:_MOST_COMPARED]:
        meant = _nearest(parameter.name, candidates) or _misplaced(parameter, candidates)
        if meant is not None and matching(parameter.name, reader.former) is None:
            meant_by[parameter.name] = meant
    return meant_by


_nearest = lru_cache(maxsize=256)(nearest)
"""The distros of a type mostly have the same parameters."""


def _misplaced(parameter: Given, candidates: frozenset[str]) -> str | None:
    """The only known parameter in a map with this last name: `constraints.goal_time` for `goal_time`."""
    same = _of_last(candidates).get(parameter.last, [])
    if len(same) != 1 or parameter.value.kind is ValueKind.MAP or are_opposed(parameter.name, same[0]):
        return None
    return same[0]


def namesakes(reader: Reader, parameter: Given) -> list[str]:
    """Return the known parameters in maps with this last name, e.g. `linear.x.max_velocity` for `max_velocity`."""
    if parameter.value.kind is ValueKind.MAP or "." in parameter.name:
        return []
    return [name for name in _expected(reader) if name.endswith(f".{parameter.name}")]


def of_other_ros(project: Project, reader: Reader, name: str) -> int | None:
    """Return the other generation of ROS if the type's counterpart there reads a parameter of this name, else None."""
    if reader.type is None:
        return None
    distro = "rolling" if is_ros1(reader) else "noetic"
    replacement = project.catalog.replacement(reader.type.type, distro)
    counterpart = project.catalog.controller(replacement.type if replacement else reader.type.type, distro)
    known = counterpart is not None and matching(name, counterpart.parameters) is not None
    return generation(distro) if known else None


@once_per_object
def _expected(reader: Reader) -> dict[str, ParameterEntry]:
    """The parameters of the node by full name, with map placeholders replaced by the given elements."""
    return expected(reader.known, reader.given)


@once_per_object
def missing(reader: Reader) -> list[MissingParameter]:
    """Return the required parameters that a node does not get.

    Gains of ROS 1's PID controllers are not included; they have rules of their own.
    """
    by_name = {
        name: MissingParameter(name, refused=True) for name, parameter in _needed(reader) if not _is_given(reader, name)
    }
    for breach in breaches(reader.type, reader.given) if reader.type else ():
        name = breach.parameter
        if name in by_name or _is_given(reader, name) or breach.rule.kind not in _REQUIRING or name == "gains":
            continue
        if "<" in name:  # the list for the placeholder is missing or invalid, which is reported by itself
            continue
        by_name[name] = MissingParameter(name, breach.rule.severity == "error", breach.message)
    return list(by_name.values())


def _needed(reader: Reader) -> Iterator[tuple[str, ParameterEntry]]:
    for name, parameter in _expected(reader).items():
        gain = is_ros1(reader) and name.rpartition(".")[2] == "p"
        if parameter.needed and not gain:
            yield name, parameter


def _is_given(reader: Reader, name: str) -> bool:
    return name in reader.located


def is_sound(reader: Reader, name: str) -> bool:
    """Return whether a parameter has no fault of its own, so that rules on several parameters can check it.

    It is given or not required, has the right type, is no empty list in ROS 2, and passes its own validators.
    """
    matched, value = known_as(reader, name), reader.given.get(name)
    if matched is None:
        return True
    parameter = reader.known[matched[0]]
    if name not in reader.given:
        return not parameter.needed
    if type_problem(value, parameter, reader.distro) or (value == [] and not is_ros1(reader)):
        return False
    return problem(value, parameter.validators) is None


@once_per_object
def is_another(reader: Reader) -> bool:
    """Return whether a controller is probably a fork with the same type name: most of its parameters are unknown."""
    leaves = reader.own.leaves
    known = sum(1 for leaf in leaves if known_as(reader, leaf.name) or matching(leaf.name, reader.former))
    return len(leaves) - known > max(known, _FEW)


def is_lacking(project: Project, controller: Controller, names: Collection[str] | None = None) -> bool:
    """Return whether every distro that has the controller refuses it because required parameters are missing.

    names: if given, only parameters with these names count.
    """
    for readers in readers_of(project):
        if readers[0].controller is controller:
            missing_by_distro = [[lack.name for lack in missing(reader) if lack.refused] for reader in readers]
            return all(any(names is None or name in names for name in lacks) for lacks in missing_by_distro)
    return False


def number_slips(reader: Reader, name: str) -> list[str]:
    """Return the known parameters that are the singular or plural of a name: `joints` for `joint`.

    This confusion has a rule of its own.
    """
    others = (f"{name}s", name.removesuffix("s"))
    return [other for other in others if other in reader.known and reader.known[other].type.startswith("string")]
