"""UC645."""

from __future__ import annotations

from collections.abc import Iterator

from urdfctl.catalog.distros import ROS2
from urdfctl.rule import Finding, Fix, Project, Severity, rule
from urdfctl.rules.common import is_known
from urdfctl.rules.launch.common import ROS_2, launch_of
from urdfctl.rules.launch_samples import PUBLISHER, launched

_DESCRIPTION, _ENDINGS = "robot_description", (".urdf", ".xacro", ".sdf")
_READERS = ("robot_state_publisher", "ros2_control_node", "move_group", "rviz2")
"""The programs that read the parameter as XML. That of Webots takes a path."""


@rule(
    "UC645",
    severity=Severity.ERROR,
    runtime="refuses",
    distros=ROS2,
    authority="robot_state_publisher src/robot_state_publisher.cpp setupURDF(): 'Unable to initialize urdf::model from robot "
    "description'; it reads the parameter as XML",
    bad=[
        launched(
            PUBLISHER.replace('"robot_description"', '"«robot_description»"').replace(
                "$(command 'xacro $(find-pkg-share arm)/arm.urdf')", "$(find-pkg-share arm)/arm.urdf"
            )
        ),
        {
            "arm.launch.xml": """
                <launch>
                  <node pkg="controller_manager" exec="ros2_control_node">
                    <param name="«robot_description»" value="arm.urdf.xacro"/>
                  </node>
                  <node pkg="moveit_ros_move_group" exec="move_group"><param name="«robot_description»" value="arm.urdf"/></node>
                  <node pkg="rviz2" exec="rviz2"><param name="«robot_description»" value="arm.sdf"/></node>
                </launch>
            """,
        },
    ],
    good=[launched(PUBLISHER)],
)
def description_is_a_path(project: Project) -> Iterator[Finding]:
    """Node gets the path of the robot description, not its text.

    The parameter `robot_description` holds the XML itself. A node that gets a path reads it as XML and rejects it:
    robot_state_publisher exits, and the controller manager has no robot.
    """
    launch = launch_of(project, ROS_2)
    for node in launch.nodes if launch else ():
        value = dict(node.values).get(_DESCRIPTION, "")
        if (
            not node.sure
            or node.executable.text not in _READERS
            or not is_known(value)
            or "<" in value
            or not value.endswith(_ENDINGS)
        ):
            continue
        at = next(word.at for word in node.parameters if word.text == _DESCRIPTION)
        message = f"'{_DESCRIPTION}' is the path '{value.rpartition('/')[2]}', but must be the text of the description"
        yield Finding(
            at, message, fix=Fix("pass what xacro prints: Command(['xacro ', path]) or $(command 'xacro path')")
        )
