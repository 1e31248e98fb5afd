"""The topics between controllers and whoever commands them."""

from __future__ import annotations

from collections.abc import Iterator

from urdfctl.doctor.examination import Ailment, Examination, ailment
from urdfctl.doctor.recording import RecordedTopic
from urdfctl.names import enumerated, nearest
from urdfctl.rules.running.command_topic_not_read import command_topic_not_read
from urdfctl.rules.running.topic_qos_incompatible import topic_qos_incompatible
from urdfctl.rules.running.topic_types_differ import topic_types_differ

_SIBLINGS = {
    "geometry_msgs/msg/Twist": "geometry_msgs/msg/TwistStamped",
    "geometry_msgs/msg/TwistStamped": "geometry_msgs/msg/Twist",
}
"""Types that are taken for each other: a command is published as one, and read as the other."""
_WEAKER = {"durability": ("volatile", "transient_local"), "reliability": ("best_effort", "reliable")}
"""What a publisher offers, and a subscription may require instead."""


def check_topics(exam: Examination) -> Iterator[Ailment]:
    """Yield the topics on which messages do not arrive."""
    topics = exam.recording.topics
    own = {*exam.managers, *(one.node for one in exam.controllers)}
    readers = set(own)
    if exam.recording.is_of_ros1:  # the node of the hardware reads the topics of all controllers
        below = tuple(f"{node}/" for node in own)
        readers |= {end.node for one in topics.values() if one.name.startswith(below) for end in one.subscriptions}
    unserved = [one for one in topics.values() if not one.publishers and _reader(one, readers)]
    for topic in topics.values():
        reader = _reader(topic, readers)
        if reader is not None and topic.publishers:
            yield from _mismatches(topic, reader)
        elif topic.publishers and not topic.subscriptions:
            yield from _unread(topic, unserved, own)


def _reader(topic: RecordedTopic, own: set[str]) -> str | None:
    """The controller or manager that reads a topic."""
    return next((end.node for end in topic.subscriptions if end.node in own), None)


def _mismatches(topic: RecordedTopic, reader: str) -> Iterator[Ailment]:
    wanted = next(end for end in topic.subscriptions if end.node == reader)
    fitting = [end for end in topic.publishers if end.type == wanted.type]
    for end in topic.publishers:
        if end.type != wanted.type and not fitting:
            yield ailment(topic_types_differ, topic=topic.name, published=end.type, read=wanted.type)
    for end in fitting:
        for quality, (weak, strong) in _WEAKER.items():
            if (getattr(end, quality), getattr(wanted, quality)) == (weak, strong):
                said = f"with {quality} {weak}, which the reader does not accept"
                yield ailment(topic_qos_incompatible, topic=topic.name, publisher=end.node, reader=reader, quality=said)


def _unread(topic: RecordedTopic, unserved: list[RecordedTopic], own: set[str]) -> Iterator[Ailment]:
    kinds = {kind for end in topic.publishers for kind in (end.type, _SIBLINGS.get(end.type, end.type))}
    if any(end.node in own for end in topic.publishers):
        return
    alike = [one.name for one in unserved if kinds & {end.type for end in one.subscriptions}]
    near = nearest(topic.name, alike) or (alike[0] if len(alike) == 1 and _ends_alike(topic.name, alike[0]) else None)
    if near:
        read, sent = _types_read(unserved, near), topic.publishers[0].type
        other = f" (as {enumerated(sorted(read), 'or')}, not {sent})" if sent not in read else ""
        yield ailment(command_topic_not_read, topic=topic.name, node=topic.publishers[0].node, near=near + other)


def _types_read(topics: list[RecordedTopic], name: str) -> set[str]:
    return {end.type for one in topics if one.name == name for end in one.subscriptions}


def _ends_alike(name: str, other: str) -> bool:
    return name.rpartition("/")[2] == other.rpartition("/")[2]
