"""Comments that Gazebo Classic's plugin cannot pass on in humble."""

from __future__ import annotations

import re
from collections.abc import Iterator

from urdfctl.diagnostic import Edit
from urdfctl.migrate.packages import Packages
from urdfctl.migrate.step import Entry, EntryKind, Proposal, Row, Step
from urdfctl.migrate.wishes import Part
from urdfctl.rules.ros2_control.comment_breaks_parameter import comment_breaks_parameter
from urdfctl.startup.patterns import lazy_pattern

_AUTHORITY = (
    "gazebo_ros2_control#295: humble's plugin passes the description on as a parameter, which is parsed as YAML"
)
_COLON = lazy_pattern(r"[ \t]*:(?=\s)")
_HASH = lazy_pattern(r"(?<=\s)#+")


def _comments(packages: Packages) -> Iterator[Proposal]:
    if packages.wishes.target != "humble" or packages.simulator != "gazebo-classic":
        return
    for loaded in packages.loaded(packages.wishes.target):
        for finding in comment_breaks_parameter.check(loaded.project):
            comment = finding.at.span
            text = comment.text.removeprefix("<!--").removesuffix("-->")
            new = re.sub(r"--+", "-", _HASH.sub("", _COLON.sub(" -", text)))
            what = "the punctuation of a comment is changed: Gazebo's plugin cannot pass on a colon before a blank"
            entry = Entry(EntryKind.DECIDED, what, finding.at, authority=_AUTHORITY, option="delete the comment")
            yield Proposal((Edit(comment, f"<!--{new}-->"),), entries=(entry,), fixes=("UC359",))


COMMENTS = Step(
    name="comments",
    part=Part.URDF,
    summary="Comments in descriptions for Gazebo Classic in humble",
    propose=_comments,
    rows=(Row("<!-- NAME: text -->", "<!-- NAME - text -->", "humble", _AUTHORITY),),
)
