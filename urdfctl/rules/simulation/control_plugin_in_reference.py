"""UC510."""

from __future__ import annotations

from collections.abc import Iterator

from urdfctl.control.hardware.simulator_plugins import loaded_plugins
from urdfctl.rule import Finding, Fix, Project, Severity, rule
from urdfctl.rules.common import robot_in


@rule(
    "UC510",
    severity=Severity.WARNING,
    runtime="ignores",
    authority="gazebo physics/Model.cc, Model::LoadPlugins: only the plugins of a model; gz-sim: 'is not a model. Please "
    "make sure that Gazebo ROS 2 Control is attached to a valid model.'",
    bad=[
        {
            "robot.urdf": """
                <gazebo reference="upper">
                  «<plugin name="gazebo_ros_control" filename="libgazebo_ros_control.so"/>»
                </gazebo>
            """,
        },
    ],
    good=[
        {
            "robot.urdf": """
                <gazebo>
                  <plugin name="gazebo_ros_control" filename="libgazebo_ros_control.so"/>
                </gazebo>
            """,
        },
    ],
)
def control_plugin_in_reference(project: Project) -> Iterator[Finding]:
    """Control or drive plugin inside `<gazebo reference="...">`.

    The content of such an element becomes part of that link or joint. Gazebo loads these plugins only for the whole
    model.
    """
    robot = robot_in(project)
    inside = (
        {plugin.at for gazebo in robot.gazebos if gazebo.reference for plugin in gazebo.plugins} if robot else set()
    )
    for sim_plugin in loaded_plugins(project):
        if sim_plugin.plugin.at in inside and (sim_plugin.hosts_control or sim_plugin.drives):
            message = (
                f"'{sim_plugin.filename}' is a plugin of the whole robot; it is not loaded inside <gazebo reference>"
            )
            yield Finding(sim_plugin.plugin.at, message, fix=Fix("move it to a <gazebo> without reference"))
