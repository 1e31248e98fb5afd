"""Find macros that take the name of another one, as in a file that was copied with its macro."""

from __future__ import annotations

import os
import re
from collections.abc import Iterator

from urdfctl.source.disk.files import FileProblem, Files
from urdfctl.source.disk.gate import is_file
from urdfctl.source.problem import Problem, ProblemKind
from urdfctl.source.xml.dom import Element

_WORD = r"([A-Za-z0-9]+)"
_FORMS = frozenset({"xacro", "urdf", "xml"})


def macro_of_other_file(name: str, node: Element, files: Files) -> Iterator[Problem]:
    """Yield the problem of a macro `iiwa_gazebo` in med.gazebo.xacro, if iiwa.gazebo.xacro defines one too."""
    folder, own = os.path.split(node.source.path)
    for other in _named_after(name, own):
        path = os.path.join(folder, other)
        if is_file(path) and _defines(path, name, files):
            message = f"macro '{name}' has the same name as a macro in '{other}'; the later definition is called"
            hint = "rename the macro to match its own file"
            yield Problem(ProblemKind.MACRO_OF_OTHER_FILE, node.at["name"], message, name, hint)


def macro_defined_again(name: str, node: Element, before: Element | None) -> Iterator[Problem]:
    """Yield the problem of a macro that replaces another one of its name, if that has another text."""
    if before is not None and _text(before) != _text(node):
        position = before.source.position(before.start)
        message = f"macro '{name}' is defined again; it replaces the one at {before.source.path}:{position.line}"
        yield Problem(ProblemKind.DUPLICATE_MACRO, node.at["name"], message, name)


def _text(node: Element) -> list[bytes]:
    """The words of an element's source, without its end tag."""
    return node.source.data[node.start : node.at.closing].split()


def _named_after(name: str, file: str) -> Iterator[str]:
    """Yield the names that a file would have if a word of the macro's name replaced one of its words."""
    parts = re.split(_WORD, file)
    words = re.findall(_WORD, name)
    strange = [word for word in words if word not in parts]
    for at, part in enumerate(parts) if strange else ():
        if at % 2 and part not in words and part not in _FORMS:
            yield from ("".join([*parts[:at], word, *parts[at + 1 :]]) for word in strange)


def _defines(path: str, name: str, files: Files) -> bool:
    try:
        text = files.glance(path).data
    except FileProblem:
        return False
    named = rb"<xacro:macro\s[^<>]*\bname\s*=\s*[\"'](?:xacro:)?%b[\"']" % re.escape(name.encode())
    return re.search(named, text) is not None
