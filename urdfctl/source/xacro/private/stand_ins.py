"""Substitutes for modules that xacro imports but hardly uses: minidom, ast, copy, glob and yaml take 35 ms to import.

They are given to the private copy of xacro only (source/xacro/private/private_module.py).
"""

from __future__ import annotations

from types import SimpleNamespace
from typing import Any

from urdfctl.startup.lazy_modules import LazyModule


class NotFoundErr(Exception):
    """A node does not have the child or the attribute. Stands in for the error of `xml.dom`, which takes 0.6 ms."""


def import_what_xacro_uses(name: str, *rest: Any) -> Any:
    """Import a module as `__import__` does, or return its stand-in."""
    return _STAND_INS[name] if name in _STAND_INS else __import__(name, *rest)


def _write_data(_writer: object, _text: object) -> None:
    """Minidom's function of that name before Python 3.13, as far as xacro looks."""


_DOCUMENT = SimpleNamespace(createTextNode=lambda text: text)
_IMPLEMENTATION = SimpleNamespace(createDocument=lambda *_: _DOCUMENT)
_MINIDOM = SimpleNamespace(
    getDOMImplementation=lambda: _IMPLEMENTATION, Element=type("Element", (), {}), _write_data=_write_data
)
_NODE = SimpleNamespace(ELEMENT_NODE=1, TEXT_NODE=3, COMMENT_NODE=8)
_STAND_INS = {
    "xml.dom.minidom": SimpleNamespace(dom=SimpleNamespace(minidom=_MINIDOM, Node=_NODE, NotFoundErr=NotFoundErr)),
    "ast": LazyModule("ast"),
    "copy": SimpleNamespace(deepcopy=list),
    "glob": LazyModule("glob"),
    "yaml": LazyModule("yaml"),
}
"""minidom: our own tree replaces it; of what xacro takes from it at import, nothing is used. copy: xacro copies only
lists. ast, glob, yaml: hardly ever used."""
