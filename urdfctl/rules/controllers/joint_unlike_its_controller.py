"""UC448."""

from __future__ import annotations

from collections import Counter
from collections.abc import Iterator

from urdfctl.control.parameters.readers import controllers_in
from urdfctl.model.controllers import Controller
from urdfctl.names import in_row, is_slip
from urdfctl.rule import Finding, Project, Severity, rule
from urdfctl.rules.common import replaced
from urdfctl.source.span import Place
from urdfctl.startup.records import NamedTuple

_LEAST = 3
"""At least this many controllers must be named after their joints to make a naming scheme."""
_CONTROLLERS = """
    shoulder_pan_controller: {type: position_controllers/JointPositionController, joint: shoulder_pan_joint}
    shoulder_lift_controller: {type: position_controllers/JointPositionController, joint: %s}
    elbow_flex_controller: {type: position_controllers/JointPositionController, joint: elbow_flex_joint}
    wrist_roll_controller: {type: position_controllers/JointPositionController, joint: wrist_roll_joint}
"""


@rule(
    "UC448",
    runtime="refuses",
    because="no robot is known: the name only looks misspelt",
    severity=Severity.WARNING,
    authority="ros_controllers: 'Could not find joint 'shouler_lift_joint' in 'hardware_interface::EffortJointInterface'.'; "
    "PR2/pr2_simulator#109",
    options=["--distro=noetic"],
    bad=[{"controllers.yaml": _CONTROLLERS % "«shouler_lift_joint»"}],
    good=[{"controllers.yaml": _CONTROLLERS % "shoulder_lift_joint"}],
)
def joint_unlike_its_controller(project: Project) -> Iterator[Finding]:
    """Joint name differs slightly from its controller's name.

    The other controllers in the file are named after their joints, so this joint's name looks misspelt. A controller
    without its joint is not loaded. Checked only if no robot is known.
    """
    pairs = list(_pairs(project)) if project.robot is None else []
    for (ending, joint_ending), count in Counter(pair.endings for pair in pairs).items():
        if not ending or not joint_ending or count < _LEAST:
            continue
        alike = [pair for pair in pairs if pair.controller.endswith(ending)]
        for pair in alike if 2 * count > len(alike) else ():
            stem = pair.controller.removesuffix(ending)
            right = stem + joint_ending
            if _is_slip(pair, right) or _is_half(pair, stem):
                start = f"joint '{pair.joint}' does not match the name of its controller '{pair.controller}'"
                message = f"{start}, unlike the other joints; did you mean '{right}'?"
                yield Finding(pair.at, message, fix=replaced(pair.at, pair.joint, right))


class _Pair(NamedTuple):
    """A controller and its only joint."""

    controller: str
    joint: str
    at: Place

    @property
    def stem(self) -> str:
        """The words at the start of both names."""
        words = zip(self.controller.split("_"), self.joint.split("_"), strict=False)
        count = next((i for i, (word, other) in enumerate(words) if word != other), 0)
        return "_".join(self.controller.split("_")[:count])

    @property
    def endings(self) -> tuple[str, str]:
        """The rest of each name after the stem; empty if the names have no stem in common."""
        length = len(self.stem)
        return (self.controller[length:], self.joint[length:]) if length else ("", "")


def _pairs(project: Project) -> Iterator[_Pair]:
    for controller in controllers_in(project).controllers:
        joint = _only_joint(controller)
        if joint is not None:
            yield _Pair(controller.name, *joint)


def _only_joint(controller: Controller) -> tuple[str, Place] | None:
    value = controller.own.value("joint") or controller.own.value("joints")
    joints = value.strings if value is not None and value.is_known else ()
    return joints[0] if len(joints) == 1 else None


def _is_slip(pair: _Pair, right: str) -> bool:
    """Whether a joint name is a misspelling, and not the name of a joint with another side or number."""
    return is_slip(right, pair.joint) and in_row(right) != in_row(pair.joint)


def _is_half(pair: _Pair, stem: str) -> bool:
    """Whether a joint name has part of its controller's ending instead of its own ending."""
    return pair.controller.startswith(f"{pair.joint}_") and pair.joint.startswith(f"{stem}_")
