"""Replace slow helpers of xacro by faster ones that give the same; see replacements.py."""

from __future__ import annotations

import keyword
import re
from collections.abc import Callable
from functools import lru_cache
from typing import Any

from urdfctl.source.budget import OverBudget
from urdfctl.source.xacro.expressions.meter import Meter
from urdfctl.source.xacro.private.macro_params import split_quickly
from urdfctl.source.xacro.private.replacements import replace


def install_speed(module: Any, meter: Meter, *, trust: bool) -> None:
    """Replace the slow helpers; with `trust`, only those that evaluate nothing."""
    replace(module, "deepcopy", list)
    replace(module, "is_valid_name", _is_valid_name)
    if trust:
        return
    replace(module, "eval_text", _text_evaluator(module, meter))
    replace(module, "parse_macro_arg", split_quickly(module.parse_macro_arg))


@lru_cache(4096)
def _is_valid_name(name: str) -> bool:
    return name.isidentifier() and not keyword.iskeyword(name)


def _text_evaluator(module: Any, meter: Meter) -> Callable[[Any, Any], Any]:
    lex = _lexer(module)

    def eval_text(text: Any, symbols: Any) -> Any:
        if not text:
            return ""
        if "$" not in text:
            return text
        return _evaluated(module, meter, lex(text), symbols)

    return eval_text


def _lexer(module: Any) -> Callable[[str], list[tuple[int, str]]]:
    """Return xacro's lexer with a cache, and without a copy of the rest of the text for each piece."""
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


def _evaluated(module: Any, meter: Meter, pieces: list[tuple[int, str]], symbols: Any) -> Any:
    """Return the value of a text like xacro's eval_text: typed if the text is a single expression."""
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
    return results[0] if len(results) == 1 else meter.joined(results)


def _expression(module: Any, text: str, symbols: Any) -> Any:
    try:
        return module.safe_eval(module.eval_text(text, symbols), symbols)
    except (OverBudget, MemoryError):
        raise
    except Exception as error:
        raise module.XacroException(exc=error, suffix=f"\nwhen evaluating expression '{text}'") from error
