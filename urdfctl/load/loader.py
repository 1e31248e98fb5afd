"""Load a target: read its files, expand it, and build the project that the rules look at."""

from __future__ import annotations

import os
from collections.abc import Collection, Mapping, Sequence
from functools import partial
from typing import TYPE_CHECKING

from urdfctl.config.file import NAMES as CONFIG_NAMES
from urdfctl.config.file import config_for
from urdfctl.config.settings import ALL_STARTED, Settings
from urdfctl.load.build_files import build_faults
from urdfctl.load.joint_lists import listed_joints_beside
from urdfctl.load.known import Described, KnownRobots
from urdfctl.load.mentions import Mentions
from urdfctl.load.open_decisions import decisions_in, unread
from urdfctl.load.origin.distro import Beside, detect_distro
from urdfctl.load.origin.evidence import package_of_file, package_of_robot
from urdfctl.load.spawned_models import with_spawned
from urdfctl.load.target import Target
from urdfctl.load.workspace_types import WorkspaceTypes
from urdfctl.model.project import NO_OWN_TYPES, Evidence, OwnTypes, Project
from urdfctl.model.robot import Robot
from urdfctl.source.disk.files import Files, is_launch, is_yaml
from urdfctl.source.disk.gate import is_file, reading_within
from urdfctl.source.opaque import is_known
from urdfctl.source.span import Place, SourceText
from urdfctl.source.todo import todos_in
from urdfctl.source.workspaces.packages import PackageIndex, Packages, package_around
from urdfctl.source.workspaces.workspace import workspace_of
from urdfctl.source.xacro.expansion import Expander
from urdfctl.source.xml.dom import Document, Element
from urdfctl.startup.records import NamedTuple

if TYPE_CHECKING:
    from urdfctl.load.controller_files import ControllerFiles
    from urdfctl.load.launch_files import LaunchFile
    from urdfctl.model.launch import Description, Launch
    from urdfctl.model.moveit import MoveIt


class LoadedTarget(NamedTuple):
    """A target as the rules look at it.

    root: the root element of the expanded description; None if there is none.
    sources: all texts that were read, by path.
    arguments: the xacro arguments the description was given.
    """

    project: Project
    root: Element | None
    sources: Mapping[str, SourceText]
    arguments: tuple[tuple[str, str], ...] = ()


