"""At which step of its life a controller is stopped by what lint found in its files."""

from __future__ import annotations

from collections.abc import Iterator

from urdfctl.catalog.values import is_set
from urdfctl.control.gains import Fate, missing_gains
from urdfctl.control.life import AT_LOAD
from urdfctl.control.parameter_rules import breaches
from urdfctl.control.session import Configured
from urdfctl.diagnostic import Diagnostic
from urdfctl.model.controllers import Controller
from urdfctl.smoke.results import Step
from urdfctl.source.span import Place

OF_ROBOT = ("UC0", "UC1")
OF_HARDWARE = ("UC2", "UC3")
OF_FILES = frozenset(
    {"UC024", "UC026", "UC401", "UC402", "UC403", "UC405", "UC406", "UC408", "UC411", "UC413", "UC414"}
)
"""What keeps a controllers' file from being read at all: none of its controllers gets its parameters."""
BY_LIFE = frozenset({"UC434", *(f"UC{number}" for number in range(450, 463))})
"""What `urdfctl.control.life` works out for each controller by itself, in the order in which they are started."""

_STARVING = frozenset({"UC407", "UC410", "UC415", "UC416", "UC430", "UC431", "UC444"})
"""A parameter does not arrive: where that shows hangs on how the controller checks it."""
_ROS2 = {"UC418": Step.ACTIVATE, "UC439": Step.CONFIGURE, "UC440": Step.ACTIVATE, "UC441": Step.ACTIVATE}


def step_of(finding: Diagnostic, one: Configured, ros: int) -> Step:
    """The step at which a finding of lint stops a controller."""
    if ros == 1:
        return _starting(one) if finding.code == "UC464" else Step.LOAD
    if finding.code in _STARVING:
        return _starved(one)
    return _ROS2.get(finding.code, Step.LOAD)


def _starting(one: Configured) -> Step:
    """Without gains some controllers of ROS 1 are not loaded, others crash when they are started."""
    fates = {missing.fate for missing in missing_gains(one.type, one.values)} if one.type else set()
    return Step.ACTIVATE if Fate.CRASH in fates and Fate.REFUSED not in fates else Step.LOAD


def _starved(one: Configured) -> Step:
    """A parameter with a check of its own is missed when it is declared, on load; others when they are configured."""
    if one.type is None:
        return Step.LOAD
    missing = (name for name, parameter in one.type.parameters.items() if parameter.needed and not parameter.is_map)
    if any(not is_set(one.values.get(name)) for name in missing):
        return Step.LOAD
    found = [breach.rule.kind for breach in breaches(one.type, one.values) if breach.rule.severity == "error"]
    return Step.LOAD if any(kind in AT_LOAD for kind in found) else Step.CONFIGURE


def concerns(finding: Diagnostic, controller: Controller) -> bool:
    """Whether a finding is about a controller: it stands at its name, its type or its parameters, or names it."""
    at = finding.at
    spans = ((place.source.path, place.span) for place in _places(controller))
    if any(path == at.file and span.start <= at.start <= span.end for path, span in spans):
        return True
    return f"'{controller.name}'" in finding.message


def _places(controller: Controller) -> Iterator[Place]:
    if controller.declared_at is not None:
        yield controller.declared_at
    if controller.type is not None:
        yield controller.type.at
    yield from (section.at for section in controller.sections)
    for parameters in (controller.parameters, controller.under_manager):
        for parameter in parameters:
            yield parameter.key
            yield parameter.value.at
