"""UC640."""

from __future__ import annotations

from collections.abc import Iterator

from urdfctl.catalog.distros import ROS2
from urdfctl.control.hardware.simulator_plugins import components, simulator_of
from urdfctl.model.launch import Launch
from urdfctl.rule import Finding, Project, Severity, StageDependsOn, rule
from urdfctl.rules.launch.common import ROS_2, launch_of, manager_nodes, may_publish_time
from urdfctl.rules.launch_samples import ARM, BROADCASTER, CONTROLLERS, MANAGER, PUBLISHER, SOUND, launched
from urdfctl.source.span import Place

_TIMED = CONTROLLERS.replace("update_rate: 100", "update_rate: 100\n        use_sim_time: %s")
_RVIZ = '<node pkg="rviz2" exec="rviz2" args="-d display.rviz"/>'
_GIVEN = MANAGER.replace("</node>", '  <param name="use_sim_time" value="«true»"/>\n      </node>')


@rule(
    "UC640",
    severity=Severity.ERROR,
    runtime="refuses",
    stage=StageDependsOn.SPAWNER,
    distros=ROS2,
    whole_robot=True,
    authority="rclcpp time_source.cpp: with use_sim_time the time stays at 0 until /clock comes; ros2_control_node.cpp sleeps "
    "until the next period; controller_manager.cpp: 'Switch controller timed out after 5 seconds!' (measured in jazzy)",
    options=["--distro=jazzy"],
    bad=[
        launched(PUBLISHER, MANAGER, BROADCASTER, ARM, controllers=_TIMED % "«true»"),
        launched(PUBLISHER, _GIVEN, BROADCASTER, ARM, _RVIZ),
    ],
    good=[SOUND],
)
def manager_without_clock(project: Project) -> Iterator[Finding]:
    """Controller manager waits for a time that nobody publishes.

    With `use_sim_time: true` the controller manager takes its time from /clock. Nothing in the launch file publishes
    it, so the manager waits, and each switch of controllers fails. With hardware that a simulator outside
    of the launch file may drive this is only a warning.
    """
    launch = launch_of(project, ROS_2)
    if launch is None or not launch.runs_without_simulator or any(map(may_publish_time, launch.nodes)):
        return
    kinds = {simulator_of(project, control) for control in components(project)}
    if not kinds or kinds - {None, "mock"}:
        return
    for at in _places(project, launch):
        message = "the controller manager has use_sim_time true, but nothing publishes /clock; set it to false"
        yield Finding(at, message, severity=None if kinds == {"mock"} else Severity.WARNING)


def _places(project: Project, launch: Launch) -> Iterator[Place]:
    """The places that give a manager simulated time."""
    managers = project.controllers.managers if project.controllers else ()
    values = [manager.parameters.value("use_sim_time") for manager in managers]
    given = [value.at for value in values if value is not None and value.value is True]
    yield from given
    for node in manager_nodes(launch) if not given else ():
        if node.sure and dict(node.values).get("use_sim_time", "").lower() == "true":
            yield next((word.at for word in node.parameters if word.text == "use_sim_time"), node.at)
