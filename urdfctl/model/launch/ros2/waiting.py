"""Event handlers whose event never comes, and what they would start."""

from __future__ import annotations

from collections.abc import Sequence

from urdfctl.model.launch import Node, Spawn, Started, Waiting
from urdfctl.model.launch.ros2.nodes import Nodes
from urdfctl.source.launch.terms import Called, Constant, Items, Perhaps, Term
from urdfctl.startup.records import NamedTuple


class _Handled(NamedTuple):
    """What an event handler starts: after which event of what action."""

    target: Called
    event: Called
    spawns: tuple[Spawn, ...]
    nodes: tuple[Node, ...]


class Handlers:
    """The event handlers of a launch file, and the actions that run."""

    def __init__(self) -> None:
        self.never: list[Node] = []
        """The nodes that never start."""
        self._acted: set[int] = set()
        """The identities of the terms of all actions that run, or may run with other arguments."""
        self._has_callbacks = False
        """Whether a function that is not followed may start actions."""
        self._handled: list[_Handled] = []

    def acts(self, term: Called) -> None:
        """Note an action that runs."""
        self._acted.add(id(term))

    def may_start(self, term: Term | None) -> None:
        """Note the actions in something that is not followed, such as a handler of an event that is rare."""
        if isinstance(term, Called):
            self._acted.add(id(term))
            for inner in (*term.arguments, *term.keywords.values(), *term.added):
                self.may_start(inner)
        elif isinstance(term, Items):
            for inner in term.values:
                self.may_start(inner)
        elif isinstance(term, Perhaps):
            self.may_start(term.term)
        elif not (term is None or isinstance(term, Constant)):
            self._has_callbacks = True

    def handles(self, event: Called, target: Called, spawns: Sequence[Spawn], nodes: Sequence[Node]) -> None:
        """Note what a handler of a target's event starts."""
        self._handled.append(_Handled(target, event, tuple(spawns), tuple(nodes)))

    def waiting(self, nodes: Nodes, *, complete: bool) -> tuple[Waiting, ...]:
        """Return what waits for an event that never comes: the exit of a program that runs until the launch ends, or an
        event of an action that is not part of the launch.

        complete: whether all actions are known.
        """
        found = []
        for each in self._handled:
            is_started = id(each.target) in self._acted
            is_endless = each.event.short == "OnProcessExit" and nodes.lasts(each.target)
            if (is_started and not is_endless) or not (is_started or (complete and not self._has_callbacks)):
                continue
            programs = [node for node in each.nodes if not nodes.is_spawner(node.package, node.executable)]
            self.never += programs
            what = [Started("spawner", tuple(name for name, _ in spawn.names)) for spawn in each.spawns]
            what += [Started(node.executable.text) for node in programs]
            if what:
                target = nodes.started(each.target)
                found.append(Waiting(tuple(what), target, each.event.at, each.event.short, is_started))
        return tuple(found)
