"""What a loader keeps of its last targets, for others with the same robot: several launch files start one robot."""

from __future__ import annotations

import os
from collections.abc import Callable, Collection, Iterable, Mapping, Sequence
from functools import partial
from typing import TYPE_CHECKING

from urdfctl.load.expansion.description import ExpandedDescription, MakeExpander
from urdfctl.load.expansion.expanding import expanded
from urdfctl.load.meshes import mesh_finder
from urdfctl.model.robot import Robot
from urdfctl.model.robot.build_robot import robot_of
from urdfctl.source.disk.files import Files
from urdfctl.source.problem import ProblemKind
from urdfctl.source.same import is_same
from urdfctl.source.span import Place
from urdfctl.source.workspaces.packages import Packages
from urdfctl.source.xacro.expanded import Expansion
from urdfctl.source.xacro.expansion import Expander
from urdfctl.source.xacro.influence import Influence
from urdfctl.source.xml.dom import Element
from urdfctl.startup.records import NamedTuple

if TYPE_CHECKING:
    from urdfctl.load.controller_files import ControllerFiles
    from urdfctl.model.controllers import Controllers

_MOST_DESCRIPTIONS = 3


class Described(NamedTuple):
    """A description that was expanded.

    files: with the sources of the description alone; others copy them before they read more.
    root: the root element; None if there is none.
    robot: the model of it.
    hosting: the model of it without the mistakes of files that are not well-formed: it tells which files belong to it.
    influence: returns the YAML files and the arguments that the values at a place depend on.
    origin: returns where a value is written that a place takes over from a property or the call of a macro.
    """

    expansion: Expansion
    files: Files
    packages: Packages
    root: Element | None
    robot: Robot | None
    hosting: Robot | None
    influence: Callable[[Place], Influence]
    origin: Callable[[Place], Place]


class KnownRobots:
    """The last descriptions, and the controllers of the last robot."""

    def __init__(self) -> None:
        self._described: dict[tuple[object, ...], Described] = {}
        self._controllers: tuple[tuple[object, ...], Controllers] | None = None

    def unless_read(self, changed: Collection[str], overlay: Mapping[str, bytes]) -> KnownRobots:
        """Return the descriptions that read none of some files, for a loader with other texts. Paths are real paths."""
        other = KnownRobots()
        for key, found in self._described.items():
            if not any(os.path.realpath(source.path) in changed for source in found.files.sources()):
                other._described[key] = found._replace(files=found.files.holding(overlay))
        return other

    def described(
        self,
        make: MakeExpander,
        path: str,
        arguments: Mapping[str, str],
        *,
        fragment: bool,
        alone: bool,
        by_xacro: bool = False,
    ) -> Described:
        """Return a description expanded with some arguments. For `fragment` and `alone`, see `expanded`.

        by_xacro: whether xacro is run on the file, whatever its name is.
        """
        key = path, tuple(arguments.items()), fragment, alone, by_xacro
        if key not in self._described:
            run = partial(_expanding_all, make) if by_xacro else make
            found = _described(run, path, arguments, fragment=fragment, alone=alone)
            while len(self._described) >= _MOST_DESCRIPTIONS:
                del self._described[next(iter(self._described))]
            self._described[key] = found
        return self._described[key]

    def controllers(
        self, files: ControllerFiles | None, ros: int | None, started: Sequence[str] | None, nodes: Iterable[str]
    ) -> Controllers | None:
        """Return the controllers in some files, as `ControllerFiles.model` does; None without files."""
        if files is None:
            return None
        key = files, ros, started, nodes
        if self._controllers is None or not is_same(self._controllers[0], key):
            self._controllers = key, files.model(ros, started, nodes)
        return self._controllers[1]


def _expanding_all(make: MakeExpander, kind: type[Expander]) -> Expander:
    expander = make(kind)
    expander.expands_all = True
    return expander


def _described(
    make: MakeExpander, path: str, arguments: Mapping[str, str], *, fragment: bool, alone: bool
) -> Described:
    first = expanded(make, path, arguments, fragment=fragment, alone=alone)
    expander, expansion = first
    robot = _robot(first, path)
    definitions = expander.definitions()
    described = Described(
        expansion=expansion,
        files=expander.files,
        packages=expander.packages,
        root=expansion.document.documentElement if expansion.document else None,
        robot=robot,
        hosting=robot,
        influence=definitions.influence_on,
        origin=definitions.origin,
    )
    if any(problem.kind is ProblemKind.XML_SYNTAX for problem in expansion.problems):
        return _with_salvage(described, make, path, arguments, alone=alone)
    return described


def _robot(read: ExpandedDescription, path: str) -> Robot | None:
    root = read.expansion.document.documentElement if read.expansion.document else None
    find_mesh = mesh_finder(read.expander.packages, path)
    return robot_of(root, find_mesh, whole=read.expansion.complete) if root is not None else None


def _with_salvage(
    described: Described, make: MakeExpander, path: str, arguments: Mapping[str, str], *, alone: bool
) -> Described:
    """The description, with the files and the other mistakes that are found behind a mistake in XML."""
    from urdfctl.load.expansion.incomplete import expanded_with_salvage

    behind = expanded_with_salvage(make, path, arguments, alone=alone)
    if behind.expansion.document is None:
        return described
    problems = described.expansion.problems
    places = {problem.at for problem in problems}
    found = [each for each in behind.expansion.problems if each.kind is ProblemKind.XML_SYNTAX]
    expansion = described.expansion._replace(problems=problems + [each for each in found if each.at not in places])
    return described._replace(expansion=expansion, files=behind.expander.files, hosting=_robot(behind, path))
