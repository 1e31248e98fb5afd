"""CMakeLists.txt of packages without compiled code: ament and install rules."""

from __future__ import annotations

import os
import re
from collections.abc import Iterator

from urdfctl.diagnostic import Edit
from urdfctl.migrate.packages import MigratedPackages
from urdfctl.migrate.ros1.python_modules import may_have_modules, python_rules
from urdfctl.migrate.ros1.used_files import programs_in, used_in
from urdfctl.migrate.shared.install_rules import BRIDGE_FILE, install_rule, installs
from urdfctl.migrate.step import EntryKind, Proposal, ReportEntry
from urdfctl.source.disk.gate import exists, is_folder, names_in
from urdfctl.source.span import SourceSpan, SourceText

_AUTHORITY = "docs.ros.org, Migrating packages from ROS 1 to ROS 2"
_FOLDERS = ("config", "launch", "meshes", "models", "params", "robots", "rviz", "sdf", "urdf", "worlds", "xacro")
_AMENT = "find_package(ament_cmake REQUIRED)"
_ARGUMENTS = r"\((?:[^()]|\([^()]*\))*\)"
_PYTHON = "catkin_python_setup"
_TESTS = r"(add_rostest(?:_gtest|_gmock)?|catkin_add_(?:gtest|gmock|nosetests))"
_REPLACED = (
    (r"cmake_minimum_required\s*\(\s*VERSION\s+(?:2\.|3\.[0-4]\b)[\d.]*", "cmake_minimum_required(VERSION 3.8"),
    (rf"find_package\s*(?=\(\s*catkin\b){_ARGUMENTS}", _AMENT),
    (r"\$\{CATKIN_PACKAGE_SHARE_DESTINATION\}", "share/${PROJECT_NAME}"),
    (r"\$\{CATKIN_(?:PACKAGE|GLOBAL)_BIN_DESTINATION\}(?:/[\w./-]*)?", "lib/${PROJECT_NAME}"),
    (r"\$\{CATKIN_(?:PACKAGE|GLOBAL)_LIB_DESTINATION\}", "lib"),
    (r"\$\{CATKIN_PACKAGE_INCLUDE_DESTINATION\}", "include/${PROJECT_NAME}"),
    (r"\bcatkin_install_python\b", "install"),
    (r"\bCATKIN_ENABLE_TESTING\b", "BUILD_TESTING"),
    (r"\.launch(?=[\s)\"])(?!\.py)", ".launch.py"),
)
_REMOVED = (
    rf"catkin_package\s*{_ARGUMENTS}",
    rf"catkin_metapackage\s*{_ARGUMENTS}",
    r"ament_package\s*\(\s*\)",
    rf"{_PYTHON}\s*{_ARGUMENTS}",
    rf"(?:roslaunch_add_file_check|roslint_(?:cpp|python|add_test|custom))\s*{_ARGUMENTS}",
    rf"{_TESTS}\s*{_ARGUMENTS}",
    r"find_package\s*\(\s*(?:roslaunch|roslint|rostest|rosunit)\b[^)]*\)",
    r"include_directories\s*\(\s*\$\{catkin_INCLUDE_DIRS\}\s*\)",
)
_OF_CLASSIC = (r"find_package\s*\(\s*gazebo(?:_dev|_ros|_plugins)?\b[^)]*\)",)
_INSTALLS = (
    r"\b(?:catkin_install_python|install)\s*\(\s*(?:PROGRAMS|FILES|DIRECTORY)\s+([^()]*?)\s+DESTINATION\b[^()]*\)"
)
_OF_CATKIN = "generate_dynamic_reconfigure_options|download_test_data|roslaunch_add_file_check"
_INSTALLED = "cmake-commands: install(FILES) ends with an error where a file is missing; colcon installs each package"
_TESTING = "docs.ros.org, launch_testing: tests that start processes"
_NO_MODULES = (
    "setup.py installed the Python modules: install them by ament_python_install_package(NAME PACKAGE_DIR DIR)"
)
_EMPTY_TESTS = r"(?ims)^if\s*\(BUILD_TESTING\)\s*endif\s*\(\s*(?:BUILD_TESTING)?\s*\)[ \t]*\n?"


def ament_build_file(packages: MigratedPackages, source: SourceText, *, name: str, is_classic: bool) -> Proposal:
    """Return the proposal to build a package by ament, and to install what launch files need.

    name: that of the package.
    is_classic: whether Gazebo Classic simulates the robot, so that it may be looked for.
    """
    old = text = source.data.decode("utf-8", "surrogateescape")
    for pattern, replacement in _REPLACED:
        text = _outside_comments(text, pattern, replacement)
    for call in (*_REMOVED, *(() if is_classic else _OF_CLASSIC)):
        text = re.sub(rf"(?im)^[ \t]*{call}[ \t]*(?:#[^\n]*)?\n?", "", text)
    if not re.search(rf"(?m)^\s*{re.escape(_AMENT)}", text):
        text = _outside_comments(text, rf"project\s*{_ARGUMENTS}", rf"\g<0>\n\n{_AMENT}", count=1)
    text = re.sub(_EMPTY_TESTS, "", text)
    text = re.sub(r"\n{3,}", "\n\n", text).rstrip("\n") + "\n"
    folder = os.path.dirname(source.path)
    has_modules = any(_matches(old, rf"{_PYTHON}\b"))
    modules = python_rules(packages, folder, name) if has_modules else []
    text += "".join(f"\n{rule}" for rule in _rules(packages, folder, name, text))
    text += "".join(f"{line}\n" for line in ["", *modules]) if modules else ""
    text += _header_rules(folder, old, text)
    text += "\nament_package()\n"
    what = "the build file uses ament_cmake and installs what launch files need"
    entries = [ReportEntry(EntryKind.DONE, what, file=source.path, authority=_AUTHORITY)]
    if has_modules and not modules and may_have_modules(packages, folder, name):
        entries.append(ReportEntry(EntryKind.FOR_YOU, _NO_MODULES, file=source.path, authority=_AUTHORITY))
    entries += _left(source, old)
    entries += _unknown(source, old, text)
    return Proposal((Edit(SourceSpan(source, 0, len(source.data)), text),), entries=tuple(entries))


