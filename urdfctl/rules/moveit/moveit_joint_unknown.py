"""UC654."""

from __future__ import annotations

from collections.abc import Iterator

from urdfctl.catalog.distros import ROS1
from urdfctl.names import nearest
from urdfctl.rule import Finding, Project, Severity, rule
from urdfctl.rules.common import is_known, replaced, whole_robot_in


def _files(joints: str) -> dict[str, str]:
    return {"robot.urdf": "", "fake_controllers.yaml": f"controller_list: [{{name: fake_arm, joints: [{joints}]}}]"}


@rule(
    "UC654",
    runtime="misbehaves",
    severity=Severity.WARNING,
    distros=ROS1,
    whole_robot=True,
    in_library=False,
    options=["--distro=noetic"],
    authority="moveit trajectory_execution_manager.cpp: 'Unable to identify any set of controllers that can actuate the "
    "specified joints'; robot_model_loader.cpp reads limits by the names of the robot's own joints",
    bad=[_files("shoulder, «elbow_joint»")],
    good=[_files("shoulder, elbow")],
)
def moveit_joint_unknown(project: Project) -> Iterator[Finding]:
    """Unknown joint in MoveIt's configuration.

    No plan moves this joint. The joint that was meant has no controller, so plans for it are not executed, or it keeps
    the limits of the URDF. The rule reports a joint if its name resembles a joint of the robot, or if the same list
    contains joints of the robot.
    """
    robot, controllers = whole_robot_in(project), project.controllers
    names = {name for name in robot.joint_names if name} if robot and controllers else set()
    for listed in controllers.moveit_lists if controllers and names else ():
        given = {joint.text for joint in listed.joints}
        for joint in listed.joints:
            if joint.text in names or "$" in joint.text or not is_known(joint.text):
                continue
            meant = nearest(joint.text, names - given)
            if not meant and (listed.controller is None or not given & names):
                continue  # it belongs to a part that this robot does not have
            what = "has limits for MoveIt" if listed.controller is None else f"is listed for '{listed.controller}'"
            hint = f"; did you mean '{meant}'?" if meant else ""
            fix = replaced(joint.at, joint.text, meant) if meant else None
            yield Finding(joint.at, f"joint '{joint.text}' {what}, but the robot does not have it{hint}", (), fix)
