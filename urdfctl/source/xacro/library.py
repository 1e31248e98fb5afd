"""Expand files that are not robots: macro libraries, whose macros are called with unknown values, and fragments, which
use names that are defined elsewhere.
"""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any

from urdfctl.source.opaque import UNKNOWN, AnyArgument, NotKnown, Opaque
from urdfctl.source.problem import ProblemKind
from urdfctl.source.span import Call, Place
from urdfctl.source.xacro.blame import Blame
from urdfctl.source.xacro.expanded import Expansion
from urdfctl.source.xacro.leftovers import unused_arguments
from urdfctl.source.xacro.unknown import UnknownExpander
from urdfctl.source.xml.dom import Document, Element, XmlNode

_TOLD = {
    ProblemKind.XML_SYNTAX,
    ProblemKind.MERGE_CONFLICT,
    ProblemKind.DOCTYPE,
    ProblemKind.BUDGET,
    ProblemKind.FORBIDDEN_EXPRESSION,
    ProblemKind.OUTSIDE_WORKSPACE,
    ProblemKind.DUPLICATE_MACRO,
    ProblemKind.XACRO_WARNING,
    ProblemKind.FILE_UNREADABLE,
    ProblemKind.FILE_NOT_FOUND,
    ProblemKind.PACKAGE_NOT_FOUND,
    ProblemKind.PACKAGE_ABSENT,
}
_PASSED_OVER = (NotKnown, ArithmeticError, AttributeError, LookupError, NameError, TypeError, ValueError)
_SYMBOL = "value_that_is_not_known"
_MOST_ROUNDS = 20


class LibraryExpander(UnknownExpander):
    """Expands with unknown parameter values. Conditions keep their content. Undefined names and macros are skipped,
    because the file that includes this one defines them.
    """

    is_library = True

    def __init__(self, *places: Any, **options: Any) -> None:
        super().__init__(*places, **options)
        self._tables: tuple[Any, Any] | None = None
        self._used: set[str] = set()
        self._tries = False

    def install(self) -> None:
        """Replace the helpers of the private xacro."""
        super().install()
        self.module._global_symbols[_SYMBOL] = Opaque()

    def expand(self, path: str, arguments: Mapping[str, str]) -> Expansion:
        """Return the expansion of a library: what its macros would write if they were called."""
        return super().expand(path, arguments)._replace(library=True)

    def _processed(self, document: Document, given: Mapping[str, str]) -> None:  # noqa: ARG002 (the base's signature)
        """Call the macros of this file that nothing calls, until all were called."""
        root = document.documentElement
        if self._tables is None or root is None:
            return
        self._values = self.module.substitution_args_context["arg"] = AnyArgument()
        self._tries = True
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
        self._look_for_leftovers(document, sources)
        for problem in unused_arguments(self.declared, {}, sources, Place(root.source, root.start)):
            if problem.hint:  # others may be used by the file that includes this one
                self._add(problem)

    # -- the replaced helpers ----------------------------------------------------------------------------------------

    def _eval_all(self, node: Element, macros: object, symbols: object) -> None:
        if self._tables is None:
            self._tables = macros, symbols
        super()._eval_all(node, macros, symbols)

    def _handle_macro_call(self, node: Element, macros: Any, symbols: object) -> bool:
        self._used.add(node.tagName.removeprefix("xacro:"))
        return super()._handle_macro_call(node, macros, symbols)

    def _may_be_endless(self, name: str) -> bool:
        return super()._may_be_endless(name) or (self._tries and sum(call.name == name for call in self.calls) > 1)

    def _is_passed_over(self, error: BaseException) -> bool:
        return isinstance(error, _PASSED_OVER)

    def _call(self, kind: str, node: Element) -> Call:
        name = node.tagName.removeprefix("xacro:")
        body = self.macros.get(name)
        made_here = body is not None and body.source is node.source and body.start == node.start
        return super()._call("uncalled macro" if made_here else kind, node)

    def _keep(self, blame: Blame, error: BaseException) -> None:
        problem = self._problem(blame, error)
        if problem.kind in _TOLD and not (self._tries and problem.kind is ProblemKind.BUDGET):
            self._add(problem)


def _call_of(body: Element, macros: Any) -> Element:
    """Return a call of a macro with unknown values and blocks, at the place of its definition."""
    name = body.attrs.get("name", "").removeprefix("xacro:")
    macro = macros[name]
    values = {p: f"${{{_SYMBOL}}}" for p in macro.params if not p.startswith("*")}
    call = Element(
        tag=f"xacro:{name}", attrs=values, source=body.source, start=body.start, call=None, cloning=body.cloning
    )
    for _ in [p for p in macro.params if p.startswith("*")]:
        block: XmlNode = Element(
            tag=UNKNOWN, attrs={}, source=body.source, start=body.start, call=None, cloning=body.cloning
        )
        call.appendChild(block)
    return call
