"""Reads a launch file with what it includes, within the limits of a run."""

from __future__ import annotations

import os
from collections.abc import Mapping

from urdfctl.model.build_launch import Sources, is_of_ros2, launch_of
from urdfctl.model.build_package import package_around
from urdfctl.model.launch import Launch, Word
from urdfctl.record import NamedTuple
from urdfctl.source.dom import Document, Element
from urdfctl.source.files import FileProblem, Files
from urdfctl.source.launch.terms import Term
from urdfctl.source.packages import PackageNotFound, Packages
from urdfctl.source.problem import Problem, ReadError
from urdfctl.source.span import Place, SourceText
from urdfctl.source.xml import parse


class Launched(NamedTuple):
    """What a launch file does, None where it is none that is understood; the files read for it, and what was wrong."""

    launch: Launch | None
    files: Files
    problems: tuple[Problem, ...]


def read_launch(
    path: str, arguments: Mapping[str, str], files: Files, packages: Packages, environ: Mapping[str, str]
) -> Launched:
    """The facts of a launch file that is started with some arguments."""
    reader = _Reader(path, files, packages, environ)
    launch = reader.ros1(arguments) if reader.is_roslaunch() else reader.ros2(arguments)
    if launch is not None:
        named = (*launch.packages, *reader.named)
        launch = launch._replace(packages=named, package=package_around(packages, reader.tree))
    return Launched(launch, files, tuple(reader.problems))


class _Reader:
    def __init__(self, path: str, files: Files, packages: Packages, environ: Mapping[str, str]) -> None:
        self.path = path
        self.files = files
        self.packages = packages
        self.environ = environ
        self.problems: list[Problem] = []
        self.named: list[Word] = []
        self._terms: dict[str, Term | None] = {}

    def is_roslaunch(self) -> bool:
        """Whether the file is one of ROS 1."""
        if not self.path.endswith((".launch", ".xml")):
            return False
        root = self._root(self.path)
        return root is None or not is_of_ros2(root)

    def ros1(self, arguments: Mapping[str, str]) -> Launch | None:
        """The facts of a launch file of ROS 1."""
        return launch_of(self.path, arguments, Sources(self.tree, self.locate, self.folder, self.environ))

    def ros2(self, arguments: Mapping[str, str]) -> Launch | None:
        """The facts of a launch file of ROS 2; what reads it is loaded only here."""
        from urdfctl.model.build_launch_ros2 import Sources as SourcesOfRos2
        from urdfctl.model.build_launch_ros2 import launch_of_ros2

        return launch_of_ros2(self.path, arguments, SourcesOfRos2(self.term, self.locate, self.find, self.environ))

    # -- texts -------------------------------------------------------------------------------------------------------

    def _source(self, path: str) -> SourceText | None:
        try:
            return self.files.read(path)
        except FileProblem as error:
            if path == self.path:
                self.problems.append(error.at(Place(SourceText(path, b""), 0, end=0)))
        return None

    def tree(self, path: str) -> Document | None:
        """The tree of a launch file in XML; None where it cannot be read."""
        source = self._source(path)
        try:
            return parse(source) if source else None
        except ReadError as error:
            if error.problem not in self.problems:
                self.problems.append(error.problem)
        return None

    def _root(self, path: str) -> Element | None:
        document = self.tree(path)
        return document.documentElement if document else None

    def term(self, path: str) -> Term | None:
        """What a launch file of ROS 2 builds; None where it cannot be read, or is none."""
        if path not in self._terms:
            self._terms[path] = self._term(path)
        return self._terms[path]

    def _term(self, path: str) -> Term | None:
        if path.endswith(".py"):
            return self._of_python(path)
        from urdfctl.source.launch.frontend import of_xml, of_yaml

        if path.endswith((".yaml", ".yml")):
            from urdfctl.source.yaml import read_yaml

            source = self._source(path)
            return of_yaml(read_yaml(source)) if source else None
        root = self._root(path)
        return of_xml(root) if root is not None and root.tagName == "launch" and is_of_ros2(root) else None

    def _of_python(self, path: str) -> Term | None:
        from urdfctl.source.launch.python import Surroundings, read_python

        source = self._source(path)
        if source is None:
            return None
        script = read_python(source, Surroundings(self.find, self.environ))
        if script.problem is not None:
            self.problems.append(script.problem)
        return script.term

    # -- places ------------------------------------------------------------------------------------------------------

    def locate(self, path: str) -> tuple[str, bool | None]:
        """Where a file lies in the sources, and whether it is there; None where nobody may look."""
        found = self.packages.source_of(path)
        if not self.files.may_read(found):
            return found, None
        return found, os.path.isfile(found) or (None if self.packages.may_be_made(found) else False)

    def find(self, package: str, at: Place) -> str | None:
        """The folder of a package that is named at a place; None where it is not among the sources."""
        self.named.append(Word(package, at))
        return self.folder(package)

    def folder(self, package: str) -> str | None:
        """The folder of a package."""
        try:
            return self.packages.find(package)
        except PackageNotFound:
            return None
