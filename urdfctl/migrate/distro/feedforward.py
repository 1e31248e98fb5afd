"""Gains of feedforward that did nothing, because a PID controller has its feedforward off."""

from __future__ import annotations

from collections.abc import Iterator

from urdfctl.migrate.edits.yaml_edits import ByName, MapEdits, leaves, text_at
from urdfctl.migrate.options import Part
from urdfctl.migrate.packages import MigratedPackages
from urdfctl.migrate.shared.controller_files import FileSection, sections
from urdfctl.migrate.step import EntryKind, Proposal, ReportEntry, Row, Step

_TYPE = "pid_controller/PidController"
_SWITCH, _GAIN = "enable_feedforward", "feedforward_gain"
_AUTHORITY = (
    "ros2_controllers#1553: a feedforward_gain that is not zero acts; before, the feedforward was off unless "
    "enable_feedforward or the service set_feedforward_control switched it on"
)


def _feedforward(packages: MigratedPackages) -> Iterator[Proposal]:
    for section in packages.found(sections):
        is_due = section.type == _TYPE and packages.crosses("kilted", section.path)
        if is_due and packages.may_change(section.path):
            given = dict(leaves(section.parameters))
            gains = [name for name in given if name.rpartition(".")[2] == _GAIN and not _is_zero(text_at(given, name))]
            if gains and text_at(given, _SWITCH).lower() in ("", "false"):
                yield _off(packages, section, given, gains)


def _off(packages: MigratedPackages, section: FileSection, given: ByName, gains: list[str]) -> Proposal:
    """The proposal to make gains zero that had no effect."""
    edits = MapEdits(packages.read(section.path))
    entries = []
    for name in gains:
        edits.replace(given[name][-1][1].value, "0.0")
        what = f"'{name}' of '{section.node}' is 0.0, because the feedforward was off at the start"
        option = f"{name}: {text_at(given, name)}"
        at = given[name][-1][1].key.at
        entries.append(ReportEntry(EntryKind.DECIDED, what, at, authority=_AUTHORITY, option=option))
    if _SWITCH in given:
        edits.drop(given[_SWITCH])
    return Proposal(edits=edits.edits(), entries=tuple(entries))


def _is_zero(text: str) -> bool:
    try:
        return float(text) == 0
    except ValueError:
        return False


_CONTROLLER = """
    controller_manager:
      ros__parameters:
        update_rate: 100
        wheel:
          type: pid_controller/PidController
    wheel:
      ros__parameters:
        dof_names: [wheel]
        command_interface: velocity
        reference_and_state_interfaces: [velocity]
        gains:
          wheel: {p: 1.0, feedforward_gain: %s}
"""

FEEDFORWARD = Step(
    name="feedforward",
    part=Part.YAML,
    summary="Feedforward of PID controllers that was off",
    propose=_feedforward,
    rows=(Row(f"pid_controller without {_SWITCH}: {_GAIN}", f"{_GAIN}: 0.0", "kilted", _AUTHORITY),),
    before=[{"options": "--from=jazzy --to=kilted", "config/controllers.yaml": _CONTROLLER % "0.95"}],
    after=[{"config/controllers.yaml": _CONTROLLER % "0.0"}],
)
