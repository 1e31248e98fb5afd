"""UC164."""

from __future__ import annotations

from collections.abc import Iterator

from urdfctl.rule import Finding, Project, Severity, rule
from urdfctl.rules.common import is_known, label, robot_in

_LARGEST = {"effort": 1e12, "velocity": 1e6}
"""From this on a limit limits nothing that a robot can do."""
_WRIST = """
    <link name="tool">
      <inertial><mass value="1"/><inertia ixx="0.01" ixy="0" ixz="0" iyy="0.01" iyz="0" izz="0.01"/></inertial>
    </link>
    <joint name="wrist" type="revolute">
      <parent link="fore"/><child link="tool"/>
      <limit lower="-1" upper="1" effort="%s" velocity="%s"/>
    </joint>
"""


@rule(
    "UC164",
    severity=Severity.WARNING,
    runtime="misbehaves",
    authority="urdfdom urdf_parser/src/joint.cpp parseJointLimits() takes every number; sdformat: a negative effort or velocity "
    "is no limit; joint_limits_interface joint_limits_interface.h: clamps the command to [-max, max]",
    bad=[
        {"robot.urdf": _WRIST % ("«-5»", "2")},
        {"robot.urdf": _WRIST % ("5", "«-2»")},
        {"robot.urdf": _WRIST % ("«1e30»", "«1e9»")},
    ],
    good=[{"robot.urdf": _WRIST % ("5", "2")}],
)
def limit_negative(project: Project) -> Iterator[Finding]:
    """Effort or velocity limit that is negative, or so large that it limits nothing.

    urdfdom accepts it. In Gazebo a negative limit is none at all, so nothing protects the joint. Others clamp each
    command between the limit and its negative, which is an empty range, and the joint does not follow.
    """
    robot = robot_in(project)
    for joint in robot.joints if robot else ():
        tag = next(joint.tag.named("limit"), None) if joint.moves else None
        for name, largest in _LARGEST.items() if tag else ():
            text = tag.attributes.get(name, "") if tag else ""
            value = _number(text)
            if tag is None or value is None or 0 <= value < largest:
                continue
            wrong = "is negative" if value < 0 else "limits nothing"
            message = f"{name} limit of {label('joint', joint.name)} {wrong}: '{text.strip()}'"
            yield Finding(tag.at[name], message)


def _number(text: str) -> float | None:
    try:
        return float(text) if is_known(text) else None
    except ValueError:
        return None
