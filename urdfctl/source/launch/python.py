"""Evaluate a launch file in Python from its syntax tree, without ever running it.

Statements are followed one by one. If a condition is unknown, both branches are followed, and what they add is marked
as optional. Imported functions and classes are not called: a term records the name and the arguments.
"""

from __future__ import annotations

import ast
import warnings
from collections.abc import Callable, Iterator, Mapping, Sequence
from types import MappingProxyType

from urdfctl.source.launch.classes import class_of
from urdfctl.source.launch.compared import compared_arguments
from urdfctl.source.launch.expressions import Evaluation
from urdfctl.source.launch.frames import Frame, extend, merged
from urdfctl.source.launch.modules import Modules
from urdfctl.source.launch.operations import added, listed, shown, truth
from urdfctl.source.launch.refused import misnamed_entry, refusal
from urdfctl.source.launch.terms import Constant, Function, ImportedName, Items, Perhaps, Term, UnknownTerm, one_of
from urdfctl.source.launch.unbound import unbound_name
from urdfctl.source.launch.unused import unused_actions
from urdfctl.source.opaque import UNKNOWN
from urdfctl.source.problem import Problem, ProblemKind
from urdfctl.source.span import Place, SourceSpan, SourceText
from urdfctl.startup.records import NamedTuple

MOST_BYTES = 1 << 20
_NONE: Mapping[str, Term] = MappingProxyType({})
_ENTRY = "generate_launch_description"
_WITH_VALUE = "use IfCondition, or perform(context) in an OpaqueFunction"
_MOST_JUDGED = 1 << 15
"""Bytes of a launch file whose calls are judged one by one; more are not written by hand."""


class Surroundings(NamedTuple):
    """The system that a launch file can query.

    find: returns the folder of a package that is used at a place; None if it is not among the sources.
    environ: the environment variables.
    module: returns the text of a Python module by its name and the file that imports it; None if it is not found.
    yaml: returns the content of a YAML file; None if it cannot be read.
    too_long: is told a place at which a text becomes too long.
    write: is told the path of a file and the text that the launch file writes into it.
    skip: is told the text of a branch that does not run.
    """

    find: Callable[[str, Place], str | None]
    environ: Mapping[str, str]
    module: Callable[[str, str], SourceText | None] = lambda *_: None
    yaml: Callable[[str], Term | None] = lambda _: None
    too_long: Callable[[Place], None] = lambda _: None
    write: Callable[[str, Term], object] = lambda *_: None
    skip: Callable[[str], object] = lambda _: None


class Script(NamedTuple):
    """The result of reading a launch file in Python.

    term: its launch description; None if the file is not a launch file.
    problems: why the file cannot be read, or what in it has no effect.
    """

    term: Term | None
    problems: tuple[Problem, ...] = ()


def read_python(source: SourceText, surroundings: Surroundings) -> Script:
    """Return the launch description of a file in Python."""
    if len(source.data) > MOST_BYTES:
        return _broken(ProblemKind.BUDGET, Place(source, 0, end=0), "the launch file is larger than 1 MiB")
    try:
        tree = _parsed(source)
    except SyntaxError as error:
        from urdfctl.source.conflicts import merge_conflict

        conflict = merge_conflict(source)
        if conflict is not None:
            return Script(None, (conflict,))
        offset = source.offset(error.lineno or 1, error.offset or 1)
        at = Place(source, offset, end=offset)
        return _broken(ProblemKind.PYTHON_SYNTAX, at, _told(source, error))
    except (ValueError, RecursionError, MemoryError) as error:
        message = "nested too deeply" if isinstance(error, (RecursionError, MemoryError)) else str(error)
        at = Place(source, 0, end=0)
        return _broken(ProblemKind.PYTHON_SYNTAX, at, f"Python syntax error: {message}")
    module = Frame({}, None)
    run = Run(source, surroundings)
    run.block(tree.body, module)
    entry = module.names.get(_ENTRY)
    if not isinstance(entry, Function):
        slip = misnamed_entry(tree, _ENTRY) if entry is None and source.path.endswith("launch.py") else None
        return _broken(ProblemKind.PYTHON_CALL, run.at(slip[0]), slip[1]) if slip else Script(None)
    return Script(entry.call((), {}, None), tuple(_mistakes(tree, source, run.at)))


def _broken(kind: ProblemKind, at: Place, message: str) -> Script:
    return Script(None, (Problem(kind, at, message),))


