"""Tests use the public names of the package, so that what is private may change without them."""

from __future__ import annotations

import ast
from collections.abc import Iterator
from pathlib import Path

from folder import CHECKOUT

STILL_USED: dict[str, set[str]] = {
    "fix/test_fix_trial.py": {"_run"},
    "fuzz/fake_git.py": {"_started"},
    "fuzz/probes.py": {"_code", "_location"},
    "lint/test_cache.py": {"_MAX_STORED", "_clocks", "_run"},
    "output/test_output_leftovers.py": {"_machine"},
    "server/test_server_hostile.py": {"_PATIENCE"},
    "smoke/engines/test_smoke_planning.py": {"_left_out"},
    "smoke/lifecycle/test_smoke_candidates.py": {"_errors_by_distro"},
    "smoke/motion/test_smoke_trial.py": {"_skidding", "_stiff", "_tested", "_untested", "_wheels"},
    "smoke/motion/test_smoke_trial_order.py": {"_untested"},
    "smoke/runs/test_smoke_runs.py": {"_engine_output", "_limits", "_run"},
    "smoke/tasks/test_smoke_reading.py": {"_drive", "_gains", "_limit", "_loop"},
    "source/test_deep_folders.py": {"_leave", "_open_closed_streams", "_run"},
    "source/test_gate.py": {"_check_regular"},
    "startup/test_quick_imports.py": {"_PACKAGES"},
}
"""The private names that tests use until there is another way, by file. None may be added."""
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


def test_no_test_uses_another_private_name_of_the_package() -> None:
    tests = CHECKOUT / "tests"
    used = {path.relative_to(tests).as_posix(): used_in(path) for path in sorted(tests.rglob("*.py"))}
    assert {file: names for file, names in used.items() if names} == STILL_USED


def test_private_names_are_seen_when_they_are_imported_read_or_replaced() -> None:
    text = "from urdfctl import a\nfrom urdfctl.b import _c\na._d()\npatch.setattr(a, '_e', 1)\na.F()._replace(g=1)\n"
    assert set(private_names(ast.parse(text))) == {"_c", "_d", "_e"}
