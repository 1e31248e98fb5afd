"""Substitutes for modules that xacro imports but hardly uses: minidom, ast, copy, glob and yaml take 35 ms to import.

They are given to the private copy of xacro only (source/xacro/private_module.py).
"""

from __future__ import annotations

import importlib
from types import ModuleType, SimpleNamespace
from xml.dom import Node, NotFoundErr

from urdfctl.startup.hints import Any


def import_what_xacro_uses(name: str, *rest: Any) -> Any:
    """Import a module as `__import__` does, or return its stand-in."""
    return _STAND_INS[name] if name in _STAND_INS else __import__(name, *rest)


class _Lazy(ModuleType):
    """A module that is imported when an attribute of it is read."""

    def __getattr__(self, name: str) -> Any:
        return getattr(importlib.import_module(self.__name__), name)


def _write_data(_writer: object, _text: object) -> None:
    """Minidom's function of that name before Python 3.13, as far as xacro looks."""


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
"""minidom: our own tree replaces it; of what xacro takes from it at import, nothing is used. copy: xacro copies only
lists. ast, glob, yaml: hardly ever used."""
