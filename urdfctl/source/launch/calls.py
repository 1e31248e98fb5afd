"""The functions and methods that launch files in Python call: those of Python, of launch, and of ROS packages.

A call of another one becomes a term that says what is called with what.
"""

from __future__ import annotations

import os
from collections.abc import Callable, Iterator, Mapping, Sequence

from urdfctl.source.launch.counting import counted
from urdfctl.source.launch.frames import Frame, add, append, extend
from urdfctl.source.launch.moveit_configs import chain_of, usual_controllers
from urdfctl.source.launch.operations import listed, method, shown, text_at
from urdfctl.source.launch.terms import (
    Called,
    Constant,
    Items,
    Member,
    OneOf,
    Table,
    Term,
    UnknownTerm,
    is_same,
    known_text,
    outside,
    perhaps,
)
from urdfctl.source.lengths import until_too_long
from urdfctl.source.opaque import UNKNOWN
from urdfctl.source.span import Place
from urdfctl.source.variables import required

_SHARE = frozenset({"get_package_share_directory", "get_package_share_path"})
_FINDING = frozenset({"FindPackageShare", "FindPackage", "FindPackagePrefix"})
_PATHS = frozenset({"Path", "PosixPath", "str", "fspath", "abspath", "realpath", "expanduser", "normpath"})
_ENVIRONMENT = frozenset({"os.getenv", "os.environ.get"})
_GROWING = frozenset({"add_action", "add_entity"})
_LOADING = frozenset({"yaml.safe_load", "yaml.load", "yaml.full_load"})
_OF_DEBUGGER = frozenset({"ld", "condition_name", "commands_file", "extra_debug_args"})
_LISTS = frozenset({"list", "tuple", "sorted"})


def entities_of(description: Called, at: Place) -> Items:
    """Return the actions of a launch description; of one that a function of a package makes, itself in their place."""
    if description.short != "LaunchDescription":
        return Items([description], at)
    first = description.given("initial_entities", 0)
    own = first.values if isinstance(first, Items) else [first] if first is not None else []
    return Items([*own, *description.added], at)


def _mappings(arguments: Sequence[Term], keywords: Mapping[str, Term], _: Place) -> Iterator[Term]:
    """What xacro's `process_doc` gives a document that is parsed."""
    yield from (mappings for mappings in (keywords.get("mappings"), *arguments[1:]) if mappings)


def _debuggable(arguments: Sequence[Term], keywords: Mapping[str, Term], at: Place) -> Iterator[Term]:
    """The node that `add_debuggable_node` adds to a launch description, unless it is debugged (moveit_configs_utils,
    launch_utils.py): its package and its program may be given by position."""
    named = dict(zip(("package", "executable"), arguments[1:], strict=False))
    own = {key: value for key, value in keywords.items() if key not in _OF_DEBUGGER}
    yield Called("launch_ros.actions.Node", at, (), {**named, **own})


_ADDING = {"process_doc": _mappings, "add_debuggable_node": _debuggable}
"""The functions that add to their first argument, and what they add."""


