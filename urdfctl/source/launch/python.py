"""What a launch file in Python builds, told from its syntax tree: nothing of it is ever run.

Statements are followed one by one; where a condition is not known both ways are, and what they add is only perhaps
there. Imported things are called in name only: the term says what was called with what.
"""

from __future__ import annotations

import ast
import warnings
from collections.abc import Callable, Mapping, Sequence

from urdfctl.record import NamedTuple
from urdfctl.source.launch.expressions import Evaluation
from urdfctl.source.launch.operations import added, shown, truth
from urdfctl.source.launch.terms import (
    MOST_ITEMS,
    Called,
    Constant,
    Context,
    Function,
    Items,
    Missing,
    Name,
    Perhaps,
    Table,
    Term,
    one_of,
    perhaps,
)
from urdfctl.source.opaque import UNKNOWN
from urdfctl.source.problem import Problem, ProblemKind
from urdfctl.source.span import Place, SourceText

MOST_BYTES = 1 << 20
_MOST_STEPS = 100_000
_MOST_DEPTH = 100
_MOST_CALLS = 20
_ENTRY = "generate_launch_description"


class Surroundings(NamedTuple):
    """What a launch file may ask of the system: the folder of a package, None where it is not among the sources; and
    the environment."""

    find: Callable[[str, Place], str | None]
    environ: Mapping[str, str]


class Script(NamedTuple):
    """What a file builds: None where it is no launch file, and the problem that kept it from being read."""

    term: Term | None
    problem: Problem | None = None


def read_python(source: SourceText, surroundings: Surroundings) -> Script:
    """The launch description of a file in Python."""
    if len(source.data) > MOST_BYTES:
        return Script(
            None, Problem(ProblemKind.BUDGET, Place(source, 0, end=0), "the launch file is larger than 1 MiB")
        )
    try:
        with warnings.catch_warnings():
            warnings.simplefilter("ignore")
            tree = ast.parse(source.data.decode("utf-8-sig"))
    except SyntaxError as error:
        offset = source.offset(error.lineno or 1, error.offset or 1)
        at = Place(source, offset, end=offset)
        return Script(None, Problem(ProblemKind.PYTHON_SYNTAX, at, f"no good Python: {error.msg}"))
    except (ValueError, RecursionError, MemoryError) as error:
        message = "nested too deep" if isinstance(error, (RecursionError, MemoryError)) else str(error)
        return Script(None, Problem(ProblemKind.PYTHON_SYNTAX, Place(source, 0, end=0), f"no good Python: {message}"))
    module = _Frame({}, None)
    run = Run(source, surroundings)
    run.block(tree.body, module)
    entry = module.names.get(_ENTRY)
    return Script(entry.call((), {}, None) if isinstance(entry, Function) else None)


def evaluated(expression: str) -> str:
    """What `PythonExpression` gives for a text; UNKNOWN where that cannot be told."""
    source = SourceText("", expression.encode("utf-8", "replace"))
    try:
        with warnings.catch_warnings():
            warnings.simplefilter("ignore")
            tree = ast.parse(expression.strip(), mode="eval")
    except (SyntaxError, ValueError, RecursionError, MemoryError):
        return UNKNOWN
    return shown(Run(source, Surroundings(lambda *_: None, {})).value(tree.body, _Frame({}, None)))


class _Frame:
    """The names of a function that is followed, or of the file; not `sure` where it may not come to here."""

    __slots__ = ("calls", "names", "outer", "returned", "sure")

    def __init__(self, names: dict[str, Term], outer: _Frame | None, *, sure: bool = True, calls: int = 0) -> None:
        self.names = names
        self.outer = outer
        self.returned: list[Term] = []
        self.sure = sure
        self.calls = calls

    def find(self, name: str) -> Term | None:
        frame: _Frame | None = self
        while frame is not None:
            if name in frame.names:
                return frame.names[name]
            frame = frame.outer
        return None


