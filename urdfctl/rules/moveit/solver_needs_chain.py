"""UC664."""

from __future__ import annotations

from collections.abc import Iterator

from urdfctl.rule import Finding, Note, Project, Severity, rule
from urdfctl.rules.moveit.common import is_of_other_robot, planning
from urdfctl.rules.moveit.samples import KINEMATICS, planned

_OF_CHAINS = frozenset({"KDLKinematicsPlugin", "LMAKinematicsPlugin", "TRAC_IKKinematicsPlugin"})
"""Solvers that refuse a group that is not a chain, by their class names."""
_HAND = '<joint name="elbow"/></group>\n      <group name="both"><joint name="shoulder"/><joint name="finger"/></group>'
_FINGER = """
    <link name="finger">
      <inertial><mass value="1"/><inertia ixx="0.01" ixy="0" ixz="0" iyy="0.01" iyz="0" izz="0.01"/></inertial>
    </link>
    <joint name="finger" type="revolute">
      <parent link="fore"/><child link="finger"/><axis xyz="0 0 1"/>
      <limit lower="-1" upper="1" effort="10" velocity="2"/>
    </joint>
"""


def _files(group: str, solver: str = "kdl_kinematics_plugin/KDLKinematicsPlugin") -> dict[str, str]:
    kinematics = KINEMATICS.replace("    arm:", f"    {group}:").replace(
        "kdl_kinematics_plugin/KDLKinematicsPlugin", solver
    )
    files = planned('<joint name="elbow"/></group>', _HAND, kinematics=kinematics)
    return {
        **files,
        "arm.urdf": _FINGER.replace('<link name="finger">', '<link name="finger_link">').replace(
            '<child link="finger"/>', '<child link="finger_link"/>'
        ),
    }


@rule(
    "UC664",
    severity=Severity.ERROR,
    runtime="drops",
    whole_robot=True,
    in_library=False,
    authority="moveit_kinematics kdl_kinematics_plugin.cpp initialize(): \"Group 'both' is not a chain\"; kinematics_plugin_loader"
    ".cpp: 'Kinematics solver of type ... could not be initialized for group'",
    bad=[
        _files("«both»"),
        _files("«both»", "lma_kinematics_plugin/LMAKinematicsPlugin"),
        _files("«both»", "trac_ik_kinematics_plugin/TRAC_IKKinematicsPlugin"),
    ],
    good=[_files("arm"), _files("both", "bio_ik/BioIKKinematicsPlugin")],
)
def solver_needs_chain(project: Project) -> Iterator[Finding]:
    """Kinematics solver for a group that is not a chain.

    KDL, LMA and TRAC-IK solve chains: each joint of the group must be right below the one before it, with only fixed
    joints between them. For other groups the solver is not loaded. Remove the group from kinematics.yaml, or define it
    as a chain.
    """
    groups, moveit = planning(project), project.moveit
    if groups is None or moveit is None or is_of_other_robot(project):
        return
    for solver in moveit.solvers:
        group = groups.semantic.group(solver.group.text)
        kind = solver.solver.text.rpartition("/")[2] if solver.solver else ""
        if group is None or kind not in _OF_CHAINS or not groups.members(group) or groups.is_chain(group):
            continue
        message = f"{kind} needs a chain, but group '{group.name.text}' is not a chain; remove it from kinematics.yaml"
        yield Finding(solver.group.at, message, (Note("the group is defined here", group.name.at),))
