"""A module that is imported when an attribute of it is read.

Saves: `datetime` and `base64`, which PyYAML imports and hardly uses, take 1.5 ms; `ast` and `glob` of xacro take more.
"""

from __future__ import annotations

import importlib
from types import ModuleType
from typing import Any


class LazyModule(ModuleType):
    """Has the attributes of the module of its name."""

    def __getattr__(self, name: str) -> Any:
        return getattr(importlib.import_module(self.__name__), name)
