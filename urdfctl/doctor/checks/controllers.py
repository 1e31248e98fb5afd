"""The hardware and the controllers of each manager, beside those that the files declare and start."""

from __future__ import annotations

import json
import math
from collections.abc import Iterator

from urdfctl.doctor.examination import Ailment, Examination, ailment
from urdfctl.doctor.expectation import ExpectedController
from urdfctl.doctor.recording import RecordedController, RecordedManager
from urdfctl.names import enumerated
from urdfctl.rules.running.running_controller_not_active import running_controller_not_active
from urdfctl.rules.running.running_controller_not_in_files import running_controller_not_in_files
from urdfctl.rules.running.running_controller_not_loaded import running_controller_not_loaded
from urdfctl.rules.running.running_hardware_not_active import running_hardware_not_active
from urdfctl.rules.running.running_parameter_differs import running_parameter_differs
from urdfctl.rules.running.running_type_unknown import running_type_unknown

_MOST_NOTES = 5
_LIKE = 1e-6
_AUTOMATIC = ("use_sim_time", "robot_description")
"""Parameters that launch arguments or other nodes mostly give."""


def check_hardware(exam: Examination) -> Iterator[Ailment]:
    """Yield the hardware components that are not active."""
    for name in exam.managers:
        for component in exam.manager(name).hardware:
            if component.state not in ("active", ""):
                yield ailment(
                    running_hardware_not_active, component=component.name, state=component.state, manager=name
                )


def check_controllers(exam: Examination) -> Iterator[Ailment]:
    """Yield what is wrong with the controllers: first what a wrong parameter explains, then those that are missing or
    not active, then those that the files do not have."""
    answering = [one for one in exam.controllers if exam.manager(one.manager).answers]
    for expected in answering:
        yield from _of_parameters(exam, expected)
    for expected in answering:
        running = exam.running(expected)
        if running is None and expected.state:
            yield _not_loaded(exam, expected)
        elif running is not None and running.state != "active" and expected.state == "active":
            why = _why_not_active(exam, expected, running)
            yield ailment(
                running_controller_not_active, expected.at, controller=running.name, state=running.state, why=why
            )
    if exam.is_whole:
        for name in exam.managers:
            yield from _unknown(exam, exam.manager(name))


# -- parameters --------------------------------------------------------------------------------------------------------


def _of_parameters(exam: Examination, expected: ExpectedController) -> Iterator[Ailment]:
    """One finding for the parameters in which a running controller differs from the files."""
    running = exam.recording.parameters(expected.node)
    differing = [
        (name, running[name], value)
        for name, value in expected.parameters.items()
        if name in running and name not in _AUTOMATIC and not _is_same(running[name], value)
    ]
    if differing:
        (name, runs, files), *rest = differing
        notes = [f"{other}: {_written(one)}, the files say {_written(two)}" for other, one, two in rest[:_MOST_NOTES]]
        yield ailment(
            running_parameter_differs,
            expected.at,
            node=expected.node,
            parameter=name,
            running=_written(runs),
            files=_written(files),
            notes=notes,
        )


def _is_same(one: object, other: object) -> bool:
    if isinstance(one, list) and isinstance(other, list):
        return len(one) == len(other) and all(map(_is_same, one, other))
    first, second = _number(one), _number(other)
    if first is not None and second is not None:
        return first == second or math.isclose(first, second, rel_tol=_LIKE, abs_tol=_LIKE)
    return str(one) == str(other) or (other is None and one in ("", [], None))


def _number(value: object) -> float | None:
    """A number, also one that JSON has no way to write; None for anything else."""
    if isinstance(value, bool):
        return None
    if isinstance(value, int | float):
        return float(value) if math.isfinite(value) else None
    return None


def _written(value: object) -> str:
    return json.dumps(value, ensure_ascii=False)


# -- states ------------------------------------------------------------------------------------------------------------


def _not_loaded(exam: Examination, expected: ExpectedController) -> Ailment:
    """Why a controller that the files start is not loaded."""
    manager = exam.manager(expected.manager)
    given = exam.recording.parameters(expected.manager).get(f"{expected.name}.type")
    if isinstance(given, str) and given and manager.types and given not in manager.types:
        files = f"; the files say '{expected.type}'" if expected.type and expected.type != given else ""
        return ailment(running_type_unknown, expected.at, controller=expected.name, running=given, files=files)
    why = "no spawner asked for it (was an older launch file started?), or its initialisation failed: "
    why += f"look for parameters of '{expected.node}' in the log"
    return ailment(
        running_controller_not_loaded, expected.at, controller=expected.name, manager=expected.manager, why=why
    )


def _why_not_active(exam: Examination, expected: ExpectedController, running: RecordedController) -> str:
    manager = exam.manager(expected.manager)
    missing = [
        name for name in (*running.commands, *running.states) if manager.exported and name not in manager.exported
    ]
    if missing:
        return f"no hardware exports {_few(missing)}"
    holders = {
        other.name: [name for name in running.commands if name in other.claimed]
        for other in manager.controllers
        if other.name != running.name and other.state == "active"
    }
    for name, held in holders.items():
        if held:
            return f"'{name}' holds {_few(held)}"
    idle = [component.name for component in manager.hardware if component.state not in ("active", "")]
    if idle:
        return f"hardware {_few(idle)} is not active"
    if running.state == "unconfigured":
        return "it was not configured, or refused its parameters: look for its name in the log"
    how = f"ros2 control set_controller_state -c {expected.manager} {running.name} active"
    return f"its interfaces are free, but nobody activated it (a spawner with --inactive?); {how}"


def _few(names: list[str]) -> str:
    shown = [f"'{name}'" for name in names[:3]]
    return enumerated([*shown, f"{len(names) - len(shown)} more"] if len(names) > len(shown) else shown)


def _unknown(exam: Examination, manager: RecordedManager) -> Iterator[Ailment]:
    known = {one.name for one in exam.controllers if one.manager == manager.name}
    for running in manager.controllers:
        if running.name not in known and running.state == "active" and running.claimed:
            holds = f", and it holds {_few(list(running.claimed))}"
            yield ailment(running_controller_not_in_files, controller=running.name, holds=holds)
