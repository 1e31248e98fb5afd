"""Which of a node's parameters it does not read, which of them are slips, and which it lacks."""

from __future__ import annotations

from collections.abc import Collection, Iterator, Mapping
from functools import lru_cache

from urdfctl.catalog.distros import generation
from urdfctl.catalog.entries import FormerParameter, Parameter
from urdfctl.catalog.map_parameters import expected, matching, prefixes
from urdfctl.catalog.validators import problem
from urdfctl.catalog.value_types import type_problem
from urdfctl.control.parameter_rules import breaches
from urdfctl.memory import once_per_object
from urdfctl.model.controllers import Controller
from urdfctl.model.parameters import Kind
from urdfctl.model.parameters import Parameter as Given
from urdfctl.record import NamedTuple
from urdfctl.rule import Project
from urdfctl.rules.controllers.readers import Reader, readers_of
from urdfctl.suggest import nearest

OF_EVERY_NODE = ("qos_overrides", "start_type_description_service", "diagnostic_updater", "enable_logger_service")
"""What rclcpp and its helpers read in any node, besides what ros2_control tells of it."""
OF_THE_SPAWNER = ("type", "params_file", "fallback_controllers", "node_options_args", "ros__parameters")
"""What may stand in a controller's section, and is not for the controller."""
_MOST_COMPARED = 20
_FEW = 4
_NEEDING = ("not_empty", "needs", "any_set", "one_group_set", "length")


class Missing(NamedTuple):
    """A parameter that a node needs and is not given. `words` follow its name, where it is more than to be given."""

    name: str
    refused: bool
    words: str = ""


def known_as(reader: Reader, name: str) -> tuple[str, str | None] | None:
    """The parameter that a node reads under a full name, and the element that it is for."""
    given = _known_as(reader)
    return given[name] if name in given else matching(name, reader.known)


@once_per_object
def _known_as(reader: Reader) -> dict[str, tuple[str, str | None] | None]:
    return {parameter.name: matching(parameter.name, reader.known) for parameter in reader.located}


def is_ros1(reader: Reader) -> bool:
    """Whether the node is one of ROS 1, which reads its parameters one by one and takes others for none of its own."""
    return generation(reader.distro) == 1


@once_per_object
def unread(reader: Reader) -> list[Given]:
    """What is given to a node alone, and it does not read; of a map that it knows nothing of, the map."""
    told: dict[str, Given] = {}
    for leaf in reader.own.leaves:
        if _is_foreign(reader, leaf.name) or known_as(reader, leaf.name):
            continue
        top = _unknown_part(leaf.name, _starts(reader))
        found = reader.own.get(top)
        if found is not None:
            told[top] = found
    return list(told.values())


def _is_foreign(reader: Reader, name: str) -> bool:
    """Whether somebody else reads it, or another rule tells that nobody does."""
    first = name.partition(".")[0]
    if first in reader.controllers or ".ros__parameters" in name:
        return True
    if first in OF_EVERY_NODE or (reader.controller is not None and first in OF_THE_SPAWNER):
        return True
    return reader.type is not None and first in reader.type.ignored


@once_per_object
def _starts(reader: Reader) -> dict[str, FormerParameter]:
    """What stands before the dots in the names that a node reads, or that others read, as something to be matched."""
    names = prefixes((*reader.known, *reader.former))
    return {name: FormerParameter(name) for name in names}


def _unknown_part(name: str, starts: Mapping[str, FormerParameter]) -> str:
    """As much of a name as is needed to see that it is not known."""
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
    """Of the unread parameters those that surely mean one that is read, and which: both by their full names."""
    found: dict[str, str] = {}
    if not unread(reader):
        return found
    candidates = frozenset(
        name for name in (*_expected(reader), *_starts(reader)) if "<" not in name and name not in reader.own
    )
    for parameter in unread(reader)[:_MOST_COMPARED]:
        meant = nearest(parameter.name, candidates) or _misplaced(parameter, candidates)
        if meant is not None and matching(parameter.name, reader.former) is None:
            found[parameter.name] = meant
    return found