class Calls:
    """Gives the terms of calls.

    find, environ: see `python.Surroundings`.
    load: returns the content of a YAML file; None if it cannot be read.
    perform: returns the text that a substitution becomes.
    write: is told the path of a file and the text that is written into it.
    """

    def __init__(
        self,
        find: Callable[[str, Place], str | None],
        environ: Mapping[str, str],
        load: Callable[[str], Term | None],
        perform: Callable[[Term, Place], Term],
        write: Callable[[str, Term], object],
    ) -> None:
        self._find, self._environ, self._load, self._performed = find, environ, load, perform
        self._write = write

    def function(  # noqa: PLR0911 (one return per function)
        self, name: str, arguments: list[Term], keywords: Mapping[str, Term], at: Place
    ) -> Term:
        """Return the term of a call of an imported or built-in function, by its full name."""
        short = name.rpartition(".")[2]
        first = arguments[0] if arguments else None
        if short in _SHARE and first is None:
            first = keywords.get("package_name")
        if short in _SHARE and first is not None:
            return self._share(first, at)
        if name == "os.path.join":
            return text_at(os.path.join("", *until_too_long(map(shown, arguments))), at)
        if short == "dirname" and isinstance(first, Constant) and isinstance(first.value, str):
            return Constant(os.path.dirname(first.value), at)
        if short in _PATHS and isinstance(first, Constant):
            return text_at(os.path.join(*until_too_long(map(shown, arguments))), at)
        if short in _LISTS and len(arguments) <= 1:
            items = listed(first) if first is not None else []
            return UnknownTerm(at) if items is None else Items(items, at)
        if name in _ENVIRONMENT:
            return self.environment([*arguments, *(keywords[name] for name in ("default",) if name in keywords)], at)
        if short in _ADDING and isinstance(first, Called):
            first.added.extend(_ADDING[short](arguments, keywords, at))
        if name in _LOADING and isinstance(first, Called):
            return self._yaml(first, at)
        if name == "dict":
            table = Table(at)
            for key, value in keywords.items():
                table.put(Constant(key, value.at), value)
            return table
        number = counted(name, [*arguments, *keywords.values()], at)
        return Called(name, at, arguments, keywords) if number is None else number

    def _yaml(self, file: Called, at: Place) -> Term:
        """The content of a YAML file that is opened, or whose text is read."""
        if file.short in {"read", "read_text"} and isinstance(file.of, Called):
            file = file.of
        path = known_text(file.given("file", 0)) if file.short == "open" else None
        return (self._load(path) if path else None) or UnknownTerm(at)

    def _share(self, package: Term, at: Place) -> Term:
        """The share folder of a package."""
        name = known_text(package)
        folder = self._find(name, package.at) if name else None
        return Constant(folder or (outside(name) if name else UNKNOWN), at)

    def package_of_builder(self, of: Term | None, at: Place) -> Term | None:
        """Return the folder that a MoveItConfigsBuilder, or what it made, reads; None for another term."""
        chain = chain_of(of)
        if chain is None:
            return None
        package = known_text(chain[0].given("package_name"))
        robot = known_text(chain[0].given("robot_name", 0))
        name = package or (robot and f"{robot}_moveit_config")
        return self._share(Constant(name, at), at) if name else None

    def looked_into(self, term: Term) -> Term:
        """Return a term, or the dict that it is if a MoveItConfigsBuilder reads it from the file with MoveIt's
        controllers."""
        if not isinstance(term, Member) or term.name != "trajectory_execution":
            return term
        chain, folder = chain_of(term.of), known_text(self.package_of_builder(term.of, term.at))
        if chain is None or folder is None:
            return term
        builder, calls = chain
        given = calls[term.name].given("file_path", 0) if term.name in calls else None
        named = known_text(given)
        path = usual_controllers(folder, known_text(builder.given("robot_name", 0)) or "")
        if given is not None:
            path = os.path.join(folder, named) if named else None
        content = self._load(path) if path else None
        return content if isinstance(content, Table) else term

    def environment(self, arguments: Sequence[Term], at: Place) -> Term:
        """Return the term of an environment variable: its name, and its default if it has one."""
        name = known_text(arguments[0]) if arguments else None
        if name is not None and name not in self._environ and len(arguments) > 1:
            return arguments[1]
        return Constant(UNKNOWN if name is None else required(self._environ, name), at)

    def method(
        self, of: Term, name: str, given: tuple[list[Term], Mapping[str, Term]], at: Place, frame: Frame
    ) -> Term:
        """Return the term of a call of a method of a term.

        given: the arguments, and those that are given by keyword.
        """
        arguments, keywords = given
        of = self.looked_into(of)
        if name == "perform":
            return self._performed(of, at)
        if name == "find" and isinstance(of, Called) and of.short in _FINDING and arguments:
            return self._share(arguments[0], at)
        if name == "perform_substitution" and arguments:
            return self._performed(arguments[0], at)
        if name in {"write", "write_text"} and arguments:
            self._written(of, arguments[0])
        if isinstance(of, Items):
            return self._of_list(of, name, arguments, at, frame)
        if isinstance(of, Member) and of.name == "launch_configurations" and name == "get" and arguments:
            return self._performed(Called("LaunchConfiguration", at, arguments), at)
        if name in _GROWING and isinstance(of, (Called, OneOf)) and arguments:
            for option in of.options if isinstance(of, OneOf) else (of,):
                if isinstance(option, Called):
                    add(option, arguments[0], frame)
            return Constant(None, at)
        result = method(of, name, arguments, keywords, at)
        if result is not None:
            return result
        called = Called(name, at, arguments, keywords)
        called.of = of
        return called

    def _written(self, file: Term, text: Term) -> None:
        """Tell what is written into a file that is opened by its path, or into a path."""
        path = known_text(file.given("file", 0)) if isinstance(file, Called) and file.short == "open" else None
        path = path or known_text(file)
        if path is not None:
            self._write(path, text)

    def _of_list(self, of: Items, name: str, arguments: Sequence[Term], at: Place, frame: Frame) -> Term:
        if name in {"append", "extend", "insert"} and arguments:
            if name == "extend":
                extend(of, arguments[0], frame)
            else:
                append(of, arguments[-1], frame)
            return Constant(None, at)
        if name == "copy":
            return Items(of.values, at)
        if name == "remove" and arguments:
            self._removed(of, arguments[0], frame)
        elif name in {"pop", "clear"}:
            of.values[:] = [perhaps(value) for value in of.values]
        return UnknownTerm(at)

    @staticmethod
    def _removed(of: Items, item: Term, frame: Frame) -> None:
        """Remove an item from a list; if it is unknown which item, all become optional."""
        index = next((index for index, value in enumerate(of.values) if is_same(value, item)), None)
        if index is None:
            of.values[:] = [perhaps(value) for value in of.values]
        elif frame.sure:
            del of.values[index]
        else:
            of.values[index] = perhaps(of.values[index])
