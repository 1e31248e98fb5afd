"""UC628."""

from __future__ import annotations

from collections.abc import Iterator

from urdfctl.model.launch import Started
from urdfctl.names import enumerated
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

_THEN = "OnProcessExit(target_action=states, on_exit=[arm])"


def _started(event: str, then: str = "{}") -> dict[str, str]:
    files = {"arm.urdf": ROBOT, "controllers.yaml": CONTROLLERS, "package.xml": MANIFEST}
    launch = _LAUNCH.replace("EVENT", event).replace(_THEN, then.format(_THEN))
    return {"arm.launch.py": launch, **files}


@rule(
    "UC628",
    severity=Severity.ERROR,
    runtime="refuses",
    authority="launch event_handlers/on_process_exit.py: acts on ProcessExited of the target; controller_manager "
    "ros2_control_node.cpp main(): 'executor->spin()' until the launch ends",
    bad=[
        _started("«OnProcessExit(target_action=manager, on_exit=[states])»"),
        _started("«OnProcessExit(target_action=Node(package='arm', executable='home'), on_exit=[states])»"),
        _started("«OnProcessExit(target_action=manager, on_exit=[Node(package='rviz2', executable='rviz2')])»", "«{}»"),
    ],
    good=[
        _started("OnProcessStart(target_action=manager, on_start=[states])"),
    ],
)
def spawner_after_endless_program(project: Project) -> Iterator[Finding]:
    """Spawner waits for the exit of a program that never exits, or never starts.

    `OnProcessExit` of ros2_control_node, or of another program that runs as long as the launch, starts its actions when
    everything ends. An event handler of an action that is not in the launch description never starts its own. No
    controller is spawned, and nothing is printed. If no controllers wait, but only other programs, it is a warning.
    """
    for waiting in project.launch.waiting if project.launch else ():
        spawners = [each for each in waiting.what if each.program == "spawner"]
        names = list(dict.fromkeys(map(_titled, spawners or waiting.what)))
        what = f"{enumerated(names)} {'wait' if len(names) > 1 else 'waits'}"
        severity = None if spawners else Severity.WARNING
        target = _titled(waiting.target)
        if waiting.is_started:
            message = f"{what} for the exit of {target}, which runs until the launch ends; use OnProcessStart"
        else:
            message = f"{what} for {target}, which nothing starts; add it to the LaunchDescription"
        yield Finding(waiting.at, message, severity=severity)


def _titled(started: Started) -> str:
    if started.program == "spawner" or started.controllers:
        return f"the spawner of {in_words(started.controllers, 3) or 'its controllers'}"
    return f"'{started.program}'" if started.program else "a process"
