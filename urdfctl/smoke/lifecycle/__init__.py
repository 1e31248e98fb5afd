"""The lifecycle of each controller as its controller manager would lead it, with nothing moving."""

from __future__ import annotations

from urdfctl.smoke.lifecycle.controller_manager import NOT_MOVED, ControllerLifecycle, RobotLifecycle
from urdfctl.smoke.lifecycle.lint_errors import LINT_REPORTS_IT, place_of, stops_hardware
from urdfctl.smoke.lifecycle.possible_distros import lifecycle_of, result_without_motion

__all__ = [
    "LINT_REPORTS_IT",
    "NOT_MOVED",
    "ControllerLifecycle",
    "RobotLifecycle",
    "lifecycle_of",
    "place_of",
    "result_without_motion",
    "stops_hardware",
]
