"""The nodes and commands of ROS 2 launch files: their arguments and parameters, and which of them load controllers."""

from __future__ import annotations

import os
import re
from collections.abc import Callable, Iterator, Sequence

from urdfctl.model.controllers import FileReference
from urdfctl.model.descriptions import content_of, is_of_other_node
from urdfctl.model.launch import Description, Node, ParameterLoad, Reference, Spawn, Word, joined
from urdfctl.model.launch_moveit import builder_of, files_of_table
from urdfctl.model.launch_texts import Content, Texts, replaced_by
from urdfctl.model.moveit_files import MoveItFiles
from urdfctl.model.spawner import SpawnerArguments, command_arguments, manager_of, spawner_arguments
from urdfctl.source.launch.terms import Called, Constant, Items, Member, Missing, OneOf, Perhaps, Table, Term
from urdfctl.source.opaque import UNKNOWN, if_known
from urdfctl.source.span import Place

SPAWNERS = ("spawner", "spawner.py")
MANAGERS = ("ros2_control_node",)
_DESCRIBED = ("robot_state_publisher", *MANAGERS, "move_group")
_OF_MANAGERS = r"ros2_control|controller_manager"
_SEMANTIC = "robot_description_semantic"
_FILE_OPTIONS = ("-file", "--file")
_SUFFIXES = (".yaml", ".yml", ".urdf", ".xacro", ".rviz", ".sdf", ".world", ".srdf")
_NAMING = ("controller_name", "controller_names", "controller_info_dict")
_ALTERNATIVE = {"package": "node_package", "executable": "node_executable", "name": "node_name"}
"""The keywords of a node with their names in older distros."""


class Gathered:
    """The facts that are collected while a launch file is followed."""

    def __init__(self) -> None:
        self.descriptions: list[Description] = []
        self.loads: list[ParameterLoad] = []
        self.spawns: list[Spawn] = []
        self.elsewhere: list[Spawn] = []
        self.nodes: list[Node] = []
        self.references: dict[tuple[str, int], Reference] = {}
        self.moveit: list[MoveItFiles] = []
        self.altered = False
        """Whether an action changes the parameters or remappings of all following nodes."""


