"""Resolve `$(find)`, `$(env)` and `$(eval)` without ROS; see replacements.py."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from functools import partial
from typing import Any

from urdfctl.source.xacro.expressions.guards import MissingVariable
from urdfctl.source.xacro.expressions.meter import Meter
from urdfctl.source.xacro.private.private_module import substitutions
from urdfctl.source.xacro.private.replacements import replace
from urdfctl.source.xacro.private.safety import evaluate_text


class XacroSubstitutions:
    """The state for resolving `$(...)`, and the function that xacro calls for it."""

    def __init__(
        self, module: Any, meter: Meter, find_package: Callable[[str], str], environ: Mapping[str, str]
    ) -> None:
        self.module, self.find_package, self.environ = module, find_package, environ
        self._meter = meter
        self._evaluate = module.eval_extension
        self._connected = False

    def install(self, *, trust: bool) -> None:
        """Replace eval_extension. xacro's module for substitutions is loaded on first use."""

        def extension(text: str) -> str:
            if not self._connected:
                self._connected = True
                self._connect(trust=trust)
            try:
                return str(self._evaluate(text))
            except Exception as error:
                error.substitution = text  # type: ignore[attr-defined]  # for failed_expression()
                raise

        replace(self.module, "eval_extension", extension)

    def _connect(self, *, trust: bool) -> None:
        part: Any = substitutions(self.module)
        for name, function in (("find", self.find_package), ("env", self._env), ("optenv", self._optenv)):
            replace(part, f"_eval_{name}", function, within="substitution_args")
            part._eval_dict[name] = function
        if not trust:
            replace(part, "_eval", partial(evaluate_text, part, self._meter), within="substitution_args")

    def _env(self, name: str) -> str:
        try:
            return self.environ[name]
        except KeyError:
            raise MissingVariable(name) from None

    def _optenv(self, name: str, default: str = "") -> str:
        return self.environ.get(name, default)
