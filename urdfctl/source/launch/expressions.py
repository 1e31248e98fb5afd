"""What an expression of a launch file in Python stands for."""

from __future__ import annotations

import ast
import os
from collections.abc import Callable, Iterator, Mapping, Sequence

from urdfctl.hints import TYPE_CHECKING, Any
from urdfctl.source.launch.operations import binary, compared, item_of, method, shown, text_at, truth
from urdfctl.source.launch.terms import (
    MOST_ITEMS,
    Called,
    Constant,
    Context,
    Function,
    Items,
    Member,
    Missing,
    Name,
    OneOf,
    Perhaps,
    Table,
    Term,
    is_same,
    known_text,
    one_of,
    outside,
    perhaps,
)
from urdfctl.source.opaque import UNKNOWN
from urdfctl.source.span import Place

if TYPE_CHECKING:
    from urdfctl.source.launch.python import Run, Surroundings, _Frame

_SHARE = frozenset({"get_package_share_directory", "get_package_share_path"})
_PATHS = frozenset({"Path", "PosixPath", "str", "fspath", "abspath", "realpath", "expanduser", "normpath"})
_ENVIRONMENT = frozenset({"os.getenv", "os.environ.get"})
_GROWING = frozenset({"add_action", "add_entity"})
_LISTS = frozenset({"list", "tuple", "sorted"})


