"""Expands small literal files, for tests: with urdfctl, and with xacro itself."""

from __future__ import annotations

from collections.abc import Mapping
from pathlib import Path

import plain_xacro

from urdfctl.source.dom import Element, Node
from urdfctl.source.files import Files
from urdfctl.source.packages import PackageIndex, Packages
from urdfctl.source.problem import Problem
from urdfctl.source.xacro import Expander, Expansion
from urdfctl.source.xml_writer import write

NAMESPACE = 'xmlns:xacro="http://www.ros.org/wiki/xacro"'


def laid_out(folder: Path, files: Mapping[str, str]) -> str:
    """The path of the first of some files, all written below a folder."""
    for name, text in files.items():
        path = folder / name
        path.parent.mkdir(parents=True, exist_ok=True)
        path.write_bytes(text.encode())
    return str(folder / next(iter(files)))


def robot(body: str) -> str:
    """A robot with xacro's namespace around a body, which begins on line 2."""
    return f'<robot name="r" {NAMESPACE}>\n{body}\n</robot>\n'


def expanded(
    path: str,
    arguments: Mapping[str, str] | None = None,
    *,
    strict: bool = False,
    trust: bool = False,
    environ: Mapping[str, str] | None = None,
) -> Expansion:
    """The expansion of a file whose folder is the workspace."""
    folder = str(Path(path).parent)
    packages = Packages(path, PackageIndex(folder, environ={}))
    expander = Expander(Files([folder], packages.source_of), packages, environ or {}, strict=strict, trust=trust)
    return expander.expand(path, arguments or {})


def ours(path: str, arguments: Mapping[str, str] | None = None) -> str:
    """What urdfctl writes for a file, or its first problem's message."""
    expansion = expanded(path, arguments, strict=True)
    return write(expansion.document, path) if expansion.document else f"error: {expansion.problems[-1].message}"


def theirs(path: str, arguments: Mapping[str, str] | None = None) -> str:
    """What xacro writes for a file, or `error: ...`."""
    return plain_xacro.expand(path, Packages(path, PackageIndex(str(Path(path).parent), environ={})), arguments or {})


def said(problem: Problem) -> str:
    """A problem as `file:line:column kind message`, the file without its folder."""
    position = problem.at.source.position(problem.at.span.start)
    where = f"{Path(problem.at.source.path).name}:{position.line}:{position.column}"
    return f"{where} {problem.kind.name} {problem.message}"


def elements(node: Node | None) -> list[Element]:
    """All elements at and below a node, in document order."""
    if node is None:
        return []
    below = [found for child in node.elements() for found in elements(child)]
    return [node, *below] if isinstance(node, Element) else below
