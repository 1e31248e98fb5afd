"""Expand small literal files with urdfctl and with xacro itself."""

from __future__ import annotations

from collections.abc import Mapping
from pathlib import Path

import plain_xacro

from urdfctl.expand.xml_writer import write
from urdfctl.source.disk.files import Files
from urdfctl.source.problem import Problem
from urdfctl.source.workspaces.packages import PackageIndex, Packages
from urdfctl.source.xacro.expanded import Expansion
from urdfctl.source.xacro.expansion import Expander
from urdfctl.source.xml.dom import Element, XmlNode

NAMESPACE = 'xmlns:xacro="http://www.ros.org/wiki/xacro"'


def laid_out(folder: Path, files: Mapping[str, str]) -> str:
    """Write files to a folder, and return the path of the first."""
    for name, text in files.items():
        path = folder / name
        path.parent.mkdir(parents=True, exist_ok=True)
        path.write_bytes(text.encode())
    return str(folder / next(iter(files)))


def robot(body: str) -> str:
    """Return a robot with xacro's namespace and this body, which starts on line 2."""
    return f'<robot name="r" {NAMESPACE}>\n{body}\n</robot>\n'


def expanded(
    path: str,
    arguments: Mapping[str, str] | None = None,
    *,
    strict: bool = False,
    trust: bool = False,
    environ: Mapping[str, str] | None = None,
) -> Expansion:
    """Return the expansion of a file; its folder is the workspace."""
    folder = str(Path(path).parent)
    packages = Packages(path, PackageIndex(folder, environ={}))
    expander = Expander(Files([folder], packages.source_of), packages, environ or {}, strict=strict, trust=trust)
    return expander.expand(path, arguments or {})


def ours(path: str, arguments: Mapping[str, str] | None = None) -> str:
    """Return the XML that urdfctl writes for a file; if it fails, `error: ` and the message of the last problem."""
    expansion = expanded(path, arguments, strict=True)
    return write(expansion.document, path) if expansion.document else f"error: {expansion.problems[-1].message}"


def theirs(path: str, arguments: Mapping[str, str] | None = None) -> str:
    """Return the XML that xacro writes for a file; `error: ...` if it fails."""
    return plain_xacro.expand(path, Packages(path, PackageIndex(str(Path(path).parent), environ={})), arguments or {})


def said(problem: Problem) -> str:
    """Return a problem as `file:line:column kind message`; the file is without its folder."""
    position = problem.at.source.position(problem.at.span.start)
    where = f"{Path(problem.at.source.path).name}:{position.line}:{position.column}"
    return f"{where} {problem.kind.name} {problem.message}"


def elements(node: XmlNode | None) -> list[Element]:
    """Return a node, if it is an element, and all elements below it, in document order."""
    if node is None:
        return []
    below = [element for child in node.elements() for element in elements(child)]
    return [node, *below] if isinstance(node, Element) else below
