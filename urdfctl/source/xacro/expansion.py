"""Expand xacro with the installed xacro package, and record where each element was written and by which calls.

The result is, byte for byte, what `xacro` itself writes. With `strict`, the first problem ends the expansion. Without
it, a problem only drops the element it is in, so that one run finds all problems.
"""

from __future__ import annotations

import os
import sys
from collections.abc import Callable, Collection, Mapping
from functools import cached_property
from types import ModuleType
from typing import Any

from urdfctl.source.budget import MAX_CALL_DEPTH, MAX_CALLS, MAX_ELEMENTS, OverBudget
from urdfctl.source.disk.files import FileProblem, Files
from urdfctl.source.disk.gate import is_folder
from urdfctl.source.opaque import UNKNOWN
from urdfctl.source.problem import Problem, ProblemKind
from urdfctl.source.span import Call, Place, SourceText
from urdfctl.source.workspaces.packages import Packages
from urdfctl.source.xacro.blame import Blame, blame_of, cut_out, node_being_evaluated
from urdfctl.source.xacro.consequences import OF_FILES, OF_VALUES, Problems
from urdfctl.source.xacro.errors import AbsentFile, failed_expression, judged, problem_of
from urdfctl.source.xacro.expanded import Expansion
from urdfctl.source.xacro.expressions.meter import Meter
from urdfctl.source.xacro.influence import Definitions
from urdfctl.source.xacro.leftovers import (
    empty_arguments,
    empty_default,
    leftovers,
    placeholders,
    repeated_condition,
    unused_arguments,
)
from urdfctl.source.xacro.macro_names import macro_defined_again, macro_of_other_file
from urdfctl.source.xacro.origin import parameters_around, parameters_of, suggested, traced
from urdfctl.source.xacro.prefixes import add_prefixes, is_call, missing_prefixes
from urdfctl.source.xacro.private import private_module
from urdfctl.source.xacro.private.replacements import replace
from urdfctl.source.xacro.private.safety import install_safety, install_yaml
from urdfctl.source.xacro.private.speed import install_speed
from urdfctl.source.xacro.private.without_ros import XacroSubstitutions
from urdfctl.source.xml.dom import Cloning, Document, Element, XmlNode, XmlText
from urdfctl.source.xml.parsing import parse


