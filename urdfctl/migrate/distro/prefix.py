"""Paths below the folder of a distro's installation."""

from __future__ import annotations

import os
import re
from collections.abc import Collection, Iterator

from urdfctl.catalog.distros import ALL
from urdfctl.diagnostic import Edit
from urdfctl.migrate.edits.tokens import HOOKS, tokens_in
from urdfctl.migrate.options import Part
from urdfctl.migrate.packages import MigratedPackages
from urdfctl.migrate.step import EntryKind, Proposal, ReportEntry, Row, Step
from urdfctl.source.disk.files import is_launch
from urdfctl.source.span import Place, SourceSpan

_AUTHORITY = "docs.ros.org, Installation, Deb packages: /opt/ros/DISTRO"
_IMAGE = re.compile(rb"(?m)^(?![ \t]*#).*?(?:\b(?:ros|ros-core|ros-base|desktop)[:-]|\bROS_DISTRO[= ])([a-z]+)\b")
_PATH = re.compile(rb"(?<=/opt/ros/)[a-z]+(?![\w-])")


def _prefixes(packages: MigratedPackages) -> Iterator[Proposal]:
    target = packages.options.target
    earlier = {name.encode() for name in ALL[: ALL.index(target)]}
    for path in packages.files(*HOOKS, ".py", ".xml", ".launch"):
        source = packages.read(path)
        is_read = is_launch(path) or path.endswith((*HOOKS, ".py"))
        if not is_read or b"/opt/ros/" not in source.data or not packages.may_change(path):
            continue
        for token in tokens_in(source):
            found = [one.span() for one in _PATH.finditer(source.data, *token[1:]) if one[0] in earlier]
            edits = tuple(Edit(SourceSpan(source, *span), target) for span in found)
            if edits:
                at = Place(source, edits[0].span.start, end=edits[0].span.end)
                what = f"'/opt/ros/{edits[0].span.text}' became '/opt/ros/{target}'"
                yield Proposal(edits, entries=(ReportEntry(EntryKind.DONE, what, at, authority=_AUTHORITY),))
    yield from _images(packages, earlier)


def _images(packages: MigratedPackages, earlier: Collection[bytes]) -> Iterator[Proposal]:
    """Tell the files that make an image with an earlier distro: which packages another one has, they do not say."""
    for path in packages.files():
        name = os.path.basename(path).lower()
        if not name.startswith("dockerfile") and not name.endswith(".dockerfile"):
            continue
        source = packages.read(path)
        found = next((one for one in _IMAGE.finditer(source.data) if one[1] in earlier), None)
        if found is not None:
            at = Place(source, found.start(1), end=found.end(1))
            what = f"the image has {found[1].decode()}: make it of {packages.options.target}, with its packages"
            yield Proposal(entries=(ReportEntry(EntryKind.FOR_YOU, what, at, authority=_AUTHORITY),))


PREFIX = Step(
    name="install-prefix",
    part=Part.LAUNCH,
    summary="Paths below the folder of a distro",
    propose=_prefixes,
    rows=(Row("/opt/ros/DISTRO", "/opt/ros/TARGET", "", _AUTHORITY),),
    before=[
        {
            "options": "--from=humble --to=jazzy",
            "start.sh": """
                . /opt/ros/humble/setup.bash
                . /opt/ros/humble-ws/setup.bash
            """,
        },
    ],
    after=[
        {
            "start.sh": """
                . /opt/ros/jazzy/setup.bash
                . /opt/ros/humble-ws/setup.bash
            """,
        },
    ],
)
