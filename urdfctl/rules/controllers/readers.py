"""Who reads which parameters: the controller manager and its controllers, as each distro has them."""

from __future__ import annotations

from collections.abc import Callable, Iterator, Mapping

from urdfctl.catalog.distros import generation, in_words, since
from urdfctl.catalog.entries import ControllerType, FormerParameter, Parameter
from urdfctl.control.given import given_values
from urdfctl.memory import once_for_the_last
from urdfctl.model.controllers import Controller, Manager
from urdfctl.model.parameters import Kind, Parameters
from urdfctl.record import NamedTuple
from urdfctl.rule import Finding, Note, Project, Severity
from urdfctl.rules.controllers.common import controllers_in
from urdfctl.source.span import Place

_ROS2 = 2
_MAINTAINED = frozenset(since("humble")) - {"iron"}


class Reader(NamedTuple):
    """A node that reads parameters, as one distro has it: a controller manager, or a controller of a known type.

    `name` is what messages call it. `known` are the parameters that it reads, those of every node included; of a
    manager also what it reads of each of its `controllers`. `given` are the values that reach it, by name; `located` the same
    with their places, and `own` those that are meant for it alone.
    """

    distro: str
    name: str
    at: Place | None
    known: Mapping[str, Parameter]
    former: Mapping[str, FormerParameter]
    given: Mapping[str, object]
    located: Parameters
    own: Parameters
    type: ControllerType | None = None
    controller: Controller | None = None
    controllers: tuple[str, ...] = ()


Judge = Callable[[Reader], Iterator[Finding]]


def in_each_distro(project: Project, judge: Judge, *, newest: bool = False) -> Iterator[Finding]:
    """What a judge finds in each node, one finding for a place: less grave where not all distros that have the node give
    it, with a note that names those that do. Only what the `newest` of them gives too, where that is asked for."""
    for readers in readers_of(project):
        found: dict[Place, dict[str, Finding]] = {}
        if newest and next(judge(readers[-1]), None) is None:
            continue
        for reader in readers:
            for finding in judge(reader):
                found.setdefault(finding.at, {}).setdefault(reader.distro, finding)
        idle = readers[0].controller is not None and not may_be_started(project, readers[0].controller)
        for by_distro in found.values():
            if not newest or readers[-1].distro in by_distro:
                finding = _joined(by_distro, [reader.distro for reader in readers])
                yield finding._replace(severity=Severity.WARNING) if idle and _is_error(finding) else finding


def _joined(by_distro: Mapping[str, Finding], distros: list[str]) -> Finding:
    """The newest distro's words for all; what is mended in newer ones is no more than worth knowing."""
    last = list(by_distro.values())[-1]
    if len(by_distro) == len(distros):
        mildest = min(
            (finding.severity or Severity.ERROR for finding in by_distro.values()), key=lambda one: one.weight
        )
        return last._replace(severity=mildest)
    most = 2 * len(_MAINTAINED & by_distro.keys()) > len(_MAINTAINED)
    worse = _is_error(last) or (most and last.severity is Severity.WARNING)
    less = Severity.WARNING if worse and distros[-1] in by_distro else Severity.INFO
    return last._replace(severity=less, notes=(*last.notes, Note(f"this holds for {in_words(by_distro)}")))


def _is_error(finding: Finding) -> bool:
    return finding.severity is Severity.ERROR


def may_be_started(project: Project, controller: Controller) -> bool:
    """Whether a controller is among those that are started, or it is not known which are."""
    if project.started is None or project.controllers is None:
        return True
    found = (project.controllers.controller(name) for name in project.started)
    return "all" in project.started or any(one is controller for one in found)


@once_for_the_last
def readers_of(project: Project) -> tuple[tuple[Reader, ...], ...]:
    """Each node, as each of the distros has it that know it."""
    controllers = controllers_in(project)
    ros2 = [distro for distro in project.distros if generation(distro) == _ROS2]
    found = [tuple(_manager(project, manager, distro) for distro in ros2) for manager in controllers.managers]
    for controller in controllers.controllers:
        kind = type_of(controller)
        distros = ros2 if is_of_ros2(project, controller) else [d for d in project.distros if generation(d) == 1]
        types = [project.catalog.controller(kind, distro) for distro in distros] if kind else []
        given = given_values(controller.parameters)
        found.append(tuple(_controller(project, controller, type_, given) for type_ in types if type_))
    return tuple(readers for readers in found if readers)


def type_of(controller: Controller) -> str | None:
    """The type, where it is a text that stands there literally."""
    kind = controller.type
    return kind.text if kind is not None and kind.kind is Kind.STRING and kind.is_known else None


def is_of_ros2(project: Project, controller: Controller) -> bool:
    """Whether a controller is configured as in ROS 2, or where no file tells, the project is of it."""
    if controller.manager is not None or any(section.parameters_at for section in controller.sections):
        return True
    return not controller.sections and project.ros == _ROS2


def _manager(project: Project, manager: Manager, distro: str) -> Reader:
    catalog = project.catalog
    controllers = [c for c in controllers_in(project).controllers if c.manager is manager]
    keys = catalog.controller_keys(distro)
    of_controllers = {
        f"{controller.name}.{name}": key._replace(name=f"{controller.name}.{name}", required=False)
        for controller in controllers
        for name, key in keys.items()
    }
    simulated = {name: p for name, p in catalog.common_parameters(distro).items() if name == "use_sim_time"}
    known = {**catalog.manager_parameters(distro), **simulated, **of_controllers}
    given = given_values(manager.parameters)
    names = tuple(controller.name for controller in controllers)
    own = manager.own
    return Reader(distro, manager.name, manager.at, known, {}, given, manager.parameters, own, controllers=names)


def _controller(project: Project, controller: Controller, kind: ControllerType, given: Mapping[str, object]) -> Reader:
    known = {**project.catalog.common_parameters(kind.distro), **kind.parameters}
    at = controller.sections[0].at if controller.sections else controller.declared_at
    return Reader(
        kind.distro,
        controller.name,
        at,
        known,
        kind.former,
        given,
        controller.parameters,
        controller.own,
        kind,
        controller,
    )