class Run:
    """Follows statements, within a number of steps."""

    def __init__(self, source: SourceText, surroundings: Surroundings) -> None:
        self.source = source
        self.steps = 0
        self.depth = 0
        self.evaluation = Evaluation(self, surroundings)
        self.context: Context | None = None

    def at(self, node: ast.expr | ast.stmt) -> Place:
        """Where a node stands: from its first to its last byte."""
        starts = self.source.line_starts()
        bom = 3 if self.source.data.startswith(b"\xef\xbb\xbf") else 0

        def offset(line: int, column: int) -> int:
            return starts[min(line, len(starts)) - 1] + column + (bom if line == 1 else 0)

        end = offset(node.end_lineno or node.lineno, node.end_col_offset or node.col_offset)
        return Place(self.source, offset(node.lineno, node.col_offset), end=end)

    def may_go_on(self) -> bool:
        """Whether another step may be made."""
        self.steps += 1
        return self.steps < _MOST_STEPS and self.depth < _MOST_DEPTH

    def value(self, node: ast.expr, frame: _Frame) -> Term:
        """What an expression stands for."""
        if not self.may_go_on():
            return Missing(self.at(node))
        self.depth += 1
        try:
            return self.evaluation.of(node, frame)
        finally:
            self.depth -= 1

    # -- statements --------------------------------------------------------------------------------------------------

    def block(self, body: Sequence[ast.stmt], frame: _Frame) -> str | None:
        """Follow some statements; how they end early: with `leave`, `break` or `continue`."""
        self.depth += 1
        try:
            for statement in body:
                if not self.may_go_on():
                    frame.sure = False
                    return None
                ended = self._statement(statement, frame)
                if ended:
                    return ended
        finally:
            self.depth -= 1
        return None

    def _statement(self, node: ast.stmt, frame: _Frame) -> str | None:
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
            self._ways([case.body for case in node.cases], frame)
            return None
        self._simple(node, frame)
        return None

    def _simple(self, node: ast.stmt, frame: _Frame) -> None:
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
            frame.names[node.name] = self.function(node.name, node, node.args, frame)
        elif isinstance(node, ast.ClassDef):
            frame.names[node.name] = Missing(self.at(node))
        elif isinstance(node, (ast.Import, ast.ImportFrom)):
            self._import(node, frame)

    def _import(self, node: ast.Import | ast.ImportFrom, frame: _Frame) -> None:
        prefix = f"{node.module or ''}." if isinstance(node, ast.ImportFrom) else ""
        for alias in node.names:
            if alias.asname:
                frame.names[alias.asname] = Name(prefix + alias.name, self.at(node))
            elif prefix:
                frame.names[alias.name] = Name(prefix + alias.name, self.at(node))
            else:
                top = alias.name.partition(".")[0]
                frame.names[top] = Name(top, self.at(node))

    def _augmented(self, node: ast.AugAssign, frame: _Frame) -> None:
        value = self.value(node.value, frame)
        old = self.value(node.target, frame)
        if isinstance(node.op, ast.Add) and isinstance(old, Items):
            self.extend(old, value, frame)
        else:
            new = added(old, value, self.at(node)) if isinstance(node.op, ast.Add) else Missing(self.at(node))
            self.bind(node.target, new, frame)

    def _if(self, node: ast.If, frame: _Frame) -> str | None:
        held = truth(self.value(node.test, frame))
        if held is not None:
            return self.block(node.body if held else node.orelse, frame)
        return self._ways([node.body, node.orelse], frame)

    def _ways(self, bodies: Sequence[Sequence[ast.stmt]], frame: _Frame) -> str | None:
        """Follow all of some ways, of which only one is gone; what they agree on stays known."""
        before, was_sure = frame.names, frame.sure
        going_on, ends = [], []
        frame.sure = False
        for body in bodies:
            frame.names = dict(before)
            ended = self.block(body, frame)
            ends.append(ended)
            if ended is None:
                going_on.append(frame.names)
        frame.sure = was_sure and not any(ends)
        if not going_on:
            frame.names = before
            frame.sure = was_sure and len(set(ends)) == 1
            return ends[0]
        frame.names = _merged(going_on)
        return None

    def _loop(self, node: ast.For | ast.While, frame: _Frame) -> str | None:
        was_sure = frame.sure
        items = self.value(node.iter, frame) if isinstance(node, ast.For) else None
        known = self.evaluation.listed(items) if items is not None else None
        if known is None:
            before, frame.sure = dict(frame.names), False
            if isinstance(node, ast.For):
                self.bind(node.target, Missing(self.at(node.iter)), frame)
            self.block(node.body, frame)
            frame.names = _merged([before, frame.names])
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

    def bind(self, target: ast.expr, value: Term, frame: _Frame) -> None:
        """Give a value to what is left of `=`."""
        if isinstance(target, ast.Name):
            frame.names[target.id] = value
        elif isinstance(target, (ast.Tuple, ast.List)):
            items = self.evaluation.listed(value)
            known = items is not None and len(items) == len(target.elts)
            for index, element in enumerate(target.elts):
                self.bind(element, items[index] if items and known else Missing(self.at(target)), frame)
        elif isinstance(target, ast.Subscript):
            of = self.value(target.value, frame)
            if isinstance(of, Table):
                key = self.value(target.slice, frame)
                of.put(key, value if frame.sure else one_of([value, Missing(self.at(target))], self.at(target)))
        elif isinstance(target, ast.Starred):
            self.bind(target.value, Missing(self.at(target)), frame)

    @staticmethod
    def extend(items: Items, value: Term, frame: _Frame) -> None:
        """Add the items of a list to another, perhaps where it is not sure that this is come to."""
        more = value.values if isinstance(value, Items) else [Perhaps(value, value.at)]
        for one in more[:MOST_ITEMS]:
            Run.append(items, one, frame)

    @staticmethod
    def append(items: Items, value: Term, frame: _Frame) -> None:
        """Add an item to a list."""
        if len(items.values) < MOST_ITEMS:
            items.values.append(value if frame.sure else perhaps(value))

    @staticmethod
    def add(called: Called, value: Term, frame: _Frame) -> None:
        """Add an action to a launch description."""
        if len(called.added) < MOST_ITEMS:
            called.added.append(value if frame.sure else perhaps(value))

    # -- functions ---------------------------------------------------------------------------------------------------

    def function(self, name: str, node: ast.FunctionDef | ast.Lambda, given: ast.arguments, frame: _Frame) -> Function:
        """A function of the file."""
        defaults = [self.value(default, frame) for default in given.defaults]
        named = [None if default is None else self.value(default, frame) for default in given.kw_defaults]
        at = self.at(node)

        def call(arguments: Sequence[Term], keywords: Mapping[str, Term], context: Context | None) -> Term:
            names = _bound(given, arguments, keywords, at)
            positional = [*given.posonlyargs, *given.args]
            for argument, default in zip(positional[len(positional) - len(defaults) :], defaults, strict=True):
                names.setdefault(argument.arg, default)
            for argument, own in zip(given.kwonlyargs, named, strict=True):
                names.setdefault(argument.arg, own or Missing(at))
            for argument in positional:
                names.setdefault(argument.arg, Missing(at))
            return self._called(node, _Frame(names, frame), context)

        return Function(name, call, at)

    def _called(self, node: ast.FunctionDef | ast.Lambda, frame: _Frame, context: Context | None) -> Term:
        outer = self.context
        self.context = context or outer
        caller, self.evaluation.frame = self.evaluation.frame, frame
        frame.calls = caller.calls + 1 if caller else 0
        frame.sure = context is not None or caller is None or caller.sure
        try:
            if frame.calls > _MOST_CALLS:
                return Missing(self.at(node))
            if isinstance(node, ast.Lambda):
                return self.value(node.body, frame)
            ended = self.block(node.body, frame)
        finally:
            self.context, self.evaluation.frame = outer, caller
        ways = frame.returned if ended else [*frame.returned, Constant(None, self.at(node))]
        return one_of(ways, self.at(node))


def _bound(given: ast.arguments, arguments: Sequence[Term], keywords: Mapping[str, Term], at: Place) -> dict[str, Term]:
    """The names that the arguments of a call are bound to."""
    positional = [argument.arg for argument in (*given.posonlyargs, *given.args)]
    names = dict(zip(positional, arguments, strict=False))
    if given.vararg:
        names[given.vararg.arg] = Items(list(arguments[len(positional) :]), at)
    known = {*positional, *(argument.arg for argument in given.kwonlyargs)}
    names.update((name, value) for name, value in keywords.items() if name in known)
    if given.kwarg:
        rest = Table(at)
        for name, value in keywords.items():
            if name not in known:
                rest.put(Constant(name, value.at), value)
        names[given.kwarg.arg] = rest
    return names


def _merged(ways: Sequence[dict[str, Term]]) -> dict[str, Term]:
    """The names after some ways of which only one was gone."""
    merged: dict[str, Term] = {}
    for name in dict.fromkeys(name for way in ways for name in way):
        values = [way[name] for way in ways if name in way]
        merged[name] = one_of(values, values[0].at)
    return merged
