"""Measure a robot for the generators in a worker, with the meshes of its wheels as the smoke test reads them."""

from __future__ import annotations

from typing import Any

from urdfctl.generate.robot.job import measured_facts
from urdfctl.lint.job import Work


def measure_work(work: Work) -> dict[str, Any]:
    """Measure a robot in a worker."""
    from urdfctl.smoke.robot import corners_of

    return measured_facts(work, corners_of)
