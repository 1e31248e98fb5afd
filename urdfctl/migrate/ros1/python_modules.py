"""The modules of a package that setup.py installs in ROS 1, by catkin_python_setup()."""

from __future__ import annotations

import os
import re
from collections.abc import Iterator

from urdfctl.migrate.packages import MigratedPackages
from urdfctl.source.disk.gate import exists

_PACKAGES = r"\bpackages(?:['\"]\s*\])?\s*=\s*\[([^\]]*)\]"
_NAME = r"['\"]([\w.]+)['\"]"
_FOLDERS = ("src", "", "python", "lib")


def python_rules(packages: MigratedPackages, folder: str, name: str) -> list[str]:
    """Return the rules that install the Python modules of a package; empty if they are not found.

    name: that of the package.
    """
    modules = list(_installed(folder, _names(packages, folder, name)))
    return ["find_package(ament_cmake_python REQUIRED)", *modules] if modules else []


def may_have_modules(packages: MigratedPackages, folder: str, name: str) -> bool:
    """Return whether a package may have files of the modules that its setup.py names, wherever they are."""
    names = _names(packages, folder, name)
    inside = [os.path.relpath(path, folder) for path in packages.files(".py") if path.startswith(folder + os.sep)]
    parts = (part for path in inside for part in path.split(os.sep))
    return "setup.py" not in inside or any(os.path.splitext(part)[0] in names for part in parts)


def _names(packages: MigratedPackages, folder: str, name: str) -> list[str]:
    setup = packages.read(os.path.join(folder, "setup.py")).data.decode("utf-8", "replace")
    found = re.search(_PACKAGES, setup)
    names = re.findall(_NAME, found[1]) if found else [name]
    return list(dict.fromkeys(each.partition(".")[0] for each in names))


def _installed(folder: str, names: list[str]) -> Iterator[str]:
    """Yield the rule of each module that is in the package."""
    for name in names:
        paths = (os.path.join(each, name) for each in _FOLDERS)
        path = next((path for path in paths if exists(os.path.join(folder, path, "__init__.py"))), None)
        if path is not None:
            place = "" if path == name else f" PACKAGE_DIR {path.replace(os.sep, '/')}"
            yield f"ament_python_install_package({name}{place})"