class Expander:
    """Expands one file once.

    trust: True to evaluate any expression and accept any DOCTYPE, as xacro does.
    """

    is_library = False

    def __init__(
        self,
        files: Files,
        packages: Packages,
        environ: Mapping[str, str],
        *,
        strict: bool = False,
        trust: bool = False,
    ) -> None:
        self.files, self.packages, self.environ = files, packages, environ
        self.strict, self.trust = strict, trust
        self.found = Problems()
        self.cloning = Cloning()
        self.calls: list[Call] = []
        self._called = 0
        self.macros: dict[str, Element] = {}
        """The macros that were defined on the way, each by its last definition."""
        self.loaded: dict[str, None] = {}
        """The YAML files that expressions loaded, in order."""
        self.declared: dict[str, Element] = {}
        """The arguments that the description declares, each by its first `<xacro:arg>`."""
        self.blamed: dict[str, None] = {}
        """The arguments that are empty by default and not given, and because of which something failed."""
        self.unprefixed = False
        """Whether tags without the prefix are read as if they had it, as they were until melodic."""
        self.salvages = False
        """Whether a file that is not well-formed is read without its mistakes."""
        self.any_argument = False
        """Whether an argument that is neither given nor declared is unknown, and not a problem."""
        self.expands_all = False
        """Whether xacro is run on the file, whatever its name is."""
        self._given: Mapping[str, str] = {}
        self._properties: dict[str, set[str]] = {}
        self._written: dict[str, list[Element]] = {}
        """The elements that define each property."""
        self._originals: dict[str, Callable[..., Any]] = {}

    @cached_property
    def module(self) -> ModuleType:
        """The private xacro, which a plain URDF does not need."""
        return private_module.load()

    def expand(self, path: str, arguments: Mapping[str, str]) -> Expansion:
        """Return the expansion of a file with `name:=value` arguments."""
        module = self.module
        self.install()
        module.init_stacks(path)
        self._given = arguments
        sys.setrecursionlimit(max(sys.getrecursionlimit(), 20 * MAX_CALL_DEPTH))
        document: Document | None = None
        try:
            document = self._tree(path)
            module.process_doc(document, mappings=self._arguments(arguments), verbosity=1)
            self._processed(document, arguments)
        except FileProblem as error:
            self._add(error.at(Place(SourceText(path, b""), 0, end=0)))
        except Exception as error:  # noqa: BLE001 (whatever the description made xacro raise)
            self._keep(blame_of(error), error)
            document = None if self.strict else document
        return Expansion(document, self.found.all)

    def _tree(self, path: str, include: Call | None = None) -> Document:
        document = self.parsed(self.files.read(path), include)
        if self.unprefixed and document.documentElement is not None:
            add_prefixes(document.documentElement)
        return document

    def parsed(self, source: SourceText, include: Call | None = None) -> Document:
        """Return the tree of a file. Raises ReadError."""
        if not self.salvages:
            return parse(source, self.cloning, include, declarations=self.trust)
        from urdfctl.source.xml.salvage import read_around

        document, mistake = read_around(source, self.cloning, include, declarations=self.trust)
        if mistake is not None:
            self.found.add_gap(mistake)
        return document

    def _arguments(self, given: Mapping[str, str]) -> dict[str, str]:
        return dict(given)

    def _processed(self, document: Document, given: Mapping[str, str]) -> None:
        """Do what remains after xacro: look for the parts that it silently ignored."""
        root = document.documentElement
        if self.strict or root is None:
            return
        sources = self.files.sources()
        self._look_for_leftovers(document, sources)
        undefined = {problem.subject for problem in self.found.all if problem.kind is ProblemKind.UNDEFINED_ARGUMENT}
        at = Place(root.source, root.start)
        for problem in unused_arguments(self.declared, given, sources, at, undefined):
            if problem.hint or not self.found.may_lack_names:
                self._add(problem)

    def _look_for_leftovers(self, document: Document, sources: list[SourceText]) -> None:
        for problem in leftovers(document, sources, self.macros, self._properties):
            self._add(problem)
        for problem in missing_prefixes(sources, self.macros) if self.unprefixed else ():
            self._add(problem)

    def definitions(self) -> Definitions:
        """Return the definitions that were read, and the arguments that were given."""
        defaults = {name: element.attrs.get("default", "") for name, element in self.declared.items()}
        return Definitions(self._properties, {**defaults, **self._given}, tuple(self.loaded), self._written)

    # -- the replaced helpers of xacro -------------------------------------------------------------------------------

    def install(self) -> None:
        """Replace the helpers of the private xacro."""
        module: Any = self.module
        for name in (
            "process_include",
            "handle_macro_call",
            "check_attrs",
            "replace_node",
            "eval_all",
            "grab_macro",
            "resolve_macro",
        ):
            self._originals[name] = getattr(module, name)
            replace(module, name, getattr(self, f"_{name}"))
        replace(module, "_empty_text_node", XmlText("\n\n"))
        replace(module, "parse", self._parse)
        for level in ("warning", "error", "message"):
            replace(module, level, self._listener(level))
        self._install_findings()
        meter = Meter(trust=self.trust)
        install_speed(module, meter, trust=self.trust)
        install_yaml(module, self.files, meter, self.loaded)
        XacroSubstitutions(module, meter, self.find_package, self.environ).install(trust=self.trust)
        install_safety(module, self.files, meter, trust=self.trust)

    def _install_findings(self) -> None:
        def print_location() -> None:  # exposed to expressions under its name
            return None

        replace(self.module, "print_location", print_location)
        table: Any = self.module.Table
        resolve = table._resolve_

        def resolve_once(symbols: Any, key: str) -> Any:
            before = len(symbols.recursive)
            try:
                return resolve(symbols, key)
            except Exception:
                del symbols.recursive[before:]
                raise

        replace(table, "_resolve_", resolve_once, within="Table")

    def _parse(self, _input: object, filename: str) -> Document:
        module = self.module
        include = self.calls[-1] if self.calls else None
        try:
            return self._tree(filename, include)
        except FileProblem as error:
            module.filestack.pop()
            absent = error.kind is ProblemKind.FILE_NOT_FOUND or is_folder(error.path)
            if absent:  # an optional include may be absent: xacro looks for an IOError inside
                raise module.XacroException(exc=AbsentFile(error)) from error
            raise

    def _process_include(self, node: Element, macros: object, symbols: object, evaluate: object) -> None:
        self._enter(Call("include", node.attrs.get("filename", ""), node.source, node.start, node.call))
        self._originals["process_include"](node, macros, symbols, evaluate)
        self._leave()

    def _handle_macro_call(self, node: Element, macros: Any, symbols: object) -> bool:
        name = node.tagName
        if not name.startswith("xacro:"):
            if not (self.unprefixed and is_call(node, macros)):
                return False
            node.tagName = name = f"xacro:{name}"
        if name == "xacro:call":  # comes back here under the macro's own name
            return bool(self._originals["handle_macro_call"](node, macros, symbols))
        self._enter(self._call("macro", node))
        handled = self._originals["handle_macro_call"](node, macros, symbols)
        self._leave()
        return bool(handled)

    def _call(self, kind: str, node: Element) -> Call:
        return Call(kind, node.tagName.removeprefix("xacro:"), node.source, node.start, node.call)

    def _resolve_macro(self, name: str, macros: object, symbols: object) -> Any:
        found = self._originals["resolve_macro"](name, macros, symbols)
        body = found[2].body
        if isinstance(body, Element):
            self.calls[-1].definition = body.at.span
        return found

    def _spend(self) -> None:
        self._called += 1
        if self._called > MAX_CALLS:
            raise OverBudget(f"more than {MAX_CALLS} macro calls, includes and inserted blocks")
        if self.cloning.count > MAX_ELEMENTS:
            raise OverBudget(f"more than {MAX_ELEMENTS} elements")

    def _enter(self, call: Call) -> None:
        self._spend()
        if len(self.calls) >= MAX_CALL_DEPTH:
            raise OverBudget(f"macros and includes are nested more than {MAX_CALL_DEPTH} levels deep")
        self.calls.append(call)
        self.cloning.call = call

    def _leave(self) -> None:
        self.calls.pop()
        self.cloning.call = self.calls[-1] if self.calls else None

    def _check_attrs(self, node: Element, required: list[str], optional: list[str]) -> Any:
        if node.tagName == "xacro:insert_block":
            self._spend()
            self.cloning.insertion = node
        elif node.tagName in ("xacro:if", "xacro:unless"):
            for problem in repeated_condition(node):
                self._add(problem)
        elif node.tagName == "xacro:property":
            name = node.attrs.get("name", "")
            self._properties.setdefault(name, set()).add(node.attrs.get("value", node.attrs.get("default", "")))
            self._written.setdefault(name, []).append(node)
        elif node.tagName == "xacro:arg":
            self.declared.setdefault(node.attrs.get("name", ""), node)
        return self._originals["check_attrs"](node, required, optional)

    def _replace_node(self, node: XmlNode, by: object, content_only: bool = False) -> None:  # noqa: FBT001, FBT002 (xacro's signature)
        if by is None and isinstance(node, Element) and node.tagName == "xacro:attribute":
            self._note_attribute(node, node.parentNode)
        self._originals["replace_node"](node, by, content_only)

    def _note_attribute(self, node: Element, parent: XmlNode | None) -> None:
        """Record who wrote an attribute of `parent`. A value that is not text is a problem: xacro cannot write it."""
        if not isinstance(parent, Element):
            return
        name = node.attrs.get("name", "")
        name = next(reversed(parent.attrs), name) if "$" in name else name
        parent.moved = {**(parent.moved or {}), name: (node.source, node.start)}
        value: object = parent.attrs.get(name, "")
        if isinstance(value, str):
            return
        if value:
            parent.attrs[name] = UNKNOWN
            message = f"attribute '{name}' becomes {value!r}, which is not a string; xacro cannot write it"
            raise self.module.XacroException(message)
        parent.attrs[name] = ""
        message = f"attribute '{name}' becomes {value!r}, which is not a string; xacro writes an empty attribute"
        self._add(Problem(ProblemKind.XACRO_WARNING, node.at["value"], message))

    def _grab_macro(self, node: Element, macros: Any) -> None:
        name = node.attrs.get("name", "").removeprefix("xacro:")
        before = macros[name].body if name and dict.__contains__(macros, name) else None
        self._originals["grab_macro"](node, macros)
        self.macros[name] = node
        for problem in macro_defined_again(name, node, before):
            self._add(problem)
        for problem in macro_of_other_file(name, node, self.files):
            self._add(problem)

    def _eval_all(self, node: Element, macros: object, symbols: object) -> None:
        evaluate = self._originals["eval_all"]
        depth = len(self.module.filestack), len(self.module.macrostack), len(self.calls)
        done: list[XmlNode] = []
        while True:
            try:
                evaluate(node, macros, symbols)
            except (OverBudget, RecursionError, MemoryError):
                raise
            except Exception as error:
                if self.strict:
                    raise
                blame = blame_of(error)
                self._keep(blame, error)
                self._unwind(*depth)
                if not cut_out(blame, node, done):
                    raise
            else:
                break
        first = node.firstChild
        for child in done:
            node.insertBefore(child, first)

    def _unwind(self, files: int, macros: int, calls: int) -> None:
        del self.module.filestack[files:]
        del self.module.macrostack[macros:]
        del self.calls[calls:]
        self.cloning.call = self.calls[-1] if self.calls else None

    def _listener(self, level: str) -> Callable[..., None]:
        def listen(*words: object, **_: object) -> None:
            message = " ".join(str(word) for word in words)
            if level != "message":
                node = node_being_evaluated()
                at = node.at if node is not None else Place(SourceText(self.module.filestack[-1] or "", b""), 0, end=0)
                self._add(Problem(ProblemKind.XACRO_WARNING, at, message))

        listen.__name__ = level  # xacro asks for it
        return listen

    # -- problems ----------------------------------------------------------------------------------------------------

    def _keep(self, blame: Blame, error: BaseException) -> None:
        problem = self._problem(blame, error)
        self.found.add_failure(problem, blame.element)
        if not self.strict:
            self._blame_arguments(problem, failed_expression(error))

    def _blame_arguments(self, problem: Problem, expression: str) -> None:
        """Blame an argument for a value that is empty because of it, or for a file that exists with other values."""
        if not self.declared or problem.kind not in OF_VALUES:
            return
        definitions, empty = self.definitions(), empty_arguments(self.declared, self._given)
        behind = definitions.arguments_behind(problem.at, expression)
        self.blamed.update({name: None for name in empty if name in behind})
        if problem.kind is ProblemKind.FILE_NOT_FOUND and self.files.may_read(os.path.dirname(problem.subject)):
            self.blamed.update(dict.fromkeys(placeholders(problem.subject, self.declared, self._given, behind)))
        for name in definitions.arguments_of_file(problem.at, expression) if problem.kind in OF_FILES else ():
            if name in empty:
                self._add(empty_default(empty[name], name))

    def _problem(self, blame: Blame, error: BaseException) -> Problem:
        problem = problem_of(error, blame, self.module.filestack)
        problem = suggested(problem, self._known_names(problem, blame))
        problem = traced(problem, failed_expression(error), [self._written.get(name, ()) for name in blame.properties])
        return problem if self.strict else judged(problem, self.packages)

    def _known_names(self, problem: Problem, blame: Blame) -> Collection[str]:
        """The names that an unknown one may stand for."""
        if problem.kind is ProblemKind.UNDEFINED_ARGUMENT:
            return self.declared
        if problem.kind is ProblemKind.UNKNOWN_MACRO:
            return self.macros
        if problem.kind is ProblemKind.MACRO_CALL and blame.element is not None:
            passed = blame.element.attrs
            called = self.macros.get(blame.element.tagName.removeprefix("xacro:"))
            return [name for name in parameters_of(called) if name not in passed]
        if problem.kind is ProblemKind.UNDEFINED_NAME:
            return {*self._properties, *parameters_around(problem.at, self.macros.values())}
        return ()

    def _add(self, problem: Problem) -> None:
        self.found.add(problem)

    def find_package(self, name: str) -> str:
        """Return the folder of a package, whose files can be read from then on. Raises PackageNotFound."""
        folder = self.packages.find(name)
        self.files.allow(folder)
        node = node_being_evaluated()
        if name in self.packages.assumed and node is not None:
            message = f"package '{name}' has no package.xml, so ROS cannot find it; urdfctl uses the folder '{folder}'"
            self._add(Problem(ProblemKind.MANIFEST_MISSING, node.at, message, name))
        return folder
