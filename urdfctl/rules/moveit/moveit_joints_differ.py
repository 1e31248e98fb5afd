"""UC653."""

from __future__ import annotations

from collections.abc import Iterator

from urdfctl.catalog.distros import ROS2
from urdfctl.model.controllers import Controller, MoveItController
from urdfctl.rule import Finding, Note, Project, Severity, rule
from urdfctl.rules.common import in_words
from urdfctl.rules.moveit.samples import configured
from urdfctl.suggest import did_you_mean

_PARTIAL = "allow_partial_joints_goal"


@rule(
    "UC653",
    severity=Severity.ERROR,
    distros=ROS2,
    authority="ros2_controllers joint_trajectory_controller.cpp: 'Incoming joint elbow_joint doesn't match the controller's "
    "joints.', 'Joints on incoming trajectory don't match the controller joints.'",
    bad=configured("joints: [shoulder, elbow]", "joints: [shoulder, «elbow_joint»]"),
    good=configured(),
)
def moveit_joints_differ(project: Project) -> Iterator[Finding]:
    """MoveIt sends a controller trajectories for other joints than it controls.

    The controller refuses each goal that names a joint it does not have, and, unless it allows partial goals, each that
    leaves one out.
    """
    controllers = project.controllers
    for controller in controllers.moveit if controllers else ():
        name = controller.name.text.rpartition("/")[2]
        found = controllers.controller(name) if controllers else None
        joints = found.own.value("joints") if found else None
        names = [item.text for item in joints.items] if joints and joints.items else []
        if found is not None and joints is not None and names and "Trajectory" in (controller.type or ""):
            yield from _compared(controller, found, names, Note("the controller's joints are here", joints.at))


def _compared(controller: MoveItController, found: Controller, names: list[str], note: Note) -> Iterator[Finding]:
    strange = [joint for joint in controller.joints if joint.text not in names]
    for joint in strange:
        message = f"'{found.name}' does not control '{joint.text}', and refuses MoveIt's trajectories for it"
        yield Finding(joint.at, f"{message}{did_you_mean(joint.text, names)}", (note,))
    left = [name for name in names if name not in {joint.text for joint in controller.joints}]
    partial = found.own.value(_PARTIAL)
    if left and controller.joints and not strange and not (partial and partial.text.lower() == "true"):
        message = f"MoveIt sends '{found.name}' no {in_words(left)}: it refuses trajectories that leave joints out"
        yield Finding(controller.joints[0].at, message, (note,), severity=Severity.WARNING)
