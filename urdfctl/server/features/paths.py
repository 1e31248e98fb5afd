"""Packages, and the files in them, that fit what uses them at a place."""

from __future__ import annotations

import os
import re
from collections.abc import Iterator

from urdfctl.server.analysis.items import OfferedItem
from urdfctl.server.analysis.question import Question
from urdfctl.source.disk.files import first_bytes
from urdfctl.source.disk.gate import exists, walk
from urdfctl.source.workspaces.packages import PackageNotFound

_MOST_FILES = 2000
_HIDDEN = frozenset({"build", "install", "log", "devel", "node_modules", "__pycache__"})
_MESHES = (".stl", ".dae", ".obj", ".mesh", ".ply", ".glb", ".gltf")
_SUFFIXES = {
    "xacro:include": (".xacro", ".urdf", ".xacro.xml", ".urdf.xml"),
    "mesh": _MESHES, "texture": (".png", ".jpg", ".jpeg"),
    "include": (".launch", ".launch.xml", ".launch.py", ".launch.yaml"), "rosparam": (".yaml", ".yml"),
    "parameters": (".yaml", ".yml"), "uri": _MESHES, "xacro:property": (".yaml", ".yml"),
}  # fmt: skip
"""The files that an element reads, by its tag."""
_OF_A_ROBOT = rb"<(?:link|joint|xacro:(?!include|property|arg|if|unless|macro))\b"
_OF_TESTS = r"(?:^|/)tests?/"
_NAMED_ROBOT = rb"<robot\b[^<>]*\sname\s*="


def packages_with(question: Question, rest: str) -> Iterator[str]:
    """Yield the packages that a file can use, by name; if a path in them is written already, those that have it."""
    packages = question.packages
    if packages is None:
        return
    seen = re.findall(rb"\$\(find(?:-pkg-share)?\s+([\w.-]+)\)", b"\n".join(one.data for one in question.sources()))
    for name in sorted({*packages.known(), *(one.decode() for one in seen)}):
        try:
            folder = packages.find(name)
        except PackageNotFound:
            continue
        if not rest or exists(packages.source_of(os.path.join(folder, rest))):
            yield name


def files_in_package(question: Question, tag: str, package: str, begun: str) -> Iterator[OfferedItem]:
    """Yield the files in a package that an element can read, by their paths relative to the package.

    begun: the part of the path that is written already. Left out are files that xacro reads already; robots of their
    own are last.
    """
    if question.packages is None:
        return
    try:
        folder = question.packages.find(package)
    except PackageNotFound:
        return
    suffixes = _SUFFIXES.get(tag) or ((os.path.splitext(begun)[1],) if "." in begun else ())
    read = {os.path.realpath(path) for path in _read_now(question)}
    own = {os.path.realpath(question.file)}
    robots: list[OfferedItem] = []
    for path in _below(folder):
        relative = os.path.relpath(path, folder).replace(os.sep, "/")
        if not relative.startswith(begun) or not (not suffixes or path.lower().endswith(suffixes)):
            continue
        if os.path.realpath(path) in (read if tag == "xacro:include" else own):
            continue
        if tag == "xacro:include" and _is_robot(path):
            robots.append(OfferedItem(relative, "file", is_doubtful=True))
        else:
            yield OfferedItem(relative, "file", is_doubtful=bool(re.search(_OF_TESTS, relative)))
    yield from robots


def _read_now(question: Question) -> Iterator[str]:
    """Yield the files that the robots read, without those that the open text names no more."""
    yield question.file
    texts = [question.source.data, *(one.data for one in question.sources() if one.path != question.file)]
    for source in question.sources():
        if question.is_current or any(os.path.basename(source.path).encode() in text for text in texts):
            yield source.path


def _below(folder: str) -> Iterator[str]:
    left = _MOST_FILES
    for current, folders, files in walk(folder):
        folders[:] = sorted(name for name in folders if not name.startswith(".") and name not in _HIDDEN)
        for name in sorted(files):
            yield os.path.join(current, name)
            left -= 1
            if not left:
                return


def _is_robot(path: str) -> bool:
    """Whether a file describes a robot of its own: its root has a name, and something that is no definition."""
    try:
        data = first_bytes(path, 1 << 20)
    except OSError:
        return True
    outside = re.sub(rb"<!--.*?-->|<xacro:macro\b.*?</xacro:macro>", b"", data, flags=re.DOTALL)
    return bool(re.search(_NAMED_ROBOT, data) and re.search(_OF_A_ROBOT, outside))
