"""The nodes that ROS 2 launch files load into a container, as components of one process."""

from __future__ import annotations

from urdfctl.model.launch.ros2.texts import Texts
from urdfctl.source.launch.terms import Called, Constant, Items, Perhaps, Term

_PROGRAMS = {
    "robot_state_publisher::RobotStatePublisher": ("robot_state_publisher", "robot_state_publisher"),
    "ros_gz_sim::GzServer": ("ros_gz_sim", "gzserver"),
    "ros_gz_bridge::RosGzBridge": ("ros_gz_bridge", "bridge_node"),
}
"""The components that have to do with robots: package and executable of the same node in a process of its own."""
_SAME = ("name", "namespace", "parameters", "remappings", "condition")


def nodes_in_container(container: Called, texts: Texts) -> Items:
    """Return the nodes of a container that have to do with robots, as the actions that start each on its own."""
    given = container.given("composable_node_descriptions")
    components = given.values if isinstance(given, Items) else []
    found = [_alone(component, texts) for component in components]
    return Items([node for node in found if node is not None], container.at)


def _alone(component: Term, texts: Texts) -> Term | None:
    if isinstance(component, Perhaps):
        node = _alone(component.term, texts)
        return node and Perhaps(node, component.at)
    if not isinstance(component, Called) or component.short != "ComposableNode":
        return None
    program = _PROGRAMS.get(texts.of(component.given("plugin")))
    if program is None:
        return None
    package, executable = (Constant(name, component.at) for name in program)
    keywords = {name: component.keywords[name] for name in _SAME if name in component.keywords}
    return Called("Node", component.at, (), {**keywords, "package": package, "executable": executable})
