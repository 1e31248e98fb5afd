"""UC527."""

from __future__ import annotations

from collections.abc import Iterator

from urdfctl.rule import Finding, Fix, Project, Severity, rule
from urdfctl.rules.common import is_all_there
from urdfctl.rules.simulation.common import control_plugins


@rule(
    "UC527",
    severity=Severity.WARNING,
    distros=("kinetic",),
    authority="gazebo_ros_control (kinetic) src/gazebo_ros_control_plugin.cpp: 'GazeboRosControlPlugin missing <legacyModeNS> "
    "while using DefaultRobotHWSim, defaults to true.'; removed in melodic, ros-simulation/gazebo_ros_pkgs#709",
    options=["--distro=kinetic"],
    bad={
        "robot.urdf": """
            <gazebo>
              «<plugin name="gazebo_ros_control" filename="libgazebo_ros_control.so">»
                <robotNamespace>/arm</robotNamespace>
              </plugin>
            </gazebo>
        """,
    },
    good={
        "robot.urdf": """
            <gazebo>
              <plugin name="gazebo_ros_control" filename="libgazebo_ros_control.so">
                <robotNamespace>/arm</robotNamespace>
                <legacyModeNS>false</legacyModeNS>
              </plugin>
            </gazebo>
        """,
    },
)
def legacy_mode_not_given(project: Project) -> Iterator[Finding]:
    """In kinetic, ros_control's plugin is not told whether to look for gains in the robot's namespace.

    It prints an error and takes true: the gains in the namespace of `<robotNamespace>` are passed over. Before kinetic
    and from melodic on nobody asks, so that this is told only where kinetic is named.
    """
    for one in control_plugins(project) if project.distro else ():
        simulation = one.setting("robotSimType")
        default = simulation is None or simulation.text == "gazebo_ros_control/DefaultRobotHWSim"
        if default and one.setting("legacyModeNS") is None and is_all_there(project, one.plugin.tag):
            message = "kinetic wants <legacyModeNS> in this plugin, and takes true with an error where it is missing"
            fix = Fix("write <legacyModeNS>false</legacyModeNS>, or true where gains stand in /gazebo_ros_control")
            yield Finding(one.plugin.at, message, fix=fix)
