"""UC603."""

from __future__ import annotations

from collections.abc import Collection, Iterator, Sequence

from urdfctl.model.controllers import Controller
from urdfctl.model.launch import Launch
from urdfctl.names import nearest
from urdfctl.rule import Finding, Note, Project, Severity, rule
from urdfctl.rules.common import in_words
from urdfctl.rules.launch.common import is_sure, spawners
from urdfctl.rules.launch.steps import SPAWNS_CONTROLLERS, started_apart
from urdfctl.rules.launch_samples import BROADCASTER, CONTROLLERS, MANAGER, PUBLISHER, SOUND, launched


@rule(
    "UC603",
    severity=Severity.INFO,
    runtime="works",
    authority="ros2_control controller_manager.cpp load_controller(): a controller is loaded when a spawner asks for it; "
    "likewise ros_control's controller_manager",
    bad=[
        launched(
            PUBLISHER,
            MANAGER,
            BROADCASTER,
            controllers=CONTROLLERS.replace("    arm_controller:", "    «arm_controller»:", 1),
        ),
    ],
    good=[SOUND],
)
def controller_not_spawned(project: Project) -> Iterator[Finding]:
    """Configured controller that the launch file does not spawn.

    The controller manager loads only the controllers that a spawner or `ros2 control load_controller` names. This is
    intended if another launch file spawns the controller, or if the file lists alternatives. It is a warning if the
    controllers that are spawned command nothing, and no other text of the workspace says that it spawns the others: then no
    joint moves.
    """
    launch, controllers = project.launch, project.controllers
    if launch is None or controllers is None or not launch.spawns or not is_sure(launch):
        return
    spawned = {name.rpartition("/")[2] for spawn in spawners(launch) for name, _ in spawn.names}
    declared = [controller.name for controller in controllers.controllers if controller.declared_at]
    spawned |= {
        nearest(name, declared) or name for name in spawned if name not in declared
    }  # UC601 reports misspellings
    left = [c for c in controllers.controllers if c.declared_at and c.type and c.name not in spawned]
    if not any(_publishes_states(project, c) for c in controllers.controllers if c.name in spawned):
        left = [c for c in left if not _publishes_states(project, c)]  # UC465 reports it
    if left and left[0].declared_at:
        names = in_words(dict.fromkeys(controller.name for controller in left))
        several = len({controller.name for controller in left}) > 1
        subject = f"controllers {names} are" if several else f"controller {names} is"
        note = Note("controllers are spawned here", launch.spawns[0].at)
        message = f"{subject} configured but not spawned by the launch file"
        severity = None
        if _nothing_moves(project, launch, spawned, left):
            message += ", which spawns only broadcasters: no joint moves"
            severity = Severity.WARNING
        yield Finding(left[0].declared_at, message, (note,), severity=severity)


def _nothing_moves(project: Project, launch: Launch, spawned: Collection[str], left: Sequence[Controller]) -> bool:
    """Whether none of the spawned controllers commands anything, but one that is left would, and nothing else spawns it."""
    controllers = project.controllers.controllers if project.controllers else ()
    started = [controller for controller in controllers if controller.name in spawned]
    if len({controller.name for controller in started}) < len(spawned) or launch.elsewhere:
        return False
    if any(_commands(project, controller) is not False for controller in started):
        return False
    if not any(_commands(project, controller) for controller in left):
        return False
    return not project.may_mention(SPAWNS_CONTROLLERS, started_apart(launch))


def _commands(project: Project, controller: Controller) -> bool | None:
    """Return whether a type of controllers claims command interfaces; None if that is not known."""
    kind = controller.type.text if controller.type else ""
    entries = [project.catalog.controller(kind, distro) for distro in project.distros]
    claims = [entry.claims for entry in entries if entry is not None]
    if not claims or None in claims:
        return None
    return any(each is not None and bool(each.command) for each in claims)


def _publishes_states(project: Project, controller: Controller) -> bool:
    kind = controller.type.text if controller.type else ""
    entries = (project.catalog.controller(kind, distro) for distro in project.distros)
    return any(entry is not None and entry.publishes_joint_states for entry in entries)
