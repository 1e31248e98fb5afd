"""UC224."""

from __future__ import annotations

from collections.abc import Iterator

from urdfctl.catalog.distros import ROS1
from urdfctl.rule import Finding, Note, Project, Severity, rule
from urdfctl.rules.transmissions.common import joints_by_name, known_joints


@rule(
    "UC224",
    severity=Severity.WARNING,
    runtime="misbehaves",
    distros=ROS1,
    authority="gazebo_ros_pkgs gazebo_ros_control/src/default_robot_hw_sim.cpp registers each joint of a "
    "transmission separately; neither it nor ros_control reads <mimic>",
    bad=[
        {
            "robot.urdf": """
                <link name="finger">
                  <inertial><mass value="1"/><inertia ixx="0.01" ixy="0" ixz="0" iyy="0.01" iyz="0" izz="0.01"/></inertial>
                </link>
                <joint name="finger_joint" type="revolute">
                  <parent link="fore"/><child link="finger"/><axis xyz="0 0 1"/>
                  <limit lower="-1" upper="1" effort="10" velocity="2"/>
                  <mimic joint="elbow"/>
                </joint>
                <transmission name="finger_trans">
                  <type>transmission_interface/SimpleTransmission</type>
                  <joint name="«finger_joint»">
                    <hardwareInterface>hardware_interface/EffortJointInterface</hardwareInterface>
                  </joint>
                  <actuator name="finger_motor">
                    <mechanicalReduction>1</mechanicalReduction>
                  </actuator>
                </transmission>
            """,
        },
    ],
    good=[
        {
            "robot.urdf": """
                <link name="finger">
                  <inertial><mass value="1"/><inertia ixx="0.01" ixy="0" ixz="0" iyy="0.01" iyz="0" izz="0.01"/></inertial>
                </link>
                <joint name="finger_joint" type="revolute">
                  <parent link="fore"/><child link="finger"/><axis xyz="0 0 1"/>
                  <limit lower="-1" upper="1" effort="10" velocity="2"/>
                  <mimic joint="elbow"/>
                </joint>
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
def mimic_joint_in_transmission(project: Project) -> Iterator[Finding]:
    """Transmission drives a mimic joint.

    ros_control does not read <mimic>. The joint waits for its own commands and does not follow the other joint. If
    neither the controllers nor the simulator are known, it is only worth knowing.
    """
    joints = joints_by_name(project)
    is_open = project.controllers is None and project.named_simulator is None
    severity = Severity.INFO if is_open else None
    for transmission, joint, name in known_joints(project):
        driven = joints.get(name)
        if driven is not None and driven.mimic is not None:
            message = (
                f"{transmission.label} drives joint '{name}', which mimics '{driven.mimic.joint}'; "
                f"ros_control ignores <mimic>"
            )
            note = Note(
                "command both joints with controllers, or remove the transmission and use a mimic plugin",
                driven.mimic.at,
            )
            yield Finding(joint.at["name"], message, (note,), severity=severity)
