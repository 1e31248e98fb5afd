"""UC516."""

from __future__ import annotations

from collections.abc import Iterator

from urdfctl.control.hardware.simulator_plugins import loaded_plugins
from urdfctl.rule import Finding, Project, Severity, rule
from urdfctl.rules.common import KnownNames, is_known, replaced, whole_robot_in


@rule(
    "UC516",
    severity=Severity.WARNING,
    runtime="drops",
    because="the rest of the robot runs without the plugin",
    whole_robot=True,
    in_library=False,
    authority="gazebo_plugins gazebo_ros_p3d.cpp: 'bodyName: forearm does not exist'; gazebo_ros_force.cpp: 'link named: "
    "forearm does not exist'",
    bad=[
        {
            "robot.urdf": """
                <gazebo>
                  <plugin name="pose" filename="libgazebo_ros_p3d.so">
                    <bodyName>«forearm»</bodyName>
                    <topicName>pose</topicName>
                  </plugin>
                </gazebo>
            """,
        },
        {
            "options": "--distro=humble",
            "robot.urdf": """
                <gazebo>
                  <plugin name="pose" filename="libgazebo_ros_p3d.so">
                    <body_name>«forearm»</body_name>
                  </plugin>
                </gazebo>
                <gazebo>
                  <plugin name="drive" filename="libgazebo_ros_diff_drive.so">
                    <left_joint>shoulder</left_joint>
                    <right_joint>elbow</right_joint>
                    <wheel_separation>0.3</wheel_separation>
                    <wheel_diameter>0.1</wheel_diameter>
                    <robot_base_frame>base_footprint</robot_base_frame>
                  </plugin>
                </gazebo>
            """,
        },
    ],
    good=[
        {
            "robot.urdf": """
                <gazebo>
                  <plugin name="pose" filename="libgazebo_ros_p3d.so">
                    <bodyName>fore</bodyName>
                    <topicName>pose</topicName>
                  </plugin>
                </gazebo>
            """,
        },
        {
            "options": "--distro=noetic",
            "robot.urdf": """
                <gazebo>
                  <plugin name="drive" filename="libgazebo_ros_diff_drive.so">
                    <leftJoint>shoulder</leftJoint>
                    <rightJoint>elbow</rightJoint>
                    <wheelSeparation>0.3</wheelSeparation>
                    <wheelDiameter>0.1</wheelDiameter>
                    <robotBaseFrame>base_footprint</robotBaseFrame>
                  </plugin>
                </gazebo>
            """,
        },
    ],
)
def plugin_link_unknown(project: Project) -> Iterator[Finding]:
    """Plugin names an unknown link.

    The plugin does not start. The base frame of a drive's odometry can have any name and is not checked.
    """
    robot = whole_robot_in(project)
    if robot is None:
        return
    names = KnownNames(link.name for link in robot.links)
    for sim_plugin in loaded_plugins(project):
        children = sim_plugin.children
        for setting, tag in sim_plugin.settings():
            child = children.get(setting)
            name = tag.text
            if child is None or child.names != "link" or setting in _FRAMES or not name or not is_known(name):
                continue
            if name in names or "::" in name or name == "world":
                continue
            meant = names.meant_by(name)
            hint = f"; did you mean '{meant}'?" if meant else ""
            at = tag.at.content
            message = f"'{sim_plugin.filename}' names link '{name}', which the robot does not have{hint}"
            yield Finding(at, message, fix=replaced(at, name, meant) if meant else None)


_FRAMES = {"robotBaseFrame", "robot_base_frame"}
