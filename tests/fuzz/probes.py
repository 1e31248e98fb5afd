"""Which branches of urdfctl and xacro were reached: probes that are put into their code when it is imported.

A probe sets one byte when a function, a branch or a loop's body begins. That costs a tenth of the time of a run, where
a tracing function takes several times as long, and works in every version of Python.
"""

from __future__ import annotations

import ast
import builtins
import sys
from collections.abc import Iterable, Sequence
from importlib import import_module
from importlib.machinery import ModuleSpec, PathFinder, SourceFileLoader
from itertools import count
from pathlib import Path
from pkgutil import walk_packages
from types import CodeType

REACHED = bytearray()
"""A byte for each probe: 1 if it was reached."""
_NAME = "__probes__"
_FUNCTIONS = (ast.FunctionDef, ast.AsyncFunctionDef)
_BLOCKS = ("body", "orelse", "finalbody")


def install(packages: Iterable[str] = ("urdfctl",)) -> None:
    """Put probes into the modules of some packages that are imported from now on, and into the private xacro."""
    setattr(builtins, _NAME, REACHED)
    sys.meta_path.insert(0, _Finder(tuple(packages)))
    from urdfctl.source.xacro.private import private_module

    private_module.code_of_part = _code_of_xacro  # type: ignore[assignment]


def import_everything(package: str = "urdfctl") -> None:
    """Import all modules of a package, and the private xacro: forked processes then number the probes alike."""
    for module in walk_packages(import_module(package).__path__, f"{package}."):
        if not module.name.endswith("__main__"):
            import_module(module.name)
    from urdfctl.source.xacro.private import private_module

    private_module.substitutions(private_module.load())


class _Finder:
    def __init__(self, packages: Sequence[str]) -> None:
        self._starts = tuple(f"{package}." for package in packages)

    def find_spec(self, name: str, path: Sequence[str] | None, target: object = None) -> ModuleSpec | None:
        if not name.startswith(self._starts):
            return None
        spec = PathFinder.find_spec(name, path)
        if spec is not None and isinstance(spec.loader, SourceFileLoader):
            spec.loader = _Loader(name, spec.loader.path)
        return spec


class _Loader(SourceFileLoader):
    def get_code(self, fullname: str) -> CodeType:
        return with_probes(self.get_data(self.path), self.path)


_XACRO: dict[str, CodeType] = {}


def _code_of_xacro(part: str) -> CodeType:
    from urdfctl.source.xacro.private.private_module import location_of_xacro

    if part not in _XACRO:
        path = Path(location_of_xacro(), f"{part}.py")
        _XACRO[part] = with_probes(path.read_bytes(), str(path))
    return _XACRO[part]


def with_probes(source: bytes, path: str) -> CodeType:
    """Return the code of a module, with a probe at the start of each function, branch and loop."""
    tree = ast.parse(source, path)
    numbers = count(len(REACHED))
    for node in [*ast.walk(tree)]:
        for block in _blocks_of(node):
            block.insert(_begin_of(node, block), _probe(next(numbers), node))
    REACHED.extend(bytes(next(numbers) - len(REACHED)))
    code: CodeType = compile(ast.fix_missing_locations(tree), path, "exec", dont_inherit=True)
    return code


def _blocks_of(node: ast.AST) -> list[list[ast.stmt]]:
    """The blocks of a statement that are not always run. An `if` without `else` gets one: to be left out counts too."""
    if isinstance(node, (*_FUNCTIONS, ast.ExceptHandler, ast.match_case)):
        return [node.body]
    if isinstance(node, ast.If | ast.For | ast.AsyncFor | ast.While):
        return [node.body, node.orelse]
    return [node.orelse] if isinstance(node, ast.Try) and node.orelse else []


def _begin_of(node: ast.AST, block: list[ast.stmt]) -> int:
    """The index of the first statement that is not the docstring of a function."""
    is_documented = isinstance(node, _FUNCTIONS) and ast.get_docstring(node, clean=False) is not None
    return int(is_documented and block is node.body)


def _probe(number: int, near: ast.AST) -> ast.stmt:
    place = ast.Subscript(ast.Name(_NAME, ast.Load()), ast.Constant(number), ast.Store())
    probe = ast.Assign([place], ast.Constant(1))
    for node in ast.walk(probe):
        if isinstance(node, ast.stmt | ast.expr):
            line = getattr(near, "lineno", 1)
            node.lineno, node.end_lineno, node.col_offset, node.end_col_offset = line, line, 0, 0
    return probe
