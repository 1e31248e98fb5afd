"""UC206."""

from __future__ import annotations

from collections.abc import Iterator, Mapping

from urdfctl.catalog.distros import ROS1
from urdfctl.control.hardware.gazebo_ros1 import control_plugins, in_gazebo
from urdfctl.model.robot import Joint, Robot, Transmission, TransmissionEnd
from urdfctl.names import is_only_slip, nearest
from urdfctl.rule import Finding, Project, Severity, rule
from urdfctl.rules.links_for_joints import joint_meant_by, links_called
from urdfctl.rules.transmissions.common import joints_by_name, known_joints
from urdfctl.rules.transmissions.wrong_calls import WrongCall, macro_call, wrong_calls
from urdfctl.rules.written import at_written
from urdfctl.source.span import Call


@rule(
    "UC206",
    severity=Severity.ERROR,
    runtime="refuses",
    distros=ROS1,
    authority="gazebo_ros_pkgs gazebo_ros_control/src/default_robot_hw_sim.cpp: 'This robot has a joint named "
    '"<joint>" which is not in the gazebo model.\'',
    whole_robot=True,
    bad=[
        {
            "robot.urdf": """
                <transmission name="elbow_trans">
                  <type>transmission_interface/SimpleTransmission</type>
                  <joint name="«elbw»">
                    <hardwareInterface>hardware_interface/EffortJointInterface</hardwareInterface>
                  </joint>
                  <actuator name="elbow_motor">
                    <mechanicalReduction>1</mechanicalReduction>
                  </actuator>
                </transmission>
            """,
        },
    ],
    good=[
        {
            "robot.urdf": """
                <transmission name="elbow_trans">
                  <type>transmission_interface/SimpleTransmission</type>
                  <joint name="elbow">
                    <hardwareInterface>hardware_interface/EffortJointInterface</hardwareInterface>
                  </joint>
                  <actuator name="elbow_motor">
                    <mechanicalReduction>1</mechanicalReduction>
                  </actuator>
                </transmission>
            """,
        },
    ],
)
def transmission_joint_unknown(project: Project) -> Iterator[Finding]:
    """Unknown joint in a transmission.

    Gazebo's hardware simulation stops there, and there is no controller manager. Real hardware offers a joint that is
    in no joint state and no controller, and lacks the intended joint. If a macro from another file names several
    joints, and none is similar to a joint of the robot, the macro belongs to another robot. Then its call is reported.
    If other plugins of Gazebo move the robot, nothing that is known reads its transmissions: a warning.
    """
    robot = project.robot
    if robot is None or not robot.joints:
        return
    severity = _severity(project, robot)
    known = joints_by_name(project)
    named = list(known_joints(project))
    if all(name in known for _, _, name in named):
        return
    taken = {name for _, _, name in named}
    wrong = _wrong_calls(robot, named, known)
    for call in wrong.values():
        yield call.finding._replace(severity=severity)
    for transmission, joint, name in named:
        if name in known or macro_call(joint.at) in wrong:
            continue
        right, is_sure = joint_meant_by(robot, name, nearest(name, known.keys() - taken), taken)
        hint = f"; did you mean '{right}'?" if right else ""
        message = f"{transmission.label} names joint '{name}', which the robot does not have{hint}"
        is_sure = is_sure or (right is not None and is_only_slip(name, right, known))
        finding = at_written(joint.at["name"], name, right, message, tuple(links_called(robot, name)), safe=is_sure)
        yield finding._replace(severity=severity)


def _severity(project: Project, robot: Robot) -> Severity:
    gazebo = in_gazebo(project)
    is_moved_by_others = bool(robot.plugins) and not control_plugins(project) and project.controllers is None
    return Severity.ERROR if gazebo and (gazebo is Severity.ERROR or not is_moved_by_others) else Severity.WARNING


def _wrong_calls(
    robot: Robot, named: list[tuple[Transmission, TransmissionEnd, str]], known: Mapping[str, Joint]
) -> dict[Call | None, WrongCall]:
    """The calls of macros whose transmissions belong to another robot."""
    places = ((joint.at["name"], name) for _, joint, name in named)
    return wrong_calls(robot, places, lambda name: name in known or nearest(name, known) is not None)
