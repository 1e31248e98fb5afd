"""What a robot itself cannot do, whatever controls it: one line for each fault, after a package is written."""

from __future__ import annotations

from collections.abc import Iterator, Sequence

from urdfctl.control.claims import claims
from urdfctl.generate.controllers.parameters import GeneratedController
from urdfctl.generate.options import GeneratorOptions
from urdfctl.generate.robot.facts import JointFacts, RobotFacts
from urdfctl.names import enumerated

_MOST_NAMED = 3


def cautions(made: Sequence[GeneratedController], robot: RobotFacts, options: GeneratorOptions) -> Iterator[str]:
    """Yield what will not work: a robot without masses, motors that are too weak, fingers that nothing moves."""
    if options.simulated and robot.joints and not any(joint.inertia for joint in robot.joints):
        yield "the robot has no masses, and a simulator drops moving links without them: add <inertial> to its links"
    kept = [name for name in robot.components if name and name not in robot.generated]
    if options.hardware and kept:
        which = f"<ros2_control> '{kept[0]}', which the robot has"
        yield f"--hardware {options.hardware} does not change the plugin of {which}"
    known = {joint.name: joint for joint in robot.joints}
    moved = [known[name] for name in _commanded(made) if name in known]
    weak = [joint for joint in moved if joint.effort and joint.load and joint.load.gravity > joint.effort]
    if weak:
        worst = max(weak, key=lambda joint: joint.load.gravity / joint.effort if joint.load and joint.effort else 0.0)
        held, unit = worst.load.gravity if worst.load else 0.0, "N" if worst.slides else "N m"
        yield (
            f"{_named(weak)} cannot hold the weight in every pose: '{worst.name}' needs {held:.3g} {unit}, "
            f"and its <limit> has effort {worst.effort:g}"
        )
    followers = [joint for joint in robot.joints if joint.mimic]
    if options.ros == 1 and options.simulated and followers:
        yield f"{_named(followers)} will hang: Gazebo Classic moves no mimic joints in ROS 1; add a plugin that does"


def _commanded(made: Sequence[GeneratedController]) -> Iterator[str]:
    for controller in made:
        claimed = claims(controller.type, controller.name, controller.values)
        yield from dict.fromkeys(claim.component for claim in claimed.command) if claimed else ()


def _named(joints: Sequence[JointFacts]) -> str:
    quoted = [f"'{joint.name}'" for joint in joints[:_MOST_NAMED]]
    rest = len(joints) - _MOST_NAMED
    names = enumerated([*quoted, f"{rest} more"] if rest > 0 else quoted)
    return f"{'joint' if len(joints) == 1 else 'joints'} {names}"
