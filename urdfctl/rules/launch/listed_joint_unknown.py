"""UC619."""

from __future__ import annotations

from collections.abc import Iterator

from urdfctl.names import nearest
from urdfctl.rule import Finding, Project, Severity, rule
from urdfctl.rules.common import replaced


def _files(names: str) -> dict[str, str]:
    return {"urdf/arm.urdf": "", "config/joint_names_arm.yaml": f"controller_joint_names: [{names}]"}


@rule(
    "UC619",
    runtime="misbehaves",
    severity=Severity.WARNING,
    whole_robot=True,
    in_library=False,
    authority="industrial_core industrial_robot_client: the joints of controller_joint_names are those that are streamed and "
    "reported: 'mismatched number of joints'; joint_trajectory_action: 'Joint trajectory action failing on invalid joints'",
    bad=[_files("shoulder, elbow, «wrist»")],
    good=[_files("shoulder, elbow")],
)
def listed_joint_unknown(project: Project) -> Iterator[Finding]:
    """Unknown joint in controller_joint_names.

    The robot's driver streams and reports these joints in the listed order. An extra joint shifts the others, or every
    trajectory fails.
    """
    joints = {joint.name for joint in project.robot.joints if joint.name} if project.robot else set()
    unknown = [(name, at) for name, at in project.listed if name and name not in joints]
    if len(unknown) * 2 > len(project.listed):  # the list is for another robot
        return
    left = joints - {name for name, _ in project.listed}
    for name, at in unknown:
        meant = nearest(name, left)
        hint = f"; did you mean '{meant}'?" if meant else ""
        fix = replaced(at, name, meant) if meant else None
        yield Finding(at, f"controller_joint_names lists joint '{name}', which the robot does not have{hint}", (), fix)
