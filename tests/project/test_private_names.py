"""Tests use the public names of the package, so that what is private may change without them."""

from __future__ import annotations

import ast
from collections.abc import Iterator
from pathlib import Path

from folder import CHECKOUT

OF_NAMED_TUPLES = {"_asdict", "_fields", "_make", "_replace"}


def is_private(name: str) -> bool:
    """Whether a name is private; those of Python and of named tuples are not."""
    return name.startswith("_") and not name.startswith("__") and name not in OF_NAMED_TUPLES


def private_names(tree: ast.Module) -> Iterator[str]:
    """Yield the private names of the package that a module imports, reads or replaces."""
    ours: set[str] = set()
    for node in ast.walk(tree):
        if isinstance(node, ast.ImportFrom) and (node.module or "").startswith("urdfctl"):
            ours |= {alias.asname or alias.name for alias in node.names}
            yield from (alias.name for alias in node.names if is_private(alias.name))
        elif isinstance(node, ast.Import):
            names = (alias.asname or alias.name for alias in node.names if alias.name.startswith("urdfctl"))
            ours |= {name.partition(".")[0] for name in names}
    for node in ast.walk(tree):
        if isinstance(node, ast.Attribute) and is_private(node.attr) and root(node.value) in ours:
            yield node.attr
        elif isinstance(node, ast.Call) and ast.unparse(node.func).endswith("setattr") and root(node.args[0]) in ours:
            name = node.args[1]
            if isinstance(name, ast.Constant) and is_private(str(name.value)):
                yield str(name.value)


def root(node: ast.expr) -> str:
    """Return the name with which an expression begins: `a` of `a.b(1).c`."""
    while isinstance(node, ast.Attribute | ast.Call):
        node = node.func if isinstance(node, ast.Call) else node.value
    return node.id if isinstance(node, ast.Name) else ""


def used_in(path: Path) -> set[str]:
    """Return the private names of the package that a file uses."""
    return set(private_names(ast.parse(path.read_text(encoding="utf-8"))))


def test_no_test_uses_a_private_name_of_the_package() -> None:
    tests = CHECKOUT / "tests"
    used = {path.relative_to(tests).as_posix(): used_in(path) for path in sorted(tests.rglob("*.py"))}
    assert {file: names for file, names in used.items() if names} == {}


def test_no_test_module_imports_another_one() -> None:
    """What they share is in tests/helpers. tests/bench/exhaustive runs tests again, on all cases."""
    tests = CHECKOUT / "tests"
    paths = [path for path in sorted(tests.rglob("*.py")) if "exhaustive" not in path.parts]
    modules = {path: imported(ast.parse(path.read_text(encoding="utf-8"))) for path in paths}
    assert {path.name: names for path, names in modules.items() if names} == {}


def imported(tree: ast.Module) -> set[str]:
    """Return the test modules that a module imports from."""
    names = {node.module or "" for node in ast.walk(tree) if isinstance(node, ast.ImportFrom)}
    return {name for name in names if name.rpartition(".")[2].startswith("test_")}


def test_private_names_are_seen_when_they_are_imported_read_or_replaced() -> None:
    text = "from urdfctl import a\nfrom urdfctl.b import _c\na._d()\npatch.setattr(a, '_e', 1)\na.F()._replace(g=1)\n"
    assert set(private_names(ast.parse(text))) == {"_c", "_d", "_e"}
