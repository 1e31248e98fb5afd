"""UC525."""

from __future__ import annotations

from collections.abc import Iterator

from urdfctl.catalog.distros import ROS1
from urdfctl.rule import Finding, Note, Project, Severity, rule
from urdfctl.rules.common import is_known
from urdfctl.rules.simulation.common import control_plugins, namespace_of


@rule(
    "UC525",
    severity=Severity.WARNING,
    distros=ROS1,
    authority="controller_manager scripts/spawner: 'Controller Spawner couldn't find the expected controller_manager ROS "
    "interface.'",
    bad={
        "robot.urdf": """
            <gazebo>
              <plugin name="gazebo_ros_control" filename="libgazebo_ros_control.so">
                <robotNamespace>/arm</robotNamespace>
              </plugin>
            </gazebo>
        """,
        "package.xml": "<package><name>arm</name><exec_depend>controller_manager</exec_depend></package>",
        "arm.launch": """
            <launch>
              <param name="robot_description" textfile="$(find arm)/robot.urdf"/>
              <node name="spawner" pkg="controller_manager" type="spawner" args="«joint_state_controller»"/>
            </launch>
        """,
    },
    good={
        "robot.urdf": """
            <gazebo>
              <plugin name="gazebo_ros_control" filename="libgazebo_ros_control.so">
                <robotNamespace>/arm</robotNamespace>
              </plugin>
            </gazebo>
        """,
        "package.xml": "<package><name>arm</name><exec_depend>controller_manager</exec_depend></package>",
        "arm.launch": """
            <launch>
              <param name="robot_description" textfile="$(find arm)/robot.urdf"/>
              <node name="spawner" pkg="controller_manager" type="spawner" ns="/arm" args="joint_state_controller"/>
            </launch>
        """,
    },
)
def spawner_of_other_namespace(project: Project) -> Iterator[Finding]:
    """A spawner looks for the controller manager in another namespace than the simulated robot's.

    The plugin's manager lives in `<robotNamespace>`; the spawner asks in its own namespace, waits for half a minute, and
    gives up.
    """
    hosts = [one for one in control_plugins(project) if one.library == "gazebo_ros_control"]
    settings = [one.setting("robotNamespace") for one in hosts]
    known = {namespace_of(setting.text): setting for setting in settings if setting and is_known(setting.text)}
    if project.launch is None or not hosts or len(known) < len(hosts):
        return
    for spawn in project.launch.spawns:
        if spawn.sure and spawn.namespace is not None and namespace_of(spawn.namespace) not in known:
            ours, setting = next(iter(known.items()))
            there = namespace_of(spawn.namespace) or "/"
            message = (
                f"the spawner asks in namespace '{there}', and the simulated robot's manager is in '{ours or '/'}'"
            )
            yield Finding(spawn.at, message, (Note("the plugin says so here", setting.at),))
