"""Mutation test of the rules: change one thing of a rule at a time, and see whether its examples notice.

    python tests/bench/exhaustive/rule_mutants.py tables|conditions [--sample N] [MODULE ...]

`tables` deletes each row of each table at the top of a module; `conditions` negates each condition, takes it as false,
and drops each part of it, but for what only narrows a type. A mutant meets only the examples of the rules whose modules
import it: what is found in each bad one must stay as tests/rules/reports/ shows it, and nothing be found in a good one.
Prints the mutants that survive. Exits with 1 if a row survives that REASONS does not name, if one that it names is
noticed or gone, or if more than one in ten conditions survive.
"""

from __future__ import annotations

import argparse
import ast
import copy
import importlib
import os
import random
import signal
import sys
import tempfile
import time
from collections.abc import Callable, Collection, Iterable, Iterator, Mapping
from functools import cache, partial
from pathlib import Path
from typing import NamedTuple

ROOT = Path(__file__).parents[3]
RULES = ROOT / "urdfctl" / "rules"
sys.path.insert(0, str(ROOT))

from urdfctl.diagnostic import Diagnostic  # noqa: E402 (of this checkout)
from urdfctl.fault import Fault  # noqa: E402
from urdfctl.lint.engine import lint  # noqa: E402
from urdfctl.lint.examples import written  # noqa: E402
from urdfctl.lint.selection import Selection  # noqa: E402
from urdfctl.load.loader import LoadedTarget, Loader  # noqa: E402
from urdfctl.rules import faults_found_by  # noqa: E402

SECONDS = 20
ENOUGH = 0.9
NOT_RULES = {"__init__", "family", "examples", "readme", "prose", "launch_samples", "samples", "kinds"}
REASONS: dict[str, str] = {
    "urdf.urdf_attribute_not_read: _NAMING without 'child'": "its example would be that of 'parent' again",
    "controllers.controller_type_not_in_distro: _MAINTAINED without *since('humble')": "other evidence than the types",
    "controllers.controller_type_not_in_distro: _MAINTAINED without 'noetic'": "of the distro is needed, or own types",
    "controllers.parameters: _REQUIRING without 'any_set'": "only types that users describe have such a rule",
}
"""Rows that no example needs, as the tool prints them, each with the reason."""


class Mutant(NamedTuple):
    """A changed module: its name after `urdfctl.rules.`, what was changed, and what makes its source."""

    module: str
    what: str
    source: Callable[[], str]

    @property
    def name(self) -> str:
        """How it is printed."""
        return f"{self.module}: {self.what}"


# -- the mutants -----------------------------------------------------------------------------------------------------


@cache
def modules() -> tuple[str, ...]:
    """Return the names of the modules of rules, and of what they share."""
    paths = (path.relative_to(RULES).with_suffix("") for path in sorted(RULES.rglob("*.py")))
    return tuple(".".join(path.parts) for path in paths if path.parts[0] != "smoke" and path.name not in NOT_RULES)


@cache
def tree_of(module: str) -> ast.Module:
    """Return the syntax tree of a module."""
    return ast.parse((RULES / f"{module.replace('.', '/')}.py").read_text(encoding="utf-8"))


def rows(module: str) -> Iterator[Mutant]:
    """Yield a mutant for each row of each table at the top of a module that a function uses."""
    tree = tree_of(module)
    used = _used(tree)
    for statement in tree.body:
        if not isinstance(statement, ast.Assign | ast.AnnAssign) or statement.value is None:
            continue
        target = statement.targets[0] if isinstance(statement, ast.Assign) else statement.target
        if not isinstance(target, ast.Name) or not (target.id in used or _is_imported(module, target.id)):
            continue
        for node in _walked(statement.value):
            for index, row in enumerate(_rows(node)):
                source = partial(_changed, tree, node, lambda n, i=index: _without(n, i))
                yield Mutant(module, f"{target.id} without {row}", source)


def _walked(node: ast.AST) -> Iterator[ast.AST]:
    """A node and those in it, but for types."""
    yield node
    if not isinstance(node, ast.Subscript):
        for child in ast.iter_child_nodes(node):
            yield from _walked(child)


def _used(tree: ast.Module) -> set[str]:
    """The names of a module that its functions use, directly or in another table; not those of examples only."""
    assigned: dict[str, set[str]] = {}
    used: set[str] = set()
    for statement in tree.body:
        if isinstance(statement, ast.FunctionDef):
            used |= {name for part in statement.body for name in _names(part)}
        elif isinstance(statement, ast.ClassDef):
            used |= _names(statement)
        elif isinstance(statement, ast.Assign | ast.AnnAssign) and statement.value is not None:
            targets = statement.targets if isinstance(statement, ast.Assign) else [statement.target]
            for target in targets:
                assigned.setdefault(ast.unparse(target), set()).update(_names(statement.value))
    while more := {name for table in used & set(assigned) for name in assigned[table]} - used:
        used |= more
    return used


def _names(node: ast.AST) -> set[str]:
    return {part.id for part in ast.walk(node) if isinstance(part, ast.Name)}


