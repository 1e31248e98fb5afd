"""A place in an XML text: what is written around it, finished or not."""

from __future__ import annotations

import re

from urdfctl.server.analysis.question import Question
from urdfctl.server.analysis.scopes import Scopes, macro_around
from urdfctl.source.disk.files import is_launch
from urdfctl.source.span import SourceText
from urdfctl.startup.records import NamedTuple

ATTRIBUTE = r"\s+[\w:.-]+\s*=\s*(?:\"[^\"]*\"|'[^']*')"
OPEN_ATTRIBUTE = (
    rf"<(?P<tag>[\w:.-]+)(?:{ATTRIBUTE})*\s+(?P<name>[\w:.-]+)\s*=\s*"
    r"(?P<quote>[\"'])(?P<word>(?:(?!(?P=quote)).)*)$"
)
_MOST_AFTER = 2000


class Spot(NamedTuple):
    """A place, with what was recognised before it.

    before: the text from the last `<` on.
    found: what its end matches; the group `word` is what is typed already.
    """

    question: Question
    before: str
    found: re.Match[str]

    @property
    def after(self) -> str:
        """The text after the place."""
        offset = self.question.offset
        return self.question.source.data[offset : offset + _MOST_AFTER].decode("utf-8", "replace")

    @property
    def start(self) -> int:
        """The byte offset of the last `<`."""
        return self.question.source.data.rfind(b"<", 0, self.question.offset)

    @property
    def opened(self) -> re.Match[str] | None:
        """The attribute around the place, with the groups tag, name, quote and word; None if there is none."""
        return re.match(OPEN_ATTRIBUTE, self.before, re.DOTALL)

    @property
    def tag(self) -> str:
        """The tag that is begun."""
        found = re.match(r"<([\w:.-]*)", self.before)
        return found[1] if found else ""

    def scopes(self) -> Scopes:
        """Return what the files of the robots define; in a launch file, what the file itself does."""
        question = self.question
        if is_launch(question.file):
            return Scopes([SourceText(question.file, question.source.data)])
        return Scopes(source for source in question.sources() if source.is_xacro)

    def macro(self) -> str:
        """Return the macro that the place is in; empty if it is in none."""
        return macro_around(self.question.source.data, self.start)

    def parent(self) -> str:
        """Return the tag of the element that is open before the place; empty if there is none."""
        text = self.question.source.data[: self.start].decode("utf-8", "replace")
        text = re.sub(r"<!--.*?(-->|$)", "", text, flags=re.DOTALL)
        open_tags: list[str] = []
        for found in re.finditer(r"<(/?)([\w:.-]+)(?:[^<>\"']|\"[^\"]*\"|'[^']*')*?(/?)>", text):
            if found[1]:
                if found[2] in open_tags:
                    del open_tags[len(open_tags) - 1 - open_tags[::-1].index(found[2]) :]
            elif not found[3]:
                open_tags.append(found[2])
        return open_tags[-1] if open_tags else ""


def names_of_attributes(text: str) -> set[str]:
    """Return the names of the attributes in a part of a start tag."""
    return set(re.findall(r"([\w:.-]+)\s*=", re.sub(r"\"[^\"]*\"|'[^']*'", "", text)))
