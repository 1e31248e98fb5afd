"""What the elements of a ROS 1 launch file are read with: files, the state of their group, and substitutions."""

from __future__ import annotations

import os
import re
from collections import ChainMap
from collections.abc import Callable, Iterable, Mapping

from urdfctl.model.launch.parts import joined
from urdfctl.source.launch.terms import outside
from urdfctl.source.lengths import Room
from urdfctl.source.opaque import UNKNOWN
from urdfctl.source.span import Place
from urdfctl.source.variables import required
from urdfctl.source.xml.dom import Document
from urdfctl.startup.records import NamedTuple


class Malformed(NamedTuple):
    """An element or attribute that launch or roslaunch does not take.

    refused: whether the whole launch file is refused; otherwise the part is ignored.
    """

    at: Place
    message: str
    refused: bool = True


class Sources(NamedTuple):
    """Access to files, packages and the environment for a launch file.

    read: returns the tree of a file; None if it cannot be read.
    locate: returns the source path of a file, and whether it exists; None if that cannot be checked.
    find: returns the folder of a package; None if unknown.
    environ: the environment variables.
    blank: returns the value of arguments with an empty default, in this file and the included ones.
    too_long: is told a place at which a text becomes too long.
    malformed: is told what roslaunch does not take of an element.
    """

    read: Callable[[str], Document | None]
    locate: Callable[[str], tuple[str, bool | None]]
    find: Callable[[str], str | None]
    environ: Mapping[str, str]
    blank: Callable[[], str] = str
    too_long: Callable[[Place], None] = lambda _: None
    malformed: Callable[[Malformed], None] = lambda _: None


class Scope(NamedTuple):
    """The state for the elements of a launch file or group.

    file: path of the launch file.
    namespace: their namespace; UNKNOWN if unknown.
    arguments: the launch arguments by name; those of a group or node, before those around it.
    sure: False if an unknown condition decides whether they are used.
    depth: depth of nested includes.
    in_node: whether they are in a node.
    held: False if they are used only with other launch arguments.
    declared: the names of the arguments that the launch file declares or is given.
    """

    file: str
    namespace: str
    arguments: ChainMap[str, str]
    sure: bool
    depth: int = 0
    in_node: bool = False
    held: bool = True
    declared: frozenset[str] = frozenset()

    def joined(self, namespace: str) -> str:
        """Return a namespace that is written here, below the namespace of the elements."""
        return joined(self.namespace, namespace)


_INNERMOST = r"\$\(([^()$]*)\)"
_EVAL = r"\$\(eval (.*)\)"
_TRUTH = {"true": True, "1": True, "false": False, "0": False}


class Substitutions:
    """Resolves substitutions in the texts of one launch file.

    arguments: the launch arguments by name.
    find: returns the folder of a package; None if unknown.
    environ: the environment variables.
    too_long: called if a text would be too long.
    """

    def __init__(
        self,
        file: str,
        arguments: Mapping[str, str],
        find: Callable[[str], str | None],
        environ: Mapping[str, str],
        too_long: Callable[[], None] = lambda: None,
    ) -> None:
        self.folder = os.path.dirname(file)
        self.arguments = arguments
        self.find = find
        self.environ = environ
        self.too_long = too_long

    def resolve(self, text: str) -> str:
        """Return a text with its substitutions resolved. Like roslaunch, resolves `$(find ...)` after all others."""
        if "$(" not in text:
            return text
        evaluation = re.fullmatch(_EVAL, text.strip(), re.DOTALL)
        if evaluation:
            return self._evaluated(evaluation.group(1))
        room = Room()
        text = re.sub(_INNERMOST, lambda match: room.take(self._value(match.group(0), match.group(1))), text)
        text = re.sub(_INNERMOST, lambda match: room.take(self._found(match.group(1))), text)
        if room.is_over:
            self.too_long()
        return text if "$(" not in text and not room.is_over else UNKNOWN

    def truth(self, text: str) -> bool | None:
        """Return the value of an `if` or `unless` attribute; None if unknown."""
        return _TRUTH.get(self.resolve(text).strip().lower())

    def _value(self, whole: str, inside: str) -> str:
        command, *words = inside.split()[:3] or [""]
        name = words[0] if words else ""
        if command == "arg":
            return self.arguments.get(name, UNKNOWN)
        if command == "find":
            return whole
        if command == "dirname":
            return self.folder
        if command == "env":
            return required(self.environ, name)
        if command == "optenv":
            default = inside.split(None, 2)[2] if len(words) > 1 else ""
            return self.environ.get(name, default)
        return UNKNOWN

    def _found(self, inside: str) -> str:
        command, _, name = inside.partition(" ")
        if command != "find" or UNKNOWN in name:
            return UNKNOWN
        return self.find(name.strip()) or outside(name.strip())

    def _evaluated(self, expression: str) -> str:
        """The value of an `eval`: a Python expression with the launch arguments as names; UNKNOWN if it is unknown."""
        if "__" in expression:
            return UNKNOWN  # roslaunch refuses it
        from urdfctl.source.launch.roslaunch_eval import evaluated

        return evaluated(
            expression,
            arguments=self.arguments,
            environ=self.environ,
            find=self.find,
            folder=self.folder,
            too_long=self.too_long,
        )


def is_of_environment(text: str, names: Iterable[str]) -> bool:
    """Return whether a text depends on an environment variable that need not be set.

    names: the arguments whose values depend on one.
    """
    return "optenv" in text or any(re.search(rf"\barg\s+{re.escape(name)}\s*\)", text) for name in names)
