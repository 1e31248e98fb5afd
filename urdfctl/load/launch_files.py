"""Read a launch file and the files that it includes, within the limits of a run."""

from __future__ import annotations

import os
import re
from collections.abc import Iterable, Iterator, Mapping, Sequence
from typing import TYPE_CHECKING

from urdfctl.load.near_files import file_near
from urdfctl.model.launch import InlineParameters, Launch, LaunchedFile, Word
from urdfctl.model.launch.package import package_around
from urdfctl.model.launch.ros1 import is_of_ros2, launch_of
from urdfctl.model.launch.scope import Malformed, Sources
from urdfctl.names import is_slip, nearest
from urdfctl.source.disk.files import FileProblem, Files
from urdfctl.source.disk.gate import exists, is_file, names_in
from urdfctl.source.launch.terms import Term
from urdfctl.source.lengths import TOO_LONG
from urdfctl.source.opaque import UNKNOWN
from urdfctl.source.problem import Problem, ProblemKind, ReadError
from urdfctl.source.span import Place, SourceText
from urdfctl.source.variables import Variables
from urdfctl.source.workspaces.packages import PackageNotFound, Packages
from urdfctl.source.xml.dom import Document, Element
from urdfctl.source.xml.parsing import parse
from urdfctl.startup.per_object import once_per_object
from urdfctl.startup.records import NamedTuple

if TYPE_CHECKING:
    from urdfctl.source.launch.frontend import Entity
    from urdfctl.source.yaml.tree import YamlFile

_MOST_BYTES = 1 << 18
_MOST_LOADS = 200
_OFTEN_USED = frozenset(
    "controller_manager gazebo_ros gazebo_ros_control gazebo_ros2_control gz_ros2_control joint_state_publisher "
    "joint_state_publisher_gui moveit_ros_move_group robot_state_publisher ros_gz_bridge ros_gz_sim rviz rviz2 "
    "twist_mux xacro".split()
)
"""Packages that launch files use, and that are seldom in the workspace."""
_OF_PYTHON = b"python/"
_TEMPLATE = rb"\{\{|\{%|<%"
_PLACEHOLDER = rb"\{\{|\{%|<%|\[[A-Z]+(?:_[A-Z]+)+\]|@[A-Z]+(?:_[A-Z]+)*@|<(?i:your)[\w -]*>"
"""What a generator, e.g. MoveIt's setup assistant, or the reader of a template replaces in a launch file in XML."""
_parsed = once_per_object(parse)
"""Several launch files include the same ones."""


class LaunchFile(NamedTuple):
    """A launch file that was read.

    launch: its facts; None if it cannot be understood.
    files: the files that were read for it.
    problems: the errors of reading it.
    """

    launch: Launch | None
    files: Files
    problems: tuple[Problem, ...]

    def with_beside(self, others: Sequence[LaunchFile]) -> LaunchFile:
        """Return the launch file with what others start beside it."""
        launch, launches = self.launch, [other.launch for other in others if other.launch is not None]
        problems = dict.fromkeys(problem for each in (self, *others) for problem in each.problems)
        together = launch.with_beside(launches) if launch else launch
        return self._replace(launch=together, problems=tuple(problems))


def read_launch(
    path: str, arguments: Mapping[str, str], files: Files, packages: Packages, environ: Mapping[str, str]
) -> LaunchFile:
    """Return the facts of a launch file that is started with some arguments."""
    reader = _LaunchFileReader(path, files, packages, environ)
    launch = reader.launch(arguments)
    if launch is not None:
        launch = _without_needed(launch, arguments, reader)
        named = (*launch.packages, *reader.named)
        package = package_around(packages, reader.tree)
        references = tuple(map(_looked_around, launch.references))
        launch = launch._replace(references=references)
        misspelt = _misspelt((*named, *(node.package for node in launch.nodes if node.sure)), packages, path)
        variables = tuple(reader.environ.missing)
        launch = launch._replace(packages=named, package=package, misspelt=misspelt, variables=variables)
        reader.look_for_tags(launch.inline)
        reader.problems += _slips_in(arguments, launch, reader)
    return LaunchFile(launch, files, tuple(reader.problems))


