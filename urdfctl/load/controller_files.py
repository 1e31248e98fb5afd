"""Read the controller files of a robot: those named with it, those its plugins name, and those a launch file loads."""

from __future__ import annotations

import os
from collections.abc import Collection, Iterable, Iterator
from collections.abc import Sequence as Several

from urdfctl.load.inline_parameters import inline_tree
from urdfctl.load.near_files import file_near
from urdfctl.model.controllers import Controllers, FileReference, MoveItList, ValueKind
from urdfctl.model.controllers.build_controllers import Loaded, controllers_of
from urdfctl.model.controllers.controller_forms import form_of
from urdfctl.model.launch import GivenParameters, InlineParameters, Launch, ParameterLoad, Rewriting, joined
from urdfctl.model.launch.robot_homes import strays
from urdfctl.model.robot import Robot
from urdfctl.source.disk.files import FileProblem, Files
from urdfctl.source.disk.gate import admits, is_file
from urdfctl.source.disk.shown import current_folder
from urdfctl.source.opaque import UNKNOWN
from urdfctl.source.problem import Problem, ProblemKind
from urdfctl.source.span import Place, SourceText
from urdfctl.source.workspaces.packages import package_around
from urdfctl.source.xml.dom import Document
from urdfctl.source.yaml.replacing import below, with_replacements, with_values
from urdfctl.source.yaml.tree import Mapping, Node, Scalar, Sequence, YamlFile, read_yaml
from urdfctl.startup.records import NamedTuple

_MOST_BYTES_WITH_TABS = 1 << 20
_DEEPEST = 6
_LISTED = ("controller_list", "joint_limits")
_REPORTED_BY_RULES = (ProblemKind.FILE_NOT_FOUND, ProblemKind.OUTSIDE_WORKSPACE)
"""Rules report a missing file at the place that names it."""


class ControllerFiles(NamedTuple):
    """The controller files of a robot.

    files: those that were read.
    references: the places in the robot or a launch file that name a file.
    problems: the errors of reading them.
    whole: False if a launch file may load more files.
    moveit_lists: the lists that ROS 1's MoveIt reads.
    """

    files: tuple[Loaded, ...]
    references: tuple[FileReference, ...]
    problems: tuple[Problem, ...]
    whole: bool = True
    moveit_lists: tuple[MoveItList, ...] = ()

    @property
    def form(self) -> int | None:
        """Return the ROS generation that the files are written for; None if that is unknown or differs."""
        forms = {form for loaded in self.files if (form := form_of(loaded.yaml)) is not None}
        return forms.pop() if len(forms) == 1 else None

    def model(self, ros: int | None, started: Several[str] | None, nodes: Iterable[str] = ()) -> Controllers:
        """Return the controllers as a ROS generation reads the files.

        started: the names of the controllers that are started; None if unknown.
        nodes: the names of other nodes that are checked.
        """
        controllers = controllers_of(self.files, ros, started, self.references, nodes)
        absent = tuple(_absent(controllers))
        return controllers._replace(whole=self.whole, moveit_lists=self.moveit_lists, absent=absent)


def _absent(controllers: Controllers) -> Iterator[tuple[str, FileReference]]:
    """The files that `params_file` of a controller names and that do not exist. A relative path depends on the folder
    that the manager is started in: it is looked for beside the file, and in the package around that."""
    for controller in controllers.controllers:
        for value in controller.parameter_files:
            path, folder = value.text, os.path.dirname(value.at.source.path)
            if value.kind is not ValueKind.STRING or UNKNOWN in path or "$" in path or not path:
                continue
            around = {folder, package_around(folder) or folder, current_folder()}
            paths = [os.path.normpath(os.path.join(each, path)) for each in sorted(around)]
            if all(map(admits, paths)) and not any(map(is_file, paths)):
                nearest = next(filter(None, map(file_near, paths)), "")
                yield controller.name, FileReference(path, value.at, paths[0], exists=False, nearest=nearest)


def read_controllers(
    paths: Iterable[str], robot: Robot | None, launch: Launch | None, files: Files
) -> ControllerFiles | None:
    """Return the controller files of a robot; None if there are none.

    paths: files that are named with the robot.
    robot: its ros2_control plugins name files in `<parameters>`.
    launch: its nodes load files.
    """
    reader = _ControllerFileReader(files, is_started=launch is not None)
    for text, at, is_named in _named_by(robot, launch):
        reader.reference(text, at, is_named=is_named)
    loads = _own(launch, reader) if launch else ()
    surely = {_loaded_by(load) for load in loads if load.sure}
    for load in loads:
        if not load.sure and _loaded_by(load) in surely:
            continue  # nothing else than what is loaded anyway
        if not load.sure or load.namespace is None or load.file.path is None:
            reader.whole = False
        else:
            others = _beside(launch) if launch is not None and launch.ros == 1 else ()
            reader.load(load, of_other=launch is not None and launch.is_of_other_node(load), others=others)
    for inline in launch.inline if launch else ():
        reader.contained(inline)
    for given in launch.given if launch else ():
        reader.given(given)
    if loads and not any(load.sure for load in loads):
        reader.possible(loads)
    for path in map(os.path.abspath, paths):
        reader.named(path)
    return reader.read()


