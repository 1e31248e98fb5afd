"""UC629."""

from __future__ import annotations

from collections.abc import Iterator
from itertools import takewhile

from urdfctl.catalog.distros import ROS2
from urdfctl.model.launch import Node
from urdfctl.rule import Finding, Project, Severity, rule
from urdfctl.rules.common import replaced
from urdfctl.rules.launch.common import ROS_2, launch_of, state_publishers
from urdfctl.rules.launch_samples import ARM, BROADCASTER, MANAGER, PUBLISHER, SOUND, launched

_DESCRIPTION = "robot_description"
_RENAMED = PUBLISHER.replace('name="robot_description"', 'name="«robot_desc»"')
_BARE = '<node pkg="robot_state_publisher" exec="robot_state_publisher"{}>{}</node>'
_FILE = ' args="$(find-pkg-share arm)/arm.urdf"'


@rule(
    "UC629",
    severity=Severity.ERROR,
    runtime="refuses",
    distros=ROS2,
    options=("--distro=jazzy",),
    authority="robot_state_publisher src/robot_state_publisher.cpp RobotStatePublisher(): 'robot_description parameter must not be "
    "empty', unless an argument names a URDF file",
    bad=[
        launched(_RENAMED, MANAGER, BROADCASTER, ARM),
        launched(_BARE.format("", "").replace("<node", "«<node").replace("></", ">»</"), MANAGER, BROADCASTER, ARM),
        launched(
            _BARE.format(' args="--ros-args --log-level error"', "").replace("<node", "«<node").replace("></", ">»</"),
            MANAGER,
            BROADCASTER,
            ARM,
        ),
    ],
    good=[
        SOUND,
        launched(_BARE.format(_FILE, ""), MANAGER, BROADCASTER, ARM),
        launched(_BARE.format("", '<param from="$(find-pkg-share arm)/state.yaml"/>'), MANAGER, BROADCASTER, ARM)
        | {"state.yaml": "robot_state_publisher: {ros__parameters: {robot_description: <robot/>}}\n"},
    ],
)
def publisher_without_description(project: Project) -> Iterator[Finding]:
    """robot_state_publisher gets no robot_description.

    It exits with 'robot_description parameter must not be empty'. Nobody publishes the description: the model is not
    spawned, a controller manager waits for it, and there are no transforms.
    """
    launch = launch_of(project, ROS_2)
    for node in state_publishers(launch) if launch else []:
        if not node.sure or not node.complete or node.files or _is_given(node):
            continue
        other = next((word for word in node.parameters if "desc" in word.text or "urdf" in word.text), None)
        if other is None:
            yield Finding(node.at, "robot_state_publisher gets no parameter 'robot_description', and exits")
            continue
        message = f"robot_state_publisher gets '{other.text}', but no 'robot_description', and exits"
        yield Finding(other.at, message, fix=replaced(other.at, other.text, _DESCRIPTION))


def _is_given(node: Node) -> bool:
    """Whether a parameter or an argument of a node gives it the description."""
    texts = [word.text for word in node.words]
    of_ros = texts[texts.index("--ros-args") :] if "--ros-args" in texts else []
    named = [word.text for word in node.parameters] + of_ros
    if any(_DESCRIPTION in text or text == "--params-file" for text in named):
        return True
    return any(not text.startswith("-") for text in takewhile(lambda text: text != "--ros-args", texts))
