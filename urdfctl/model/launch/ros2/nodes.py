"""The nodes and commands of ROS 2 launch files: their arguments and parameters, and which of them load controllers."""

from __future__ import annotations

from collections.abc import Iterator, Sequence

from urdfctl.model.launch import UNCHANGED, Node, Rewriting, Spawn, Started, Word, joined
from urdfctl.model.launch.ros2.actions import NODES
from urdfctl.model.launch.ros2.descriptions import as_written
from urdfctl.model.launch.ros2.facts import LaunchFacts
from urdfctl.model.launch.ros2.moveit import INCLUDED_BY_DEMO, builder_of
from urdfctl.model.launch.ros2.parameters import DESCRIBED, MANAGERS, NodeParameters
from urdfctl.model.launch.ros2.simulators import WEBOTS_DRIVER, package_outside
from urdfctl.model.launch.ros2.spawner import SpawnerArguments, command_arguments, manager_of, spawner_arguments
from urdfctl.model.launch.ros2.texts import Content, Texts, rewriting_of
from urdfctl.source.launch.terms import Called, Constant, Items, OneOf, Perhaps, Table, Term, UnknownTerm
from urdfctl.source.opaque import UNKNOWN, if_known
from urdfctl.source.span import Place
from urdfctl.startup.records import NamedTuple

SPAWNERS = ("spawner", "spawner.py")
_MOVE_GROUP = ("moveit_ros_move_group", "move_group")
_FILE_OPTIONS = ("-file", "--file")
_NAMING = ("controller_name", "controller_names", "controller_info_dict")
_ALTERNATIVE = {"package": "node_package", "executable": "node_executable", "name": "node_name"}
"""The keywords of a node with their names in older distros."""


_LASTING = frozenset({"ros2_control_node", "robot_state_publisher", "gzserver", "parameter_bridge"})
"""Programs that run until the launch ends."""


class _Run(NamedTuple):
    """When an action runs: as the state of the launch file says in which it is."""

    sure: bool
    held: bool
    after: tuple[str, ...] = ()


