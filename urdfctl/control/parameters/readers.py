"""The nodes that read parameters: the controller manager and its controllers, by distro."""

from __future__ import annotations

from collections.abc import Callable, Iterator, Mapping

from urdfctl.catalog.distros import applies_to, generation, since
from urdfctl.catalog.entries import ControllerType, FormerParameter, ParameterEntry
from urdfctl.control.parameters.given import given_values
from urdfctl.control.robots import whole_robot_in
from urdfctl.diagnostic import Finding, Note, Severity
from urdfctl.model.controllers import Controller, Controllers, Manager, Parameters, ValueKind
from urdfctl.model.project import Project
from urdfctl.model.robot import Robot
from urdfctl.source.span import Place
from urdfctl.startup.per_object import once_for_the_last
from urdfctl.startup.records import NamedTuple

_ROS2 = 2
_OF_ALL = ("use_sim_time",)
"""The common parameters of controllers that every other node has too."""
_MAINTAINED = frozenset(since("humble")) - {"iron"}


class Reader(NamedTuple):
    """A node that reads parameters in one distro: a controller manager, or a controller of a known type."""

    distro: str
    name: str
    """Its name in messages."""
    at: Place | None
    """Its section, or else its declaration below the manager."""
    known: Mapping[str, ParameterEntry]
    """The parameters that it reads, including those of every node; for a manager also those of its controllers."""
    former: Mapping[str, FormerParameter]
    """Parameters that it reads only in other distros."""
    given: Mapping[str, object]
    """The values that reach it, by full name."""
    located: Parameters
    """The same parameters with their places."""
    own: Parameters
    """Those of them that are meant for this node alone."""
    type: ControllerType | None = None
    controller: Controller | None = None
    controllers: tuple[str, ...] = ()
    """The names of a manager's controllers."""


NOTHING = Controllers(())


def controllers_in(project: Project) -> Controllers:
    """Return the contents of the controller files; empty if the project has none."""
    return project.controllers or NOTHING


def robot_of(project: Project) -> Robot | None:
    """Return the robot if it and its controllers are completely known: only then can a name be called unknown."""
    robot = whole_robot_in(project)
    if robot is None or project.library or not project.complete or not robot.joints:
        return None
    return robot if controllers_in(project).complete else None


Judge = Callable[[Reader], Iterator[Finding]]
"""Yields the findings on one node."""


def in_each_distro(project: Project, judge: Judge, *, newest: bool = False) -> Iterator[Finding]:
    """Yield the findings of a judge on each node in all distros that have it, one finding for each place.

    If only some of these distros give a finding, it is less severe, and a note names them. It is also less severe if
    the controller is known not to be started.

    newest: yield only findings that the newest of these distros gives too.
    """
    for readers in readers_of(project):
        by_place: dict[Place, dict[str, Finding]] = {}
        if newest and next(judge(readers[-1]), None) is None:
            continue
        for reader in readers:
            for finding in judge(reader):
                by_place.setdefault(finding.at, {}).setdefault(reader.distro, finding)
        idle = readers[0].controller is not None and not may_be_started(project, readers[0].controller)
        for by_distro in by_place.values():
            if not newest or readers[-1].distro in by_distro:
                finding = _joined(by_distro, [reader.distro for reader in readers])
                finding = _of_idle(finding) if idle else finding
                yield _of_fork(finding) if _is_forked(project, readers[-1]) else finding


def _of_idle(finding: Finding) -> Finding:
    """The finding on a controller that nothing starts here: one step less severe."""
    return finding._replace(severity=finding.severity.milder) if finding.severity else finding


def _is_forked(project: Project, reader: Reader) -> bool:
    """Whether the workspace is built with a fork of the repository that has the type of a controller."""
    return reader.type is not None and not reader.type.external and builds_fork(project, reader.distro)


def builds_fork(project: Project, distro: str) -> bool:
    """Return whether the workspace is built with a fork of the repository of a distro's controllers."""
    name = "ros2_controllers" if generation(distro) == _ROS2 else "ros_controllers"
    fork = rf"(?:url\W+|uri\W+|clone\s+)\S*[:/](?!ros-controls/)[\w.-]+/{name}\b"
    return bool(project.mentioned(fork, of_builds=True))


