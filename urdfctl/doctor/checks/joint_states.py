"""The joint states: whether they are published, whole, once, in numbers, and read."""

from __future__ import annotations

from collections.abc import Iterator

from urdfctl.doctor.examination import Ailment, Examination, ailment
from urdfctl.doctor.expectation import Expectation
from urdfctl.doctor.recording import JointStates, RecordedTopic
from urdfctl.names import enumerated
from urdfctl.rules.running.joint_states_incomplete import joint_states_incomplete
from urdfctl.rules.running.joint_states_not_finite import joint_states_not_finite
from urdfctl.rules.running.joint_states_not_read import joint_states_not_read
from urdfctl.rules.running.joint_states_stand_still import joint_states_stand_still
from urdfctl.rules.running.joint_states_too_slow import joint_states_too_slow
from urdfctl.rules.running.no_joint_states import no_joint_states
from urdfctl.rules.running.two_joint_state_publishers import two_joint_state_publishers

_STATES = "sensor_msgs/msg/JointState"
_SLOWEST = 0.5
"""The share of update_rate at which joint states are too slow."""
_PUBLISHER = "robot_state_publisher"


def check_joint_states(exam: Examination) -> Iterator[Ailment]:
    """Yield what is wrong with the joint states of the robots, if their managers answer."""
    topics = [topic for topic in exam.recording.topics.values() if _is_of_states(topic)]
    published = [topic for topic in topics if topic.publishers]
    for expected in exam.expected:
        if expected.joints and all(_may_publish(exam, name) for name in expected.managers):
            yield from _of_robot(exam, expected, published)
    for topic in published:
        writers = sorted({end.node for end in topic.publishers})
        sent = exam.recording.joint_states.get(topic.name)
        if len(writers) > 1 and (sent is None or (sent.writers != 1 and _overlap(sent))):
            yield ailment(two_joint_state_publishers, topic=topic.name, nodes=enumerated(writers))
    for topic in topics:
        readers = [end.node for end in topic.subscriptions if end.node.endswith(_PUBLISHER)]
        if readers and not topic.publishers and published:
            names = enumerated(other.name for other in published)
            yield ailment(joint_states_not_read, node=readers[0], reads=topic.name, published=names)


def _may_publish(exam: Examination, manager: str) -> bool:
    return exam.manager(manager).answers or exam.recording.is_of_ros1


def _overlap(sent: JointStates) -> bool:
    """Whether two publishers of a topic may send the state of one joint; each may send those of its own."""
    every = [name for names in sent.lists for name in names]
    return len(sent.lists) == 1 or len(set(every)) < len(every)


def _is_of_states(topic: RecordedTopic) -> bool:
    return any(end.type == _STATES for end in (*topic.publishers, *topic.subscriptions))


def _of_robot(exam: Examination, expected: Expectation, published: list[RecordedTopic]) -> Iterator[Ailment]:
    home = expected.managers[0].rpartition("/")[0] if expected.managers else expected.namespace
    near = [topic for topic in published if topic.name.startswith(f"{home}/")]
    if not near:
        kind = "joint_state_controller" if exam.recording.is_of_ros1 else "joint_state_broadcaster"
        yield ailment(no_joint_states, topic=f"{home}/joint_states", broadcaster=kind)
        return
    received = [one for topic in near if (one := exam.recording.joint_states.get(topic.name)) and one.received]
    if not received:
        return
    names = frozenset(name for one in received for name in one.names)
    lacking = [f"'{joint}'" for joint in expected.joints if joint not in names]
    if lacking:
        yield ailment(joint_states_incomplete, topic=received[0].topic, joints=enumerated(lacking))
    for one in received:
        infinite = [f"'{joint}'" for joint, value in one.numbers.items() if value is None and joint in expected.joints]
        if infinite:
            yield ailment(joint_states_not_finite, topic=one.topic, joints=enumerated(infinite))
        if len(one.stamps) > 1 and len(set(one.stamps)) == 1 and one.received > 1:
            yield ailment(joint_states_stand_still, topic=one.topic, stamp=f"{one.stamps[0]:.3f} s")
        if not exam.recording.has_clock:
            yield from _of_rate(exam, expected, one)


def _of_rate(exam: Examination, expected: Expectation, received: JointStates) -> Iterator[Ailment]:
    """One topic that comes more slowly than its manager, or its publisher if it has a rate of its own, should run."""
    settings = expected.settings.get(expected.managers[0], {}) if expected.managers else {}
    senders = [end.node for end in exam.recording.topics[received.topic].publishers]
    given = [settings.get("update_rate"), *(exam.recording.parameters(node).get("update_rate") for node in senders)]
    rates = [float(rate) for rate in given if isinstance(rate, int | float) and rate > 0]
    if settings.get("update_rate") and rates and received.writers == 1 and 0 < received.rate < _SLOWEST * min(rates):
        yield ailment(joint_states_too_slow, topic=received.topic, rate=received.rate, wanted=min(rates))
