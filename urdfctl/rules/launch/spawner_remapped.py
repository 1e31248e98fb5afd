"""UC647."""

from __future__ import annotations

from collections.abc import Iterator

from urdfctl.control.hosts import CONTROLLER_MANAGER
from urdfctl.rule import Finding, Project, Severity, rule
from urdfctl.rules.launch_samples import BROADCASTER, FILE, MANAGER, PUBLISHER, launched

_SPAWNERS = ("spawner", "spawner.py")
_REMAP = '<remap from="%s" to="/joint_states"/></node>'
_ARM = f"""
      «<node pkg="controller_manager" exec="%s" args="arm_controller {FILE}">»"""
_NODE = _ARM % "spawner" + _REMAP
_SOUND = _NODE.replace("«", "").replace("»", "") % "controller_manager/list_controllers"


@rule(
    "UC647",
    runtime="ignores",
    severity=Severity.WARNING,
    authority="controller_manager spawner.py, scripts/spawner: a client of the manager's services; the controller is a node "
    "in the process of the manager, which reads --controller-ros-args (jazzy) and not the remappings of its spawner",
    bad=[
        launched(PUBLISHER, MANAGER, BROADCASTER, _NODE % "arm_controller/joint_states"),
        {
            "arm.launch": """
                <launch>
                  «<node name="spawner" pkg="controller_manager" type="spawner" args="base">»
                    <remap from="base/cmd_vel" to="cmd_vel"/>
                  </node>
                </launch>
            """,
            "package.xml": "<package><name>arm</name><exec_depend>controller_manager</exec_depend></package>",
        },
        {
            **launched(PUBLISHER, MANAGER, BROADCASTER, (_ARM % "spawner.py" + _REMAP) % "arm_controller/joint_states"),
            "options": "--distro=foxy",
        },
    ],
    good=[launched(PUBLISHER, MANAGER, BROADCASTER, _SOUND)],
)
def spawner_remapped(project: Project) -> Iterator[Finding]:
    """Remapping of a spawner does not reach the controller.

    The spawner only asks the controller manager to load a controller. The remapping has no effect on its topics.
    Remap them at the controller manager, in the simulator's plugin (<ros><remapping>), or from jazzy on with
    --controller-ros-args.
    """
    for node in project.launch.nodes if project.launch else ():
        if not node.runs(CONTROLLER_MANAGER, *_SPAWNERS):
            continue
        lost = [old for old, _ in node.remaps if old and CONTROLLER_MANAGER not in old]
        if lost:
            yield Finding(node.at, f"the spawner's remapping of '{lost[0]}' does not reach the controller")
