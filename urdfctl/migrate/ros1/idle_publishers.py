"""Publishers of launch files that set no description: in ROS 2 robot_state_publisher ends without one."""

from __future__ import annotations

from collections.abc import Sequence

from urdfctl.migrate.launch.actions import Action, parsed, plain
from urdfctl.migrate.ros1.moveit_launch import PUBLISHER_FILE


def with_description(actions: Sequence[Action], *, makes_publisher: bool) -> list[Action]:
    """Return actions without the publishers that have no description: the launch file with the description starts one.

    makes_publisher: whether MoveIt makes that one beside the launch file, which includes it then.
    """
    found = []
    makes_publisher = makes_publisher and not any(map(_includes_publisher, actions))
    for action in actions:
        if not _is_idle(action):
            inner = with_description(action.inner, makes_publisher=makes_publisher)
            found += [action._replace(inner=tuple(inner))] if inner or not action.inner else []
        elif makes_publisher:
            found.append(Action("include", value=parsed(f"$(dirname)/{PUBLISHER_FILE}"), condition=action.condition))
    return found


def _includes_publisher(action: Action) -> bool:
    """Whether an action always includes the launch file with the description: a second one would be started twice."""
    is_included = action.kind == "include" and action.condition is None
    return is_included and plain(action.value or ()).endswith(f"/{PUBLISHER_FILE}")


def _is_idle(action: Action) -> bool:
    return action.kind == "node" and action.package == "robot_state_publisher" and not action.description
