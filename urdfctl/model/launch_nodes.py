"""The nodes and commands of ROS 2's launch files: what they are given, and which of them load controllers."""

from __future__ import annotations

import os
import re
from collections.abc import Callable, Iterator, Sequence

from urdfctl.model.controllers import FileReference
from urdfctl.model.descriptions import content_of, moveit_builder
from urdfctl.model.launch import Description, Node, ParameterLoad, Reference, Spawn, Word, joined
from urdfctl.model.launch_texts import Content, Texts
from urdfctl.model.spawner import Told, manager_of, told, told_by_command
from urdfctl.source.launch.terms import Called, Constant, Items, Member, Missing, OneOf, Perhaps, Table, Term
from urdfctl.source.opaque import UNKNOWN, if_known
from urdfctl.source.span import Place

SPAWNERS = ("spawner", "spawner.py")
MANAGERS = ("ros2_control_node",)
_DESCRIBED = ("robot_state_publisher", *MANAGERS)
_OF_MANAGERS = r"ros2_control|controller_manager"
_FILE_OPTIONS = ("-file", "--file")
_SUFFIXES = (".yaml", ".yml", ".urdf", ".xacro", ".rviz", ".sdf", ".world", ".srdf")
_NAMING = ("controller_name", "controller_names", "controller_info_dict")
_ALTERNATIVE = {"package": "node_package", "executable": "node_executable", "name": "node_name"}


class Gathered:
    """What is found while a launch file is followed."""

    def __init__(self) -> None:
        self.descriptions: list[Description] = []
        self.loads: list[ParameterLoad] = []
        self.spawns: list[Spawn] = []
        self.elsewhere: list[Spawn] = []
        self.nodes: list[Node] = []
        self.references: dict[tuple[str, int], Reference] = {}
        self.altered = False
        """Whether something renames topics, or gives parameters, of all nodes that follow."""


