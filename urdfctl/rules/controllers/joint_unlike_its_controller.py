"""UC448."""

from __future__ import annotations

from collections import Counter
from collections.abc import Iterator

from urdfctl.model.controllers import Controller
from urdfctl.record import NamedTuple
from urdfctl.rule import Finding, Project, Severity, rule
from urdfctl.rules.common import replaced
from urdfctl.rules.controllers.common import controllers_in
from urdfctl.rules.controllers.joints import in_row
from urdfctl.source.span import Place
from urdfctl.suggest import is_slip

_LEAST = 3
"""So many controllers show how joints are called after them."""
_CONTROLLERS = """
    shoulder_pan_controller: {type: position_controllers/JointPositionController, joint: shoulder_pan_joint}
    shoulder_lift_controller: {type: position_controllers/JointPositionController, joint: %s}
    elbow_flex_controller: {type: position_controllers/JointPositionController, joint: elbow_flex_joint}
    wrist_roll_controller: {type: position_controllers/JointPositionController, joint: wrist_roll_joint}
"""


@rule(
    "UC448",
    severity=Severity.WARNING,
    authority="ros_controllers: 'Could not find joint 'shouler_lift_joint' in 'hardware_interface::EffortJointInterface'.'; "
    "PR2/pr2_simulator#109",
    options=["--distro=noetic"],
    bad={"controllers.yaml": _CONTROLLERS % "«shouler_lift_joint»"},
    good={"controllers.yaml": _CONTROLLERS % "shoulder_lift_joint"},
)
def joint_unlike_its_controller(project: Project) -> Iterator[Finding]:
    """A controller's joint is called almost, but not quite, as the controller is.

    The other controllers of the file are named after their joints, this one's joint looks misspelt. That is told only
    where no robot is known to ask.
    """
    pairs = list(_pairs(project)) if project.robot is None else []
    for (ending, other), count in Counter(pair.endings for pair in pairs).items():
        if not ending or not other or count < _LEAST:
            continue
        alike = [pair for pair in pairs if pair.controller.endswith(ending)]
        for pair in alike if 2 * count > len(alike) else ():
            stem = pair.controller.removesuffix(ending)
            right = stem + other
            if _is_slip(pair, right) or _is_half(pair, stem):
                name = f"joint '{pair.joint}' is not called after its controller '{pair.controller}'"
                message = f"{name}, as those of the others are; did you mean '{right}'?"
                yield Finding(pair.at, message, fix=replaced(pair.at, pair.joint, right))


class _Pair(NamedTuple):
    """A controller and its only joint."""

    controller: str
    joint: str
    at: Place

    @property
    def stem(self) -> str:
        """The words that both names begin with."""
        words = zip(self.controller.split("_"), self.joint.split("_"), strict=False)
        count = next((i for i, (one, other) in enumerate(words) if one != other), 0)
        return "_".join(self.controller.split("_")[:count])

    @property
    def endings(self) -> tuple[str, str]:
        """What each name has behind that; empty where they have nothing in common."""
        length = len(self.stem)
        return (self.controller[length:], self.joint[length:]) if length else ("", "")


def _pairs(project: Project) -> Iterator[_Pair]:
    for controller in controllers_in(project).controllers:
        found = _only_joint(controller)
        if found is not None:
            yield _Pair(controller.name, *found)


def _only_joint(controller: Controller) -> tuple[str, Place] | None:
    value = controller.own.value("joint") or controller.own.value("joints")
    joints = value.strings if value is not None and value.is_known else ()
    return joints[0] if len(joints) == 1 else None


def _is_slip(pair: _Pair, right: str) -> bool:
    """Whether a joint is misspelt, and is not one of another side or number."""
    return is_slip(right, pair.joint) and in_row(right) != in_row(pair.joint)


def _is_half(pair: _Pair, stem: str) -> bool:
    """Whether a joint has part of the ending of its controller in place of its own."""
    return pair.controller.startswith(f"{pair.joint}_") and pair.joint.startswith(f"{stem}_")
