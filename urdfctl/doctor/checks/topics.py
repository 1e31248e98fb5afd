"""The topics between controllers and whoever commands them, and the tree of transforms."""

from __future__ import annotations

from collections.abc import Iterator

from urdfctl.doctor.examination import Ailment, Examination, ailment
from urdfctl.doctor.recording import RecordedTopic
from urdfctl.names import enumerated, nearest
from urdfctl.rules.running.command_topic_not_read import command_topic_not_read
from urdfctl.rules.running.topic_qos_incompatible import topic_qos_incompatible
from urdfctl.rules.running.topic_types_differ import topic_types_differ
from urdfctl.rules.running.transform_has_two_parents import transform_has_two_parents

_WEAKER = {"durability": ("volatile", "transient_local"), "reliability": ("best_effort", "reliable")}
"""What a publisher offers, and a subscription may require instead."""


def check_topics(exam: Examination) -> Iterator[Ailment]:
    """Yield the topics on which messages do not arrive."""
    topics = exam.recording.topics
    own = {*exam.managers, *(one.node for one in exam.controllers)}
    unserved = [one for one in topics.values() if not one.publishers and _reader(one, own)]
    for topic in topics.values():
        reader = _reader(topic, own)
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
    kinds = {end.type for end in topic.publishers}
    if any(end.node in own for end in topic.publishers):
        return
    alike = [one.name for one in unserved if kinds & {end.type for end in one.subscriptions}]
    near = nearest(topic.name, alike) or (alike[0] if len(alike) == 1 and _ends_alike(topic.name, alike[0]) else None)
    if near:
        yield ailment(command_topic_not_read, topic=topic.name, node=topic.publishers[0].node, near=near)


def _ends_alike(name: str, other: str) -> bool:
    return name.rpartition("/")[2] == other.rpartition("/")[2]


def check_transforms(exam: Examination) -> Iterator[Ailment]:
    """Yield the frames with two parents."""
    parents: dict[str, list[str]] = {}
    for _, parent, child in exam.recording.transforms:
        if parent not in parents.setdefault(child, []):
            parents[child].append(parent)
    for child, found in parents.items():
        if len(found) > 1:
            yield ailment(transform_has_two_parents, frame=child, parents=enumerated(f"'{one}'" for one in found))
