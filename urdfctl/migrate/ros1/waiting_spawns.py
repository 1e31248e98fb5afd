"""Robots that are spawned whether or not their description is published: ROS 1 had it on its parameter server."""

from __future__ import annotations

from collections.abc import Iterator, Sequence

from urdfctl.migrate.classic.starting import SPAWN
from urdfctl.migrate.launch.actions import Action, ActionCondition, literal

_TOPIC = literal("-topic")

Conditions = frozenset[ActionCondition]


def waits_for_publisher(actions: Sequence[Action]) -> Iterator[str]:
    """Yield what is left to a person where a robot is spawned by its topic, which is published only sometimes."""
    found = list(_with_conditions(tuple(actions), frozenset()))
    published = [conditions for action, conditions in found if action.description]
    for action, conditions in found:
        if action.kind != "node" or action.name != SPAWN or _TOPIC not in action.words or not published:
            continue
        open_ones = [one - conditions for one in published]
        if all(open_ones) and not _are_alternatives(open_ones):
            yield (
                "the robot is spawned also where the condition of robot_state_publisher is false: it waits for its "
                "description then, which ROS 1 had in a parameter; start the publisher always"
            )
            return


def _with_conditions(actions: tuple[Action, ...], above: Conditions) -> Iterator[tuple[Action, Conditions]]:
    """Each action, also in groups, with the conditions that it starts under."""
    for action in actions:
        own = above | ({action.condition} if action.condition is not None else set())
        yield action, own
        yield from _with_conditions(action.inner, own)


def _are_alternatives(conditions: Sequence[Conditions]) -> bool:
    """Whether one of two publishers starts anyway: one if something is true, and another if it is not."""
    single = {next(iter(one)) for one in conditions if len(one) == 1}
    return any(one._replace(negated=not one.negated) in single for one in single)
