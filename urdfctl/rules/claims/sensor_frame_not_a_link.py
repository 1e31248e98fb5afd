"""UC473."""

from __future__ import annotations

from collections.abc import Iterator

from urdfctl.control.parameters.readers import Reader, in_each_distro, robot_of
from urdfctl.model.controllers import ValueKind
from urdfctl.rule import Finding, Project, Severity, rule
from urdfctl.rules.common import KnownNames, replaced

_SENSOR = """
    <ros2_control name="arm" type="system">
      <hardware><plugin>mock_components/GenericSystem</plugin></hardware>
      <sensor name="tcp">
        <state_interface name="force.x"/><state_interface name="force.y"/><state_interface name="force.z"/>
      </sensor>
    </ros2_control>
"""
_BROADCASTER = """
    controller_manager:
      ros__parameters:
        update_rate: 100
        forces: {type: force_torque_sensor_broadcaster/ForceTorqueSensorBroadcaster}
    forces:
      ros__parameters:
        interface_names: {force: {x: tcp/force.x, y: tcp/force.y, z: tcp/force.z}}
        frame_id: %s
"""
_PACKAGES = (
    "force_torque_sensor_broadcaster",
    "gps_sensor_broadcaster",
    "imu_sensor_broadcaster",
    "magnetometer_broadcaster",
    "range_sensor_broadcaster",
)


@rule(
    "UC473",
    severity=Severity.WARNING,
    runtime="misbehaves",
    authority="imu_sensor_broadcaster, force_torque_sensor_broadcaster and similar types write frame_id into the header of "
    "their messages without checking it; tf2 BufferCore: '\"tpc\" passed to lookupTransform argument source_frame does not exist'",
    whole_robot=True,
    in_library=False,
    options=["--distro=jazzy"],
    bad=[
        {"robot.urdf": _SENSOR, "controllers.yaml": _BROADCASTER % "«forearm»"},
        {
            "robot.urdf": """
                <ros2_control name="arm" type="system">
                  <hardware><plugin>mock_components/GenericSystem</plugin></hardware>
                  <sensor name="tip">
                    <state_interface name="orientation.x"/>
                    <state_interface name="orientation.y"/>
                    <state_interface name="orientation.z"/>
                    <state_interface name="orientation.w"/>
                    <state_interface name="angular_velocity.x"/>
                    <state_interface name="angular_velocity.y"/>
                    <state_interface name="angular_velocity.z"/>
                    <state_interface name="linear_acceleration.x"/>
                    <state_interface name="linear_acceleration.y"/>
                    <state_interface name="linear_acceleration.z"/>
                  </sensor>
                </ros2_control>
            """,
            "controllers.yaml": """
                controller_manager:
                  ros__parameters:
                    update_rate: 100
                    tip_broadcaster: {type: imu_sensor_broadcaster/IMUSensorBroadcaster}
                tip_broadcaster:
                  ros__parameters:
                    sensor_name: tip
                    frame_id: «forearm»
            """,
        },
        {
            "robot.urdf": """
                <ros2_control name="arm" type="system">
                  <hardware><plugin>mock_components/GenericSystem</plugin></hardware>
                  <sensor name="tip">
                    <state_interface name="latitude"/>
                    <state_interface name="longitude"/>
                    <state_interface name="altitude"/>
                    <state_interface name="status"/>
                    <state_interface name="service"/>
                  </sensor>
                </ros2_control>
            """,
            "controllers.yaml": """
                controller_manager:
                  ros__parameters:
                    update_rate: 100
                    tip_broadcaster: {type: gps_sensor_broadcaster/GPSSensorBroadcaster}
                tip_broadcaster:
                  ros__parameters:
                    sensor_name: tip
                    frame_id: «forearm»
            """,
        },
        {
            "robot.urdf": """
                <ros2_control name="arm" type="system">
                  <hardware><plugin>mock_components/GenericSystem</plugin></hardware>
                  <sensor name="tip">
                    <state_interface name="magnetic_field.x"/>
                    <state_interface name="magnetic_field.y"/>
                    <state_interface name="magnetic_field.z"/>
                  </sensor>
                </ros2_control>
            """,
            "controllers.yaml": """
                controller_manager:
                  ros__parameters:
                    update_rate: 100
                    tip_broadcaster: {type: magnetometer_broadcaster/MagnetometerBroadcaster}
                tip_broadcaster:
                  ros__parameters:
                    sensor_name: tip
                    frame_id: «forearm»
            """,
        },
        {
            "robot.urdf": """
                <ros2_control name="arm" type="system">
                  <hardware><plugin>mock_components/GenericSystem</plugin></hardware>
                  <sensor name="tip">
                    <state_interface name="range"/>
                  </sensor>
                </ros2_control>
            """,
            "controllers.yaml": """
                controller_manager:
                  ros__parameters:
                    update_rate: 100
                    tip_broadcaster: {type: range_sensor_broadcaster/RangeSensorBroadcaster}
                tip_broadcaster:
                  ros__parameters:
                    sensor_name: tip
                    frame_id: «forearm»
                    radiation_type: 1
                    field_of_view: 0.1
                    min_range: 0.1
                    max_range: 2.0
            """,
        },
    ],
    good=[{"robot.urdf": _SENSOR, "controllers.yaml": _BROADCASTER % "fore"}],
)
def sensor_frame_not_a_link(project: Project) -> Iterator[Finding]:
    """Frame of a sensor is not a link of the robot.

    The broadcaster publishes measurements in a frame that nobody publishes a transform of. RViz and filters that use
    them print an error and ignore them. A frame that a static_transform_publisher of the launch file names is accepted.
    """
    robot = robot_of(project)
    if robot is not None:
        names = KnownNames([*(link.name for link in robot.links), *_published(project)])
        yield from in_each_distro(project, lambda reader: _unknown_frame(reader, names))


def _unknown_frame(reader: Reader, names: KnownNames) -> Iterator[Finding]:
    given = reader.located.get("frame_id") if reader.type and reader.type.package in _PACKAGES else None
    if given is None or given.value.kind is not ValueKind.STRING or not given.value.is_known or not given.value.text:
        return
    name = given.value.text.lstrip("/")
    if name in names or name.rpartition("/")[2] in names:
        return
    meant = names.meant_by(name)
    hint = f"; did you mean '{meant}'?" if meant else ""
    message = f"'frame_id' of controller '{reader.name}' is '{given.value.text}', but the robot has no such link{hint}"
    fix = replaced(given.value.at, given.value.text, meant) if meant else None
    yield Finding(given.value.at, message, fix=fix, severity=Severity.WARNING)


def _published(project: Project) -> Iterator[str]:
    """The words of the programs in the launch file that publish transforms."""
    for node in project.launch.nodes if project.launch else ():
        if node.package.text == "tf2_ros":
            yield from (word.text for word in node.words)
