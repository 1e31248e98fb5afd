"""The motions of a smoke test as a table: what was commanded and what was measured, for each joint and time."""

from __future__ import annotations

import csv
import io
from collections.abc import Iterable

from urdfctl.smoke.results import RobotResult

COLUMNS = ("robot", "controller", "joint", "quantity", "unit", "seconds", "commanded", "measured", "effort_percent")


def curves_as_csv(robots: Iterable[RobotResult]) -> str:
    """Return a line for each sample of each curve, below the names of the columns."""
    text = io.StringIO()
    writer = csv.writer(text, lineterminator="\n")
    writer.writerow(COLUMNS)
    for robot in robots:
        for curve in robot.curves:
            about = (robot.linted.path, curve.controller, curve.joint, curve.quantity, curve.unit)
            efforts = curve.efforts or ("",) * len(curve.seconds)
            for sample in zip(curve.seconds, curve.commanded, curve.measured, efforts, strict=False):
                writer.writerow([*about, *(f"{value:.6g}" if isinstance(value, float) else value for value in sample)])
    return text.getvalue()
