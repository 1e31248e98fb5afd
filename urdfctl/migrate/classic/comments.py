"""Comments that Gazebo Classic's plugin cannot pass on in humble."""

from __future__ import annotations

import re
from collections.abc import Iterator

from urdfctl.diagnostic import Edit
from urdfctl.migrate.packages import Packages
from urdfctl.migrate.step import Entry, EntryKind, Proposal, Row, Step
from urdfctl.migrate.tokens import XML
from urdfctl.migrate.wishes import Part
from urdfctl.rules.ros2_control.comment_breaks_parameter import comment_breaks_parameter
from urdfctl.source.span import Place, SourceSpan, SourceText
from urdfctl.startup.patterns import lazy_pattern

_AUTHORITY = (
    "gazebo_ros2_control#295: humble's plugin passes the description on as a parameter, which is parsed as YAML"
)
_COLON = lazy_pattern(r"[ \t]*:(?=\s)")
_HASH = lazy_pattern(r"(?<=\s)#+")


def _comments(packages: Packages) -> Iterator[Proposal]:
    if packages.wishes.target != "humble" or packages.simulator != "gazebo-classic":
        return
    done: set[tuple[str, int]] = set()
    for loaded in packages.loaded(packages.wishes.target):
        tag = loaded.project.robot.tag if loaded.project.robot else None
        if tag is None or not any(comment_breaks_parameter.check(loaded.project)):
            continue
        kept = {comment.text.strip() for comment in tag.comments()}
        sources = [packages.read(path) for path in loaded.sources if path.endswith(XML) and packages.may_change(path)]
        spans = (span for source in sources for span in _written(source, kept))
        for span in spans:
            new = re.sub(r"--+", "-", _HASH.sub("", _COLON.sub(" -", span.text)))
            if new != span.text and (span.file, span.start) not in done:
                done.add((span.file, span.start))
                what = "the punctuation of a comment is changed: Gazebo's plugin cannot pass on a colon before a blank"
                at = Place(span.source, span.start, end=span.end)
                entry = Entry(EntryKind.DECIDED, what, at, authority=_AUTHORITY, option="delete the comment")
                yield Proposal((Edit(span, new),), entries=(entry,), fixes=("UC359",))


def _written(source: SourceText, kept: set[str]) -> Iterator[SourceSpan]:
    """Yield the texts of the comments in a file that a robot keeps; those with expressions look different there."""
    for found in re.finditer(rb"<!--(.*?)-->", source.data, re.DOTALL):
        span = SourceSpan(source, *found.span(1))
        if "$" in span.text or span.text.strip() in kept:
            yield span


COMMENTS = Step(
    name="comments",
    part=Part.URDF,
    summary="Comments in descriptions for Gazebo Classic in humble",
    propose=_comments,
    rows=(Row("<!-- NAME: text -->", "<!-- NAME - text -->", "humble", _AUTHORITY),),
)