def _rows(node: ast.AST) -> list[str]:
    """The rows of a table, as they are printed."""
    if isinstance(node, ast.Dict):
        return [ast.unparse(key)[:60] if key else "**" for key in node.keys]
    if isinstance(node, ast.Set | ast.List | ast.Tuple):
        return [ast.unparse(element)[:60] for element in node.elts]
    return [repr(word) for word in _words(node)]


def _words(node: ast.AST) -> list[str]:
    """The words of "...".split()."""
    if isinstance(node, ast.Call) and isinstance(node.func, ast.Attribute) and node.func.attr == "split":
        text = node.func.value
        return text.value.split() if isinstance(text, ast.Constant) and isinstance(text.value, str) else []
    return []


def _without(node: ast.AST, index: int) -> ast.AST:
    if isinstance(node, ast.Dict):
        del node.keys[index], node.values[index]
        return node
    if isinstance(node, ast.Set) and len(node.elts) == 1:
        return ast.parse("set()", mode="eval").body
    if isinstance(node, ast.Set | ast.List | ast.Tuple):
        del node.elts[index]
        return node
    words = _words(node)
    return ast.Call(ast.Attribute(ast.Constant(" ".join(words[:index] + words[index + 1 :])), "split"), [], [])


def conditions(module: str) -> Iterator[Mutant]:
    """Yield mutants of each condition in the functions of a module."""
    tree = tree_of(module)
    for function in (statement for statement in tree.body if isinstance(statement, ast.FunctionDef)):
        for part in function.body:
            for node in ast.walk(part):
                for test in _tests(node):
                    shown = f"line {test.lineno}: {ast.unparse(test)[:80]}"
                    negated = partial(_changed, tree, test, lambda n: ast.UnaryOp(ast.Not(), n))
                    yield Mutant(module, f"{shown} -> not", negated)
                    if not _narrows(test):
                        false = partial(_changed, tree, test, lambda _: ast.Constant(False))
                        yield Mutant(module, f"{shown} -> False", false)
                if isinstance(node, ast.BoolOp):
                    for index, operand in enumerate(node.values):
                        if _narrows(operand):
                            continue
                        shown = f"line {node.lineno}: {ast.unparse(node)[:80]}"
                        what = f"{shown} without {ast.unparse(operand)[:60]}"
                        dropped = partial(_changed, tree, node, lambda n, i=index: _dropped(n, i))
                        yield Mutant(module, what, dropped)


def _narrows(node: ast.expr) -> bool:
    """Whether an expression is there for the type checker, which notices if it is not: `x is None`, or a default."""
    is_default = isinstance(node, ast.Constant) or (isinstance(node, ast.Tuple | ast.List) and not node.elts)
    against = node.comparators[0] if isinstance(node, ast.Compare) else None
    return is_default or (isinstance(against, ast.Constant) and against.value is None)


def _tests(node: ast.AST) -> list[ast.expr]:
    if isinstance(node, ast.If | ast.IfExp | ast.While):
        return [node.test]
    return node.ifs if isinstance(node, ast.comprehension) else []


def _dropped(node: ast.AST, index: int) -> ast.AST:
    assert isinstance(node, ast.BoolOp)
    del node.values[index]
    return node if len(node.values) > 1 else node.values[0]


def _changed(tree: ast.Module, node: ast.AST, change: object) -> str:
    """The source of a module in which a node is changed."""
    assert callable(change)
    number = list(ast.walk(tree)).index(node)
    made = copy.deepcopy(tree)
    target = list(ast.walk(made))[number]

    class Replacing(ast.NodeTransformer):
        def visit(self, visited: ast.AST) -> ast.AST:
            return change(visited) if visited is target else self.generic_visit(visited)

    return ast.unparse(ast.fix_missing_locations(Replacing().visit(made)))


# -- who uses a module -----------------------------------------------------------------------------------------------


@cache
def _imports(module: str) -> Mapping[str, frozenset[str]]:
    """The modules of rules that a module imports, each with the names."""
    found: dict[str, set[str]] = {}
    for node in ast.walk(tree_of(module)):
        if isinstance(node, ast.ImportFrom) and (node.module or "").startswith("urdfctl.rules."):
            name = (node.module or "").removeprefix("urdfctl.rules.")
            found.setdefault(name, set()).update(alias.name for alias in node.names)
    return {name: frozenset(names) for name, names in found.items()}


@cache
def _is_imported(module: str, name: str) -> bool:
    return any(name in _imports(other).get(module, ()) for other in modules())


@cache
def users(module: str) -> frozenset[str]:
    """Return a module and all that import it, directly or not."""
    found = {module}
    while more := {other for other in modules() if not found.isdisjoint(_imports(other))} - found:
        found |= more
    return frozenset(found)


# -- the examples ----------------------------------------------------------------------------------------------------


