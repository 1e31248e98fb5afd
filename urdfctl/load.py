"""From a file to its diagnostics: reads, builds the model, runs the rules."""

from __future__ import annotations

import os
from collections.abc import Callable, Mapping, Sequence

from urdfctl.evidence import Evidence, OfFiles, ament_package, judged
from urdfctl.hints import TYPE_CHECKING
from urdfctl.lint import Linted, Outcome, Selection, lint
from urdfctl.meshes import mesh_finder
from urdfctl.model.build_robot import TOP_LEVEL, robot_of
from urdfctl.model.project import Project
from urdfctl.model.robot import Robot
from urdfctl.record import NamedTuple
from urdfctl.settings import ALL_STARTED, Settings
from urdfctl.source.dom import Document, Element
from urdfctl.source.files import FileProblem, Files, is_launch, is_yaml
from urdfctl.source.library import LibraryExpander
from urdfctl.source.packages import PackageIndex, Packages
from urdfctl.source.problem import Problem, ProblemKind, ReadError
from urdfctl.source.span import Place, SourceSpan, SourceText
from urdfctl.source.suppressions import is_reached
from urdfctl.source.xacro import HARMLESS, Expander, Expansion
from urdfctl.source.xml import LATE_DECLARATION, parse
from urdfctl.workspace import workspace_of

if TYPE_CHECKING:
    from urdfctl.launching import Launched
    from urdfctl.model.launch import Launch
    from urdfctl.pairing import Read
    from urdfctl.sharing.assistant import Assistant


_LARGE = 40
"""A robot of so many links costs more to be pickled than to be parted from."""


class Target(NamedTuple):
    """One robot in one variant: a file and its `name:=value` arguments; or a `fragment`, which others may include; with
    the `controllers` and the `launch` file that belong to it. Or a controllers' file or a launch file alone."""

    path: str
    arguments: tuple[tuple[str, str], ...] = ()
    fragment: bool = False
    controllers: tuple[str, ...] = ()
    launch: str | None = None


class Seen(NamedTuple):
    """A linted robot, with what the rules looked at, the tree that it was made of (None where there is none), and the
    texts that were read."""

    linted: Linted
    project: Project
    root: Element | None
    sources: Mapping[str, SourceText]


