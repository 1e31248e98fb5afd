"""Whether the controller managers run and answer, and whether time passes for them."""

from __future__ import annotations

import re
from collections import Counter
from collections.abc import Iterator

from urdfctl.doctor.examination import Ailment, Examination, ailment
from urdfctl.names import enumerated
from urdfctl.rules.running.clock_stands_still import clock_stands_still
from urdfctl.rules.running.description_not_received import description_not_received
from urdfctl.rules.running.hardware_not_loaded import hardware_not_loaded
from urdfctl.rules.running.manager_not_running import manager_not_running
from urdfctl.rules.running.node_runs_twice import node_runs_twice
from urdfctl.rules.running.simulation_time_mixed import simulation_time_mixed

_PLUGIN = re.compile(r"<plugin>\s*([^<\s]+)\s*</plugin>")
_DESCRIPTION = "robot_description"
_MOST = 4


def check_managers(exam: Examination) -> Iterator[Ailment]:
    """Yield the managers that do not run, or that wait for something."""
    for name in exam.managers:
        if exam.manager(name).answers:
            continue
        if name not in exam.recording.nodes:
            elsewhere = [other.name for other in exam.recording.managers.values() if other.answers]
            running = [f"these are running: {enumerated(elsewhere)}"] if elsewhere else []
            yield ailment(manager_not_running, manager=name, notes=running)
        else:
            yield _waiting(exam, name)


def _waiting(exam: Examination, manager: str) -> Ailment:
    """What a manager waits for that runs, and offers no services."""
    readers = [
        topic
        for topic in exam.recording.topics.values()
        if topic.name.endswith(_DESCRIPTION) and any(end.node == manager for end in topic.subscriptions)
    ]
    topic = readers[0] if readers else exam.recording.topics.get(f"/{_DESCRIPTION}")
    name = topic.name if topic else f"/{_DESCRIPTION}"
    publishers = topic.publishers if topic else ()
    if not publishers:
        others = [
            one.name for one in exam.recording.topics.values() if one.name.endswith(_DESCRIPTION) and one.publishers
        ]
        reason = f"nobody publishes it; {enumerated(others)} is published" if others else "nobody publishes it"
        return ailment(description_not_received, manager=manager, topic=name, reason=reason)
    volatile = [end.node for end in publishers if end.durability == "volatile"]
    if len(volatile) == len(publishers):
        reason = f"{volatile[0]} publishes it with durability volatile, and the manager requires transient_local"
        return ailment(description_not_received, manager=manager, topic=name, reason=reason)
    texts = (text for sent in exam.recording.descriptions.values() for text in sent)
    plugins = dict.fromkeys(plugin for text in texts for plugin in _PLUGIN.findall(text))
    quoted = enumerated(f"'{plugin}'" for plugin in plugins) or "of the description"
    said = [f"it says: {text}" for text in exam.recording.said if "Resource" in text][:1]
    return ailment(hardware_not_loaded, manager=manager, plugins=quoted, notes=said)


def check_nodes(exam: Examination) -> Iterator[Ailment]:
    """Yield the nodes of which two have one name."""
    for name, count in Counter(exam.recording.nodes).items():
        if count > 1 and "/_" not in name:
            yield ailment(node_runs_twice, node=name)


def check_clock(exam: Examination) -> Iterator[Ailment]:
    """Yield that the time of a simulation is wanted and missing, or used by some nodes only."""
    recording = exam.recording
    uses = {node: recording.parameters(node).get("use_sim_time") for node in sorted(recording.data["parameters"])}
    simulated = [node for node, value in uses.items() if value is True]
    if simulated and not recording.has_clock:
        yield ailment(clock_stands_still, nodes=enumerated(_few(simulated)))
    elif simulated:
        concerned = {*exam.managers, *(node for each in exam.expected for node in each.nodes)}
        for node in sorted(concerned):
            if uses.get(node) is False:
                yield ailment(simulation_time_mixed, node=node, others=enumerated(_few(simulated)))


def _few(names: list[str]) -> list[str]:
    return names if len(names) <= _MOST else [*names[:_MOST], f"{len(names) - _MOST} more"]
