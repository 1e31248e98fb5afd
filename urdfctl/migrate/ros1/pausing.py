"""A simulation that starts paused: a spawner of ROS 2 fails in it, where that of ROS 1 waited for the user."""

from __future__ import annotations

from collections.abc import Sequence

from urdfctl.migrate.launch.actions import Action, Text, all_actions, is_literal, literal, plain

DECIDED = "the simulation is not paused at the start: controllers are only activated while it runs"
_SETTING = "pause"


def must_run(actions: Sequence[Action]) -> bool:
    """Return whether a launch file starts controllers."""
    return any(action.name == "spawner" for action in all_actions(tuple(actions)))


def running(actions: Sequence[Action]) -> list[Action]:
    """Return the actions with a simulation that is not paused, unless an argument is given that says so."""
    pauses = [text for each in all_actions(tuple(actions)) for name, text in each.pairs if _is_pause(each, name)]
    arguments = {text[0].text for text in pauses if len(text) == 1 and text[0].kind == "arg"}
    return [_running(action, arguments) for action in actions]


def _running(action: Action, arguments: set[str]) -> Action:
    if action.kind == "argument" and action.name in arguments and _is_true(action.value):
        return action._replace(value=literal("false"))
    pairs = tuple(pair for pair in action.pairs if not (_is_pause(action, pair[0]) and _is_true(pair[1])))
    return action._replace(pairs=pairs, inner=tuple(_running(each, arguments) for each in action.inner))


def _is_pause(action: Action, name: str) -> bool:
    return action.kind == "include" and name == _SETTING


def _is_true(text: Text | None) -> bool:
    return text is not None and is_literal(text) and plain(text).strip().lower() in {"true", "1"}
