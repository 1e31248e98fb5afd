"""The tree of transforms: one parent and one publisher for each frame, at the time of the joint states."""

from __future__ import annotations

from collections.abc import Iterator

from urdfctl.doctor.examination import Ailment, Examination, ailment
from urdfctl.doctor.recording import RecordedTransform
from urdfctl.names import enumerated
from urdfctl.rules.running.transform_has_two_parents import transform_has_two_parents
from urdfctl.rules.running.transform_is_stale import transform_is_stale
from urdfctl.rules.running.transform_sent_twice import transform_sent_twice

_STATIC = "tf_static"
_OLDEST = 10.0
"""Seconds that transforms may be behind the joint states: a publisher may pause."""
_MOST = 3


def check_transforms(exam: Examination) -> Iterator[Ailment]:
    """Yield the frames with two parents or two publishers, and transforms of another time."""
    parents: dict[str, list[str]] = {}
    for one in exam.recording.transforms:
        if one.parent not in parents.setdefault(one.child, []):
            parents[one.child].append(one.parent)
    for child, found in parents.items():
        if len(found) > 1:
            yield ailment(transform_has_two_parents, frame=child, parents=enumerated(f"'{one}'" for one in found))
    moving = [one for one in exam.recording.transforms if not one.topic.endswith(_STATIC)]
    yield from _of_publishers(exam, moving)
    yield from _of_time(exam, moving)


def _of_publishers(exam: Examination, moving: list[RecordedTransform]) -> Iterator[Ailment]:
    doubled = [one for one in moving if one.writers > 1]
    for one in doubled[:1]:
        topic = exam.recording.topics.get(one.topic)
        nodes = enumerated(sorted({end.node for end in topic.publishers})) if topic else "two nodes"
        notes = [f"so is that to '{other.child}'" for other in doubled[1:]]
        yield ailment(transform_sent_twice, frame=one.child, parent=one.parent, nodes=nodes, notes=notes)


def _of_time(exam: Examination, moving: list[RecordedTransform]) -> Iterator[Ailment]:
    """Transforms of a publisher whose clock is behind that of the joint states."""
    now = max((stamp for one in exam.recording.joint_states.values() for stamp in one.stamps), default=0.0)
    old = [one for one in moving if one.received > 1 and one.last is not None and now - one.last > _OLDEST]
    if old and now:
        frames = [f"'{one.child}'" for one in old[:_MOST]]
        more = [f"{len(old) - _MOST} more"] if len(old) > _MOST else []
        behind = now - max(one.last or 0.0 for one in old)
        yield ailment(transform_is_stale, frames=enumerated([*frames, *more]), seconds=behind)
