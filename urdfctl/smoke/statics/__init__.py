"""The checks of a robot before anything moves: its controllers' lifecycles, and the physics that needs no engine."""

from __future__ import annotations

from urdfctl.smoke.statics.check import StaticCheck, as_not_started, check_statically, with_troubles
from urdfctl.smoke.statics.ground import carried_by

__all__ = ["StaticCheck", "as_not_started", "carried_by", "check_statically", "with_troubles"]
