"""UC604."""

from __future__ import annotations

from collections.abc import Iterator

from urdfctl.rule import Finding, Note, Project, Severity, rule
from urdfctl.rules.launch.common import is_spawner, publishers_of_states
from urdfctl.rules.launch_samples import ARM, BROADCASTER, MANAGER, MANIFEST, PUBLISHER, SOUND, launched

_NODE = """
      «<node pkg="joint_state_publisher" exec="joint_state_publisher"/>»"""
_NAMES = ("joint_state_broadcaster", "joint_state_controller")
_TOPICS = ("joint_states", "/joint_states")


def _renamed(topic: str) -> dict[str, str]:
    node = f"""
      <node pkg="joint_state_publisher" exec="joint_state_publisher"><remap from="{topic}" to="wanted"/></node>"""
    manifest = MANIFEST.replace("</package>", "<exec_depend>joint_state_publisher</exec_depend></package>")
    return {**launched(PUBLISHER, MANAGER, BROADCASTER, ARM, node), "package.xml": manifest}


@rule(
    "UC604",
    severity=Severity.WARNING,
    runtime="misbehaves",
    authority="joint_state_publisher: publishes joint_states of all joints, zero for joints without input; "
    "robot_state_publisher takes whatever comes on joint_states",
    bad=[
        launched(PUBLISHER, MANAGER, BROADCASTER, ARM, _NODE),
        launched(PUBLISHER, MANAGER, BROADCASTER.replace("state_broadcaster", "state_controller"), ARM, _NODE),
    ],
    good=[SOUND, _renamed("joint_states"), _renamed("/joint_states")],
)
def joint_state_publisher_beside_broadcaster(project: Project) -> Iterator[Finding]:
    """joint_state_publisher and the broadcaster both publish joint states.

    The broadcaster publishes measured positions and joint_state_publisher publishes zeros. The robot in RViz jumps
    between the two, and planners see a wrong state. Use joint_state_publisher only for robots without controllers.
    """
    launch = project.launch
    started = [
        (spawn, at)
        for spawn in (launch.spawns if launch else ())
        if spawn.sure and spawn.active and is_spawner(spawn)
        for name, at in spawn.names
        if name in _NAMES
    ]
    for node in publishers_of_states(launch) if launch else ():
        configured = any(word.text == "source_list" or "joint" in word.text for word in node.parameters) or node.files
        renamed = any(before in _TOPICS for before, _ in node.remaps)
        same = [at for spawn, at in started if spawn.namespace == node.namespace]
        if node.sure and node.complete and not configured and not renamed and same:
            notes = (Note("the broadcaster is spawned here", same[0]),)
            message = "joint_state_publisher and the broadcaster both publish joint_states; start only one of them"
            yield Finding(node.at, message, notes)
