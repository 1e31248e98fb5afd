"""Which functions of the smoke test each test calls, and which functions a changed statement concerns. Python 3.11."""

from __future__ import annotations

import ast
import functools
import hashlib
import json
import multiprocessing
import os
import sys
import tempfile
import threading
from collections import defaultdict
from collections.abc import Iterator
from pathlib import Path
from types import FrameType
from typing import NamedTuple

import pytest

ROOT = Path(__file__).parents[3]
SMOKE = ROOT / "urdfctl" / "smoke"
KEPT = ROOT / ".pytest_cache" / "smoke-called.json"


class Test(NamedTuple):
    """A test: its node, its processor time in s, and the functions that it calls, as module:qualified name."""

    __test__ = False

    name: str
    seconds: float
    functions: frozenset[str]


def modules() -> list[str]:
    """Return the names of all modules of the smoke test, as after `urdfctl.smoke.`."""
    paths = (path.relative_to(SMOKE) for path in sorted(SMOKE.rglob("*.py")))
    names = (".".join(part for part in path.with_suffix("").parts if part != "__init__") for path in paths)
    return [name for name in names if name]


def path_of(module: str) -> Path:
    """Return the file of a module."""
    path = SMOKE / module.replace(".", "/")
    return path / "__init__.py" if path.is_dir() else path.with_suffix(".py")


def called() -> list[Test]:
    """Return the tests that call functions of the smoke test.

    Each file of tests runs once, with its calls counted, and again when it has changed. Remove KEPT after large changes
    of the smoke test itself: a test that calls other functions since then would not be found.
    """
    kept = json.loads(KEPT.read_text(encoding="utf-8")) if KEPT.exists() else {}
    tests = []
    for path in [*sorted(ROOT.glob("tests/smoke/*/*.py")), *sorted(ROOT.glob("tests/commands/test_cli_smoke*.py"))]:
        text = path.read_bytes()
        name, key = path.relative_to(ROOT).as_posix(), hashlib.sha256(text).hexdigest()
        if kept.get(name, [""])[0] != key:
            print(f"counting the calls of {name}", flush=True)
            kept[name] = [key, _counted(name)]
            KEPT.parent.mkdir(exist_ok=True)
            KEPT.write_text(json.dumps(kept), encoding="utf-8")
        tests += [Test(node, seconds, frozenset(functions)) for node, seconds, functions in kept[name][1]]
    return tests


def _counted(file: str) -> list[tuple[str, float, list[str]]]:
    """Return the tests of a file with their seconds and the functions that they and their forks call."""
    with tempfile.NamedTemporaryFile("r", encoding="utf-8") as log:
        process = multiprocessing.get_context("fork").Process(target=_count, args=(file, log.name))
        process.start()
        process.join()
        lines = [line.rstrip("\n").split("\t") for line in log]
    seconds: dict[str, float] = defaultdict(float)
    functions: dict[str, set[str]] = defaultdict(set)
    for node, kind, value in lines:
        if kind == "seconds":
            seconds[node] += float(value)
        else:
            functions[node].add(value)
    return [(node, seconds[node], sorted(found)) for node, found in functions.items()]


def _count(file: str, log: str) -> None:
    null = os.open(os.devnull, os.O_RDWR)
    for stream in (0, 1, 2):
        os.dup2(null, stream)
    counter = _Counter(os.open(log, os.O_WRONLY | os.O_APPEND))
    threading.settrace(counter.trace)
    sys.settrace(counter.trace)
    os._exit(pytest.main(["-q", "-n0", "-p", "no:cacheprovider", file], plugins=[counter]))


class _Counter:
    """Writes each function of the smoke test that a test calls to a file, which forks of this process share."""

    def __init__(self, log: int) -> None:
        self.log = log
        self.node, self.began = "", 0.0
        self.seen: set[int] = set()
        self.prefix = f"{SMOKE}{os.sep}"

    def trace(self, frame: FrameType, _event: str, _argument: object) -> None:
        code = frame.f_code
        if code.co_filename.startswith(self.prefix) and self.node and id(code) not in self.seen:
            self.seen.add(id(code))
            module = Path(code.co_filename[len(self.prefix) :]).with_suffix("").as_posix().replace("/", ".")
            self._write("calls", f"{module.removesuffix('.__init__')}:{code.co_qualname.partition('.<')[0]}")

    def _write(self, kind: str, value: object) -> None:
        os.write(self.log, f"{self.node}\t{kind}\t{value}\n".encode())

    def pytest_runtest_logstart(self, nodeid: str) -> None:
        self.node, self.seen, self.began = nodeid, set(), sum(os.times()[:4])

    def pytest_runtest_logfinish(self) -> None:
        self._write("seconds", sum(os.times()[:4]) - self.began)


def concerned(module: str, statement: ast.stmt, line: int) -> frozenset[str]:
    """Return the functions that a change in a line of a top-level statement of a module concerns.

    For a function that is the function itself; for a constant, each function that names it, or names a constant that
    does; for anything else, all functions of the module.
    """
    for name, function in _functions(module):
        if function.lineno <= line <= (function.end_lineno or 0):
            return frozenset([f"{module}:{name}"])
    targets = [statement.target] if isinstance(statement, ast.AnnAssign) else getattr(statement, "targets", [])
    names = {target.id for target in targets if isinstance(target, ast.Name)}
    if not names:
        return frozenset(f"{module}:{name}" for name, _ in _functions(module))
    return frozenset(_naming(names))


def _naming(names: set[str]) -> Iterator[str]:
    for module in modules():
        functions = list(_functions(module))
        for name, function in functions:
            if not names.isdisjoint(_named(function)):
                yield f"{module}:{name}"
        for statement in _tree(module).body:
            if isinstance(statement, ast.FunctionDef | ast.Import | ast.ImportFrom):
                continue
            of_value = _named(getattr(statement, "value", None) or statement)
            if isinstance(statement, ast.Assign | ast.AnnAssign) and not names.isdisjoint(of_value):
                more = {target.id for target in ast.walk(statement) if isinstance(target, ast.Name)} - names
                targets = statement.targets if isinstance(statement, ast.Assign) else [statement.target]
                yield from _naming({one.id for one in targets if isinstance(one, ast.Name)} & more)
            elif isinstance(statement, ast.ClassDef) and not names.isdisjoint(of_value):
                yield from (f"{module}:{name}" for name, _ in functions)


def _named(node: ast.AST) -> set[str]:
    parts = list(ast.walk(node))
    return {part.id for part in parts if isinstance(part, ast.Name)} | {
        part.attr for part in parts if isinstance(part, ast.Attribute)
    }


@functools.cache
def _tree(module: str) -> ast.Module:
    return ast.parse(path_of(module).read_text(encoding="utf-8"))


@functools.cache
def _functions(module: str) -> list[tuple[str, ast.FunctionDef]]:
    """Return the functions and methods of a module with their qualified names, but not those inside functions."""
    found = []
    for node in _tree(module).body:
        if isinstance(node, ast.FunctionDef):
            found.append((node.name, node))
        elif isinstance(node, ast.ClassDef):
            found += [(f"{node.name}.{one.name}", one) for one in node.body if isinstance(one, ast.FunctionDef)]
    return found