def _slips_in(arguments: Mapping[str, str], launch: Launch, reader: _LaunchFileReader) -> Iterator[Problem]:
    """The given arguments that the launch file does not declare, where another one was certainly meant: those of
    included files can be given too."""
    declared = {name for name, _ in launch.arguments}
    for name in arguments:
        meant = nearest(name, declared) if name not in declared else None
        if meant is not None and meant not in arguments:
            at = Place(reader.files.read(reader.path), 0)
            message = f"argument '{name}' is given, but the launch file does not declare it; did you mean '{meant}'?"
            yield Problem(ProblemKind.UNKNOWN_ARGUMENT, at, message, name)


def _is_in_template(at: Place) -> bool:
    """Whether the line of a place has a placeholder, so that the file is no launch file yet."""
    data, start = at.source.data, at.span.start
    end = data.find(b"\n", start)
    line = data[data.rfind(b"\n", 0, start) + 1 : end if end >= 0 else len(data)]
    return re.search(_PLACEHOLDER, line) is not None


def _looked_around(reference: LaunchedFile) -> LaunchedFile:
    """A file that a launch file names, with what is beside it if it does not exist."""
    file = reference.file
    if file.exists is False and file.path:
        file = file._replace(nearest=file_near(file.path))
    return reference._replace(has_siblings=_has_siblings(reference), file=file)


def _has_siblings(reference: LaunchedFile) -> bool:
    """Whether a missing file should be there: its folder has another one with its ending, or is missing too."""
    path = reference.file.path
    if reference.use != "argument" or reference.file.exists is not False or not path:
        return False
    try:
        names = names_in(os.path.dirname(path))
    except FileNotFoundError:
        return True
    except OSError:
        return False
    return any(name.endswith(os.path.splitext(path)[1]) for name in names)


def _misspelt(named: Iterable[Word], packages: Packages, path: str) -> tuple[tuple[Word, str], ...]:
    """The packages that no package.xml declares, each with the one that it is with one slip: one of the workspace, or
    one that many launch files use."""
    found: dict[str, tuple[Word, str]] = {}
    for word in named:
        if UNKNOWN in word.text or word.text in found:
            continue
        try:
            packages.find(word.text)
        except PackageNotFound as error:
            known = () if word.text in _OFTEN_USED else (*error.known, *_OFTEN_USED)
            meant = nearest(word.text, [name for name in known if is_slip(word.text, name)])
            declared = any(packages.declares(word.text, file) for file in (path, word.at.source.path))
            if meant and not declared:
                found[word.text] = (word, meant)
    return tuple(found.values())


def _without_needed(launch: Launch, arguments: Mapping[str, str], reader: _LaunchFileReader) -> Launch:
    """The launch file, where it is not known whether a file exists if its path needs an argument that is not given.

    An argument with an empty default is one that is not given, also in an included launch file.
    """
    missing = {one.file.path for one in launch.references if one.file.exists is False}
    other = reader.launch(arguments, blank=UNKNOWN) if missing and reader.has_blank else None
    if other is None:
        return launch
    return launch.with_open_files(missing - {one.file.path for one in other.references})


