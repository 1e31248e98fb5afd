"""UC525."""

from __future__ import annotations

from collections.abc import Iterator
from itertools import pairwise

from urdfctl.catalog.distros import ROS1
from urdfctl.control.hardware.gazebo_ros1 import may_be_driven
from urdfctl.control.hardware.simulator_plugins import control_plugins, namespace_of
from urdfctl.control.hosts import hosts_no_manager
from urdfctl.model.launch import Launch
from urdfctl.rule import Finding, Note, Project, Severity, StageDependsOn, rule
from urdfctl.rules.common import doubt_of, is_known
from urdfctl.source.span import Place

_MODEL_SPAWNERS = ("gazebo_ros", "spawn_model")


@rule(
    "UC525",
    runtime="refuses",
    stage=StageDependsOn.SPAWNER,
    because="another launch file may start a manager there",
    severity=Severity.WARNING,
    distros=ROS1,
    authority="controller_manager scripts/spawner: 'Controller Spawner couldn't find the expected controller_manager ROS "
    "interface.'",
    bad=[
        {
            "robot.urdf": """
                <gazebo>
                  <plugin name="gazebo_ros_control" filename="libgazebo_ros_control.so">
                    <robotNamespace>/arm</robotNamespace>
                  </plugin>
                </gazebo>
            """,
            "package.xml": "<package><name>arm</name><exec_depend>gazebo_ros_control</exec_depend></package>",
            "arm.launch": """
                <launch>
                  <param name="robot_description" textfile="$(find arm)/robot.urdf"/>
                  <node name="spawner" pkg="controller_manager" type="spawner" args="«joint_state_controller»"/>
                </launch>
            """,
        },
        {
            "robot.urdf": """
                <gazebo><plugin name="gazebo_ros_control" filename="libgazebo_ros_control.so"/></gazebo>
            """,
            "package.xml": "<package><name>arm</name><exec_depend>gazebo_ros_control</exec_depend></package>",
            "arm.launch": """
                <launch>
                  <param name="robot_description" textfile="$(find arm)/robot.urdf"/>
                  <node name="model" pkg="gazebo_ros" type="spawn_model" ns="/arm" args="-urdf -model arm -param /robot_description"/>
                  <node name="spawner" pkg="controller_manager" type="spawner" args="«joint_state_controller»"/>
                </launch>
            """,
        },
    ],
    good=[
        {
            "robot.urdf": """
                <gazebo>
                  <plugin name="gazebo_ros_control" filename="libgazebo_ros_control.so">
                    <robotNamespace>/arm</robotNamespace>
                  </plugin>
                </gazebo>
            """,
            "package.xml": "<package><name>arm</name><exec_depend>gazebo_ros_control</exec_depend></package>",
            "arm.launch": """
                <launch>
                  <param name="robot_description" textfile="$(find arm)/robot.urdf"/>
                  <node name="spawner" pkg="controller_manager" type="spawner" ns="/arm" args="joint_state_controller"/>
                </launch>
            """,
        },
    ],
)
def spawner_of_other_namespace(project: Project) -> Iterator[Finding]:
    """Spawner looks for the controller manager in another namespace.

    The plugin's controller manager runs in `<robotNamespace>`, or without it in the namespace of the node that spawns
    the model. The spawner asks in its own namespace, waits for half a minute and gives up.
    """
    hosts = [sim_plugin for sim_plugin in control_plugins(project) if sim_plugin.library == "gazebo_ros_control"]
    if project.launch is None or not hosts or may_be_driven(project):
        return
    default = _of_model_spawner(project.launch)
    known: dict[str, Place] = {}
    for setting in (sim_plugin.setting("robotNamespace") for sim_plugin in hosts):
        if setting is not None and is_known(setting.text):
            known[namespace_of(setting.text)] = setting.at
        elif setting is None and default is not None:
            known.update((default,))
        else:
            return
    severity, notes = _certainty(project.launch)
    for spawn in project.launch.spawns:
        if spawn.sure and spawn.namespace is not None and namespace_of(spawn.namespace) not in known:
            ours, at = next(iter(known.items()))
            theirs = namespace_of(spawn.namespace) or "/"
            message = (
                f"spawner asks in namespace '{theirs}', "
                f"but the simulated robot's controller manager is in '{ours or '/'}'"
            )
            where = Note("the plugin's namespace is set here", at)
            yield Finding(spawn.at, message, (where, *notes), severity=severity)


def _certainty(launch: Launch) -> tuple[Severity | None, tuple[Note, ...]]:
    """An error if the launch file spawns the robot too, all that it starts is known, and nothing else runs a manager."""
    doubt = doubt_of(launch)
    spawned = any(node.sure and node.runs(*_MODEL_SPAWNERS) for node in launch.nodes)
    if doubt is None or not spawned or launch.others or not all(map(hosts_no_manager, launch.nodes)):
        return None, ()
    return (doubt.severity or Severity.ERROR), doubt.notes


def _of_model_spawner(launch: Launch) -> tuple[str, Place] | None:
    """The namespace of plugins without `<robotNamespace>`, and its place; None if it is unknown.

    It is that of the node that spawns the model, or the one that the node is given.
    """
    nodes = [node for node in launch.nodes if node.runs(*_MODEL_SPAWNERS)]
    if len(nodes) != 1 or not nodes[0].sure or nodes[0].namespace is None:
        return None
    words = nodes[0].words
    given = [after for before, after in pairwise(words) if before.text == "-robot_namespace"]
    if any(word.known is None for word in (*words, *given)):
        return None
    return namespace_of(given[0].text if given else nodes[0].namespace), nodes[0].at
