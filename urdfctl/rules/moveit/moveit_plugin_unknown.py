"""UC677."""

from __future__ import annotations

from collections.abc import Iterator

from urdfctl.catalog.distros import ROS2
from urdfctl.model.moveit.build_moveit import PLUGIN
from urdfctl.names import nearest
from urdfctl.rule import Finding, Project, Severity, rule
from urdfctl.rules.common import replaced
from urdfctl.rules.moveit.samples import built, planned

_CLASSES = (
    "moveit_simple_controller_manager/MoveItSimpleControllerManager",
    "moveit_ros_control_interface/Ros2ControlManager",
    "moveit_ros_control_interface/Ros2ControlMultiManager",
    "moveit_ros_control_interface/MoveItControllerManager",
    "moveit_ros_control_interface/MoveItMultiControllerManager",
)
_MOVEIT = """
    {}: {}
    moveit_simple_controller_manager:
      controller_names: [arm_controller]
      arm_controller: {{type: FollowJointTrajectory, action_ns: follow_joint_trajectory, joints: [shoulder, elbow]}}
"""


@rule(
    "UC677",
    severity=Severity.WARNING,
    runtime="refuses",
    distros=ROS2,
    because="planning works without controllers",
    authority="moveit2 trajectory_execution_manager.cpp initialize(): 'Parameter '~moveit_controller_manager' not specified. "
    "... No paths can be executed.', 'Exception while loading controller manager'; moveit_ros_control_interface "
    "moveit_core_plugins.xml",
    options=["--distro=jazzy"],
    bad=[
        planned(moveit_controllers=_MOVEIT.format("«moveit_controler_manager»", _CLASSES[0])),
        planned(moveit_controllers=_MOVEIT.format(PLUGIN, f"«{_CLASSES[0].replace('/', '::')}»")),
        built(
            "{}", {"config/moveit_controllers.yaml": _MOVEIT.format(PLUGIN, f"«{_CLASSES[0].replace('MoveIt', '')}»")}
        ),
    ],
    good=[
        *(planned(moveit_controllers=_MOVEIT.format(PLUGIN, name)) for name in _CLASSES),
        planned(moveit_controllers=_MOVEIT.format(PLUGIN, "crane_moveit/CraneManager")),
    ],
)
def moveit_plugin_unknown(project: Project) -> Iterator[Finding]:
    """MoveIt's plugin for controllers is misspelt.

    moveit_controller_manager names the class by which move_group reaches the controllers, as package/Class. If the key
    or the class has another name, move_group logs a fatal error. It still plans, but executes nothing. A class that is
    not similar to one of MoveIt's may be of another package, and is not reported.
    """
    plugin = project.moveit.plugin if project.moveit else None
    if plugin is None:
        return
    key, value = plugin
    if key.text != PLUGIN:
        message = f"MoveIt reads '{PLUGIN}', not '{key.text}', so it executes nothing"
        yield Finding(key.at, message, fix=replaced(key.at, key.text, PLUGIN))
    right = nearest(value.text, _CLASSES) if value.text not in _CLASSES else None
    if right is not None:
        message = f"MoveIt has no plugin '{value.text}', so it executes nothing; did you mean '{right}'?"
        yield Finding(value.at, message, fix=replaced(value.at, value.text, right))
