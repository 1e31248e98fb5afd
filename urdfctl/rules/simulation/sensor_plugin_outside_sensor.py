"""UC530."""

from __future__ import annotations

from collections.abc import Iterator

from urdfctl.rule import Finding, Fix, Project, Severity, rule
from urdfctl.rules.simulation.common import loaded
from urdfctl.rules.simulation.facts import OF_SENSORS


@rule(
    "UC530",
    severity=Severity.WARNING,
    authority="gazebo physics/Model.cc: 'is attempting to load a plugin, but detected an incorrect plugin type. Plugin "
    "filename[libgazebo_ros_camera.so]'",
    bad={
        "robot.urdf": """
            <gazebo reference="fore">
              «<plugin name="camera" filename="libgazebo_ros_camera.so"/>»
            </gazebo>
        """,
    },
    good={
        "robot.urdf": """
            <gazebo reference="fore">
              <sensor type="camera" name="camera">
                <plugin name="camera" filename="libgazebo_ros_camera.so"/>
              </sensor>
            </gazebo>
        """,
    },
)
def sensor_plugin_outside_sensor(project: Project) -> Iterator[Finding]:
    """The plugin of a sensor stands in no `<sensor>`.

    It publishes what the sensor around it measures. As a plugin of the robot it is of the wrong type, and not loaded.
    """
    for one in loaded(project):
        if one.library in OF_SENSORS:
            message = f"'{one.filename}' is the plugin of a sensor, and is not loaded outside of a <sensor>"
            fix = Fix('write it in <gazebo reference="link"><sensor type="..." name="...">')
            yield Finding(one.plugin.at, message, fix=fix)
