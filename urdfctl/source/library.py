"""Expands what is no robot by itself: a macro library, by calling its macros with values that are not known; or a
fragment, whose undefined names are not known either."""

from __future__ import annotations

from collections.abc import Callable, Mapping

from urdfctl.hints import Any
from urdfctl.source.dom import Document, Element, Node
from urdfctl.source.expressions import ForbiddenExpression
from urdfctl.source.leftovers import leftovers, unused_arguments
from urdfctl.source.opaque import UNKNOWN, AnyArgument, NotKnown, Opaque
from urdfctl.source.problem import ProblemKind
from urdfctl.source.span import Call, Place
from urdfctl.source.xacro import Expander, Expansion
from urdfctl.source.xacro_errors import Blame

_TOLD = {
    ProblemKind.XML_SYNTAX,
    ProblemKind.DOCTYPE,
    ProblemKind.BUDGET,
    ProblemKind.FORBIDDEN_EXPRESSION,
    ProblemKind.OUTSIDE_WORKSPACE,
    ProblemKind.DUPLICATE_MACRO,
    ProblemKind.XACRO_WARNING,
    ProblemKind.FILE_UNREADABLE,
    ProblemKind.FILE_NOT_FOUND,
    ProblemKind.PACKAGE_NOT_FOUND,
}
_SYMBOL = "value_that_is_not_known"
_MOST_ROUNDS = 20


class LibraryExpander(Expander):
    """Knows no parameter's value. Conditions keep what they guard; names that are not defined, and macros that are
    defined elsewhere, are passed over: the file that includes this one brings them."""

    def _install(self) -> None:
        super()._install()
        module: Any = self.module
        module._global_symbols[_SYMBOL] = Opaque()
        evaluate = module.safe_eval
        module.safe_eval = lambda expression, symbols, local=None: _opaquely(evaluate, expression, symbols, local)
        decide = module.get_boolean_value
        module.get_boolean_value = lambda value, condition: self._decided(decide, value, condition)
        self._guard: Element | None = None
        self._tables: tuple[Any, Any] | None = None
        self._used: set[str] = set()

    def expand(self, path: str, arguments: Mapping[str, str]) -> Expansion:
        """The expansion of a library: what its macros would write, were they called."""
        return super().expand(path, arguments)._replace(library=True)

    def _arguments(self, given: Mapping[str, str]) -> dict[str, str]:
        return AnyArgument(given)

    def _processed(self, document: Document, given: Mapping[str, str]) -> None:  # noqa: ARG002 (the base's signature)
        """Call the macros that this file defines and nothing calls, until none is left."""
        root = document.documentElement
        if self._tables is None or root is None:
            return
        self.module.substitution_args_context["arg"] = AnyArgument()
        for _ in range(_MOST_ROUNDS):
            uncalled = [
                body for name, body in self.macros.items() if name not in self._used and body.source is root.source
            ]
            if not uncalled:
                break
            for body in uncalled:
                root.appendChild(_call_of(body, self._tables[0]))
            self._eval_all(root, *self._tables)
        sources = self.files.sources()
        for problem in leftovers(document, sources, self.macros, self._properties):
            self._add(problem)
        for problem in unused_arguments(self._declared, {}, sources, Place(root.source, root.start)):
            if problem.hint:  # others may be used by the file that includes this one
                self._add(problem)

    # -- the replaced helpers ----------------------------------------------------------------------------------------

    def _eval_all(self, node: Element, macros: object, symbols: object) -> None:
        if self._tables is None:
            self._tables = macros, symbols
        super()._eval_all(node, macros, symbols)

    def _handle_macro_call(self, node: Element, macros: object, symbols: object) -> bool:
        self._used.add(node.tagName.removeprefix("xacro:"))
        return super()._handle_macro_call(node, macros, symbols)

    def _check_attrs(self, node: Element, required: list[str], optional: list[str]) -> Any:
        self._guard = node
        return super()._check_attrs(node, required, optional)

    def _decided(self, decide: Callable[[Any, Any], bool], value: Any, condition: Any) -> bool:
        unknown = isinstance(value, Opaque) or (isinstance(value, str) and UNKNOWN in value)
        if unknown and condition is not None:  # without a condition the question is whether a property is a literal
            return self._guard is None or self._guard.tagName != "xacro:unless"
        return decide(value, condition)

    def _call(self, kind: str, node: Element) -> Call:
        name = node.tagName.removeprefix("xacro:")
        body = self.macros.get(name)
        made_here = body is not None and body.source is node.source and body.start == node.start
        return super()._call("uncalled macro" if made_here else kind, node)

    def _keep(self, blame: Blame, error: BaseException) -> None:
        problem = self._problem(blame, error)
        if problem.kind in _TOLD and UNKNOWN not in problem.message:
            self._add(problem)


def _opaquely(evaluate: Callable[..., Any], expression: str, symbols: Any, local: Any) -> Any:
    try:
        return evaluate(expression, symbols, local)
    except ForbiddenExpression:
        raise
    except (NotKnown, ArithmeticError, AttributeError, LookupError, NameError, TypeError, ValueError):
        return Opaque()


def _call_of(body: Element, macros: Any) -> Element:
    """A call of a macro with unknown values and blocks, which stands where the macro is defined."""
    name = body.attrs.get("name", "").removeprefix("xacro:")
    macro = macros[name]
    values = {p: f"${{{_SYMBOL}}}" for p in macro.params if not p.startswith("*")}
    call = Element(f"xacro:{name}", values, body.source, body.start, None, body.cloning)
    for _ in [p for p in macro.params if p.startswith("*")]:
        block: Node = Element(UNKNOWN, {}, body.source, body.start, None, body.cloning)
        call.appendChild(block)
    return call
