"""The stability of PID loops that command velocities: the hardware follows them, so that no mass matters."""

from __future__ import annotations

from collections.abc import Iterator, Sequence

from urdfctl.rules.smoke.loop_unstable import loop_unstable
from urdfctl.rules.smoke.loop_without_gain import loop_without_gain
from urdfctl.smoke.matrices import eigenvalues
from urdfctl.smoke.results import Trouble, trouble_of
from urdfctl.smoke.robot import Mechanism
from urdfctl.smoke.statics.loops.gain_faults import gain_fault
from urdfctl.smoke.tasks import ControllerTask, MotionFamily, PidGains

_HOLDING = (MotionFamily.TRAJECTORY, MotionFamily.POSITION_PID)
MOST_GROWTH = 1.0003
"""The spectral radius up to which a loop counts as stable: slower growth is not visible."""


def velocity_loop_troubles(mechanism: Mechanism, tasks: Sequence[ControllerTask], rate: float) -> Iterator[Trouble]:
    """Yield the loops from positions to velocities that never come to rest, or command nothing."""
    for task in tasks:
        if task.family not in _HOLDING or task.interface != "velocity" or task.through:
            continue
        for name, gain in zip(task.joints, task.gains, strict=False):
            hinge = mechanism.hinge(name)
            if hinge is None:
                continue
            place = f"gain:{task.controller}/{gain.prefix}"
            if not gain.p and not gain.i and not gain.feed:
                yield trouble_of(loop_without_gain, f"{place}p", task.controller, (), joint=name)
                continue
            fault = gain_fault(hinge, gain, None, rate, lambda tried: growth_of(tried, 1 / rate) <= MOST_GROWTH)
            if fault and (gain.p or gain.i):
                fields = {"rate": rate, "why": fault.why}
                yield trouble_of(loop_unstable, f"{place}{fault.gain}", task.controller, (), **fields)


def growth_of(gains: PidGains, period: float) -> float:
    """Return by which factor an error grows in each period: the velocity is p e + i ∫e - d v of the last period."""
    p, i, d = gains.p, gains.i, gains.d
    matrix = [[1 - period * p, period * d, -period * i], [p, -d, i], [period, 0.0, 1.0]]
    if not i:
        matrix = [row[:2] for row in matrix[:2]]
    return max(map(abs, eigenvalues(matrix)))