def _of_fork(finding: Finding) -> Finding:
    note = Note("the workspace is built with a fork of the repository of this controller, which may read it")
    return finding._replace(severity=Severity.INFO, notes=(*finding.notes, note))


def _joined(by_distro: Mapping[str, Finding], distros: list[str]) -> Finding:
    """One finding in the words of the newest distro; only info if newer distros no longer give it."""
    last = list(by_distro.values())[-1]
    if len(by_distro) == len(distros):
        severities = (finding.severity or Severity.ERROR for finding in by_distro.values())
        mildest = min(severities, key=lambda severity: severity.weight)
        return last._replace(severity=mildest)
    most = 2 * len(_MAINTAINED & by_distro.keys()) > len(_MAINTAINED)
    is_grave = _is_error(last) or (most and last.severity is Severity.WARNING)
    severity = Severity.WARNING if is_grave and distros[-1] in by_distro else Severity.INFO
    return last._replace(severity=severity, notes=(*last.notes, Note(applies_to(by_distro))))


def _is_error(finding: Finding) -> bool:
    return finding.severity is Severity.ERROR


def may_be_started(project: Project, controller: Controller) -> bool:
    """Return whether a controller is started, or it is unknown which controllers are started."""
    if project.started is None or project.controllers is None:
        return True
    started = (project.controllers.controller(name) for name in project.started)
    return "all" in project.started or any(each is controller for each in started)


@once_for_the_last
def readers_of(project: Project) -> tuple[tuple[Reader, ...], ...]:
    """Return the nodes of a project; for each node one Reader for every distro that knows it, oldest first."""
    controllers = controllers_in(project)
    ros2 = [distro for distro in project.distros if generation(distro) == _ROS2]
    nodes = [tuple(_manager(project, manager, distro) for distro in ros2) for manager in controllers.managers]
    for controller in controllers.controllers:
        kind = type_of(controller)
        distros = ros2 if is_of_ros2(project, controller) else [d for d in project.distros if generation(d) == 1]
        types = [_type(project, kind, distro) for distro in distros] if kind else []
        given = given_values(controller.parameters)
        nodes.append(tuple(_controller(project, controller, type_, given) for type_ in types if type_))
    nodes += [tuple(_node(project, node, distro) for distro in ros2) for node in controllers.nodes]
    return tuple(readers for readers in nodes if readers)


def _type(project: Project, name: str, distro: str) -> ControllerType | None:
    """The type in a distro, from the catalogue or from a package of the workspace that defines its parameters."""
    own = project.own.controllers.get(name)
    if own is not None and "parameters" in own:
        from urdfctl.catalog.reading import controller_type

        return controller_type(own, distro)
    return project.catalog.controller(name, distro)


def type_of(controller: Controller) -> str | None:
    """Return the controller's type if it is a literal string, else None."""
    kind = controller.type
    return kind.text if kind is not None and kind.kind is ValueKind.STRING and kind.is_known else None


def is_of_ros2(project: Project, controller: Controller) -> bool:
    """Return whether a controller is configured in the form of ROS 2; if no file shows it, whether the project is."""
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
    return Reader(
        distro=distro,
        name=manager.name,
        at=manager.at,
        known=known,
        former={},
        given=given,
        located=manager.parameters,
        own=own,
        controllers=names,
    )


def _node(project: Project, node: Controller, distro: str) -> Reader:
    """A node whose parameters the user defines."""
    from urdfctl.catalog.reading import read_parameters

    everywhere = {name: each for name, each in project.catalog.common_parameters(distro).items() if name in _OF_ALL}
    return Reader(
        distro=distro,
        name=node.name,
        at=node.declared_at,
        known={**everywhere, **read_parameters(project.own.nodes[node.name], distro)},
        former={},
        given=given_values(node.parameters),
        located=node.parameters,
        own=node.own,
    )


def _controller(project: Project, controller: Controller, kind: ControllerType, given: Mapping[str, object]) -> Reader:
    known = {**project.catalog.common_parameters(kind.distro), **kind.parameters}
    at = controller.sections[0].at if controller.sections else controller.declared_at
    return Reader(
        distro=kind.distro,
        name=controller.name,
        at=at,
        known=known,
        former=kind.former,
        given=given,
        located=controller.parameters,
        own=controller.own,
        type=kind,
        controller=controller,
    )