class Loader:
    """What the targets of a run share: the settings, and what was learned of the packages of a workspace."""

    def __init__(self, settings: Settings, selection: Selection, held: Mapping[str, bytes] | None = None) -> None:
        self.settings = settings
        self.selection = selection
        self.may_part = False
        """Whether a large robot may be linted by two processes."""
        self.assistant: Assistant | None = None
        self._held = held or {}
        self._indexes: dict[str, PackageIndex] = {}

    def holding(self, held: Mapping[str, bytes]) -> Loader:
        """One that knows the same, and reads some files, by their real paths, as if they held other bytes."""
        other = Loader(self.settings, self.selection, held)
        other._indexes = self._indexes
        return other

    def survey(self, targets: Sequence[Target]) -> None:
        """Learn once, before workers part, what each of many targets would else learn for itself."""
        for path in {workspace_of(os.path.abspath(target.path), self.settings.workspace) for target in targets}:
            for crawl in self._index(path).crawls:
                crawl.packages()

    def index_for(self, path: str) -> PackageIndex:
        """The packages of the workspace that a file belongs to."""
        return self._index(workspace_of(path, self.settings.workspace))

    def _index(self, workspace: str) -> PackageIndex:
        if workspace not in self._indexes:
            self._indexes[workspace] = PackageIndex(workspace, self.settings.package_paths, self.settings.environ)
        return self._indexes[workspace]

    def reading(self, path: str) -> tuple[Files, Packages]:
        """What may be read for a file, and the packages as it sees them."""
        index = self.index_for(path)
        packages = Packages(path, index)
        bounds = None if self.settings.trust else [index.workspace, *index.extra]
        return Files(bounds, packages.source_of, self._held), packages

    def expander(self, path: str, kind: type[Expander] = Expander, *, strict: bool = False) -> Expander:
        """An expander for one file."""
        files, packages = self.reading(path)
        return kind(files, packages, self.settings.environ, strict=strict, trust=self.settings.trust)

    def lint(self, target: Target) -> Linted:
        """The findings in one robot, or in a file that is none: then in the macros it defines, or its controllers."""
        return self.seen(target).linted

    def seen(self, target: Target) -> Seen:
        """The findings, and what they were found in."""
        path = os.path.abspath(target.path)
        launched = self._launched(path, target)
        described = launched.launch.description if launched and launched.launch else None
        arguments = dict(target.arguments)
        if described and described.file.path and (is_launch(path) or _same(described.file.path, path)):
            given = {} if is_launch(path) else arguments
            path, arguments = described.file.path, {**dict(described.arguments or ()), **given}
        if is_yaml(path) or is_launch(path):
            return self._seen_alone(path, target, launched)
        expander = self.expander(path, LibraryExpander if target.fragment else Expander)
        expansion = expansion_of(expander, path, arguments)
        if expander.macros and not expansion.library and _is_library(expansion):
            expander = self.expander(path, LibraryExpander)
            expansion = expansion_of(expander, path, arguments)
        project = self._project(path, expansion, expander, target.controllers, launched)
        root = expansion.document.documentElement if expansion.document else None
        seen = self._seen(project, (expander.files, launched), root)
        return seen._replace(linted=seen.linted._replace(arguments=tuple(arguments.items())))

    def _launched(self, path: str, target: Target) -> Launched | None:
        launch = path if is_launch(path) else target.launch and os.path.abspath(target.launch)
        if not launch:
            return None
        from urdfctl.launching import read_launch

        arguments = dict(target.arguments) if is_launch(path) else {}
        return read_launch(launch, arguments, *self.reading(launch), self.settings.environ)

    def _seen_alone(self, path: str, target: Target, launched: Launched | None) -> Seen:
        """The findings in controllers' files that no robot is known for."""
        from urdfctl.pairing import read_controllers

        files, packages = self.reading(path)
        named = [path] if is_yaml(path) else []
        launch = launched.launch if launched else None
        read = read_controllers([*named, *target.controllers], None, launch, files)
        package = packages.own() or ament_package(packages.beside())
        evidence = judged(None, package, self.settings, _of_files(read, launch))
        problems = (*(launched.problems if launched else ()), *(read.problems if read else ()))
        project = self._judged(Project(None, path, problems=problems), evidence, read, launch)
        return self._seen(project, (files, launched), None)

    def _project(
        self,
        path: str,
        expansion: Expansion,
        expander: Expander,
        controllers: Sequence[str] = (),
        launched: Launched | None = None,
    ) -> Project:
        root = expansion.document.documentElement if expansion.document else None
        find_mesh = mesh_finder(expander.packages, path)
        robot = robot_of(root, find_mesh, whole=expansion.complete) if root is not None else None
        launch = launched.launch if launched else None
        read = _read_controllers(controllers, robot, launch, expander.files)
        evidence = judged(robot, expander.packages.own(), self.settings, _of_files(read, launch))
        problems = (
            *expansion.problems,
            *(launched.problems if launched else ()),
            *(read.problems if read else ()),
        )
        project = Project(robot, path, problems=problems, complete=expansion.complete, library=expansion.library)
        listed = _listed_joints(path, expander.files)
        project = project._replace(influence=expander.definitions().influence_on, listed=listed)
        return self._judged(project, evidence, read, launch)

    def _judged(self, project: Project, evidence: Evidence, read: Read | None, launch: Launch | None) -> Project:
        """A project with what is known of its distro and simulator, and its controllers as that distro reads them."""
        started = self.settings.started
        if started is None and launch is not None:
            started = launch.started
        controllers = read.model(evidence.ros, None if started == ALL_STARTED else started) if read else None
        if started == ALL_STARTED:
            started = tuple(one.full_name for one in controllers.controllers) if controllers else None
        return project._replace(
            distro=evidence.distro,
            distros=evidence.distros,
            distro_from=evidence.source,
            simulator=evidence.simulator,
            simulator_from=evidence.simulator_from,
            started=started,
            in_order=self.settings.started not in (None, ALL_STARTED),
            controllers=controllers,
            launch=launch,
            additions=self.settings.additions,
        )

    def _seen(self, project: Project, read: tuple[Files, Launched | None], root: Element | None) -> Seen:
        robot, files, launched = project.robot, read[0], read[1]
        sources = {
            source.path: source for one in (files, launched and launched.files) if one for source in one.sources()
        }

        def reached(span: SourceSpan) -> bool:
            return root is None or is_reached(span, root)

        linted = Linted(
            project.path,
            project.ros,
            project.distro,
            project.distro_from,
            project.simulator,
            project.complete,
            project.library,
            robot.name if robot else None,
            len(robot.links) if robot else None,
            tuple(sources),
            self._outcome(project, list(sources.values()), reached),
            _controllers_files(project),
            project.launch.path if project.launch else None,
        )
        return Seen(linted, project, root, sources)

    def _outcome(
        self, project: Project, sources: Sequence[SourceText], reached: Callable[[SourceSpan], bool]
    ) -> Outcome:
        large = project.robot is not None and len(project.robot.links) >= _LARGE
        if self.may_part and large:
            from urdfctl.sharing.parted import lint_parted

            return lint_parted(project, sources, self.selection, reached)
        if self.assistant is not None and not large:
            from urdfctl.sharing.assistant import lint_assisted

            return lint_assisted(self.assistant, project, sources, self.selection, reached)
        return lint(project, sources, self.selection, reached=reached)


