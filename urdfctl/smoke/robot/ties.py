"""The joints that `<gazebo>` adds to a robot in SDF: they close loops, which a tree of links cannot have."""

from __future__ import annotations

from urdfctl.model.robot import Robot

_ENDS = ("parent", "child")


def ties_of(robot: Robot) -> list[str]:
    """Return the names of the joints that `<gazebo>` adds between links, in their order."""
    joints = (child for gazebo in robot.gazebos for child in gazebo.tag.named("joint"))
    whole = (joint for joint in joints if all(any(joint.named(end)) for end in _ENDS))
    return [joint.attributes.get("name") or "" for joint in whole]
