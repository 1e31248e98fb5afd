"""UC666."""

from __future__ import annotations

from collections.abc import Iterator

from urdfctl.catalog.distros import ROS2
from urdfctl.rule import Finding, Project, Severity, rule
from urdfctl.rules.common import KnownNames, is_known, replaced
from urdfctl.rules.moveit.common import is_of_other_robot, planning
from urdfctl.rules.moveit.samples import LIMITS, planned


@rule(
    "UC666",
    severity=Severity.WARNING,
    runtime="ignores",
    distros=ROS2,
    whole_robot=True,
    in_library=False,
    options=("--distro=humble",),
    authority="moveit_ros_planning robot_model_loader.cpp configure(): limits are read by the names of the robot's own joints",
    bad=[planned(joint_limits=LIMITS.replace("elbow:", "«elbow_joint»:"))],
    good=[planned(joint_limits=LIMITS)],
)
def limits_joint_unknown(project: Project) -> Iterator[Finding]:
    """joint_limits.yaml names an unknown joint.

    MoveIt ignores the entry without a message. The joint that was meant has the limits of the URDF, and no acceleration
    limit.
    """
    groups, moveit = planning(project), project.moveit
    if groups is None or moveit is None or is_of_other_robot(project):
        return
    names = KnownNames(groups.joints)
    for limits in moveit.limits:
        joint = limits.joint
        variable = joint.text.rpartition("/")[0]
        if (
            joint.text in names
            or variable in groups.virtual
            or joint.text in groups.virtual
            or not is_known(joint.text)
        ):
            continue
        meant = names.meant_by(joint.text)
        hint = f"; did you mean '{meant}'?" if meant else ""
        fix = replaced(joint.at, joint.text, meant) if meant else None
        message = f"joint_limits.yaml limits joint '{joint.text}', which the robot does not have{hint}"
        yield Finding(joint.at, message, (), fix)
