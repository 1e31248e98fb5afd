"""UC701."""

from __future__ import annotations

from collections.abc import Iterator

from urdfctl.catalog.distros import since
from urdfctl.control.hardware.gazebo_plugins import IN_GZ
from urdfctl.control.hardware.simulator_plugins import (
    LoadedPlugin,
    has_other_hardware,
    loaded_plugins,
    of_sensors,
    written_plugins,
)
from urdfctl.rule import Finding, Fix, Note, Project, Severity, rule

_WITHOUT = since("jazzy")


@rule(
    "UC701",
    runtime="refuses",
    because="the robot may run on hardware alone",
    severity=Severity.WARNING,
    distros=_WITHOUT,
    authority="gazebo_ros2_control README: Gazebo Classic is not released for Ubuntu Noble, and gazebo_ros_pkgs and "
    "gazebo_ros2_control not for jazzy and later; gz-sim src/SystemLoader.cc: 'couldn't find shared library'",
    options=["--distro=jazzy"],
    bad=[
        {
            "robot.urdf": """
                <gazebo>
                  <plugin name="drive" filename="«libgazebo_ros_diff_drive.so»">
                    <left_joint>shoulder</left_joint>
                    <right_joint>elbow</right_joint>
                  </plugin>
                </gazebo>
            """,
        },
        {
            "robot.urdf": """
                <gazebo>
                  <plugin name="gazebo_ros2_control" filename="«libgazebo_ros2_control.so»"/>
                  <plugin name="control" filename="«libgazebo_ros_control.so»"/>
                  <plugin name="ackermann_drive" filename="«libgazebo_ros_ackermann_drive.so»"/>
                  <plugin name="bumper" filename="«libgazebo_ros_bumper.so»"/>
                  <plugin name="camera" filename="«libgazebo_ros_camera.so»"/>
                  <plugin name="depth_camera" filename="«libgazebo_ros_depth_camera.so»"/>
                  <plugin name="ft_sensor" filename="«libgazebo_ros_ft_sensor.so»"/>
                  <plugin name="gps_sensor" filename="«libgazebo_ros_gps_sensor.so»"/>
                  <plugin name="gpu_laser" filename="«libgazebo_ros_gpu_laser.so»"/>
                  <plugin name="imu" filename="«libgazebo_ros_imu.so»"/>
                  <plugin name="imu_sensor" filename="«libgazebo_ros_imu_sensor.so»"/>
                  <plugin name="joint_pose_trajectory" filename="«libgazebo_ros_joint_pose_trajectory.so»"/>
                  <plugin name="joint_state_publisher" filename="«libgazebo_ros_joint_state_publisher.so»"/>
                  <plugin name="laser" filename="«libgazebo_ros_laser.so»"/>
                  <plugin name="openni_kinect" filename="«libgazebo_ros_openni_kinect.so»"/>
                  <plugin name="p3d" filename="«libgazebo_ros_p3d.so»"/>
                  <plugin name="planar_move" filename="«libgazebo_ros_planar_move.so»"/>
                  <plugin name="range" filename="«libgazebo_ros_range.so»"/>
                  <plugin name="ray_sensor" filename="«libgazebo_ros_ray_sensor.so»"/>
                  <plugin name="skid_steer_drive" filename="«libgazebo_ros_skid_steer_drive.so»"/>
                  <plugin name="wheel_slip" filename="«libgazebo_ros_wheel_slip.so»"/>
                </gazebo>
            """,
        },
    ],
    good=[
        {
            "robot.urdf": """
                <gazebo>
                  <plugin filename="gz-sim-diff-drive-system" name="gz::sim::systems::DiffDrive">
                    <left_joint>shoulder</left_joint>
                    <right_joint>elbow</right_joint>
                    <wheel_separation>0.3</wheel_separation>
                    <wheel_radius>0.05</wheel_radius>
                  </plugin>
                </gazebo>
            """,
        },
    ],
)
def gazebo_classic_gone(project: Project) -> Iterator[Finding]:
    """Gazebo Classic plugin in a distro without Gazebo Classic.

    Gazebo Classic reached its end of life in January 2025, and has no release for jazzy and later. gz cannot load its
    plugins. If the controllers run in such a plugin, the simulated robot is not controlled.
    """
    if not set(project.distros) <= set(_WITHOUT):
        return
    in_gz = project.simulator == "gz"
    everywhere = (*(written_plugins(project) if in_gz else loaded_plugins(project)), *of_sensors(project))
    if not any(plugin.hosts_control for plugin in everywhere):
        everywhere += tuple(plugin for plugin in written_plugins(project) if plugin.hosts_control)
    classic = [plugin for plugin in everywhere if plugin.simulator == "gazebo-classic" and not plugin.known]
    both = any(plugin.hosts_control and plugin.simulator == "gz" for plugin in everywhere)
    first: dict[str, LoadedPlugin] = {}
    for plugin in classic:
        first.setdefault(plugin.library, plugin)
    for library, plugin in first.items():
        more = sum(other.library == library for other in classic) - 1
        message = (
            f"plugin '{plugin.filename}' is for Gazebo Classic, which does not exist in {project.distros[0]} and later"
        )
        notes = (Note(f"{more} more in this robot"),) if more else ()
        instead = IN_GZ.get(library)
        fix = Fix(f"in gz use {instead}") if instead else None
        vital = plugin.hosts_control and not has_other_hardware(project)
        severity = Severity.INFO if both else Severity.ERROR if vital else None
        yield Finding(plugin.plugin.at["filename"], message, notes, fix, severity)
