"""UC652."""

from __future__ import annotations

from collections.abc import Iterator

from urdfctl.names import nearest
from urdfctl.rule import Finding, Project, Severity, rule
from urdfctl.rules.common import in_words, is_known, replaced
from urdfctl.rules.moveit.common import real_controllers
from urdfctl.rules.moveit.samples import configured


@rule(
    "UC652",
    runtime="refuses",
    because="another file may declare the controller",
    severity=Severity.WARNING,
    authority="moveit2 moveit_simple_controller_manager.cpp: 'Action client not connected: arm_controler/"
    "follow_joint_trajectory', 'Returned 0 controllers in list'",
    bad=[configured("[arm_controller]\n      arm_controller:", "[«arm_controler»]\n      arm_controler:")],
    good=[configured()],
)
def moveit_controller_unknown(project: Project) -> Iterator[Finding]:
    """Unknown controller in MoveIt's configuration.

    No controller file declares the controller. MoveIt waits for an action that no node offers, and executes nothing. The
    driver of an arm or a gripper may offer the action too.
    """
    controllers = project.controllers
    if controllers is None or not controllers.complete or not controllers.controllers:
        return
    names = list(dict.fromkeys(controller.name for controller in controllers.controllers))
    for controller in real_controllers(project):
        name = controller.name
        if name.text.rpartition("/")[2] in names or "$" in name.text or not is_known(name.text):
            continue
        meant = nearest(name.text, names)
        if meant is None and project.ros == 1 and project.launch is not None:
            continue  # the driver's launch file loads its controllers
        hint = f"did you mean '{meant}'?" if meant else f"declared: {in_words(names)}"
        fix = replaced(name.at, name.text, meant) if meant else None
        of_driver = meant is None and project.launch is not None  # a driver may offer the action
        severity = Severity.INFO if of_driver else None
        message = f"MoveIt uses controller '{name.text}', which no file declares; {hint}"
        yield Finding(name.at, message, (), fix, severity)
