"""The order of a report: causes first."""

from __future__ import annotations

from collections.abc import Iterable

from urdfctl.diagnostic import Diagnostic, Severity
from urdfctl.rules.smoke.angles_in_degrees import angles_in_degrees
from urdfctl.rules.smoke.controller_not_activated import controller_not_activated
from urdfctl.rules.smoke.controller_not_configured import controller_not_configured
from urdfctl.rules.smoke.controller_not_loaded import controller_not_loaded
from urdfctl.rules.smoke.does_not_drive_forward import does_not_drive_forward
from urdfctl.rules.smoke.does_not_turn_left import does_not_turn_left
from urdfctl.rules.smoke.engines_disagree import engines_disagree
from urdfctl.rules.smoke.hardware_not_started import hardware_not_started
from urdfctl.rules.smoke.inertia_too_large import inertia_too_large
from urdfctl.rules.smoke.inertia_too_small import inertia_too_small
from urdfctl.rules.smoke.inertia_unusable import inertia_unusable
from urdfctl.rules.smoke.joint_does_not_follow import joint_does_not_follow
from urdfctl.rules.smoke.joint_leaves_limits import joint_leaves_limits
from urdfctl.rules.smoke.joint_moves_wrong_way import joint_moves_wrong_way
from urdfctl.rules.smoke.joint_oscillates import joint_oscillates
from urdfctl.rules.smoke.joint_too_fast import joint_too_fast
from urdfctl.rules.smoke.joints_oscillate_together import joints_oscillate_together
from urdfctl.rules.smoke.length_in_millimetres import length_in_millimetres
from urdfctl.rules.smoke.limits_in_degrees import limits_in_degrees
from urdfctl.rules.smoke.mass_in_grams import mass_in_grams
from urdfctl.rules.smoke.mass_outside_of_link import mass_outside_of_link
from urdfctl.rules.smoke.mimic_not_kept import mimic_not_kept
from urdfctl.rules.smoke.robot_not_spawned import robot_not_spawned
from urdfctl.rules.smoke.robot_tips_over import robot_tips_over
from urdfctl.rules.smoke.simulation_explodes import simulation_explodes
from urdfctl.rules.smoke.task_not_performed import task_not_performed
from urdfctl.rules.smoke.travel_in_millimetres import travel_in_millimetres
from urdfctl.rules.smoke.wheels_slip import wheels_slip

_BEFORE_MOTION = frozenset(
    fault.code
    for fault in (
        robot_not_spawned,
        hardware_not_started,
        controller_not_loaded,
        controller_not_configured,
        controller_not_activated,
    )
)
"""What keeps controllers from becoming active."""
_OF_THE_MODEL = frozenset(
    fault.code
    for fault in (
        angles_in_degrees,
        inertia_too_large,
        inertia_too_small,
        inertia_unusable,
        length_in_millimetres,
        limits_in_degrees,
        mass_in_grams,
        mass_outside_of_link,
        travel_in_millimetres,
    )
)
"""Numbers of the description that cannot be meant: loads, efforts and motions follow from them."""
_MEASURED = frozenset(
    fault.code
    for fault in (
        does_not_drive_forward,
        does_not_turn_left,
        engines_disagree,
        joint_does_not_follow,
        joint_leaves_limits,
        joint_moves_wrong_way,
        joint_oscillates,
        joint_too_fast,
        joints_oscillate_together,
        mimic_not_kept,
        robot_tips_over,
        simulation_explodes,
        task_not_performed,
        wheels_slip,
    )
)
"""What an engine sees: the consequence of what is found without one."""


def causes_first(findings: Iterable[Diagnostic]) -> list[Diagnostic]:
    """Return findings in the order in which to mend them.

    First what keeps controllers from starting, and numbers of the model that cannot be meant; then by severity, what
    was found without an engine before what one measured; then by file and line.
    """
    return sorted(findings, key=_rank)


def _rank(finding: Diagnostic) -> tuple[bool, int, bool, object]:
    stops = finding.code in _BEFORE_MOTION and finding.severity is Severity.ERROR
    leads = stops or finding.code in _OF_THE_MODEL
    return not leads, -finding.severity.weight, finding.code in _MEASURED, finding.order
