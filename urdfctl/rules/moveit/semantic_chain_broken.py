"""UC659."""

from __future__ import annotations

from collections.abc import Iterator

from urdfctl.rule import Finding, Project, Severity, rule
from urdfctl.rules.moveit.common import planning
from urdfctl.rules.moveit.samples import planned

_ALONE = """
      «<chain base_link="base"/>»"""


@rule(
    "UC659",
    runtime="drops",
    severity=Severity.ERROR,
    whole_robot=True,
    in_library=False,
    authority="srdfdom src/model.cpp loadGroups(): 'Base link name not specified for chain', \"Links 'a' and 'b' do not form a "
    "chain. Not included in group 'arm'\"",
    bad=[planned('<chain base_link="base" tip_link="fore"/>', _ALONE)],
    good=[planned()],
)
def semantic_chain_broken(project: Project) -> Iterator[Finding]:
    """Chain of a planning group does not connect two links.

    A chain needs base_link and tip_link, and a path of joints between them. MoveIt drops other chains from the group.
    """
    groups = planning(project)
    for group in groups.semantic.groups if groups else ():
        for chain in group.chains:
            if chain.base is None or chain.tip is None:
                lacking = "base_link" if chain.base is None else "tip_link"
                yield Finding(chain.at, f"the chain of group '{group.name.text}' has no {lacking}")
            elif groups and {chain.base.text, chain.tip.text} <= groups.links and not groups.joins(chain):
                ends = f"'{chain.base.text}' and '{chain.tip.text}'"
                yield Finding(chain.at, f"the chain of group '{group.name.text}' is broken: no joints connect {ends}")
