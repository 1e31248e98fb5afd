"""UC627."""

from __future__ import annotations

from collections.abc import Iterator

from urdfctl.rule import Finding, Project, Severity, rule
from urdfctl.rules.launch.common import ROS_2, is_spawner
from urdfctl.rules.launch_samples import ARM, BROADCASTER, FILE, MANAGER, PUBLISHER, SOUND, launched, spawner

_OF_ROS_1 = '<launch>%s<node name="s" pkg="controller_manager" type="spawner" args="%s"/></launch>'
_OF_MOVEIT = "ros_controllers.launch"
"""What MoveIt's assistant writes, also for a robot without controllers, beside the launch file that spawns them."""
_MANIFEST = "<package><name>arm</name><exec_depend>controller_manager</exec_depend></package>"


@rule(
    "UC627",
    severity=Severity.ERROR,
    runtime="refuses",
    authority="ros2_control spawner.py, ros_control controller_manager/scripts/spawner: nargs='+', so that argparse ends the program; "
    "controller_manager.cpp: 'The 'type' param was not defined for '''",
    bad=[
        launched(PUBLISHER, MANAGER, BROADCASTER, ARM, spawner(f"«{FILE}»")),
        {
            "arm.launch": '<launch><node name="s" pkg="controller_manager" type="spawner" args="«--namespace=/arm»"/></launch>',
            "package.xml": _MANIFEST,
        },
    ],
    good=[SOUND],
)
def spawner_without_name(project: Project) -> Iterator[Finding]:
    """Spawner gets no name of a controller.

    The spawner ends with an error, because it needs one name at least; with an empty one, the controller manager finds no
    type for it. Name the controllers in the arguments. In a launch file of ROS 1 that starts no robot, and in the
    one that MoveIt's assistant writes for a robot without controllers, this is only worth knowing.
    """
    launch = project.launch
    for spawn in launch.spawns if launch else ():
        if not (spawn.sure and spawn.complete and is_spawner(spawn)):
            continue
        empty = [at for name, at in spawn.names if not name.strip()]
        if empty:
            yield Finding(empty[0], "the spawner gets an empty name; name the controllers in its arguments")
        elif not spawn.names:
            is_of_moveit = spawn.at.span.source.path.endswith(_OF_MOVEIT)
            alone = launch is not None and launch.ros != ROS_2 and (is_of_moveit or not launch.descriptions)
            message = "the spawner gets no name of a controller; name the controllers in its arguments"
            yield Finding(spawn.at, message, severity=Severity.INFO if alone else None)