class Nodes:
    """Adds what single actions do to what was found."""

    def __init__(self, found: Gathered, texts: Texts, locate: Callable[[str], tuple[str, bool | None]]) -> None:
        self.found = found
        self.texts = texts
        self._locate = locate

    # -- nodes -------------------------------------------------------------------------------------------------------

    def node(self, term: Called, *, sure: bool, held: bool, after: tuple[str, ...] = ()) -> None:
        """A node: a controller's spawner, a manager, or another."""
        package, executable = self._word(term, "package"), self._word(term, "executable")
        if not held:
            if self._is_spawner(package, executable):
                self.found.elsewhere.append(self._spawn(term, executable, sure=sure, after=after))
            return
        parameters = _Parameters(self, term, executable.text, sure=sure)
        words, complete = self._words(term.keywords.get("arguments"))
        name = self._word(term, "name").known if _given(term, "name") is not None else None
        namespace = if_known(self._namespace(term))
        remaps = tuple(self._remaps(term.keywords.get("remappings")))
        whole = parameters.complete and complete and not self.found.altered
        given = tuple(parameters.names), remaps
        files = tuple(parameters.files)
        self.found.nodes.append(
            Node(package, executable, name, namespace, term.at, words, *given, sure=sure, complete=whole, files=files)
        )
        if self._is_spawner(package, executable):
            self.found.spawns.append(self._spawn(term, executable, sure=sure, after=after))
        else:
            self._described_by(words, executable.text, namespace, sure=sure)

    @staticmethod
    def _is_spawner(package: Word, executable: Word) -> bool:
        return package.text == "controller_manager" and executable.text in SPAWNERS

    def told(self, term: Called) -> Told | None:
        """What an action tells the controller manager to load; None where it is no spawner."""
        if term.short in {"Node", "LifecycleNode"}:
            if not self._is_spawner(self._word(term, "package"), self._word(term, "executable")):
                return None
            words, complete = self._words(term.keywords.get("arguments"))
            return told(words, complete=complete)
        found = told_by_command(self._command_words(term)[0])
        return found[1] if found else None

    def _spawn(self, term: Called, program: Word, *, sure: bool, after: tuple[str, ...]) -> Spawn:
        words, complete = self._words(term.keywords.get("arguments"))
        said = told(words, complete=complete)
        files = [*said.values("-p", "--param-file"), *self._files(term.keywords.get("parameters"))]
        at = term.keywords["arguments"].at if "arguments" in term.keywords else term.at
        return self._made(said, program, at, self._namespace(term), files, sure=sure, after=after)

    def _made(
        self,
        said: Told,
        program: Word,
        at: Place,
        namespace: str,
        files: Sequence[Word],
        *,
        sure: bool,
        after: tuple[str, ...] = (),
    ) -> Spawn:
        for given in said.values("-n", "--namespace"):
            namespace = joined("", given.text)
        manager, of_manager = manager_of(said.manager, namespace)
        references = tuple(self.load(word, program.text, sure=sure) for word in files)
        names = tuple((word.text, word.at) for word in said.names)
        return Spawn(
            names, of_manager, at, said.active, sure, said.complete, manager, program, said.options, references, after
        )

    def helper(self, term: Called, *, sure: bool, held: bool) -> None:
        """A spawner that controller_manager's launch_utils make."""
        names = next((one for key in _NAMING if (one := term.given(key))), None) or term.given("", 0)
        files = term.given("controller_params_file") or term.given("controller_params_files")
        table = names if isinstance(names, Table) else None
        listed: list[Term] = [*table.entries.values()] if table else []
        keys = Items([Constant(key, place) for key, place in table.keys.items()], table.at) if table else None
        words, complete = self._words(keys or _as_list(names))
        more, known = self._words(term.given("extra_spawner_args"))
        said = told([*words, *more], complete=complete and known and (table is None or table.whole))
        given = [*self._words(_as_list(files))[0], *(w for one in listed for w in self._words(_as_list(one))[0])]
        manager = self.texts.scope.settings.get("controller_manager_name", "controller_manager")
        said = said._replace(manager=said.manager or manager)
        program = Word("spawner", term.at)
        spawn = self._made(said, program, term.at, self.texts.scope.namespace, [w for w in given if w.text], sure=sure)
        (self.found.spawns if held else self.found.elsewhere).append(spawn)

    def moveit_demo(self, term: Called, controllers: str, *, sure: bool, held: bool) -> None:
        """MoveIt's demo, which starts a manager and spawners of controllers that only its configuration knows."""
        spawn = Spawn((), if_known(self.texts.scope.namespace), term.at, sure=sure, complete=False)
        if held:
            self.load(Word(controllers, term.at), MANAGERS[0], sure=sure)
            self.found.spawns.append(spawn)

    # -- commands ----------------------------------------------------------------------------------------------------

    def command(self, term: Called, *, sure: bool, held: bool, after: tuple[str, ...]) -> tuple[Word, ...]:
        """A process: `ros2 control`, or another. Gives its words."""
        words, complete = self._command_words(term)
        found = told_by_command(words)
        if found is not None:
            said = found[1]._replace(complete=found[1].complete and complete)
            spawn = self._made(
                said, found[0], term.at, "", list(said.values("-p", "--param-file")), sure=sure, after=after
            )
            (self.found.spawns if held else self.found.elsewhere).append(spawn)
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
        """The words of a list, and whether it is known that these are all."""
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
        """The files among a node's parameters."""
        for value in term.values if isinstance(term, Items) else ():
            if isinstance(value, (Constant, Called)) and (text := self.texts.of(value)):
                yield Word(text, value.at)

    # -- files -------------------------------------------------------------------------------------------------------

    def load(self, file: Word, node: str, *, sure: bool) -> FileReference:
        """A parameter file that is given to a manager or a spawner."""
        reference = self.reference(file.text, file.at, "parameters", sure=sure)
        self.found.loads.append(ParameterLoad(reference, "", file.at, sure, node=node))
        return reference

    def reference(self, path: str, at: Place, use: str, *, sure: bool) -> FileReference:
        """A file that is used, noted where it is known which."""
        known = if_known(path)
        located, exists = self._locate(known) if known else (None, None)
        if known and not os.path.isabs(known):
            located, exists = None, None  # where it lies hangs on the folder that the launch is started in
        reference = FileReference(path, at, located, exists)
        if located is not None:
            self.found.references.setdefault((located, at.start), Reference(reference, use, None, sure))
        return reference

    def described(self, content: Content, node: str, namespace: str | None, *, sure: bool) -> None:
        """A robot description that a node is given."""
        file = self.reference(content.path or UNKNOWN, content.at, "description", sure=sure)
        names = tuple(Word(name, at) for name, at in content.names)
        self.found.descriptions.append(
            Description(file, content.arguments, namespace, content.at, sure, names, content.command, node)
        )

    def _described_by(self, words: Sequence[Word], executable: str, namespace: str | None, *, sure: bool) -> None:
        """A description that a node is given as a file: the old way of robot_state_publisher, and of a spawner of
        models."""
        for index, word in enumerate(words):
            if word.known is None:
                continue
            named = index > 0 and words[index - 1].text in _FILE_OPTIONS
            if word.text.endswith(".urdf") and (executable in _DESCRIBED or named):
                self.described(Content(word.text, (), word.at), executable, namespace, sure=sure)
            elif word.text.endswith(_SUFFIXES) and os.path.isabs(word.text):
                self.reference(word.text, word.at, "argument", sure=sure)


