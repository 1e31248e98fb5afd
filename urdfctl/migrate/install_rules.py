"""The rules in CMakeLists.txt that install the folders of a package."""

from __future__ import annotations

import re

BRIDGE_FILE = "config/bridge.yaml"
"""The new file for ros_gz_bridge, which one step writes and another installs."""


def installs(text: str, folder: str) -> bool:
    """Return whether a build file has an install rule that names a folder, or takes folders from a variable."""
    rules = re.findall(r"(?s)install\s*\((?:[^()]|\([^()]*\))*\)", re.sub(r"#.*", "", text))
    lists = re.findall(r"(?s)foreach\s*\(.*?\)", text)
    return any(re.search(rf"(?<![\w/]){folder}\b|\$\{{dir", rule) for rule in [*rules, *lists])


def install_rule(*folders: str) -> str:
    """Return the rule that installs folders of a package."""
    return f"install(DIRECTORY {' '.join(folders)}\n  DESTINATION share/${{PROJECT_NAME}}\n)\n"
