"""PyYAML, imported without compiling its regular expressions.

Saves: PyYAML compiles two dozen patterns on import, one of them a class of all printable Unicode characters. This takes
as long as the rest of the import. Most of them are not used when libyaml does the reading, so each is compiled on first
use.
"""

from __future__ import annotations

import re
import sys
from importlib import import_module

from urdfctl.startup.hints import Any
from urdfctl.startup.patterns import LazyPattern

_STANDARD_MODULES = ("base64", "binascii", "codecs", "datetime", "weakref")
"""Modules that PyYAML imports. They are imported before `re.compile` is replaced, so that their patterns are normal."""


def load() -> Any:
    """Return the `yaml` module; if it is imported already, as it is."""
    imported = sys.modules.get("yaml")
    if imported is not None:
        return imported
    for name in _STANDARD_MODULES:
        import_module(name)
    original = re.compile
    re.compile = LazyPattern  # type: ignore[assignment]
    try:
        import yaml
    finally:
        re.compile = original
    return yaml


yaml = load()
