"""Tags and macro calls of xacro without the prefix `xacro:`, which xacro read until melodic."""

from __future__ import annotations

from collections.abc import Iterator

from urdfctl.diagnostic import Edit
from urdfctl.migrate.options import Part
from urdfctl.migrate.packages import MigratedPackages
from urdfctl.migrate.step import EntryKind, Proposal, ReportEntry, Row, Step
from urdfctl.rules.reading.xacro_prefix_missing import xacro_prefix_missing

_AUTHORITY = "wiki.ros.org/xacro: since noetic, tags without the prefix are not expanded"


def _prefixes(packages: MigratedPackages) -> Iterator[Proposal]:
    done: set[tuple[Edit, ...]] = set()
    for loaded in packages.loaded(packages.options.target):
        for finding in xacro_prefix_missing.check(loaded.project):
            edits = finding.fix.edits if finding.fix else ()
            if edits and edits not in done:
                done.add(edits)
                entry = ReportEntry(EntryKind.DONE, "xacro needs its prefix here", finding.at, authority=_AUTHORITY)
                yield Proposal(edits, entries=(entry,), fixes=("UC018",))


PREFIXES = Step(
    name="xacro-prefixes",
    part=Part.URDF,
    summary="Tags of xacro without their prefix",
    propose=_prefixes,
    generation=1,
    rows=(Row("<NAME> of a macro", "<xacro:NAME>", "", _AUTHORITY),),
    before=[
        {
            "arm.xacro": """
                <robot name="arm" xmlns:xacro="http://www.ros.org/wiki/xacro">
                  <xacro:macro name="part" params="name">
                    <link name="${name}"/>
                  </xacro:macro>
                  <part name="base"/>
                </robot>
            """,
        },
    ],
    after=[
        {
            "arm.xacro": """
                <robot name="arm" xmlns:xacro="http://www.ros.org/wiki/xacro">
                  <xacro:macro name="part" params="name">
                    <link name="${name}"/>
                  </xacro:macro>
                  <xacro:part name="base"/>
                </robot>
            """,
        },
    ],
)
