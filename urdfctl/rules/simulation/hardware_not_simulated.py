"""UC507."""

from __future__ import annotations

from collections.abc import Iterator

from urdfctl.catalog.distros import ROS2
from urdfctl.control.hardware.simulator_plugins import IN_GAZEBO, components, control_plugins
from urdfctl.rule import Finding, Fix, Project, Severity, Stage, rule
from urdfctl.rules.common import is_conditional, is_known, is_xacro


@rule(
    "UC507",
    severity=Severity.ERROR,
    stage=Stage.HARDWARE,
    runtime="refuses",
    distros=ROS2,
    in_library=False,
    authority="gz_ros2_control src/gz_ros2_control_plugin.cpp loads only GazeboSimSystemInterface: 'The plugin failed to "
    "load for some reason. Error: According to the loaded plugin descriptions the class "
    "mock_components/GenericSystem with base class type gz_ros2_control::GazeboSimSystemInterface does not exist'",
    options=["--distro=jazzy", "--simulator=gz"],
    bad=[
        {
            "robot.urdf": """
                <ros2_control name="arm" type="system">
                  <hardware>«<plugin>»mock_components/GenericSystem</plugin></hardware>
                  <joint name="elbow"><command_interface name="position"/><state_interface name="position"/></joint>
                </ros2_control>
                <gazebo>
                  <plugin filename="gz_ros2_control-system" name="gz_ros2_control::GazeboSimROS2ControlPlugin">
                    <parameters>/opt/arm/controllers.yaml</parameters>
                  </plugin>
                </gazebo>
            """,
        },
    ],
    good=[
        {
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
    ],
)
def hardware_not_simulated(project: Project) -> Iterator[Finding]:
    """Hardware that Gazebo's plugin cannot load.

    The plugin in Gazebo loads only simulated hardware, neither drivers nor mock hardware. The component's joints have
    no interfaces in the simulator. Outside Gazebo the same description may be correct. It is therefore an error only if
    you name the simulator, and a warning in a file that cannot choose.
    """
    hosts = control_plugins(project)
    robot = project.robot
    if not hosts or robot is None:
        return
    severity = Severity.ERROR if project.named_simulator else Severity.INFO if is_xacro(robot) else Severity.WARNING
    for control in components(project):
        name = control.plugin or ""
        known = [project.catalog.hardware(name, distro) for distro in project.distros] if is_known(name) else []
        simulators = {hardware.simulator for hardware in known if hardware}
        chosen = not project.named_simulator and is_conditional(control.hardware[-1].at)
        if not simulators or simulators & set(IN_GAZEBO) or chosen:
            continue
        default = hosts[0].any.default_hardware if hosts[0].any else None
        message = f"'{name}' is not simulated hardware; '{hosts[0].filename}' cannot load it in Gazebo"
        fix = Fix(f"write <plugin>{default}</plugin> for the simulation") if default else None
        yield Finding(control.hardware[-1].plugins[0].at, message, fix=fix, severity=severity)
