"""The wheels of a drive, which ROS 1's controller measured in the robot and ROS 2's wants written."""

from __future__ import annotations

from collections.abc import Iterator, Sequence

from urdfctl.generate.robot.facts import JointFacts
from urdfctl.generate.robot.survey import facts_of
from urdfctl.generate.robot.wheels import Measure, across, radius
from urdfctl.generate.text.scalars import yaml_float
from urdfctl.migrate.packages import MigratedPackages


def measured(
    packages: MigratedPackages, left: Sequence[str], right: Sequence[str], given: Sequence[str]
) -> Iterator[str]:
    """Yield the lines of a diff_drive_controller with the measures that are not given, from a robot with the wheels.

    A robot of which all parts are known comes first.
    """
    for loaded in sorted(packages.loaded(), key=lambda one: not one.project.complete):
        robot = loaded.project.robot
        if robot is None or not {*left, *right} <= {*robot.joint_names}:
            continue
        joints = {joint.name: joint for joint in facts_of(robot).joints}
        sides = [_of(joints, names) for names in (left, right)]
        if all(sides):
            yield from _lines(sides, given)
        return


def _of(joints: dict[str, JointFacts], names: Sequence[str]) -> list[JointFacts]:
    return [joints[name] for name in names if name in joints]


def _lines(sides: Sequence[Sequence[JointFacts]], given: Sequence[str]) -> Iterator[str]:
    measures: dict[str, Measure] = {"wheel_separation": across(*sides), "wheel_radius": radius([*sides[0], *sides[1]])}
    for name, measure in measures.items():
        if name not in given and measure.value is not None:
            yield f"{name}: {yaml_float(measure.value)}  # {measure.how}"
