"""UC515."""

from __future__ import annotations

from collections.abc import Iterator

from urdfctl.control.hardware.simulator_plugins import loaded_plugins, named_joints
from urdfctl.model.robot import Robot
from urdfctl.rule import Finding, Note, Project, Severity, rule
from urdfctl.rules.common import KnownNames, is_known, whole_robot_in
from urdfctl.rules.simulation.common import default_joints


@rule(
    "UC515",
    severity=Severity.WARNING,
    runtime="drops",
    because="the rest of the robot runs without the plugin",
    whole_robot=True,
    in_library=False,
    authority="gazebo_plugins gazebo_ros_utils.h: 'couldn't get wheel hinge joint named'; gazebo_ros_diff_drive.cpp (ROS 2): "
    "'Joint [elbw] not found, plugin will not work.'; gz-sim DiffDrive.cc: 'Failed to find left joint'",
    bad=[
        {
            "robot.urdf": """
                <gazebo>
                  <plugin name="drive" filename="libgazebo_ros_diff_drive.so">
                    <leftJoint>«shouldr»</leftJoint>
                    <rightJoint>elbow</rightJoint>
                    <wheelSeparation>0.3</wheelSeparation>
                    <wheelDiameter>0.1</wheelDiameter>
                  </plugin>
                </gazebo>
            """,
        },
        {
            "robot.urdf": """
                <link name="left"><inertial><mass value="1"/><inertia ixx="0.01" ixy="0" ixz="0" iyy="0.01" iyz="0" izz="0.01"/></inertial></link>
                <link name="right"><inertial><mass value="1"/><inertia ixx="0.01" ixy="0" ixz="0" iyy="0.01" iyz="0" izz="0.01"/></inertial></link>
                <joint name="left_mount" type="fixed"><parent link="fore"/><child link="left"/></joint>
                <joint name="right_mount" type="fixed"><parent link="fore"/><child link="right"/></joint>
                <gazebo>
                  <plugin name="drive" filename="libgazebo_ros_diff_drive.so">
                    <leftJoint>«left_mount»</leftJoint>
                    <rightJoint>«right_mount»</rightJoint>
                    <wheelSeparation>0.3</wheelSeparation>
                    <wheelDiameter>0.1</wheelDiameter>
                  </plugin>
                </gazebo>
            """,
        },
        {
            "robot.urdf": """
                <gazebo>
                  «<plugin name="drive" filename="libgazebo_ros_diff_drive.so">»
                    <wheelSeparation>0.3</wheelSeparation>
                    <wheelDiameter>0.1</wheelDiameter>
                  </plugin>
                </gazebo>
            """,
        },
    ],
    good=[
        {
            "robot.urdf": """
                <gazebo>
                  <plugin name="drive" filename="libgazebo_ros_diff_drive.so">
                    <leftJoint>shoulder</leftJoint>
                    <rightJoint>elbow</rightJoint>
                    <wheelSeparation>0.3</wheelSeparation>
                    <wheelDiameter>0.1</wheelDiameter>
                  </plugin>
                </gazebo>
            """,
        },
        {
            "robot.urdf": """
                <link name="left"><inertial><mass value="1"/><inertia ixx="0.01" ixy="0" ixz="0" iyy="0.01" iyz="0" izz="0.01"/></inertial></link>
                <link name="right"><inertial><mass value="1"/><inertia ixx="0.01" ixy="0" ixz="0" iyy="0.01" iyz="0" izz="0.01"/></inertial></link>
                <joint name="left_mount" type="fixed"><parent link="fore"/><child link="left"/></joint>
                <joint name="right_mount" type="fixed"><parent link="fore"/><child link="right"/></joint>
                <gazebo reference="left_mount"><preserveFixedJoint>true</preserveFixedJoint></gazebo>
                <gazebo reference="right_mount"><disableFixedJointLumping>true</disableFixedJointLumping></gazebo>
                <gazebo>
                  <plugin name="drive" filename="libgazebo_ros_diff_drive.so">
                    <leftJoint>left_mount</leftJoint>
                    <rightJoint>right_mount</rightJoint>
                    <wheelSeparation>0.3</wheelSeparation>
                    <wheelDiameter>0.1</wheelDiameter>
                  </plugin>
                </gazebo>
            """,
        },
        {
            "robot.urdf": """
                <gazebo>
                  <link name="flag"/>
                  <joint name="mast" type="revolute">
                    <parent>fore</parent><child>flag</child><axis><xyz>0 0 1</xyz></axis>
                  </joint>
                  <plugin name="states" filename="libgazebo_ros_joint_state_publisher.so">
                    <jointName>shoulder, mast</jointName>
                  </plugin>
                </gazebo>
            """,
        },
    ],
)
def plugin_joint_unknown(project: Project) -> Iterator[Finding]:
    """Plugin names an unknown or fixed joint.

    A drive without its joint does not work; in ROS 1 Gazebo exits. Gazebo merges the links of a fixed joint, and the
    joint does not exist there.
    """
    robot = whole_robot_in(project)
    if robot is None:
        return
    plugins = loaded_plugins(project)
    used = [name for sim_plugin in plugins for name, _ in named_joints(sim_plugin)]
    names = KnownNames([*(joint.name for joint in robot.joints), *_in_sdf(robot)], taken=used)
    fixed = {joint.name for joint in robot.joints if joint.type == "fixed"} - {
        gazebo.reference for gazebo in robot.gazebos if any(child.name in _KEEPING for child in gazebo.tag.children)
    }
    for sim_plugin in plugins:
        severity = Severity.ERROR if sim_plugin.moves_joints else None
        for name, place in named_joints(sim_plugin):
            if not is_known(name) or "::" in name or (name in names and name not in fixed):
                continue
            if name in fixed:
                message = f"'{sim_plugin.filename}' names joint '{name}', which is fixed; Gazebo merges it away"
                yield Finding(place, message, severity=Severity.WARNING if sim_plugin.moves_joints else Severity.INFO)
                continue
            meant = names.meant_by(name)
            hint = f"; did you mean '{meant}'?" if meant else ""
            fix = names.fix(place, name, meant)
            message = f"'{sim_plugin.filename}' names joint '{name}', which the robot does not have{hint}"
            yield Finding(place, message, fix=fix, severity=severity)
        for setting, default in default_joints(project, sim_plugin):
            if default not in names:
                message = (
                    f"'{sim_plugin.filename}' has no <{setting}>, and the robot has no joint '{default}' (its default)"
                )
                yield Finding(
                    sim_plugin.plugin.at,
                    message,
                    (Note(f"add <{setting}> with the name of a joint"),),
                    severity=severity,
                )


def _in_sdf(robot: Robot) -> Iterator[str]:
    """The joints that <gazebo> elements add in SDF: Gazebo inserts them into the model as they are."""
    for gazebo in robot.gazebos:
        if not gazebo.reference:
            yield from (tag.attributes["name"] for tag in gazebo.tag.named("joint") if "name" in tag.attributes)


_KEEPING = {"preserveFixedJoint", "disableFixedJointLumping"}
"""Elements of <gazebo reference="joint"> that keep a fixed joint in Gazebo."""
