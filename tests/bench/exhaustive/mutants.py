"""Mutation test of the smoke test: change one constant or comparison at a time, and see whether a test fails.

    python tests/bench/exhaustive/mutants.py [--seconds N] [MODULE ...]

Each constant of a module is multiplied and divided by three, and each comparison is reversed. Each mutant meets only
the tests that call a function that it concerns (see `called.py`), the quickest first, and those of files that import
the module before slower ones, up to the first that fails.
Prints the mutants that survive, how many were killed in each module, and in all. Exits with 1 if less than nine of ten
were.
"""

from __future__ import annotations

import argparse
import ast
import copy
import functools
import importlib.abc
import importlib.machinery
import importlib.util
import multiprocessing
import os
import signal
import sys
from collections import Counter
from collections.abc import Iterator, Sequence
from itertools import accumulate
from multiprocessing.queues import SimpleQueue
from types import CodeType
from typing import NamedTuple

import pytest
from called import ROOT, Test, called, concerned, modules, path_of

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
QUICKEST = 20
LIKELIER = 0.1
OPTIONS = ("-q", "-x", "-n0", "-p", "no:cacheprovider", "-W", "ignore::pytest.PytestAssertRewriteWarning")
PRELOADED = ("numpy", "pybullet", "mujoco", "hypothesis", "typer.testing", "urdfctl.commands.app", "urdfctl.lint.job")


class Mutant(NamedTuple):
    """A changed module: what was changed, in which top-level statement, and its source."""

    what: str
    statement: ast.stmt
    line: int
    source: str


def mutants(source: str) -> Iterator[Mutant]:
    """Yield each mutant of a module."""
    tree = ast.parse(source)
    for index, node in enumerate(ast.walk(tree)):
        changes: list[tuple[str, ast.AST]] = []
        if isinstance(node, ast.Compare):
            changes = [(f"{ast.unparse(node)} reversed", _reversed(node))]
        elif isinstance(node, ast.Assign | ast.AnnAssign) and node in tree.body:
            changes = list(_scaled(node))
        for what, changed in changes:
            made = copy.deepcopy(tree)
            target = list(ast.walk(made))[index]
            target.__dict__.update(changed.__dict__)
            line = getattr(node, "lineno", 0)
            statement = next(one for one in tree.body if one.lineno <= line <= (one.end_lineno or 0))
            yield Mutant(f"line {line}: {what}", statement, line, ast.unparse(made))


def _reversed(node: ast.Compare) -> ast.Compare:
    made = copy.deepcopy(node)
    made.ops = [REVERSED[type(op)]() for op in made.ops[:1]] + made.ops[1:]
    return made


def _scaled(node: ast.Assign | ast.AnnAssign) -> Iterator[tuple[str, ast.stmt]]:
    numbers = [n for n, part in enumerate(ast.walk(node)) if isinstance(part, ast.Constant) and _is_number(part.value)]
    for n in numbers:
        for factor in FACTORS:
            made = copy.deepcopy(node)
            constant = list(ast.walk(made))[n]
            assert isinstance(constant, ast.Constant)
            assert isinstance(constant.value, int | float)
            before = constant.value
            constant.value = type(before)(before * factor if before else factor)
            if constant.value == before:  # an int 0
                continue
            yield f"{ast.unparse(node)[:60]} -> {constant.value:g}", made


def _is_number(value: object) -> bool:
    return isinstance(value, int | float) and not isinstance(value, bool)


class _Changed(importlib.machinery.SourceFileLoader):
    """Loads a module from another source than its file's."""

    def __init__(self, fullname: str, path: str, source: str) -> None:
        super().__init__(fullname, path)
        self.source = source

    def get_code(self, fullname: str) -> CodeType:
        return compile(self.source, self.path, "exec")


class _Finder(importlib.abc.MetaPathFinder):
    def __init__(self, loader: _Changed) -> None:
        self.loader = loader

    def find_spec(self, fullname: str, *_: object) -> importlib.machinery.ModuleSpec | None:
        return importlib.util.spec_from_loader(fullname, self.loader) if fullname == self.loader.name else None


class _Chosen:
    """Lets pytest run some tests in their order, and notes the first that fails."""

    def __init__(self, tests: Sequence[str], failed: SimpleQueue[str]) -> None:
        self.order = {name: n for n, name in enumerate(tests)}
        self.failed = failed

    def pytest_collection_modifyitems(self, items: list[pytest.Item]) -> None:
        items[:] = sorted((one for one in items if one.nodeid in self.order), key=lambda one: self.order[one.nodeid])

    def pytest_runtest_logreport(self, report: pytest.TestReport) -> None:
        if report.failed:
            self.failed.put(report.nodeid)


