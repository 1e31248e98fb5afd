"""Texts that say with which arguments people start a launch file."""

from __future__ import annotations

from systems.render.plan import Plan, file_name, is_typed
from systems.render.workspace import Workspace

_PATHS = {"readme": "{package}/README.md", "document": "docs/start.md", "script": "{package}/scripts/start.sh"}


def add_documents(workspace: Workspace, plan: Plan) -> None:
    """Add the text that starts the system, with the arguments that it needs, if the switches say so."""
    kind = workspace.idioms["told"] if workspace.idioms["reduced"] == "nothing" else "readme"
    if kind == "nowhere":
        return
    start = plan.starts[-1]
    needed = (name for name, default in start.declared if default is None and is_typed(plan.right.get(name, ())))
    given = [f"{name}:={plan.right[name][0]}" for name in needed]
    program = "roslaunch" if plan.system.generation == 1 else "ros2 launch"
    command = " ".join((program, start.package, file_name(plan, start), *given))
    text = f"#!/bin/sh\n{command}\n" if kind == "script" else f"# Start\n\nSee `{start.stem}`:\n\n```\n{command}\n```\n"
    workspace.files[_PATHS[kind].format(package=start.package)] = text
