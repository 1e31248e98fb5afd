"""Guarded expressions and params give what Python and xacro give, wherever those give anything sane."""

from __future__ import annotations

import pytest
import xacro
from hypothesis import given, settings
from hypothesis import strategies as st
from sampling import examples

from urdfctl.source.xacro.expressions.compiling import compile_checked
from urdfctl.source.xacro.expressions.meter import Meter
from urdfctl.source.xacro.private.macro_params import split_first


def split(function: object, text: str) -> object:
    try:
        return function(text)  # type: ignore[operator]
    except IndexError as error:
        return str(error)


@settings(max_examples=examples(300))
@given(st.text(st.sampled_from("ab'\"${}()^|:= \n\t"), max_size=14))
def test_the_params_of_a_macro_are_split_as_xacro_splits_them(text: str) -> None:
    assert split(split_first, text) == split(xacro.parse_macro_arg, text)
    assert split(split_first, "a:=" + text) == split(xacro.parse_macro_arg, "a:=" + text)


SANE = [
    "1 + 2 * 3 ** 2 - 7 % 4 // 2 << 1",
    "2 * 'ab' + 'c' * 2",
    "[1, 2] * 2 + [0] * 3",
    "(1,) * 2",
    "'%.3f %s' % (1.5, 'x')",
    "'%5d|%-5s|%%' % (1, 'a')",
    "-2 ** 2",
    "2 ** -1",
    "0 ** 0",
    "1 ** 10**100",
    "True * 3",
    "'a'.ljust(4) + 'b'.zfill(3)",
    "'{} {:.3f} {a} {{}}'.format(1, 2.0, a=3)",
    "[x * y for x in [1, 2] for y in [3.0, 'a']]",
    "(lambda x, y: x ** y)(2, 3)",
    "sum([i * i for i in range(5)])",
    "10 ** 1000 % 7",
    "dict(a=1)['a'] * 1.5",
    "3 if 1 < 2 < 3 else 4",
    "'a,b'.split(',')",
    "[1, 2, 3][::-1]",
    "(2 + 3j).real * 2",
    "'x' in 'xyz' and not None",
]


@pytest.mark.parametrize("expression", SANE)
def test_a_sane_expression_gives_what_python_gives(expression: str) -> None:
    code = compile_checked(expression, function=True)
    names = {name: __builtins__[name] for name in ("sum", "range", "dict")}  # type: ignore[index]
    function = type(split)(code, {**names, "__builtins__": {}})
    assert function(*Meter().guards) == eval(expression)  # noqa: S307 (literal)


NUMBERS = st.integers(-50, 50) | st.floats(allow_nan=False, width=16) | st.booleans()


@given(
    NUMBERS | st.text(max_size=3) | st.lists(st.integers(), max_size=3),
    NUMBERS,
    st.sampled_from(["*", "**", "<<", "%"]),
)
def test_a_guarded_operator_gives_or_raises_what_python_does(left: object, right: object, operator: str) -> None:
    def outcome(function: object, *arguments: object) -> object:
        try:
            return repr(function(*arguments))  # type: ignore[operator]
        except (TypeError, ValueError, ArithmeticError) as error:
            return type(error), str(error)

    code = compile_checked(f"left {operator} right", function=True)
    ours = outcome(type(split)(code, {"left": left, "right": right, "__builtins__": {}}), *Meter().guards)
    assert ours == outcome(lambda: eval(f"left {operator} right", {"left": left, "right": right}))  # noqa: S307 (literal)
