"""UC437."""

from __future__ import annotations

import re
from collections.abc import Iterator

from urdfctl.catalog.values import elements, is_known
from urdfctl.control.parameters.readers import Reader, in_each_distro
from urdfctl.names import nearest
from urdfctl.rule import Finding, Project, Severity, rule
from urdfctl.rules.common import replaced
from urdfctl.rules.controllers.parameters import known_as


@rule(
    "UC437",
    severity=Severity.WARNING,
    runtime="ignores",
    authority="generate_parameter_library: parameters with __map_ are declared for each element of the list they name",
    options=["--distro=jazzy"],
    bad=[
        {
            "controllers.yaml": """
                controller_manager:
                  ros__parameters:
                    update_rate: 100
                    arm: {type: joint_trajectory_controller/JointTrajectoryController}
                arm:
                  ros__parameters:
                    joints: [shoulder, elbow]
                    command_interfaces: [position]
                    state_interfaces: [position]
                    constraints:
                      «elbwo»: {goal: 0.1}
            """
        },
    ],
    good=[
        {
            "controllers.yaml": """
                controller_manager:
                  ros__parameters:
                    update_rate: 100
                    arm: {type: joint_trajectory_controller/JointTrajectoryController}
                arm:
                  ros__parameters:
                    joints: [shoulder, elbow]
                    command_interfaces: [position]
                    state_interfaces: [position]
                    constraints:
                      elbow: {goal: 0.1}
            """
        },
    ],
)
def parameter_of_no_element(project: Project) -> Iterator[Finding]:
    """Parameter for a joint that the controller does not list.

    Constraints, gains and the like are read for each element of a list, such as `joints`. Those for other names are
    ignored silently.
    """
    joints = frozenset(project.robot.joint_names if project.robot else ())
    return in_each_distro(project, lambda reader: _unlisted(reader, joints), newest=True)


def _unlisted(reader: Reader, joints: frozenset[str]) -> Iterator[Finding]:
    reported = set()
    for leaf in reader.own.leaves:
        pattern, element = known_as(reader, leaf.name) or ("", None)
        listing = re.search("<([^<>]+)>", pattern)
        if listing is None or element is None or not is_known(element):
            continue
        value = reader.given.get(listing[1])
        listed = [part for part in elements(value) if isinstance(part, str)]
        if not listed or element in listed or not is_known(value) or element in reported:
            continue
        reported.add(element)
        if element in joints and nearest(element, [name for name in listed if name not in joints]):
            continue  # UC440 reports the name in the list
        start = pattern[: listing.start()] + element
        group = reader.own.get(start)
        at, written = (group.key, group.last) if group else (leaf.key, leaf.last)
        right = None if element in joints else nearest(element, listed)
        hint = f"; did you mean '{right}'?" if right else f"; '{start}' is ignored"
        message = f"'{element}' is not in '{listing[1]}'{hint}"
        yield Finding(at, message, fix=replaced(at, written, right) if right else None, severity=Severity.WARNING)
