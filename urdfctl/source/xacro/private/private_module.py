"""A private copy of the installed xacro package, whose helpers can be replaced without an effect on other code.

xacro keeps its state in module globals and looks up its helpers there at call time. So each expansion gets its own
module objects, which are never in `sys.modules`: they are gone with the expansion.
"""

from __future__ import annotations

import builtins
import itertools
import os
import sys
from collections.abc import Mapping
from functools import lru_cache
from importlib.machinery import SourceFileLoader
from types import CodeType, ModuleType
from typing import Any

from urdfctl.errors import UserError
from urdfctl.source.xacro.private.stand_ins import import_what_xacro_uses

KNOWN_VERSIONS = "2.1.0 and 2.1.1"
REQUIRED = (
    "LEXER NameSpace QuickLexer Table XacroException YamlListWrapper ConstructUnits _empty_text_node "
    "abs_filename_spec all_includes check_attrs create_global_symbols eval_all eval_extension eval_text "
    "get_boolean_value grab_macro grab_property handle_macro_call init_stacks is_valid_name load_yaml "
    "parse parse_macro_arg print_location process_doc process_include replace_node resolve_macro "
    "safe_eval substitution_args_context"
).split()
_numbers = itertools.count()
_PYTHONPATH = os.environ.get("PYTHONPATH", "")
"""PYTHONPATH at the start of the run: workers load xacro with a reduced environment."""


@lru_cache(1)
def location_of_xacro() -> str:
    """Return the folder of the xacro package. The package of this installation comes before one in PYTHONPATH, because
    a sourced ROS environment has its own, older xacro."""
    foreign = {os.path.abspath(p) for p in _PYTHONPATH.split(os.pathsep) if p}
    entries = [entry or os.curdir for entry in sys.path[0:]]
    ours = [entry for entry in entries if os.path.abspath(entry) not in foreign]
    for entry in ours + entries:
        folder = os.path.join(entry, "xacro")
        if os.path.isfile(os.path.join(folder, "__init__.py")) and os.path.isfile(os.path.join(folder, "xmlutils.py")):
            return folder
    raise UserError("the package xacro is not installed: pip install 'xacro>=2.1,<3'")


@lru_cache(4)
def code_of_part(part: str) -> CodeType:
    """Return the compiled code of a module of the xacro package."""
    loader = SourceFileLoader(f"xacro.{part}", os.path.join(location_of_xacro(), f"{part}.py"))
    code = loader.get_code(f"xacro.{part}")
    if code is None:  # pragma: no cover (a source file always has code)
        raise UserError(f"the package xacro at {location_of_xacro()} cannot be loaded")
    return code


class _OtherModules(dict[str, ModuleType]):
    """The other modules of a private xacro by name, each executed when it is first imported."""

    def __init__(self, package: str) -> None:
        self._package = package
        command_line = self["cli"] = ModuleType(f"{package}.cli")  # never used here, and optparse is slow to import
        command_line.process_args = None  # type: ignore[attr-defined]

    def __missing__(self, part: str) -> ModuleType:
        made = self[part] = _executed(ModuleType(f"{self._package}.{part}"), part, self)
        return made


def load() -> ModuleType:
    """Return a new private xacro module. UserError if the installed version is not supported."""
    module = ModuleType(f"_urdfctl_xacro_{next(_numbers)}")
    module.__file__ = os.path.join(location_of_xacro(), "__init__.py")
    module._parts = _OtherModules(module.__name__)  # type: ignore[attr-defined]
    _executed(module, "__init__", module._parts)
    missing = [needed for needed in REQUIRED if not hasattr(module, needed)]
    if missing:
        where = f"the package xacro at {location_of_xacro()}"
        raise UserError(f"{where} is of an unknown version (no '{missing[0]}'); known are {KNOWN_VERSIONS}")
    return module


def substitutions(module: ModuleType) -> ModuleType:
    """Return the module of a private xacro that resolves `$(...)`."""
    parts: _OtherModules = module._parts
    return parts["substitution_args"]


def _executed(module: ModuleType, part: str, parts: Mapping[str, ModuleType]) -> ModuleType:
    """Execute the code of a part of xacro in a module, which finds the others in `parts` and not in `sys.modules`."""

    def import_(imported: str, outer: Any = None, inner: Any = None, names: Any = (), level: int = 0) -> Any:
        return parts[imported] if level else import_what_xacro_uses(imported, outer, inner, names)

    module.__dict__["__builtins__"] = {**vars(builtins), "__import__": import_}
    exec(code_of_part(part), module.__dict__)  # noqa: S102 (the installed package's own code)
    return module
