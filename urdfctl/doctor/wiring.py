"""The graph of what is really wired in a running system, with the differences to that of the files as broken parts."""

from __future__ import annotations

from collections.abc import Iterator

from urdfctl.doctor.recording import RecordedController, RecordedHardware, RecordedManager, Recording
from urdfctl.graph.parts import Edge, Graph, GraphNode
from urdfctl.rules.running.running_controller_not_active import running_controller_not_active
from urdfctl.rules.running.running_controller_not_in_files import running_controller_not_in_files
from urdfctl.rules.running.running_controller_not_loaded import running_controller_not_loaded
from urdfctl.rules.running.running_hardware_differs import running_hardware_differs
from urdfctl.rules.running.running_hardware_not_active import running_hardware_not_active
from urdfctl.rules.running.running_parameter_differs import running_parameter_differs
from urdfctl.rules.running.running_part_missing import running_part_missing
from urdfctl.rules.running.running_type_differs import running_type_differs

_CONTROLLERS = ("controller", "broadcaster")
_PARTS = ("command", "hardware", "joint", "state")
_OF_PARAMETERS = ("claims", "reads")
"""The edges that follow from the parameters of a controller."""
_OF_HARDWARE = ("drives", "moves", "measures")


def live_graph(files: Graph, recording: Recording) -> Graph:
    """Return what is wired in a recorded system; a part that differs from the files has the code of its fault."""
    wired = _Wired(files)
    managers = [one for one in recording.managers.values() if one.answers]
    spaces = {node.name.strip("/").rpartition("/")[0] for node in files.nodes if node.kind in _CONTROLLERS}
    for manager in [one for one in managers if one.namespace.strip("/") in spaces] or managers:
        wired.add(manager)
    return files._replace(nodes=tuple(wired.nodes()), edges=tuple(wired.edges()))


