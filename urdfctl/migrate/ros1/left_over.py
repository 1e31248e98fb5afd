"""Launch files of ROS 1 that a person must write anew: what they name is kept up with what became of it."""

from __future__ import annotations

import glob
import os
import re
from collections.abc import Collection, Iterator

from urdfctl.diagnostic import Edit
from urdfctl.migrate.edits.markup import attribute, elements, root_of
from urdfctl.migrate.packages import MigratedPackages
from urdfctl.migrate.ros1.launches import ENDINGS, doubled_names, launch_roots, new_name
from urdfctl.source.disk.gate import matching
from urdfctl.source.span import SourceSpan
from urdfctl.source.workspaces.packages import package_name
from urdfctl.source.xml.dom import Element

_IN_PACKAGE = re.compile(r"\$\((?:find ([\w-]+)|dirname)\)(/.*)")
_ARGUMENT = re.compile(r"\$\((?:arg|eval|env|optenv) [^)]*\)")


def renamed_parameters(packages: MigratedPackages, old: Collection[str], new: str) -> Iterator[Edit]:
    """Yield the edits of launch files that load files with some old paths, so that they load a new one."""
    for root in packages.found(launch_roots).values():
        for element in elements(root):
            written = attribute(element, "file") if element.tagName == "rosparam" else ""
            head = written.rpartition("/")[0]
            tag = element.source.start_tag(element.start)
            if written and named_files(packages, element) & {*old} and tag is not None:
                yield Edit(SourceSpan(element.source, *tag.attributes["file"]), f"{head}/{os.path.basename(new)}")


def renamed_includes(packages: MigratedPackages, left: Collection[str], ending: str) -> Iterator[Edit]:
    """Yield the edits of launch files that are left, so that they include the migrated ones.

    left: the paths of the launch files that are left to a person.
    ending: that of migrated launch files.
    """
    for path in left:
        root = root_of(packages.read(path))
        for element in elements(root) if root is not None else ():
            written = attribute(element, "file") if element.tagName == "include" else ""
            tag = element.source.start_tag(element.start)
            if written.endswith(ENDINGS) and tag is not None and named_files(packages, element) - {*left}:
                new = new_name(written, ending, packages.found(doubled_names))
                yield Edit(SourceSpan(element.source, *tag.attributes["file"]), new)


def named_files(packages: MigratedPackages, element: Element) -> set[str]:
    """Return the files of the packages that the `file` of an element of a launch file means."""
    return addressed_files(packages, attribute(element, "file"), os.path.dirname(element.source.path))


def addressed_files(packages: MigratedPackages, written: str, around: str = "") -> set[str]:
    """Return the files of the packages that an address of ROS 1 means, with any values of its arguments.

    around: the folder of the launch file; empty if it is not known.
    """
    found = _IN_PACKAGE.fullmatch(written)
    if found is None or not (found[1] or around):
        return set()
    pattern = "".join("*" if index % 2 else glob.escape(part) for index, part in enumerate(_split(found[2])))
    named = (os.path.dirname(path) for path in packages.files("package.xml") if package_name(path) == found[1])
    folders = named if found[1] else (around,)
    return {os.path.normpath(path) for folder in folders for path in matching(glob.escape(folder) + pattern)}


def _split(text: str) -> Iterator[str]:
    """The parts of a text between its arguments, and the arguments, in turn."""
    end = 0
    for match in _ARGUMENT.finditer(text):
        yield from (text[end : match.start()], match[0])
        end = match.end()
    yield text[end:]
