"""Where a source package installs its files: `$(find pkg)/urdf/x` may be `description/urdf/x` in the source tree.

The install rules come from `install()` in CMakeLists.txt and from `data_files` in setup.py. Both files are parsed, and
never run.
"""

from __future__ import annotations

import os
import re
from bisect import bisect_right
from collections.abc import Iterator
from itertools import islice

from urdfctl.source.disk import gate
from urdfctl.source.disk.files import first_bytes
from urdfctl.source.workspaces.expanded_files import expanded_files
from urdfctl.source.workspaces.installed import Installed, below_share, installed

_INSTALL = r"(?si)\binstall\s*\(\s*(DIRECTORY|FILES|PROGRAMS)\s+([^)]*)\)"
_PROJECT = r"(?i)\bproject\s*\(\s*([\w.-]+)"
_OF_AMENT = r"(?i)\bfind_package\s*\(\s*ament_cmake(?:_auto)?\b"
_REGISTERS = (
    r"\b(?!(?i:find_package)\b)\w*(?i:package)\s*\(|\b(?i:add_subdirectory|return|catkin\w*)\s*\("
    r"|\b(?i:include)\s*\((?!\s*[A-Z]\w*\s*\))"  # but not a module of CMake's own, such as CTest
)
"""What registers a package, or may do so elsewhere, or ends the file before."""
_ANY_INSTALL = r"(?si)\binstall\s*(\()([^)]*)\)"
_CALL = r"\b(\w+)\s*\(\s*(\w*)"
_INSTALLS_MORE = frozenset(
    "foreach add_subdirectory include function macro execute_process ament_auto_package catkin_install_python "
    "add_custom_command add_custom_target configure_file".split()
)
"""Commands of CMake that can make or install files without a literal `install()`; so can macros named as below."""
_INSTALLS_PYTHON = r"(?i)\bament_python_install_(?:package|module)\s*\((?![^()]*DESTINATION)[^()]*\)"
"""What installs Python modules, and nothing into the package's share (ament_cmake_python)."""
_MACROS_OF_OTHERS = ("xacro_add_", "install_", "fetchcontent_", "externalproject_")
_WRITES = frozenset("download generate configure write append rename copy archive_extract".split())
"""What `file()` does that makes files."""
_GIVEN_BY_PATTERN = r"(?i)INSTALL_TO_SHARE|\bGLOB"
_COMMENT = r"#[^\n]*"
_LOOP = r"(?si)\bforeach\s*\(\s*(\w+)\s+([^()]*)\)((?:(?!\bforeach\s*\().)*?)\bendforeach\s*\([^()]*\)"
_BLOCK = r"(?i)\b(end)?(?:if|function|macro|while)\s*\("
_SET = r"(?i)\bset\s*\(\s*(\w+)\s+([^()]*)\)"
_AUTO = r"(?i)\bament_auto_package\s*\(([^()]*)\)"
_AUTO_OPTIONS = ("INSTALL_TO_PATH", "USE_SCOPED_HEADER_INSTALL_DIR")
_MOST_ROUNDS = 200
_MOST_RULES = 500
_MOST_CHARACTERS = 1 << 16
_PIECE = r'"([^"]*)"|(\S+)'
_MOST_BYTES = 1 << 20


class InstallMap:
    """The install rules of one package."""

    def __init__(
        self, folder: str, rules: list[Installed], *, whole: bool = False, makes: bool = False, build: str = ""
    ) -> None:
        self.folder = folder
        self._build = build
        self.rules = rules
        self.whole = whole
        """Whether `rules` is known to be complete."""
        self.makes = makes
        """Whether the build may generate files that are not in the source tree."""

    def installs(self, source: str) -> bool | None:
        """Return whether a source file is installed, by its path relative to the package; None if unknown."""
        if any(source == rule.source or source.startswith(rule.source.rstrip("/") + "/") for rule in self.rules):
            return True
        return False if self.whole else None

    def makes_named(self, name: str) -> bool:
        """Return whether the build may generate files, and CMakeLists.txt mentions one of this name."""
        return self.makes and re.search(rf"(?<![\w.-]){re.escape(name)}(?![\w-])", self._build) is not None

    def source_of(self, relative: str) -> str | None:
        """Return the existing source file that is installed at a path relative to share/<package>, if any."""
        for target, source in self.rules:
            if target and relative != target and not relative.startswith(target + "/"):
                continue
            rest = relative[len(target) :].lstrip("/")
            candidate = os.path.normpath(os.path.join(self.folder, source, rest))
            if gate.exists(candidate):
                return candidate
        return None


def read_install_map(folder: str, package: str) -> InstallMap:
    """Return the install rules of the package in a folder; no rules if it has no build files."""
    cmake = _read(os.path.join(folder, "CMakeLists.txt"))
    cmake = cmake[: cmake.rfind(")") + 1]  # without this, each unclosed call is searched to the end: quadratic time
    cmake = re.sub(_AUTO, _auto_installed, _unrolled(cmake))
    setup = _read(os.path.join(folder, "setup.py"))
    rules = list(islice(_from_cmake(cmake, package), _MOST_RULES))
    plain = _is_plain_cmake(cmake, package) if cmake else False
    if setup:
        from urdfctl.source.workspaces.setup_files import is_plain_setup, rules_of_setup

        rules += islice(rules_of_setup(setup, folder, package), _MOST_RULES)
        plain = plain if cmake else is_plain_setup(setup, package)
    makes = bool(cmake) if not setup or cmake else "cmdclass" in setup
    whole = plain and bool(cmake) != bool(setup) and len(rules) < _MOST_RULES
    return InstallMap(folder, rules, whole=whole, makes=makes and not plain, build=cmake)