class Nodes:
    """Adds the effects of single actions to the collected facts."""

    def __init__(self, facts: Gathered, texts: Texts, locate: Callable[[str], tuple[str, bool | None]]) -> None:
        self.facts = facts
        self.texts = texts
        self._locate = locate

    # -- nodes -------------------------------------------------------------------------------------------------------

    def node(self, term: Called, *, sure: bool, held: bool, after: tuple[str, ...] = ()) -> None:
        """Add a node: a spawner, a controller manager or another node."""
        package, executable = self._word(term, "package"), self._word(term, "executable")
        if not held:
            if self._is_spawner(package, executable):
                self.facts.elsewhere.append(self._spawn(term, executable, sure=sure, after=after))
            return
        parameters = _Parameters(self, term, executable.text, sure=sure)
        words, complete = self._words(term.keywords.get("arguments"))
        name = self._word(term, "name").known if _given(term, "name") is not None else None
        namespace = if_known(self._namespace(term))
        remaps = tuple(self._remaps(term.keywords.get("remappings")))
        self.facts.nodes.append(
            Node(
                package=package,
                executable=executable,
                name=name,
                namespace=namespace,
                at=term.at,
                words=words,
                parameters=tuple(parameters.names),
                remaps=remaps,
                sure=sure,
                complete=parameters.complete and complete and not self.facts.altered,
                files=tuple(parameters.files),
                values=tuple(parameters.values.items()),
            )
        )
        if self._is_spawner(package, executable):
            self.facts.spawns.append(self._spawn(term, executable, sure=sure, after=after))
        else:
            self._described_by(words, executable.text, namespace, sure=sure)

    @staticmethod
    def _is_spawner(package: Word, executable: Word) -> bool:
        return package.text == "controller_manager" and executable.text in SPAWNERS

    def spawner_arguments(self, term: Called) -> SpawnerArguments | None:
        """Return the spawner's arguments of an action; None if it is not a spawner."""
        if term.short in {"Node", "LifecycleNode"}:
            if not self._is_spawner(self._word(term, "package"), self._word(term, "executable")):
                return None
            words, complete = self._words(term.keywords.get("arguments"))
            return spawner_arguments(words, complete=complete)
        command = command_arguments(self._command_words(term)[0])
        return command[1] if command else None

    def _spawn(self, term: Called, program: Word, *, sure: bool, after: tuple[str, ...]) -> Spawn:
        words, complete = self._words(term.keywords.get("arguments"))
        parsed = spawner_arguments(words, complete=complete)
        files = [*parsed.values("-p", "--param-file"), *self._files(term.keywords.get("parameters"))]
        at = term.keywords["arguments"].at if "arguments" in term.keywords else term.at
        return self._spawn_with(parsed, program, at, self._namespace(term), files, sure=sure, after=after)

    def _spawn_with(
        self,
        parsed: SpawnerArguments,
        program: Word,
        at: Place,
        namespace: str,
        files: Sequence[Word],
        *,
        sure: bool,
        after: tuple[str, ...] = (),
    ) -> Spawn:
        for given in parsed.values("-n", "--namespace"):
            namespace = joined("", given.text)
        manager, manager_namespace = manager_of(parsed.manager, namespace)
        references = tuple(self.load(word, program.text, sure=sure, of=if_known(namespace)) for word in files)
        names = tuple((word.text, word.at) for word in parsed.names)
        return Spawn(
            names=names,
            namespace=manager_namespace,
            at=at,
            active=parsed.active,
            sure=sure,
            complete=parsed.complete,
            manager=manager,
            program=program,
            options=parsed.options,
            files=references,
            after=after,
        )

    def helper(self, term: Called, *, sure: bool, held: bool) -> None:
        """Add a spawner from a function of controller_manager's launch_utils."""
        names = next((given for key in _NAMING if (given := term.given(key))), None) or term.given("", 0)
        files = term.given("controller_params_file") or term.given("controller_params_files")
        table = names if isinstance(names, Table) else None
        file_lists: list[Term | None] = [files, *table.entries.values()] if table else [files]
        keys = Items([Constant(key, place) for key, place in table.keys.items()], table.at) if table else None
        words, complete = self._words(keys or _as_list(names))
        more, known = self._words(term.given("extra_spawner_args"))
        parsed = spawner_arguments([*words, *more], complete=complete and known and (table is None or table.whole))
        manager = self.texts.scope.settings.get("controller_manager_name", "controller_manager")
        parsed = parsed._replace(manager=parsed.manager or manager)
        paths = [word for file_list in file_lists for word in self._words(_as_list(file_list))[0] if word.text]
        program = Word("spawner", term.at)
        spawn = self._spawn_with(parsed, program, term.at, self.texts.scope.namespace, paths, sure=sure)
        (self.facts.spawns if held else self.facts.elsewhere).append(spawn)

    def moveit(self, term: Called, *, sure: bool, held: bool) -> None:
        """Add what a function of moveit_configs_utils.launches starts.

        The demo also starts a controller manager with ros2_controllers.yaml, and spawners of MoveIt's controllers.
        """
        builder = builder_of(term.given("moveit_config", 0), self.texts)
        kind, namespace = term.short, if_known(self.texts.scope.namespace)
        demo = kind == "generate_demo_launch"
        if not held:
            return
        if builder is not None:
            runs = demo or kind == "generate_move_group_launch"
            self.facts.moveit.append(builder.files(term.at, self._locate, namespace=namespace, sure=sure, runs=runs))
            if runs or kind == "generate_rsp_launch":
                content = builder.description(lambda path: bool(self._locate(path)[1]), term.at)
                self.described(content, _DESCRIBED[0] if not runs else "move_group", namespace, sure=sure)
        if demo or kind == "generate_spawn_controllers_launch":
            self.facts.spawns.append(Spawn((), namespace, term.at, sure=sure, complete=False))
        if demo:
            folder = builder.folder if builder else UNKNOWN
            controllers = Word(f"{folder}/config/ros2_controllers.yaml", term.at)
            self.load(controllers, MANAGERS[0], sure=sure, of=namespace)

    # -- commands ----------------------------------------------------------------------------------------------------

    def command(self, term: Called, *, sure: bool, held: bool, after: tuple[str, ...]) -> tuple[Word, ...]:
        """Add a process, which may load controllers. Return the words of its command line."""
        words, complete = self._command_words(term)
        command = command_arguments(words)
        if command is not None:
            program, parsed = command
            parsed = parsed._replace(complete=parsed.complete and complete)
            files = list(parsed.values("-p", "--param-file"))
            spawn = self._spawn_with(parsed, program, term.at, "", files, sure=sure, after=after)
            (self.facts.spawns if held else self.facts.elsewhere).append(spawn)
        return words

    def _command_words(self, term: Called) -> tuple[tuple[Word, ...], bool]:
        words, complete = self._words(term.given("cmd", 0))
        if self.texts.truth(term.keywords.get("shell")):
            words = tuple(Word(part, word.at) for word in words for part in word.text.split())
        return words, complete

    # -- words -------------------------------------------------------------------------------------------------------

    def _word(self, term: Called, keyword: str) -> Word:
        given = _given(term, keyword)
        return Word(self.texts.of(given), given.at if given is not None else term.at)

    def _namespace(self, term: Called) -> str:
        given = term.keywords.get("namespace") or term.keywords.get("node_namespace")
        return joined(self.texts.scope.namespace, self.texts.of(given) if given is not None else "")

    def _words(self, term: Term | None) -> tuple[tuple[Word, ...], bool]:
        """The words of a list, and whether the list is fully known."""
        if term is None:
            return (), True
        if not isinstance(term, Items):
            return (), isinstance(term, Constant) and term.value is None
        words, complete = [], True
        for value in term.values:
            if isinstance(value, Perhaps) or (isinstance(value, OneOf) and not _one_word(value)):
                complete = False
            else:
                words.append(Word(self.texts.of(value), value.at))
        return tuple(words), complete

    def _remaps(self, term: Term | None) -> Iterator[tuple[str, str]]:
        for pair in term.values if isinstance(term, Items) else ():
            if isinstance(pair, Items) and len(pair.values) == 2:  # noqa: PLR2004 (from and to)
                yield self.texts.of(pair.values[0]), self.texts.of(pair.values[1])

    def _files(self, term: Term | None) -> Iterator[Word]:
        """The parameter files among a node's `parameters`."""
        for value in term.values if isinstance(term, Items) else ():
            if isinstance(value, (Constant, Called)) and (text := self.texts.of(value)):
                yield Word(text, value.at)

    # -- files -------------------------------------------------------------------------------------------------------

    def load(self, file: Word, node: str, *, sure: bool, of: str | None, term: Term | None = None) -> FileReference:
        """Add a parameter file of a controller manager or a spawner, and return the reference to it.

        of: the node's namespace; None if unknown.
        term: the file as the launch file gives it; None if it is a plain path.
        """
        reference = self.reference(file.text, file.at, "parameters", sure=sure)
        replaced = replaced_by(term, self.texts)
        self.facts.loads.append(ParameterLoad(reference, "", file.at, sure, node=node, of=of, replaced=replaced))
        return reference

    def reference(self, path: str, at: Place, use: str, *, sure: bool) -> FileReference:
        """Add a reference to a file, if its path is known, and return it."""
        known = if_known(path)
        located, exists = self._locate(known) if known else (None, None)
        if known and not os.path.isabs(known):
            located, exists = None, None  # depends on the folder that the launch is started in
        reference = FileReference(path, at, located, exists)
        if located is not None:
            self.facts.references.setdefault((located, at.start), Reference(reference, use, None, sure))
        return reference

    def described(self, content: Content, node: str, namespace: str | None, *, sure: bool) -> None:
        """Add a robot description that is passed to a node."""
        file = self.reference(content.path or UNKNOWN, content.at, "description", sure=sure)
        names = tuple(Word(name, at) for name, at in content.names)
        self.facts.descriptions.append(
            Description(
                file=file,
                arguments=content.arguments,
                namespace=namespace,
                at=content.at,
                sure=sure,
                names=names,
                command=content.command,
                node=node,
                alternatives=content.alternatives,
                as_yaml=content.as_yaml,
                more=content.more,
            )
        )

    def worlds(self, given: Table | None, texts: Texts, *, sure: bool) -> None:
        """Add the world files in the arguments of a simulator."""
        for value in given.entries.values() if given else ():
            for word in texts.of(value).split():
                if word.endswith((".world", ".sdf")) and os.path.isabs(word) and UNKNOWN not in word:
                    self.reference(word, value.at, "argument", sure=sure)

    def _described_by(self, words: Sequence[Word], executable: str, namespace: str | None, *, sure: bool) -> None:
        """Add the files in a node's arguments.

        A URDF file is a description for robot_state_publisher (its old form), or for a program that spawns models.
        """
        for index, word in enumerate(words):
            if word.known is None:
                continue
            named = index > 0 and words[index - 1].text in _FILE_OPTIONS
            if word.text.endswith(".urdf") and (executable in _DESCRIBED or named):
                self.described(Content(word.text, (), word.at), executable, namespace, sure=sure)
            elif word.text.endswith(_SUFFIXES) and os.path.isabs(word.text):
                self.reference(word.text, word.at, "argument", sure=sure)


