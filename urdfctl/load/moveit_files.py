"""Read MoveIt's configuration of a robot: the files that a launch file gives to MoveIt, or those beside its robot."""

from __future__ import annotations

import os
from collections.abc import Callable, Iterator, Mapping, Sequence
from typing import TYPE_CHECKING

from urdfctl.load.expansion.description import expansion_of
from urdfctl.model.controllers import FileReference, MoveItController
from urdfctl.model.launch import Launch
from urdfctl.model.moveit import MoveIt, MoveItFiles, Pipeline, Semantic
from urdfctl.model.moveit.build_moveit import (
    empty_controller_list,
    empty_values,
    limits_of,
    moveit_controllers,
    pipeline_of,
    plugin_of,
    solvers_of,
    unlisted_controllers,
)
from urdfctl.model.moveit.build_semantic import semantic_of
from urdfctl.source.disk.files import FileProblem, Files
from urdfctl.source.disk.gate import is_file, names_in
from urdfctl.source.span import Place, SourceText
from urdfctl.source.xacro.expansion import Expander
from urdfctl.source.yaml.replacing import with_replacements
from urdfctl.source.yaml.tree import YamlFile, read_yaml

if TYPE_CHECKING:
    from urdfctl.source.workspaces.packages import PackageIndex

_ROS_2 = 2
_CONTROLLERS, _OF_MOVEIT = "ros2_controllers.yaml", "moveit_controllers.yaml"
_KINEMATICS, _LIMITS = "kinematics.yaml", "joint_limits.yaml"
_DESCRIPTIONS = (".urdf.xacro", ".urdf", ".xacro")
_PIPELINE = "_planning.yaml"
_PLANNING = "moveit_ros_planning"
"""The package of MoveIt that reads the planning pipelines."""

_Texts = tuple[tuple[str, str], ...]


def read_moveit(
    path: str,
    launch: Launch | None,
    controllers: Sequence[str],
    files: Files,
    expander: Callable[[], Expander],
    *,
    index: PackageIndex,
) -> MoveIt | None:
    """Return MoveIt's configuration of a target; None if there is none.

    path: the robot description, or the file that is linted without one.
    controllers: the controller files that belong to the robot.
    files: reads the YAML files. expander: returns an expander for the SRDF, which may be a xacro file.
    index: the packages of the workspace.
    """
    given = _given(launch) if launch is not None and launch.moveit else None
    found = given or _beside(path, controllers)
    if found is None:
        return None
    loads = launch.loads if launch is not None else ()
    replaced = {load.file.path: load.rewriting.texts for load in loads}
    reader = _MoveItReader(files, expander, replaced)
    moveit = reader.read(found, is_given=given is not None, ros=launch.ros if launch else None)
    is_here = bool(moveit.pipelines) and any(_PLANNING in crawl.packages() for crawl in index.crawls)
    return moveit._replace(is_here=is_here)


def moveit_in(paths: Sequence[str], files: Files, expander: Callable[[], Expander], ros: int) -> MoveIt:
    """Return the configuration in files that a launch file will give to MoveIt, by their names.

    A name ends as those that the setup assistant writes: `.srdf`, `kinematics.yaml`, `ompl_planning.yaml`.
    """

    def named(ending: str) -> list[FileReference]:
        found = [path for path in paths if path.endswith(ending)]
        return [FileReference(path, _start_of(path), path, True) for path in found]  # noqa: FBT003

    given = MoveItFiles(
        at=_start_of(paths[0]),
        semantic=next(iter(named(".srdf")), None),
        kinematics=next(iter(named(_KINEMATICS)), None),
        limits=next(iter(named(_LIMITS)), None),
        controllers=tuple(named(_OF_MOVEIT)),
        pipelines=tuple((_pipeline_named(file.text), file) for file in named(_PIPELINE)),
        as_values=True,
        runs=True,
    )
    return _MoveItReader(files, expander).read(given, is_given=True, ros=ros)


def _pipeline_named(path: str) -> str:
    return os.path.basename(path).removesuffix(_PIPELINE).rpartition("-")[2]


def _given(launch: Launch) -> MoveItFiles:
    """What a launch file gives to MoveIt: what move_group gets, with what other nodes get where that is unknown."""
    home = launch.description.namespace if launch.description else None
    sure = [each for each in launch.moveit if each.sure] or list(launch.moveit)
    near = [each for each in sure if home is None or each.namespace in (None, home)] or sure
    first, *others = sorted(near, key=lambda each: not each.runs)
    for other in others:
        first = first._replace(
            semantic=first.semantic or other.semantic,
            arguments=first.arguments if first.semantic else other.arguments,
            kinematics=first.kinematics or other.kinematics,
            limits=first.limits or other.limits,
            controllers=first.controllers or other.controllers,
            pipelines=first.pipelines or other.pipelines,
        )
    return first._replace(semantic=None, limits=None) if _has_other_robot(launch, home) else first


