"""Where launch files of ROS 2 set the simulation's time: before the nodes that need it."""

from __future__ import annotations

from collections.abc import Sequence

from urdfctl.migrate.launch.actions import Action, is_literal

_STARTING = ("node", "include", "group", "process")


def time_first(actions: Sequence[Action]) -> list[Action]:
    """Return the actions of a launch file with use_sim_time before the first that starts something.

    A parameter of ROS 1 is global wherever it is set; SetParameter is only for the nodes after it (launch_ros
    actions/set_parameter.py). An argument that it reads is declared before it, unless its default reads others.
    """
    found = [one for one in actions if one.kind == "set_parameter" and one.name == "use_sim_time" and not one.condition]
    started = next((index for index, one in enumerate(actions) if one.kind in _STARTING), len(actions))
    if not found or found[-1] in actions[:started]:
        return list(actions)
    read = {part.text for part in found[-1].value or () if part.kind == "arg"}
    declared = [one for one in actions if one.kind in ("argument", "let") and one.name in read]
    if not all(is_literal(one.value or ()) and not one.condition for one in declared):
        return list(actions)
    return [*declared, found[-1], *(one for one in actions if one not in (*found, *declared))]
