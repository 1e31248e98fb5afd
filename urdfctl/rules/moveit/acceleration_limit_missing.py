"""UC668."""

from __future__ import annotations

from collections.abc import Iterator

from urdfctl.catalog.distros import since
from urdfctl.rule import Finding, Project, Severity, rule
from urdfctl.rules.common import in_words
from urdfctl.rules.moveit.common import is_of_other_robot, planning
from urdfctl.rules.moveit.samples import LIMITS, planned

_FLAG, _VALUE = "has_acceleration_limits", "max_acceleration"
_WITHOUT = LIMITS.replace("has_acceleration_limits: true", "has_acceleration_limits: false", 1)


@rule(
    "UC668",
    runtime="refuses",
    because="another file may give the limit",
    severity=Severity.WARNING,
    distros=since("iron"),
    options=("--distro=jazzy",),
    whole_robot=True,
    in_library=False,
    authority="moveit_core time_optimal_trajectory_generation.cpp: 'No acceleration limit was defined for joint shoulder! You have "
    "to define acceleration limits in the URDF or joint_limits.yaml'; until humble 1 rad/s^2 is assumed",
    bad=[planned(joint_limits=_WITHOUT.replace("shoulder:", "«shoulder»:"))],
    good=[planned(joint_limits=LIMITS)],
)
def acceleration_limit_missing(project: Project) -> Iterator[Finding]:
    """Joint of a planning group without an acceleration limit.

    Since iron, the adapter AddTimeOptimalParameterization fails without an acceleration limit for each joint, and every
    plan fails. The URDF has no such limit, so joint_limits.yaml must give it.
    """
    groups, moveit = planning(project), project.moveit
    if groups is None or moveit is None or not moveit.limits or is_of_other_robot(project):
        return
    limited = {
        each.joint.text
        for each in moveit.limits
        if (flag := each.value(_FLAG)) and flag.text.lower() == "true" and each.value(_VALUE)
    }
    planned_for = {joint for group in groups.semantic.groups for joint in groups.active(group)}
    missing = sorted(planned_for - limited - {joint.text for joint in groups.semantic.passive})
    if missing:
        at = next((each.joint.at for each in moveit.limits if each.joint.text in missing), moveit.limits[0].joint.at)
        joints = f"joint{'s' * (len(missing) > 1)} {in_words(missing, 3)}"
        message = f"no acceleration limit for {joints}; plans fail when they are timed. Set {_VALUE}"
        severity = None if set(project.distros) <= set(since("iron")) else Severity.INFO
        yield Finding(at, message, severity=severity)
