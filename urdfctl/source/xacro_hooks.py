"""Replaces helpers of xacro for speed, for safety, and for packages without ROS; what they give is the same."""

from __future__ import annotations

import keyword
import os
import re
from collections.abc import Callable
from functools import lru_cache, partial, reduce
from operator import getitem
from types import FunctionType, ModuleType, SimpleNamespace

from urdfctl.hints import TYPE_CHECKING, Any
from urdfctl.source import engine, guards
from urdfctl.source.expressions import OPERATORS, compile_checked, plain_path
from urdfctl.source.files import Files
from urdfctl.source.macro_params import split_quickly
from urdfctl.source.yaml_size import check_size

if TYPE_CHECKING:
    from urdfctl.source.xacro import Expander

_PURE = (
    "abs all any bool complex dict divmod enumerate filter float frozenset hash int isinstance issubclass "
    "len list map max min ord range repr reversed round set slice sorted str sum tuple zip"
).split()


class MissingVariable(Exception):
    """`$(env X)` of a variable that is not set, or that a linter does not pass on."""


def install(expander: Expander) -> None:
    """Put the replacements into the expander's private xacro."""
    module: Any = expander.module
    module.deepcopy = list
    module.is_valid_name = _is_valid_name
    module.load_yaml = _yaml_loader(expander)
    module.eval_extension = _extension(expander, module.eval_extension)
    module.print_location.__name__ = "print_location"  # it is exposed under its name
    _heal_recursion(module)
    if expander.trust:
        module._global_symbols = module.create_global_symbols()
        return
    lex = _lexer(module)

    def eval_text(text: Any, symbols: Any) -> Any:
        if not text:
            return ""
        if "$" not in text:
            return text
        return _evaluated(module, lex(text), symbols)

    module.eval_text = eval_text
    module.safe_eval = _safe_eval
    module.parse_macro_arg = split_quickly(module.parse_macro_arg)
    module.tokenize = guards.tokenized(module.tokenize)
    module.glob = SimpleNamespace(glob=partial(_glob, expander.files))
    module._global_symbols = _harmless_symbols(module)


def _harmless_symbols(module: Any) -> Any:
    """What xacro exposes to expressions, made from guarded builtins and a guarded math."""
    plain = module.__dict__["__builtins__"], module.math
    module.__dict__["__builtins__"], module.math = guards.harmless_builtins(), guards.harmless_math()
    try:
        return module.create_global_symbols()
    finally:
        module.__dict__["__builtins__"], module.math = plain


def _glob(files: Files, pattern: str) -> list[str]:
    """The files that a pattern of an include matches, where they may be read: elsewhere nothing is even looked for."""
    fixed = re.split(r"[*?[]", pattern, maxsplit=1)[0]
    if not files.may_read(os.path.dirname(fixed)):
        return []
    from glob import glob

    return glob(pattern)


def _lexer(module: Any) -> Callable[[str], list[tuple[int, str]]]:
    """Xacro's own lexer, remembering what it has cut, and cutting without a copy of the rest for each piece."""
    kinds = [re.compile(pattern.pattern.removeprefix("^")) for pattern in module.LEXER.res]

    @lru_cache(4096)
    def lex(text: str) -> list[tuple[int, str]]:
        pieces = []
        position = 0
        while position < len(text):
            for kind, pattern in enumerate(kinds):
                found = pattern.match(text, position)
                if found:
                    pieces.append((kind, found[0]))
                    position = found.end()
                    break
            else:
                raise module.XacroException("invalid expression: " + text[position:])
        return pieces

    return lex


def _evaluated(module: Any, pieces: list[tuple[int, str]], symbols: Any) -> Any:
    """What xacro's eval_text gives for the pieces of a text: a typed value for a single one, else a text."""
    lexer = module.LEXER
    results: list[Any] = []
    for kind, text in pieces:
        if kind == lexer.EXPR:
            results.append(_expression(module, text[2:-1], symbols))
        elif kind == lexer.EXTENSION:
            results.append(module.eval_extension(f"$({module.eval_text(text[2:-1], symbols)})"))
        elif kind == lexer.DOLLAR_DOLLAR_BRACE:
            results.append(text[1:])
        else:
            results.append(text)
    return results[0] if len(results) == 1 else guards.checked("".join(map(str, results)))


