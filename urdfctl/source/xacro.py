"""Expands xacro with the installed xacro package, and keeps for every element where it was written and by which calls.

What comes out is, byte for byte, what `xacro` itself would write. A problem either ends the expansion (`strict`), or is
kept and costs only the element it is in, so that one run tells all of them.
"""

from __future__ import annotations

import os
import sys
from collections.abc import Callable, Mapping
from types import FrameType, ModuleType

from urdfctl.hints import Any
from urdfctl.record import NamedTuple
from urdfctl.source import engine, xacro_hooks
from urdfctl.source.budget import MAX_CALL_DEPTH, MAX_CALLS, MAX_ELEMENTS, MAX_PROBLEMS, OverBudget
from urdfctl.source.dom import COMMENT, Cloning, Document, Element, Node, Text
from urdfctl.source.files import FileProblem, Files
from urdfctl.source.influence import Definitions
from urdfctl.source.leftovers import empty_default, leftovers, repeated_condition, unused_arguments
from urdfctl.source.macro_names import macro_of_other_file
from urdfctl.source.opaque import UNKNOWN
from urdfctl.source.packages import Packages
from urdfctl.source.problem import Problem, ProblemKind
from urdfctl.source.span import Call, Place, SourceText
from urdfctl.source.xacro_errors import Blame, blame_of, failed_expression, problem_of
from urdfctl.source.xml import parse

_CONSEQUENCES = {
    ProblemKind.UNDEFINED_NAME,
    ProblemKind.UNKNOWN_MACRO,
    ProblemKind.UNDEFINED_ARGUMENT,
    ProblemKind.XACRO,
}
_OF_FILES = {ProblemKind.FILE_NOT_FOUND, ProblemKind.FILE_UNREADABLE}

HARMLESS = {
    ProblemKind.LATE_DECLARATION,
    ProblemKind.XACRO_WARNING,
    ProblemKind.DUPLICATE_MACRO,
    ProblemKind.MACRO_OF_OTHER_FILE,
    ProblemKind.ARGUMENT_UNUSABLE,
    ProblemKind.UNUSED_ARGUMENT,
    ProblemKind.UNKNOWN_ARGUMENT,
    ProblemKind.MANIFEST_MISSING,
    ProblemKind.CONDITION_REPEATED,
    ProblemKind.PREFIX_MISSING,
    ProblemKind.BRACES,
}
"""The kinds of problems that cost nothing of the robot."""


class Expansion(NamedTuple):
    """What became of one file: the expanded tree, what was met on the way, and whether it is a macro library, whose
    macros were called with values that are not known."""

    document: Document | None
    problems: list[Problem]
    library: bool = False

    @property
    def complete(self) -> bool:
        """False where a problem cost a part of the robot."""
        return self.document is not None and not self.library and all(p.kind in HARMLESS for p in self.problems)


