"""PyYAML, of which only the reader is imported at first, and without compiling its regular expressions.

Saves: 7 to 8 % of a lint (paired whole processes, median of 21). PyYAML imports a writer, a second reader in Python,
and modules for dates; a run uses the reader in C and the types of scalars. PyYAML also compiles two dozen patterns on
import, one of them a class of all printable Unicode characters, and most are not used when libyaml does the reading.
"""

from __future__ import annotations

import re
import sys
from collections.abc import Callable, Iterator
from importlib import import_module
from importlib.machinery import PathFinder
from types import ModuleType, SimpleNamespace
from typing import Any

from urdfctl.startup.lazy_modules import LazyModule

_STANDARD_MODULES = ("base64", "binascii", "datetime")
"""Modules that PyYAML imports and that its reader hardly uses."""
_MARKED = {"scanner": "ScannerError", "parser": "ParserError", "composer": "ComposerError"}
_PLAIN = {"emitter": "EmitterError", "serializer": "SerializerError", "representer": "RepresenterError"}
"""Parts of PyYAML in Python, and the error that the part in C looks up in each of them when it is imported."""


class LazyPattern:
    """A regular expression that is compiled on first use. Has the attributes of a compiled pattern."""

    def __init__(self, *arguments: Any) -> None:
        self._arguments = arguments

    def __getattr__(self, name: str) -> Any:
        attribute = self.__dict__[name] = getattr(re.compile(*self._arguments), name)
        return attribute


class _Package(ModuleType):
    """PyYAML with its reader. It becomes all of PyYAML when something else is asked for."""

    is_partial = True

    def __getattr__(self, name: str) -> Any:
        if not self.is_partial:
            raise AttributeError(f"module 'yaml' has no attribute '{name}'")
        self.is_partial = False
        for standard in (*_STANDARD_MODULES, "weakref"):
            import_module(standard)
        _with_lazy_patterns(lambda: self.__loader__.exec_module(self))  # type: ignore[union-attr]
        return getattr(self, name)


def load() -> Any:
    """Return the `yaml` module; if it is imported already, as it is."""
    imported = sys.modules.get("yaml")
    if imported is not None:
        return imported
    spec = PathFinder.find_spec("yaml")
    if spec is None:
        return import_module("yaml")
    package = sys.modules["yaml"] = _Package("yaml")
    package.__spec__, package.__loader__, package.__file__ = spec, spec.loader, spec.origin
    package.__package__, package.__path__ = "yaml", spec.submodule_search_locations or []
    _with_lazy_patterns(_import_reader_in_python)
    _add_reader_in_c(package)
    return package


def _import_reader_in_python() -> None:
    """Import the parts that the reader in C needs, with stand-ins for standard modules that are not imported yet."""
    stand_ins = {name: LazyModule(name) for name in _STANDARD_MODULES if name not in sys.modules}
    sys.modules.update(stand_ins)
    try:
        for part in ("error", "nodes", "events", "tokens", "reader", "constructor", "resolver"):
            import_module(f"yaml.{part}")
    finally:
        for name in stand_ins:
            del sys.modules[name]


def _add_reader_in_c(package: Any) -> None:
    """Add the reader in C, if it is installed; without it, all of PyYAML is needed."""
    for errors, base in ((_MARKED, package.error.MarkedYAMLError), (_PLAIN, package.error.YAMLError)):
        for part, name in errors.items():
            setattr(package, part, SimpleNamespace(**{name: type(name, (base,), {})}))
    try:
        in_c = import_module("yaml._yaml")
    except ImportError:
        return
    finally:
        for part in (*_MARKED, *_PLAIN):
            delattr(package, part)

    class CSafeLoader(in_c.CParser, package.constructor.SafeConstructor, package.resolver.Resolver):  # type: ignore[misc,name-defined]
        def __init__(self, stream: str | bytes) -> None:
            in_c.CParser.__init__(self, stream)
            package.constructor.SafeConstructor.__init__(self)
            package.resolver.Resolver.__init__(self)

    package.CSafeLoader, package.load, package.parse = CSafeLoader, _load, _parse
    for part in (package.error, package.nodes, package.events):
        vars(package).update({name: value for name, value in vars(part).items() if not name.startswith("_")})


def _load(text: str | bytes, loader_class: Any) -> Any:
    """Return the value of a text, as `yaml.load` does."""
    loader = loader_class(text)
    try:
        return loader.get_single_data()
    finally:
        loader.dispose()


def _parse(text: str | bytes, loader_class: Any) -> Iterator[Any]:
    """Yield the events of a text, as `yaml.parse` does."""
    loader = loader_class(text)
    try:
        while loader.check_event():
            yield loader.get_event()
    finally:
        loader.dispose()


def _with_lazy_patterns(action: Callable[[], object]) -> None:
    """Do something while `re.compile` returns patterns that are compiled on first use."""
    original = re.compile
    re.compile = LazyPattern  # type: ignore[assignment]
    try:
        action()
    finally:
        re.compile = original


yaml = load()
SAFE_LOADER: Any = yaml.CSafeLoader if hasattr(yaml, "CSafeLoader") else yaml.SafeLoader
"""The safe loader: in C if libyaml is installed."""
