"""UC653."""

from __future__ import annotations

from collections.abc import Iterator

from urdfctl.model.controllers import Controller, Controllers, Key, MoveItController
from urdfctl.model.robot import Robot
from urdfctl.names import did_you_mean
from urdfctl.rule import Finding, Note, Project, Severity, rule
from urdfctl.rules.common import in_words
from urdfctl.rules.moveit.common import real_controllers
from urdfctl.rules.moveit.samples import configured

_PARTIAL = "allow_partial_joints_goal"


@rule(
    "UC653",
    severity=Severity.ERROR,
    runtime="refuses",
    authority="ros2_controllers joint_trajectory_controller.cpp: 'Incoming joint elbow_joint doesn't match the controller's "
    "joints.', 'Joints on incoming trajectory don't match the controller joints.'; moveit_ros "
    "trajectory_execution_manager.cpp distributeTrajectory(): no fixed, passive or mimic joint",
    bad=[configured("joints: [shoulder, elbow]", "joints: [shoulder, «elbow_joint»]")],
    good=[configured()],
)
def moveit_joints_differ(project: Project) -> Iterator[Finding]:
    """MoveIt and the controller list different joints.

    The controller rejects every goal that names a joint it does not control. Unless it allows partial goals, it also
    rejects every goal that omits one of its joints. MoveIt sends no positions of joints that are fixed or mimic others,
    or that the robot lacks.
    """
    controllers = project.controllers
    if project.moveit is None or project.moveit.guessed:
        return
    for moveit in real_controllers(project):
        if any("$(" in joint.text for joint in moveit.joints):
            continue  # what roslaunch puts there is not known
        controller = _meant(moveit, controllers) if controllers else None
        joints = controller.own.value("joints") if controller else None
        names = [item.text for item in joints.items] if joints and joints.items else []
        if controller is not None and joints is not None and names and "Trajectory" in (moveit.type or ""):
            moveit = moveit._replace(joints=tuple(_sent(moveit, names, project.robot)))  # noqa: PLW2901
            note = Note("the controller's joints are here", joints.at)
            severity = None if project.robot else Severity.WARNING  # the joint may mimic another one
            if project.robot is None and project.launch is not None:
                continue  # other launch files start the robot
            for finding in _compared(moveit, controller, names, note):
                yield finding._replace(severity=finding.severity or severity)


def _meant(moveit: MoveItController, controllers: Controllers) -> Controller | None:
    """The controller with the name that MoveIt uses, which may have a namespace; or the only one of the last word."""
    name = moveit.name.text.strip("/")
    last = name.rpartition("/")[2]
    same = [each for each in controllers.controllers if each.full_name.rpartition("/")[2] == last]
    return controllers.controller(name) or (same[0] if len(same) == 1 else None)


def _sent(moveit: MoveItController, names: list[str], robot: Robot | None) -> Iterator[Key]:
    """Yield the listed joints of the controller, and those others that MoveIt may send it: no fixed joint, none that
    mimics, and none that the robot lacks, unless it stands for one of the controller's that is not listed."""
    known = {joint.name: joint for joint in robot.joints} if robot else {}
    is_whole = set(names) <= {joint.text for joint in moveit.joints}
    for joint in moveit.joints:
        own = known.get(joint.text)
        never = (own.mimic or not own.moves) if own else robot is not None and is_whole
        if joint.text in names or not never:
            yield joint


def _compared(moveit: MoveItController, controller: Controller, names: list[str], note: Note) -> Iterator[Finding]:
    unknown = [joint for joint in moveit.joints if joint.text not in names]
    for joint in unknown:
        message = (
            f"controller '{controller.name}' does not control joint '{joint.text}' and rejects trajectories for it"
        )
        yield Finding(joint.at, f"{message}{did_you_mean(joint.text, names)}", (note,))
    missing = [name for name in names if name not in {joint.text for joint in moveit.joints}]
    partial = controller.own.value(_PARTIAL)
    if missing and moveit.joints and not unknown and not (partial and partial.text.lower() == "true"):
        message = (
            f"MoveIt's joints for controller '{controller.name}' do not include {in_words(missing)}; "
            "the controller rejects incomplete trajectories"
        )
        yield Finding(moveit.joints[0].at, message, (note,), severity=Severity.WARNING)
