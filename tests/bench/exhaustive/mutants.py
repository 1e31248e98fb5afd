"""Mutation test of the smoke test: change one constant or comparison at a time, and see whether a test fails.

    python tests/bench/exhaustive/mutants.py [--jobs N] [MODULE ...]

Each constant of a module is multiplied and divided by three, and each comparison is reversed. Those that survive the
fast tests are given to the slow ones, with engines. Prints the mutants that survive these too, and how many were
killed. Exits with 1 if less than nine of ten were.
"""

from __future__ import annotations

import argparse
import ast
import copy
import subprocess
import sys
import tempfile
from collections.abc import Iterator
from concurrent.futures import ThreadPoolExecutor
from pathlib import Path

ROOT = Path(__file__).parents[3]
SMOKE = ROOT / "urdfctl" / "smoke"
TESTS = ("checks", "formulas", "stability", "trial", "agreement", "groups", "manager", "page", "runs")
SLOW_TESTS = ("test_smoke_engines", "test_smoke_faults", "test_smoke_rules", "test_cli_smoke_gates", "test_cli_smoke")
FACTORS = (3.0, 1 / 3)
REVERSED: dict[type[ast.cmpop], type[ast.cmpop]] = {
    ast.Lt: ast.GtE,
    ast.GtE: ast.Lt,
    ast.Gt: ast.LtE,
    ast.LtE: ast.Gt,
    ast.Eq: ast.NotEq,
    ast.NotEq: ast.Eq,
    ast.In: ast.NotIn,
    ast.NotIn: ast.In,
    ast.Is: ast.IsNot,
    ast.IsNot: ast.Is,
}
ENOUGH = 0.9
HARNESS = """
import importlib.abc, importlib.util, sys
name, path = sys.argv[1], sys.argv[2]
class Finder(importlib.abc.MetaPathFinder):
    def find_spec(self, fullname, _path, _target=None):
        return importlib.util.spec_from_file_location(name, path) if fullname == name else None
sys.meta_path.insert(0, Finder())
import pytest
sys.exit(pytest.main(["-q", "-x", "-n0", "-p", "no:cacheprovider", *sys.argv[3:]]))
"""


def mutants(source: str) -> Iterator[tuple[str, str]]:
    """Yield each mutant of a module as what was changed, and its source."""
    tree = ast.parse(source)
    for index, node in enumerate(ast.walk(tree)):
        changes: list[tuple[str, ast.AST]] = []
        if isinstance(node, ast.Compare):
            changes = [(f"{ast.unparse(node)} reversed", _reversed(node))]
        elif isinstance(node, ast.Assign) and node in tree.body:
            changes = list(_scaled(node))
        for what, changed in changes:
            made = copy.deepcopy(tree)
            target = list(ast.walk(made))[index]
            target.__dict__.update(changed.__dict__)
            yield f"line {getattr(node, 'lineno', 0)}: {what}", ast.unparse(made)


def _reversed(node: ast.Compare) -> ast.Compare:
    made = copy.deepcopy(node)
    made.ops = [REVERSED[type(op)]() for op in made.ops[:1]] + made.ops[1:]
    return made


def _scaled(node: ast.Assign) -> Iterator[tuple[str, ast.Assign]]:
    numbers = [n for n, part in enumerate(ast.walk(node)) if isinstance(part, ast.Constant) and _is_number(part.value)]
    for n in numbers:
        for factor in FACTORS:
            made = copy.deepcopy(node)
            constant = list(ast.walk(made))[n]
            assert isinstance(constant, ast.Constant)
            assert isinstance(constant.value, int | float)
            constant.value = constant.value * factor if constant.value else factor
            yield f"{ast.unparse(node)[:60]} -> {constant.value:g}", made


def _is_number(value: object) -> bool:
    return isinstance(value, int | float) and not isinstance(value, bool)


def modules() -> list[str]:
    """Return the names of all modules of the smoke test, as after `urdfctl.smoke.`."""
    paths = (path.relative_to(SMOKE).with_suffix("") for path in sorted(SMOKE.rglob("*.py")))
    return [".".join(path.parts) for path in paths if path.name != "__init__"]


def survives(module: str, source: str) -> bool:
    """Return whether all tests pass with a changed module: the fast ones, then the slow ones."""
    fast = [f"tests/test_smoke_{name}.py" for name in TESTS]
    return _passes(module, source, fast) and _passes(module, source, [f"tests/{name}.py" for name in SLOW_TESTS])


def _passes(module: str, source: str, tests: list[str]) -> bool:
    with tempfile.TemporaryDirectory() as folder:
        path = Path(folder) / f"{module}.py"
        path.write_text(source, encoding="utf-8")
        command = [sys.executable, "-c", HARNESS, f"urdfctl.smoke.{module}", str(path), *tests]
        try:
            done = subprocess.run(command, cwd=ROOT, capture_output=True, timeout=240, check=False)
        except subprocess.TimeoutExpired:
            return False
    return done.returncode == 0


def main() -> int:
    """Test all mutants of the modules named in the arguments, or of all modules."""
    parser = argparse.ArgumentParser(description="Mutation test of the smoke test.")
    parser.add_argument("modules", nargs="*", default=modules(), help="e.g. checks or engines.bullet; default: all")
    parser.add_argument("--jobs", type=int, default=1, help="how many mutants are tested at the same time")
    options = parser.parse_args()
    killed = total = 0
    for module in options.modules:
        source = (SMOKE / f"{module.replace('.', '/')}.py").read_text(encoding="utf-8")
        made = list(mutants(source))
        with ThreadPoolExecutor(options.jobs) as pool:
            results = list(pool.map(lambda one, module=module: survives(module, one[1]), made))  # type: ignore[misc]
        for (what, _), alive in zip(made, results, strict=True):
            if alive:
                print(f"{module}: {what}", flush=True)
        killed += results.count(False)
        total += len(results)
        print(f"{module}: {results.count(False)} of {len(results)} killed", flush=True)
    print(f"{killed} of {total} mutants killed")
    return 0 if killed >= ENOUGH * total else 1


if __name__ == "__main__":
    raise SystemExit(main())