def _misplaced(parameter: Given, candidates: frozenset[str]) -> str | None:
    """The one parameter that is called so within a map: `goal_time` for `constraints.goal_time`."""
    same = _of_last(candidates).get(parameter.last, [])
    return same[0] if len(same) == 1 and parameter.value.kind is not Kind.MAP else None


def namesakes(reader: Reader, parameter: Given) -> list[str]:
    """The parameters that are called so within maps, where there are several: `linear.x.max_velocity` and its like."""
    if parameter.value.kind is Kind.MAP or "." in parameter.name:
        return []
    return [name for name in _expected(reader) if name.endswith(f".{parameter.name}")]


def of_other_ros(project: Project, reader: Reader, name: str) -> int | None:
    """The other generation of ROS, where the type's counterpart there reads a parameter of this name."""
    if reader.type is None:
        return None
    distro = "rolling" if is_ros1(reader) else "noetic"
    found = project.catalog.replacement(reader.type.type, distro)
    counterpart = project.catalog.controller(found.type if found else reader.type.type, distro)
    known = counterpart is not None and matching(name, counterpart.parameters) is not None
    return generation(distro) if known else None


@once_per_object
def _expected(reader: Reader) -> dict[str, Parameter]:
    """The parameters by the full names that they have with the values that are given."""
    return expected(reader.known, reader.given)


@once_per_object
def missing(reader: Reader) -> list[Missing]:
    """What a node needs and is not given, but for the gains of ROS 1's PID controllers, which have rules of their own."""
    found = {name: Missing(name, refused=True) for name, parameter in _needed(reader) if not _is_given(reader, name)}
    for breach in breaches(reader.type, reader.given) if reader.type else ():
        name = breach.parameter
        if name in found or _is_given(reader, name) or breach.rule.kind not in _NEEDING or name == "gains":
            continue
        if "<" in name:  # what it stands for is not given, or of no use, which is a fault of its own
            continue
        found[name] = Missing(name, breach.rule.severity == "error", breach.message)
    return list(found.values())


def _needed(reader: Reader) -> Iterator[tuple[str, Parameter]]:
    for name, parameter in _expected(reader).items():
        gain = is_ros1(reader) and name.rpartition(".")[2] == "p"
        if parameter.needed and not gain:
            yield name, parameter


def _is_given(reader: Reader, name: str) -> bool:
    return name in reader.located


def is_sound(reader: Reader, name: str) -> bool:
    """Whether what a rule on several parameters is asked about is fit to be asked about: given, or not needed, of the
    right type, no empty list of ROS 2, and nothing that its own checks refuse."""
    found, value = known_as(reader, name), reader.given.get(name)
    if found is None:
        return True
    parameter = reader.known[found[0]]
    if name not in reader.given:
        return not parameter.needed
    if type_problem(value, parameter, reader.distro) or (value == [] and not is_ros1(reader)):
        return False
    return problem(value, parameter.validators) is None


def is_another(reader: Reader) -> bool:
    """Whether a controller is rather another one of the same name, a fork: it reads less than half of its parameters."""
    leaves = reader.own.leaves
    known = sum(1 for leaf in leaves if known_as(reader, leaf.name) or matching(leaf.name, reader.former))
    return len(leaves) - known > max(known, _FEW)


def is_lacking(project: Project, controller: Controller, names: Collection[str] | None = None) -> bool:
    """Whether a controller is refused for want of parameters (of some names), in each distro that has it."""
    for readers in readers_of(project):
        if readers[0].controller is controller:
            lacks = [[lack.name for lack in missing(reader) if lack.refused] for reader in readers]
            return all(any(names is None or name in names for name in one) for one in lacks)
    return False


def number_slips(reader: Reader, name: str) -> list[str]:
    """The parameters that a name is the plural of, or that are its plural: `joints` for `joint`, which has a rule of
    its own."""
    others = (f"{name}s", name.removesuffix("s"))
    return [other for other in others if other in reader.known and reader.known[other].type.startswith("string")]
