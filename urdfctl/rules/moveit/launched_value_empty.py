"""UC656."""

from __future__ import annotations

from collections.abc import Iterator

from urdfctl.catalog.distros import ROS2
from urdfctl.rule import Finding, Project, Severity, rule
from urdfctl.rules.moveit.samples import MOVEIT, planned


@rule(
    "UC656",
    severity=Severity.ERROR,
    runtime="refuses",
    distros=ROS2,
    options=("--distro=humble",),
    authority="launch_ros normalize_parameters.py: an empty list becomes an empty tuple, \"Expected 'value' to be one of ..., but "
    "got '()' of type '<class 'tuple'>'\" (moveit2#2837); None: 'Unexpected type for parameter value None'",
    bad=[planned(moveit_controllers=MOVEIT.replace("    joints: [shoulder, elbow]", "    «joints»: []"))],
    good=[planned(moveit_controllers=MOVEIT)],
)
def launched_value_empty(project: Project) -> Iterator[Finding]:
    """Empty list or missing value in a file of MoveIt.

    MoveIt's launch files read the YAML files and pass their content to the nodes. Launch accepts neither an empty list
    nor a key without a value, and stops with an error. Delete the key, or give it a value.
    """
    moveit = project.moveit
    is_certain = moveit is not None and moveit.files is not None and moveit.files.sure
    for name, at in moveit.empty if moveit else ():
        message = f"'{name}' is empty, and launch rejects an empty list or value; remove it, or give it a value"
        yield Finding(at, message, severity=None if is_certain else Severity.WARNING)