def _left(source: SourceText, old: str) -> Iterator[ReportEntry]:
    """Yield what is left to a person: tests of catkin, and what does not exist."""
    if tests := sorted({found[1].lower() for found in _matches(old, rf"(?<!\w){_TESTS}\s*\(")}):
        what = f"tests of {', '.join(tests)} no longer run: write them with launch_testing or ament_cmake_pytest"
        yield ReportEntry(EntryKind.FOR_YOU, what, file=source.path, authority=_TESTING)
    for path in dict.fromkeys(_not_there(source)):
        what = f"'{path}' is to be installed, but does not exist, so that colcon cannot install the package: remove it"
        yield ReportEntry(EntryKind.FOR_YOU, what, file=source.path, authority=_INSTALLED)


def _unknown(source: SourceText, old: str, text: str) -> Iterator[ReportEntry]:
    """Yield what only catkin, or a package that it found, defines, and the new build file still names."""
    found = "".join(call[0] for call in _matches(old, rf"find_package\s*(?=\(\s*catkin\b){_ARGUMENTS}"))
    of_packages = "|".join(map(re.escape, {"catkin", *re.findall(r"[a-z][\w-]*", found.partition("COMPONENTS")[2])}))
    commands = {call[1] for call in _matches(text, rf"(?<![\w$])((?:{of_packages})_\w+|{_OF_CATKIN})\s*\(")}
    for name in sorted(commands):
        what = f"'{name}()' came with find_package(catkin): find the package that defines it, or CMake ends there"
        yield ReportEntry(EntryKind.FOR_YOU, what, file=source.path, authority=_AUTHORITY)
    code = re.sub(r"#[^\n]*", "", text)
    for name in sorted({*re.findall(r"\$\{(CATKIN_\w+)\}", code)}):
        what = f"'{name}' is empty without catkin: write another path in its place"
        yield ReportEntry(EntryKind.FOR_YOU, what, file=source.path, authority=_AUTHORITY)


def _header_rules(folder: str, old: str, text: str) -> str:
    """The rules for headers that catkin exported to other packages; empty if it exported none."""
    calls = _matches(old, rf"catkin_package\s*{_ARGUMENTS}")
    exported = any(re.search(r"\bINCLUDE_DIRS\s+include\b", re.sub(r"#[^\n]*", "", call[0])) for call in calls)
    if not exported or not is_folder(os.path.join(folder, "include")):
        return ""
    installed = re.search(r"DIRECTORY\s+include\b", re.sub(r"#[^\n]*", "", text))
    rule = "" if installed else "install(DIRECTORY include/\n  DESTINATION include\n)\n"
    return f"\n{rule}ament_export_include_directories(include)\n"


def _rules(packages: MigratedPackages, folder: str, name: str, text: str) -> Iterator[str]:
    """Yield the rules for what a build file does not install: usual folders, what files use, and programs."""
    folders, files = used_in(packages, folder, name)
    usual = (one for one in _FOLDERS if _has_files(os.path.join(folder, one)))
    if missing := [one for one in sorted({*usual, *folders}) if not installs(text, one)]:
        yield install_rule(*missing)
    if lost := [one for one in files if one not in text]:
        yield f"install(FILES {' '.join(lost)}\n  DESTINATION share/${{PROJECT_NAME}}\n)\n"
    if programs := programs_in(packages, folder, name, text):
        lines = "".join(f"  {program}\n" for program in programs)
        yield f"install(PROGRAMS\n{lines}  DESTINATION lib/${{PROJECT_NAME}}\n)\n"


def _not_there(source: SourceText) -> Iterator[str]:
    """Yield the files that a build file installs, and that do not exist; a space of catkin for development needs none.

    Launch files have other names afterwards.
    """
    text = source.data.decode("utf-8", "surrogateescape")
    folder = os.path.dirname(source.path)
    for found in _matches(text, _INSTALLS):
        names = [word.strip('"') for word in re.sub(r"#[^\n]*", "", found[1]).split()]
        for name in () if "OPTIONAL" in found[0] else names:
            path = re.sub(r"\A\$\{(?:PROJECT|CMAKE_CURRENT|CMAKE)_SOURCE_DIR\}/", "", name)
            if "$" not in path and not path.endswith(".launch") and not exists(os.path.join(folder, path)):
                yield path


def _outside_comments(text: str, pattern: str, replacement: str, *, count: int = 0) -> str:
    """A text with a pattern replaced, except in comments."""
    parts: list[str] = []
    end = 0
    for found in _matches(text, pattern):
        parts += [text[end : found.start()], found.expand(replacement)]
        end = found.end()
        if count and len(parts) == 2 * count:
            break
    return "".join([*parts, text[end:]])


def _matches(text: str, pattern: str) -> Iterator[re.Match[str]]:
    for found in re.finditer(pattern, text, re.IGNORECASE):  # CMake's commands are read so
        line = text.rfind("\n", 0, found.start()) + 1
        if "#" not in text[line : found.start()]:
            yield found


def _has_files(folder: str) -> bool:
    """Whether a folder has files of its own, not only the one for the bridge, whose step installs it."""
    return is_folder(folder) and set(names_in(folder)) != {os.path.basename(BRIDGE_FILE)}
