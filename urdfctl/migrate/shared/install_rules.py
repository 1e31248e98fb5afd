"""The rules in CMakeLists.txt and setup.py that install the folders and files of a package."""

from __future__ import annotations

import ast
import os
import re
from collections.abc import Iterable

from urdfctl.diagnostic import Edit
from urdfctl.migrate.edits.python_edits import PythonFile, keyword
from urdfctl.source.lengths import Room
from urdfctl.source.span import SourceText

BRIDGE_FILE = "config/bridge.yaml"
"""The new file for ros_gz_bridge, which one step writes and another installs."""
_INSTALL = r"(?is)install\s*\((?:[^()]|\([^()]*\))*\)"
_ELSEWHERE = r"(?i)DESTINATION\s+[\"']?(?:include|bin|\$\{CATKIN_PACKAGE_INCLUDE_DESTINATION\})(?!\w)"
"""A rule for a folder in which nothing of a package is looked for, except what is compiled."""


def installs(text: str, folder: str) -> bool:
    """Return whether a build file has an install rule that names a folder, or takes folders from an unknown list."""
    text = _with_lists(re.sub(r"#.*", "", text))
    rules = [rule for rule in re.findall(_INSTALL, text) if not re.search(_ELSEWHERE, rule)]
    lists = re.findall(r"(?is)foreach\s*\(.*?\)", text)
    if any(re.search(rf"(?<![\w/]){folder}\b", part) for part in [*rules, *lists]):
        return True
    is_known = bool(lists) and not any("$" in each for each in lists)
    return not is_known and any("${dir" in rule for rule in rules)


def _with_lists(text: str) -> str:
    """A build file with the variables that it sets once replaced by their values: lists of folders, mostly."""
    values: dict[str, list[str]] = {}
    for name, value in re.findall(r"(?i)\bset\s*\(\s*(\w+)\s+([^()]*)\)", text):
        values.setdefault(name, []).append(value)
    known = {name: found[0] for name, found in values.items() if len(found) == 1}
    room = Room()
    return re.sub(r"\$\{(\w+)\}", lambda match: room.take(known[match[1]]) if match[1] in known else match[0], text)


def install_rule(*folders: str) -> str:
    """Return the rule that installs folders of a package."""
    return f"install(DIRECTORY {' '.join(folders)}\n  DESTINATION share/${{PROJECT_NAME}}\n)\n"


def in_setup(source: SourceText, package: str, files: Iterable[str]) -> Edit | None:
    """Return the edit with which a setup.py installs some files of its package too; None if it has no list for that."""
    file = PythonFile(source)
    for call, scope in file.calls("setup"):
        given = keyword(call, "data_files")
        listed = file.value_of(given.value, scope) if given is not None else None
        if isinstance(listed, ast.List):
            folders = ((os.path.dirname(f"share/{package}/{one}"), one) for one in files)
            return file.appended(listed, [f'("{folder}", ["{one}"])' for folder, one in folders])
    return None
