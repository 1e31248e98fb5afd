"""UC508."""

from __future__ import annotations

from collections.abc import Iterator

from urdfctl.catalog.distros import ROS2
from urdfctl.rule import Finding, Fix, Project, Severity, rule
from urdfctl.rules.common import whole_robot_in
from urdfctl.rules.simulation.common import IN_GAZEBO, components, loaded, simulator_of


@rule(
    "UC508",
    severity=Severity.WARNING,
    distros=ROS2,
    whole_robot=True,
    in_library=False,
    authority="gz_ros2_control and gazebo_ros2_control, Add the plugin: it 'parses the ros2_control tags and loads the "
    "appropriate hardware interfaces and controller manager'",
    bad={
        "robot.urdf": """
            <ros2_control name="arm" type="system">
              <hardware>«<plugin>»gz_ros2_control/GazeboSimSystem</plugin></hardware>
              <joint name="elbow"><command_interface name="position"/><state_interface name="position"/></joint>
            </ros2_control>
        """,
    },
    good={
        "robot.urdf": """
            <ros2_control name="arm" type="system">
              <hardware><plugin>gz_ros2_control/GazeboSimSystem</plugin></hardware>
              <joint name="elbow"><command_interface name="position"/><state_interface name="position"/></joint>
            </ros2_control>
            <gazebo>
              <plugin filename="gz_ros2_control-system" name="gz_ros2_control::GazeboSimROS2ControlPlugin">
                <parameters>/opt/arm/controllers.yaml</parameters>
              </plugin>
            </gazebo>
        """,
    },
)
def control_plugin_missing(project: Project) -> Iterator[Finding]:
    """A robot's hardware runs in Gazebo, and no plugin of the robot brings it there.

    The controller manager of a simulated robot lives in a plugin of Gazebo, which loads the hardware. Without it
    spawners wait for the manager in vain.
    """
    robot = whole_robot_in(project)
    if robot is None or any(one.hosts_control or one.any is None for one in loaded(project) if one.filename):
        return
    for control in components(project):
        simulator = simulator_of(project, control)
        if simulator not in IN_GAZEBO:
            continue
        last = project.distros[-1] if project.distro else "iron" if simulator == "gazebo-classic" else "rolling"
        hosts = [one for one in project.catalog.simulator_plugins(last) if one.hosts_control]
        right = next((one for one in hosts if one.simulator == simulator), None)
        message = f"'{control.plugin}' runs in {IN_GAZEBO[simulator]}, and no <plugin> of the robot loads it there"
        fix = None
        if right:
            name = right.names[0] if right.names else "gazebo_ros2_control"
            plugin = f'<plugin filename="{right.filenames[0]}" name="{name}">'
            fix = Fix(f"add <gazebo>{plugin}<parameters>...</parameters></plugin></gazebo>")
        yield Finding(control.hardware[-1].plugins[0].at, message, fix=fix)
        return