class Example(NamedTuple):
    """An example of a fault, loaded."""

    fault: Fault
    number: int
    is_bad: bool
    loaded: LoadedTarget

    def found(self, codes: tuple[str, ...]) -> list[Diagnostic]:
        """Return the findings of some rules."""
        sources = list(self.loaded.sources.values())
        return lint(self.loaded.project, sources, Selection(codes)).diagnostics

    def fails(self, codes: tuple[str, ...], unchanged: Mapping[int, list[Diagnostic]]) -> bool:
        """Return whether a test of it fails. unchanged: what is found in each example without a mutant."""
        if not self.is_bad:
            return bool(self.found(codes))
        return [finding for finding in self.found(codes) if finding.code == self.fault.code] != unchanged[self.number]


def loaded_examples(folder: str, of: Collection[str]) -> list[Example]:
    """Return the examples of the rules in some modules, written to a folder and loaded."""
    made: list[Example] = []
    for fault in faults_found_by("lint"):
        if fault.code in ("UC000", "UC099") or fault.module not in of:  # two are about the run, not found by a check
            continue
        for is_bad, examples in ((True, fault.bad), (False, fault.good)):
            for example in examples:
                target, settings = written(example, os.path.join(folder, str(len(made))))
                made.append(Example(fault, len(made), is_bad, Loader(settings).load(target)))
    return made


# -- the run ---------------------------------------------------------------------------------------------------------


class Bench:
    """The examples of the rules that some mutants concern, and what the bad ones show unchanged."""

    def __init__(self, folder: str, mutants: Iterable[Mutant]) -> None:
        concerned = {
            f"urdfctl.rules.{name}" for module in {mutant.module for mutant in mutants} for name in users(module)
        }
        self.examples = loaded_examples(folder, concerned)
        bad = (example for example in self.examples if example.is_bad)
        self.unchanged = {example.number: example.found((example.fault.code,)) for example in bad}

    def survives(self, mutant: Mutant) -> bool:
        """Return whether no example notices a mutant."""
        child = os.fork()
        if not child:
            self._meet(mutant)
        deadline = time.monotonic() + SECONDS
        while time.monotonic() < deadline:
            done, status = os.waitpid(child, os.WNOHANG)
            if done:
                return status == 0
            time.sleep(0.002)
        os.kill(child, signal.SIGKILL)
        os.waitpid(child, 0)
        return False

    def _meet(self, mutant: Mutant) -> None:
        """Exit with 0 if no example notices the mutant, else with 1."""
        try:
            again = {f"urdfctl.rules.{name}" for name in users(mutant.module)}
            families = [name for name in sys.modules if name.startswith("urdfctl.rules.") and name.endswith(".family")]
            for name in (*again, *families):
                sys.modules.pop(name, None)
            name = f"urdfctl.rules.{mutant.module}"
            module = type(sys)(name)
            module.__file__ = str(RULES / f"{mutant.module.replace('.', '/')}.py")
            sys.modules[name] = module
            exec(compile(mutant.source(), module.__file__, "exec"), module.__dict__)  # noqa: S102 (that is the point)
            for dependant in sorted(again):
                importlib.import_module(dependant)
            codes = tuple(sorted(e.fault.code for e in self.examples if e.fault.module in again))
            of_rules = [example for example in self.examples if example.fault.module in again]
            failed = any(example.fails(codes, self.unchanged) for example in of_rules)
        except BaseException:  # noqa: BLE001 (whatever the mutant does, it is noticed)
            failed = True
        os._exit(1 if failed else 0)


def main() -> int:
    """Test the mutants of the modules named in the arguments, or of all modules."""
    parser = argparse.ArgumentParser(description="Mutation test of the rules.")
    parser.add_argument("what", choices=["tables", "conditions"])
    parser.add_argument("modules", nargs="*", help="e.g. urdf.axis_zero or urdf; default: all")
    parser.add_argument("--sample", type=int, default=0, help="only so many mutants, drawn at random")
    parser.add_argument("--seed", type=int, default=1)
    options = parser.parse_args()
    make = rows if options.what == "tables" else conditions
    wanted = [
        name
        for name in modules()
        if not options.modules or any(f"{name}.".startswith(f"{given}.") for given in options.modules)
    ]
    mutants = [mutant for module in wanted for mutant in make(module)]
    if options.sample:
        mutants = random.Random(options.seed).sample(mutants, min(options.sample, len(mutants)))  # noqa: S311 (a sample)
    with tempfile.TemporaryDirectory() as folder:
        bench = Bench(os.path.realpath(folder), mutants)
        changed = sorted({mutant.module for mutant in mutants})
        for module in changed[:1] if options.sample else changed:
            unchanged = Mutant(module, "unchanged", partial(ast.unparse, tree_of(module)))
            assert bench.survives(unchanged), f"the examples fail without a mutant of {module}"
        survivors = []
        for mutant in mutants:
            if bench.survives(mutant):
                survivors.append(mutant.name)
                print(mutant.name, REASONS.get(mutant.name, ""), flush=True)
    print(f"{len(mutants) - len(survivors)} of {len(mutants)} mutants killed")
    if options.what == "tables":
        known = {name for name in REASONS if name.partition(":")[0] in wanted}
        return 0 if set(survivors) == known or (options.sample and known.issuperset(survivors)) else 1
    return 0 if len(mutants) - len(survivors) >= ENOUGH * len(mutants) else 1


if __name__ == "__main__":
    raise SystemExit(main())
