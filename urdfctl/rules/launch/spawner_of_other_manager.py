"""UC606."""

from __future__ import annotations

from collections.abc import Iterator

from urdfctl.catalog.distros import ROS2
from urdfctl.control.hosts import hosts_no_manager
from urdfctl.rule import Finding, Note, Project, Severity, StageDependsOn, rule
from urdfctl.rules.common import in_words
from urdfctl.rules.launch.common import ROS_2, Running, launch_of, managers
from urdfctl.rules.launch_samples import (
    BROADCASTER,
    FILE,
    MANAGER,
    PUBLISHER,
    ROBOT,
    SOUND,
    launched,
    spawner,
)

_WITH_PLUGIN = (
    ROBOT
    + """
    <gazebo>
      <plugin name="gz_ros2_control::GazeboSimROS2ControlPlugin" filename="gz_ros2_control-system">
        <parameters>$(find arm)/controllers.yaml</parameters>
      </plugin>
    </gazebo>
"""
)
_ELSEWHERE = MANAGER.replace('exec="ros2_control_node"', 'exec="ros2_control_node" namespace="left"')


@rule(
    "UC606",
    severity=Severity.ERROR,
    runtime="refuses",
    stage=StageDependsOn.SPAWNER,
    distros=ROS2,
    whole_robot=True,
    authority="ros2_control spawner.py: 'Could not contact service /left/controller_manager/list_controllers'",
    bad=[
        launched(PUBLISHER, MANAGER, BROADCASTER, spawner(f"«arm_controller» -c /left/controller_manager {FILE}")),
        launched(
            PUBLISHER, _ELSEWHERE, BROADCASTER.replace('"joint', '"«joint').replace('r"/>', 'r»"/>'), robot=_WITH_PLUGIN
        ),
    ],
    good=[SOUND],
)
def spawner_of_other_manager(project: Project) -> Iterator[Finding]:
    """Spawner contacts a controller manager that does not run.

    The manager's name is resolved in the spawner's namespace. Without `-c` it is `controller_manager`. The spawner
    waits for services that no node offers.
    """
    launch = launch_of(project, ROS_2)
    if launch is None or not launch.complete or (project.robot is None and launch.simulations):
        return
    running = managers(project, launch)
    if not running or not all(_is_known(manager) for manager in running) or _placed_by_simulator(project):
        return
    known = [manager.node for manager in running]
    if not all(hosts_no_manager(node) or node in known for node in launch.nodes):
        return
    names = {manager.full_name for manager in running}
    for spawn in launch.spawns:
        asked = f"{spawn.namespace}/{spawn.manager}"
        if spawn.sure and spawn.namespace is not None and spawn.manager is not None and asked not in names:
            subject = "controller manager is" if len(names) == 1 else "controller managers are"
            message = f"the spawner contacts '{asked}', but the running {subject} {in_words(sorted(names))}"
            at = spawn.names[0][1] if spawn.names else spawn.at
            yield Finding(
                at, message, tuple(Note("a controller manager is started here", manager.at) for manager in running)
            )


def _is_known(manager: Running) -> bool:
    return manager.namespace is not None and manager.name is not None and (manager.node is None or manager.node.sure)


def _placed_by_simulator(project: Project) -> bool:
    """Return whether a model is spawned into a namespace, which its plugins inherit."""
    nodes = project.launch.nodes if project.launch else ()
    return any("namespace" in word.text for node in nodes for word in node.words if word.text.startswith("-robot"))
