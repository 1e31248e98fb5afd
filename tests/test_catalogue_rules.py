"""For each type of controller in each distro: the least right file is clean, and what is left out, of a wrong type or
refused by a validator is found where it stands."""

from __future__ import annotations

import json
from collections.abc import Iterator, Mapping

import pytest

from urdfctl.catalog.catalog import CATALOG
from urdfctl.catalog.distros import ROS1, ROS2, generation
from urdfctl.catalog.entries import ControllerType, Parameter
from urdfctl.catalog.map_parameters import expanded
from urdfctl.catalog.validators import problem
from urdfctl.control.minimal import minimal_parameters
from urdfctl.control.values import Values
from urdfctl.diagnostic import Diagnostic, Severity
from urdfctl.lint import Selection, lint
from urdfctl.model.build_controllers import Loaded, controllers_of
from urdfctl.model.project import Project
from urdfctl.source.span import SourceText
from urdfctl.source.yaml import read_yaml


def known(distro: str, name: str) -> ControllerType:
    controller = CATALOG.controller(name, distro)
    assert controller is not None
    return controller


def types() -> Iterator[tuple[str, str]]:
    """Each type in each distro, without those that are as in the distro before."""
    for family in (ROS1, ROS2):
        last: dict[str, ControllerType] = {}
        for distro in family:
            for name in CATALOG.known_types(distro):
                controller = known(distro, name)
                if name not in last or controller != last[name]._replace(distro=distro, since=controller.since):
                    yield distro, name
                last[name] = controller


TYPES = list(types())
NAMES = [f"{distro}-{name}" for distro, name in TYPES]


def file_of(controller: ControllerType, values: Mapping[str, object]) -> str:
    """A controllers' file, as JSON, which is YAML too; dotted names nested where ROS 1 wants them so."""
    if generation(controller.distro) == 2:
        manager = {"update_rate": 100, "c": {"type": controller.type}}
        sections: dict[str, object] = {"controller_manager": {"ros__parameters": manager}}
        if values:
            sections["c"] = {"ros__parameters": dict(values)}
        return json.dumps(sections)
    nested: dict[str, object] = {"type": controller.type}
    for name, value in values.items():
        *above, last = name.split(".")
        inner = nested
        for part in above:
            inner = inner.setdefault(part, {})  # type: ignore[assignment]
        inner[last] = value
    return json.dumps({"c": nested})


def findings(controller: ControllerType, values: Mapping[str, object]) -> list[Diagnostic]:
    source = SourceText("/controllers.yaml", file_of(controller, values).encode())
    ros = generation(controller.distro)
    made = controllers_of([Loaded(read_yaml(source))], ros, ("c",))
    project = Project(None, "/controllers.yaml", controller.distro, (controller.distro,), controllers=made)
    outcome = lint(project, [source], Selection(select=("UC4",)))
    assert not outcome.crashed
    return [one for one in outcome.diagnostics if one.severity is not Severity.INFO]


def is_gain(controller: ControllerType, name: str) -> bool:
    """ROS 1's PID gains have rules of their own."""
    return generation(controller.distro) == 1 and name.rpartition(".")[2] == "p"


@pytest.mark.parametrize(("distro", "name"), TYPES, ids=NAMES)
def test_the_least_right_parameters_are_clean(distro: str, name: str) -> None:
    controller = known(distro, name)
    values = minimal_parameters(controller)
    found = [one for one in findings(controller, values) if one.code != "UC439"]  # a chain without filters is right too
    assert [one.message for one in found] == []


@pytest.mark.parametrize(("distro", "name"), TYPES, ids=NAMES)
def test_each_needed_parameter_that_is_left_out_is_missed(distro: str, name: str) -> None:
    controller = known(distro, name)
    values = minimal_parameters(controller)
    for parameter in controller.parameters.values():
        if not parameter.needed or is_gain(controller, parameter.name):
            continue
        for full in expanded(parameter.name, Values(controller, values)):
            rest = {key: value for key, value in values.items() if key != full}
            found = findings(controller, {**rest, "use_sim_time": True})
            assert any(one.code == "UC431" and f"'{full}'" in one.message for one in found), full


def wrong_value(parameter: Parameter, distro: str) -> object:
    """A value of another type; None where there is none that is surely wrong."""
    kinds = {kind.removesuffix("_array") for kind in parameter.types}
    if kinds & {"none", "struct"}:
        return None
    if "string" in kinds:
        return 7
    return "a text" if generation(distro) == 1 or "double" not in kinds else "1.0x"


@pytest.mark.parametrize(("distro", "name"), TYPES, ids=NAMES)
def test_a_value_of_a_wrong_type_is_found_for_each_parameter(distro: str, name: str) -> None:
    controller = known(distro, name)
    values = minimal_parameters(controller)
    for parameter in controller.parameters.values():
        wrong = wrong_value(parameter, distro)
        if wrong is None or parameter.ignored:
            continue
        for full in expanded(parameter.name, Values(controller, values))[:1]:
            found = [one.message for one in findings(controller, {**values, full: wrong}) if one.code == "UC432"]
            assert len(found) == 1, full
            assert found[0].startswith(f"'{full}' must be")


def broken_values(parameter: Parameter, values: Mapping[str, object]) -> Iterator[object]:
    """Values of the right type that a validator refuses."""
    kind = parameter.types[-1]
    plain = kind.removesuffix("_array")
    singles: list[object] = {
        "double": [-1e9, 0.0, 1e9],
        "int": [-(10**9), 0, 10**9],
        "string": ["", "nothing_known"],
        "bool": [],
    }.get(plain, [])
    if kind != plain:
        given = values.get(parameter.name)
        twice = [list(given) * 2] if isinstance(given, list) and given else []
        singles = [[], *([single] for single in singles), *twice, *([single] * 30 for single in singles)]
    for value in singles:
        if problem(value, parameter.validators) is not None:
            yield value


@pytest.mark.parametrize(("distro", "name"), TYPES, ids=NAMES)
def test_a_value_that_a_validator_refuses_is_found(distro: str, name: str) -> None:
    controller = known(distro, name)
    values = minimal_parameters(controller)
    for parameter in controller.parameters.values():
        if parameter.ignored:
            continue
        for full in expanded(parameter.name, Values(controller, values))[:1]:
            for broken in broken_values(parameter, values):
                code = "UC407" if broken == [] and generation(distro) == 2 else "UC433"
                found = [one.code for one in findings(controller, {**values, full: broken})]
                assert found.count(code) == 1, (full, broken)


def test_the_values_that_are_tried_break_all_validators() -> None:
    every = [p for distro, name in TYPES for p in known(distro, name).parameters.values() if p.validators]
    assert [one for one in every if not list(broken_values(one, {one.name: ["a"]}))] == []
