"""What a source package installs where: `$(find pkg)/urdf/x` often lies in `description/urdf/x` of the source tree.

Read from the `install()` rules of CMakeLists.txt and from `data_files` of setup.py, as text: neither is ever run.
"""

from __future__ import annotations

import ast
import os
import re
from collections.abc import Iterator

from urdfctl.record import NamedTuple
from urdfctl.source.files import first_bytes

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


class Installed(NamedTuple):
    """`source` (relative to the package) comes to stand at `target` (relative to share/<package>)."""

    target: str
    source: str


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
    rules = [*_from_cmake(cmake, package), *_from_setup(setup, folder, package)]
    plain = _is_plain_cmake(cmake, package) if cmake else _is_plain_setup(setup, package)
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
        target = _below_share(words[where + 1], name)
        if target is None:
            continue
        for source in words[:where]:
            if source.isupper() and source.isalpha():
                break
            yield _installed(kind.upper(), target, source)


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


def _below_share(destination: str, package: str) -> str | None:
    """A destination relative to share/<package>; None where it lies elsewhere."""
    share = f"share/{package}"
    destination = os.path.normpath(destination)
    if destination == share:
        return ""
    return destination[len(share) + 1 :] if destination.startswith(share + "/") else None


def _installed(kind: str, target: str, source: str) -> Installed:
    if kind == "DIRECTORY" and source.endswith("/"):
        return Installed(target, source.rstrip("/"))
    return Installed(os.path.normpath(os.path.join(target, os.path.basename(source))), source)


def _from_setup(text: str, folder: str, package: str) -> Iterator[Installed]:
    if "data_files" not in text:
        return
    try:
        tree = ast.parse(text)
    except (SyntaxError, ValueError, RecursionError, MemoryError):
        return
    for node in ast.walk(tree):
        if isinstance(node, ast.Tuple) and len(node.elts) == 2:  # noqa: PLR2004 (a pair of data_files)
            destination = _text_of(node.elts[0], package)
            target = _below_share(destination, package) if destination else None
            if target is not None:
                for source in _sources_of(node.elts[1], package):
                    yield from _matching(folder, target, source)


def _is_plain_setup(text: str, package: str) -> bool:
    """Whether setup.py lists all its data files as texts and patterns."""
    try:
        tree = ast.parse(text)
    except (SyntaxError, ValueError, RecursionError, MemoryError):
        return False
    given = [
        keyword.value
        for node in ast.walk(tree)
        if isinstance(node, ast.Call)
        for keyword in node.keywords
        if keyword.arg == "data_files"
    ]
    if len(given) != 1 or not isinstance(given[0], ast.List):
        return False
    return all(isinstance(pair, ast.Tuple) and _is_plain_pair(pair.elts, package) for pair in given[0].elts)


def _is_plain_pair(pair: list[ast.expr], package: str) -> bool:
    if len(pair) != 2 or _text_of(pair[0], package) is None:  # noqa: PLR2004 (where to, and which)
        return False
    if isinstance(pair[1], ast.List):
        return all(_text_of(element, package) is not None for element in pair[1].elts)
    return isinstance(pair[1], ast.Call) and bool(pair[1].args) and _text_of(pair[1].args[0], package) is not None


def _matching(folder: str, target: str, pattern: str) -> Iterator[Installed]:
    if "*" not in pattern and "?" not in pattern:
        yield _installed("FILES", target, pattern)
        return
    from glob import escape, glob

    for path in sorted(glob(os.path.join(escape(folder), pattern))):
        relative = os.path.relpath(path, folder)
        yield _installed("FILES", target, relative)


def _sources_of(node: ast.expr, package: str) -> Iterator[str]:
    """The texts in a list of files, and the patterns of `glob(...)`."""
    if isinstance(node, ast.List):
        for element in node.elts:
            text = _text_of(element, package)
            if text:
                yield text
    elif isinstance(node, ast.Call) and node.args:
        text = _text_of(node.args[0], package)
        if text:
            yield text
    elif isinstance(node, ast.BinOp):
        yield from _sources_of(node.left, package)
        yield from _sources_of(node.right, package)


def _text_of(node: ast.expr, package: str) -> str | None:
    """A path written as text, as `os.path.join(...)`, or with `package_name` in it; None where it is anything else."""
    if isinstance(node, ast.Constant):
        return node.value if isinstance(node.value, str) else None
    if isinstance(node, ast.Name):
        return package if node.id == "package_name" else None
    parts: list[ast.expr] = []
    separator = ""
    if isinstance(node, ast.Call) and isinstance(node.func, ast.Attribute) and node.func.attr == "join":
        parts, separator = node.args, "/"
    elif isinstance(node, ast.BinOp) and isinstance(node.op, ast.Add):
        parts = [node.left, node.right]
    elif isinstance(node, ast.JoinedStr):
        parts = [value.value if isinstance(value, ast.FormattedValue) else value for value in node.values]
    texts = [_text_of(part, package) for part in parts]
    known = [text for text in texts if text is not None]
    return separator.join(known) if known and len(known) == len(texts) else None
