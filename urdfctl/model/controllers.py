"""The controllers that YAML files configure: ROS 1 and ROS 2, several files together, each part with its place."""

from __future__ import annotations

import re
from enum import Enum, auto

from urdfctl.model.parameters import Parameters, Value
from urdfctl.record import NamedTuple
from urdfctl.source.span import Place


class FaultKind(Enum):
    """What keeps the real reader from taking a file, or part of it, though it is good YAML."""

    ALIAS = auto()
    """ROS 2: rcl ends the process, 'Will not support aliasing'."""
    EMPTY = auto()
    """ROS 2: a key or an element without a value, 'No value at line'; ROS 1: null cannot be uploaded."""
    EMPTY_COLLECTION = auto()
    """ROS 2: an empty list or map: 'No parameter value set', the node that reads it fails."""
    MIXED_LIST = auto()
    """ROS 2: 'Sequence should be of same type'."""
    NESTED_LIST = auto()
    """ROS 2: 'Sequences cannot be key'."""
    MAP_IN_LIST = auto()
    """ROS 2: rcl takes a list of maps for its first map, and what stands behind that is lost."""
    OUTSIDE_PARAMETERS = auto()
    """ROS 2: 'Cannot have a value before ros__parameters'; `subject` is the key."""
    PARAMETERS_NOT_A_MAP = auto()
    """ROS 2: what stands under ros__parameters is a list or a text."""
    NODE_NAME = auto()
    """ROS 2: a node's name that rmw refuses, or ros__parameters without one; `subject` is the name."""
    ROOT = auto()
    """The document is no map."""
    DOCUMENTS = auto()
    """ROS 1: roslaunch reads one document, 'expected a single document in the stream'."""
    OVERFLOW = auto()
    """ROS 1: 'int exceeds XML-RPC limits': more than 32 bits."""
    UNUSABLE = auto()
    """ROS 1: a date, or a tag that PyYAML's safe loader does not know."""
    KEY = auto()
    """ROS 1: a key that is no text: a number, a bool."""


class Key(NamedTuple):
    """A key of a file."""

    text: str
    at: Place


class Fault(NamedTuple):
    """One of those, with the name it is about, and of ROS 2 the keys above it: as far as ros__parameters."""

    kind: FaultKind
    at: Place
    subject: str = ""
    keys: tuple[Key, ...] = ()


class Section(NamedTuple):
    """The parameters that the files give to one node, or in ROS 1 to one name.

    `path` is as the files write it, joined with slashes: `/**/arm`, `robot/arm`. `at` is the key before the parameters,
    `parameters_at` the `ros__parameters` of ROS 2. Sections of one path in one or several files are one.
    """

    path: str
    at: Place
    parameters: Parameters
    parameters_at: Place | None = None

    @property
    def name(self) -> str:
        """The last part of the path."""
        return self.path.rpartition("/")[2]

    @property
    def namespace(self) -> str | None:
        """Empty at the root, else with a leading slash; None where wildcards stand in it."""
        before = self.path.rpartition("/")[0].strip("/")
        return None if "*" in before else f"/{before}" if before else ""

    @property
    def is_shared(self) -> bool:
        """Whether it names no node, but is meant for many."""
        return "*" in self.name

    def names(self, node: str) -> bool:
        """Whether it speaks of a node: by its full name, or by its name alone where its namespace is not known."""
        if not node.startswith("/"):
            return self.is_shared or self.name == node
        return re.fullmatch(_pattern("/" + self.path.lstrip("/")), node) is not None


def _pattern(path: str) -> str:
    """The regular expression that rclcpp's parameter_map.cpp makes of a path."""
    parts = re.split(r"(/\*\*|/\*)", path)
    wild = {"/**": r"(/\w+)*", "/*": r"(/\w+)"}
    return "".join(wild.get(part) or re.escape(part) for part in parts)


class Manager(NamedTuple):
    """A controller manager of ROS 2 as the files know it: `namespace` is None where they do not tell it.

    `parameters` are all that reach it, `own` those of the sections that name it.
    """

    name: str
    namespace: str | None
    at: Place
    parameters: Parameters
    own: Parameters
    sections: tuple[Section, ...]


