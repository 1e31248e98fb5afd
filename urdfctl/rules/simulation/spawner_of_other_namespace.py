"""UC525."""

from __future__ import annotations

from collections.abc import Iterator

from urdfctl.catalog.distros import ROS1
from urdfctl.control.simulator_plugins import control_plugins, namespace_of
from urdfctl.rule import Finding, Note, Project, Severity, rule
from urdfctl.rules.common import is_known


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
    """Spawner looks for the controller manager in another namespace.

    The plugin's controller manager runs in `<robotNamespace>`. The spawner asks in its own namespace, waits for half a
    minute and gives up.
    """
    hosts = [sim_plugin for sim_plugin in control_plugins(project) if sim_plugin.library == "gazebo_ros_control"]
    settings = [sim_plugin.setting("robotNamespace") for sim_plugin in hosts]
    known = {namespace_of(setting.text): setting for setting in settings if setting and is_known(setting.text)}
    if project.launch is None or not hosts or len(known) < len(hosts):
        return
    for spawn in project.launch.spawns:
        if spawn.sure and spawn.namespace is not None and namespace_of(spawn.namespace) not in known:
            ours, setting = next(iter(known.items()))
            theirs = namespace_of(spawn.namespace) or "/"
            message = (
                f"spawner asks in namespace '{theirs}', "
                f"but the simulated robot's controller manager is in '{ours or '/'}'"
            )
            yield Finding(spawn.at, message, (Note("the plugin's namespace is set here", setting.at),))
