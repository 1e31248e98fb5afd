"""roslaunch's `$(...)` substitutions, as far as they are known without running anything; the rest becomes UNKNOWN."""

from __future__ import annotations

import os
import re
from collections.abc import Callable, Collection, Mapping

from urdfctl.source.lengths import Room
from urdfctl.source.opaque import UNKNOWN

_INNERMOST = r"\$\(([^()$]*)\)"
_EVAL = r"\$\(eval (.*)\)"
_TRUTH = {"true": True, "1": True, "false": False, "0": False}


class Substituter:
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
        if command == "optenv":
            default = inside.split(None, 2)[2] if len(words) > 1 else ""
            return self.environ.get(name, default)
        return UNKNOWN

    def _found(self, inside: str) -> str:
        command, _, name = inside.partition(" ")
        if command != "find" or UNKNOWN in name:
            return UNKNOWN
        return self.find(name.strip()) or UNKNOWN

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


def is_of_environment(text: str, names: Collection[str]) -> bool:
    """Return whether a text depends on an environment variable that need not be set.

    names: the arguments whose values depend on one.
    """
    return "optenv" in text or any(name in names for name in re.findall(r"\barg\s+([^\s()]+)\s*\)", text))
