"""The steps of a bringup: start the simulator, spawn the model, load and spawn the controllers, publish the description.

A rule about a missing step speaks only if the launch file is wholly known, and no other text of the workspace (a second
launch file, a script, the commands in a README) does the step: `Project.may_mention`.
"""

from __future__ import annotations

from collections.abc import Iterator

from urdfctl.control.hosts import MANAGER
from urdfctl.model.launch import Launch, Node, joined
from urdfctl.rule import Project
from urdfctl.rules.launch.common import manager_nodes

SPAWNS_CONTROLLERS = (
    r"\bspawner\b|(?:load|start|switch)_controller|(?:Load|Switch)Controller|ros2 control |controller_manager\.launch_utils|"
    r"controllers?_spawner|generate_\w*controllers?_launch|controller_manager\s+(?:spawn|load|start)"
)
"""What says that a text may spawn controllers."""
STARTS_SIMULATOR = (
    r"gz_sim\.launch|gz_server|gzserver|GzServer|gz sim\b|ign gazebo|gz_sim_composition|gazebo\.launch|_world\.launch|"
    r"gazebo_ros\s+(?:gazebo|debug)|type=.gazebo|(?:launch|run)\s+\S*(?:gazebo|gz|ign|sim)|\bgazebo\s+(?:-|\S+\.world)"
)
SPAWNS_MODEL = (
    r"spawn_(?:entity|model|urdf)|Spawn(?:Entity|Model)|urdf_spawner|EntityFactory|gz model|model-file|"
    r"(?:executable|exec|type)\s*=\s*.create\b|gazebo\s+create\b|gz_sim\s+create\b|/create\b|gz_spawn_model"
)
_OWN_MANAGER = rf"{MANAGER}|(?:type|exec|executable)\s*=\s*.\w*(?:hardware|driver)"
"""What says that a launch file starts a controller manager, or a driver that contains one."""
_OWN_SIMULATOR = (
    r"(?:gazebo_ros|ros_gz_sim|ros_ign_gazebo)\W[\s\S]{0,120}?(?:\w+_world|gazebo|gzserver|gz_sim|ign_gazebo)\.launch"
)
"""What says that a launch file starts a simulator: nobody starts two of these beside each other."""
PUBLISHES_DESCRIPTION = r"robot_state_publisher|robot_description"
_DESCRIPTION = "robot_description"


def started_apart(launch: Launch) -> str:
    """Return what the launch files say that are not started beside this one: each starts a simulator, or a controller
    manager, of its own, as this one does; empty if it starts neither."""
    if any(simulation.sure for simulation in launch.simulations):
        return f"{_OWN_SIMULATOR}|{_OWN_MANAGER}"
    return _OWN_MANAGER if any(node.sure for node in manager_nodes(launch)) else ""


def description_topic(node: Node, name: str = _DESCRIPTION) -> str:
    """Return the full name of the topic that a node calls robot_description, or by another name."""
    own = joined(node.namespace or "", name)
    renamed = next((after for before, after in node.remaps if before in {name, own}), name)
    return joined(node.namespace or "", renamed)


def declared_controllers(project: Project) -> Iterator[str]:
    """Yield the names of the controllers that the files declare with a type."""
    for each in project.controllers.controllers if project.controllers else ():
        if each.declared_at is not None and each.type is not None:
            yield each.name
