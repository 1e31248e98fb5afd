"""What the code's readers rely on and no linter checks."""

from __future__ import annotations

import ast
import builtins
from collections.abc import Iterator
from pathlib import Path

from folder import CHECKOUT

MOST_POSITIONAL = 5
PLAIN = {*dir(builtins), "join"}


def calls(path: Path) -> Iterator[ast.Call]:
    """Yield the calls in a file."""
    for node in ast.walk(ast.parse(path.read_text(encoding="utf-8"))):
        if isinstance(node, ast.Call):
            yield node


def test_calls_with_more_than_five_arguments_use_keywords() -> None:
    long = [
        f"{path.relative_to(CHECKOUT)}:{call.lineno} {ast.unparse(call.func)}"
        for path in sorted((CHECKOUT / "urdfctl").rglob("*.py"))
        for call in calls(path)
        if len(call.args) > MOST_POSITIONAL and not any(isinstance(part, ast.Starred) for part in call.args)
        if ast.unparse(call.func).split(".")[-1] not in PLAIN
    ]
    assert long == []


def test_the_name_of_a_class_stands_once() -> None:
    named: dict[str, list[str]] = {}
    for path in sorted((CHECKOUT / "urdfctl").rglob("*.py")):
        for node in ast.parse(path.read_text(encoding="utf-8")).body:
            if isinstance(node, ast.ClassDef):
                named.setdefault(node.name, []).append(str(path.relative_to(CHECKOUT)))
    assert {name: paths for name, paths in named.items() if len(paths) > 1} == {}
