"""PyYAML, loaded without its patterns.

While it is imported it compiles two dozen of them, one a class of all printable characters of Unicode, which takes as
long as all else of the import. Where libyaml reads, nobody asks for most: they are compiled when somebody does.
"""

from __future__ import annotations

import re
import sys
from importlib import import_module

from urdfctl.hints import Any

_OF_PYTHON = ("base64", "binascii", "codecs", "datetime", "weakref")
"""What PyYAML imports of others, whose patterns are to be what they are."""


class _Later:
    """A pattern that is compiled when something is asked of it."""

    def __init__(self, *arguments: Any) -> None:
        self._arguments = arguments

    def __getattr__(self, name: str) -> Any:
        found = self.__dict__[name] = getattr(re.compile(*self._arguments), name)
        return found


def load() -> Any:
    """The module, as `import yaml` would give it."""
    known = sys.modules.get("yaml")
    if known is not None:
        return known
    for name in _OF_PYTHON:
        import_module(name)
    compiled = re.compile
    re.compile = _Later  # type: ignore[assignment]
    try:
        import yaml
    finally:
        re.compile = compiled
    return yaml


yaml = load()