def _of_files(read: Read | None, launch: Launch | None) -> OfFiles | None:
    """The generation of ROS that the files beside a robot are written for."""
    form = read.form if read else None
    if form is not None:
        return OfFiles(form, "ros__parameters" if form == 2 else "its controllers' types")  # noqa: PLR2004
    return OfFiles(launch.ros, "its launch file") if launch else None


def _controllers_files(project: Project) -> tuple[str, ...]:
    """The files that belong to a robot; none where a launch file loads some, and none of them has controllers."""
    found = project.controllers
    if found is None or (project.launch and not found.managers and not found.controllers):
        return ()
    return tuple(dict.fromkeys(file.path for file in found.files))


def _same(path: str, other: str) -> bool:
    return os.path.realpath(path) == os.path.realpath(other)


def _read_controllers(paths: Sequence[str], robot: Robot | None, launch: Launch | None, files: Files) -> Read | None:
    """The controllers' files that belong to a robot; YAML is loaded only where there may be any."""
    named = any(plugin.setting("parameters") for plugin in (robot.plugins if robot else ()))
    if not paths and not named and not (launch and launch.loads):
        return None
    from urdfctl.pairing import read_controllers

    return read_controllers(paths, robot, launch, files)


def _listed_joints(path: str, files: Files) -> tuple[tuple[str, Place], ...]:
    """The joints that a support package of ROS-Industrial lists for a robot: those of urdf/arm.xacro in
    config/joint_names_arm.yaml."""
    folder, name = os.path.split(path)
    file = os.path.join(os.path.dirname(folder), "config", f"joint_names_{name.partition('.')[0]}.yaml")
    if not os.path.isfile(file):
        return ()
    from urdfctl.pairing import listed_joints

    return tuple(listed_joints(file, files))


def expansion_of(expander: Expander, path: str, arguments: Mapping[str, str]) -> Expansion:
    """The tree of a file: expanded where it is xacro; a plain URDF is read as it stands, as robots load it."""
    try:
        source = expander.files.read(path)
    except FileProblem as error:
        return Expansion(None, [error.at(Place(SourceText(path, b""), 0, end=0))])
    if source.is_xacro:
        return expander.expand(path, arguments)
    document, problems = _read(source, expander)
    return Expansion(document, problems, library=isinstance(expander, LibraryExpander))


def _read(source: SourceText, expander: Expander) -> tuple[Document | None, list[Problem]]:
    """The tree of a plain URDF, with what its readers take though it is no good XML."""
    try:
        return parse(source, expander.cloning, declarations=expander.trust), []
    except ReadError as error:
        problem = error.problem
    if problem.subject != LATE_DECLARATION:
        return None, [problem]
    late = problem._replace(kind=ProblemKind.LATE_DECLARATION)
    try:
        return parse(source, expander.cloning, declarations=expander.trust, late_declaration=True), [late]
    except ReadError as error:
        return None, [error.problem]


_OF_INCLUDES = {ProblemKind.FILE_NOT_FOUND, ProblemKind.PACKAGE_NOT_FOUND, ProblemKind.FILE_UNREADABLE}


def _is_library(expansion: Expansion) -> bool:
    """Whether nothing of a robot is in what a file expands to, and no fault of its own is why."""
    root = expansion.document.documentElement if expansion.document else None
    if root is None or any(child.tagName in TOP_LEVEL for child in root.elements()):
        return False
    return all(problem.kind in HARMLESS | _OF_INCLUDES for problem in expansion.problems)
