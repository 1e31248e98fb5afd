"""The `parameters` of nodes in ROS 2 launch files."""

from __future__ import annotations

import re

from urdfctl.model.launch import GivenParameters, Word, joined
from urdfctl.model.launch.ros2.descriptions import as_written, content_of, is_of_other_node
from urdfctl.model.launch.ros2.facts import LaunchFacts
from urdfctl.model.launch.ros2.given import section_of
from urdfctl.model.launch.ros2.moveit import builder_of, files_of_table
from urdfctl.model.launch.ros2.simulators import WEBOTS_DRIVER
from urdfctl.model.launch.ros2.texts import Content, Texts, rewriting_of
from urdfctl.source.launch.terms import Called, Constant, Items, Member, OneOf, Perhaps, Table, Term
from urdfctl.source.opaque import UNKNOWN

MANAGERS = ("ros2_control_node",)
DESCRIBED = ("robot_state_publisher", *MANAGERS, "move_group", WEBOTS_DRIVER)
"""The programs that take a robot description."""
_OF_MANAGERS = r"ros2_control|controller_manager"
_MAY_MANAGE = r"control|manager|driver|hardware|simulat|mujoco|isaac|webots"
"""In the name of a program that may contain a controller manager; another one gets the description."""
_PARAMETERS = "ros__parameters"
_MAPPINGS = "xacro_mappings"
_DESCRIPTION, _SEMANTIC = "robot_description", "robot_description_semantic"
_DESCRIPTION_PATH = r"[^<>\s]+\.(?:urdf|xacro|sdf)"
"""A text in place of a description that is the path of its file."""