def _expression(module: Any, text: str, symbols: Any) -> Any:
    try:
        return module.safe_eval(module.eval_text(text, symbols), symbols)
    except Exception as error:
        raise module.XacroException(exc=error, suffix=f"\nwhen evaluating expression '{text}'") from error


def _safe_eval(expression: str, symbols: Any, _local: object = None) -> Any:
    expression = expression.strip()
    path = plain_path(expression)
    if path is not None and path[0] in symbols:
        return guards.checked(reduce(getitem, path[1:], symbols[path[0]]))
    symbols.update(__builtins__={})
    function = FunctionType(compile_checked(expression, function=True), symbols)
    return guards.checked(function(*guards.GUARDS))


@lru_cache(4096)
def _is_valid_name(name: str) -> bool:
    return name.isidentifier() and not keyword.iskeyword(name)


def _heal_recursion(module: Any) -> None:
    """A failed look-up leaves its mark in xacro's table, and the next one would be told of a circle that is none."""
    resolve = module.Table._resolve_

    def healed(table: Any, key: str) -> Any:
        before = len(table.recursive)
        try:
            return resolve(table, key)
        except Exception:
            del table.recursive[before:]
            raise

    module.Table._resolve_ = healed


def _yaml_loader(expander: Expander) -> Callable[[str], Any]:
    """Xacro's load_yaml. A plain function: a `partial` would show expressions what it was made of."""

    def load_yaml(filename: str) -> Any:
        return _load_yaml(expander, filename)

    return load_yaml


def _load_yaml(expander: Expander, filename: str) -> Any:
    """What a YAML file holds, by libyaml where it is there, reading only what may be read."""
    from urdfctl.source.pyyaml import yaml

    module: Any = expander.module
    base: Any = getattr(yaml, "CSafeLoader", yaml.SafeLoader)
    loader = type("Loader", (base,), {})
    for unit in module.ConstructUnits:
        loader.add_constructor(unit.value.tag, unit.constructor)  # type: ignore[attr-defined]
    path = module.abs_filename_spec(filename)
    text = expander.files.read(path).data
    check_size(text)
    expander.loaded[path] = None
    module.filestack.append(path)
    try:
        return module.YamlListWrapper.wrap(yaml.load(text, loader))
    finally:
        module.filestack.pop()
        module.all_includes.append(path)


def _extension(expander: Expander, original: Callable[[str], str]) -> Callable[[str], str]:
    """`$(find)`, `$(env)` and `$(eval)`, with packages found without ROS; xacro's module for them is loaded late."""
    connected = False

    def extension(text: str) -> str:
        nonlocal connected
        if not connected:
            connected = True
            _connect(expander, engine.substitutions(expander.module))
        try:
            return original(text)
        except Exception as error:
            error.substitution = text  # type: ignore[attr-defined]  # for who tells of it
            raise

    return extension


def _connect(expander: Expander, substitutions: ModuleType) -> None:
    module: Any = substitutions
    module._eval_find = module._eval_dict["find"] = expander.find_package
    environ = expander.environ

    def env(name: str) -> str:
        if name not in environ:
            raise MissingVariable(name)
        return environ[name]

    def optenv(name: str, default: str = "") -> str:
        return environ.get(name, default)

    module._eval_env = module._eval_dict["env"] = env
    module._eval_optenv = module._eval_dict["optenv"] = optenv
    if not expander.trust:
        module._eval = partial(_eval, module)


def _eval(module: Any, expression: str, context: dict[str, Any]) -> str:
    """Xacro's `$(eval ...)`, behind the same allow-list as `${...}` and with harmless builtins only."""
    arguments = context.setdefault("arg", {})

    def arg(name: str) -> Any:
        return module.convert_value(module._eval_arg(name, args=arguments), "auto")

    if "__" in expression:
        raise module.SubstitutionException("$(eval ...) may not contain double underscore expressions")
    values = {**module._eval_dict, **vars(guards.harmless_math())}
    known = {"arg": arg, **{name: value for name, value in values.items() if not name.startswith("__")}}
    code = compile_checked(expression.strip())
    return str(guards.checked(eval(code, _harmless_globals(), module._DictWrapper(arguments, known))))  # noqa: S307 (only the allow-list comes so far)


def _harmless_globals() -> dict[str, Any]:
    named = guards.harmless_builtins()
    operators = zip(OPERATORS, guards.GUARDS, strict=True)
    return {"__builtins__": {**{name: named[name] for name in _PURE}, **dict(operators)}}
