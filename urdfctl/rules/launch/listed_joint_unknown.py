"""UC619."""

from __future__ import annotations

from collections.abc import Iterator

from urdfctl.rule import Finding, Project, Severity, rule
from urdfctl.rules.common import replaced
from urdfctl.suggest import nearest


def _files(names: str) -> dict[str, str]:
    return {"urdf/arm.urdf": "", "config/joint_names_arm.yaml": f"controller_joint_names: [{names}]"}


@rule(
    "UC619",
    severity=Severity.WARNING,
    whole_robot=True,
    in_library=False,
    authority="industrial_core industrial_robot_client: the joints of controller_joint_names are those that are streamed and "
    "reported: 'mismatched number of joints'; joint_trajectory_action: 'Joint trajectory action failing on invalid joints'",
    bad=_files("shoulder, elbow, «wrist»"),
    good=_files("shoulder, elbow"),
)
def listed_joint_unknown(project: Project) -> Iterator[Finding]:
    """A package lists a joint for the robot's driver that the robot does not have.

    The driver streams and reports the joints of controller_joint_names, in that order. One more than the robot has shifts
    the others, or lets each trajectory fail.
    """
    joints = {joint.name for joint in project.robot.joints if joint.name} if project.robot else set()
    unknown = [(name, at) for name, at in project.listed if name and name not in joints]
    if len(unknown) * 2 > len(project.listed):  # then it is another robot's list
        return
    left = joints - {name for name, _ in project.listed}
    for name, at in unknown:
        meant = nearest(name, left)
        hint = f"; did you mean '{meant}'?" if meant else ""
        fix = replaced(at, name, meant) if meant else None
        yield Finding(at, f"'{name}' is listed for the robot's driver, and the robot has no such joint{hint}", (), fix)
