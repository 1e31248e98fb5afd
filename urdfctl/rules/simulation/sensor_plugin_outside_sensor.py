"""UC530."""

from __future__ import annotations

from collections.abc import Iterator

from urdfctl.control.hardware.gazebo_plugins import OF_SENSORS
from urdfctl.control.hardware.simulator_plugins import loaded_plugins
from urdfctl.rule import Finding, Fix, Project, Severity, rule


@rule(
    "UC530",
    severity=Severity.WARNING,
    runtime="warns",
    authority="gazebo physics/Model.cc: 'is attempting to load a plugin, but detected an incorrect plugin type. Plugin "
    "filename[libgazebo_ros_camera.so]'",
    bad=[
        {
            "robot.urdf": """
                <gazebo reference="fore">
                  «<plugin name="camera" filename="libgazebo_ros_camera.so"/>»
                </gazebo>
            """,
        },
    ],
    good=[
        {
            "robot.urdf": """
                <gazebo reference="fore">
                  <sensor type="camera" name="camera">
                    <plugin name="camera" filename="libgazebo_ros_camera.so"/>
                  </sensor>
                </gazebo>
            """,
        },
    ],
)
def sensor_plugin_outside_sensor(project: Project) -> Iterator[Finding]:
    """Sensor plugin outside `<sensor>`.

    The plugin publishes what the enclosing sensor measures. As a plugin of the robot it has the wrong type: Gazebo
    prints an error and does not load it.
    """
    for sim_plugin in loaded_plugins(project):
        if sim_plugin.library in OF_SENSORS:
            message = f"'{sim_plugin.filename}' is a sensor plugin; it is not loaded outside <sensor>"
            fix = Fix('move it into <gazebo reference="link"><sensor type="..." name="...">')
            yield Finding(sim_plugin.plugin.at, message, fix=fix)
