"""The checks of a running system, causes before consequences."""

from __future__ import annotations

from collections.abc import Callable, Iterator

from urdfctl.doctor.checks.controllers import check_controllers, check_hardware
from urdfctl.doctor.checks.descriptions import check_parts, check_values
from urdfctl.doctor.checks.joint_states import check_joint_states
from urdfctl.doctor.checks.managers import (
    check_managers,
    check_nodes,
    check_other_nodes,
    check_publishers,
    check_spawners,
)
from urdfctl.doctor.checks.time import check_clock
from urdfctl.doctor.checks.topics import check_topics
from urdfctl.doctor.checks.transforms import check_transforms
from urdfctl.doctor.examination import Ailment, Examination

Check = Callable[[Examination], Iterator[Ailment]]

CHECKS: tuple[Check, ...] = (
    check_managers,
    check_nodes,
    check_clock,
    check_parts,
    check_hardware,
    check_spawners,
    check_controllers,
    check_values,
    check_publishers,
    check_joint_states,
    check_topics,
    check_transforms,
    check_other_nodes,
)
"""In the order of the answers: what is found first explains the rest."""

__all__ = ["CHECKS"]
