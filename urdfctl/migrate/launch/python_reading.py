"""Read a launch file in Python that a migration wrote, and nobody changed since: its actions."""

from __future__ import annotations

import ast
from collections.abc import Iterator

from urdfctl.migrate.edits.python_edits import called, keyword
from urdfctl.migrate.launch.actions import Action, ActionCondition, PartOfText, Text, joined, literal, plain
from urdfctl.migrate.launch.written import WrittenLaunch, as_python
from urdfctl.source.span import SourceText

_KINDS = {
    "DeclareLaunchArgument": "argument",
    "SetLaunchConfiguration": "let",
    "SetParameter": "set_parameter",
    "IncludeLaunchDescription": "include",
    "GroupAction": "group",
    "Node": "node",
    "ExecuteProcess": "process",
}


def read_python(source: SourceText) -> WrittenLaunch | None:
    """Return what a migration wrote into a launch file; None if it has any other form."""
    try:
        text = source.data.decode()
        tree = ast.parse(text)
        about = ast.get_docstring(tree) or ""
        head = text.splitlines()[1 : tree.body[1].lineno - 1] if len(tree.body) > 1 else []
        todos = tuple(line for line in head if line.startswith("#"))
        written = WrittenLaunch(about, todos, tuple(_PythonFile(text, tree).actions()))
    except (_OtherFormError, SyntaxError, ValueError, RecursionError):
        return None
    return written if as_python(written) == text else None


class _OtherFormError(Exception):
    """A part of the file has a form that no migration writes."""


