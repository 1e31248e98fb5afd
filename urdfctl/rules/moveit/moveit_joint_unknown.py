"""UC654."""

from __future__ import annotations

from collections.abc import Iterator

from urdfctl.catalog.distros import ROS1
from urdfctl.rule import Finding, Project, Severity, rule
from urdfctl.rules.common import is_known, replaced, whole_robot_in
from urdfctl.suggest import nearest


def _files(joints: str) -> dict[str, str]:
    return {"robot.urdf": "", "fake_controllers.yaml": f"controller_list: [{{name: fake_arm, joints: [{joints}]}}]"}


@rule(
    "UC654",
    severity=Severity.WARNING,
    distros=ROS1,
    whole_robot=True,
    in_library=False,
    options=["--distro=noetic"],
    authority="moveit trajectory_execution_manager.cpp: 'Unable to identify any set of controllers that can actuate the "
    "specified joints'; robot_model_loader.cpp reads limits by the names of the robot's own joints",
    bad=_files("shoulder, «elbow_joint»"),
    good=_files("shoulder, elbow"),
)
def moveit_joint_unknown(project: Project) -> Iterator[Finding]:
    """MoveIt is told of a joint that the robot does not have.

    No plan moves it, and the joint that was meant has no controller, so that plans for it are not executed, or keeps the
    limits of the URDF. Told are joints that are like one of the robot's, or listed beside others that it has.
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
                continue  # it is a part that this robot comes without
            what = "has limits for MoveIt" if listed.controller is None else f"is listed for '{listed.controller}'"
            hint = f"; did you mean '{meant}'?" if meant else ""
            fix = replaced(joint.at, joint.text, meant) if meant else None
            yield Finding(joint.at, f"'{joint.text}' {what}, and the robot has no such joint{hint}", (), fix)
