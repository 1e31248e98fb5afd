"""The checks of a robot before anything moves: its controllers' lifecycles, and the physics that needs no engine."""

from __future__ import annotations

from urdfctl.smoke.statics.check import StaticCheck, as_not_started, check_statically, with_troubles
from urdfctl.smoke.statics.doubts import with_doubts
from urdfctl.smoke.statics.unknown_parts import with_mock_hardware

__all__ = ["StaticCheck", "as_not_started", "check_statically", "with_doubts", "with_mock_hardware", "with_troubles"]
