"""UC648."""

from __future__ import annotations

from collections.abc import Iterator

from urdfctl.control.hardware.simulator_plugins import loaded_plugins
from urdfctl.model.launch import Launch, Node, Spawn, joined
from urdfctl.rule import Finding, Note, Project, Severity, rule
from urdfctl.rules.common import doubt_of, whole_robot_in
from urdfctl.rules.launch.common import publishers_of_states, state_publishers
from urdfctl.rules.launch_samples import CONTROLLERS, FILE, launched, spawner
from urdfctl.source.opaque import UNKNOWN
from urdfctl.source.span import Place

_TOPIC = "joint_states"
_PUBLISHER = """
      «<node pkg="robot_state_publisher" exec="robot_state_publisher">»
        <param name="robot_description" value="$(command 'xacro $(find-pkg-share arm)/arm.urdf')" type="str"/>%s
      </node>"""
_MANAGER = """
      <node pkg="controller_manager" exec="ros2_control_node" namespace="left">
        <param from="$(find-pkg-share arm)/controllers.yaml"/>
        <remap from="~/robot_description" to="/robot_description"/>
        <remap from="robot_description" to="/robot_description"/>
      </node>"""
_LEFT = "left:\n" + "\n".join(f"  {line[4:]}" for line in CONTROLLERS.strip("\n").splitlines()) + "\n"
_SPAWNER = spawner("joint_state_broadcaster -c /left/controller_manager") + spawner(
    f"arm_controller -c /left/controller_manager {FILE}"
)
_REMAP = '\n        <remap from="joint_states" to="/left/joint_states"/>'
_UNMARKED = _PUBLISHER.replace("«", "").replace("»", "")


@rule(
    "UC648",
    runtime="misbehaves",
    severity=Severity.WARNING,
    whole_robot=True,
    in_library=False,
    authority="joint_state_controller.cpp, joint_state_broadcaster.cpp: publish joint_states in the namespace of the manager; "
    "robot_state_publisher subscribes joint_states in its own",
    bad=[launched(_PUBLISHER % "", _MANAGER, _SPAWNER, controllers=_LEFT)],
    good=[launched(_UNMARKED % _REMAP, _MANAGER, _SPAWNER, controllers=_LEFT)],
)
def joint_states_of_other_namespace(project: Project) -> Iterator[Finding]:
    """Joint states are published in another namespace than that in which they are read.

    The broadcaster publishes `joint_states` in the namespace of its manager, robot_state_publisher reads them in its
    own. The robot moves, but stands still in RViz and in all transforms. Start both in one namespace, or remap.
    """
    launch, robot = project.launch, whole_robot_in(project)
    doubt = doubt_of(launch) if launch else None
    if launch is None or robot is None or doubt is None or all(joint.type == "fixed" for joint in robot.joints):
        return
    published = _published(project, launch)
    readers = [node for node in state_publishers(launch) if node.sure]
    read = [_read_by(node) for node in readers]
    if not published or not readers or None in read or _is_passed_on(project, launch):
        return
    topic, at = next(iter(published.items()))
    if not set(published) & set(read):
        message = f"the joint states are published as '{topic}', but robot_state_publisher reads '{read[0]}'"
        yield Finding(readers[0].at, message, (Note("they are published by this controller", at), *doubt.notes))


def _published(project: Project, launch: Launch) -> dict[str, Place]:
    """The topics that spawned controllers publish joint states on; none if one is not known."""
    topics: dict[str, Place] = {}
    for spawn in launch.spawns:
        for name, at in spawn.names:
            if _publishes(project, name.rpartition("/")[2]):
                namespace = spawn.namespace if launch.ros == 1 else spawn.full_name(name).rpartition("/")[0]
                if namespace is None or not spawn.sure or UNKNOWN in namespace or _has_arguments(spawn):
                    return {}
                topics[joined(namespace, _TOPIC)] = at
    return topics


def _publishes(project: Project, name: str) -> bool:
    """Whether a controller publishes the states of all joints under the usual name."""
    controller = project.controllers.controller(name) if project.controllers else None
    if controller is None or controller.type is None or "use_local_topics" in controller.parameters:
        return False
    known = (project.catalog.controller(controller.type.text, distro) for distro in project.distros)
    return any(kind is not None and kind.publishes_joint_states for kind in known)


def _has_arguments(spawn: Spawn) -> bool:
    return spawn.option("--controller-ros-args") is not None


def _read_by(node: Node) -> str | None:
    """The topic on which a node reads joint states; None if it is not known."""
    if node.namespace is None or not node.complete:
        return None
    own = joined(node.namespace, _TOPIC)
    new = next((new for old, new in node.remaps if joined(node.namespace, old) == own), None)
    topic = own if new is None else joined(node.namespace, new)
    return None if UNKNOWN in topic else topic


def _is_passed_on(project: Project, launch: Launch) -> bool:
    """Whether something else may read the joint states and publish them again, or renames them."""
    words = (word.text for node in launch.nodes for word in node.words)
    if publishers_of_states(launch) or any(_TOPIC in word for word in words) or launch.others:
        return True
    plugins = (plugin.setting("ros/remapping") for plugin in loaded_plugins(project))
    managers = (old for node in launch.nodes for old, _ in node.remaps if node not in state_publishers(launch))
    return any(plugins) or any(_TOPIC in old for old in managers)
