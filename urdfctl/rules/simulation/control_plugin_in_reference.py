"""UC510."""

from __future__ import annotations

from collections.abc import Iterator

from urdfctl.rule import Finding, Fix, Project, Severity, rule
from urdfctl.rules.common import robot_in
from urdfctl.rules.simulation.common import loaded


@rule(
    "UC510",
    severity=Severity.WARNING,
    authority="gazebo physics/Model.cc, Model::LoadPlugins: the plugins of a model alone; gz-sim: 'is not a model. Please "
    "make sure that Gazebo ROS 2 Control is attached to a valid model.'",
    bad={
        "robot.urdf": """
            <gazebo reference="upper">
              «<plugin name="gazebo_ros_control" filename="libgazebo_ros_control.so"/>»
            </gazebo>
        """,
    },
    good={
        "robot.urdf": """
            <gazebo>
              <plugin name="gazebo_ros_control" filename="libgazebo_ros_control.so"/>
            </gazebo>
        """,
    },
)
def control_plugin_in_reference(project: Project) -> Iterator[Finding]:
    """The plugin that moves a robot stands in a `<gazebo reference="...">`.

    What stands there becomes part of that link or joint, and Gazebo loads such plugins of the whole model alone.
    """
    robot = robot_in(project)
    inside = (
        {plugin.at for gazebo in robot.gazebos if gazebo.reference for plugin in gazebo.plugins} if robot else set()
    )
    for one in loaded(project):
        if one.plugin.at in inside and (one.hosts_control or one.drives):
            message = f"'{one.filename}' is a plugin of the whole robot, and is not loaded in <gazebo reference>"
            yield Finding(one.plugin.at, message, fix=Fix("write it in a <gazebo> without reference"))
