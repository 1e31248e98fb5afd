"""UC439."""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Mapping

from urdfctl.catalog.catalog import Catalog
from urdfctl.catalog.distros import ROS2
from urdfctl.catalog.entries import ParameterEntry as Known
from urdfctl.catalog.validators import problem
from urdfctl.catalog.value_types import type_problem
from urdfctl.control.parameters.given import plain
from urdfctl.control.parameters.readers import Reader, in_each_distro
from urdfctl.model.controllers import Parameter, ValueKind
from urdfctl.names import did_you_mean
from urdfctl.rule import Finding, Project, Severity, Stage, rule
from urdfctl.rules.controllers.filters import FilterChain, chains

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
    stage=Stage.CONFIGURE,
    severity=Severity.ERROR,
    runtime="refuses",
    distros=ROS2,
    authority="filters filters/filter_chain.hpp: 'filter_chain.filter1.name and filter_chain.filter1.type are required'; "
    "control_toolbox: 'LowPass filter cannot be configured'",
    options=["--distro=jazzy"],
    bad=[{"controllers.yaml": _FILE % "«1»"}],
    good=[{"controllers.yaml": _FILE % "0.5"}],
)
def filter_chain_unusable(project: Project) -> Iterator[Finding]:
    """Invalid or empty filter chain.

    Filters are called `filter1`, `filter2` and so on, without gaps. Each has a name, a type, and the parameters of that
    type. A chain without `filter1` is empty and passes its input on unchanged.
    """
    yield from in_each_distro(project, lambda reader: _faults(reader, project.catalog))


def _faults(reader: Reader, catalog: Catalog) -> Iterator[Finding]:
    filter_chains = list(chains(reader))
    known = catalog.filters(reader.distro) if filter_chains else {}
    yield from _unfiltered(reader, filter_chains)
    for chain in filter_chains:
        filters = list(chain.filters())
        if not filters:
            message = f"filter chain '{chain.name}' is empty; call its filters 'filter1', 'filter2' and so on"
            yield Finding(chain.at.key, message, severity=Severity.WARNING)
        for name, parameter in filters:
            yield from _faults_of_filter(chain, name, parameter, known)
    yield from _shared(reader)


def _unfiltered(reader: Reader, filter_chains: list[FilterChain]) -> Iterator[Finding]:
    """Inputs of a filtering controller that have no chain."""
    inputs = reader.located.value("input_interfaces") if "<input_interfaces>.filter_chain" in reader.known else None
    chained = {chain.name for chain in filter_chains}
    for name, at in inputs.strings if inputs and "filter_chain" not in chained else ():
        if f"{name}.filter_chain" not in chained:
            message = f"input '{name}' has no filter_chain; it is passed on unchanged"
            yield Finding(at, message, severity=Severity.WARNING)


def _shared(reader: Reader) -> Iterator[Finding]:
    """One chain for several inputs, which need one each."""
    shared, inputs = reader.located.get("filter_chain"), reader.located.value("input_interfaces")
    if shared is not None and "filter_chain" in reader.known and inputs is not None and len(inputs.items) > 1:
        message = (
            "several 'input_interfaces' cannot share one 'filter_chain'; give each its own: '<input>: filter_chain:'"
        )
        yield Finding(shared.key, message, severity=Severity.ERROR)


def _faults_of_filter(chain: FilterChain, name: str, at: Parameter, known: Filters) -> Iterator[Finding]:
    for wanted in ("name", "type"):
        if f"{name}.{wanted}" not in chain.parameters:
            yield Finding(at.key, f"filter '{chain.name}.{name}' has no '{wanted}'", severity=Severity.ERROR)
            return
    kind = chain.parameters.value(f"{name}.type")
    if kind is None or kind.kind is not ValueKind.STRING or not kind.is_known:
        return
    if kind.text not in known:
        hint = did_you_mean(kind.text, known)
        if hint:
            yield Finding(kind.at, f"filter type '{kind.text}' is unknown{hint}", severity=Severity.ERROR)
        return
    given = {parameter.name: parameter for parameter in chain.parameters.under(f"{name}.params")}
    for needed in known[kind.text].values():
        if needed.needed and needed.name not in given:
            message = f"filter '{chain.name}.{name}' has no '{needed.name}', which filter type '{kind.text}' requires"
            yield Finding(at.key, message, severity=Severity.ERROR)
    yield from _faults_of_values(given.values(), known[kind.text], kind.text)


def _faults_of_values(given: Iterable[Parameter], known: Mapping[str, Known], kind: str) -> Iterator[Finding]:
    for parameter in given:
        declared = known.get(parameter.name)
        if declared is None:
            continue
        value = plain(parameter.value)
        wrong = type_problem(value, declared, "rolling") or problem(value, declared.validators)
        if wrong:
            message = f"'{parameter.name}' of filter type '{kind}' {wrong}"
            yield Finding(parameter.value.at, message, severity=Severity.ERROR)