class Loader:
    """State shared by all targets of a run: the settings, and an index of the packages of each workspace."""

    def __init__(self, settings: Settings, overlay: Mapping[str, bytes] | None = None) -> None:
        self.settings = settings
        self._overlay = overlay or {}
        self._indexes: dict[str, PackageIndex] = {}
        self._types = WorkspaceTypes()
        self._files: dict[str, Files] = {}
        self._decisions: dict[str, list[tuple[str, Place]]] = {}
        self._known = KnownRobots()
        self._mentions = Mentions()

    def with_overlay(self, overlay: Mapping[str, bytes], changed: Collection[str] | None = None) -> Loader:
        """Return a loader with the same packages that reads these bytes instead of the files with these real paths.

        changed: the real paths of all files whose text differs from what this loader read. Descriptions that read none
        of them are not expanded again. None if that is not known.
        """
        other = Loader(self.settings, overlay)
        other._indexes = self._indexes
        other._types = self._types.with_same_exports()
        if changed is not None:
            other._known = self._known.unless_read(changed, overlay)
        return other

    def anew(self) -> Loader:
        """Return a loader that reads all files anew, and knows where the packages are."""
        other = Loader(self.settings, self._overlay)
        other._indexes = {workspace: index.anew() for workspace, index in self._indexes.items()}
        return other

    def index_packages(self, targets: Sequence[Target]) -> None:
        """Find the packages of all workspaces once, before workers are forked."""
        for workspace, path in self._a_path_in_each_workspace(targets).items():
            for crawl in self._index(workspace).crawls:
                crawl.packages()
            self.reading(path)

    def read_exports(self, targets: Sequence[Target]) -> None:
        """Read what the packages of all workspaces export once, before workers are forked.

        Saves: each of thirty workers reads the manifests of four hundred packages, 5 ms.
        """
        for path in self._a_path_in_each_workspace(targets).values():
            self._types.exports_in(self.index_for(path), self.reading(path)[0])

    def _a_path_in_each_workspace(self, targets: Sequence[Target]) -> dict[str, str]:
        paths = [os.path.abspath(target.path) for target in targets]
        return {self._workspace(path): path for path in paths}

    def _workspace(self, path: str) -> str:
        return workspace_of(path, self.settings.workspace)

    def _settings_of_package(self, path: str) -> Settings:
        """The settings, with the distro and the simulator of a configuration in the package of a file.

        An option of the command line counts more, the configuration of the run less.
        """
        package = package_around(os.path.dirname(path))
        if package is None or not any(is_file(os.path.join(package, name)) for name in CONFIG_NAMES):
            return self.settings
        config = config_for((package,), self.settings.workspace)
        settings = self.settings
        if config.distro and (settings.distro is None or settings.distro_from):
            settings = settings._replace(distro=config.distro, distro_from=config.distro_from)
        if config.simulator and (settings.simulator is None or settings.simulator_from):
            settings = settings._replace(simulator=config.simulator, simulator_from=config.simulator_from)
        return settings

    def index_for(self, path: str) -> PackageIndex:
        """Return the packages of the workspace that a file is in."""
        return self._index(self._workspace(path))

    def _index(self, workspace: str) -> PackageIndex:
        if workspace not in self._indexes:
            self._indexes[workspace] = PackageIndex(workspace, self.settings.package_paths, self.settings.environ)
        return self._indexes[workspace]

    def reading(self, path: str) -> tuple[Files, Packages]:
        """Return what may be read for a file, and the packages as it sees them."""
        index = self.index_for(path)
        packages = Packages(path, index)
        if index.workspace not in self._files:
            bounds = None if self.settings.trust else [index.workspace, *index.extra]
            self._files[index.workspace] = Files(bounds, held=self._overlay)
            for named in self.settings.named_files:
                self._files[index.workspace].allow(named)
        return self._files[index.workspace].again(packages.source_of), packages

    def reading_for(self, path: str) -> reading_within:
        """Return a context in which this thread reads nothing but what may be read for a file."""
        index = self.index_for(path)
        roots = [index.workspace, *index.extra, *index.elsewhere(), *self.settings.named_files]
        return reading_within(None if self.settings.trust else roots)

    def expander(self, path: str, kind: type[Expander] = Expander, *, strict: bool = False) -> Expander:
        """Return an expander for one file."""
        files, packages = self.reading(path)
        return kind(files, packages, self.settings.environ, strict=strict, trust=self.settings.trust)

    def load(self, target: Target) -> LoadedTarget:
        """Return the target, with the files that belong to it."""
        path = os.path.abspath(target.path)
        launch_file = self._launch_file(path, target)
        description = _description(launch_file, None if is_launch(path) else path, target.namespace)
        arguments = dict(target.arguments)
        alone = not arguments
        if launch_file and launch_file.launch and description and description.file.path:
            given_arguments = {} if is_launch(path) else arguments
            path, arguments = description.file.path, {**dict(description.arguments or ()), **given_arguments}
            alone = description.arguments is None or description.more
            launch_file = launch_file._replace(launch=launch_file.launch.among(description))
        if is_yaml(path) or is_launch(path):
            return self._without_robot(path, target, launch_file)
        by_xacro = bool(description and description.by_xacro)
        described = self._known.described(
            partial(self.expander, path), path, arguments, fragment=target.fragment, alone=alone, by_xacro=by_xacro
        )
        if target.guessed and launch_file and described.expansion.document:
            launch_file = self._fitting(target, launch_file, described.expansion.document)
        files = described.files.copy()
        project = self._project(path, described, files, target.controllers, launch_file)
        if target.guessed and project.moveit is not None:
            project = project._replace(moveit=project.moveit._replace(guessed=True))
        given = tuple((name, value) for name, value in arguments.items() if is_known(value))
        sources = _sources(files, launch_file)
        return LoadedTarget(self._among_others(project, sources), described.root, sources, given)

    def variants(self, target: Target) -> list[Target]:
        """Return a target for each choice of the arguments that a launch file needs, or is documented to be given.

        It is the target itself if it needs none. Otherwise the arguments are guessed from the files that exist; or
        they are those with which the launch file includes another one.
        """
        path = os.path.abspath(target.path)
        if not is_launch(path) or target.arguments:
            return [target]
        from urdfctl.load.launch_variants import launch_variants, variant_including

        files, packages = self.reading(path)
        read = partial(self._launch, path, files, packages)
        if target.towards:
            found = [variant_including(target.towards, read, files.read(path).data)]
        else:
            found = launch_variants(read, [dict(arguments) for arguments, _ in target.documented])
        told, target = dict(target.documented), target._replace(documented=())
        return [
            target._replace(arguments=one.arguments, guessed=one.is_guessed, told_at=told.get(one.arguments))
            for one in found
        ]

    def _fitting(self, target: Target, launch_file: LaunchFile, robot: Document) -> LaunchFile:
        """The launch file with those of its parameter files that fit the joints of a robot best."""
        from urdfctl.load.controller_files import misfit
        from urdfctl.load.launch_variants import file_choices

        path, given = os.path.abspath(target.path), dict(target.arguments)
        files, packages = self.reading(path)
        read = partial(self._launch, path, files, packages)
        launch = launch_file.launch
        least = misfit(launch, robot, files) if launch else (0, 0)
        for choice in file_choices(launch, given, read) if launch and any(least) else ():
            other = read({**given, **choice})
            found = misfit(other, robot, files) if other else least
            if found < least:
                least, launch = found, other
        return launch_file._replace(launch=launch)

    def _launch(self, path: str, files: Files, packages: Packages, arguments: Mapping[str, str]) -> Launch | None:
        """The model of a launch file that is started with these arguments."""
        from urdfctl.load.launch_files import read_launch

        return read_launch(path, arguments, files, packages, self.settings.environ).launch

    def _launch_file(self, path: str, target: Target) -> LaunchFile | None:
        launch = path if is_launch(path) else target.launch and os.path.abspath(target.launch)
        if not launch:
            return None
        from urdfctl.load.launch_files import read_launch

        arguments = dict(target.arguments) if is_launch(path) else {}
        files, packages = self.reading(launch)
        first = read_launch(launch, arguments, files, packages, self.settings.environ)
        beside = [
            read_launch(start.path, dict(start.arguments), files, self.reading(start.path)[1], self.settings.environ)
            for start in target.beside
        ]
        return first.with_beside(beside)

    def _without_robot(self, path: str, target: Target, launch_file: LaunchFile | None) -> LoadedTarget:
        """Load a controller file, or a launch file without a description."""
        from urdfctl.load.controller_files import read_controllers

        files, packages = self.reading(path)
        named = [path] if is_yaml(path) else []
        launch = launch_file.launch if launch_file else None
        controller_files = read_controllers([*named, *target.controllers], None, launch, files)
        package = package_of_file(packages)
        sources = tuple(_sources(files, launch_file).values())
        moveit = self._moveit(path, launch, controller_files, files)
        beside = Beside(
            package=package,
            controllers=controller_files,
            launch=launch,
            sources=sources,
            moveit=moveit,
            workspace=self._workspace(path),
            path=path,
        )
        evidence = detect_distro(None, beside, self._settings_of_package(path))
        problems = (
            *(launch_file.problems if launch_file else ()),
            *(controller_files.problems if controller_files else ()),
            *(moveit.problems if moveit else ()),
        )
        build, todos = build_faults(packages, files, sources), self._todos(sources, packages)
        project = Project(None, path, problems=problems, build=build, todos=todos, moveit=moveit)
        project = self._completed(project, evidence, controller_files, launch)
        texts = _sources(files, launch_file)
        return LoadedTarget(self._among_others(project, texts), None, texts)

    def _among_others(self, project: Project, sources: Mapping[str, SourceText]) -> Project:
        """The project, which can ask what the other texts of its workspace say."""
        understood = [path for path in sources if not is_yaml(path)]
        return project._replace(mentioned=self._mentions.beside(self._workspace(project.path), understood))

    def _project(
        self,
        path: str,
        described: Described,
        files: Files,
        controllers: Sequence[str] = (),
        launch_file: LaunchFile | None = None,
    ) -> Project:
        expansion = described.expansion
        launch = launch_file.launch if launch_file else None
        robot, hosting = with_spawned(described.robot, launch, files), with_spawned(described.hosting, launch, files)
        settings = self._settings_of_package(path)
        hosting = hosting if settings.simulator != "none" else None  # no simulator loads the plugins of the robot
        controller_files = _controller_files(controllers, hosting, launch, files)
        sources = tuple(_sources(files, launch_file).values())
        moveit = self._moveit(path, launch, controller_files, files)
        beside = Beside(
            package=package_of_robot(described.packages),
            controllers=controller_files,
            launch=launch,
            sources=sources,
            moveit=moveit,
            workspace=self._workspace(path),
            path=path,
        )
        evidence = detect_distro(robot, beside, settings)
        problems = (
            *expansion.problems,
            *(launch_file.problems if launch_file else ()),
            *(controller_files.problems if controller_files else ()),
            *(moveit.problems if moveit else ()),
        )
        project = Project(robot, path, problems=problems, complete=expansion.complete, library=expansion.library)
        listed, build = listed_joints_beside(path, files), build_faults(described.packages, files, sources)
        todos = self._todos(sources, described.packages)
        project = project._replace(listed=listed, build=build, todos=todos)
        project = project._replace(influence=described.influence, origin=described.origin)
        project = project._replace(moveit=moveit, together=bool(controllers))
        return self._completed(project, evidence, controller_files, launch)

    def _todos(self, sources: Sequence[SourceText], packages: Packages) -> tuple[tuple[str, Place], ...]:
        """Return what a migration left to a person in some texts, and in the other files of the package."""
        own = packages.own()
        if own is not None and own not in self._decisions:
            self._decisions[own] = decisions_in(own)
        inside = tuple(todo for source in sources for todo in todos_in(source))
        return inside + (unread(self._decisions[own], [source.path for source in sources]) if own else ())

    def _moveit(
        self, path: str, launch: Launch | None, controller_files: ControllerFiles | None, files: Files
    ) -> MoveIt | None:
        """Return MoveIt's configuration of a target. Its reader is imported only if there may be one."""
        controllers = [loaded.yaml.source.path for loaded in controller_files.files] if controller_files else []
        beside = (file for file in controllers if os.path.basename(file) == "ros2_controllers.yaml")
        semantic = f"{path.removesuffix('.xacro').removesuffix('.urdf')}.srdf"
        if not (launch and launch.moveit) and not any(beside) and not is_file(semantic):
            return None
        from urdfctl.load.moveit_files import read_moveit

        return read_moveit(path, launch, controllers, files, partial(self.expander, path), index=self.index_for(path))

    def _completed(
        self, project: Project, evidence: Evidence, controller_files: ControllerFiles | None, launch: Launch | None
    ) -> Project:
        """Return the project with its distro, its simulator, and its controllers as that distro reads them."""
        started = self.settings.started
        if started is None and launch is not None:
            started = launch.started
        named = None if started == ALL_STARTED else started
        nodes = dict(self.settings.nodes)
        controllers = self._known.controllers(controller_files, evidence.ros, named, nodes)
        if started == ALL_STARTED:
            started = tuple(controller.full_name for controller in controllers.controllers) if controllers else None
        project = project._replace(
            distro=evidence.distro,
            distros=evidence.distros,
            distro_from=evidence.source,
            evidence=evidence,
            simulator=evidence.simulator,
            simulator_from=evidence.simulator_from,
            started=started,
            in_order=self.settings.started not in (None, ALL_STARTED),
            controllers=controllers,
            launch=launch,
            additions=self.settings.additions,
            own=OwnTypes(nodes=nodes) if nodes else NO_OWN_TYPES,
        )
        return self._types.added_to(project, self.index_for(project.path), self.reading(project.path)[0])


