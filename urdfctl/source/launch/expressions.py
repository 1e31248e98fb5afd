"""Evaluate the expressions of a launch file in Python."""

from __future__ import annotations

import ast
import os
from collections.abc import Callable, Iterator, Mapping, Sequence
from itertools import islice
from typing import Any

from urdfctl.source.launch.calls import Calls, entities_of
from urdfctl.source.launch.classes import assign, attribute_of, created
from urdfctl.source.launch.frames import Frame, bound
from urdfctl.source.launch.nodes import inside_quotes, place_of
from urdfctl.source.launch.operations import (
    binary,
    compared,
    item_of,
    joined_at,
    listed,
    shown,
    slice_of,
    text_at,
    truth,
)
from urdfctl.source.launch.terms import (
    MOST_ITEMS,
    Called,
    Constant,
    Context,
    Function,
    ImportedName,
    Items,
    Member,
    OwnClass,
    OwnObject,
    Perhaps,
    Table,
    Term,
    UnknownTerm,
    one_of,
    perhaps,
)
from urdfctl.source.opaque import UNKNOWN
from urdfctl.source.span import Place, SourceText

_MOST_STEPS = 100_000
_MOST_DEPTH = 100
_MOST_CALLS = 20


class Evaluation:
    """Evaluates expressions of one launch file to terms, within limits of steps and nesting.

    source: the file.
    frame: the frame of the current function call; None outside of calls.
    context: the launch context of the current call of an OpaqueFunction; None outside of one.
    find, environ, yaml, too_long, write: see `python.Surroundings`.
    outer: the evaluation of the file that imports this one; None for a launch file.
    member: returns what a full name means in the modules of the workspace; None if it is not there.
    """

    def __init__(
        self,
        source: SourceText,
        find: Callable[[str, Place], str | None],
        environ: Mapping[str, str],
        yaml: Callable[[str], Term | None] = lambda _: None,
        too_long: Callable[[Place], None] = lambda _: None,
        write: Callable[[str, Term], object] = lambda *_: None,
    ) -> None:
        self.source = source
        self.frame: Frame | None = None
        self.context: Context | None = None
        self.outer: Evaluation | None = None
        self.member: Callable[[str], Term | None] = lambda _: None
        self._too_long = too_long
        self._calls = Calls(find, environ, yaml, self._performed, write)
        self.steps = 0
        self.depth = 0
        self._kinds: dict[type[ast.expr], Callable[[Any, Frame], Term]] = {
            ast.Constant: self._constant,
            ast.Name: self._name,
            ast.Attribute: self._attribute,
            ast.Call: self._call,
            ast.List: self._list,
            ast.Tuple: self._list,
            ast.Set: self._list,
            ast.Dict: self._dict,
            ast.JoinedStr: self._joined,
            ast.BinOp: self._binary,
            ast.BoolOp: self._bool,
            ast.UnaryOp: self._unary,
            ast.Compare: self._compare,
            ast.IfExp: self._either,
            ast.Subscript: self._subscript,
            ast.ListComp: self._comprehension,
            ast.GeneratorExp: self._comprehension,
            ast.SetComp: self._comprehension,
            ast.DictComp: self._dict_comprehension,
            ast.Lambda: self._lambda,
            ast.NamedExpr: self._named,
        }

    def at(self, node: ast.expr | ast.stmt) -> Place:
        """Return the place of a node, from its first to its last byte."""
        return place_of(self.source, node)

    def may_go_on(self) -> bool:
        """Count a step, and return whether the limits of steps and of nesting allow it."""
        self.steps += 1
        return self.steps < _MOST_STEPS and self.depth < _MOST_DEPTH

    def value(self, node: ast.expr, frame: Frame) -> Term:
        """Return the term of an expression."""
        if not self.may_go_on():
            return UnknownTerm(self.at(node))
        evaluate = self._kinds.get(type(node))
        self.depth += 1
        try:
            term = evaluate(node, frame) if evaluate else UnknownTerm(self.at(node))
        finally:
            self.depth -= 1
        if isinstance(term, UnknownTerm) and term.too_long:
            self._too_long(term.at)
        return term

    def bind(self, target: ast.expr, value: Term, frame: Frame) -> None:
        """Assign a term to the target of an assignment or a loop."""
        if isinstance(target, ast.Name):
            frame.names[target.id] = value
        elif isinstance(target, (ast.Tuple, ast.List)):
            items = listed(value)
            known = items is not None and len(items) == len(target.elts)
            for index, element in enumerate(target.elts):
                self.bind(element, items[index] if items and known else UnknownTerm(self.at(target)), frame)
        elif isinstance(target, ast.Subscript):
            table = self.value(target.value, frame)
            if isinstance(table, Table):
                key = self.value(target.slice, frame)
                table.put(key, value if frame.sure else one_of([value, UnknownTerm(self.at(target))], self.at(target)))
        elif isinstance(target, ast.Attribute):
            of = self.value(target.value, frame)
            if isinstance(of, OwnObject):
                assign(of, target.attr, value, sure=frame.sure)
        elif isinstance(target, ast.Starred):
            self.bind(target.value, UnknownTerm(self.at(target)), frame)

    # -- functions ---------------------------------------------------------------------------------------------------

    def function(
        self, name: str, node: ast.FunctionDef | ast.Lambda, frame: Frame, body: Callable[[Frame], Term]
    ) -> Function:
        """Return the term of a function that the file defines.

        frame: the frame in which it is defined.
        body: returns what the function's body returns in the frame of a call.
        """
        given = node.args
        defaults = [self.value(default, frame) for default in given.defaults]
        keyword_defaults = [None if default is None else self.value(default, frame) for default in given.kw_defaults]
        at = self.at(node)

        def call(arguments: Sequence[Term], keywords: Mapping[str, Term], context: Context | None) -> Term:
            names = bound(given, arguments, keywords, at)
            positional = [*given.posonlyargs, *given.args]
            for parameter, default in zip(positional[len(positional) - len(defaults) :], defaults, strict=True):
                names.setdefault(parameter.arg, default)
            for parameter, keyword_default in zip(given.kwonlyargs, keyword_defaults, strict=True):
                names.setdefault(parameter.arg, keyword_default or UnknownTerm(at))
            for parameter in positional:
                names.setdefault(parameter.arg, UnknownTerm(at))
            return self._call_in(Frame(names, frame), body, context, at)

        return Function(name, call, at)

    def _call_in(self, frame: Frame, body: Callable[[Frame], Term], context: Context | None, at: Place) -> Term:
        outer = self.context
        self.context = context or outer
        caller, self.frame = self.frame, frame
        frame.calls = caller.calls + 1 if caller else 0
        frame.sure = context is not None or caller is None or caller.sure
        try:
            return body(frame) if frame.calls <= _MOST_CALLS else UnknownTerm(at)
        finally:
            self.context, self.frame = outer, caller

    # -- literals ----------------------------------------------------------------------------------------------------

    def _constant(self, node: ast.Constant, _: Frame) -> Term:
        at = self.at(node)
        value = node.value
        if isinstance(value, str):
            return text_at(value, inside_quotes(at, value))
        return Constant(value, at) if value is None or isinstance(value, (bool, int, float)) else UnknownTerm(at)

    def _list(self, node: ast.List | ast.Tuple | ast.Set, frame: Frame) -> Term:
        return Items(list(islice(self._spread(node.elts, frame), MOST_ITEMS)), self.at(node))

    def _spread(self, nodes: Sequence[ast.expr], frame: Frame) -> Iterator[Term]:
        for node in nodes:
            if isinstance(node, ast.Starred):
                value = self.value(node.value, frame)
                items = listed(value)
                yield from items if items is not None else [Perhaps(UnknownTerm(value.at), value.at)]
            else:
                yield self.value(node, frame)

    def _dict(self, node: ast.Dict, frame: Frame) -> Term:
        table = Table(self.at(node))
        for key, item in zip(node.keys, node.values, strict=True):
            value = self.value(item, frame)
            if key is not None:
                table.put(self.value(key, frame), value)
            elif isinstance(value, Table):
                table.take(value)
            else:
                table.whole = False
        return table

    def _joined(self, node: ast.JoinedStr, frame: Frame) -> Term:
        return joined_at("", self._parts(node, frame), self.at(node))

    def _parts(self, node: ast.JoinedStr, frame: Frame) -> Iterator[str]:
        for part in node.values:
            if isinstance(part, ast.FormattedValue):
                plain = part.format_spec is None and part.conversion in {-1, ord("s")}
                yield shown(self.value(part.value, frame)) if plain else UNKNOWN
            elif isinstance(part, ast.Constant):
                yield str(part.value)

    def _lambda(self, node: ast.Lambda, frame: Frame) -> Term:
        return self.function("lambda", node, frame, lambda inner: self.value(node.body, inner))

    # -- names -------------------------------------------------------------------------------------------------------

    def _name(self, node: ast.Name, frame: Frame) -> Term:
        at = self.at(node)
        if node.id == "__file__":
            return Constant(os.path.abspath(self.source.path), at)
        term = frame.find(node.id)
        return ImportedName(node.id, at) if term is None else term

    def _named(self, node: ast.NamedExpr, frame: Frame) -> Term:
        value = self.value(node.value, frame)
        self.bind(node.target, value, frame)
        return value

    def _attribute(self, node: ast.Attribute, frame: Frame) -> Term:
        of = self.value(node.value, frame)
        at = self.at(node)
        if isinstance(of, ImportedName) and (of.path, node.attr) == ("sys", "argv"):
            return Items([Constant(word, at) for word in ("ros2", "launch", self.source.path)], at)
        if isinstance(of, ImportedName):
            path = f"{of.path}.{node.attr}"
            return self.member(path) or ImportedName(path, at)
        if isinstance(of, (OwnClass, OwnObject)):
            return attribute_of(of, node.attr, at)
        if isinstance(of, Constant) and isinstance(of.value, str):
            if node.attr == "parent":
                return Constant(os.path.dirname(of.value), at)
            return Constant(os.path.basename(of.value), at) if node.attr == "name" else UnknownTerm(at)
        if node.attr == "package_path":
            return self._calls.package_of_builder(of, at) or Member(of, node.attr, at)
        if node.attr == "entities" and isinstance(of, Called):
            return entities_of(of, at)
        return Member(of, node.attr, at)

    def _subscript(self, node: ast.Subscript, frame: Frame) -> Term:
        of = self._calls.looked_into(self.value(node.value, frame))
        at = self.at(node)
        if isinstance(node.slice, ast.Slice):
            part = node.slice
            bounds = [self.value(bound, frame) if bound else None for bound in (part.lower, part.upper)]
            return UnknownTerm(at) if part.step else slice_of(of, bounds[0], bounds[1], at)
        key = self.value(node.slice, frame)
        if isinstance(of, ImportedName) and of.path == "os.environ":
            return self._calls.environment([key], at)
        if isinstance(of, Member) and of.name == "launch_configurations":
            return self._performed(Called("LaunchConfiguration", at, [key]), at)
        if isinstance(of, (Called, Member)):
            return Member(of, f"[{shown(key)}]", at)
        return item_of(of, key, at)

    # -- operators ---------------------------------------------------------------------------------------------------

    def _binary(self, node: ast.BinOp, frame: Frame) -> Term:
        left = self.value(node.left, frame)
        return binary(node.op, left, self.value(node.right, frame), self.at(node))

    def _bool(self, node: ast.BoolOp, frame: Frame) -> Term:
        decisive = isinstance(node.op, ast.Or)
        doubtful: list[Term] = []
        for part in node.values:
            value = self.value(part, frame)
            held = truth(value)
            if held is None:
                doubtful.append(value)
            elif held is decisive or part is node.values[-1]:
                return one_of([*doubtful, value], self.at(node)) if doubtful else value
        return one_of(doubtful, self.at(node)) if doubtful else UnknownTerm(self.at(node))

    def _unary(self, node: ast.UnaryOp, frame: Frame) -> Term:
        value, at = self.value(node.operand, frame), self.at(node)
        if isinstance(node.op, ast.Not):
            held = truth(value)
            return UnknownTerm(at) if held is None else Constant(not held, at)
        number = value.value if isinstance(value, Constant) else None
        if isinstance(node.op, ast.USub) and isinstance(number, (int, float)):
            return Constant(-number, at)
        return UnknownTerm(at)

    def _compare(self, node: ast.Compare, frame: Frame) -> Term:
        at = self.at(node)
        if len(node.ops) != 1:
            return UnknownTerm(at)
        left = self.value(node.left, frame)
        return compared(node.ops[0], left, self.value(node.comparators[0], frame), at)

    def _either(self, node: ast.IfExp, frame: Frame) -> Term:
        held = truth(self.value(node.test, frame))
        if held is not None:
            return self.value(node.body if held else node.orelse, frame)
        return one_of([self.value(node.body, frame), self.value(node.orelse, frame)], self.at(node))

    # -- comprehensions ----------------------------------------------------------------------------------------------

    def _comprehension(self, node: ast.ListComp | ast.GeneratorExp | ast.SetComp, frame: Frame) -> Term:
        items: list[Term] = []
        for sure in self._rounds(node.generators, frame):
            value = self.value(node.elt, frame)
            items.append(value if sure else perhaps(value))
        return Items(items[:MOST_ITEMS], self.at(node))

    def _dict_comprehension(self, node: ast.DictComp, frame: Frame) -> Term:
        table = Table(self.at(node))
        for sure in self._rounds(node.generators, frame):
            key, value = self.value(node.key, frame), self.value(node.value, frame)
            table.put(key, value if sure else perhaps(value))
        return table

    def _rounds(self, generators: Sequence[ast.comprehension], frame: Frame, *, sure: bool = True) -> Iterator[bool]:
        """Bind the names of each round of a comprehension, and yield whether the round is known to take place."""
        if not generators:
            yield sure
            return
        first, *rest = generators
        items = listed(self.value(first.iter, frame))
        if items is None:
            items = [Perhaps(UnknownTerm(self.at(first.iter)), self.at(first.iter))]
        for item in items:
            if not self.may_go_on():
                return
            self.bind(first.target, item.term if isinstance(item, Perhaps) else item, frame)
            tests = [truth(self.value(test, frame)) for test in first.ifs]
            if False not in tests:
                certain = sure and None not in tests and not isinstance(item, Perhaps)
                yield from self._rounds(rest, frame, sure=certain)

    # -- calls -------------------------------------------------------------------------------------------------------

    def _call(self, node: ast.Call, frame: Frame) -> Term:
        at = self.at(node)
        arguments = list(self._spread(node.args, frame))
        keywords: dict[str, Term] = {}
        for keyword in node.keywords:
            value = self.value(keyword.value, frame)
            if keyword.arg is not None:
                keywords[keyword.arg] = value
            elif isinstance(value, Table):
                keywords.update(value.entries)
        if isinstance(node.func, ast.Attribute):
            of = self.value(node.func.value, frame)
            if isinstance(of, ImportedName):
                path = f"{of.path}.{node.func.attr}"
                function = self.member(path) or ImportedName(path, at)
            elif isinstance(of, (OwnClass, OwnObject)):
                function = attribute_of(of, node.func.attr, at)
            else:
                return self._calls.method(of, node.func.attr, (arguments, keywords), at, frame)
        else:
            function = self.value(node.func, frame)
        if isinstance(function, Function):
            return function.call(arguments, keywords, None)
        if isinstance(function, OwnClass):
            return created(function, arguments, keywords, at)
        if isinstance(function, ImportedName):
            return self._calls.function(function.path, arguments, keywords, at)
        return UnknownTerm(at)

    def _performed(self, of: Term, at: Place) -> Term:
        if isinstance(of, Called) and of.short == "Command":
            return of  # what a command prints is known by the command only
        evaluation: Evaluation | None = self
        while evaluation is not None and evaluation.context is None:
            evaluation = evaluation.outer
        context = evaluation.context if evaluation else None
        return Constant(context.perform(of) if context else UNKNOWN, at)
