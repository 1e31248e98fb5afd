"""UC602."""

from __future__ import annotations

from collections.abc import Iterator

from urdfctl.rule import Finding, Note, Project, Severity, rule
from urdfctl.rules.launch.common import full_name, is_spawner
from urdfctl.rules.launch_samples import ARM, BROADCASTER, FILE, MANAGER, PUBLISHER, SOUND, launched, spawner
from urdfctl.source.span import Place


@rule(
    "UC602",
    runtime="refuses",
    because="the first spawner has done the work",
    severity=Severity.WARNING,
    authority="ros2_control spawner.py: 'Controller already loaded, skipping load_controller', then 'Failed to configure "
    "controller'; ros_control scripts/spawner: 'Failed to load arm_controller'",
    bad=[launched(PUBLISHER, MANAGER, BROADCASTER, ARM, spawner(f"«arm_controller» {FILE}"))],
    good=[SOUND],
)
def controller_spawned_twice(project: Project) -> Iterator[Finding]:
    """Controller is spawned twice.

    The second spawner finds the controller loaded and active. It cannot configure it again and exits with an error.
    Actions that wait for the spawner to finish may never start.
    """
    seen: dict[str, Place] = {}
    for spawn in project.launch.spawns if project.launch else ():
        if not spawn.sure or spawn.namespace is None or spawn.manager is None or not is_spawner(spawn):
            continue
        for name, at in spawn.names:
            first = seen.setdefault(full_name(name, spawn), at)
            if first is not at and first.start != at.start:
                yield Finding(
                    at,
                    f"controller '{name}' is spawned twice; the second spawner fails",
                    (Note("it is first spawned here", first),),
                )
