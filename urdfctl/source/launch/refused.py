"""Calls in a launch file in Python that launch certainly refuses, or that lose what they get."""

from __future__ import annotations

import ast
from collections.abc import Callable, Iterator, Sequence

from urdfctl.names import is_slip
from urdfctl.source.launch.unbound import entry_function, evaluated

Refusal = tuple[ast.expr | ast.stmt, str]
_SUBSTITUTIONS = frozenset(
    "Command EnvironmentVariable FindExecutable FindPackagePrefix FindPackageShare LaunchConfiguration "
    "PathJoinSubstitution PythonExpression TextSubstitution".split()
)
_OF_PACKAGE = frozenset({"FindPackageShare", "get_package_share_directory", "get_package_share_path"})
_PACKAGES = ("launch", "launch_ros", "ament_index_python", "os")
_PLAIN = (bool, int, float)


def refusal(tree: ast.Module, nodes: Sequence[ast.AST], entry: str) -> Refusal | None:
    """Return the first part of a launch file that launch certainly refuses, and what is wrong; None if there is none.

    nodes: all nodes of the tree.
    entry: the name of the function that is called.
    """
    names = _Bindings(nodes)
    for part in evaluated(tree, entry):
        check = _CHECKS.get(names.called(part)) if isinstance(part, ast.Call) else None
        found = check(part, names) if check is not None and isinstance(part, ast.Call) else _sum(part, names)
        if found is not None:
            return found
    return _of_entry(tree, entry)


def misnamed_entry(tree: ast.Module, entry: str) -> Refusal | None:
    """Return the function that is the entry with a slip, or with more behind it, of a launch file that has none.

    None if there is none, or if the entry may be among what is imported by `*`.
    """
    functions = [one for one in tree.body if isinstance(one, ast.FunctionDef)]
    slip = next((one for one in functions if is_slip(one.name, entry) or one.name.startswith(f"{entry}_")), None)
    imports = (one for one in tree.body if isinstance(one, ast.ImportFrom))
    if slip is None or any(name.name == "*" for each in imports for name in each.names):
        return None
    return slip.body[0], f"launch looks for '{entry}', but the function is '{slip.name}'"


class _Bindings:
    """What the names of a launch file stand for, as far as that is certain."""

    def __init__(self, nodes: Sequence[ast.AST]) -> None:
        self._imported: dict[str, str] = {}
        self._values: dict[str, list[ast.expr]] = {}
        hidden: set[str] = set()
        for node in nodes:
            if isinstance(node, (ast.Import, ast.ImportFrom)):
                self._import(node)
            elif isinstance(node, (ast.FunctionDef, ast.ClassDef)):
                hidden.add(node.name)
            elif isinstance(node, ast.Assign):
                for target in node.targets:
                    if isinstance(target, ast.Name):
                        self._values.setdefault(target.id, []).append(node.value)
        for name in hidden | self._values.keys():
            self._imported.pop(name, None)

    def _import(self, node: ast.Import | ast.ImportFrom) -> None:
        module = "" if isinstance(node, ast.Import) else f"{node.module or ''}."
        for alias in node.names:
            full = module + alias.name
            if full.partition(".")[0] not in _PACKAGES:
                continue
            if alias.asname or module:
                self._imported[alias.asname or alias.name] = full
            else:
                root = alias.name.partition(".")[0]
                self._imported[root] = root

    def called(self, call: ast.expr) -> str:
        """Return the last part of the name of what is called, `os.path.join` whole; empty if it is not of launch."""
        if not isinstance(call, ast.Call):
            return ""
        parts: list[str] = []
        function: ast.expr = call.func
        while isinstance(function, ast.Attribute):
            parts.append(function.attr)
            function = function.value
        known = self._imported.get(function.id) if isinstance(function, ast.Name) else None
        if known is None:
            return ""
        full = ".".join((known, *reversed(parts)))
        return full if full == "os.path.join" else full.rpartition(".")[2]

    def makes(self, value: ast.expr, names: frozenset[str]) -> bool:
        """Return whether a value is the result of one of some calls, directly or by the only assignment to its name."""
        if isinstance(value, ast.Name):
            values = self._values.get(value.id, [])
            return len(values) == 1 and self.called(values[0]) in names
        return self.called(value) in names


def _of_entry(tree: ast.Module, entry: str) -> Refusal | None:
    function = entry_function(tree, entry)
    if function is None or any(_gives(node) for node in _own(function)):
        return None
    return function.body[-1], f"{entry}() returns nothing; add 'return' before the launch description"