class _PythonFile:
    """A launch file as text and syntax tree."""

    def __init__(self, text: str, tree: ast.Module) -> None:
        self._text, self._lines, self._tree = text, text.splitlines(), tree

    def actions(self) -> Iterator[Action]:
        """Yield the actions of the launch description, with the comments between them."""
        last = self._tree.body[-1] if self._tree.body else None
        returned = last.body[-1] if isinstance(last, ast.FunctionDef) else None
        call = returned.value if isinstance(returned, ast.Return) else None
        if not isinstance(call, ast.Call) or len(call.args) != 1:
            raise _OtherFormError
        yield from self._list(call.args[0])

    def _list(self, node: ast.expr) -> Iterator[Action]:
        line = node.lineno
        for item in _items(node):
            yield from self._comment(line, item.lineno - 1)
            line = item.end_lineno or item.lineno
            if not isinstance(item, ast.Call):
                raise _OtherFormError
            if called(item) != "PushRosNamespace":
                yield self._action(item)
        yield from self._comment(line, (node.end_lineno or line) - 1)

    def _comment(self, start: int, end: int) -> Iterator[Action]:
        """The comment in the lines between two lines, counted from 1."""
        lines = [line.strip() for line in self._lines[start:end]]
        if lines:
            yield Action("comment", "\n".join(line.removeprefix("#").removeprefix(" ") for line in lines))

    def _action(self, call: ast.Call) -> Action:
        kind = _KINDS.get(called(call))
        if kind is None:
            raise _OtherFormError
        given = {one.arg or "": one.value for one in call.keywords}
        condition = self._condition(given.pop("condition")) if "condition" in given else None
        if kind == "node":
            return self._node(given)._replace(condition=condition)
        if kind == "process":
            words = tuple(self._text_of(item) for item in _items(given.pop("cmd", None)))
            flags = tuple((name, self._flag(value)) for name, value in given.items())
            return Action(kind, words=words, flags=flags, condition=condition)
        if kind == "argument":
            value = self._text_of(given["default_value"]) if "default_value" in given else None
            about = plain(self._text_of(given["description"])) if "description" in given else ""
            return Action(kind, self._name(call), value, about=about, condition=condition)
        if kind == "set_parameter":
            return Action(kind, plain(self._text_of(given["name"])), self._typed(given["value"]), condition=condition)
        if kind == "let":
            return Action(kind, self._name(call), self._text_of(_nth(call, 1)), condition=condition)
        if kind == "include":
            source, arguments = _nth(call, 0), keyword(call, "launch_arguments")
            pairs = tuple(self._pairs(arguments.value)) if arguments else ()
            return Action(kind, value=self._text_of(_only(source)), pairs=pairs, condition=condition)
        first = next(iter(_items(_nth(call, 0))), None)
        is_pushed = isinstance(first, ast.Call) and called(first) == "PushRosNamespace"
        space = self._text_of(_only(first)) if first is not None and is_pushed else None
        return Action(kind, value=space, inner=tuple(self._list(_nth(call, 0))), condition=condition)

    def _node(self, given: dict[str, ast.expr]) -> Action:
        texts = {name: self._text_of(given.pop(name, None)) for name in ("package", "executable", "name", "namespace")}
        words = tuple(self._text_of(item) for item in _items(given.pop("arguments", None)))
        remaps = tuple(self._remap(item) for item in _items(given.pop("remappings", None)))
        files: list[Text] = []
        pairs: list[tuple[str, Text]] = []
        description: Text = ()
        for item in _items(given.pop("parameters", None)):
            if not isinstance(item, ast.Dict):
                files.append(self._text_of(_only(item) if isinstance(item, ast.Call) else item))
                continue
            for key, value in zip(item.keys, item.values, strict=True):
                is_typed = isinstance(value, ast.Call) and called(value) == "ParameterValue"
                if is_typed and plain(self._text_of(key)) == "robot_description":
                    description = self._text_of(_only(_nth(value, 0)))
                elif is_typed:
                    name = plain(self._text_of(key))
                    pairs.append((name, (PartOfText("double", ""), *self._text_of(_only(value)))))
                else:
                    pairs.append((plain(self._text_of(key)), self._typed(value)))
        return Action(
            "node",
            plain(texts["executable"]),
            value=texts["namespace"] or None,
            package=plain(texts["package"]),
            node_name=texts["name"],
            words=words,
            pairs=tuple(pairs),
            files=tuple(files),
            description=description,
            remaps=remaps,
            flags=tuple((name, self._flag(value)) for name, value in given.items()),
        )

    def _remap(self, item: ast.expr) -> tuple[Text, Text]:
        if not isinstance(item, ast.Tuple) or len(item.elts) != 2:  # noqa: PLR2004 (a pair)
            raise _OtherFormError
        return self._text_of(item.elts[0]), self._text_of(item.elts[1])

    def _pairs(self, node: ast.expr) -> Iterator[tuple[str, Text]]:
        """The arguments of an include: {...}.items()."""
        known = node.func.value if isinstance(node, ast.Call) and isinstance(node.func, ast.Attribute) else None
        if not isinstance(known, ast.Dict):
            raise _OtherFormError
        for key, value in zip(known.keys, known.values, strict=True):
            yield plain(self._text_of(key)), self._text_of(value)

    def _condition(self, node: ast.expr) -> ActionCondition:
        if not isinstance(node, ast.Call):
            raise _OtherFormError
        return ActionCondition(self._text_of(_only(node)), called(node) == "UnlessCondition")

    def _flag(self, node: ast.expr) -> str:
        is_text = isinstance(node, ast.Constant) and isinstance(node.value, str)
        return plain(self._text_of(node)) if is_text else self._written(node)

    def _typed(self, node: ast.expr) -> Text:
        """The value of a parameter: a text with substitutions, or a number or truth value as it is written."""
        is_text = isinstance(node, (ast.Call, ast.List)) or (
            isinstance(node, ast.Constant) and isinstance(node.value, str)
        )
        return self._text_of(node) if is_text else literal(self._written(node))

    def _written(self, node: ast.expr) -> str:
        return ast.get_source_segment(self._text, node) or ""

    def _name(self, call: ast.Call) -> str:
        return plain(self._text_of(_nth(call, 0)))

    def _text_of(self, node: ast.expr | None) -> Text:
        """A text with substitutions; empty if there is none."""
        if node is None:
            return ()
        if isinstance(node, ast.Constant) and isinstance(node.value, str):
            return literal(node.value)
        if isinstance(node, ast.List):
            return joined(*map(self._text_of, node.elts))
        if not isinstance(node, ast.Call):
            raise _OtherFormError
        kinds = {"LaunchConfiguration": "arg", "FindPackageShare": "find", "EnvironmentVariable": "env"}
        name = called(node)
        if name == "ThisLaunchFileDir":
            return (PartOfText("dirname", ""),)
        if name == "PythonExpression":
            return (PartOfText("written", self._written(node)),)
        if name not in kinds:
            raise _OtherFormError
        default = keyword(node, "default_value")
        about = plain(self._text_of(default.value)) if default else None
        return (PartOfText(kinds[name], self._name(node), about),)


def _items(node: ast.expr | None) -> list[ast.expr]:
    if node is not None and not isinstance(node, ast.List):
        raise _OtherFormError
    return node.elts if node is not None else []


def _nth(call: ast.expr, index: int) -> ast.expr:
    if not isinstance(call, ast.Call) or index >= len(call.args):
        raise _OtherFormError
    return call.args[index]


def _only(call: ast.expr) -> ast.expr:
    return _nth(call, 0)