class Evaluation:
    """Evaluates expressions in a frame; `frame` is that of the function that is being followed."""

    def __init__(self, run: Run, surroundings: Surroundings) -> None:
        self.run = run
        self.surroundings = surroundings
        self.frame: _Frame | None = None
        self._kinds: dict[type[ast.expr], Callable[[Any, _Frame], Term]] = {
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

    def of(self, node: ast.expr, frame: _Frame) -> Term:
        """What an expression stands for."""
        kind = self._kinds.get(type(node))
        return kind(node, frame) if kind else Missing(self.run.at(node))

    @staticmethod
    def listed(term: Term) -> list[Term] | None:
        """What a loop over a term goes through; None where that is not known."""
        if isinstance(term, Items):
            return list(term.values)
        if isinstance(term, Table):
            keys: list[Term] = [Constant(key, term.keys[key]) for key in term.entries]
            return keys if term.whole else [*keys, Perhaps(Missing(term.at), term.at)]
        return None

    # -- literals ----------------------------------------------------------------------------------------------------

    def _constant(self, node: ast.Constant, _: _Frame) -> Term:
        at = self.run.at(node)
        value = node.value
        if isinstance(value, str):
            return text_at(value, _inside(at, value))
        return Constant(value, at) if value is None or isinstance(value, (bool, int, float)) else Missing(at)

    def _list(self, node: ast.List | ast.Tuple | ast.Set, frame: _Frame) -> Term:
        return Items(list(self._spread(node.elts, frame)), self.run.at(node))

    def _spread(self, nodes: Sequence[ast.expr], frame: _Frame) -> Iterator[Term]:
        for node in nodes[:MOST_ITEMS]:
            if isinstance(node, ast.Starred):
                value = self.run.value(node.value, frame)
                listed = self.listed(value)
                yield from listed if listed is not None else [Perhaps(Missing(value.at), value.at)]
            else:
                yield self.run.value(node, frame)

    def _dict(self, node: ast.Dict, frame: _Frame) -> Term:
        table = Table(self.run.at(node))
        for key, item in zip(node.keys, node.values, strict=True):
            value = self.run.value(item, frame)
            if key is not None:
                table.put(self.run.value(key, frame), value)
            elif isinstance(value, Table):
                table.take(value)
            else:
                table.whole = False
        return table

    def _joined(self, node: ast.JoinedStr, frame: _Frame) -> Term:
        texts = []
        for part in node.values:
            if isinstance(part, ast.FormattedValue):
                plain = part.format_spec is None and part.conversion in {-1, ord("s")}
                texts.append(shown(self.run.value(part.value, frame)) if plain else UNKNOWN)
            elif isinstance(part, ast.Constant):
                texts.append(str(part.value))
        return text_at("".join(texts), self.run.at(node))

    def _lambda(self, node: ast.Lambda, frame: _Frame) -> Term:
        return self.run.function("lambda", node, node.args, frame)

    # -- names -------------------------------------------------------------------------------------------------------

    def _name(self, node: ast.Name, frame: _Frame) -> Term:
        at = self.run.at(node)
        if node.id == "__file__":
            return Constant(os.path.abspath(self.run.source.path), at)
        found = frame.find(node.id)
        return Name(node.id, at) if found is None else found

    def _named(self, node: ast.NamedExpr, frame: _Frame) -> Term:
        value = self.run.value(node.value, frame)
        self.run.bind(node.target, value, frame)
        return value

    def _attribute(self, node: ast.Attribute, frame: _Frame) -> Term:
        of = self.run.value(node.value, frame)
        at = self.run.at(node)
        if isinstance(of, Name):
            return Name(f"{of.path}.{node.attr}", at)
        if isinstance(of, Constant) and isinstance(of.value, str):
            if node.attr == "parent":
                return Constant(os.path.dirname(of.value), at)
            return Constant(os.path.basename(of.value), at) if node.attr == "name" else Missing(at)
        return Member(of, node.attr, at)

    def _subscript(self, node: ast.Subscript, frame: _Frame) -> Term:
        of = self.run.value(node.value, frame)
        at = self.run.at(node)
        if isinstance(node.slice, ast.Slice):
            return Missing(at)
        key = self.run.value(node.slice, frame)
        if isinstance(of, Name) and of.path == "os.environ":
            return self._environment([key], at)
        if isinstance(of, Member) and of.name == "launch_configurations":
            return self._performed(Called("LaunchConfiguration", at, [key]), at)
        if isinstance(of, (Called, Member)):
            return Member(of, f"[{shown(key)}]", at)
        return item_of(of, key, at)

    # -- operators ---------------------------------------------------------------------------------------------------

    def _binary(self, node: ast.BinOp, frame: _Frame) -> Term:
        left = self.run.value(node.left, frame)
        return binary(node.op, left, self.run.value(node.right, frame), self.run.at(node))

    def _bool(self, node: ast.BoolOp, frame: _Frame) -> Term:
        decisive = isinstance(node.op, ast.Or)
        doubtful: list[Term] = []
        for part in node.values:
            value = self.run.value(part, frame)
            held = truth(value)
            if held is None:
                doubtful.append(value)
            elif held is decisive or part is node.values[-1]:
                return one_of([*doubtful, value], self.run.at(node)) if doubtful else value
        return one_of(doubtful, self.run.at(node)) if doubtful else Missing(self.run.at(node))

    def _unary(self, node: ast.UnaryOp, frame: _Frame) -> Term:
        value, at = self.run.value(node.operand, frame), self.run.at(node)
        if isinstance(node.op, ast.Not):
            held = truth(value)
            return Missing(at) if held is None else Constant(not held, at)
        number = value.value if isinstance(value, Constant) else None
        if isinstance(node.op, ast.USub) and isinstance(number, (int, float)):
            return Constant(-number, at)
        return Missing(at)

    def _compare(self, node: ast.Compare, frame: _Frame) -> Term:
        at = self.run.at(node)
        if len(node.ops) != 1:
            return Missing(at)
        left = self.run.value(node.left, frame)
        return compared(node.ops[0], left, self.run.value(node.comparators[0], frame), at)

    def _either(self, node: ast.IfExp, frame: _Frame) -> Term:
        held = truth(self.run.value(node.test, frame))
        if held is not None:
            return self.run.value(node.body if held else node.orelse, frame)
        return one_of([self.run.value(node.body, frame), self.run.value(node.orelse, frame)], self.run.at(node))

    # -- comprehensions ----------------------------------------------------------------------------------------------

    def _comprehension(self, node: ast.ListComp | ast.GeneratorExp | ast.SetComp, frame: _Frame) -> Term:
        made: list[Term] = []
        for sure in self._rounds(node.generators, frame):
            value = self.run.value(node.elt, frame)
            made.append(value if sure else perhaps(value))
        return Items(made[:MOST_ITEMS], self.run.at(node))

    def _dict_comprehension(self, node: ast.DictComp, frame: _Frame) -> Term:
        table = Table(self.run.at(node))
        for sure in self._rounds(node.generators, frame):
            key, value = self.run.value(node.key, frame), self.run.value(node.value, frame)
            table.put(key, value if sure else perhaps(value))
        return table

    def _rounds(self, generators: Sequence[ast.comprehension], frame: _Frame, *, sure: bool = True) -> Iterator[bool]:
        """Bind the names of each round, and tell whether it surely takes place."""
        if not generators:
            yield sure
            return
        first, *rest = generators
        items = self.listed(self.run.value(first.iter, frame))
        if items is None:
            items = [Perhaps(Missing(self.run.at(first.iter)), self.run.at(first.iter))]
        for item in items:
            if not self.run.may_go_on():
                return
            self.run.bind(first.target, item.term if isinstance(item, Perhaps) else item, frame)
            tests = [truth(self.run.value(test, frame)) for test in first.ifs]
            if False not in tests:
                certain = sure and None not in tests and not isinstance(item, Perhaps)
                yield from self._rounds(rest, frame, sure=certain)

    # -- calls -------------------------------------------------------------------------------------------------------

    def _call(self, node: ast.Call, frame: _Frame) -> Term:
        at = self.run.at(node)
        arguments = list(self._spread(node.args, frame))
        keywords: dict[str, Term] = {}
        for keyword in node.keywords:
            value = self.run.value(keyword.value, frame)
            if keyword.arg is not None:
                keywords[keyword.arg] = value
            elif isinstance(value, Table):
                keywords.update(value.entries)
        if isinstance(node.func, ast.Attribute):
            of = self.run.value(node.func.value, frame)
            if not isinstance(of, Name):
                return self._method(of, node.func.attr, (arguments, keywords), at, frame)
            return self._named_call(f"{of.path}.{node.func.attr}", arguments, keywords, at)
        function = self.run.value(node.func, frame)
        if isinstance(function, Function):
            return function.call(arguments, keywords, None)
        if isinstance(function, Name):
            return self._named_call(function.path, arguments, keywords, at)
        return Missing(at)

    def _named_call(self, name: str, arguments: list[Term], keywords: Mapping[str, Term], at: Place) -> Term:
        """A call of something imported, or built in."""
        short = name.rpartition(".")[2]
        first = arguments[0] if arguments else None
        if short in _SHARE and first is None:
            first = keywords.get("package_name")
        if short in _SHARE and first is not None:
            package = known_text(first)
            found = self.surroundings.find(package, first.at) if package else None
            return Constant(found or (outside(package) if package else UNKNOWN), at)
        if name == "os.path.join":
            return text_at(os.path.join("", *map(shown, arguments)), at)
        if short == "dirname" and isinstance(first, Constant) and isinstance(first.value, str):
            return Constant(os.path.dirname(first.value), at)
        if short in _PATHS and isinstance(first, Constant):
            return text_at(os.path.join(*map(shown, arguments)), at)
        if short in _LISTS and len(arguments) <= 1:
            listed = self.listed(first) if first is not None else []
            return Missing(at) if listed is None else Items(listed, at)
        if name in _ENVIRONMENT:
            return self._environment(arguments, at)
        if short == "process_doc" and isinstance(first, Called):
            first.added.extend(one for one in (keywords.get("mappings"), *arguments[1:]) if one)
        if name == "dict":
            table = Table(at)
            for key, value in keywords.items():
                table.put(Constant(key, value.at), value)
            return table
        return Called(name, at, arguments, keywords)

    def _environment(self, arguments: Sequence[Term], at: Place) -> Term:
        name = known_text(arguments[0]) if arguments else None
        if name is not None and name in self.surroundings.environ:
            return Constant(self.surroundings.environ[name], at)
        return arguments[1] if name is not None and len(arguments) > 1 else Constant(UNKNOWN, at)

    def _method(
        self, of: Term, name: str, given: tuple[list[Term], Mapping[str, Term]], at: Place, frame: _Frame
    ) -> Term:
        arguments, keywords = given
        if name == "perform":
            return self._performed(of, at)
        if name == "perform_substitution" and arguments:
            return self._performed(arguments[0], at)
        if isinstance(of, Items):
            return self._of_list(of, name, arguments, at, frame)
        if isinstance(of, Member) and of.name == "launch_configurations" and name == "get" and arguments:
            return self._performed(Called("LaunchConfiguration", at, arguments), at)
        if name in _GROWING and isinstance(of, (Called, OneOf)) and arguments:
            for one in of.options if isinstance(of, OneOf) else (of,):
                if isinstance(one, Called):
                    self.run.add(one, arguments[0], frame)
            return Constant(None, at)
        found = method(of, name, arguments, keywords, at)
        if found is not None:
            return found
        called = Called(name, at, arguments, keywords)
        called.of = of
        return called

    def _of_list(self, of: Items, name: str, arguments: Sequence[Term], at: Place, frame: _Frame) -> Term:
        if name in {"append", "extend", "insert"} and arguments:
            if name == "extend":
                self.run.extend(of, arguments[0], frame)
            else:
                self.run.append(of, arguments[-1], frame)
            return Constant(None, at)
        if name == "copy":
            return Items(of.values, at)
        if name == "remove" and arguments:
            self._removed(of, arguments[0], frame)
        elif name in {"pop", "clear"}:
            of.values[:] = [perhaps(value) for value in of.values]
        return Missing(at)

    @staticmethod
    def _removed(of: Items, item: Term, frame: _Frame) -> None:
        """Take an item out of a list; where it is not known which, each may be gone."""
        place = next((index for index, value in enumerate(of.values) if is_same(value, item)), None)
        if place is None:
            of.values[:] = [perhaps(value) for value in of.values]
        elif frame.sure:
            del of.values[place]
        else:
            of.values[place] = perhaps(of.values[place])

    def _performed(self, of: Term, at: Place) -> Term:
        context: Context | None = self.run.context
        return Constant(context.perform(of) if context else UNKNOWN, at)


def _inside(at: Place, text: str) -> Place:
    """Where a text stands between its quotes; the whole literal where it is not written so."""
    span = at.span
    literal = span.source.data[span.start : span.end]
    if len(literal) > 1 and literal[:1] in {b"'", b'"'} and literal[1:-1] == text.encode("utf-8", "replace"):
        return Place(span.source, span.start + 1, end=span.end - 1)
    return at
