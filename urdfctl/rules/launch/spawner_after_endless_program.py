"""UC628."""

from __future__ import annotations

from collections.abc import Iterator

from urdfctl.rule import Finding, Project, Severity, rule
from urdfctl.rules.common import in_words
from urdfctl.rules.launch_samples import CONTROLLERS, MANIFEST, ROBOT

_LAUNCH = """
    from ament_index_python.packages import get_package_share_directory
    from launch import LaunchDescription
    from launch.actions import RegisterEventHandler
    from launch.event_handlers import OnProcessExit, OnProcessStart
    from launch_ros.actions import Node

    def generate_launch_description():
        share = get_package_share_directory("arm")
        robot = {"robot_description": open(share + "/arm.urdf").read()}
        publisher = Node(package="robot_state_publisher", executable="robot_state_publisher", parameters=[robot])
        manager = Node(
            package="controller_manager", executable="ros2_control_node", parameters=[share + "/controllers.yaml"],
            remappings=[("~/robot_description", "/robot_description")])
        states = Node(package="controller_manager", executable="spawner", arguments=["joint_state_broadcaster"])
        arm = Node(
            package="controller_manager", executable="spawner",
            arguments=["arm_controller", "-p", share + "/controllers.yaml"])
        first = RegisterEventHandler(EVENT)
        then = RegisterEventHandler(OnProcessExit(target_action=states, on_exit=[arm]))
        return LaunchDescription([publisher, manager, first, then])
"""


def _started(event: str) -> dict[str, str]:
    files = {"arm.urdf": ROBOT, "controllers.yaml": CONTROLLERS, "package.xml": MANIFEST}
    return {"arm.launch.py": _LAUNCH.replace("EVENT", event), **files}


@rule(
    "UC628",
    severity=Severity.ERROR,
    runtime="refuses",
    authority="launch event_handlers/on_process_exit.py: acts on ProcessExited of the target; controller_manager "
    "ros2_control_node.cpp main(): 'executor->spin()' until the launch ends",
    bad=[_started("«OnProcessExit(target_action=manager, on_exit=[states])»")],
    good=[_started("OnProcessStart(target_action=manager, on_start=[states])")],
)
def spawner_after_endless_program(project: Project) -> Iterator[Finding]:
    """Spawner waits for the exit of a program that never exits.

    `OnProcessExit` of ros2_control_node, or of another program that runs as long as the launch, starts its actions when
    everything ends. No controller is spawned, and nothing is printed.
    """
    for spawn in project.launch.spawns if project.launch else ():
        if spawn.waits_for is None or not spawn.sure:
            continue
        program, names = spawn.waits_for.text, in_words([name for name, _ in spawn.names], 3) or "its controllers"
        message = f"the spawner of {names} waits for the exit of '{program}', which runs until the launch ends"
        yield Finding(spawn.waits_for.at, f"{message}; use OnProcessStart")
