"""UC863."""

from __future__ import annotations

from urdfctl.fault import Severity, fault
from urdfctl.rules.running.samples import Recorded, example


def _break(recording: Recorded) -> None:
    for one in recording["tf"]["/tf"]:
        one.update(count=50, first_stamp="40.0", last_stamp="42.0")


@fault(
    "UC863",
    severity=Severity.WARNING,
    runtime="misbehaves",
    authority="tf2 buffer_core.cpp: 'TF_OLD_DATA' and 'Lookup would require extrapolation'",
    bad=[example(_break)],
    good=[example()],
)
def transform_is_stale(frames: str, seconds: float) -> str:
    """Transforms are far older than the joint states.

    The publisher has another clock: another computer, or use_sim_time on one side only. Look-ups fail.
    """
    return f"the transforms to {frames} are {seconds:.0f} s behind the joint states: their publisher has another clock"