def _own(function: ast.FunctionDef) -> Iterator[ast.AST]:
    """Yield the nodes of a function that are not in a function inside it."""
    pending: list[ast.AST] = list(function.body)
    while pending:
        node = pending.pop()
        yield node
        if not isinstance(node, (ast.FunctionDef, ast.AsyncFunctionDef, ast.ClassDef, ast.Lambda)):
            pending.extend(ast.iter_child_nodes(node))


def _gives(node: ast.AST) -> bool:
    is_return = isinstance(node, ast.Return) and node.value is not None
    return is_return or isinstance(node, (ast.Yield, ast.YieldFrom, ast.Raise))


def _given(call: ast.Call, name: str) -> ast.expr | None:
    return next((keyword.value for keyword in call.keywords if keyword.arg == name), None)


def _is_text(value: ast.expr | None) -> bool:
    return isinstance(value, ast.JoinedStr) or (isinstance(value, ast.Constant) and isinstance(value.value, str))


def _description(call: ast.Call, _: _Bindings) -> Refusal | None:
    if len(call.args) > 1 and not any(isinstance(one, ast.Starred) for one in call.args):
        return call.func, "LaunchDescription takes one list; put the actions between [ and ]"
    return None


def _node(call: ast.Call, _: _Bindings) -> Refusal | None:
    parameters, arguments = _given(call, "parameters"), _given(call, "arguments")
    if parameters is not None and (isinstance(parameters, ast.Dict) or _is_text(parameters)):
        return parameters, "'parameters' must be a list; put it between [ and ]"
    if arguments is not None and _is_text(arguments):
        return arguments, "'arguments' must be a list; of a text, the program gets each letter as an argument"
    named = {keyword.arg for keyword in call.keywords}
    if not call.args and not named & {None, "executable", "node_executable"}:
        return call.func, "Node has no 'executable', which it requires"
    return None


def _include(call: ast.Call, _: _Bindings) -> Refusal | None:
    given = _given(call, "launch_arguments")
    if isinstance(given, ast.Dict) and given.keys and not any(key is None for key in given.keys):
        return given, "'launch_arguments' must be pairs; add '.items()' after the }"
    pairs = given.func.value if isinstance(given, ast.Call) and isinstance(given.func, ast.Attribute) else None
    values = pairs.values if isinstance(pairs, ast.Dict) else ()
    wrong = next((one for one in values if isinstance(one, ast.Constant) and isinstance(one.value, _PLAIN)), None)
    return (wrong, f"a launch argument must be a text: write '{str(wrong.value).lower()}' in quotes") if wrong else None


def _join(call: ast.Call, names: _Bindings) -> Refusal | None:
    wrong = next((one for one in call.args if names.makes(one, _SUBSTITUTIONS)), None)
    if wrong is not None:
        return wrong, "os.path.join() takes no substitution of launch; use PathJoinSubstitution([...])"
    return _discarded(call.args, names)


def _path_join(call: ast.Call, names: _Bindings) -> Refusal | None:
    parts = call.args[0] if len(call.args) == 1 else None
    return _discarded(parts.elts, names) if isinstance(parts, (ast.List, ast.Tuple)) else None


def _sum(part: ast.expr, names: _Bindings) -> Refusal | None:
    if not isinstance(part, ast.BinOp) or not isinstance(part.op, ast.Add):
        return None
    if any(names.makes(one, _SUBSTITUTIONS) for one in (part.left, part.right)) and (
        _is_text(part.left) or _is_text(part.right)
    ):
        return part, "a substitution of launch and a text cannot be added; use PathJoinSubstitution([...]) or a list"
    return None


def _discarded(parts: list[ast.expr], names: _Bindings) -> Refusal | None:
    """Return a later part of a path that begins with a slash, after the folder of a package."""
    if not parts or not names.makes(parts[0], _OF_PACKAGE):
        return None
    for part in parts[1:]:
        if isinstance(part, ast.Constant) and isinstance(part.value, str) and part.value.startswith("/"):
            return part, f"'{part.value}' begins with '/', so the package before it is lost; write '{part.value[1:]}'"
    return None


_CHECKS: dict[str, Callable[[ast.Call, _Bindings], Refusal | None]] = {
    "LaunchDescription": _description,
    "Node": _node,
    "IncludeLaunchDescription": _include,
    "os.path.join": _join,
    "PathJoinSubstitution": _path_join,
}