class Controller(NamedTuple):
    """A controller that is declared (ROS 2: under the manager; ROS 1: by its type), has a section with a type, or is
    started.

    `namespace` is None where the files do not tell it, and empty at the root. `type` is None where none is given.
    `declared_at` is the key under the manager, else that of its section; None where it is started, and in no file.
    `parameters` are all that reach it, with those of wildcards; `own` those of the `sections` that name it.
    `under_manager` is what else stands at its name under the manager, where the controller never looks:
    all but type, params_file and fallback_controllers.
    """

    name: str
    namespace: str | None
    type: Value | None
    declared_at: Place | None
    parameters: Parameters
    own: Parameters
    sections: tuple[Section, ...] = ()
    under_manager: Parameters = Parameters()
    parameter_files: tuple[Value, ...] = ()
    manager: Manager | None = None

    @property
    def full_name(self) -> str:
        """The name with its namespace, as far as it is known."""
        return self.name if self.namespace is None else f"{self.namespace}/{self.name}"


class MoveItController(NamedTuple):
    """A controller that moveit_controllers.yaml names: its `section`, None where nothing describes it, and what is
    `lacking` of what MoveIt needs to know; `joints` are those that it is sent; `first` is its first setting."""

    name: Key
    section: Key | None
    lacking: tuple[str, ...]
    type: str | None
    joints: tuple[Key, ...]
    first: Place | None


class MoveItList(NamedTuple):
    """The joints that ROS 1's MoveIt is told of: those of a controller in `controller_list`, or, where that is None,
    those that have limits for planning."""

    controller: str | None
    joints: tuple[Key, ...]


class FileReference(NamedTuple):
    """A controllers' file that something names: `path` is where it lies, None where only the running system can tell;
    `exists` whether a file is there, None where nobody looked."""

    text: str
    at: Place
    path: str | None
    exists: bool | None


class ControllersFile(NamedTuple):
    """One YAML file. `form` is 1 or 2 for the generation of ROS that it is written for, None where nothing tells;
    `told_by` are the keys that tell it: ros__parameters, the manager's, those of typed controllers of ROS 1.
    `is_moveit` tells that it lists controllers for MoveIt, and is not judged. Not `readable`: no YAML at all."""

    path: str
    at: Place
    form: int | None
    is_moveit: bool = False
    readable: bool = True
    faults: tuple[Fault, ...] = ()
    told_by: tuple[Key, ...] = ()


class Controllers(NamedTuple):
    """What all files of a robot say together; later ones win.

    `others` are sections that no manager and no controller of these files reads: other nodes, other settings, or a name
    that is misspelt. `references` are the files that the robot itself or a launch file names. Not `whole`: other files
    may be loaded too, by a launch file whose conditions are not known. `moveit` are those that MoveIt, configured
    beside one of the files, sends trajectories to; `moveit_lists` what ROS 1's is told of joints.
    """

    files: tuple[ControllersFile, ...]
    managers: tuple[Manager, ...] = ()
    controllers: tuple[Controller, ...] = ()
    others: tuple[Section, ...] = ()
    references: tuple[FileReference, ...] = ()
    whole: bool = True
    moveit: tuple[MoveItController, ...] = ()
    moveit_lists: tuple[MoveItList, ...] = ()

    @property
    def complete(self) -> bool:
        """Whether every file is known and could be read: else nothing may be claimed to be absent."""
        return self.whole and all(file.readable for file in self.files) and all(r.exists for r in self.references)

    @property
    def faults(self) -> tuple[Fault, ...]:
        """The faults of all files."""
        return tuple(fault for file in self.files for fault in file.faults)

    def controller(self, name: str) -> Controller | None:
        """The controller of a name, which may have a namespace before it; of a full name where a slash begins it."""
        if name.startswith("/"):
            return next((c for c in self.controllers if c.full_name == name), None)
        return next((c for c in self.controllers if f"/{c.full_name}".endswith(f"/{name}")), None)

    def other(self, name: str) -> Section | None:
        """The first other section of a name."""
        return next((section for section in self.others if section.name == name), None)
