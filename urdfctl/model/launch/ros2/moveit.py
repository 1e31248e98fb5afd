"""The files that ROS 2 launch files give to MoveIt: those of a MoveItConfigsBuilder, and those in a node's parameters.

A builder reads the files of one package by their usual names, unless a call in its chain names another one
(moveit_configs_utils, moveit_configs_builder.py).
"""

from __future__ import annotations

import os
from collections.abc import Callable, Iterator, Mapping

from urdfctl.model.controllers import FileReference
from urdfctl.model.launch import Word
from urdfctl.model.launch.ros2.texts import Content, Texts, table_of
from urdfctl.model.launch.xacro_command import known_path
from urdfctl.model.moveit import MoveItFiles
from urdfctl.source.launch.moveit_configs import chain_of, controllers_in, listed_names, usual_controllers
from urdfctl.source.launch.terms import Called, Constant, Items, Table, Term, outside
from urdfctl.source.opaque import UNKNOWN
from urdfctl.source.span import Place

Locate = Callable[[str], tuple[str, bool | None]]

LAUNCHES = frozenset(
    (
        "generate_demo_launch generate_move_group_launch generate_rsp_launch generate_moveit_rviz_launch "
        "generate_spawn_controllers_launch generate_static_virtual_joint_tfs_launch generate_warehouse_db_launch "
        "generate_setup_assistant_launch"
    ).split()
)
"""The functions of moveit_configs_utils.launches."""
INCLUDED_BY_DEMO = ("rsp", "move_group", "spawn_controllers")
"""The launch files of its package that `generate_demo_launch` includes whatever its arguments are, without ending."""
_SEMANTIC = "robot_description_semantic"
_KINEMATICS = "robot_description_kinematics"
_PLANNING = "robot_description_planning"
_MANAGER = "moveit_simple_controller_manager"
_OF_PIPELINE = ("planning_plugin", "planning_plugins", "request_adapters")
_FILES = {_KINEMATICS: "config/kinematics.yaml", "joint_limits": "config/joint_limits.yaml"}


class Builder:
    """A MoveItConfigsBuilder with the calls that follow it.

    call: the builder itself. calls: the methods that are called on it, by name.
    """

    def __init__(self, call: Called, calls: Mapping[str, Called], texts: Texts) -> None:
        self.call, self.calls, self.texts = call, calls, texts
        self.name = texts.of(call.given("robot_name", 0))
        self.folder = _folder(call, texts)

    def file(self, method: str, usual: str) -> str:
        """Return the path that a method's `file_path` names, else the usual one in the package."""
        given = self._given(method)
        return os.path.join(self.folder, self.texts.of(given) if given is not None else usual)

    def description(self, exists: Callable[[str], bool], at: Place) -> Content:
        """Return the robot description that it loads."""
        folder = known_path(self.folder)
        if folder is None:
            return Content(None, None, at, command=f"cat {self.folder}")
        called = self.calls.get("robot_description")
        given = called.given("mappings", 1) if called else None
        mappings = table_of(given)
        values = {key: self.texts.of(value) for key, value in mappings.entries.items()} if mappings else {}
        whole = given is None or (mappings is not None and mappings.whole)
        names = tuple(mappings.keys.items()) if mappings else ()
        if self._given("robot_description") is not None:
            text = self.file("robot_description", "")
            named = known_path(text)
            command = None if named else f"cat {text}"
            return Content(named, tuple(values.items()) if whole else None, at, names, command=command)
        path, arguments = self._usual_description(exists)
        given_arguments = tuple(values.items()) if values else arguments
        return Content(path, given_arguments if whole else None, at, names)

    def _usual_description(self, exists: Callable[[str], bool]) -> tuple[str | None, tuple[tuple[str, str], ...]]:
        """The description in the package, else the one that the setup assistant was started with; its arguments."""
        setup = self._setup("URDF")
        words = [word.partition(":=") for word in setup.get("xacro_args", "").split() if ":=" in word]
        arguments = tuple((name, value) for name, _, value in words)
        modified = os.path.join(self.folder, f"config/{self.name}.urdf.xacro")
        if exists(modified):
            return known_path(modified), arguments
        package, relative = setup.get("package"), setup.get("relative_path")
        if package and relative:
            folder = self.texts.sources.find(package, self.call.at)
            return known_path(os.path.join(folder, relative)) if folder else None, arguments
        plain = os.path.join(self.folder, f"config/{self.name}.urdf")
        return (known_path(plain) if exists(plain) else None), arguments

    def files(self, at: Place, locate: Locate, *, namespace: str | None, sure: bool, runs: bool) -> MoveItFiles:
        """Return the files that it reads."""

        def reference(path: str | None) -> FileReference | None:
            known = known_path(path) if path else None
            return FileReference(known, at, *locate(known)) if known else None

        called = self.calls.get(_SEMANTIC)
        mappings = called.given("mappings", 1) if called else None
        usual = self._setup("SRDF").get("relative_path") or f"config/{self.name}.srdf"
        controllers = reference(self._controllers())
        pipelines = ((name, reference(path)) for name, path in self._pipelines())
        return MoveItFiles(
            at=at,
            semantic=reference(self.file(_SEMANTIC, usual)),
            arguments=() if mappings is None else None,
            kinematics=reference(self.file(_KINEMATICS, _FILES[_KINEMATICS])),
            limits=reference(self.file("joint_limits", _FILES["joint_limits"])),
            controllers=(controllers,) if controllers else (),
            pipelines=tuple((name, file) for name, file in pipelines if file),
            namespace=namespace,
            sure=sure,
            as_values=True,
            runs=runs,
            undecided=self._undecided() if controllers is None else None,
        )

    def spawned(self) -> tuple[Word, ...] | None:
        """Return the controllers that `generate_spawn_controllers_launch` spawns; None if they are not known.

        They are those that MoveIt's own controllers have the names of, and then the joint state broadcaster
        (moveit_configs_utils, launches.py).
        """
        path = known_path(self._controllers() or UNKNOWN)
        file = self.texts.sources.values(path) if path else None
        if not isinstance(file, Table):
            return None
        manager = file.entries.get(_MANAGER)
        names = manager.entries.get("controller_names") if isinstance(manager, Table) else Items([], self.call.at)
        if not isinstance(names, Items):
            return None
        words = [Word(self.texts.of(value), value.at) for value in names.values]
        return (*words, Word("joint_state_broadcaster", self.call.at))

    def _given(self, method: str) -> Term | None:
        called = self.calls.get(method)
        return called.given("file_path", 0) if called else None

    def _controllers(self) -> str | None:
        """The file with MoveIt's controllers; None if the builder cannot choose one."""
        if self._given("trajectory_execution") is not None:
            return self.file("trajectory_execution", "")
        return usual_controllers(self.folder, self.name)

    def _undecided(self) -> tuple[str, ...] | None:
        """The files with controllers of which the builder can choose none; None if the folder cannot be listed."""
        folder = os.path.join(self.folder, "config")
        if not listed_names(folder) or self._given("trajectory_execution") is not None:
            return None
        return tuple(sorted(controllers_in(folder)))

    def _pipelines(self) -> Iterator[tuple[str, str]]:
        called = self.calls.get("planning_pipelines")
        given = called.given("pipelines", 1) if called else None
        folder = os.path.join(self.folder, "config")
        ending = "_planning.yaml"
        names = [name.removesuffix(ending) for name in listed_names(folder) if name.endswith(ending)]
        if isinstance(given, Items):
            wanted = {self.texts.of(value) for value in given.values}
            names = [name for name in names if name in wanted]
        return ((name, os.path.join(folder, name + ending)) for name in names)

    def _setup(self, part: str) -> dict[str, str]:
        """The texts of a section of .setup_assistant."""
        path = known_path(os.path.join(self.folder, ".setup_assistant"))
        file = self.texts.sources.values(path) if path else None
        config = file.entries.get("moveit_setup_assistant_config") if isinstance(file, Table) else None
        tables = (config.entries.get(name) for name in (part, part.lower())) if isinstance(config, Table) else ()
        table = next((each for each in tables if isinstance(each, Table)), None)
        values = table.entries.items() if table else ()
        return {name: str(value.value) for name, value in values if isinstance(value, Constant) and value.value}


