"""roslaunch's `$(...)`: what can be told of it without running anything. What cannot becomes UNKNOWN in the text."""

from __future__ import annotations

import os
import re
from collections.abc import Callable, Mapping

from urdfctl.source.opaque import UNKNOWN

_ONE = r"\$\(([^()$]*)\)"
_EVAL = r"\$\(eval (.*)\)"
_OPERAND = r"""(?:arg\(\s*['"](\w+)['"]\s*\)|(\w+))"""
_COMPARISON = rf"""\s*{_OPERAND}\s*(==|!=)\s*['"]([^'"]*)['"]\s*"""
_NEGATION = rf"\s*not\s+{_OPERAND}\s*"
_TRUTH = {"true": True, "1": True, "false": False, "0": False}


class Substitutions:
    """Resolves the texts of one launch file. `find` gives a package's folder, None where it is not known."""

    def __init__(
        self, file: str, arguments: Mapping[str, str], find: Callable[[str], str | None], environ: Mapping[str, str]
    ) -> None:
        self.folder = os.path.dirname(file)
        self.arguments = arguments
        self.find = find
        self.environ = environ

    def resolve(self, text: str) -> str:
        """A text as roslaunch makes it: packages are found after everything else."""
        if "$(" not in text:
            return text
        whole = re.fullmatch(_EVAL, text.strip(), re.DOTALL)
        if whole:
            return self._evaluated(whole.group(1))
        text = re.sub(_ONE, lambda match: self._value(match.group(0), match.group(1)), text)
        text = re.sub(_ONE, lambda match: self._found(match.group(1)), text)
        return text if "$(" not in text else UNKNOWN

    def truth(self, text: str) -> bool | None:
        """What an `if` says; None where it is not known."""
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
        """A comparison of an argument with a text, or `not` an argument; no other expression is worked out."""
        compared = re.fullmatch(_COMPARISON, expression)
        if compared:
            called, bare, operator, literal = compared.groups()
            value = self.arguments.get(called or bare, UNKNOWN)
            return UNKNOWN if UNKNOWN in value else str((value == literal) is (operator == "=="))
        negated = re.fullmatch(_NEGATION, expression)
        if negated:
            truth = _TRUTH.get(self.arguments.get(negated.group(1) or negated.group(2), UNKNOWN).lower())
            return UNKNOWN if truth is None else str(not truth)
        return UNKNOWN