def _mistakes(tree: ast.Module, source: SourceText, at: Callable[[ast.expr | ast.stmt], Place]) -> Iterator[Problem]:
    """What Python does not find or refuses when the file is started, and what the file creates in vain."""
    nodes = [*ast.walk(tree)]
    name = unbound_name(tree, nodes, _ENTRY)
    if name is not None:
        message = f"name '{name.id}' is not defined; launch stops with a NameError"
        yield Problem(ProblemKind.PYTHON_NAME, at(name), message, name.id)
    elif len(source.data) <= _MOST_JUDGED and (refused := refusal(tree, nodes, _ENTRY)):
        yield Problem(ProblemKind.PYTHON_CALL, at(refused[0]), refused[1])
    for unused in unused_actions(nodes, source.data.decode("utf-8", "replace")):
        message = f"'{unused.id}' is created, but not started; add it to the LaunchDescription"
        yield Problem(ProblemKind.ACTION_UNUSED, at(unused), message, unused.id)
    for compared in compared_arguments(nodes) if b"LaunchConfiguration" in source.data else ():
        message = f"this is always {compared.gives}: a LaunchConfiguration is not its value; {_WITH_VALUE}"
        yield Problem(ProblemKind.ARGUMENT_COMPARED, at(compared.at), message)


def _told(source: SourceText, error: SyntaxError) -> str:
    is_xml = source.data.lstrip().startswith(b"<")
    return "launch file is XML; let its name end in '.launch.xml'" if is_xml else f"Python syntax error: {error.msg}"


def _parsed(source: SourceText) -> ast.Module:
    with warnings.catch_warnings():
        warnings.simplefilter("ignore")
        return ast.parse(source.data.decode("utf-8-sig"))


def evaluated(expression: str, names: Mapping[str, Term] = _NONE, too_long: Callable[[], None] = lambda: None) -> str:
    """Return the text of an expression, such as that of a PythonExpression; UNKNOWN if it cannot be evaluated.

    names: those that it may use.
    too_long: called if the text would be too long.
    """
    source = SourceText("", expression.encode("utf-8", "replace"))
    try:
        with warnings.catch_warnings():
            warnings.simplefilter("ignore")
            tree = ast.parse(expression.strip(), mode="eval")
    except (SyntaxError, ValueError, RecursionError, MemoryError):
        return UNKNOWN
    evaluation = Evaluation(source, lambda *_: None, {}, too_long=lambda _: too_long())
    return shown(evaluation.value(tree.body, Frame(dict(names), None)))


