"""For each controller type and distro: a minimal file is clean; missing, mistyped and invalid values are reported."""

from __future__ import annotations

import json
from collections.abc import Iterator, Mapping

from sampling import assert_each, sample

from urdfctl.catalog.catalog import CATALOG
from urdfctl.catalog.distros import ROS1, ROS2, generation
from urdfctl.catalog.entries import ControllerType, ParameterEntry
from urdfctl.catalog.map_parameters import expanded
from urdfctl.catalog.validators import problem
from urdfctl.control.parameters.minimal import minimal_parameters
from urdfctl.control.parameters.values import Values
from urdfctl.diagnostic import Diagnostic, Severity
from urdfctl.lint.engine import lint
from urdfctl.lint.selection import Selection
from urdfctl.model.controllers.build_controllers import Loaded, controllers_of
from urdfctl.model.project import Project
from urdfctl.source.span import SourceText
from urdfctl.source.yaml.tree import read_yaml


def known(distro: str, name: str) -> ControllerType:
    controller = CATALOG.controller(name, distro)
    assert controller is not None
    return controller


def types() -> Iterator[tuple[str, str]]:
    """Yield each type in each distro, unless it is the same as in the previous distro."""
    for family in (ROS1, ROS2):
        last: dict[str, ControllerType] = {}
        for distro in family:
            for name in CATALOG.known_types(distro):
                controller = known(distro, name)
                if name not in last or controller != last[name]._replace(distro=distro, since=controller.since):
                    yield distro, name
                last[name] = controller


TYPES = list(types())
SAMPLE = {f"{distro}-{name}": (distro, name) for distro, name in sample(TYPES, 6)}


def file_of(controller: ControllerType, values: Mapping[str, object]) -> str:
    """Return a controller file as JSON, which is valid YAML; for ROS 1, dotted names are nested."""
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
    """Return whether it is a PID gain of ROS 1, which has its own rules."""
    return generation(controller.distro) == 1 and name.rpartition(".")[2] == "p"


def test_minimal_parameters_have_no_findings() -> None:
    def check(case: tuple[str, str]) -> None:
        controller = known(*case)
        values = minimal_parameters(controller)
        messages = [
            finding.message
            for finding in findings(controller, values)
            if finding.code != "UC439"  # a chain without filters is valid too
        ]
        assert messages == []

    assert_each(check, SAMPLE)


def test_each_missing_required_parameter_is_reported() -> None:
    def check(case: tuple[str, str]) -> None:
        controller = known(*case)
        values = minimal_parameters(controller)
        for parameter in controller.parameters.values():
            if not parameter.needed or is_gain(controller, parameter.name):
                continue
            for full in expanded(parameter.name, Values(controller, values)):
                rest = {key: value for key, value in values.items() if key != full}
                reported = findings(controller, {**rest, "use_sim_time": True})
                assert any(finding.code == "UC431" and f"'{full}'" in finding.message for finding in reported), full

    assert_each(check, SAMPLE)


def wrong_value(parameter: ParameterEntry, distro: str) -> object:
    """Return a value of another type; None if no value is certain to be wrong."""
    kinds = {kind.removesuffix("_array") for kind in parameter.types}
    if kinds & {"none", "struct"}:
        return None
    if "string" in kinds:
        return 7
    return "a text" if generation(distro) == 1 or "double" not in kinds else "1.0x"


def test_a_value_of_the_wrong_type_is_reported_for_each_parameter() -> None:
    def check(case: tuple[str, str]) -> None:
        controller = known(*case)
        values = minimal_parameters(controller)
        for parameter in controller.parameters.values():
            wrong = wrong_value(parameter, controller.distro)
            if wrong is None or parameter.ignored:
                continue
            for full in expanded(parameter.name, Values(controller, values))[:1]:
                reported = findings(controller, {**values, full: wrong})
                messages = [finding.message for finding in reported if finding.code == "UC432"]
                assert len(messages) == 1, full
                assert messages[0].startswith(f"'{full}' must be")

    assert_each(check, SAMPLE)


def broken_values(parameter: ParameterEntry, values: Mapping[str, object]) -> Iterator[object]:
    """Yield values of the right type that a validator rejects."""
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


def test_a_value_that_a_validator_rejects_is_reported() -> None:
    def check(case: tuple[str, str]) -> None:
        controller = known(*case)
        values = minimal_parameters(controller)
        for parameter in controller.parameters.values():
            if parameter.ignored:
                continue
            for full in expanded(parameter.name, Values(controller, values))[:1]:
                for broken in broken_values(parameter, values):
                    code = "UC407" if broken == [] and generation(controller.distro) == 2 else "UC433"
                    codes = [finding.code for finding in findings(controller, {**values, full: broken})]
                    assert codes.count(code) == 1, (full, broken)

    assert_each(check, SAMPLE)


def test_the_broken_values_cover_all_validators() -> None:
    validated = [
        parameter
        for distro, name in TYPES
        for parameter in known(distro, name).parameters.values()
        if parameter.validators
    ]
    assert [parameter for parameter in validated if not list(broken_values(parameter, {parameter.name: ["a"]}))] == []
