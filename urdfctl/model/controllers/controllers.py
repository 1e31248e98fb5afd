"""The model of controllers in YAML files, for ROS 1 and ROS 2. Several files are combined; each part has its place."""

from __future__ import annotations

import os
from enum import Enum, auto

from urdfctl.model.controllers.parameters import Parameters, Value
from urdfctl.model.node_patterns import PLACEHOLDER, matches
from urdfctl.source.span import Place
from urdfctl.startup.per_object import once_for_the_last
from urdfctl.startup.records import NamedTuple


class FaultKind(Enum):
    """Reasons why ROS rejects a valid YAML file, or loses part of it."""

    ALIAS = auto()
    """ROS 2: an alias; rcl ends the process with 'Will not support aliasing'."""
    EMPTY = auto()
    """A key or an element without a value. ROS 2: 'No value at line'; ROS 1: null cannot be uploaded."""
    EMPTY_COLLECTION = auto()
    """ROS 2: an empty list or map; the node that reads it fails with 'No parameter value set'."""
    MIXED_LIST = auto()
    """ROS 2: a list with elements of several types; 'Sequence should be of same type'."""
    NESTED_LIST = auto()
    """ROS 2: a list in a list; 'Sequences cannot be key'."""
    MAP_IN_LIST = auto()
    """ROS 2: a list of maps; rcl reads the first map instead of the list, and loses the others."""
    OUTSIDE_PARAMETERS = auto()
    """ROS 2: a value outside ros__parameters; 'Cannot have a value before ros__parameters'; `subject` is the key."""
    PARAMETERS_NOT_A_MAP = auto()
    """ROS 2: ros__parameters is a list or a scalar."""
    NODE_NAME = auto()
    """ROS 2: a node name that rmw rejects, or ros__parameters without a node name; `subject` is the name."""
    ROOT = auto()
    """The root of the document is not a map."""
    DOCUMENTS = auto()
    """ROS 1: several documents; roslaunch reads one, 'expected a single document in the stream'."""
    PYTHON_TAG = auto()
    """ROS 2: a value with a tag such as !!python/tuple; rcl ignores it, Python's safe reader rejects it."""
    UNEXPANDED = auto()
    """A value with `${...}`, or `$(...)`, which may have no meaning there; `subject` is its key."""
    LOST_INDENTATION = auto()
    """ROS 2: ros__parameters beside the node's name, not below it; `subject` is the name."""
    OVERFLOW = auto()
    """ROS 1: an integer of more than 32 bits; 'int exceeds XML-RPC limits'."""
    UNUSABLE = auto()
    """ROS 1: a date, or a tag that PyYAML's safe loader does not know."""
    KEY = auto()
    """ROS 1: a key that is not a string, such as a number or a bool."""


class Key(NamedTuple):
    """A key or name in a file, with its place."""

    text: str
    at: Place


class FileFault(NamedTuple):
    """A fault in a file.

    subject: the name that it is about, if any.
    keys: ROS 2: the keys above it, down to ros__parameters.
    """

    kind: FaultKind
    at: Place
    subject: str = ""
    keys: tuple[Key, ...] = ()


class Section(NamedTuple):
    """The parameters that the files give to one node (ROS 2) or one name (ROS 1).

    Sections with the same path, in one or several files, are combined.

    path: the path as the files write it, joined with slashes: `/**/arm`, `robot/arm`.
    at: the last key of the path.
    parameters: the parameters.
    parameters_at: ROS 2: the key `ros__parameters`.
    """

    path: str
    at: Place
    parameters: Parameters
    parameters_at: Place | None = None

    @property
    def name(self) -> str:
        """The last part of the path, without a placeholder before it."""
        last = self.path.rpartition("/")[2]
        return PLACEHOLDER.sub("", last) or last

    @property
    def namespace(self) -> str | None:
        """The namespace: empty at the root, otherwise with a leading slash; None if it contains wildcards, or
        placeholders that a launch file replaces."""
        before = self.path.rpartition("/")[0].strip("/")
        return None if "*" in before or PLACEHOLDER.search(self.path) else f"/{before}" if before else ""

    @property
    def is_shared(self) -> bool:
        """Whether the last part of the path is a wildcard, so that the section is for several nodes."""
        return "*" in self.name

    def names(self, node: str) -> bool:
        """Return whether the section applies to a node.

        node: the full name with a leading slash; the name alone if the namespace is unknown.
        """
        if not node.startswith("/"):
            return self.is_shared or self.name == node
        path = "/" + self.path.lstrip("/")
        return matches(path, node) if self.is_pattern else path == node

    @property
    def is_pattern(self) -> bool:
        """Whether the path has wildcards, or placeholders that a launch file replaces."""
        return any(mark in self.path for mark in "*<{")