class Run:
    """Follows statements, within a limit of steps."""

    def __init__(self, source: SourceText, surroundings: Surroundings, importer: Run | None = None) -> None:
        self.surroundings = surroundings
        self.modules: Modules = importer.modules if importer else Modules(surroundings.module, self._followed)
        find, environ, _, yaml, too_long, write, _ = surroundings
        self.evaluation = Evaluation(source, find, environ, yaml, too_long, write=write)
        self.evaluation.outer = importer.evaluation if importer else None
        self.evaluation.member = lambda path: self.modules.member(path, source.path)
        self.at = self.evaluation.at
        self.value = self.evaluation.value
        self.bind = self.evaluation.bind

    def _followed(self, source: SourceText) -> Frame | None:
        """The names of a module that the launch file imports."""
        try:
            tree = _parsed(source) if len(source.data) <= MOST_BYTES else None
        except (SyntaxError, ValueError, RecursionError, MemoryError):
            tree = None
        if tree is None:
            return None
        frame = Frame({}, None)
        Run(source, self.surroundings, self).block(tree.body, frame)
        return frame

    def block(self, body: Sequence[ast.stmt], frame: Frame) -> str | None:
        """Follow statements. Return how they end early: `leave`, `break` or `continue`; None if they run to the end."""
        self.evaluation.depth += 1
        try:
            for statement in body:
                if not self.evaluation.may_go_on():
                    frame.sure = False
                    return None
                ended = self._statement(statement, frame)
                if ended:
                    return ended
        finally:
            self.evaluation.depth -= 1
        return None

    def _statement(self, node: ast.stmt, frame: Frame) -> str | None:
        if isinstance(node, ast.Return):
            frame.returned.append(self.value(node.value, frame) if node.value else Constant(None, self.at(node)))
            return "leave"
        if isinstance(node, (ast.Break, ast.Continue, ast.Raise)):
            return {"Break": "break", "Continue": "continue"}.get(type(node).__name__, "leave")
        if isinstance(node, ast.If):
            return self._if(node, frame)
        if isinstance(node, (ast.For, ast.While)):
            return self._loop(node, frame)
        if isinstance(node, ast.With):
            for item in node.items:
                value = self.value(item.context_expr, frame)
                if item.optional_vars is not None:
                    self.bind(item.optional_vars, value, frame)
            return self.block(node.body, frame)
        if isinstance(node, ast.Try):
            ended = self.block([*node.body, *node.orelse], frame)
            return self.block(node.finalbody, frame) or ended
        if isinstance(node, ast.Match):
            self._branches([case.body for case in node.cases], frame)
            return None
        self._simple(node, frame)
        return None

    def _simple(self, node: ast.stmt, frame: Frame) -> None:
        if isinstance(node, ast.Expr):
            self.value(node.value, frame)
        elif isinstance(node, ast.Assign):
            value = self.value(node.value, frame)
            for target in node.targets:
                self.bind(target, value, frame)
        elif isinstance(node, ast.AnnAssign) and node.value is not None:
            self.bind(node.target, self.value(node.value, frame), frame)
        elif isinstance(node, ast.AugAssign):
            self._augmented(node, frame)
        elif isinstance(node, ast.FunctionDef):
            frame.names[node.name] = self._function(node, frame)
        elif isinstance(node, ast.ClassDef):
            frame.names[node.name] = self._class(node, frame)
        elif isinstance(node, (ast.Import, ast.ImportFrom)):
            self._import(node, frame)

    def _import(self, node: ast.Import | ast.ImportFrom, frame: Frame) -> None:
        is_from = isinstance(node, ast.ImportFrom)
        prefix = f"{'.' * node.level}{node.module or ''}." if isinstance(node, ast.ImportFrom) else ""
        for alias in node.names:
            if alias.asname or is_from:
                full = prefix + alias.name
                own = self.evaluation.member(full) if is_from else None
                frame.names[alias.asname or alias.name] = own or ImportedName(full.lstrip("."), self.at(node))
            else:
                top = alias.name.partition(".")[0]
                frame.names[top] = ImportedName(top, self.at(node))

    def _augmented(self, node: ast.AugAssign, frame: Frame) -> None:
        value = self.value(node.value, frame)
        old = self.value(node.target, frame)
        if isinstance(node.op, ast.Add) and isinstance(old, Items):
            extend(old, value, frame)
        else:
            new = added(old, value, self.at(node)) if isinstance(node.op, ast.Add) else UnknownTerm(self.at(node))
            self.bind(node.target, new, frame)

    def _if(self, node: ast.If, frame: Frame) -> str | None:
        held = truth(self.value(node.test, frame))
        if held is not None:
            body, other = (node.body, node.orelse) if held else (node.orelse, node.body)
            if other:
                first, last = self.at(other[0]), self.at(other[-1])
                self.surroundings.skip(SourceSpan(first.source, first.start, last.span.end).text)
            return self.block(body, frame)
        return self._branches([node.body, node.orelse], frame)

    def _branches(self, bodies: Sequence[Sequence[ast.stmt]], frame: Frame) -> str | None:
        """Follow all branches, of which only one runs. Names that have the same term in all of them stay known."""
        before, was_sure = frame.names, frame.sure
        continuing, ends = [], []
        frame.sure = False
        for body in bodies:
            frame.names = dict(before)
            ended = self.block(body, frame)
            ends.append(ended)
            if ended is None:
                continuing.append(frame.names)
        frame.sure = was_sure and not any(ends)
        if not continuing:
            frame.names = before
            frame.sure = was_sure and len(set(ends)) == 1
            return ends[0]
        frame.names = merged(continuing)
        return None

    def _loop(self, node: ast.For | ast.While, frame: Frame) -> str | None:
        was_sure = frame.sure
        items = self.value(node.iter, frame) if isinstance(node, ast.For) else None
        known = listed(items) if items is not None else None
        if known is None:
            before, frame.sure = dict(frame.names), False
            if isinstance(node, ast.For):
                self.bind(node.target, UnknownTerm(self.at(node.iter)), frame)
            self.block(node.body, frame)
            frame.names = merged([before, frame.names])
            frame.sure = was_sure
            return None
        ended = None
        for item in known:
            certain = not isinstance(item, Perhaps)
            inner, frame.sure = frame.sure, frame.sure and certain
            if isinstance(node, ast.For):
                self.bind(node.target, item.term if isinstance(item, Perhaps) else item, frame)
            ended = self.block(node.body, frame)
            frame.sure = frame.sure if certain else inner
            if ended in {"break", "leave"} and certain:
                break
        if ended == "leave":
            return ended
        frame.sure = was_sure
        return self.block(node.orelse, frame) if ended != "break" else None

    def _class(self, node: ast.ClassDef, frame: Frame) -> Term:
        inner = Frame({}, frame)
        self.block([one for one in node.body if not isinstance(one, ast.FunctionDef)], inner)
        bases = [self.value(base, frame) for base in node.bases]
        return class_of(node, bases, inner, lambda one: self._function(one, frame), self.at(node))

    def _function(self, node: ast.FunctionDef, frame: Frame) -> Function:
        def body(inner: Frame) -> Term:
            ended = self.block(node.body, inner)
            results = inner.returned if ended else [*inner.returned, Constant(None, self.at(node))]
            return one_of(results, self.at(node))

        return self.evaluation.function(node.name, node, frame, body)
