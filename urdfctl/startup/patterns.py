"""Regular expressions that are compiled on first use.

Saves: compiling one takes 0.1 to 0.5 ms, and a run uses a third of those in the modules that it imports.
"""

from __future__ import annotations

import re

from urdfctl.startup.hints import TYPE_CHECKING, Any


class LazyPattern:
    """Has the attributes of a compiled pattern."""

    def __init__(self, *arguments: Any) -> None:
        self._arguments = arguments

    def __getattr__(self, name: str) -> Any:
        attribute = self.__dict__[name] = getattr(re.compile(*self._arguments), name)
        return attribute


if TYPE_CHECKING:
    lazy_pattern = re.compile
else:
    lazy_pattern = LazyPattern
"""Use it like `re.compile`, for patterns in a module."""
