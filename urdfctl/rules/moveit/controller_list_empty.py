"""UC655."""

from __future__ import annotations

from collections.abc import Iterator

from urdfctl.names import is_slip
from urdfctl.rule import Finding, Project, Severity, rule
from urdfctl.rules.common import replaced
from urdfctl.rules.moveit.samples import built, planned

_MOVEIT = """
    moveit_simple_controller_manager:
      {}: {}
      arm_controller:
        type: FollowJointTrajectory
        action_ns: follow_joint_trajectory
        joints: [shoulder, elbow]
"""
_KEYS = ("moveit_simple_controller_manager", "controller_names", "controller_list")


@rule(
    "UC655",
    severity=Severity.WARNING,
    runtime="drops",
    because="planning works without controllers",
    authority="moveit_simple_controller_manager.cpp: 'Returned 0 controllers in list', 'No controller_names specified.'; "
    "trajectory_execution_manager.cpp: 'Unable to identify any set of controllers that can actuate the specified joints'; "
    "moveit_configs_builder.py trajectory_execution(): 'no matches for config/*_controllers.yaml'",
    bad=[
        planned(moveit_controllers=_MOVEIT.format("«controller_names»", "[]")),
        planned(moveit_controllers=_MOVEIT.format("«controller_name»", "[arm_controller]")),
        planned(
            moveit_controllers=_MOVEIT.format("controller_names", "[arm_controller]").replace(
                "moveit_simple_controller_manager", "«moveit_simple_controler_manager»"
            )
        ),
        built("«{}»", {}),
    ],
    good=[
        planned(moveit_controllers=_MOVEIT.format("controller_names", "[arm_controller]")),
        built("{}", {"config/moveit_controllers.yaml": _MOVEIT.format("controller_names", "[arm_controller]")}),
    ],
)
def controller_list_empty(project: Project) -> Iterator[Finding]:
    """MoveIt's list of controllers is empty, or its key is misspelt.

    MoveIt plans, but knows no controller that could execute the plan. The setup assistant of ROS 1 writes an empty
    controller_list if no controllers were added in it. List each controller with its name, action_ns, type and joints.
    MoveItConfigsBuilder reads config/*_controllers.yaml, and goes on with a warning if there is none.
    """
    moveit = project.moveit
    if moveit is not None and moveit.files is not None and moveit.files.undecided == () and moveit.files.runs:
        message = "config/ has no moveit_controllers.yaml, so MoveIt knows no controller and executes nothing"
        yield Finding(moveit.files.at, message)
    if moveit is not None and moveit.no_controllers is not None and not moveit.controllers:
        at = moveit.no_controllers
        right = next((name for name in _KEYS if is_slip(at.span.text, name)), None)
        if right is None:
            yield Finding(at, f"{at.span.text} is empty, so MoveIt knows no controller and executes nothing")
        else:
            message = f"MoveIt reads '{right}', not '{at.span.text}', so it knows no controller and executes nothing"
            yield Finding(at, message, fix=replaced(at, at.span.text, right))
