"""UC437."""

from __future__ import annotations

import re
from collections.abc import Iterator

from urdfctl.catalog.values import elements, is_known
from urdfctl.rule import Finding, Project, Severity, rule
from urdfctl.rules.common import replaced
from urdfctl.rules.controllers.parameters import known_as
from urdfctl.rules.controllers.readers import Reader, in_each_distro
from urdfctl.suggest import nearest


@rule(
    "UC437",
    severity=Severity.WARNING,
    authority="generate_parameter_library: parameters with __map_ are declared for each element of the list they name",
    options=["--distro=jazzy"],
    bad={
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
    good={
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
)
def parameter_of_no_element(project: Project) -> Iterator[Finding]:
    """A parameter is given for a joint, or the like, that is not in the list that it belongs to.

    Constraints and gains are read for each of the controller's joints. Those of others are ignored without a word.
    """
    return in_each_distro(project, _of_none, newest=True)


def _of_none(reader: Reader) -> Iterator[Finding]:
    told = set()
    for leaf in reader.own.leaves:
        pattern, element = known_as(reader, leaf.name) or ("", None)
        listing = re.search("<([^<>]+)>", pattern)
        if listing is None or element is None or not is_known(element):
            continue
        value = reader.given.get(listing[1])
        there = [part for part in elements(value) if isinstance(part, str)]
        if not there or element in there or not is_known(value) or element in told:
            continue
        told.add(element)
        start = pattern[: listing.start()] + element
        found = reader.own.get(start)
        at, written = (found.key, found.last) if found else (leaf.key, leaf.last)
        right = nearest(element, there)
        end = f"; did you mean '{right}'?" if right else f", and nobody reads '{start}'"
        message = f"'{element}' is not in '{listing[1]}'{end}"
        yield Finding(at, message, fix=replaced(at, written, right) if right else None, severity=Severity.WARNING)