class Expander:
    """Expands one file once. `trust` lets its expressions and DOCTYPEs do whatever xacro lets them."""

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
        self.problems: list[Problem] = []
        self.cloning = Cloning()
        self.calls: list[Call] = []
        self.module: ModuleType = engine.load()
        self._called = 0
        self.macros: dict[str, Element] = {}
        """The macros that were defined on the way, each by its last definition."""
        self.loaded: dict[str, None] = {}
        """The YAML files that expressions loaded, in order."""
        self._given: Mapping[str, str] = {}
        self._properties: dict[str, set[str]] = {}
        self._declared: dict[str, Element] = {}
        self._seen: set[tuple[ProblemKind, str, str]] = set()
        self._include_failed = False
        self._originals: dict[str, Callable[..., Any]] = {}
        self._install()

    def expand(self, path: str, arguments: Mapping[str, str]) -> Expansion:
        """The expansion of a file with `name:=value` arguments."""
        module = self.module
        module.init_stacks(path)
        self._given = arguments
        sys.setrecursionlimit(max(sys.getrecursionlimit(), 20 * MAX_CALL_DEPTH))
        document: Document | None = None
        try:
            document = parse(self.files.read(path), self.cloning, declarations=self.trust)
            module.process_doc(document, mappings=self._arguments(arguments), verbosity=1)
            self._processed(document, arguments)
        except FileProblem as error:
            self.problems.append(error.at(Place(SourceText(path, b""), 0, end=0)))
        except Exception as error:  # noqa: BLE001 (whatever the description made xacro raise)
            self._keep(blame_of(error), error)
            document = None if self.strict else document
        finally:
            engine.release(module)
        return Expansion(document, self.problems)

    def _arguments(self, given: Mapping[str, str]) -> dict[str, str]:
        return dict(given)

    def _processed(self, document: Document, given: Mapping[str, str]) -> None:
        """What is left to do when xacro is done: to look for what it passed over."""
        root = document.documentElement
        if self.strict or root is None:
            return
        sources = self.files.sources()
        for problem in leftovers(document, sources, self.macros, self._properties):
            self._add(problem)
        for problem in unused_arguments(self._declared, given, sources, Place(root.source, root.start)):
            self._add(problem)

    def definitions(self) -> Definitions:
        """What was defined on the way, and the arguments that were given."""
        defaults = {name: element.attrs.get("default", "") for name, element in self._declared.items()}
        return Definitions(self._properties, {**defaults, **self._given}, tuple(self.loaded))

    # -- the replaced helpers of xacro -------------------------------------------------------------------------------

    def _install(self) -> None:
        module = self.module
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
            setattr(module, name, getattr(self, f"_{name}"))
        module._empty_text_node = Text("\n\n")  # type: ignore[attr-defined]
        module.parse = self._parse  # type: ignore[attr-defined]
        module.print_location = lambda: None  # type: ignore[attr-defined]
        for level in ("warning", "error", "message"):
            setattr(module, level, self._listener(level))
        xacro_hooks.install(self)

    def _parse(self, _input: object, filename: str) -> Document:
        module = self.module
        include = self.calls[-1] if self.calls else None
        try:
            return parse(self.files.read(filename), self.cloning, include, declarations=self.trust)
        except FileProblem as error:
            module.filestack.pop()
            absent = error.kind is ProblemKind.FILE_NOT_FOUND or os.path.isdir(error.path)
            if absent:  # an optional include may be absent: xacro looks for an IOError inside
                raise module.XacroException(exc=_AbsentFile(error)) from error
            raise

    def _process_include(self, node: Element, macros: object, symbols: object, evaluate: object) -> None:
        self._enter(Call("include", node.attrs.get("filename", ""), node.source, node.start, node.call))
        self._originals["process_include"](node, macros, symbols, evaluate)
        self._leave()

    def _handle_macro_call(self, node: Element, macros: object, symbols: object) -> bool:
        name = node.tagName
        if not name.startswith("xacro:"):
            return False
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
            raise OverBudget(f"macros and includes call each other more than {MAX_CALL_DEPTH} deep")
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
            texts = self._properties.setdefault(node.attrs.get("name", ""), set())
            texts.add(node.attrs.get("value", node.attrs.get("default", "")))
        elif node.tagName == "xacro:arg":
            self._declared.setdefault(node.attrs.get("name", ""), node)
        return self._originals["check_attrs"](node, required, optional)

    def _replace_node(self, node: Node, by: object, content_only: bool = False) -> None:  # noqa: FBT001, FBT002 (xacro's signature)
        if by is None and isinstance(node, Element) and node.tagName == "xacro:attribute":
            self._note_attribute(node, node.parentNode)
        self._originals["replace_node"](node, by, content_only)

    def _note_attribute(self, node: Element, parent: Node | None) -> None:
        """Remember who wrote an attribute of `parent`. A value that is no text is a fault: xacro cannot write it."""
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
            raise self.module.XacroException(f"attribute '{name}' becomes {value!r}, no text: xacro cannot write it")
        parent.attrs[name] = ""
        message = f"attribute '{name}' becomes {value!r}, no text: xacro writes an empty attribute"
        self._add(Problem(ProblemKind.XACRO_WARNING, node.at["value"], message))

    def _grab_macro(self, node: Element, macros: Any) -> None:
        name = node.attrs.get("name", "").removeprefix("xacro:")
        before = macros[name].body if name and dict.__contains__(macros, name) else None
        self._originals["grab_macro"](node, macros)
        self.macros[name] = node
        if before is not None and (before.source.path, before.start) != (node.source.path, node.start):
            position = before.source.position(before.start)
            message = f"macro '{name}' is defined again; its definition at {before.source.path}:{position.line} is lost"
            self._add(Problem(ProblemKind.DUPLICATE_MACRO, node.at["name"], message, name))
        for problem in macro_of_other_file(name, node, self.files):
            self._add(problem)

    def _eval_all(self, node: Element, macros: object, symbols: object) -> None:
        evaluate = self._originals["eval_all"]
        depth = len(self.module.filestack), len(self.module.macrostack), len(self.calls)
        done: list[Node] = []
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
                if not _cut_out(blame, node, done):
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
                node = _node_being_evaluated()
                at = node.at if node is not None else Place(SourceText(self.module.filestack[-1] or "", b""), 0, end=0)
                self._add(Problem(ProblemKind.XACRO_WARNING, at, message))

        listen.__name__ = level  # xacro asks for it
        return listen

    # -- problems ----------------------------------------------------------------------------------------------------

    def _keep(self, blame: Blame, error: BaseException) -> None:
        problem = self._problem(blame, error)
        if self._include_failed and problem.kind in _CONSEQUENCES:
            return  # most likely what the missing file would have brought
        if blame.element is not None and blame.element.tagName == "xacro:include":
            self._include_failed = True
        self._add(problem)
        if problem.kind in _OF_FILES and not self.strict:
            self._blame_arguments(problem.at, failed_expression(error))

    def _blame_arguments(self, at: Place, expression: str) -> None:
        """A file's name that comes to nothing is the fault of an argument that stands in it and is empty by default."""
        for name in self.definitions().arguments_of_file(at, expression):
            declared = self._declared.get(name)
            if declared is not None and name not in self._given and not declared.attrs.get("default", "-").strip():
                self._add(empty_default(declared, name))

    def _problem(self, blame: Blame, error: BaseException) -> Problem:
        return problem_of(error, blame, self.module.filestack)

    def _add(self, problem: Problem) -> None:
        key = (problem.kind, problem.subject, problem.message)
        if key in self._seen:
            return
        self._seen.add(key)
        self.problems.append(problem)
        if len(self.problems) > MAX_PROBLEMS:
            raise OverBudget(f"more than {MAX_PROBLEMS} problems")

    def find_package(self, name: str) -> str:
        """The folder of a package, which may be read from then on. PackageNotFound where there is none."""
        folder = self.packages.find(name)
        self.files.allow(folder)
        node = _node_being_evaluated()
        if name in self.packages.assumed and node is not None:
            message = f"package '{name}' has no package.xml: ROS will not find it; its folder is taken to be '{folder}'"
            self._add(Problem(ProblemKind.MANIFEST_MISSING, node.at, message, name))
        return folder


