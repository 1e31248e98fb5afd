"""UC606."""

from __future__ import annotations

from collections.abc import Iterator

from urdfctl.catalog.distros import ROS2
from urdfctl.rule import Finding, Note, Project, Severity, rule
from urdfctl.rules.common import in_words
from urdfctl.rules.launch.common import ROS_2, Running, hosts_no_manager, launch_of, manager_nodes, managers
from urdfctl.rules.launch.samples import BROADCASTER, FILE, MANAGER, PUBLISHER, SOUND, launched, spawner


@rule(
    "UC606",
    severity=Severity.ERROR,
    distros=ROS2,
    whole_robot=True,
    authority="ros2_control spawner.py: 'Could not contact service /left/controller_manager/list_controllers'",
    bad=launched(PUBLISHER, MANAGER, BROADCASTER, spawner(f"«arm_controller» -c /left/controller_manager {FILE}")),
    good=SOUND,
)
def spawner_of_other_manager(project: Project) -> Iterator[Finding]:
    """A spawner asks a controller manager of another name or namespace than the one that runs.

    The manager's name is made absolute in the spawner's namespace, and is `controller_manager` where `-c` gives none.
    The spawner waits for services that nobody offers.
    """
    launch = launch_of(project, ROS_2)
    if launch is None or not launch.complete or (project.robot is None and launch.simulations):
        return
    running = managers(project, launch)
    if not running or not all(_is_known(one) for one in running) or _placed_by_simulator(project):
        return
    if not all(hosts_no_manager(node) or node in manager_nodes(launch) for node in launch.nodes):
        return
    names = {one.full_name for one in running}
    for spawn in launch.spawns:
        asked = f"{spawn.namespace}/{spawn.manager}"
        if spawn.sure and spawn.namespace is not None and spawn.manager is not None and asked not in names:
            message = f"the spawner asks '{asked}', and the controller manager that runs is {in_words(sorted(names))}"
            at = spawn.names[0][1] if spawn.names else spawn.at
            yield Finding(at, message, tuple(Note("it is started here", one.at) for one in running))


def _is_known(one: Running) -> bool:
    return one.namespace is not None and one.name is not None and (one.node is None or one.node.sure)


def _placed_by_simulator(project: Project) -> bool:
    """Whether a model is spawned into a namespace, which its plugins take over."""
    nodes = project.launch.nodes if project.launch else ()
    return any("namespace" in word.text for node in nodes for word in node.words if word.text.startswith("-robot"))
