"""What an editor asks about: a place in a file, and the robots that the file is read for."""

from __future__ import annotations

from collections.abc import Iterator, Sequence

from urdfctl.load.loader import LoadedTarget
from urdfctl.source.span import SourceSpan, SourceText
from urdfctl.source.workspaces.packages import Packages
from urdfctl.source.xml.dom import Element
from urdfctl.startup.records import NamedTuple


class Evaluated(NamedTuple):
    """An attribute with an expression, in one call: the element that it was written in, its text, and its value."""

    element: Element
    span: SourceSpan
    value: str


class Question(NamedTuple):
    """A place that an editor asks about.

    robots: those that read the file, the one that says most first, after the variant that was chosen.
    source: the file as it is open; its path is as the robots read it.
    line, column: from 1, in code points.
    """

    robots: Sequence[LoadedTarget]
    source: SourceText
    line: int
    column: int
    is_current: bool = True
    """Whether the robots were read from the texts as they are; a text that cannot be parsed now was read before."""
    packages: Packages | None = None
    """The packages as the file sees them; None if they are not asked about."""
    is_chosen: bool = False
    """Whether the user chose the first robot: only its values are shown."""

    @property
    def shown(self) -> Sequence[LoadedTarget]:
        """The robots whose values are shown."""
        return self.robots[:1] if self.is_chosen else self.robots

    @property
    def file(self) -> str:
        """The path of the file."""
        return self.source.path

    @property
    def offset(self) -> int:
        """The byte offset of the place."""
        return self.source.offset(self.line, self.column)

    @property
    def before(self) -> str:
        """The text of the line before the place."""
        return self.source.line(self.line)[: self.column - 1]

    def sources(self) -> list[SourceText]:
        """Return the texts that the robots read, each once."""
        return list({one.path: one for robot in self.robots for one in robot.sources.values()}.values())

    def is_in(self, span: SourceSpan) -> bool:
        """Return whether the place is in a span of the file, or at its end."""
        return span.file == self.file and span.start <= self.offset <= span.end

    def evaluated(self) -> Iterator[Evaluated]:
        """Yield the attributes of the file that have expressions, for each robot shown and each call of a macro."""
        for robot in self.shown:
            for element in robot.root.walk() if robot.root is not None else ():
                if element.source.path != self.file:
                    continue
                for attribute, value in element.attrs.items():
                    span = element.at[attribute].span
                    if "$" in span.text and span.start != element.start:
                        yield Evaluated(element, span, value)
