"""Which controllers' files belong to a robot: those named beside it, those its plugins name, and those that a launch
file loads."""

from __future__ import annotations

import os
from collections.abc import Iterable, Iterator
from collections.abc import Sequence as Several

from urdfctl.model.build_controllers import Loaded, controllers_of, form_of
from urdfctl.model.controllers import Controllers, FileReference, MoveItController, MoveItList
from urdfctl.model.launch import Launch
from urdfctl.model.robot import Robot
from urdfctl.record import NamedTuple
from urdfctl.source.files import FileProblem, Files
from urdfctl.source.problem import Problem, ProblemKind
from urdfctl.source.span import Place, SourceText
from urdfctl.source.yaml import Mapping, Scalar, Sequence, YamlFile, read_yaml

_MOST_BYTES_WITH_TABS = 1 << 20
_OF_MOVEIT, _MOVEIT = "ros2_controllers.yaml", "moveit_controllers.yaml"
_LISTED = ("controller_list", "joint_limits")
_NOT_TOLD = (ProblemKind.FILE_NOT_FOUND, ProblemKind.OUTSIDE_WORKSPACE)
"""A file that something names and that is not there is a fact of what names it; rules tell it."""


class Read(NamedTuple):
    """The files that were read, those that the robot or a launch file names, and what was wrong with any of them. Not
    `whole`: a launch file may load more."""

    files: tuple[Loaded, ...]
    references: tuple[FileReference, ...]
    problems: tuple[Problem, ...]
    whole: bool = True
    moveit: tuple[MoveItController, ...] = ()
    moveit_lists: tuple[MoveItList, ...] = ()

    @property
    def form(self) -> int | None:
        """The generation of ROS that the files are written for; None where they do not tell it, or disagree."""
        forms = {form for loaded in self.files if (form := form_of(loaded.yaml)) is not None}
        return forms.pop() if len(forms) == 1 else None

    def model(self, ros: int | None, started: Several[str] | None) -> Controllers:
        """What the files say to a generation of ROS."""
        made = controllers_of(self.files, ros, started, self.references)
        return made._replace(whole=self.whole, moveit=self.moveit, moveit_lists=self.moveit_lists)


def read_controllers(paths: Iterable[str], robot: Robot | None, launch: Launch | None, files: Files) -> Read | None:
    """The files of some paths, those that the robot's ros2_control plugins name in `<parameters>`, and those that a
    launch file loads; None where there are none."""
    reader = _Reader(files)
    for text, at in _named_by(robot):
        reader.reference(text, at)
    for load in launch.loads if launch else ():
        if not load.sure or load.namespace is None or load.file.path is None:
            reader.whole = False
        else:
            reader.load(load.file, load.namespace, in_node=load.in_node)
    for path in map(os.path.abspath, paths):
        reader.named(path)
    return reader.read()


def listed_joints(path: str, files: Files) -> Iterator[tuple[str, Place]]:
    """The joints in `controller_joint_names` of a file, each with its place."""
    try:
        documents = read_yaml(files.read(path)).documents
    except FileProblem:
        return
    for document in documents:
        names = document.get("controller_joint_names") if isinstance(document, Mapping) else None
        for item in names.items if isinstance(names, Sequence) else ():
            if isinstance(item, Scalar):
                yield item.text, item.at


class _Reader:
    def __init__(self, files: Files) -> None:
        self.files = files
        self.whole = True
        self._trees: dict[str, YamlFile] = {}
        self._loaded: list[Loaded] = []
        self._references: list[FileReference] = []
        self._problems: list[Problem] = []

    def read(self) -> Read | None:
        used = {loaded.yaml.source.path for loaded in self._loaded}
        problems = [p for path, tree in self._trees.items() if path in used for p in tree.problems]
        told = tuple(self._moveit(used)), tuple(self._moveit_lists())
        found = Read(tuple(self._loaded), tuple(self._references), (*self._problems, *problems), self.whole, *told)
        return found if found.files or found.references or found.problems or not self.whole else None

    def _moveit(self, used: Iterable[str]) -> Iterator[MoveItController]:
        """What is configured for MoveIt beside one of the files, as its setup assistant and its builder have it."""
        for folder in sorted({os.path.dirname(path) for path in used if os.path.basename(path) == _OF_MOVEIT}):
            path = os.path.join(folder, _MOVEIT)
            if os.path.isfile(path):
                from urdfctl.model.moveit import moveit_controllers

                try:
                    yield from moveit_controllers(self._tree(path))
                except FileProblem:
                    continue

    def _moveit_lists(self) -> Iterator[MoveItList]:
        """What the files that are loaded tell ROS 1's MoveIt; each once, though several nodes may load it."""
        for loaded in {loaded.yaml.source.path: loaded for loaded in self._loaded}.values():
            if any(isinstance(one, Mapping) and any(map(one.get, _LISTED)) for one in loaded.yaml.documents):
                from urdfctl.model.moveit import moveit_lists

                yield from moveit_lists(loaded.yaml, loaded.namespace)

    def named(self, path: str) -> None:
        """A file that the user names: it has to be there."""
        try:
            tree = self._tree(path)
        except FileProblem as error:
            self._problems.append(error.at(Place(SourceText(path, b""), 0, end=0)))
        else:
            if not any(loaded.yaml is tree for loaded in self._loaded):
                self._loaded.append(Loaded(tree))

    def reference(self, text: str, at: Place) -> None:
        """A file that a plugin names: only an absolute path is the same wherever the simulator runs."""
        if not os.path.isabs(text) or "$" in text:
            self._references.append(FileReference(text, at, None, exists=None))
            return
        tree, exists = self._existing(text, at)
        self._references.append(FileReference(text, at, tree.source.path if tree else text, exists))
        if tree is not None:
            self._loaded.append(Loaded(tree))

    def load(self, file: FileReference, namespace: str, *, in_node: bool) -> None:
        """A file that a launch file loads: of those for a single node only what has controllers is kept."""
        tree, exists = self._existing(file.path or "", file.at)
        self._references.append(file._replace(exists=exists))
        if tree is not None and not (in_node and form_of(tree) is None):
            self._loaded.append(Loaded(tree, namespace))

    def _existing(self, path: str, at: Place) -> tuple[YamlFile | None, bool | None]:
        try:
            return self._tree(path), True
        except FileProblem as error:
            if error.kind not in _NOT_TOLD:
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


def _named_by(robot: Robot | None) -> Iterator[tuple[str, Place]]:
    for plugin in robot.plugins if robot else ():
        if "ros2_control" in (plugin.filename or ""):
            for tag in plugin.tag.named("parameters"):
                if tag.text:
                    yield tag.text, tag.at.content
