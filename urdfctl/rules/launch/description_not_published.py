"""UC611."""

from __future__ import annotations

from collections.abc import Iterator

from urdfctl.catalog.distros import ROS2, since, until
from urdfctl.model.launch import Launch, Node
from urdfctl.rule import Finding, Note, Project, Severity, rule
from urdfctl.rules.launch.common import ROS_2, launch_of, manager_nodes, state_publishers
from urdfctl.rules.launch.steps import description_topic
from urdfctl.rules.launch_samples import ARM, BROADCASTER, PUBLISHER, SOUND, launched

_NAME = "robot_description"
_ELSEWHERE = PUBLISHER.replace("<node ", '<node namespace="left" ')


@rule(
    "UC611",
    severity=Severity.ERROR,
    runtime="refuses",
    distros=ROS2,
    options=("--distro=jazzy",),
    authority="ros2_control controller_manager.cpp: 'Waiting for data on 'robot_description' topic to finish "
    "initialization'; since jazzy (#1358) the parameter is not read; until iron the topic is '~/robot_description'",
    bad=[
        launched(
            _ELSEWHERE,
            """
      «<node pkg="controller_manager" exec="ros2_control_node">»
        <param from="$(find-pkg-share arm)/controllers.yaml"/>
      </node>""",
            BROADCASTER,
            ARM,
        ),
    ],
    good=[SOUND],
)
def description_not_published(project: Project) -> Iterator[Finding]:
    """Controller manager gets no robot description.

    Since jazzy it waits for the topic robot_description in its namespace, which robot_state_publisher publishes. Until
    iron it takes the parameter robot_description. In humble and iron it also takes the topic ~/robot_description, which
    must be remapped. Without the description it has no hardware, and no spawner gets an answer.
    """
    launch = launch_of(project, ROS_2)
    if launch is None or not launch.complete:
        return
    publishers = state_publishers(launch)
    known = all(node.namespace is not None and node.complete for node in publishers)
    for node in manager_nodes(launch):
        if not node.sure or node.namespace is None or not node.complete:
            continue
        if set(project.distros) <= set(until("iron")):
            yield from _of_parameter(node)
        elif known and set(project.distros) <= set(since("jazzy")):
            yield from _of_topic(node, launch, publishers)


def _of_parameter(node: Node) -> Iterator[Finding]:
    given = any(word.text == _NAME for word in node.parameters)
    if not given and not any(before.endswith(f"/{_NAME}") for before, _ in node.remaps):
        yield Finding(
            node.at, "the controller manager gets no robot description, neither as a parameter nor through a remapping"
        )


def _of_topic(node: Node, launch: Launch, publishers: list[Node]) -> Iterator[Finding]:
    topics = {description_topic(publisher): publisher for publisher in publishers}
    asked = description_topic(node)
    if asked in topics:
        return
    if not topics:
        message = f"no node in the launch file publishes '{asked}', which the controller manager waits for"
        yield Finding(node.at, message, severity=Severity.WARNING)
        return
    topic, publisher = next(iter(topics.items()))
    message = f"the controller manager waits for '{asked}', but robot_state_publisher publishes '{topic}'"
    severity = Severity.ERROR if all(started.sure for started in launch.nodes) else Severity.WARNING
    yield Finding(node.at, message, (Note("robot_state_publisher is started here", publisher.at),), severity=severity)
