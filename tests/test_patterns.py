"""Patterns of modules are compiled on first use."""

from __future__ import annotations

import ast
import re
from pathlib import Path

from urdfctl.startup.patterns import LazyPattern

PACKAGE = Path(__file__).parents[1] / "urdfctl"


def test_a_lazy_pattern_has_what_a_compiled_one_has() -> None:
    lazy, compiled = re.compile(r"(a)b", re.IGNORECASE), re.compile(r"(a)b", re.IGNORECASE)
    assert isinstance(lazy, LazyPattern)
    assert lazy.findall("AB ab") == compiled.findall("AB ab")
    assert (lazy.pattern, lazy.flags) == (compiled.pattern, compiled.flags)


def test_no_lazy_pattern_is_given_to_a_function_of_re_which_takes_only_compiled_ones() -> None:
    given = []
    for path in PACKAGE.rglob("*.py"):
        tree = ast.parse(path.read_text(encoding="utf-8"))
        lazy = {
            ast.unparse(node.targets[0])
            for node in tree.body
            if isinstance(node, ast.Assign) and ast.unparse(node.value).startswith("re.compile(")
        }
        given += [
            f"{path.name}:{node.lineno}"
            for node in (ast.walk(tree) if lazy else ())
            if isinstance(node, ast.Call) and ast.unparse(node.func).startswith("re.")
            if node.args and ast.unparse(node.args[0]) in lazy
        ]
    assert given == []
