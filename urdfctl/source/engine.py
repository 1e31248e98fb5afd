"""A private instance of the installed xacro package, whose helpers can be replaced without touching anybody else's.

xacro keeps its state in module globals and looks its helpers up there at call time. So each expansion gets a module
object of its own, which never stands in `sys.modules` under xacro's name.
"""

from __future__ import annotations

import builtins
import importlib
import itertools
import os
import sys
from functools import lru_cache
from importlib.machinery import SourceFileLoader
from types import CodeType, ModuleType, SimpleNamespace
from xml.dom import Node, NotFoundErr

from urdfctl.errors import UserError
from urdfctl.hints import Any

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
"""As the run began with it: where xacro is loaded, in a worker, little of the environment is left."""


@lru_cache(1)
def _location() -> str:
    """The folder of the xacro package to use: one of this installation before one that PYTHONPATH puts in front,
    because a sourced ROS environment brings an older xacro of its own."""
    foreign = {os.path.abspath(p) for p in _PYTHONPATH.split(os.pathsep) if p}
    entries = [entry or os.curdir for entry in sys.path[0:]]
    ours = [entry for entry in entries if os.path.abspath(entry) not in foreign]
    for entry in ours + entries:
        folder = os.path.join(entry, "xacro")
        if os.path.isfile(os.path.join(folder, "__init__.py")) and os.path.isfile(os.path.join(folder, "xmlutils.py")):
            return folder
    raise UserError("the package xacro is not installed: pip install 'xacro>=2.1,<3'")


@lru_cache(3)
def _code(part: str) -> CodeType:
    loader = SourceFileLoader(f"xacro.{part}", os.path.join(_location(), f"{part}.py"))
    code = loader.get_code(f"xacro.{part}")
    if code is None:  # pragma: no cover (a source file always has code)
        raise UserError(f"the package xacro at {_location()} cannot be loaded")
    return code


def load() -> ModuleType:
    """A fresh xacro module. UserError where the installed one is not of a kind that we know how to drive."""
    name = f"_urdfctl_xacro_{next(_numbers)}"
    command_line = ModuleType(f"{name}.cli")  # never used here, and optparse is dear
    command_line.process_args = None  # type: ignore[attr-defined]
    sys.modules[command_line.__name__] = command_line
    module = ModuleType(name)
    module.__package__, module.__path__ = name, [_location()]
    module.__file__ = os.path.join(_location(), "__init__.py")
    sys.modules[name] = module
    _part(f"{name}.xmlutils")
    _run(module, "__init__")
    missing = [needed for needed in REQUIRED if not hasattr(module, needed)]
    if missing:
        where = f"the package xacro at {_location()}"
        raise UserError(f"{where} is of an unknown version (no '{missing[0]}'); known are {KNOWN_VERSIONS}")
    return module


def substitutions(module: ModuleType) -> ModuleType:
    """The module of a private xacro that resolves `$(...)`."""
    return _part(f"{module.__name__}.substitution_args")


def _part(name: str) -> ModuleType:
    """A module of a private xacro, which imports nothing relative to itself."""
    made = ModuleType(name)
    sys.modules[name] = made
    _run(made, name.rpartition(".")[2])
    return made


def _run(module: ModuleType, part: str) -> None:
    module.__dict__["__builtins__"] = {**vars(builtins), "__import__": _import_what_is_used}
    exec(_code(part), module.__dict__)  # noqa: S102 (the installed package's own code)


def _import_what_is_used(name: str, *rest: Any) -> Any:
    return _STAND_INS[name] if name in _STAND_INS else __import__(name, *rest)


class _Lazy(ModuleType):
    """A module that becomes the one of its name when it is asked for anything."""

    def __getattr__(self, name: str) -> Any:
        return getattr(importlib.import_module(self.__name__), name)


def _write_data(_writer: object, _text: object) -> None:
    """What minidom has of that name before Python 3.13, as far as xacro looks."""


_DOCUMENT = SimpleNamespace(createTextNode=lambda text: text)
_IMPLEMENTATION = SimpleNamespace(createDocument=lambda *_: _DOCUMENT)
_MINIDOM = SimpleNamespace(
    getDOMImplementation=lambda: _IMPLEMENTATION, Element=type("Element", (), {}), _write_data=_write_data
)
_STAND_INS = {
    "xml.dom.minidom": SimpleNamespace(dom=SimpleNamespace(minidom=_MINIDOM, Node=Node, NotFoundErr=NotFoundErr)),
    "ast": _Lazy("ast"),
    "copy": SimpleNamespace(deepcopy=list),
    "glob": _Lazy("glob"),
    "yaml": _Lazy("yaml"),
}
"""What xacro imports and is dear. In minidom's place is our own tree: of what xacro takes from it while it is loaded,
nothing is used. It copies only lists of paths, and hardly ever globs or reads YAML."""


def release(module: ModuleType) -> None:
    """Forget a private xacro."""
    for name in [n for n in sys.modules if n == module.__name__ or n.startswith(module.__name__ + ".")]:
        del sys.modules[name]
