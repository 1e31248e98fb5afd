"""Generate MoveIt's list of controllers, from the same controllers as the controller file."""

from __future__ import annotations

from collections.abc import Iterator, Sequence

from urdfctl.generate.controllers.parameters import GeneratedController
from urdfctl.generate.options import File, GeneratorOptions
from urdfctl.generate.text.scalars import one_line
from urdfctl.generate.text.templates import Templates

ACTIONS = {
    "JointTrajectoryController": ("FollowJointTrajectory", "follow_joint_trajectory"),
    "GripperActionController": ("GripperCommand", "gripper_cmd"),
}
"""The types of controllers that MoveIt uses, without their packages, with the type and the name of their action."""


def moveit_file(
    made: Sequence[GeneratedController], options: GeneratorOptions, templates: Templates, title: str
) -> File | None:
    """Return moveit_controllers.yaml with the controllers that MoveIt can use. None if there are none.

    MoveIt calls actions: of trajectory controllers, and of grippers that accept GripperCommand.
    """
    shown = []
    for controller, (kind, action) in usable_by_moveit(made):
        space = f"{options.namespace}/" if options.namespace and options.ros == 1 else ""
        joints = [joint.name for joint in controller.task.joints]
        shown.append({"name": f"{space}{controller.name}", "type": kind, "action": action, "joints": joints})
    if not shown:
        return None
    text = templates.render(
        "controllers/moveit.yaml",
        command=options.command,
        title=one_line(title),
        ros=options.ros,
        controllers=shown,
    )
    return File("config/moveit_controllers.yaml", text)


def usable_by_moveit(made: Sequence[GeneratedController]) -> Iterator[tuple[GeneratedController, tuple[str, str]]]:
    """Yield the controllers that MoveIt can use, each with the type and the name of its action."""
    for controller in made:
        action = ACTIONS.get(controller.type.type.rpartition("/")[2])
        if action is None or controller.waits or controller.task.below:
            continue
        parallel = "parallel_gripper" in controller.type.type
        yield controller, ("ParallelGripperCommand" if parallel else action[0], action[1])
