"""UC605."""

from __future__ import annotations

from collections.abc import Iterator

from urdfctl.catalog.distros import ROS2
from urdfctl.control.hosts import MANAGER, hosts_no_manager
from urdfctl.rule import Finding, Project, Severity, rule
from urdfctl.rules.launch.common import ROS_2, is_spawner, is_sure, launch_of, managers, state_publishers
from urdfctl.rules.launch.steps import STARTS_SIMULATOR
from urdfctl.rules.launch_samples import ARM, BROADCASTER, PUBLISHER, SOUND, launched

_STARTS_MANAGER = rf"{MANAGER}|generate_demo_launch|_driver\b|{STARTS_SIMULATOR}"
"""What says that a text may start a controller manager."""
_FIRST = BROADCASTER.replace("joint_state_broadcaster", "«joint_state_broadcaster»")


@rule(
    "UC605",
    runtime="refuses",
    because="another launch file may start the manager",
    severity=Severity.WARNING,
    distros=ROS2,
    whole_robot=True,
    authority="ros2_control spawner.py: 'waiting for service /controller_manager/list_controllers to become available...'",
    bad=[
        launched(PUBLISHER, _FIRST, ARM),
        launched(PUBLISHER, _FIRST, ARM, '\n      <node pkg="rviz2" exec="rviz2"/>'),
    ],
    good=[SOUND],
)
def spawner_without_manager(project: Project) -> Iterator[Finding]:
    """Controllers are spawned without a controller manager.

    The spawner waits for the manager's services, and waits forever if no timeout is given. The manager is the node
    ros2_control_node of package controller_manager. In a simulation it is the plugin of gz or Gazebo. It is an error if no other
    text of the workspace, such as a launch file or a README, says that it starts one.
    """
    launch = launch_of(project, ROS_2)
    if launch is None or project.robot is None or not is_sure(launch) or not state_publishers(launch):
        return
    if launch.simulations or managers(project, launch) or not all(hosts_no_manager(node) for node in launch.nodes):
        return
    first = next((spawn for spawn in launch.spawns if is_spawner(spawn)), None)
    if first is not None:
        at = first.names[0][1] if first.names else first.at
        message = "controllers are spawned, but the launch file starts no controller manager"
        yield Finding(at, message, severity=None if project.may_mention(_STARTS_MANAGER) else Severity.ERROR)
