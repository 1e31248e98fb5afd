"""MuJoCo, imported without the modules that it hardly uses, and without looking for plugins of other packages.

Saves: 45 of 210 ms of processor time (whole processes, best of 7, three times). MuJoCo imports modules for archives and
for programs, and reads the metadata of all installed packages for plugins that no URDF can name.
"""

from __future__ import annotations

import sys
from importlib import import_module
from types import ModuleType
from typing import Any

from urdfctl.startup.lazy_modules import LazyModule

_STANDARD_MODULES = ("ctypes.util", "subprocess", "zipfile")
_OF_PLUGINS = "importlib.metadata"
"""Without it MuJoCo finds no plugins of other packages (mujoco/__init__.py, _load_all_bundled_plugins())."""


def load() -> Any:
    """Return the `mujoco` module; if it is imported already, as it is. Raise ImportError if it is not installed."""
    imported = sys.modules.get("mujoco")
    if imported is not None:
        return imported
    stand_ins: dict[str, ModuleType | None] = {name: LazyModule(name) for name in _STANDARD_MODULES}
    stand_ins[_OF_PLUGINS] = None
    added = {name: module for name, module in stand_ins.items() if name not in sys.modules}
    sys.modules.update(added)  # type: ignore[arg-type]  # None: the import fails
    try:
        return import_module("mujoco")
    finally:
        for name in added:
            del sys.modules[name]
