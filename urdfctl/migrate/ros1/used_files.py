"""What files of the packages use of a package: ROS 2 finds only what is installed, and roslaunch found everything."""

from __future__ import annotations

import os
import posixpath
import re
from collections.abc import Iterable, Iterator

from urdfctl.migrate.classic.sdf import model_folders
from urdfctl.migrate.packages import MigratedPackages
from urdfctl.source.disk.gate import is_file, is_folder

_TEXTS = (".py", ".xml", ".launch", ".xacro", ".urdf", ".gazebo", ".yaml", ".yml", ".srdf", ".sdf", ".world", ".rviz")
_OF_PACKAGE = re.compile(
    rb"\$\(find(?:-pkg-share)?\s+([\w-]+)\)/([\w.-]+)"
    rb"|(?:package|model)://([\w-]+)/([\w.-]+)"
    rb"|FindPackageShare\(['\"]([\w-]+)['\"]\), ['\"]/([\w.-]+)"
)
_STARTED = re.compile(
    rb"package=\"([\w-]+)\",\s*executable=\"([\w.-]+)\""
    rb"|<node\b(?=[^<>]*?\bpkg=['\"]([\w-]+))(?=[^<>]*?\b(?:exec|type)=['\"]([\w.-]+)['\"])"
)
_IMPORT = re.compile(rb"(?m)^[ \t]*(?:from|import)[ \t]+(\w+)")
_INSTALL = r"(?is)\b(?:catkin_install_python|install)\s*\(((?:[^()]|\([^()]*\))*)\)"
_NO_PROGRAMS = ("cfg", "test", "tests", "msg", "srv", "action")
_ENDINGS = ("", ".py", ".sh", ".bash")


def used_names(packages: MigratedPackages) -> dict[str, frozenset[str]]:
    """Return the files and folders, directly in a package, that files of any package name, by the name of the package."""
    return _pairs(packages, _OF_PACKAGE)


def started_programs(packages: MigratedPackages) -> dict[str, frozenset[str]]:
    """Return the programs that launch files start, by the name of their package."""
    return _pairs(packages, _STARTED)


def _pairs(packages: MigratedPackages, pattern: re.Pattern[bytes]) -> dict[str, frozenset[str]]:
    found: dict[str, set[str]] = {}
    for path in packages.files(*_TEXTS):
        for one in pattern.finditer(packages.read(path).data):
            package, name = (part.decode() for part in one.groups() if part is not None)
            found.setdefault(package, set()).add(name)
    return {package: frozenset(names) for package, names in found.items()}


def used_in(packages: MigratedPackages, folder: str, name: str) -> tuple[list[str], list[str]]:
    """Return the folders and the files, directly in a package, that files of any package use."""
    models = {one.partition("/")[0] for one in packages.found(model_folders).get(folder, ()) if one != os.curdir}
    names = sorted({*packages.found(used_names).get(name, ()), *models})
    paths = {one: os.path.join(folder, one) for one in names if one not in ("package.xml", "CMakeLists.txt")}
    return [one for one, path in paths.items() if is_folder(path)], [
        one for one, path in paths.items() if is_file(path)
    ]


def programs_in(packages: MigratedPackages, folder: str, name: str, build: str) -> list[str]:
    """Return the scripts of a package that its build file does not install, relative to the package.

    They are those that launch files start, and others that may be executed, which rosrun found wherever they are; and
    the modules beside these that they import, because Python looks for these beside the program.
    """
    started = packages.found(started_programs).get(name, frozenset())
    rules = [one[1] for one in re.finditer(_INSTALL, re.sub(r"#[^\n]*", "", build))]
    found = []
    for path in packages.files(*_ENDINGS):
        relative = os.path.relpath(path, folder)
        if relative.startswith(os.pardir) or not packages.read(path).data.startswith(b"#!"):
            continue
        parts = relative.split(os.sep)
        is_wanted = parts[-1] in started or (os.access(path, os.X_OK) and parts[0] not in _NO_PROGRAMS)
        if is_wanted and relative != "setup.py" and not _is_installed(relative.replace(os.sep, "/"), rules):
            found.append(relative.replace(os.sep, "/"))
    modules = (one for one in _imported(packages, folder, found) if not _is_installed(one, rules))
    return [*found, *sorted({*modules} - {*found})]


def _imported(packages: MigratedPackages, folder: str, programs: Iterable[str]) -> Iterator[str]:
    """The modules that programs import from their own folder, and those that these import."""
    waiting, known = list(programs), {*programs}
    while waiting:
        path = waiting.pop()
        for name in dict.fromkeys(_IMPORT.findall(packages.read(os.path.join(folder, path)).data)):
            module = posixpath.join(posixpath.dirname(path), f"{name.decode()}.py")
            if module not in known and is_file(os.path.join(folder, module)):
                known.add(module)
                waiting.append(module)
                yield module


def _is_installed(relative: str, rules: list[str]) -> bool:
    """Whether a rule names a program, or its folder as one with programs, or programs that are not known."""
    folder, _, name = relative.rpartition("/")
    for rule in rules:
        if re.search(rf"(?<![\w.-]){re.escape(name)}(?![\w.-])", rule):
            return True
        is_of_programs = "PROGRAMS" in rule or re.search(r"DESTINATION\s+\S*(?:lib/|BIN_DESTINATION)", rule)
        names_all = re.search(r"(?:PROGRAMS|DIRECTORY)\s+\$\{", rule)
        if is_of_programs and (names_all or (folder and re.search(rf"(?<![\w/]){re.escape(folder)}/?\s", rule))):
            return True
    return False