def _beside(launch: Launch) -> list[str]:
    """The namespaces of the other robots that are not around the robot's own one."""
    home = launch.description.namespace if launch.description else None
    return [each for each in launch.namespaces_of_others if not f"{home or ''}/".startswith(f"{each}/")]


def _own(launch: Launch, reader: _ControllerFileReader) -> Several[ParameterLoad]:
    """The parameter files that a launch file loads for a robot.

    ROS 1: without those that set parameters in namespaces of no robot, if only another robot lacks parameters.
    """
    own, others = launch.description, launch.namespaces_of_others
    if launch.ros > 1 or own is None or not others:
        return launch.loads
    home, homes = own.namespace or "", {own.namespace or "", *others}
    spaces = [reader.spaces(load) for load in launch.loads]
    strayed = strays(set().union(*spaces), homes, homes)
    pairs = zip(launch.loads, spaces, strict=True)
    return [load for load, names in pairs if not names or any(home in strayed.get(name, homes) for name in names)]


def _loaded_by(load: ParameterLoad) -> tuple[str | None, str | None, Rewriting]:
    """What one load adds that another one does not."""
    return load.file.path, load.namespace, load.rewriting


def _spaces(tree: YamlFile, namespace: str) -> set[str]:
    """The full names of what a file sets when it is loaded into a namespace of ROS 1; a mark for what has no name."""
    keys = (
        entry.key.text for document in tree.documents if isinstance(document, Mapping) for entry in document.entries
    )
    return {joined(namespace, key) for key in keys} or {UNKNOWN}


def _is_in(space: str, namespaces: Collection[str]) -> bool:
    """Whether a full name is one of some namespaces, or below one: `/left/arm_controller` in `/left`."""
    return any(space == each or space.startswith(f"{each}/") for each in namespaces)


def listed_joints(path: str, files: Files) -> Iterator[tuple[str, Place]]:
    """Yield the joints in `controller_joint_names` of a file, each with its place."""
    try:
        documents = read_yaml(files.read(path)).documents
    except FileProblem:
        return
    for document in documents:
        names = document.get("controller_joint_names") if isinstance(document, Mapping) else None
        for item in names.items if isinstance(names, Sequence) else ():
            if isinstance(item, Scalar):
                yield item.text, item.at


def misfit(launch: Launch, robot: Document, files: Files) -> tuple[int, int]:
    """Return how many joints the parameter files of a launch file name that a robot does not have, and how many of its
    joints they do not name."""
    root = robot.documentElement
    known = {joint.attrs.get("name") for joint in root.elements() if joint.tagName == "joint"} if root else set()
    named: set[str] = set()
    for load in launch.loads:
        try:
            documents = read_yaml(files.read(load.file.path)).documents if load.file.path else ()
        except FileProblem:
            continue
        named.update(name for document in documents for name in _joints(document))
    return len(named - known), len(known - named)


def _joints(node: Node, depth: int = 0) -> Iterator[str]:
    """The joints that the controllers in a file name."""
    for entry in node.entries if isinstance(node, Mapping) and depth < _DEEPEST else ():
        if entry.key.text in {"joint", "joints"}:
            items = entry.value.items if isinstance(entry.value, Sequence) else (entry.value,)
            yield from (item.text for item in items if isinstance(item, Scalar))
        else:
            yield from _joints(entry.value, depth + 1)


