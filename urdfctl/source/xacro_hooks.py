"""Replaces helpers of xacro for speed, for safety, and for packages without ROS; what they give is the same."""

from __future__ import annotations

import builtins
import keyword
import math
from collections.abc import Callable
from functools import lru_cache, partial
from types import ModuleType
from typing import TYPE_CHECKING, Any

from urdfctl.source import engine
from urdfctl.source.expressions import compile_checked

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
    original_eval_text = module.eval_text
    lex = _lexer(module)

    def eval_text(text: Any, symbols: Any) -> Any:
        if not text:
            return ""
        if "$" not in text:
            return text
        return _evaluated(module, lex(text), symbols)

    module.eval_text = eval_text if not expander.trust else original_eval_text
    module.deepcopy = list
    module.is_valid_name = _is_valid_name
    if not expander.trust:
        module.safe_eval = partial(_safe_eval, module)
    module.load_yaml = partial(_load_yaml, expander)
    module.eval_extension = _extension(expander, module.eval_extension)
    _heal_recursion(module)
    module._global_symbols = module.create_global_symbols()


def _lexer(module: Any) -> Callable[[str], list[tuple[int, str]]]:
    """Xacro's own lexer, remembering what it has cut."""

    @lru_cache(4096)
    def lex(text: str) -> list[tuple[int, str]]:
        quick = module.QuickLexer(module.LEXER)
        quick.lex(text)
        pieces = []
        while quick.peek():
            pieces.append(quick.next())
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
    return results[0] if len(results) == 1 else "".join(map(str, results))


def _expression(module: Any, text: str, symbols: Any) -> Any:
    try:
        return module.safe_eval(module.eval_text(text, symbols), symbols)
    except Exception as error:
        raise module.XacroException(exc=error, suffix=f"\nwhen evaluating expression '{text}'") from error


def _safe_eval(module: Any, expression: str, symbols: Any, local: Any = None) -> Any:
    code = compile_checked(expression.strip())
    invalid = [name for name in code.co_names if name.startswith("__")]
    if invalid:
        raise module.XacroException("Use of invalid name(s): ", ", ".join(invalid))
    symbols.update(__builtins__={})
    return eval(code, symbols, local)  # noqa: S307 (compile_checked lets only the allow-list through)


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


def _load_yaml(expander: Expander, filename: str) -> Any:
    """Xacro's load_yaml, on libyaml where it is there, reading only what may be read."""
    import yaml

    module: Any = expander.module
    base: Any = getattr(yaml, "CSafeLoader", yaml.SafeLoader)
    loader = type("Loader", (base,), {})
    for unit in module.ConstructUnits:
        loader.add_constructor(unit.value.tag, unit.constructor)  # type: ignore[attr-defined]
    path = module.abs_filename_spec(filename)
    text = expander.files.read(path).data
    module.filestack.append(path)
    try:
        return module.YamlListWrapper.wrap(yaml.load(text, loader))  # noqa: S506 (a SafeLoader)
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
    known = {"arg": arg, **{k: v for k, v in module._eval_dict.items() if k != "__builtins__"}, **vars(math)}
    code = compile_checked(expression.strip())
    harmless = {name: getattr(builtins, name) for name in _PURE}
    return str(eval(code, {"__builtins__": harmless}, module._DictWrapper(arguments, known)))  # noqa: S307 (as above)