def killer(module: str, source: str, tests: Sequence[Test], seconds: float) -> str | None:
    """Return the test that fails with a changed module, or why none ended; None if the mutant survives."""
    if not tests:
        return None
    fork = multiprocessing.get_context("fork")
    failed: SimpleQueue[str] = fork.SimpleQueue()
    process = fork.Process(target=_run, args=(module, source, [test.name for test in tests], failed))
    process.start()
    process.join(seconds + 10 * sum(test.seconds for test in tests))
    if process.is_alive():
        os.killpg(process.pid or 0, signal.SIGKILL)
        process.join()
        return "time limit"
    if process.exitcode == 0:
        return None
    return failed.get() if not failed.empty() else "no import"


@functools.cache
def _imports(file: str) -> str:
    """The lines with which a file of tests imports modules of the smoke test."""
    lines = (ROOT / file).read_text(encoding="utf-8").splitlines()
    return "\n".join(f"{line} " for line in lines if line.startswith("from urdfctl.smoke"))


def _names(test: Test, module: str) -> bool:
    """Whether a file of tests imports a module itself: its tests are the likeliest to fail."""
    parent, _, name = f"urdfctl.smoke.{module}".rpartition(".")
    imports = _imports(test.name.partition("::")[0])
    return f"from urdfctl.smoke.{module} " in imports or f"from {parent} import {name} " in imports


def _cost(test: Test, module: str) -> float:
    return (0.01 + test.seconds) * (LIKELIER if _names(test, module) else 1.0)


def _touches(test: Test, module: str) -> bool:
    return any(name.partition(":")[0] == module for name in test.functions)


def _run(module: str, source: str, tests: Sequence[str], failed: SimpleQueue[str]) -> None:
    os.setsid()
    null = os.open(os.devnull, os.O_RDWR)
    for stream in (0, 1, 2):
        os.dup2(null, stream)
    sys.meta_path.insert(0, _Finder(_Changed(f"urdfctl.smoke.{module}", str(path_of(module)), source)))
    for part in (tests[:QUICKEST], tests[QUICKEST:]):  # each file takes time to be imported
        files = sorted({name.partition("::")[0] for name in part})
        if part and pytest.main([*OPTIONS, *files], plugins=[_Chosen(part, failed)]):
            os._exit(1)
    os._exit(0)


def main() -> int:
    """Test all mutants of the modules named in the arguments, or of all modules."""
    parser = argparse.ArgumentParser(description="Mutation test of the smoke test.")
    parser.add_argument(
        "modules", nargs="*", default=modules(), help="e.g. motion.checks or engines.pybullet_engine; default: all"
    )
    parser.add_argument("--seconds", type=float, default=20.0, help="time limit, beside ten times what the tests take")
    parser.add_argument(
        "--most", type=float, default=60.0, help="processor time of the tests that a mutant meets, in s"
    )
    parser.add_argument("--verbose", action="store_true", help="also print what killed each mutant")
    options = parser.parse_args()
    os.chdir(ROOT)
    sys.path.insert(0, str(ROOT))
    tests = called()
    for name in PRELOADED:
        importlib.import_module(name)
    assert not any(name.startswith("urdfctl.smoke") for name in sys.modules), "a mutant would not be imported"
    killers: Counter[str] = Counter()
    killed = total = 0
    for module in options.modules:
        source = path_of(module).read_text(encoding="utf-8")
        quick = sorted((test for test in tests if test.seconds < 1.0), key=lambda test: test.seconds)
        fails = killer(module, source, [test for test in quick if _touches(test, module)][:QUICKEST], options.seconds)
        assert fails is None, f"{module} fails unchanged: {fails}"
        made = list(mutants(source))
        dead = 0
        for mutant in made:
            functions = concerned(module, mutant.statement, mutant.line)
            meant = [test for test in tests if not functions.isdisjoint(test.functions)]
            meant.sort(key=lambda test: _cost(test, module) / (1 + killers[test.name]))
            sums = accumulate(test.seconds for test in meant)
            meant = [test for test, so_far in zip(meant, sums, strict=True) if so_far <= options.most]
            by = killer(module, mutant.source, meant, options.seconds)
            if by is None:
                print(f"{module}: {mutant.what} survives {len(meant)} tests", flush=True)
            elif options.verbose:
                print(f"{module}: {mutant.what} killed by {by}", flush=True)
            killers.update([by] if by else [])
            dead += by is not None
        killed += dead
        total += len(made)
        print(f"{module}: {dead} of {len(made)} killed", flush=True)
    print(f"{killed} of {total} mutants killed")
    return 0 if killed >= ENOUGH * total else 1


if __name__ == "__main__":
    raise SystemExit(main())
