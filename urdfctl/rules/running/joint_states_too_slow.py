"""UC845."""

from __future__ import annotations

from urdfctl.fault import Severity, fault
from urdfctl.rules.running.samples import Recorded, example


def _break(recording: Recorded) -> None:
    recording["joint_states"]["/joint_states"]["rate_hz"] = 20.0


@fault(
    "UC845",
    severity=Severity.WARNING,
    runtime="misbehaves",
    authority="controller_manager.cpp: the loop runs at update_rate; the broadcaster publishes in each of its cycles",
    bad=[example(_break)],
    good=[example()],
)
def joint_states_too_slow(topic: str, rate: float, wanted: float) -> str:
    """Joint states come far more slowly than the manager should run.

    The processor is too busy, or the hardware blocks in read() or write().
    """
    return f"{topic} comes at {rate:.3g} Hz, but update_rate is {wanted:g} Hz"
