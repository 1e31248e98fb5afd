"""The playground: urdfctl in a page, on Python for browsers (Pyodide), with all that it needs beside it.

Only what is pure Python can be taken along as it is. PyYAML and MarkupSafe have a part in C that they do without.
"""

from __future__ import annotations

import json
import shutil
import zipfile
from collections.abc import Iterator
from importlib.metadata import Distribution, distribution
from pathlib import Path

from documents import ROOT
from packaging.requirements import Requirement
from texts import Pages, front_matter

from urdfctl.catalog.distros import ALL
from urdfctl.graph.svg import STYLE
from urdfctl.report.pages import allowed_scripts, allowed_styles

_HERE = Path(__file__).resolve().parent / "playground"
_PYODIDE = ("pyodide.mjs", "pyodide.asm.mjs", "pyodide.asm.wasm", "python_stdlib.zip", "pyodide-lock.json")
_SERVED = ("app.js", "explained.js", "worker.js", "driver.py", "style.css")
_EXAMPLE = ROOT / "samples" / "broken" / "mybot"
_NEW_DATE = (2020, 1, 1, 0, 0, 0)
"""The same input makes the same archive."""


def playground_pages() -> Pages:
    """Return the page that stands in the place of the playground where it was not built."""
    head = front_matter("Playground", "Lint a robot in your browser; nothing leaves the page")
    return {"playground/index.md": f"{head}\n# Playground\n\nThis copy of the site was built without the playground.\n"}


def write_playground(folder: Path, pyodide: Path) -> None:
    """Write the playground into the folder of its page, with Pyodide from the folder of its npm package."""
    (folder / "pyodide").mkdir(parents=True, exist_ok=True)
    for name in _PYODIDE:
        shutil.copyfile(pyodide / name, folder / "pyodide" / name)
    for name in _SERVED:
        shutil.copyfile(_HERE / name, folder / name)
    distros = json.dumps(ALL).replace('"', "&quot;")
    page = (_HERE / "index.html").read_text("utf-8").replace("POLICY", policy())
    page = page.replace('<html lang="en">', f'<html lang="en" data-distros="{distros}">')
    (folder / "index.html").write_text(page, "utf-8")
    (folder / "example.json").write_text(json.dumps(dict(_example())), "utf-8")
    with zipfile.ZipFile(folder / "packages.zip", "w", zipfile.ZIP_DEFLATED) as archive:
        for name, path in sorted(_packages()):
            archive.writestr(zipfile.ZipInfo(name, _NEW_DATE), path.read_bytes(), zipfile.ZIP_DEFLATED)


def policy() -> str:
    """Return what the playground may run and load: its own files, Python's WebAssembly, and the scripts and styles of
    urdfctl's pages, by their hashes, for the graph and the robot in 3-D. It can connect to its own folder only."""
    rules = (
        "default-src 'none'",
        f"script-src 'self' 'wasm-unsafe-eval' {allowed_scripts()}",
        f"style-src 'self' {allowed_styles(STYLE)}",
        "connect-src 'self'",
        "worker-src 'self'",
        "img-src data:",
        "frame-src 'self'",
        "base-uri 'none'",
        "form-action 'none'",
    )
    return "; ".join(rules)


def _example() -> Iterator[tuple[str, str]]:
    for path in sorted(_EXAMPLE.rglob("*")):
        if path.is_file():
            yield path.relative_to(_EXAMPLE).as_posix(), path.read_text("utf-8")


def _packages() -> Iterator[tuple[str, Path]]:
    """The files of urdfctl and of all that it needs, by their names in site-packages."""
    for path in (ROOT / "urdfctl").rglob("*"):
        if path.is_file() and "__pycache__" not in path.parts:
            yield path.relative_to(ROOT).as_posix(), path
    for path in (ROOT / "templates").rglob("*"):
        if path.is_file():
            yield f"urdfctl/{path.relative_to(ROOT).as_posix()}", path
    for needed in _needed(distribution("urdfctl"), set()):
        for file in needed.files or ():
            path = Path(str(needed.locate_file(file)))
            if ".." not in file.parts and path.suffix not in {".so", ".pyd", ".pyc"} and path.is_file():
                yield file.as_posix(), path


def _needed(one: Distribution, known: set[str]) -> Iterator[Distribution]:
    """What a distribution requires without extras, and what that requires."""
    for requirement in one.requires or ():
        wanted = Requirement(requirement)
        if wanted.name.lower() in known or (wanted.marker and not wanted.marker.evaluate({"extra": ""})):
            continue
        known.add(wanted.name.lower())
        found = distribution(wanted.name)
        yield found
        yield from _needed(found, known)
