"""Expands a description some of whose arguments have no known value: what depends on them is unknown, the rest is
expanded as ever."""

from __future__ import annotations

import re
from collections.abc import Callable, Mapping
from typing import Any

from urdfctl.source.budget import OverBudget
from urdfctl.source.opaque import UNKNOWN, AnyArgument, NotKnown, Opaque
from urdfctl.source.problem import Problem
from urdfctl.source.xacro.blame import Blame
from urdfctl.source.xacro.errors import causes_of
from urdfctl.source.xacro.expanded import Expansion
from urdfctl.source.xacro.expansion import Expander
from urdfctl.source.xacro.expressions.compiling import ForbiddenExpression
from urdfctl.source.xml.dom import Element

_PROPERTIES = ("xacro:property", "property")
_MACROS = ("xacro:macro", "macro")
_MOST_NESTED = 3
"""How often a macro may be open at the same time if the condition that ends its recursion may be unknown."""


class UnknownExpander(Expander):
    """Takes the arguments whose text contains UNKNOWN as unknown, and those that nobody gives.

    Conditions that are unknown keep what they guard.
    """

    def __init__(self, *places: Any, **options: Any) -> None:
        super().__init__(*places, **options)
        self.environ = AnyArgument(self.environ)
        self._guard: Element | None = None
        self._values: dict[str, str] = {}
        self.any_argument = True
        self.guessed = False
        """Whether a condition was unknown, so that both of its branches are kept."""

    def install(self) -> None:
        """Replace the helpers of the private xacro."""
        super().install()
        module: Any = self.module
        evaluate, extend = module.safe_eval, module.eval_extension
        module.safe_eval = lambda expression, symbols, local=None: self._evaluated(evaluate, expression, symbols, local)
        module.eval_extension = lambda text: self._extended(extend, text)
        decide = module.get_boolean_value
        module.get_boolean_value = lambda value, condition: self._decided(decide, value, condition)

    def expand(self, path: str, arguments: Mapping[str, str]) -> Expansion:
        """Return the expansion: as that of a library if a condition was unknown, as a partial one if an include was."""
        expansion = super().expand(path, arguments)
        return expansion._replace(library=self.guessed, partial=self.found.left_out)

    def needed(self) -> tuple[list[str], list[str]]:
        """Return the names of the arguments, and of the environment variables, that were used and are not given."""
        arguments = self._values.asked if isinstance(self._values, AnyArgument) else {}
        variables = self.environ.asked if isinstance(self.environ, AnyArgument) else {}
        return list(arguments), list(variables)

    def _arguments(self, given: Mapping[str, str]) -> dict[str, str]:
        values = AnyArgument(given) if self.any_argument else dict(given)
        self._values = values
        return values

    # -- the replaced helpers ----------------------------------------------------------------------------------------

    def _check_attrs(self, node: Element, required: list[str], optional: list[str]) -> Any:
        self._guard = node
        return super()._check_attrs(node, required, optional)

    def _handle_macro_call(self, node: Element, macros: Any, symbols: object) -> bool:
        if self._may_be_endless(node.tagName.removeprefix("xacro:")):
            self._replace_node(node, None)
            return True
        return super()._handle_macro_call(node, macros, symbols)

    def _may_be_endless(self, name: str) -> bool:
        return self.guessed and sum(call.name == name for call in self.calls) >= _MOST_NESTED

    def _decided(self, decide: Callable[[Any, Any], bool], value: Any, condition: Any) -> bool:
        unknown = isinstance(value, Opaque) or (isinstance(value, str) and UNKNOWN in value)
        if unknown and condition is not None:  # without a condition the question is whether a property is a literal
            self.guessed = True
            if self._guard is not None:
                _forget_properties(self._guard)
            return self._guard is None or self._guard.tagName != "xacro:unless"
        return decide(value, condition)

    def _evaluated(self, evaluate: Callable[..., Any], expression: str, symbols: Any, local: Any) -> Any:
        if UNKNOWN in expression:
            return Opaque()
        veiled = _Veiled(symbols)
        try:
            return evaluate(expression, veiled, local)
        except (ForbiddenExpression, OverBudget, MemoryError):
            raise
        except Exception as error:
            if veiled.unknown or self._is_passed_over(error):
                return Opaque()
            raise

    def _is_passed_over(self, error: BaseException) -> bool:
        return isinstance(error, NotKnown)

    def _extended(self, extend: Callable[[str], str], text: str) -> str:
        if not re.match(r"\$\(\s*eval\b", text):
            return extend(text)
        if UNKNOWN in text or self._asks_for_unknown(text):
            return UNKNOWN
        context: Any = self.module.substitution_args_context
        context["arg"] = dict(self._values)  # in which the names of functions are not arguments
        try:
            return extend(text)
        except Exception as error:
            if any(map(self._is_passed_over, causes_of(error))):
                return UNKNOWN
            raise
        finally:
            context["arg"] = self._values

    def _asks_for_unknown(self, text: str) -> bool:
        """Whether a `$(eval ...)` uses an argument that is unknown, by its name or by `arg('name')`."""
        if self.any_argument:
            for name in re.findall(r"\barg\(\s*['\"]([^'\"]+)", text):
                self._values.setdefault(name, self._values[name])
        words = set(re.findall(r"\w+", text))
        return any(name in words and UNKNOWN in value for name, value in self._values.items())

    def _keep(self, blame: Blame, error: BaseException) -> None:
        if any(isinstance(cause, NotKnown) for cause in causes_of(error)):
            self.found.left_out = True  # whatever the element would have become
        else:
            super()._keep(blame, error)

    def _add(self, problem: Problem) -> None:
        if UNKNOWN not in problem.message:
            super()._add(problem)


def _forget_properties(guard: Element) -> None:
    """Make the properties unknown that are only set if an unknown condition holds."""
    pending = guard.elements()
    while pending:
        element = pending.pop()
        if element.tagName in _PROPERTIES and "value" in element.attrs:
            element.attrs["value"] = UNKNOWN
        elif element.tagName not in _MACROS:
            pending += element.elements()


class _Veiled(dict[str, Any]):
    """The names of an expression, in which a text that is partly unknown is unknown as a whole."""

    def __init__(self, symbols: Any) -> None:
        super().__init__()
        self._symbols = symbols
        self.unknown = False

    def __contains__(self, name: object) -> bool:
        return name in self._symbols

    def __getitem__(self, name: str) -> Any:
        value = self._symbols[name]
        if isinstance(value, Opaque) or (isinstance(value, str) and UNKNOWN in value):
            self.unknown = True
            return Opaque()
        return value