class _LaunchFileReader:
    def __init__(self, path: str, files: Files, packages: Packages, environ: Mapping[str, str]) -> None:
        self.path = path
        self.files = files
        self.packages = packages
        self.environ = Variables(environ)
        self.problems: list[Problem] = []
        self.named: list[Word] = []
        self._terms: dict[str, Term | None] = {}
        self._written: dict[str, Term] = {}
        self._skipped: list[str] = []
        self._blank = ""
        self._loads = 0
        self.has_blank = False
        """Whether the launch file, or an included one, has an argument with an empty default that is not given."""

    def is_roslaunch(self) -> bool:
        """Return whether the file is a ROS 1 launch file."""
        if not self.path.endswith((".launch", ".xml")):
            return False
        root = self._root(self.path)
        return root is None or not is_of_ros2(root)

    def launch(self, arguments: Mapping[str, str], blank: str = "") -> Launch | None:
        """The facts of the launch file, with a value for arguments that have an empty default."""
        self._blank = blank
        return self.ros1(arguments) if self.is_roslaunch() else self.ros2(arguments)

    def _of_blank(self) -> str:
        self.has_blank = True
        return self._blank

    def _too_long(self, at: Place) -> None:
        """Report the first place at which a text is too long: others follow from it."""
        if not any(problem.message == TOO_LONG for problem in self.problems):
            self.problems.append(Problem(ProblemKind.BUDGET, at, TOO_LONG))

    def _malformed(self, part: Malformed) -> None:
        """Report a part of a launch file that it is refused for, or that is ignored."""
        problem = Problem(ProblemKind.LAUNCH_FORM, part.at, part.message, guessed=not part.refused)
        if not any(problem.message == other.message and part.at.is_same(other.at) for other in self.problems):
            self.problems.append(problem)

    def ros1(self, arguments: Mapping[str, str]) -> Launch | None:
        """Return the facts of a ROS 1 launch file."""
        sources = Sources(
            read=self.tree,
            locate=self.locate,
            find=self.folder,
            environ=self.environ,
            blank=self._of_blank,
            too_long=self._too_long,
            malformed=self._malformed,
        )
        return launch_of(self.path, arguments, sources)

    def ros2(self, arguments: Mapping[str, str]) -> Launch | None:
        """Return the facts of a ROS 2 launch file. Its reader is imported only here."""
        from urdfctl.model.launch.ros2 import Ros2Sources as SourcesOfRos2
        from urdfctl.model.launch.ros2 import launch_of_ros2

        sources = SourcesOfRos2(
            read=self.term,
            locate=self.locate,
            find=self.find,
            environ=self.environ,
            values=self.yaml,
            blank=self._of_blank,
            too_long=self._too_long,
            written=self._written.get,
        )
        launch = launch_of_ros2(self.path, arguments, sources)
        return launch._replace(skipped=(*launch.skipped, *self._skipped)) if launch and self._skipped else launch

    # -- texts -------------------------------------------------------------------------------------------------------

    def _source(self, path: str) -> SourceText | None:
        try:
            return self.files.read(path)
        except FileProblem as error:
            if path == self.path:
                self.problems.append(error.at(Place(SourceText(path, b""), 0, end=0)))
        return None

    def tree(self, path: str) -> Document | None:
        """Return the tree of an XML launch file; None if it cannot be read."""
        source = self._source(path)
        try:
            return _parsed(source) if source else None
        except ReadError as error:
            if error.problem not in self.problems and not _is_in_template(error.problem.at):
                self.problems.append(error.problem)
        return None

    def _root(self, path: str) -> Element | None:
        document = self.tree(path)
        return document.documentElement if document else None

    def term(self, path: str) -> Term | None:
        """Return the term that a ROS 2 launch file builds; None if it cannot be read or is not a launch file."""
        if path not in self._terms:
            self._terms[path] = self._term(path)
        return self._terms[path]

    def _term(self, path: str) -> Term | None:
        if path.endswith(".py"):
            return self._of_python(path)
        from urdfctl.model.launch.ros2.forms import malformed
        from urdfctl.source.launch.frontend import description

        root = self._entity(path)
        if root is None:
            return None
        for part in malformed(root):
            self._malformed(part)
        return description(root)

    def _entity(self, path: str) -> Entity | None:
        """The root of a launch file of ROS 2 in XML or YAML; None if it cannot be read or is not a launch file."""
        from urdfctl.source.launch.frontend import of_xml, of_yaml

        if path.endswith((".yaml", ".yml")):
            from urdfctl.source.yaml.tree import read_yaml

            source = self._source(path)
            return of_yaml(self._well_formed(read_yaml(source))) if source else None
        root = self._root(path)
        return of_xml(root) if root is not None and root.tagName == "launch" and is_of_ros2(root) else None

    def _of_python(self, path: str) -> Term | None:
        from urdfctl.source.launch.python import Surroundings, read_python

        source = self._source(path)
        if source is None:
            return None
        around = Surroundings(
            self.find,
            self.environ,
            self.module,
            self.yaml,
            too_long=self._too_long,
            write=self._written.setdefault,
            skip=self._skipped.append,
        )
        script = read_python(source, around)
        self.problems += script.problems
        return script.term

    def yaml(self, path: str) -> Term | None:
        """What a launch file in Python loads from a YAML file; None where it cannot be read."""
        from urdfctl.source.launch.yaml_terms import term_of_yaml
        from urdfctl.source.yaml.tree import read_yaml

        self._loads += 1
        source = self._source(self.packages.source_of(path)) if self._loads <= _MOST_LOADS else None
        if source is None or len(source.data) > _MOST_BYTES:
            return None
        return term_of_yaml(self._well_formed(read_yaml(source)))

    def look_for_tags(self, inline: Iterable[InlineParameters]) -> None:
        """Look for tags that rosparam refuses in the parameters that ROS 1 launch files contain."""
        suspicious = [one for one in inline if _OF_PYTHON in one.at.source.data[one.at.span.start : one.at.span.end]]
        if suspicious:
            from urdfctl.load.inline_parameters import inline_tree

            self.problems += [problem for one in suspicious for problem in inline_tree(one).refused_tags]

    def _read_by_python(self, file: YamlFile) -> YamlFile:
        """A YAML file that launch, or a launch file, reads."""
        self.problems += [problem for problem in file.refused_tags if problem not in self.problems]
        return file

    def _well_formed(self, file: YamlFile) -> YamlFile:
        """A YAML file that launch, or a launch file, reads, and where it is no YAML; a template is not known to be."""
        if not file.readable and not re.search(_TEMPLATE, file.source.data):
            self.problems += [problem for problem in file.problems if problem not in self.problems]
        return self._read_by_python(file)

    def module(self, name: str, importer: str) -> SourceText | None:
        """The text of a Python module of the workspace; None if there is no such module."""
        top, _, rest = name.lstrip(".").partition(".")
        tail = os.path.join(*rest.split(".")) if rest else ""
        if name.startswith("."):
            above = [os.pardir] * (len(name) - len(name.lstrip(".")) - 1)
            bases = [os.path.join(os.path.dirname(importer), *above, top, tail)]
        else:
            package = self.folder(top) if self.packages.is_of_workspace(top) else None
            bases = [os.path.join(package, part, tail) for part in (top, f"src/{top}")] if package else []
            bases.append(os.path.join(os.path.dirname(importer), top, tail))
        for base in bases:
            for path in (f"{os.path.normpath(base)}.py", os.path.join(os.path.normpath(base), "__init__.py")):
                if is_file(path):
                    return self._source(path)
        return None

    # -- places ------------------------------------------------------------------------------------------------------

    def locate(self, path: str) -> tuple[str, bool | None]:
        """Return the source of an installed file, and whether it exists; None if that cannot be checked."""
        path = os.path.normpath(path) if os.pardir in path else path
        source = self.packages.source_of(path)
        if source == path and not exists(path):
            source = os.path.join(self.packages.source_of(os.path.dirname(path)), os.path.basename(path))
        if not self.files.may_read(source):
            return source, None
        return source, is_file(source) or (None if self.packages.may_be_made(source) else False)

    def find(self, package: str, at: Place) -> str | None:
        """Return the folder of a package that is named at a place; None if it was not found."""
        self.named.append(Word(package, at))
        return self.folder(package)

    def folder(self, package: str) -> str | None:
        """Return the folder of a package; None if it was not found."""
        try:
            return self.packages.find(package)
        except PackageNotFound:
            return None