def _has_other_robot(launch: Launch, home: str | None) -> bool:
    """Whether move_group gets another file as description than the robot: its SRDF is for that one."""
    robot = launch.description
    near = (one for one in launch.descriptions if home is None or one.namespace in {None, home})
    of_moveit = {one.file.path for one in near if one.node == "move_group" and one.file.path}
    return robot is not None and bool(of_moveit) and robot.file.path not in of_moveit


def _beside(path: str, controllers: Sequence[str]) -> MoveItFiles | None:
    """The files that the setup assistant writes beside a description or ros2_controllers.yaml; None without them."""
    folder, name = os.path.split(path)
    stem = next((name.removesuffix(ending) for ending in _DESCRIPTIONS if name.endswith(ending)), "")
    semantic = os.path.join(folder, f"{stem}.srdf")
    folders = [os.path.dirname(file) for file in controllers if os.path.basename(file) == _CONTROLLERS]
    described = is_file(semantic) and bool(stem)
    home = folder if described else next(iter(folders), None)
    if home is None or not (described or is_file(os.path.join(home, _OF_MOVEIT))):
        return None

    def file(name: str) -> FileReference | None:
        whole = os.path.join(home, name)
        return FileReference(whole, _start_of(whole), whole, True) if is_file(whole) else None  # noqa: FBT003

    of_moveit = file(_OF_MOVEIT)
    return MoveItFiles(
        at=_start_of(path),
        semantic=file(os.path.basename(semantic)) if described else None,
        kinematics=file(_KINEMATICS),
        limits=file(_LIMITS),
        controllers=(of_moveit,) if of_moveit else (),
        pipelines=tuple(_pipelines(home, file)),
        as_values=True,
    )


def _pipelines(folder: str, file: Callable[[str], FileReference | None]) -> Iterator[tuple[str, FileReference]]:
    for name in (one for one in names_in(folder) if one.endswith(_PIPELINE)):
        found = file(name)
        if found is not None:
            yield name.removesuffix(_PIPELINE), found


def _start_of(path: str) -> Place:
    return Place(SourceText(path, b""), 0, end=0)


class _MoveItReader:
    def __init__(
        self, files: Files, expander: Callable[[], Expander], replaced: Mapping[str | None, _Texts] | None = None
    ) -> None:
        """`replaced`: the texts that a launch file replaces in a file, such as `$(arg prefix)`."""
        self.files = files
        self._expander = expander
        self._replaced = replaced or {}

    def read(self, found: MoveItFiles, *, is_given: bool, ros: int | None) -> MoveIt:
        """Return the content of the files; `is_given` tells whether a launch file gives them to MoveIt."""
        kinematics, limits = self._tree(found.kinematics), self._tree(found.limits)
        trees = [tree for file in found.controllers if (tree := self._tree(file))]
        pipelines = [(name, tree) for name, file in found.pipelines if (tree := self._tree(file))]
        lists = (empty_controller_list(tree) for tree in trees)
        known = [tree for tree in (kinematics, limits, *trees, *(tree for _, tree in pipelines)) if tree]
        tags = [problem for tree in known for problem in tree.refused_tags]
        values = [empty for tree in known for empty in empty_values(tree)] if found.as_values and ros != 1 else []
        return MoveIt(
            files=found if is_given else None,
            semantic=self._semantic(found),
            solvers=tuple(solvers_of(kinematics)) if kinematics else (),
            limits=tuple(limits_of(limits)) if limits else (),
            controllers=tuple(self._controllers(trees)),
            pipelines=tuple(self._pipelines(pipelines)),
            empty=tuple(values),
            no_controllers=next((place for place in lists if place), None),
            plugin=next((plugin for tree in trees if (plugin := plugin_of(tree))), None),
            unlisted=tuple(key for tree in trees for key in unlisted_controllers(tree)),
            problems=tuple(dict.fromkeys(tags)),
        )

    @staticmethod
    def _controllers(trees: Sequence[YamlFile]) -> Iterator[MoveItController]:
        for tree in {tree.source.path: tree for tree in trees}.values():
            yield from moveit_controllers(tree)

    @staticmethod
    def _pipelines(trees: Sequence[tuple[str, YamlFile]]) -> Iterator[Pipeline]:
        for name, tree in trees:
            pipeline = pipeline_of(name, tree)
            if pipeline is not None:
                yield pipeline

    def _semantic(self, found: MoveItFiles) -> Semantic | None:
        path = found.semantic.path if found.semantic else None
        if path is None or found.arguments is None or (found.semantic and found.semantic.exists is False):
            return None
        try:
            self.files.read(path)
        except FileProblem:
            return None
        expansion = expansion_of(self._expander(), path, dict(found.arguments))
        root = expansion.document.documentElement if expansion.document else None
        return semantic_of(root, path, complete=expansion.complete) if root is not None else None

    def _tree(self, file: FileReference | None) -> YamlFile | None:
        if file is None or file.path is None:
            return None
        try:
            return with_replacements(read_yaml(self.files.read(file.path)), self._replaced.get(file.path, ()))
        except FileProblem:
            return None
