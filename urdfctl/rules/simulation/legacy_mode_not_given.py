"""UC527."""

from __future__ import annotations

from collections.abc import Iterator

from urdfctl.control.hardware.simulator_plugins import control_plugins
from urdfctl.rule import Finding, Fix, Project, Severity, rule
from urdfctl.rules.common import is_all_there


@rule(
    "UC527",
    severity=Severity.WARNING,
    runtime="warns",
    distros=("kinetic",),
    authority="gazebo_ros_control (kinetic) src/gazebo_ros_control_plugin.cpp: 'GazeboRosControlPlugin missing <legacyModeNS> "
    "while using DefaultRobotHWSim, defaults to true.'; removed in melodic, ros-simulation/gazebo_ros_pkgs#709",
    options=["--distro=kinetic"],
    bad=[
        {
            "robot.urdf": """
                <gazebo>
                  «<plugin name="gazebo_ros_control" filename="libgazebo_ros_control.so">»
                    <robotNamespace>/arm</robotNamespace>
                  </plugin>
                </gazebo>
            """,
        },
    ],
    good=[
        {
            "robot.urdf": """
                <gazebo>
                  <plugin name="gazebo_ros_control" filename="libgazebo_ros_control.so">
                    <robotNamespace>/arm</robotNamespace>
                    <legacyModeNS>false</legacyModeNS>
                  </plugin>
                </gazebo>
            """,
        },
    ],
)
def legacy_mode_not_given(project: Project) -> Iterator[Finding]:
    """Plugin of ros_control without `<legacyModeNS>` in kinetic.

    The setting says whether gains are read from the robot's namespace. Without it, the plugin logs an error and uses
    true: the gains in the namespace of `<robotNamespace>` are ignored. Only kinetic reads this setting, so it is
    reported only if kinetic is named.
    """
    for sim_plugin in control_plugins(project) if project.distro else ():
        simulation = sim_plugin.setting("robotSimType")
        default = simulation is None or simulation.text == "gazebo_ros_control/DefaultRobotHWSim"
        if default and sim_plugin.setting("legacyModeNS") is None and is_all_there(project, sim_plugin.plugin.tag):
            message = "plugin has no <legacyModeNS>; kinetic logs an error and uses true"
            fix = Fix("add <legacyModeNS>false</legacyModeNS>, or true if the gains are in /gazebo_ros_control")
            yield Finding(sim_plugin.plugin.at, message, fix=fix)
