"""What a source package installs where: `$(find pkg)/urdf/x` often lies in `description/urdf/x` of the source tree.

Read from the `install()` rules of CMakeLists.txt and from `data_files` of setup.py, as text: neither is ever run.
"""

from __future__ import annotations

import os
import re
from collections.abc import Iterator

from urdfctl.source.files import first_bytes
from urdfctl.source.installed import Installed, below_share, installed

_INSTALL = r"(?si)\binstall\s*\(\s*(DIRECTORY|FILES|PROGRAMS)\s+([^)]*)\)"
_PROJECT = r"(?i)\bproject\s*\(\s*([\w.-]+)"
_ANY_INSTALL = r"(?si)\binstall\s*(\()([^)]*)\)"
_NOT_PLAIN = (
    r"(?i)\b(?:foreach|add_subdirectory|include|function|macro|execute_process|ament_auto_package|catkin_install_python"
    r"|xacro_add_\w+|add_custom_command|add_custom_target|configure_file|install_\w+|\w+_install\w*)\s*\(|INSTALL_TO_SHARE|\bGLOB"
)
_COMMENT = r"#[^\n]*"
_PIECE = r'"([^"]*)"|(\S+)'
_MOST_BYTES = 1 << 20


class InstallMap:
    """The install rules of one package."""

    def __init__(self, folder: str, rules: list[Installed], *, whole: bool = False, makes: bool = False) -> None:
        self.folder = folder
        self.rules = rules
        self.whole = whole
        """Whether these are surely all."""
        self.makes = makes
        """Whether building may make files that are not among the sources."""

    def installs(self, source: str) -> bool | None:
        """Whether a file of the sources is installed, by its path in the package; None where that is not sure."""
        if any(source == rule.source or source.startswith(rule.source.rstrip("/") + "/") for rule in self.rules):
            return True
        return False if self.whole else None

    def source_of(self, relative: str) -> str | None:
        """The existing source file that is installed at a path relative to share/<package>; None where none is."""
        for target, source in self.rules:
            if target and relative != target and not relative.startswith(target + "/"):
                continue
            rest = relative[len(target) :].lstrip("/")
            candidate = os.path.normpath(os.path.join(self.folder, source, rest))
            if os.path.exists(candidate):
                return candidate
        return None


def read_install_map(folder: str, package: str) -> InstallMap:
    """The install rules of the package in a folder; none where it has no build files."""
    cmake = _read(os.path.join(folder, "CMakeLists.txt"))
    cmake = cmake[: cmake.rfind(")") + 1]  # calls that no bracket ends would each be looked for to the end
    setup = _read(os.path.join(folder, "setup.py"))
    rules = list(_from_cmake(cmake, package))
    plain = _is_plain_cmake(cmake, package) if cmake else False
    if setup:
        from urdfctl.source.setup_files import is_plain_setup, rules_of_setup

        rules += rules_of_setup(setup, folder, package)
        plain = plain if cmake else is_plain_setup(setup, package)
    return InstallMap(
        folder, rules, whole=plain and bool(cmake) != bool(setup), makes=bool(cmake or setup) and not plain
    )


def _read(path: str) -> str:
    try:
        return first_bytes(path, _MOST_BYTES).decode("utf-8", "replace").replace("\r\n", "\n")
    except OSError:
        return ""


def _from_cmake(text: str, package: str) -> Iterator[Installed]:
    text = re.sub(_COMMENT, "", text)
    project = re.search(_PROJECT, text)
    name = project.group(1) if project else package
    for kind, body in re.findall(_INSTALL, text):
        words = [quoted or bare for quoted, bare in re.findall(_PIECE, _substituted(body, name))]
        if "DESTINATION" not in words[:-1]:
            continue
        where = words.index("DESTINATION")
        target = below_share(words[where + 1], name)
        if target is None:
            continue
        for source in words[:where]:
            if source.isupper() and source.isalpha():
                break
            yield installed(kind.upper(), target, source)


def _is_plain_cmake(text: str, package: str) -> bool:
    """Whether all that a CMakeLists.txt installs is said in words: no loops, no macros, no unknown variables."""
    text = re.sub(_COMMENT, "", text)
    if re.search(_NOT_PLAIN, text):
        return False
    return not any("${" in _substituted(body, package) for _, body in re.findall(_ANY_INSTALL, text))


def _substituted(body: str, project: str) -> str:
    for variable, value in (
        ("${PROJECT_NAME}", project),
        ("${CMAKE_PROJECT_NAME}", project),
        ("${CMAKE_CURRENT_SOURCE_DIR}/", ""),
        ("${CMAKE_CURRENT_LIST_DIR}/", ""),
        ("${PROJECT_SOURCE_DIR}/", ""),
        ("${CMAKE_INSTALL_PREFIX}/", ""),
        ("${CATKIN_PACKAGE_SHARE_DESTINATION}", f"share/{project}"),
    ):
        body = body.replace(variable, value)
    return body