class _ControllerFileReader:
    def __init__(self, files: Files, *, is_started: bool) -> None:
        self.files = files
        self.is_started = is_started
        self.whole = True
        self._trees: dict[str, YamlFile] = {}
        self._rewritten_files: dict[tuple[str, Rewriting], YamlFile] = {}
        self._loaded: list[Loaded] = []
        self._references: list[FileReference] = []
        self._problems: list[Problem] = []

    def read(self) -> ControllerFiles | None:
        used = {loaded.yaml.source.path for loaded in self._loaded}
        problems = [p for path, tree in self._trees.items() if path in used for p in tree.problems]
        result = ControllerFiles(
            files=tuple(self._loaded),
            references=tuple(self._references),
            problems=(*self._problems, *problems),
            whole=self.whole,
            moveit_lists=tuple(self._moveit_lists()),
        )
        has_file = any(not loaded.inline or form_of(loaded.yaml) is not None for loaded in result.files)
        return result if has_file or result.references or result.problems or not self.whole else None

    def _moveit_lists(self) -> Iterator[MoveItList]:
        """Yield the lists for ROS 1's MoveIt in the loaded files; each file once, though several nodes may load it."""
        for loaded in {loaded.yaml.source.path: loaded for loaded in self._loaded}.values():
            if any(
                isinstance(document, Mapping) and any(map(document.get, _LISTED)) for document in loaded.yaml.documents
            ):
                from urdfctl.model.moveit.build_moveit import moveit_lists

                yield from moveit_lists(loaded.yaml, loaded.namespace)

    def named(self, path: str) -> None:
        """Add a file that the user names. It is a problem if it cannot be read."""
        try:
            tree = self._tree(path)
        except FileProblem as error:
            self._problems.append(error.at(Place(SourceText(path, b""), 0, end=0)))
        else:
            if not any(loaded.yaml.source is tree.source for loaded in self._loaded):
                self._loaded.append(Loaded(tree))

    def reference(self, text: str, at: Place, *, is_named: bool) -> None:
        """Add a file that a plugin names. Only an absolute path does not depend on where the simulator runs.

        is_named: False if the plugin's name lacks ros2_control; then the file counts only if it has controllers.
        """
        is_here = self.is_started or self.files.may_read(text)  # else the path of another machine, and nobody starts it
        if not os.path.isabs(text) or "$" in text or UNKNOWN in text or not is_here:
            if is_named:
                self._references.append(FileReference(text, at, None, exists=None))
            return
        tree, exists = self._existing(text, at)
        if not is_named and (tree is None or form_of(tree) is None):
            return
        near = file_near(text) if exists is False else ""
        self._references.append(FileReference(text, at, tree.source.path if tree else text, exists, near))
        if tree is not None:
            self._loaded.append(Loaded(tree))

    def load(self, load: ParameterLoad, *, of_other: bool = False, others: Collection[str] = ()) -> None:
        """Add a file that a launch file loads. One for a single node is kept only if it may have controllers.

        others: ROS 1: the namespaces of other robots. A file that sets parameters only there is one of these.
        """
        tree, exists = self._existing(load.file.path or "", load.file.at, is_known=load.file.exists is not None)
        if exists is False and load.file.exists is None:
            exists = None  # its path needs an argument
        self._references.append(load.file._replace(exists=exists))
        if tree is not None and all(_is_in(space, others) for space in _spaces(tree, load.namespace or "")):
            return
        if tree is not None and not (load.in_node and (of_other or form_of(tree) is None)):
            self._loaded.append(Loaded(self._rewritten(tree, load.rewriting), load.namespace or "", of_other))

    def spaces(self, load: ParameterLoad) -> set[str]:
        """Return the full names of what a file sets in ROS 1; empty if that is not known."""
        tree = (
            self._existing(load.file.path, load.file.at)[0] if load.file.path and load.namespace is not None else None
        )
        return _spaces(tree, load.namespace or "") if tree is not None else set()

    def _rewritten(self, tree: YamlFile, how: Rewriting) -> YamlFile:
        """A rewritten file: the same one for all nodes that get it so."""
        key = tree.source.path, how
        if key not in self._rewritten_files:
            text = with_replacements(tree, how.texts)
            self._rewritten_files[key] = below(with_values(text, how.values), how.root)
        return self._rewritten_files[key]

    def contained(self, inline: InlineParameters) -> None:
        """Add parameters that a launch file contains; those that depend on a condition may be missing."""
        if not inline.sure:
            self.whole = False
            return
        tree = inline_tree(inline)
        if tree.readable:
            self._loaded.append(Loaded(tree, inline.namespace, inline=True))

    def given(self, given: GivenParameters) -> None:
        """Add parameters that a launch file gives a controller manager in a dict."""
        if given.sure:
            tree = YamlFile(given.at.source, (given.document,), (), ())
            self._loaded.append(Loaded(tree, inline=True))
        else:
            self.whole = False

    def possible(self, loads: Several[ParameterLoad]) -> None:
        """The only file that a launch file may load, if there is no other; it is not known whether it is loaded."""
        files = {load.file.path for load in loads}
        if len(files) == 1 and None not in files and loads[0].namespace is not None:
            self.load(loads[0])

    def _existing(self, path: str, at: Place, *, is_known: bool = True) -> tuple[YamlFile | None, bool | None]:
        """A file and whether it exists. That it cannot be read is a problem only if its path is known to be this."""
        try:
            return self._tree(path), True
        except FileProblem as error:
            if error.kind not in _REPORTED_BY_RULES and is_known:
                self._problems.append(error.at(at))
            return None, False if error.kind is ProblemKind.FILE_NOT_FOUND else None

    def _tree(self, path: str) -> YamlFile:
        source = self.files.read(path)
        if source.path not in self._trees:
            tree = read_yaml(source)
            if b"\t" in source.data[:_MOST_BYTES_WITH_TABS] and form_of(tree) == 1:
                tree = read_yaml(source, by_python=True)
            self._trees[source.path] = tree
        return self._trees[source.path]


def _named_by(robot: Robot | None, launch: Launch | None) -> Iterator[tuple[str, Place, bool]]:
    """The files in `<parameters>` of plugins, each with its place and whether the plugin is named after ros2_control.

    No plugin is loaded if the launch file starts a controller manager, and no simulator.
    """
    if launch is not None and launch.runs_without_simulator:
        return
    for plugin in robot.plugins if robot else ():
        is_named = "ros2_control" in (plugin.filename or "")
        for tag in plugin.tag.named("parameters"):
            if tag.text and (is_named or tag.text.strip().endswith((".yaml", ".yml"))):
                yield tag.text, tag.at.content, is_named