class _Parameters:
    """What a node's `parameters` hold: the names of those that are given one by one, and files, which are loaded where
    the node is a controller manager."""

    def __init__(self, nodes: Nodes, term: Called, executable: str, *, sure: bool) -> None:
        self.nodes = nodes
        self.executable = executable
        self.sure = sure
        self.names: list[Word] = []
        self.files: list[Word] = []
        self.complete = True
        self.namespace = if_known(nodes._namespace(term))
        given = term.keywords.get("parameters")
        if isinstance(given, Items):
            for value in given.values:
                self._one(value)
        elif given is not None:
            self.complete = False

    def _one(self, term: Term) -> None:
        if isinstance(term, Perhaps):
            self.complete = False
            self._one(term.term)
        elif isinstance(term, OneOf):
            self.complete = False
            for option in term.options:
                self._one(option)
        elif isinstance(term, Table):
            self._table(term)
        elif isinstance(term, Member) and moveit_builder(term)[0] is not None:
            self._member(term)
        elif isinstance(term, (Constant, Called)):
            self._file(term)
        elif isinstance(term, Items):
            for value in term.values:
                self._one(value)
        else:
            self.complete = False

    def _table(self, table: Table) -> None:
        self.complete = self.complete and table.whole
        for name, value in table.entries.items():
            self.names.append(Word(name, table.keys[name]))
            if name == "robot_description":
                self._description(value)

    def _member(self, term: Member) -> None:
        self.complete = False
        if term.name == "robot_description":
            self.names.append(Word(term.name, term.at))
            self._description(term)

    def _description(self, value: Term) -> None:
        if self.executable not in _DESCRIBED:
            return
        nodes = self.nodes
        content = content_of(value, nodes.texts, lambda path: bool(nodes._locate(path)[1]))
        content = content or Content(None, None, value.at)
        nodes.described(content, self.executable, self.namespace, sure=self.sure)

    def _file(self, term: Constant | Called) -> None:
        text = self.nodes.texts.of(term)
        if isinstance(term, Called) and UNKNOWN in text and term.of is not None:
            self.complete = False  # a method's result: some dict
            return
        self.files.append(Word(text, term.at))
        if re.search(_OF_MANAGERS, self.executable):
            self.nodes.load(Word(text, term.at), self.executable, sure=self.sure)
        elif text:
            self.nodes.reference(text, term.at, "parameters", sure=self.sure)


def _given(term: Called, keyword: str) -> Term | None:
    found = term.keywords.get(keyword) or term.keywords.get(_ALTERNATIVE[keyword])
    return None if isinstance(found, Constant) and found.value is None else found


def _as_list(term: Term | None) -> Term | None:
    return Items([term], term.at) if isinstance(term, (Constant, Called, Missing)) else term


def _one_word(term: OneOf) -> bool:
    return all(isinstance(option, (Constant, Called)) for option in term.options)
