"""What the files say that should run: one start, its managers, controllers, descriptions and nodes."""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from typing import Any

from urdfctl.compare.changes import changes
from urdfctl.compare.snapshot import without
from urdfctl.compare.tree import TreeNode, node_of
from urdfctl.control.hardware.simulator_plugins import control_plugins, namespace_of
from urdfctl.control.parameters.given import given_values
from urdfctl.lint.job import Work
from urdfctl.load.loader import LoadedTarget, Loader
from urdfctl.load.target import Target
from urdfctl.model.controllers import Controller
from urdfctl.model.launch import Launch, Spawn
from urdfctl.model.project import Project
from urdfctl.source.opaque import is_known
from urdfctl.source.span import Place
from urdfctl.startup.records import NamedTuple

_MOST_ARGUMENTS = 6
_MANAGER = "controller_manager"
_PUBLISHER = "robot_state_publisher"


class ExpectedController(NamedTuple):
    """A controller that the files declare or spawn.

    manager: the full name of its manager.
    state: `active` or `inactive` if a launch file spawns it; empty if nothing is known to start it.
    parameters: those of its sections, by full dotted name.
    at: the place that declares it, as file:line:column.
    """

    name: str
    manager: str
    state: str
    type: str | None
    parameters: Mapping[str, Any]
    at: str

    @property
    def node(self) -> str:
        """The full name of its node."""
        return f"{self.manager.rpartition('/')[0]}/{self.name}"


class Expectation(NamedTuple):
    """What one launch file starts, or one robot with its controllers needs.

    launch: the launch file; empty if there is none.
    robot: the file of the description.
    namespace: that of the description.
    managers: the full names of the controller managers.
    settings: the parameters of managers, by their full name.
    controllers: of all managers.
    tree: the description.
    open: the addresses of values that depend on arguments of the launch file.
    joints: the joints that move.
    nodes: the full names of other nodes with a known name.
    state_publishers: those of the nodes that publish transforms of the joint states.
    complete: whether the launch file is wholly known.
    """

    launch: str
    robot: str
    namespace: str
    managers: tuple[str, ...]
    settings: Mapping[str, Mapping[str, Any]]
    controllers: tuple[ExpectedController, ...]
    tree: TreeNode
    open: frozenset[str]
    joints: tuple[str, ...]
    nodes: tuple[str, ...]
    state_publishers: tuple[str, ...]
    complete: bool

    def to_json(self) -> dict[str, Any]:
        """Return the expectation as plain data."""
        controllers = [{**each._asdict(), "parameters": dict(each.parameters)} for each in self.controllers]
        plain = {**self._asdict(), "controllers": controllers, "tree": self.tree.to_json(), "open": sorted(self.open)}
        return {**plain, "settings": {name: dict(values) for name, values in self.settings.items()}}

    @classmethod
    def from_json(cls, data: dict[str, Any]) -> Expectation:
        """Return what `to_json` made `data` from."""
        return cls(
            **{
                **data,
                "managers": tuple(data["managers"]),
                "controllers": tuple(ExpectedController(**each) for each in data["controllers"]),
                "tree": TreeNode.from_json(data["tree"]),
                "open": frozenset(data["open"]),
                "joints": tuple(data["joints"]),
                "nodes": tuple(data["nodes"]),
                "state_publishers": tuple(data["state_publishers"]),
            }
        )


def expectation_work(work: Work) -> dict[str, Any]:
    """Return what is expected of a target, in a worker; `expected` is None without a description."""
    loaded = work.loader.load(work.target)
    found = expectation_of(loaded, work.loader, work.target, work.details["roots"])
    return {"expected": found and found.to_json()}


def expectation_of(loaded: LoadedTarget, loader: Loader, target: Target, roots: Sequence[str]) -> Expectation | None:
    """Return what is expected of a loaded target; None without a description.

    roots: the folders whose paths are left out of texts, the innermost first.
    """
    project, launch = loaded.project, loaded.project.launch
    if loaded.root is None or project.robot is None:
        return None
    tree = node_of(loaded.root, lambda text: without(text, roots))
    managers = _managers(project)
    return Expectation(
        launch=launch.path if launch else "",
        robot=project.path,
        namespace=(launch.description.namespace or "") if launch and launch.description else "",
        managers=tuple(managers),
        settings=dict(_settings(project, launch)),
        controllers=tuple(_controllers(project, managers)),
        tree=tree,
        open=_open(tree, project, loader, target, roots),
        joints=tuple(joint.name for joint in project.robot.joints if joint.moves and joint.name and not joint.mimic),
        nodes=tuple(name for name, _ in _nodes(launch)) if launch else (),
        state_publishers=tuple(name for name, is_it in _nodes(launch) if is_it) if launch else (),
        complete=project.complete and (launch is None or launch.complete),
    )