def _description(launch_file: LaunchFile | None, path: str | None, namespace: str | None) -> Description | None:
    """The description of a robot in a launch file: the first one, or the one whose file and namespace are named."""
    robots = launch_file.launch.robots if launch_file and launch_file.launch else ()
    if namespace is not None:
        robots = tuple(one for one in robots if one.namespace == namespace)
    return next((one for one in robots if path is None or _is_same_file(one.file.path or "", path)), None)


def _sources(files: Files, launch_file: LaunchFile | None) -> dict[str, SourceText]:
    launch_files = launch_file.files.sources() if launch_file else ()
    return {source.path: source for source in (*files.sources(), *launch_files)}


def _is_same_file(path: str, other: str) -> bool:
    return os.path.realpath(path) == os.path.realpath(other)


def _controller_files(
    paths: Sequence[str], robot: Robot | None, launch: Launch | None, files: Files
) -> ControllerFiles | None:
    """Return the robot's controller files. YAML is imported only if there may be any."""
    is_named = any(plugin.setting("parameters") for plugin in (robot.plugins if robot else ()))
    if not paths and not is_named and not (launch and (launch.loads or launch.inline or launch.given)):
        return None
    from urdfctl.load.controller_files import read_controllers

    return read_controllers(paths, robot, launch, files)