class _Parameters:
    """The `parameters` of a node: names of single parameters, and files. A controller manager's files are loaded.

    names: the names of single parameters.
    values: the texts of single parameters by name, with UNKNOWN for what is not known.
    files: the files.
    complete: False if some of them are unknown.
    """

    def __init__(self, nodes: Nodes, term: Called, executable: str, *, sure: bool) -> None:
        self.nodes = nodes
        self.executable = executable
        self.sure = sure
        self.names: list[Word] = []
        self.values: dict[str, str] = {}
        self.files: list[Word] = []
        self.complete = True
        self.namespace = if_known(nodes._namespace(term))
        given = term.keywords.get("parameters")
        if isinstance(given, Items):
            for value in given.values:
                self._add(value)
        elif given is not None:
            self.complete = False

    def _add(self, term: Term) -> None:
        if isinstance(term, Perhaps):
            self.complete = False
            self._add(term.term)
        elif isinstance(term, OneOf):
            self.complete = False
            for option in term.options:
                self._add(option)
        elif isinstance(term, Table):
            self._table(term)
        elif isinstance(term, (Member, Called)) and builder_of(term, self.nodes.texts) is not None:
            self._of_builder(term)
        elif isinstance(term, (Constant, Called)) or (isinstance(term, Items) and _is_path(term)):
            self._file(term)
        elif isinstance(term, Items):
            for value in term.values:
                self._add(value)
        else:
            self.complete = False

    def _table(self, table: Table) -> None:
        self.complete = self.complete and table.whole
        for name, value in table.entries.items():
            self.names.append(Word(name, table.keys[name]))
            if isinstance(value, (Constant, Called)) and name != "robot_description":
                self.values[name] = self.nodes.texts.of(value)
            if name == "robot_description":
                self._description(value)
        read = lambda term: content_of(term, self.nodes.texts, lambda _: False)  # noqa: E731 (one use)
        files = files_of_table(table, table.at, read, self.nodes._locate)
        if files is not None:
            runs = self.executable == "move_group"
            self.nodes.facts.moveit.append(files._replace(namespace=self.namespace, sure=self.sure, runs=runs))

    def _of_builder(self, term: Member | Called) -> None:
        """Add the parameters of a MoveItConfigsBuilder: one of its dicts, or all of them (`to_dict()`)."""
        self.complete = False
        nodes, builder = self.nodes, builder_of(term, self.nodes.texts)
        if isinstance(term, Member) and term.name == "robot_description":
            self.names.append(Word(term.name, term.at))
            self._description(term)
        elif builder is not None and (isinstance(term, Called) or term.name == _SEMANTIC):
            runs = self.executable == "move_group"
            files = builder.files(term.at, nodes._locate, namespace=self.namespace, sure=self.sure, runs=runs)
            nodes.facts.moveit.append(files)
            if runs and isinstance(term, Called):
                exists = lambda path: bool(nodes._locate(path)[1])  # noqa: E731 (one use)
                nodes.described(builder.description(exists, term.at), self.executable, self.namespace, sure=self.sure)

    def _description(self, value: Term) -> None:
        if self.executable not in _DESCRIBED:
            return
        nodes = self.nodes
        if is_of_other_node(value, nodes.texts):
            return
        content = content_of(value, nodes.texts, lambda path: bool(nodes._locate(path)[1]))
        content = content or Content(None, None, value.at)
        nodes.described(content, self.executable, self.namespace, sure=self.sure)

    def _file(self, term: Constant | Called | Items) -> None:
        text = self.nodes.texts.of(term)
        if isinstance(term, Called) and UNKNOWN in text and term.of is not None:
            self.complete = False  # a method's result: some dict
            return
        self.files.append(Word(text, term.at))
        if re.search(_OF_MANAGERS, self.executable):
            self.nodes.load(Word(text, term.at), self.executable, sure=self.sure, of=self.namespace, term=term)
        elif text:
            self.nodes.reference(text, term.at, "parameters", sure=self.sure)


def _is_path(items: Items) -> bool:
    """Whether a list inside `parameters` is one path in parts: launch_ros joins texts and substitutions."""
    parts = items.values
    return bool(parts) and all(
        isinstance(part, Constant) or (isinstance(part, Called) and part.short != "ParameterFile") for part in parts
    )


def _given(term: Called, keyword: str) -> Term | None:
    argument = term.keywords.get(keyword) or term.keywords.get(_ALTERNATIVE[keyword])
    return None if isinstance(argument, Constant) and argument.value is None else argument


def _as_list(term: Term | None) -> Term | None:
    return Items([term], term.at) if isinstance(term, (Constant, Called, Missing)) else term


def _one_word(term: OneOf) -> bool:
    return all(isinstance(option, (Constant, Called)) for option in term.options)