class Nodes:
    """Adds the effects of single actions to the collected facts."""

    def __init__(self, facts: LaunchFacts, texts: Texts) -> None:
        self.facts = facts
        self.texts = texts
        self._rewritings: dict[tuple[str, int], Rewriting] = {}

    # -- nodes -------------------------------------------------------------------------------------------------------

    def node(self, term: Called, *, sure: bool, held: bool, after: tuple[str, ...] = ()) -> None:
        """Add a node: a spawner, a controller manager or another node."""
        package, executable = self._word(term, "package"), self._word(term, "executable")
        if not held:
            if self.is_spawner(package, executable):
                self.facts.elsewhere.append(self._spawn(term, executable, _Run(sure, held, after)))
            return
        words, complete = self._split(term, "arguments")
        name = self._word(term, "name").known if _given(term, "name") is not None else None
        namespace = if_known(self._namespace(term))
        parameters = NodeParameters(
            term.keywords.get("parameters"),
            _program(package, executable),
            facts=self.facts,
            texts=self.texts,
            namespace=namespace,
            sure=sure,
            name=name,
        )
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
        if self.is_spawner(package, executable):
            self.facts.spawns.append(self._spawn(term, executable, _Run(sure, held, after)))
        else:
            self._described_by(words, executable.text, namespace, sure=sure)

    @staticmethod
    def is_spawner(package: Word, executable: Word) -> bool:
        """Return whether a program of a package is the spawner of controllers."""
        return package.text == "controller_manager" and executable.text in SPAWNERS

    def spawner_arguments(self, term: Called) -> SpawnerArguments | None:
        """Return the spawner's arguments of an action; None if it is not a spawner."""
        if term.short in NODES:
            if not self.is_spawner(self._word(term, "package"), self._word(term, "executable")):
                return None
            words, complete = self._split(term, "arguments")
            return spawner_arguments(words, complete=complete)
        command = command_arguments(self._split(term, "cmd")[0])
        return command[1] if command else None

    def started(self, term: Called) -> Started:
        """Return what an action starts; nothing if it is no process."""
        arguments = self.spawner_arguments(term)
        names = tuple(word.text for word in arguments.names) if arguments else ()
        is_node = term.short in NODES
        return Started(self._word(term, "executable").text if is_node else "", names)

    def lasts(self, term: Called) -> bool:
        """Return whether an action starts a program that runs until the launch ends."""
        return term.short in NODES and self._word(term, "executable").text in _LASTING

    def _spawn(self, term: Called, program: Word, run: _Run) -> Spawn:
        words, complete = self._split(term, "arguments")
        parsed = spawner_arguments(words, complete=complete)
        files = [*parsed.values("-p", "--param-file"), *self._files(term.keywords.get("parameters"))]
        at = term.keywords["arguments"].at if "arguments" in term.keywords else term.at
        return self._spawn_with(parsed, program, at, self._namespace(term), files=files, run=run)

    def _spawn_with(
        self,
        parsed: SpawnerArguments,
        program: Word,
        at: Place,
        namespace: str,
        files: Sequence[Word],
        run: _Run,
    ) -> Spawn:
        for given in parsed.values("-n", "--namespace"):
            namespace = joined("", given.text)
        manager, manager_namespace = manager_of(parsed.manager, namespace)
        references = tuple(
            self.facts.load(
                word,
                program.text,
                sure=run.sure,
                held=run.held,
                of=if_known(namespace),
                rewriting=self._rewritings.get((word.text, word.at.start), UNCHANGED),
            )
            for word in files
        )
        names = tuple((word.text, word.at) for word in parsed.names)
        return Spawn(
            names=names,
            namespace=manager_namespace,
            at=at,
            active=parsed.active,
            sure=run.sure,
            complete=parsed.complete,
            manager=manager,
            program=program,
            options=parsed.options,
            files=references,
            after=run.after,
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
        spawn = self._spawn_with(
            parsed, program, term.at, self.texts.scope.namespace, files=paths, run=_Run(sure, held)
        )
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
            self.facts.moveit.append(
                builder.files(term.at, self.facts.locate, namespace=namespace, sure=sure, runs=runs)
            )
            if runs or kind == "generate_rsp_launch":
                content = builder.description(self.facts.exists, term.at)
                self.facts.described(content, DESCRIBED[0] if not runs else "move_group", namespace, sure=sure)
        if demo or kind == "generate_spawn_controllers_launch":
            words = builder.spawned() if builder is not None else None
            for word in words or ():
                names = ((word.text, word.at),)
                self.facts.spawns.append(Spawn(names, namespace, term.at, sure=sure, complete=UNKNOWN not in word.text))
            if words is None:
                self.facts.spawns.append(Spawn((), namespace, term.at, sure=sure, complete=False))
        if demo:
            if builder is not None and term.given("launch_package_path", 1) is None:
                self._included_by_demo(builder.folder, term.at, sure=sure)
            folder = builder.folder if builder else UNKNOWN
            controllers = Word(f"{folder}/config/ros2_controllers.yaml", term.at)
            self.facts.load(controllers, MANAGERS[0], sure=sure, of=namespace)
            self.facts.nodes += _of_demo(controllers, namespace, sure=sure)

    def _included_by_demo(self, folder: str, at: Place, *, sure: bool) -> None:
        """Add the launch files of the package that MoveIt's demo includes, and that are missing."""
        for name in INCLUDED_BY_DEMO:
            path = f"{folder}/launch/{name}.launch.py"
            if UNKNOWN not in path and self.facts.locate(path)[1] is False:
                self.facts.reference(path, at, "include", sure=sure)

    def program(self, term: Called) -> tuple[str, ...]:
        """Return the package and the executable of an action that starts a node."""
        return tuple(self._word(term, keyword).text for keyword in ("package", "executable") if _given(term, keyword))

    # -- commands ----------------------------------------------------------------------------------------------------

    def command(self, term: Called, *, sure: bool, held: bool, after: tuple[str, ...]) -> tuple[Word, ...]:
        """Add a process, which may load controllers. Return the words of its command line."""
        words, complete = self._split(term, "cmd")
        command = command_arguments(words)
        if command is not None:
            program, parsed = command
            parsed = parsed._replace(complete=parsed.complete and complete)
            files = list(parsed.values("-p", "--param-file"))
            spawn = self._spawn_with(parsed, program, term.at, "", files=files, run=_Run(sure, held, after))
            (self.facts.spawns if held else self.facts.elsewhere).append(spawn)
        elif held and [word.text for word in words[:2]] == ["ros2", "run"]:
            self._run(words[2:], term.at, sure=sure)
        return words

    def _run(self, words: Sequence[Word], at: Place, *, sure: bool) -> None:
        """Add the node that `ros2 run` starts, in no namespace of the launch file's. Its parameters are not read."""
        if len(words) < 2 or words[0].text.startswith("-"):  # noqa: PLR2004 (a package and a program)
            return
        package, program, *given = words
        namespace = None if any("__ns" in word.text or word.known is None for word in given) else ""
        node = Node(package, program, None, namespace, at, words=tuple(given), sure=sure, complete=False)
        self.facts.nodes.append(node)
        self._described_by(given, program.text, namespace, sure=sure)

    # -- words -------------------------------------------------------------------------------------------------------

    def _split(self, term: Called, keyword: str) -> tuple[tuple[Word, ...], bool]:
        """The words of a process, and whether they are fully known. A shell splits them again (launch ExecuteLocal)."""
        words, complete = self._words(term.given(keyword, 0 if keyword == "cmd" else None))
        if self.texts.truth(term.keywords.get("shell")):
            words = tuple(Word(part, word.at) for word in words for part in word.text.split())
        return words, complete

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
                words.append(self._written(value))
        return tuple(words), complete

    def _written(self, value: Term) -> Word:
        """The text of a term; how it rewrites a file is remembered."""
        word = Word(self.texts.of(value), value.at)
        rewriting = rewriting_of(value, self.texts)
        if rewriting is not UNCHANGED:
            self._rewritings[word.text, word.at.start] = rewriting
        return word

    def _remaps(self, term: Term | None) -> Iterator[tuple[str, str]]:
        for pair in term.values if isinstance(term, Items) else ():
            if isinstance(pair, Items) and len(pair.values) == 2:  # noqa: PLR2004 (from and to)
                yield self.texts.of(pair.values[0]), self.texts.of(pair.values[1])

    def _files(self, term: Term | None) -> Iterator[Word]:
        """The parameter files among a node's `parameters`."""
        for value in term.values if isinstance(term, Items) else ():
            if isinstance(value, (Constant, Called)) and self.texts.of(value):
                yield self._written(value)

    def files_given(self, given: Table | None, texts: Texts, *, sure: bool) -> None:
        """Add the files in the arguments of an included launch file, such as the world of a simulator."""
        for value in given.entries.values() if given else ():
            for word in texts.of(value).split():
                self.facts.named_file(Word(word, value.at), sure=sure)

    def _described_by(self, words: Sequence[Word], executable: str, namespace: str | None, *, sure: bool) -> None:
        """Add the files in a node's arguments.

        A URDF file is a description for robot_state_publisher (its old form), or for a program that spawns models.
        """
        for index, word in enumerate(words):
            if word.known is None and package_outside(word.text) is None:
                continue
            named = index > 0 and words[index - 1].text in _FILE_OPTIONS
            if word.text.endswith(".urdf") and (executable in DESCRIBED or named):
                content = as_written(Content(word.text, (), word.at), self.texts, self.facts.exists)
                self.facts.described(content, executable, namespace, sure=sure)
            else:
                self.facts.named_file(word._replace(text=word.text.rpartition(":=")[2]), sure=sure)


def _of_demo(controllers: Word, namespace: str | None, *, sure: bool) -> Iterator[Node]:
    """Yield the nodes of MoveIt's demo that have to do with controllers (moveit_configs_utils, launches.py).

    The manager gets the description as a parameter in humble, by a remapping in jazzy.
    """
    at = controllers.at
    publisher = "robot_state_publisher"
    described = (Word("robot_description", at),)
    yield Node(Word(publisher, at), Word(publisher, at), publisher, namespace, at, parameters=described, sure=sure)
    yield Node(
        package=Word("controller_manager", at),
        executable=Word(MANAGERS[0], at),
        name=None,
        namespace=namespace,
        at=at,
        remaps=(("~/robot_description", "/robot_description"),),
        sure=sure,
        files=(controllers,),
    )


def _program(package: Word, executable: Word) -> str:
    """The name by which a program is known; empty if it has only the name of MoveIt's, as clients of it do."""
    if package.text == WEBOTS_DRIVER:
        return WEBOTS_DRIVER
    is_other = package.known is not None and package.text != _MOVE_GROUP[0]
    return "" if executable.text == _MOVE_GROUP[1] and is_other else executable.text


def _given(term: Called, keyword: str) -> Term | None:
    argument = term.keywords.get(keyword) or term.keywords.get(_ALTERNATIVE[keyword])
    return None if isinstance(argument, Constant) and argument.value is None else argument


def _as_list(term: Term | None) -> Term | None:
    return Items([term], term.at) if isinstance(term, (Constant, Called, UnknownTerm)) else term


def _one_word(term: OneOf) -> bool:
    return all(isinstance(option, (Constant, Called)) for option in term.options)
