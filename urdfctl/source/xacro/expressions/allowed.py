"""An allow-list for the syntax trees of expressions.

xacro itself checks only the top-level names; a lambda, a comprehension, `$(eval ...)` or `str.format` bypasses that.
Here, attributes that begin with an underscore, or lead from a value to the interpreter, are not allowed.
"""

from __future__ import annotations

import _ast as ast  # faster to import than ast
from collections.abc import Iterator

from urdfctl.source.xacro.expressions.guards import MOST_PLACES, ForbiddenExpression, check_places

_ALLOWED: tuple[type[ast.AST], ...] = (
    ast.Expression, ast.BoolOp, ast.BinOp, ast.UnaryOp, ast.IfExp, ast.Compare, ast.Call, ast.keyword, ast.Starred,
    ast.Constant, ast.Dict, ast.Set, ast.List, ast.Tuple, ast.Subscript, ast.Slice, ast.Name, ast.Attribute,
    ast.ListComp, ast.SetComp, ast.DictComp, ast.GeneratorExp, ast.comprehension, ast.Lambda, ast.arguments, ast.arg,
    ast.JoinedStr, ast.FormattedValue, ast.expr_context, ast.boolop, ast.operator, ast.unaryop, ast.cmpop,
)  # fmt: skip
_FORBIDDEN_ATTRIBUTES = frozenset(
    (
        "gi_frame gi_code gi_yieldfrom cr_frame cr_code cr_await cr_origin ag_frame ag_code ag_await f_back "
        "f_globals f_locals f_builtins f_code f_trace f_generator tb_frame tb_next tb_lasti func_globals func_code "
        "co_code co_consts co_names mro format_map with_traceback to_bytes"
    ).split()
)
_GROWING = frozenset("append extend insert".split())
_PADDING = frozenset("ljust rjust center zfill expandtabs".split())
_ONLY_CALLED = frozenset("append ljust rjust zfill expandtabs format".split())
_REPEATING = (ast.ListComp, ast.SetComp, ast.DictComp, ast.GeneratorExp, ast.Lambda)


def check(node: ast.AST, *, called: bool = False) -> None:
    """Raise ForbiddenExpression if a node is not allowed, whatever is below it.

    called: whether the node is what a call calls.
    """
    if not isinstance(node, _ALLOWED):
        raise ForbiddenExpression(f"{type(node).__name__} is not allowed in an expression")
    if isinstance(node, ast.Attribute):
        _check_attribute(node)
        if node.attr in _ONLY_CALLED and not called:
            raise ForbiddenExpression(f"'{node.attr}' without a call is not allowed in an expression")
    elif isinstance(node, ast.Name):
        _check_name(node.id)
    elif isinstance(node, ast.arg):
        _check_name(node.arg)
    elif isinstance(node, ast.Constant) and isinstance(node.value, str) and _is_dunder(node.value):
        raise ForbiddenExpression(f"the string '{node.value}' is not allowed in an expression")
    elif isinstance(node, ast.Call) and isinstance(node.func, ast.Attribute):
        _check_method(node, node.func)
    elif isinstance(node, ast.FormattedValue) and node.format_spec is not None:
        _check_format_spec(node.format_spec)
    elif isinstance(node, _REPEATING):
        _check_repeated(node)


def _check_name(name: str) -> None:
    if name.startswith("__"):
        raise ForbiddenExpression(f"the name '{name}' is not allowed in an expression")


def _is_dunder(text: str) -> bool:
    return text.startswith("__") and text.endswith("__") and bool(text.strip("_"))


def _check_attribute(node: ast.Attribute) -> None:
    name = node.attr
    if name.startswith("_") or name in _FORBIDDEN_ATTRIBUTES:
        raise ForbiddenExpression(f"the attribute '{name}' is not allowed in an expression")
    if name == "format":
        _check_template(node.value)


def _check_template(template: ast.expr) -> None:
    """Reject a `format` whose text is not a literal: the text can name attributes and items."""
    import string

    if not isinstance(template, ast.Constant) or not isinstance(template.value, str):
        raise ForbiddenExpression("'format' on a computed string is not allowed in an expression")
    try:
        fields = list(string.Formatter().parse(template.value))
    except ValueError:
        return  # the call itself reports the error
    for _, name, spec, _ in fields:
        if name and ("." in name or "[" in name):
            raise ForbiddenExpression(f"the format field '{name}' is not allowed in an expression")
        check_places(spec or "")
        if "{" in (spec or ""):
            raise ForbiddenExpression("a computed format width is not allowed in an expression")


def _check_format_spec(spec: ast.expr) -> None:
    for part in _walk(spec):
        if isinstance(part, ast.FormattedValue):
            raise ForbiddenExpression("a computed format width is not allowed in an expression")
        if isinstance(part, ast.Constant):
            check_places(str(part.value))


def _check_method(call: ast.Call, method: ast.Attribute) -> None:
    if method.attr not in _PADDING:
        return
    widths = [argument.value for argument in call.args if isinstance(argument, ast.Constant)]
    if len(widths) < len(call.args) or call.keywords or any(isinstance(w, int) and w > MOST_PLACES for w in widths):
        raise ForbiddenExpression(f"'{method.attr}' with a computed or large width is not allowed in an expression")


def _check_repeated(repeated: ast.AST) -> None:
    """Reject methods that let a list grow in a comprehension or lambda: the loop could be endless."""
    for node in _attributes(repeated):
        if node.attr in _GROWING:
            raise ForbiddenExpression(f"'{node.attr}' in a comprehension or lambda is not allowed in an expression")


def _attributes(tree: ast.AST) -> Iterator[ast.Attribute]:
    for node in _walk(tree):
        if isinstance(node, ast.Attribute):
            yield node


def _walk(tree: ast.AST) -> Iterator[ast.AST]:
    """Yield a node and all nodes below it, like ast.walk."""
    pending = [tree]
    for node in pending:
        for name in node._fields:
            value = getattr(node, name, None)
            pending += [part for part in (value if isinstance(value, list) else [value]) if isinstance(part, ast.AST)]
        yield node