def builder_of(term: Term | None, texts: Texts) -> Builder | None:
    """Return the MoveItConfigsBuilder at the start of a chain of calls; None if there is none."""
    chain = chain_of(term)
    return Builder(*chain, texts) if chain else None


def files_of_table(
    table: Table, at: Place, read: Callable[[Term], Content | None], locate: Locate
) -> MoveItFiles | None:
    """Return the files whose content is in a dict of parameters for a node; None if there is none for MoveIt.

    read: returns the file whose text a term is, and the xacro arguments for it.
    """
    found = MoveItFiles(at, as_values=True)
    semantic = table.entries.get(_SEMANTIC)
    if semantic is not None:
        content = read(semantic)
        path = content.path if content else None
        where = locate(path) if path else (None, None)
        file = FileReference(path or UNKNOWN, semantic.at, *where)
        arguments, as_yaml = (content.arguments, content.as_yaml) if content else (None, False)
        found = found._replace(semantic=file, arguments=arguments, as_yaml=as_yaml)
    controllers, kinematics = _file_of(table.entries.get(_MANAGER)), _file_of(table.entries.get(_KINEMATICS))
    bare = next(_with(table, "kinematics_solver"), None) if kinematics is None else None
    found = found._replace(
        kinematics=kinematics or (bare and bare[1]),
        limits=_file_of(table.entries.get(_PLANNING)),
        controllers=(controllers,) if controllers else (),
        pipelines=tuple(dict.fromkeys(pair for key in _OF_PIPELINE for pair in _with(table, key))),
        bare_kinematics=bare is not None,
    )
    return None if found == MoveItFiles(at, as_values=True) else found


def _with(table: Table, key: str) -> Iterator[tuple[str, FileReference]]:
    """Yield the entries of a dict that were read from YAML files and have a key, with their files."""
    for name, value in table.entries.items():
        file = _file_of(value)
        if file is not None and isinstance(value, Table) and key in value.entries:
            yield name, file


def _file_of(term: Term | None) -> FileReference | None:
    """The YAML file that a dict was read from."""
    path = term.at.source.path if isinstance(term, Table) else ""
    return FileReference(path, term.at, path, True) if term and path.endswith((".yaml", ".yml")) else None  # noqa: FBT003


def _folder(call: Called, texts: Texts) -> str:
    """The folder of the package that a builder reads; contains UNKNOWN if it is unknown."""
    given = call.given("package_name") or call.given("robot_name", 0)
    name = texts.of(given)
    if given is None or UNKNOWN in name:
        return UNKNOWN
    package = name if call.given("package_name") else f"{name}_moveit_config"
    return texts.sources.find(package, given.at) or outside(package)
