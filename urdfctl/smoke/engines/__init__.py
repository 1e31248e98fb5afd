"""The physics engines, all behind one small interface, and the robot as they can load it."""

from __future__ import annotations

from urdfctl.smoke.engines.contacts import TouchingLinks, testable, touching_links
from urdfctl.smoke.engines.engine import (
    CHOICES,
    STEP,
    BasePose,
    Engine,
    EngineSetup,
    RobotRejected,
    engines_named,
    installed,
    open_engine,
)
from urdfctl.smoke.engines.mjcf_check import is_checkable, mjcf_fault
from urdfctl.smoke.engines.urdf import EngineUrdf, engine_urdf, wheel_links

__all__ = [
    "CHOICES",
    "STEP",
    "BasePose",
    "Engine",
    "EngineSetup",
    "EngineUrdf",
    "RobotRejected",
    "TouchingLinks",
    "engine_urdf",
    "engines_named",
    "installed",
    "is_checkable",
    "mjcf_fault",
    "open_engine",
    "testable",
    "touching_links",
    "wheel_links",
]
