"""UC439."""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Mapping

from urdfctl.catalog.catalog import Catalog
from urdfctl.catalog.distros import ROS2
from urdfctl.catalog.entries import Parameter as Known
from urdfctl.catalog.validators import problem
from urdfctl.catalog.value_types import type_problem
from urdfctl.control.given import plain
from urdfctl.model.parameters import Kind, Parameter
from urdfctl.rule import Finding, Project, Severity, rule
from urdfctl.rules.controllers.filters import Chain, chains
from urdfctl.rules.controllers.readers import Reader, in_each_distro
from urdfctl.suggest import did_you_mean

Filters = Mapping[str, Mapping[str, Known]]
_FILE = """
    controller_manager:
      ros__parameters:
        update_rate: 100
        smooth: {type: chained_filter_controller/ChainedFilter}
    smooth:
      ros__parameters:
        input_interfaces: [elbow/position]
        output_interfaces: [elbow/smooth]
        filter_chain:
          filter1:
            name: smooth
            type: control_filters/ExponentialFilterDouble
            params: {alpha: %s}
"""


@rule(
    "UC439",
    severity=Severity.ERROR,
    distros=ROS2,
    authority="filters filters/filter_chain.hpp: 'filter_chain.filter1.name and filter_chain.filter1.type are required'; "
    "control_toolbox: 'LowPass filter cannot be configured'",
    options=["--distro=jazzy"],
    bad={"controllers.yaml": _FILE % "«1»"},
    good={"controllers.yaml": _FILE % "0.5"},
)
def filter_chain_unusable(project: Project) -> Iterator[Finding]:
    """A chain of filters cannot be made, or is empty.

    The filters are `filter1`, `filter2` and so on, without a gap, each with a name, a type and the parameters of that
    type. A chain without `filter1` is empty, and what goes in comes out as it is.
    """
    yield from in_each_distro(project, lambda reader: _faults(reader, project.catalog))


def _faults(reader: Reader, catalog: Catalog) -> Iterator[Finding]:
    found = list(chains(reader))
    known = catalog.filters(reader.distro) if found else {}
    yield from _unfiltered(reader, found)
    for chain in found:
        filters = list(chain.filters())
        if not filters:
            message = f"'{chain.name}' is empty: its filters are called 'filter1', 'filter2' and so on"
            yield Finding(chain.at.key, message, severity=Severity.WARNING)
        for name, parameter in filters:
            yield from _faults_of_filter(chain, name, parameter, known)
    yield from _shared(reader)


def _unfiltered(reader: Reader, found: list[Chain]) -> Iterator[Finding]:
    """The inputs that no chain is for: of a controller that is there to filter."""
    inputs = reader.located.value("input_interfaces") if "<input_interfaces>.filter_chain" in reader.known else None
    chained = {chain.name for chain in found}
    for name, at in inputs.strings if inputs and "filter_chain" not in chained else ():
        if f"{name}.filter_chain" not in chained:
            yield Finding(at, f"'{name}' has no filter_chain, and is copied as it is", severity=Severity.WARNING)


def _shared(reader: Reader) -> Iterator[Finding]:
    """A chain that several inputs would have to share."""
    shared, inputs = reader.located.get("filter_chain"), reader.located.value("input_interfaces")
    if shared is not None and "filter_chain" in reader.known and inputs is not None and len(inputs.items) > 1:
        message = "each of several 'input_interfaces' needs a chain of its own: '<input>: filter_chain:'"
        yield Finding(shared.key, message, severity=Severity.ERROR)


def _faults_of_filter(chain: Chain, name: str, parameter: Parameter, known: Filters) -> Iterator[Finding]:
    for wanted in ("name", "type"):
        if f"{name}.{wanted}" not in chain.parameters:
            yield Finding(parameter.key, f"'{chain.name}.{name}' has no '{wanted}'", severity=Severity.ERROR)
            return
    kind = chain.parameters.value(f"{name}.type")
    if kind is None or kind.kind is not Kind.STRING or not kind.is_known:
        return
    if kind.text not in known:
        hint = did_you_mean(kind.text, known)
        if hint:
            yield Finding(kind.at, f"unknown type of filter '{kind.text}'{hint}", severity=Severity.ERROR)
        return
    given = {one.name: one for one in chain.parameters.under(f"{name}.params")}
    for needed in known[kind.text].values():
        if needed.needed and needed.name not in given:
            message = f"'{chain.name}.{name}' is not given '{needed.name}', which a {kind.text} needs"
            yield Finding(parameter.key, message, severity=Severity.ERROR)
    yield from _faults_of_values(given.values(), known[kind.text], kind.text)


def _faults_of_values(given: Iterable[Parameter], known: Mapping[str, Known], kind: str) -> Iterator[Finding]:
    for one in given:
        parameter = known.get(one.name)
        if parameter is None:
            continue
        value = plain(one.value)
        wrong = type_problem(value, parameter, "rolling") or problem(value, parameter.validators)
        if wrong:
            yield Finding(one.value.at, f"'{one.name}' of a {kind} {wrong}", severity=Severity.ERROR)
