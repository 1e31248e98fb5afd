"""Where elements are written, and the plugins in the XML files of the packages."""

from __future__ import annotations

import os
from collections.abc import Collection, Iterator

from urdfctl.migrate.edits.markup import elements, root_of
from urdfctl.migrate.packages import OF_XML, MigratedPackages
from urdfctl.source.span import Place, SourceSpan
from urdfctl.source.xml.dom import Element

ElementKey = tuple[str, int]
"""An element as it is written: the real path of its file, and the offset of its start tag."""


def key_of(at: Place) -> ElementKey:
    """Return the key of the element at a place."""
    return os.path.realpath(at.source.path), at.start


def key_of_element(element: Element) -> ElementKey:
    """Return the key of an element."""
    return os.path.realpath(element.source.path), element.start


def place_of(span: SourceSpan) -> Place:
    """Return the place of some bytes."""
    return Place(span.source, span.start, end=span.end)


def written_elements(packages: MigratedPackages, mark: str, endings: Collection[str] = OF_XML) -> Iterator[Element]:
    """Yield all elements of the files that contain a text, as they are written."""
    for path in packages.files(*endings):
        source = packages.read(path)
        root = root_of(source) if mark.encode() in source.data else None
        yield from elements(root) if root is not None else ()


def plugin_elements(packages: MigratedPackages, *endings: str, at_first: bool = False) -> Iterator[Element]:
    """Yield the `<plugin>` elements in the XML files, as they are written.

    endings: those of other files to look into, too.
    at_first: whether to yield them as they were before the migration, instead of as they are now.
    """
    for path in packages.files(*OF_XML, *endings):
        source = packages.read(packages.scratch.real(path) if at_first else path)
        root = root_of(source) if b"<plugin" in source.data else None
        if root is not None and root.tagName in {"robot", "gazebo", "sdf"}:
            yield from (element for element in elements(root) if element.tagName == "plugin")