def _managers(project: Project) -> dict[str, None]:
    """The full names of the managers that are started, or that the spawners ask for."""
    launch = project.launch
    found: dict[str, None] = {}
    for node in launch.nodes if launch else ():
        if node.sure and node.runs(_MANAGER, "ros2_control_node") and node.namespace is not None:
            found[f"{node.namespace}/{node.name or _MANAGER}"] = None
    for plugin in control_plugins(project) if launch and launch.simulations else ():
        setting = plugin.setting("ros/namespace")
        namespace = namespace_of(setting.text) if setting else ""
        name = plugin.setting("controller_manager_name")
        found.setdefault(f"{namespace}/{name.text.strip() if name else _MANAGER}")
    for spawn in launch.spawns if launch else ():
        if spawn.sure and spawn.namespace is not None and spawn.manager is not None:
            found.setdefault(f"{spawn.namespace}/{spawn.manager}")
    home = (launch.description.namespace or "") if launch and launch.description else ""
    own = {name: None for name in found if name.rpartition("/")[0] == home}
    if not found and not project.controllers and not (project.robot and project.robot.ros2_controls):
        return {}
    return own or found or {f"{home}/{_MANAGER}" if project.ros == 1 else f"/{_MANAGER}": None}


def _settings(project: Project, launch: Launch | None) -> Iterator[tuple[str, dict[str, Any]]]:
    """The parameters of managers from files, without those that a launch file overrides."""
    nodes = launch.nodes if launch else ()
    overridden = {word.text for node in nodes if node.runs(_MANAGER) for word in node.parameters}
    for each in project.controllers.managers if project.controllers else ():
        values = given_values(each.parameters)
        known = {name: value for name, value in values.items() if _is_plain(value) and name not in overridden}
        yield f"{each.namespace or ''}/{each.name}", known


def _controllers(project: Project, managers: Mapping[str, None]) -> Iterator[ExpectedController]:
    spawned = dict(_spawned(project.launch)) if project.launch else {}
    declared = project.controllers.controllers if project.controllers else ()
    known: set[tuple[str, str]] = set()
    for controller in declared:
        if controller.declared_at is None and not spawned:
            continue
        for manager in _managers_of(controller, managers):
            if (manager, controller.name) not in known:
                known.add((manager, controller.name))
                state = spawned.get((manager, controller.name), ("", None))[0]
                yield _expected(controller, manager, state)
    for (manager, name), (state, at) in spawned.items():
        if (manager, name) not in known and at is not None:
            yield ExpectedController(name=name, manager=manager, state=state, type=None, parameters={}, at=_shown(at))


def _managers_of(controller: Controller, managers: Mapping[str, None]) -> list[str]:
    own = [name for name in managers if controller.namespace in (None, name.rpartition("/")[0])]
    return own or [f"{controller.namespace or ''}/{_MANAGER}"]


def _expected(controller: Controller, manager: str, state: str) -> ExpectedController:
    known = {name: value for name, value in given_values(controller.parameters).items() if _is_plain(value)}
    kind = controller.type.text if controller.type and is_known(controller.type.text) else None
    place = controller.declared_at or (controller.sections[0].at if controller.sections else None)
    return ExpectedController(
        name=controller.name,
        manager=manager,
        state=state,
        type=kind,
        parameters=known,
        at=_shown(place) if place else "",
    )


def _is_plain(value: object) -> bool:
    return all(map(_is_plain, value)) if isinstance(value, list) else not isinstance(value, str) or is_known(value)


def _spawned(launch: Launch) -> Iterator[tuple[tuple[str, str], tuple[str, Place | None]]]:
    for spawn in launch.spawns:
        if spawn.sure and spawn.manager is not None and spawn.namespace is not None:
            for name, at in spawn.names:
                if is_known(name):
                    yield (f"{spawn.namespace}/{spawn.manager}", name), (_state(spawn), at)


def _state(spawn: Spawn) -> str:
    return "active" if spawn.active else "inactive"


def _nodes(launch: Launch) -> Iterator[tuple[str, bool]]:
    """The nodes with a known name, and whether each publishes the transforms of links."""
    for node in launch.nodes:
        is_it = node.runs(_PUBLISHER, _PUBLISHER)
        name = node.name or (node.executable.text if is_it else "")
        if node.sure and name and node.namespace is not None and is_known(name, node.namespace):
            yield f"{node.namespace}/{name}", is_it


def _shown(place: Place) -> str:
    line, column = place.source.position(place.start)
    return f"{place.source.path}:{line}:{column}"


# -- what depends on arguments -----------------------------------------------------------------------------------------


def _open(tree: TreeNode, project: Project, loader: Loader, target: Target, roots: Sequence[str]) -> frozenset[str]:
    """The addresses of what differs if an argument that the launch file passes to xacro has another value."""
    launch = project.launch
    description = launch.description if launch else None
    given = dict((description.arguments or ()) if description else target.arguments)
    found: set[str] = set()
    for name, value in list(given.items())[:_MOST_ARGUMENTS]:
        other = _other(value)
        if other is None:
            continue
        arguments = tuple({**given, name: other}.items())
        loaded = loader.load(Target(project.path, arguments))
        if loaded.root is not None:
            changed = changes(tree, node_of(loaded.root, lambda text: without(text, roots)))
            found.update(change.address for change in changed)
    return frozenset(found)


def _other(value: str) -> str | None:
    """Another value of the same kind; None for a text, which may be a path."""
    if value.lower() in ("true", "false"):
        return "false" if value.lower() == "true" else "true"
    try:
        return repr(float(value) * 2 + 0.37)
    except ValueError:
        return None
