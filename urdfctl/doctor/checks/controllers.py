"""The hardware and the controllers of each manager, beside those that the files declare and start."""

from __future__ import annotations

from collections.abc import Iterator

from urdfctl.doctor.checks.parameters import of_manager, of_parameters
from urdfctl.doctor.examination import Ailment, Examination, ailment
from urdfctl.doctor.expectation import ExpectedController
from urdfctl.doctor.recording import RecordedController, RecordedManager
from urdfctl.names import enumerated
from urdfctl.rules.running.manager_without_types import manager_without_types
from urdfctl.rules.running.running_controller_not_active import running_controller_not_active
from urdfctl.rules.running.running_controller_not_in_files import running_controller_not_in_files
from urdfctl.rules.running.running_controller_not_loaded import running_controller_not_loaded
from urdfctl.rules.running.running_hardware_not_active import running_hardware_not_active
from urdfctl.rules.running.running_type_differs import running_type_differs
from urdfctl.rules.running.running_type_unknown import running_type_unknown

_TYPE = ".type"
_INITIAL = "hardware_components_initial_state"


def check_hardware(exam: Examination) -> Iterator[Ailment]:
    """Yield the hardware components that are not active, though the files do not leave them so."""
    for name in exam.managers:
        meant = exam.settings(name)
        for component in exam.manager(name).hardware:
            wanted = meant.get(f"{_INITIAL}.{component.state}")
            if component.state not in ("active", "") and not (isinstance(wanted, list) and component.name in wanted):
                yield ailment(
                    running_hardware_not_active,
                    notes=_notes(exam.logged(component.name)),
                    component=component.name,
                    state=component.state,
                    manager=name,
                )


def check_controllers(exam: Examination) -> Iterator[Ailment]:
    """Yield what is wrong with the controllers: first what a wrong parameter explains, then those that are missing or
    not active, then those that the files do not have."""
    for name in exam.managers:
        yield from _without_types(exam, name)
    answering = [one for one in exam.controllers if exam.manager(one.manager).answers]
    for expected in exam.controllers if exam.recording.is_of_ros1 else answering:
        yield from _of_type(exam, expected)
        yield from of_parameters(exam, expected.node, expected.parameters, expected.at)
    for name in exam.managers:
        if exam.manager(name).answers:
            yield from of_manager(exam, name)
    down = [one for one in answering if _is_down(exam, one)]
    names = {one.name for one in down}
    for expected in sorted(down, key=lambda one: bool(_chained(exam, one) & names)):
        running = exam.running(expected)
        yield _not_loaded(exam, expected) if running is None else _not_active(exam, expected, running, names)
    if exam.is_whole:
        for name in exam.managers:
            yield from _unknown(exam, exam.manager(name))


def _without_types(exam: Examination, manager: str) -> Iterator[Ailment]:
    """A manager that has no type of a controller, and the type of none that it should have."""
    running = exam.recording.parameters(manager)
    types = [name for name in exam.settings(manager) if name.endswith(_TYPE)]
    if running and types and not any(name.endswith(_TYPE) for name in running):
        controllers = enumerated(f"'{name.removesuffix(_TYPE)}'" for name in types)
        yield ailment(manager_without_types, manager=manager, controllers=controllers)


def _is_down(exam: Examination, expected: ExpectedController) -> bool:
    """Whether a controller is not in the state in which the files start it."""
    running = exam.running(expected)
    if running is None:
        return bool(expected.state)
    return running.state != "active" and expected.state == "active"


def _chained(exam: Examination, expected: ExpectedController) -> set[str]:
    """The controllers that a controller commands."""
    running = exam.running(expected)
    return {name.partition("/")[0] for name in running.commands} if running else set()


def _of_type(exam: Examination, expected: ExpectedController) -> Iterator[Ailment]:
    running = exam.running(expected)
    if running is not None and expected.type and running.type not in ("", expected.type):
        yield ailment(
            running_type_differs, expected.at, controller=running.name, running=running.type, files=expected.type
        )


# -- states ------------------------------------------------------------------------------------------------------------


def _not_loaded(exam: Examination, expected: ExpectedController) -> Ailment:
    """Why a controller that the files start is not loaded."""
    manager = exam.manager(expected.manager)
    settings = exam.recording.parameters(expected.manager)
    given = settings.get(f"{expected.name}.type")
    if isinstance(given, str) and given and manager.types and given not in manager.types:
        files = f"; the files say '{expected.type}'" if expected.type and expected.type != given else ""
        return ailment(running_type_unknown, expected.at, controller=expected.name, running=given, files=files)
    logged = exam.logged(expected.name)
    if logged:
        why = logged
    elif settings and given is None and expected.type:
        why = f"the manager has no parameter '{expected.name}.type': it got other files, or they name another node"
    else:
        why = "no spawner asked for it (was an older launch file started?), or its initialisation failed: "
        why += f"look for parameters of '{expected.node}' in the log"
    return ailment(
        running_controller_not_loaded, expected.at, controller=expected.name, manager=expected.manager, why=why
    )


def _not_active(
    exam: Examination, expected: ExpectedController, running: RecordedController, down: set[str]
) -> Ailment:
    logged = exam.logged(running.name)
    why = _why_not_active(exam, expected, running, down)
    return ailment(
        running_controller_not_active,
        expected.at,
        notes=_notes(logged if why else ""),
        controller=running.name,
        state=running.state,
        why=why or logged or _what_to_do(expected, running),
    )


def _why_not_active(
    exam: Examination, expected: ExpectedController, running: RecordedController, down: set[str]
) -> str:
    """What keeps a controller from being active; empty if nothing is seen."""
    manager = exam.manager(expected.manager)
    chained = sorted(_chained(exam, expected) & down)
    if chained:
        return f"it commands {_few(chained)}, which is not active"
    wanted = (*running.commands, *running.states)
    missing = [name for name in wanted if manager.exported and name not in manager.exported]
    if missing:
        return f"no hardware exports {_few(missing)}"
    for other in manager.controllers:
        held = [name for name in running.commands if name in other.claimed]
        if held and other.name != running.name and other.state == "active":
            return f"'{other.name}' holds {_few(held)}"
    idle = [component.name for component in manager.hardware if component.state not in ("active", "")]
    return f"hardware {_few(idle)} is not active" if idle else ""


def _what_to_do(expected: ExpectedController, running: RecordedController) -> str:
    if running.state == "unconfigured":
        return "it was not configured, or refused its parameters: look for its name in the log"
    how = f"ros2 control set_controller_state -c {expected.manager} {running.name} active"
    return f"its interfaces are free, but nobody activated it (a spawner with --inactive?); {how}"


def _notes(logged: str) -> tuple[str, ...]:
    return (logged,) if logged else ()


def _few(names: list[str]) -> str:
    shown = [f"'{name}'" for name in names[:3]]
    return enumerated([*shown, f"{len(names) - len(shown)} more"] if len(names) > len(shown) else shown)


def _unknown(exam: Examination, manager: RecordedManager) -> Iterator[Ailment]:
    known = {one.name for one in exam.controllers if one.manager == manager.name}
    for running in manager.controllers:
        if running.name not in known and running.state == "active" and running.claimed:
            holds = f", and it holds {_few(list(running.claimed))}"
            yield ailment(running_controller_not_in_files, controller=running.name, holds=holds)
