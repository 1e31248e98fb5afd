"""UC652."""

from __future__ import annotations

from collections.abc import Iterator

from urdfctl.catalog.distros import ROS2
from urdfctl.rule import Finding, Project, Severity, rule
from urdfctl.rules.common import in_words, replaced
from urdfctl.rules.moveit.samples import configured
from urdfctl.suggest import nearest


@rule(
    "UC652",
    severity=Severity.WARNING,
    distros=ROS2,
    authority="moveit2 moveit_simple_controller_manager.cpp: 'Action client not connected: arm_controler/"
    "follow_joint_trajectory', 'Returned 0 controllers in list'",
    bad=configured("[arm_controller]\n      arm_controller:", "[«arm_controler»]\n      arm_controler:"),
    good=configured(),
)
def moveit_controller_unknown(project: Project) -> Iterator[Finding]:
    """MoveIt is told to use a controller that ros2_controllers.yaml does not declare.

    MoveIt waits for an action of that name, which nobody offers, and executes nothing.
    """
    controllers = project.controllers
    if controllers is None or not controllers.complete or not controllers.controllers:
        return
    names = list(dict.fromkeys(one.name for one in controllers.controllers))
    for controller in controllers.moveit:
        name = controller.name
        if name.text.rpartition("/")[2] in names:
            continue
        meant = nearest(name.text, names)
        hint = f"did you mean '{meant}'?" if meant else f"declared are {in_words(names)}"
        fix = replaced(name.at, name.text, meant) if meant else None
        yield Finding(name.at, f"MoveIt is told to use '{name.text}', which no file declares; {hint}", (), fix)
