"""UC366."""

from __future__ import annotations

from collections.abc import Iterator

from urdfctl.catalog.distros import ROS2
from urdfctl.control.hardware.simulator_plugins import IN_GAZEBO, components, simulator_of
from urdfctl.rule import Finding, Note, Project, Severity, rule
from urdfctl.rules.common import in_words, whole_robot_in

_FINGER = """
            <link name="finger">
              <inertial><mass value="1"/><inertia ixx="0.01" ixy="0" ixz="0" iyy="0.01" iyz="0" izz="0.01"/></inertial>
            </link>
            <joint name="«grip»" type="prismatic">
              <parent link="fore"/><child link="finger"/>
              <limit lower="-1" upper="1" effort="1" velocity="1"/><mimic joint="elbow"/>
            </joint>
"""
_CONTROL = """
            <ros2_control name="arm" type="system">
              <hardware><plugin>gz_ros2_control/GazeboSimSystem</plugin></hardware>
              <joint name="elbow"><command_interface name="position"/><state_interface name="position"/></joint>
              %s
            </ros2_control>
            <gazebo>
              <plugin filename="gz_ros2_control-system" name="gz_ros2_control::GazeboSimROS2ControlPlugin">
                <parameters>/opt/arm/controllers.yaml</parameters>
              </plugin>
            </gazebo>
"""


@rule(
    "UC366",
    severity=Severity.WARNING,
    runtime="misbehaves",
    distros=ROS2,
    whole_robot=True,
    in_library=False,
    authority="gz_ros2_control doc/index.rst, Using mimic joints in simulation; gz_system.cpp write() and "
    "gazebo_system.cpp write() move the mimic joints of the component only",
    options=["--distro=jazzy"],
    bad=[{"robot.urdf": _FINGER + _CONTROL % ""}],
    good=[
        {
            "robot.urdf": _FINGER.replace("«", "").replace("»", "")
            + _CONTROL % '<joint name="grip"><state_interface name="position"/></joint>'
        },
    ],
)
def mimic_joint_not_in_component(project: Project) -> Iterator[Finding]:
    """Mimic joint is missing in the simulated <ros2_control> component.

    Gazebo's plugin lets a mimic joint follow only if it is in the component of the joint that it mimics. A missing one
    hangs loose in the simulation, and the joint state broadcaster does not publish it. Since jazzy it has state
    interfaces only; until iron it needs `<param name="mimic">` too.
    """
    robot = whole_robot_in(project)
    if robot is None:
        return
    simulated = [control for control in components(project) if simulator_of(project, control) in IN_GAZEBO]
    present = {part.name for control in robot.ros2_controls for part in control.parts}
    lost = [
        joint
        for joint in robot.joints
        if joint.mimic and joint.name not in present and not _is_moved(project, joint.name)
    ]
    for control in simulated:
        leaders = {part.name for part in control.parts if part.kind == "joint" and part.commands}
        mine = [joint for joint in lost if joint.mimic and joint.mimic.joint in leaders]
        if mine:
            name = mine[0].name
            several = len(mine) > 1
            who = (
                f"mimic joints {in_words([joint.name or '' for joint in mine], 3)} are"
                if several
                else f"mimic joint '{name}' is"
            )
            message = (
                f"{who} not in <ros2_control>, so Gazebo's plugin does not move {'them' if several else 'it'} with "
            )
            message += f"'{mine[0].mimic.joint if mine[0].mimic else ''}'; add <joint name=\"{name}\"> with state interfaces only"
            yield Finding(mine[0].at["name"], message, (Note("the mimicked joint is in this component", control.at),))


def _is_moved(project: Project, name: str | None) -> bool:
    """Whether a plugin of the simulator names the joint, as those do that imitate <mimic>."""
    plugins = project.robot.plugins if project.robot else ()
    return any(name in (tag.text, tag.attributes.get("name")) for plugin in plugins for tag in plugin.tag.children)
