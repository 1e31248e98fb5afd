"""What a launch file is known to do with a robot and its controllers: static facts, each with its place."""

from __future__ import annotations

from typing import NamedTuple

from urdfctl.model.controllers import FileReference
from urdfctl.source.span import Place

# `sure` is False where a condition that is not known decides; a namespace is empty at the root, and None where it is
# not known


class Description(NamedTuple):
    """A robot description that is put on the parameter server: its URDF or xacro file, and the `arguments` for xacro,
    None where one of them is not known."""

    file: FileReference
    arguments: tuple[tuple[str, str], ...] | None
    namespace: str | None
    at: Place
    sure: bool = True


class ParameterLoad(NamedTuple):
    """A YAML file whose parameters are loaded below a namespace; `in_node`: below a node's own name."""

    file: FileReference
    namespace: str | None
    at: Place
    sure: bool = True
    in_node: bool = False


class Spawn(NamedTuple):
    """A spawner: the controllers it names, each with its place, and the namespace of their manager. Not `active`: they
    are loaded, not started; not `complete`: what it is given is not all known."""

    names: tuple[tuple[str, Place], ...]
    namespace: str | None
    at: Place
    active: bool = True
    sure: bool = True
    complete: bool = True


class Launch(NamedTuple):
    """One launch file, with all that it includes. Not `complete`: an included file could not be read, so something may
    be done that is not listed."""

    path: str
    ros: int
    descriptions: tuple[Description, ...] = ()
    loads: tuple[ParameterLoad, ...] = ()
    spawns: tuple[Spawn, ...] = ()
    complete: bool = True

    @property
    def started(self) -> tuple[str, ...] | None:
        """The controllers that are started together, with their namespaces where they are known; None where not all of
        them are known, or there are none."""
        if not self.complete or not self.spawns or not all(spawn.sure and spawn.complete for spawn in self.spawns):
            return None
        return tuple(dict.fromkeys(_full(name, s) for s in self.spawns if s.active for name, _ in s.names))

    @property
    def description(self) -> Description | None:
        """The one robot that is surely described by a file that is there, with known arguments."""
        known = [one for one in self.descriptions if one.sure and one.file.exists and one.arguments is not None]
        return known[0] if len(known) == 1 == len(self.descriptions) else None


def _full(name: str, spawn: Spawn) -> str:
    return name if spawn.namespace is None else f"{spawn.namespace}/{name}"
