"""A planning group of MoveIt, as a user asks for it, and the links that it is about."""

from __future__ import annotations

import re
from collections.abc import Iterator, Mapping, Sequence

from urdfctl.errors import UserError
from urdfctl.generate.robot.facts import LinkFacts
from urdfctl.names import did_you_mean
from urdfctl.startup.records import NamedTuple

_GIVEN = re.compile(r"([^=:,]+)=([^=:,]+):([^=:,]+)")
_LISTED = re.compile(r"([^=:]+)=([^=:]+)")


class PlanningGroup(NamedTuple):
    """A planning group: its joints, and the links at the ends of its chain, if it is one.

    mount: for a tool, the link that it is attached to. carrier: the group that moves this link. links: of a tool
    without joints.
    """

    name: str
    joints: tuple[str, ...]
    base: str | None = None
    tip: str | None = None
    mount: str | None = None
    carrier: str | None = None
    links: tuple[str, ...] = ()


class LinkTree:
    """The links of a robot: what carries each, and what it carries."""

    def __init__(self, links: Sequence[LinkFacts]) -> None:
        self.links: Mapping[str, LinkFacts] = {link.name: link for link in links}
        self.of_joint: Mapping[str, LinkFacts] = {link.joint: link for link in links if link.joint}
        self.root = links[0].name
        self._below: dict[str, list[LinkFacts]] = {}
        for link in links:
            self._below.setdefault(link.parent, []).append(link)

    def up(self, name: str) -> Iterator[LinkFacts]:
        """Yield a link and those that carry it, up to the root."""
        while name:
            yield self.links[name]
            name = self.links[name].parent

    def moving(self, base: str, tip: str) -> list[str] | None:
        """Return the joints that move between two links; None if the first does not carry the second."""
        found: list[str] = []
        for link in self.up(tip):
            if link.name == base:
                return found[::-1]
            if link.type != "fixed":
                found.append(link.joint)
        return None

    def welded(self, name: str) -> list[str]:
        """Return a link and all that are fixed to it below, from there outwards."""
        found = [name]
        for one in found:
            found += [link.name for link in self._below.get(one, ()) if link.type == "fixed"]
        return found


def asked_group(text: str, tree: LinkTree) -> PlanningGroup:
    """Return a group as a user writes it: NAME=BASE:TIP, or NAME=JOINT,JOINT. UserError if the robot has it not."""
    chain, listed = _GIVEN.fullmatch(text), _LISTED.fullmatch(text)
    if chain:
        name, base, tip = (part.strip() for part in chain.groups())
        for link in (base, tip):
            if link not in tree.links:
                raise UserError(f"--group {name}: the robot has no link '{link}'{did_you_mean(link, tree.links)}")
        moving = tree.moving(base, tip)
        if not moving:
            why = "no joint moves between" if moving is not None else "no chain leads from"
            raise UserError(f"--group {name}: {why} '{base}' {'and' if moving is not None else 'to'} '{tip}'")
        return PlanningGroup(name, tuple(moving), base, tip)
    if listed:
        name, joints = listed[1].strip(), tuple(part.strip() for part in listed[2].split(",") if part.strip())
        for joint in joints:
            if joint not in tree.of_joint:
                raise UserError(f"--group {name}: the robot has no joint '{joint}'{did_you_mean(joint, tree.of_joint)}")
        return PlanningGroup(name, joints)
    raise UserError(f"--group must be NAME=BASE:TIP or NAME=JOINT,JOINT, not '{text}'")
