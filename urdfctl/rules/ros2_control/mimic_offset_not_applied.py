"""UC367."""

from __future__ import annotations

from collections.abc import Iterator

from urdfctl.catalog.distros import ROS2
from urdfctl.control.hardware.behaviour import behaviour_of
from urdfctl.rule import Finding, Note, Project, Severity, rule
from urdfctl.rules.common import robot_in
from urdfctl.rules.ros2_control.common import components

_ROBOT = """
    <link name="finger">
      <inertial><mass value="1"/><inertia ixx="0.01" ixy="0" ixz="0" iyy="0.01" iyz="0" izz="0.01"/></inertial>
    </link>
    <joint name="finger_joint" type="revolute">
      <parent link="fore"/><child link="finger"/><axis xyz="0 0 1"/>
      <limit lower="-3" upper="3" effort="1" velocity="4"/>
      <mimic joint="elbow" multiplier="-1" offset="%s"/>
    </joint>
    <ros2_control name="arm" type="system">
      <hardware><plugin>%s</plugin></hardware>
      <joint name="elbow"><command_interface name="position"/><state_interface name="position"/></joint>
      <joint name="finger_joint"><state_interface name="position"/></joint>
    </ros2_control>
"""
_PLUGIN = """
    <gazebo>
      <plugin filename="gz_ros2_control-system" name="gz_ros2_control::GazeboSimROS2ControlPlugin">
        <parameters>/opt/arm/controllers.yaml</parameters>
      </plugin>
    </gazebo>
"""
_GZ, _MOCK = "gz_ros2_control/GazeboSimSystem", "mock_components/GenericSystem"


@rule(
    "UC367",
    severity=Severity.WARNING,
    runtime="misbehaves",
    distros=ROS2,
    whole_robot=True,
    authority="gz_ros2_control gz_system.cpp write(): position_mimic_joint - position_mimicked_joint * mimic_joint.multiplier; "
    "mock_components generic_system.cpp read() up to iron: multiplier * state of the mimicked joint",
    options=["--distro=jazzy"],
    bad=[{"robot.urdf": _ROBOT % ("«0.5»", _GZ) + _PLUGIN}],
    good=[
        {"robot.urdf": _ROBOT % ("0", _GZ) + _PLUGIN},
        {"robot.urdf": _ROBOT % ("0.5", _MOCK)},
    ],
)
def mimic_offset_not_applied(project: Project) -> Iterator[Finding]:
    """Offset of a mimic joint is not applied.

    The hardware moves the joint to multiplier * position of the other joint, without the `offset` of <mimic>. RViz and
    robot_state_publisher apply it, so that the robot looks different there. Put the offset into the origin of the joint.
    """
    robot = robot_in(project)
    offsets = {joint.name: joint.mimic for joint in robot.joints if joint.mimic and joint.mimic.offset} if robot else {}
    for control in components(project) if offsets else ():
        steps = [behaviour_of(project.catalog, control.plugin, distro, "mimic") for distro in project.distros]
        if not steps or any(step is None or step.offset for step in steps):
            continue
        for part in control.parts:
            mimic = offsets.get((part.name or "").strip())
            if mimic is None or mimic.offset is None or not mimic.offset.value:
                continue
            message = f"'{control.plugin}' moves mimic joint '{part.name}' without its offset; put it into the joint's <origin>"
            yield Finding(mimic.offset.at, message, (Note("the joint is simulated here", part.at),))