def _read(path: str) -> str:
    try:
        return first_bytes(path, _MOST_BYTES).decode("utf-8", "replace").replace("\r\n", "\n")
    except OSError:
        return ""


def missing_sources(text: str, folder: str, package: str) -> Iterator[tuple[str, int]]:
    """Yield the files and folders that install() in a CMakeLists.txt names and that do not exist, with their offsets.

    Only literal names outside conditions and functions count. Nothing is yielded if the build may make files.
    """
    plain = _without_comments(text)
    if _installs_more(plain):
        return
    project = re.search(_PROJECT, plain)
    name = project.group(1) if project else package
    blocks, depths = _blocks(plain)
    for call in re.finditer(_INSTALL, plain):
        body = call.group(2)
        depth = depths[bisect_right(blocks, call.start()) - 1]
        if "DESTINATION" not in body or re.search(r"\bOPTIONAL\b", body) or depth > 0:
            continue
        for word in re.finditer(_PIECE, body.partition("DESTINATION")[0]):
            written = word.group(1) or word.group(2) or ""
            source = _substituted(written, name)
            if source.isupper() and source.isalpha():
                break
            literal = source == written and bool(source) and not re.search(r"[*?$]|^/", source)
            path = os.path.join(folder, source)
            if literal and gate.admits(path) and not os.path.exists(path):
                yield source, call.start(2) + word.start(1 if word.group(1) else 2)


def unregistered_project(text: str) -> tuple[int, int] | None:
    """Return where a CMakeLists.txt for ament names its project, if it surely never calls ament_package().

    text: the file, with one character for each byte.
    """
    plain = _without_comments(text)
    project = re.search(_PROJECT, plain)
    if project is None or not re.search(_OF_AMENT, plain) or re.search(_REGISTERS, plain):
        return None
    return project.span(1)


def _without_comments(text: str) -> str:
    """A CMakeLists.txt with blanks in the place of its comments."""
    return re.sub(_COMMENT, lambda comment: " " * len(comment.group()), text)


def _blocks(text: str) -> tuple[list[int], list[int]]:
    """Where conditions and functions begin and end, and in how many of them the text is from there on."""
    ends, depths = [0], [0]
    for word in re.finditer(_BLOCK, text):
        ends.append(word.end())
        depths.append(depths[-1] + (-1 if word.group(1) else 1))
    return ends, depths


def _from_cmake(text: str, package: str) -> Iterator[Installed]:
    text = re.sub(_COMMENT, "", text)
    project = re.search(_PROJECT, text)
    name = project.group(1) if project else package
    for kind, body in re.findall(_INSTALL, text):
        words = [quoted or bare for quoted, bare in re.findall(_PIECE, _substituted(body, name))]
        if "DESTINATION" not in words[:-1]:
            continue
        keyword = words.index("DESTINATION")
        target = below_share(words[keyword + 1], name)
        if target is None:
            continue
        for source in words[:keyword]:
            if source.isupper() and source.isalpha():
                break
            yield installed(kind.upper(), target, source)
    yield from expanded_files(_substituted(text, name))


def _unrolled(text: str) -> str:
    """A CMakeLists.txt with each `foreach` over known words replaced by its rounds."""
    if "foreach" not in text.lower() or len(text) > _MOST_CHARACTERS:
        return text
    text = re.sub(_COMMENT, "", text)
    lists = {name: words.split() for name, words in re.findall(_SET, text)}

    def rounds(match: re.Match[str]) -> str:
        variable, given, body = match.groups()
        kind, *rest = given.split() or [""]
        words = given.split()
        if kind == "IN":
            known = [lists.get(name) for name in rest[1:]] if rest[:1] == ["LISTS"] else [rest[1:]]
            words = [word for part in known for word in part or ("$",)]
            if rest[:1] == ["ITEMS"]:
                words = [word for each in rest[1:] for word in lists.get(each.strip("${}"), [each])]
        if len(words) * len(body) > _MOST_CHARACTERS or len(words) > _MOST_ROUNDS or kind == "RANGE":
            return match.group()
        if any("$" in word for word in words):
            return match.group()
        return "\n".join(body.replace(f"${{{variable}}}", word.strip('"')) for word in words)

    return re.sub(_LOOP, rounds, text)


def _auto_installed(call: re.Match[str]) -> str:
    """The install rule that ament_auto_package() makes of INSTALL_TO_SHARE (ament_cmake_auto)."""
    folders = call.group(1).partition("INSTALL_TO_SHARE")[2]
    kept = [word for word in folders.split() if word not in _AUTO_OPTIONS]
    rule = f"install(DIRECTORY {' '.join(kept)} DESTINATION share/${{PROJECT_NAME}})" if kept else ""
    return f"{rule}\nament_package()"


def _installs_more(text: str) -> bool:
    """Whether a CMakeLists.txt may make or install files that its literal install() rules do not name."""
    for command, first in re.findall(_CALL, re.sub(_INSTALLS_PYTHON, "", text).lower()):
        if command in _INSTALLS_MORE or command.startswith(_MACROS_OF_OTHERS) or "_install" in command:
            return True
        if command == "file" and first in _WRITES:
            return True
    return re.search(_GIVEN_BY_PATTERN, text) is not None


def _is_plain_cmake(text: str, package: str) -> bool:
    """Whether all install rules of a CMakeLists.txt are literal: without loops, macros and unknown variables."""
    text = re.sub(_COMMENT, "", text)
    if _installs_more(text):
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
