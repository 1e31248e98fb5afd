"""Read which controllers the user asks for, and for which joints: NAME=TYPE[INTERFACES]:JOINTS."""

from __future__ import annotations

import re
from collections.abc import Iterable, Iterator, Sequence

from urdfctl.errors import UserError
from urdfctl.generate.options import Request
from urdfctl.generate.request.choice import no_match, regex_of
from urdfctl.generate.robot.facts import JointFacts, RobotFacts

_FORM = "--controller NAME=TYPE or NAME=TYPE[INTERFACE]:JOINTS, e.g. arm=trajectory:'joint_.*'"
_NAME = re.compile(r"[A-Za-z_][A-Za-z0-9_]*")
_KIND = re.compile(r"([^\[\]]+?)\s*(?:\[([^\[\]]*)\])?")


def requested(texts: Iterable[str]) -> tuple[Request, ...]:
    """Return the controllers that the options ask for. UserError if one is malformed, or if two have one name."""
    found: dict[str, Request] = {}
    for text in texts:
        request = _request(text)
        if request.name in found:
            raise UserError(f"two controllers are called '{request.name}'; give each --controller its own name")
        found[request.name] = request
    return tuple(found.values())


def _request(text: str) -> Request:
    name, equals, rest = text.partition("=")
    kind, _, joints = _at_first_colon(rest)
    read = _KIND.fullmatch(kind.strip())
    interfaces = tuple(_parts(read[2] or "")) if read else ()
    if not equals or read is None or (read[2] is not None and not interfaces):
        raise UserError(f"'{text}' is not a controller: write {_FORM}")
    if not _NAME.fullmatch(name.strip()):
        raise UserError(f"'{name}' cannot be a controller's name: use letters, digits and underscores")
    return Request(name.strip(), read[1], tuple(_parts(joints)), interfaces=interfaces)


def _at_first_colon(text: str) -> tuple[str, str, str]:
    """A text before and after its first colon that is not one of two, as in the full name of a class."""
    match = re.search(r"(?<!:):(?!:)", text)
    return (text[: match.start()], ":", text[match.end() :]) if match else (text, "", "")


def _parts(text: str) -> Iterator[str]:
    """The parts between commas outside brackets."""
    depth, part = 0, ""
    for c in text:
        depth += (c in "([{") - (c in ")]}")
        if c == "," and depth <= 0:
            yield from [part.strip()] if part.strip() else []
            part = ""
        else:
            part += c
    yield from [part.strip()] if part.strip() else []


def of_list(joints: Sequence[JointFacts], default: str | None) -> tuple[Request, ...]:
    """Return the controllers that the columns of a joint list ask for.

    default: the type of a controller of which the list gives only the name. UserError if there is none.
    """
    members: dict[tuple[str, str], list[str]] = {}
    for joint in joints:
        kind = joint.controller_type or default
        if joint.controller and not kind:
            raise UserError(f"controller '{joint.controller}' has no type: add a column `controller_type`, or --type")
        if kind and (joint.controller or joint.controller_type):
            members.setdefault((joint.controller or "", kind), []).append(joint.name)
    names = [name for name, _ in members if name]
    twice = next((name for name in names if names.count(name) > 1), None)
    if twice:
        kinds = " and ".join(kind for name, kind in members if name == twice)
        raise UserError(f"the joint list gives controller '{twice}' two types: {kinds}")
    return tuple(Request(name, kind, tuple(joints)) for (name, kind), joints in members.items())


def joints_of(request: Request, joints: Sequence[JointFacts], robot: RobotFacts) -> tuple[JointFacts, ...]:
    """Return the joints that a request names, in their order. UserError if a pattern matches none."""
    by_name = {joint.name: joint for joint in joints}
    found: dict[str, JointFacts] = {}
    for pattern in request.patterns:
        regex = regex_of(pattern)
        matching = [by_name[pattern]] if pattern in by_name else [j for j in joints if regex.fullmatch(j.name)]
        if not matching:
            raise UserError(_why_none(request, pattern, by_name, robot))
        found.update({joint.name: joint for joint in matching})
    return tuple(found.values())


def _why_none(request: Request, pattern: str, known: Iterable[str], robot: RobotFacts) -> str:
    follower = next((joint for joint in robot.joints if joint.name == pattern and joint.mimic), None)
    if follower and follower.mimic:
        return f"joint '{pattern}' mimics '{follower.mimic[0]}'; command that joint in '{request.name}'"
    return f"controller '{request.name}': {no_match(pattern, list(known))}"