class _AbsentFile(FileProblem, OSError):
    """A file that is not there, in the form in which xacro looks for it."""

    def __init__(self, problem: FileProblem) -> None:
        FileProblem.__init__(self, problem.kind, problem.path, problem.message, problem.hint)


def _cut_out(blame: Blame, parent: Element, done: list[Node]) -> bool:
    """Take what could not be evaluated out of the tree, so that the rest can go on; False where nothing can be.
    What stands before it is evaluated already, and twice would be wrong: it comes to stand in `done`."""
    if blame.attribute is not None and blame.element is parent and blame.attribute in parent.attrs:
        parent.attrs[blame.attribute] = UNKNOWN
        return True
    node: Node | None = blame.node
    while node is not None and node.parentNode is not parent:
        node = node.parentNode
    if node is None:
        return False
    done += _taken_from_before(node, parent)
    if isinstance(node, Text):
        node.data = UNKNOWN
    else:
        parent.removeChild(node)
    return True


def _taken_from_before(node: Node, parent: Element) -> list[Node]:
    """The siblings before a node, taken out of the tree; not the comments next to it, which xacro removes with what
    they speak of."""
    taken: list[Node] = []
    before = node.previousSibling
    while isinstance(before, Text) and (before.nodeType == COMMENT or not before.data.strip()):
        before = before.previousSibling
    while before is not None:
        taken.append(before)
        before = before.previousSibling
    for sibling in taken:
        parent.removeChild(sibling)
    return taken[::-1]


def _node_being_evaluated() -> Element | None:
    frame: FrameType | None = sys._getframe(1)
    while frame is not None:
        if frame.f_code.co_name == "eval_all":
            node = frame.f_locals.get("node")
            if isinstance(node, Element):
                return node
            if isinstance(node, Node) and isinstance(node.parentNode, Element):
                return node.parentNode
        frame = frame.f_back
    return None
