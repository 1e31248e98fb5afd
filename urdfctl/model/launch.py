"""What a launch file is known to do with a robot and its controllers: static facts, each with its place."""

from __future__ import annotations

from urdfctl.model.controllers import FileReference
from urdfctl.model.package import Package
from urdfctl.record import NamedTuple
from urdfctl.source.opaque import UNKNOWN
from urdfctl.source.span import Place

# `sure` is False where a condition that is not known decides; a namespace is empty at the root, and None where it is
# not known; a text that is not all known holds UNKNOWN


class Word(NamedTuple):
    """A text with its place: an argument of a program, a name."""

    text: str
    at: Place

    @property
    def known(self) -> str | None:
        """The text; None where it is not all known."""
        return None if UNKNOWN in self.text else self.text


class Description(NamedTuple):
    """A robot description that is put on the parameter server or given to a node: its URDF or xacro file, and the
    `arguments` for xacro, None where one of them is not known.

    `names` are the arguments that are given, known or not; `command` is the command that makes it, where one does;
    `node` the executable that is given it, None for the parameter server.
    """

    file: FileReference
    arguments: tuple[tuple[str, str], ...] | None
    namespace: str | None
    at: Place
    sure: bool = True
    names: tuple[Word, ...] = ()
    command: str | None = None
    node: str | None = None


class ParameterLoad(NamedTuple):
    """A YAML file whose parameters are loaded below a namespace; `in_node`: below a node's own name. Of ROS 2 the file
    itself names its nodes; `node` is the executable that it is given to."""

    file: FileReference
    namespace: str | None
    at: Place
    sure: bool = True
    in_node: bool = False
    node: str | None = None


class Option(NamedTuple):
    """An option of a program as it is written, and the value that follows it."""

    name: str
    value: Word | None
    at: Place


class Spawn(NamedTuple):
    """A spawner: the controllers it names, each with its place, and the namespace of their manager. Not `active`: they
    are loaded, not started; not `complete`: what it is given is not all known.

    `manager` is the manager's name without namespace, None where it is not known; `program` what is called: `spawner`,
    `spawner.py`, or of `ros2 control` the verb. `files` are the parameter files it is given. `after` are the
    controllers whose spawner ends first.
    """

    names: tuple[tuple[str, Place], ...]
    namespace: str | None
    at: Place
    active: bool = True
    sure: bool = True
    complete: bool = True
    manager: str | None = "controller_manager"
    program: Word | None = None
    options: tuple[Option, ...] = ()
    files: tuple[FileReference, ...] = ()
    after: tuple[str, ...] = ()

    def option(self, *names: str) -> Option | None:
        """The first option of some names."""
        return next((option for option in self.options if option.name in names), None)


class Node(NamedTuple):
    """A node that is started: its package and executable, each with its place; its full namespace; the words it is
    given, the names of its parameters, and of its topics those that are renamed; the files whose parameters it is given
    too. Not `complete`: something that it is given is not known."""

    package: Word
    executable: Word
    name: str | None
    namespace: str | None
    at: Place
    words: tuple[Word, ...] = ()
    parameters: tuple[Word, ...] = ()
    remaps: tuple[tuple[str, str], ...] = ()
    sure: bool = True
    complete: bool = True
    files: tuple[Word, ...] = ()

    def runs(self, package: str, *executables: str) -> bool:
        """Whether it is one of some executables of a package."""
        return self.package.text == package and self.executable.text in executables


class Simulation(NamedTuple):
    """A simulator that is started: `gz` or `gazebo-classic`; `paused` is None where that is not known."""

    simulator: str
    at: Place
    paused: bool | None = None
    sure: bool = True


class Reference(NamedTuple):
    """A file of a package that the launch file uses; `use` says for what: `description`, `parameters`, `include`, or
    another. `package` is its package, None where it is in none that is known."""

    file: FileReference
    use: str
    package: str | None = None
    sure: bool = True


class Launch(NamedTuple):
    """One launch file, with all that it includes. Not `complete`: an included file could not be read, so something may
    be done that is not listed.

    `elsewhere` are the spawners that run only where other arguments are given. `packages` are those that it names,
    `package` is the one that it lies in. `strays` are the arguments given to included files of ROS 1 that have none of
    the name.
    """

    path: str
    ros: int
    descriptions: tuple[Description, ...] = ()
    loads: tuple[ParameterLoad, ...] = ()
    spawns: tuple[Spawn, ...] = ()
    complete: bool = True
    elsewhere: tuple[Spawn, ...] = ()
    nodes: tuple[Node, ...] = ()
    simulations: tuple[Simulation, ...] = ()
    references: tuple[Reference, ...] = ()
    packages: tuple[Word, ...] = ()
    package: Package | None = None
    strays: tuple[Word, ...] = ()

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
        alike = {(one.file.path, frozenset(one.arguments or ()), one.namespace) for one in known}
        return known[0] if len(alike) == 1 and len(known) == len(self.descriptions) else None


def joined(namespace: str, name: str) -> str:
    """A name in a namespace, as launch files join them: empty for the root."""
    if UNKNOWN in name:
        return UNKNOWN
    whole = name if name.startswith("/") else f"{namespace}/{name}"
    return UNKNOWN if UNKNOWN in whole else "".join(f"/{part}" for part in whole.split("/") if part)


def _full(name: str, spawn: Spawn) -> str:
    return name if spawn.namespace is None else f"{spawn.namespace}/{name}"
