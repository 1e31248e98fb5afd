"""Whether the controller managers and the nodes beside them run and answer."""

from __future__ import annotations

import re
from collections import Counter
from collections.abc import Iterator

from urdfctl.doctor.examination import Ailment, Examination, ailment
from urdfctl.names import enumerated
from urdfctl.rules.running.description_not_received import description_not_received
from urdfctl.rules.running.hardware_not_loaded import hardware_not_loaded
from urdfctl.rules.running.manager_not_running import manager_not_running
from urdfctl.rules.running.node_runs_twice import node_runs_twice
from urdfctl.rules.running.spawner_waits import spawner_waits
from urdfctl.rules.running.state_publisher_not_running import state_publisher_not_running

_PLUGIN = re.compile(r"<plugin>\s*([^<\s]+)\s*</plugin>")
_DESCRIPTION = "robot_description"
_ASKED = "/list_controllers"
_SPAWNER = re.compile(r"/spawner_\w|/spawner$")


def check_managers(exam: Examination) -> Iterator[Ailment]:
    """Yield the managers that do not run, or that wait for something."""
    for name in exam.managers:
        if exam.manager(name).answers:
            continue
        if exam.recording.is_of_ros1:
            if f"{name}{_ASKED}" not in exam.recording.services:
                yield ailment(manager_not_running, manager=name)
        elif name not in exam.recording.nodes:
            elsewhere = [other.name for other in exam.recording.managers.values() if other.answers]
            others = [other for other in elsewhere if other not in exam.managers]
            instead = f"; {enumerated(others)} runs instead" if others else ""
            yield ailment(manager_not_running, manager=name, instead=instead)
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
    """Yield the nodes of the robot's control of which two have one name."""
    yield from _doubled(exam, _of_control(exam), is_own=True)


def check_other_nodes(exam: Examination) -> Iterator[Ailment]:
    """Yield the other nodes of which two have one name."""
    yield from _doubled(exam, _of_control(exam), is_own=False)


def _of_control(exam: Examination) -> frozenset[str]:
    publishers = (node for each in exam.expected for node in each.state_publishers)
    return frozenset((*exam.managers, *publishers, *(one.node for one in exam.controllers)))


def _doubled(exam: Examination, own: frozenset[str], *, is_own: bool) -> Iterator[Ailment]:
    for name, count in Counter(exam.recording.nodes).items():
        if count > 1 and "/_" not in name and (name in own) == is_own:
            yield ailment(node_runs_twice, node=name)


def check_publishers(exam: Examination) -> Iterator[Ailment]:
    """Yield the nodes that should publish transforms, and do not run."""
    running = exam.recording.nodes
    for each in exam.expected:
        for node in each.state_publishers:
            others = [one for one in running if one.rpartition("/")[2] == node.rpartition("/")[2]]
            if node not in running and not others:
                yield ailment(state_publisher_not_running, node=node)


def check_spawners(exam: Examination) -> Iterator[Ailment]:
    """Yield what spawners wait for: a client alone makes the name of a service appear."""
    spawners = [node for node in exam.recording.nodes if _SPAWNER.search(node)]
    answering = [one.name for one in exam.recording.managers.values() if one.answers]
    asked = {name.removesuffix(_ASKED) for name in exam.recording.services if name.endswith(_ASKED)}
    for manager in sorted(asked - {*answering, *exam.recording.nodes, *exam.managers}) if spawners else ():
        running = f"; {enumerated(answering)} does" if answering else ""
        yield ailment(spawner_waits, spawner=spawners[0], manager=manager, running=running)
