"""UC641."""

from __future__ import annotations

from collections.abc import Iterator

from urdfctl.catalog.distros import ROS2
from urdfctl.control.hardware.simulator_plugins import components, simulator_of
from urdfctl.rule import Finding, Note, Project, Severity, rule
from urdfctl.rules.launch.common import ROS_2, launch_of, may_publish_time, state_publishers
from urdfctl.rules.launch_samples import ARM, BROADCASTER, MANAGER, MANIFEST, PUBLISHER, ROBOT, SOUND, launched

_RVIZ = '<node pkg="rviz2" exec="rviz2" args="-d display.rviz"/>'
_IN_MUJOCO = ROBOT.replace("mock_components/GenericSystem", "mujoco_ros2_control/MujocoSystemInterface")
_WEBOTS = '<node pkg="webots_ros2_driver" exec="ros2_supervisor.py"/>'
_WITHOUT_CLOCK = {None, "mock", "webots"}
"""What hardware runs in without publishing the time; in Webots the supervisor does."""
_WITH_CLOCK = PUBLISHER.replace("</node>", '  <param name="%s" value="true"/>\n      </node>')


@rule(
    "UC641",
    runtime="misbehaves",
    severity=Severity.WARNING,
    distros=ROS2,
    authority="rclcpp time_source.cpp: with use_sim_time a node takes its time from /clock, and stays at 0 without it; "
    "webots_ros2_driver ros2_supervisor.py and mujoco_ros2_control publish it; "
    "robot_state_publisher.cpp callbackJointState(): 'Moved backwards in time, re-publishing joint transforms!'",
    bad=[launched(_WITH_CLOCK % "«use_sim_time»", MANAGER, BROADCASTER, ARM, _RVIZ)],
    good=[
        SOUND,
        launched(_WITH_CLOCK % "use_sim_time", MANAGER, BROADCASTER, ARM, _WEBOTS),
        {
            **launched(_WITH_CLOCK % "use_sim_time", MANAGER, BROADCASTER, ARM, robot=_IN_MUJOCO),
            "package.xml": MANIFEST.replace("</name>", "</name><exec_depend>mujoco_ros2_control</exec_depend>"),
        },
    ],
)
def clock_of_other_world(project: Project) -> Iterator[Finding]:
    """use_sim_time of robot_state_publisher does not fit the simulator.

    In a simulation, joint states have the simulator's time. A robot_state_publisher with `use_sim_time: false` compares
    them with the computer's clock, and its transforms do not fit those of other nodes. With `use_sim_time: true` but
    without a simulator, MuJoCo's hardware included, nobody publishes /clock, and the node's time stands still.
    """
    launch = launch_of(project, ROS_2)
    if launch is None:
        return
    simulated = {simulator_of(project, control) for control in components(project)} - _WITHOUT_CLOCK
    has_no_clock = launch.runs_without_simulator and not (simulated or any(map(may_publish_time, launch.nodes)))
    simulation = next((simulation for simulation in launch.simulations if simulation.sure), None)
    for node in state_publishers(launch):
        value = dict(node.values).get("use_sim_time", "").lower()
        at = next((word.at for word in node.parameters if word.text == "use_sim_time"), node.at)
        if simulation and value == "false" and node.sure:
            message = f"'{node.executable.text}' has use_sim_time false, but a simulator runs; set it to true"
            yield Finding(at, message, (Note("the simulator is started here", simulation.at),))
        elif value == "true" and node.sure and has_no_clock:
            message = (
                f"'{node.executable.text}' has use_sim_time true, but no simulator publishes the time; set it to false"
            )
            yield Finding(at, message)