class _Wired:
    """The parts of a running system beside those of the files."""

    def __init__(self, files: Graph) -> None:
        self.files = {_key(node): node for node in files.nodes}
        self.ids = {node.id: _key(node) for node in files.nodes}
        self.expected = {(self.ids[edge.source], self.ids[edge.target]): edge for edge in files.edges}
        wires = [pair for pair, edge in self.expected.items() if edge.kind in _OF_HARDWARE]
        self.exported = {end for pair in wires for end in pair}
        self.references: set[str] = set()
        self.lists_states = False
        self.live: dict[str, GraphNode] = {}
        self.wires: dict[tuple[str, str], Edge] = {}

    def add(self, manager: RecordedManager) -> None:
        """Add what a manager lists."""
        names = {name.partition("/")[0] for one in manager.controllers for name in one.commands}
        self.lists_states = self.lists_states or any(one.states for one in manager.controllers)
        for controller in manager.controllers:
            self._controller(manager, controller, is_commanded=controller.name in names)
        for component in manager.hardware:
            self._hardware(component)

    def _node(self, kind: str, name: str, detail: str = "", *, active: bool = True, rule: str = "") -> str:
        key = f"{kind}:{name.strip('/')}"
        meant = self.files.get(key)
        new = GraphNode(meant.id if meant else key, kind, meant.name if meant else name, detail)
        known = self.live.get(key, new._replace(active=False))
        rules = tuple(dict.fromkeys((*known.rules, *([rule] if rule else []))))
        shown = detail or known.detail or (meant.detail if meant else "")
        self.live[key] = known._replace(detail=shown, active=known.active or active, rules=rules)
        return key

    def _edge(self, source: str, target: str, kind: str, *, active: bool) -> None:
        ends = self.live[source].id, self.live[target].id
        self.wires[source, target] = Edge(*ends, kind, active=active)

    def _controller(self, manager: RecordedManager, one: RecordedController, *, is_commanded: bool) -> None:
        name = f"{manager.namespace}/{one.name}".strip("/")
        kinds = [kind for kind in _CONTROLLERS if f"{kind}:{name}" in self.files]
        kind = kinds[0] if kinds else "controller" if one.commands or is_commanded else "broadcaster"
        active = one.state == "active"
        key = self._node(kind, name, one.type, active=active, rule=self._rule_of(f"{kind}:{name}", one))
        for interface in one.commands:
            target = self._node("command", interface, interface.rpartition("/")[2], active=interface in one.claimed)
            self._edge(key, target, "claims", active=interface in one.claimed)
        for interface in one.states:
            source = self._node("state", interface, interface.rpartition("/")[2], active=active)
            self._edge(source, key, "reads", active=active)
        for interface in one.references:
            source = self._node("command", interface, interface.rpartition("/")[2], active=active)
            self._edge(source, key, "commands", active=active)
            self.references.add(source)

    def _rule_of(self, key: str, one: RecordedController) -> str:
        """The code of the difference between a controller and that of the files; empty if there is none."""
        meant = self.files.get(key)
        if meant is None:
            return running_controller_not_in_files.code
        if meant.detail and one.type and meant.detail != one.type:
            return running_type_differs.code
        return running_controller_not_active.code if meant.active and one.state != "active" else ""

    def _hardware(self, one: RecordedHardware) -> None:
        active = one.state in ("active", "")
        meant = self.files.get(f"hardware:{one.name}")
        is_other = meant is not None and meant.detail and one.plugin and meant.detail != one.plugin
        rule = running_hardware_differs.code if is_other else "" if active else running_hardware_not_active.code
        for interface in one.commands:
            key = self._node("hardware", one.name, one.plugin, active=active, rule=rule)
            command = self._node("command", interface, interface.rpartition("/")[2], active=False)
            joint = self._node("joint", interface.rpartition("/")[0], active=active)
            self._edge(command, key, "drives", active=active)
            self._edge(key, joint, "moves", active=active)
        for interface in one.states:
            state = self._node("state", interface, interface.rpartition("/")[2], active=False)
            joint = self._node("joint", interface.rpartition("/")[0], active=active)
            self._edge(joint, state, "measures", active=active)

    # -- the result ----------------------------------------------------------------------------------------------------

    def nodes(self) -> Iterator[GraphNode]:
        """Yield the nodes of both, those of the files first, in their order."""
        for key, meant in self.files.items():
            live = self.live.get(key)
            if live is not None:
                yield live
            elif meant.kind in _CONTROLLERS:
                rules = (running_controller_not_loaded.code,) if meant.active else ()
                yield meant._replace(active=False, rules=rules)
            elif meant.kind in _PARTS:
                is_missing = self.live and key in self.exported and self._is_sure(key)
                rules = (running_part_missing.code,) if is_missing else ()
                yield meant._replace(active=False, rules=rules)
            else:
                yield meant._replace(active=self._is_served(key), rules=())
        for key, live in self.live.items():
            if key not in self.files:
                is_part = live.kind in _PARTS and not live.rules and key not in self.references
                yield live._replace(rules=(running_part_missing.code,)) if is_part else live

    def _is_sure(self, key: str) -> bool:
        """Whether a part of the files should be there: hardware may measure less than a driver could."""
        kind, _, name = key.partition(":")
        return kind != "state" or f"joint:{name.rpartition('/')[0]}" not in self.live

    def _is_served(self, key: str) -> bool:
        """Whether a controller that runs reads or publishes a topic."""
        ends = {end for pair in self.expected if key in pair for end in pair}
        return any(end in self.live and self.live[end].active for end in ends)

    def edges(self) -> Iterator[Edge]:
        """Yield the edges of both."""
        broken = {node.id for node in self.nodes() if node.rules}
        active = {node.id for node in self.nodes() if node.active}
        for pair, edge in {**self.expected, **self.wires}.items():
            ends = {edge.source, edge.target}
            if pair in self.wires and pair in self.expected:
                yield edge
            elif self._is_difference(pair, edge) and not ends & broken:
                yield edge._replace(active=ends <= active, rules=_code_of(edge))
            else:
                yield edge._replace(active=ends <= active, rules=())

    def _is_difference(self, pair: tuple[str, str], edge: Edge) -> bool:
        """Whether an edge that only one side has is one: a broadcaster may read more than the files show, and not
        every recording lists what is read."""
        if edge.kind == "reads":
            return self.lists_states and pair in self.expected and pair[0] in self.live
        if edge.kind == "measures":
            return False
        return bool(self.live) and edge.kind in ("claims", *_OF_HARDWARE)


def _code_of(edge: Edge) -> tuple[str, ...]:
    return (running_parameter_differs.code if edge.kind in _OF_PARAMETERS else running_part_missing.code,)


def _key(node: GraphNode) -> str:
    return f"{node.kind}:{node.name.strip('/')}"