class NodeParameters:
    """The `parameters` of a node: names of single parameters, and files. A controller manager's files are loaded.

    names: the names of single parameters.
    values: the texts of single parameters by name, with UNKNOWN for what is not known.
    files: the files.
    complete: False if some of them are unknown.
    """

    def __init__(
        self,
        given: Term | None,
        executable: str,
        *,
        facts: LaunchFacts,
        texts: Texts,
        namespace: str | None,
        sure: bool,
        name: str | None = None,
    ) -> None:
        self.facts = facts
        self.texts = texts
        self.executable = executable
        self.namespace = namespace
        self.sure = sure
        self.name = name
        self.names: list[Word] = []
        self.values: dict[str, str] = {}
        self.files: list[Word] = []
        self._plain: list[tuple[Term, Word]] = []
        self.complete = True
        self._tables = [each for each in given.values if isinstance(each, Table)] if isinstance(given, Items) else []
        if isinstance(given, Items):
            for value in given.values:
                self._add(value)
        elif given is not None:
            self.complete = False
        if not re.search(_OF_MANAGERS, executable):
            self._as_manager()

    def _as_manager(self) -> None:
        """Load the files of a program that has a controller manager by another name: one of them has its section, and
        all of them reach every node of the process."""
        is_described = any(name.text == _DESCRIPTION for name in self.names) and self.executable not in DESCRIBED
        if not (is_described or re.search(_MAY_MANAGE, self.executable)):
            return
        read = self.texts.sources.values
        tables = [(term, word, read(word.text) if word.known else None) for term, word in self._plain]
        known = [(term, word, table.entries) for term, word, table in tables if isinstance(table, Table)]
        if any(_is_manager(key) for _, _, entries in known for key in entries):
            for term, word, entries in known:
                if any(isinstance(each, Table) and _PARAMETERS in each.entries for each in entries.values()):
                    self._load(term, word)

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
        elif isinstance(term, (Member, Called)) and builder_of(term, self.texts) is not None:
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
            is_text = isinstance(value, (Constant, Called)) or (name == _DESCRIPTION and isinstance(value, Items))
            text = self.texts.of(value) if is_text else None
            if text is not None and (name != _DESCRIPTION or re.fullmatch(_DESCRIPTION_PATH, text)):
                self.values[name] = text
            if name == _DESCRIPTION:
                self._description(value)
            elif is_text or (isinstance(value, Items) and _is_path(value)):
                self.facts.named_file(Word(self.texts.of(value), value.at), sure=self.sure)
        if self.executable in MANAGERS and self.namespace is not None and table.entries.keys() - {_DESCRIPTION}:
            node = joined(self.namespace, self.name) if self.name else "/**"
            document = section_of(table, node, self.texts)
            self.facts.given.append(GivenParameters(document, table.at, self.sure, self.namespace))
        read = lambda term: content_of(term, self.texts, lambda _: False)  # noqa: E731 (one use)
        files = files_of_table(table, table.at, read, self.facts.locate)
        if files is not None:
            runs = self.executable == "move_group"
            self.facts.moveit.append(files._replace(namespace=self.namespace, sure=self.sure, runs=runs))

    def _of_builder(self, term: Member | Called) -> None:
        """Add the parameters of a MoveItConfigsBuilder: one of its dicts, or all of them (`to_dict()`)."""
        builder = builder_of(term, self.texts)
        is_description = isinstance(term, Member) and term.name == _DESCRIPTION
        self.complete = self.complete and is_description
        if is_description:
            self.names.append(Word(term.name, term.at))
            self._description(term)
        elif builder is not None and (isinstance(term, Called) or term.name == _SEMANTIC):
            runs = self.executable == "move_group"
            files = builder.files(term.at, self.facts.locate, namespace=self.namespace, sure=self.sure, runs=runs)
            self.facts.moveit.append(files)
            if self._takes_description and isinstance(term, Called):
                content = builder.description(self.facts.exists, term.at)
                self.facts.described(content, self.executable, self.namespace, sure=self.sure)

    @property
    def _takes_description(self) -> bool:
        return self.executable in DESCRIBED or re.search(_OF_MANAGERS, self.executable) is not None

    def _description(self, value: Term) -> None:
        if not self._takes_description or is_of_other_node(value, self.texts):
            return
        content = content_of(value, self.texts, self.facts.exists) or self._of_a_path(value)
        content = as_written(content, self.texts, self.facts.exists)
        self.facts.described(content, self.executable, self.namespace, sure=self.sure)

    def _of_a_path(self, value: Term) -> Content:
        """The description that a program reads from a path; unknown if it takes none.

        webots_ros2_driver WebotsNode.cpp expands it with the arguments in `xacro_mappings`.
        """
        path = self.texts.of(value) if self.executable == WEBOTS_DRIVER else ""
        if not re.fullmatch(_DESCRIPTION_PATH, path):
            return Content(None, None, value.at)
        given = next((table.entries[_MAPPINGS] for table in self._tables if _MAPPINGS in table.entries), None)
        words = [self.texts.of(each).partition(":=") for each in given.values] if isinstance(given, Items) else []
        is_known = given is None or isinstance(given, Items)
        return Content(path, tuple((name, text) for name, _, text in words) if is_known else None, value.at)

    def _file(self, term: Constant | Called | Items) -> None:
        text = self.texts.of(term)
        if isinstance(term, Called) and UNKNOWN in text and term.of is not None:
            self.complete = False  # a method's result: some dict
            return
        word = Word(text, term.at)
        self.files.append(word)
        if re.search(_OF_MANAGERS, self.executable):
            self._load(term, word)
        elif text:
            self._plain.append((term, word))
            self.facts.reference(text, term.at, "parameters", sure=self.sure)

    def _load(self, term: Term, word: Word) -> None:
        rewriting = rewriting_of(term, self.texts)
        self.facts.load(word, self.executable, sure=self.sure, of=self.namespace, rewriting=rewriting)


def _is_manager(section: str) -> bool:
    return section.rpartition("/")[2] == "controller_manager"


def _is_path(items: Items) -> bool:
    """Whether a list inside `parameters` is one path in parts: launch_ros joins texts and substitutions."""
    parts = items.values
    return bool(parts) and all(
        isinstance(part, Constant) or (isinstance(part, Called) and part.short != "ParameterFile") for part in parts
    )