class Manager(NamedTuple):
    """A ROS 2 controller manager that the files configure.

    namespace: None if the files do not say; empty at the root.
    at: the key of its section.
    parameters: all parameters that it gets, including those from wildcards.
    own: the parameters from the sections that name it.
    sections: the sections that name it.
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

    namespace: None if the files do not say; empty at the root.
    type: None if not given.
    declared_at: the key under the manager, otherwise that of its section; None if it is started, but in no file.
    parameters: all parameters that it gets, including those from wildcards.
    own: the parameters from the sections that name it.
    sections: the sections that name it.
    under_manager: other parameters under its name in the manager's section, which the controller never reads: all
        except type, params_file and fallback_controllers.
    parameter_files: the values of `params_file`.
    manager: its manager; None if unknown.
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
        """The name with its namespace; the name alone if the namespace is unknown."""
        return self.name if self.namespace is None else f"{self.namespace}/{self.name}"

    @property
    def in_namespace(self) -> str:
        """The name, with its namespace unless that is unknown or the root."""
        return f"{self.namespace}/{self.name}" if self.namespace else self.name


class MoveItController(NamedTuple):
    """A controller that MoveIt sends trajectories to, in moveit_controllers.yaml or ROS 1's `controller_list`.

    name: its entry in `controller_names`.
    section: the key of its section; None if it has none. In ROS 1, its name.
    lacking: required settings that are missing.
    type: None if missing.
    joints: the joints that MoveIt sends to it.
    first: place of its first setting; None if it has none.
    action: its action namespace; None if missing.
    type_at: place of the type; None if missing.
    joints_at: place of the list of joints; None if missing.
    """

    name: Key
    section: Key | None
    lacking: tuple[str, ...]
    type: str | None
    joints: tuple[Key, ...]
    first: Place | None
    action: Key | None = None
    type_at: Place | None = None
    joints_at: Place | None = None


class MoveItList(NamedTuple):
    """A list of joints in a MoveIt file for ROS 1.

    controller: the entry of `controller_list` that has the joints; None for the joints in `joint_limits`.
    joints: the joints.
    """

    controller: str | None
    joints: tuple[Key, ...]


class FileReference(NamedTuple):
    """A reference to a file.

    text: the reference as written.
    path: path of the file; None if only the running system knows it.
    exists: whether the file exists; None if it was not looked up.
    nearest: the similar name of a file beside one that does not exist; empty if there is none.
    """

    text: str
    at: Place
    path: str | None
    exists: bool | None
    nearest: str = ""


class ControllersFile(NamedTuple):
    """One YAML file.

    form: the ROS generation that it is written for, 1 or 2; None if unknown.
    is_moveit: it lists controllers for MoveIt, and is not checked as a controller file.
    readable: False if it is not valid YAML.
    faults: reasons why ROS rejects it, or loses part of it.
    told_by: the keys that show its form: ros__parameters, the manager's, or typed controllers of ROS 1.
    empty: it has no content.
    """

    path: str
    at: Place
    form: int | None
    is_moveit: bool = False
    readable: bool = True
    faults: tuple[FileFault, ...] = ()
    told_by: tuple[Key, ...] = ()
    empty: bool = False


class Controllers(NamedTuple):
    """The combined content of all controller files of a robot. Later files override earlier ones.

    others: sections that no manager or controller in these files reads: other nodes, or a misspelt name.
    references: the files that the robot or a launch file names.
    whole: False if a launch file may load files that could not be determined.
    moveit_lists: joints that MoveIt files for ROS 1 list.
    nodes: other nodes whose parameters the user defines.
    shared: ROS 2: the sections for several nodes, with a wildcard as the last part of the path.
    absent: ROS 2: the files that `params_file` of a controller names and that do not exist, with the controller's name.
    """

    files: tuple[ControllersFile, ...]
    managers: tuple[Manager, ...] = ()
    controllers: tuple[Controller, ...] = ()
    others: tuple[Section, ...] = ()
    references: tuple[FileReference, ...] = ()
    whole: bool = True
    moveit_lists: tuple[MoveItList, ...] = ()
    nodes: tuple[Controller, ...] = ()
    shared: tuple[Section, ...] = ()
    absent: tuple[tuple[str, FileReference], ...] = ()

    @property
    def complete(self) -> bool:
        """Whether every file is known and readable. If not, no rule may report that something is missing.

        A reference that cannot be read, with the name of a file that was read, is taken for an installed copy of it.
        """
        if not self.whole or not all(file.readable for file in self.files):
            return False
        names = {os.path.basename(file.path) for file in self.files}
        return all(each.exists or os.path.basename(each.text.strip()) in names for each in self.references)

    @property
    def faults(self) -> tuple[FileFault, ...]:
        """The faults of all files."""
        return tuple(fault for file in self.files for fault in file.faults)

    def controller(self, name: str) -> Controller | None:
        """Return the first controller with a name, if any.

        name: the name, with or without its namespace; with a leading slash, the full name.
        """
        same = _by_name(self.controllers).get(name.rpartition("/")[2], ())
        if name.startswith("/"):
            return next((c for c in same if c.full_name == name), None)
        return next((c for c in same if f"/{c.full_name}".endswith(f"/{name}")), None)

    def other(self, name: str) -> Section | None:
        """Return the first of the `others` with a name, if any."""
        return next((section for section in self.others if section.name == name), None)


@once_for_the_last
def _by_name(controllers: tuple[Controller, ...]) -> dict[str, list[Controller]]:
    """The controllers by their names without a namespace."""
    named: dict[str, list[Controller]] = {}
    for controller in controllers:
        named.setdefault(controller.full_name.rpartition("/")[2], []).append(controller)
    return named
