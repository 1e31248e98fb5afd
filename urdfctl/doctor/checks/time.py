"""Whether time passes for the nodes: whether they use that of a simulation, and whether anything publishes it."""

from __future__ import annotations

from collections.abc import Iterator

from urdfctl.doctor.examination import Ailment, Examination, ailment
from urdfctl.names import enumerated
from urdfctl.rules.running.clock_stands_still import clock_stands_still
from urdfctl.rules.running.simulation_time_mixed import simulation_time_mixed

_MOST = 4


def check_clock(exam: Examination) -> Iterator[Ailment]:
    """Yield that the time of a simulation is wanted and missing, or used by some nodes only."""
    recording = exam.recording
    uses = {node: recording.parameters(node).get("use_sim_time") for node in sorted(recording.data["parameters"])}
    simulated = [node for node, value in uses.items() if value is True]
    if simulated and not (recording.has_clock and recording.clock_advances):
        state = "stands still" if recording.has_clock else "has no publisher"
        yield ailment(clock_stands_still, state=state, nodes=enumerated(_few(simulated)))
    elif simulated:
        concerned = {*exam.managers, *(node for each in exam.expected for node in each.nodes)}
        for node in sorted(concerned):
            if uses.get(node) is False:
                yield ailment(simulation_time_mixed, node=node, others=enumerated(_few(simulated)))


def _few(names: list[str]) -> list[str]:
    return names if len(names) <= _MOST else [*names[:_MOST], f"{len(names) - _MOST} more"]
