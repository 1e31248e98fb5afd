"""Topics and actions whose name or type changes with a controller, and the files that name them."""

from __future__ import annotations

import os
import re
from collections.abc import Iterable, Iterator

from urdfctl.catalog.distros import since
from urdfctl.migrate.report import ReportLine
from urdfctl.migrate.step import EntryKind
from urdfctl.migrate.trial.scratch import Scratch
from urdfctl.names import shortened
from urdfctl.output.change import Change
from urdfctl.source.disk.files import first_bytes
from urdfctl.source.span import SourceText
from urdfctl.source.yaml.tree import Mapping, Node, Scalar, read_yaml
from urdfctl.startup.records import NamedTuple

CODE = (".py", ".cpp", ".cc", ".cxx", ".c", ".hpp", ".h", ".hh")
"""The endings of files with code."""
_OTHERS = ("", ".xml", ".launch", ".yaml", ".yml", ".rviz", ".perspective", ".sh", ".m")
_MOST_BYTES = 1 << 20
_MOST_NAMES = 4
_PARTS = 64
"""So many names are looked for at once; a file of controllers mostly has fewer."""


class MovedTopic(NamedTuple):
    """A topic or action that changes with a controller.

    pattern: the type of the controller before, or after for one that keeps it.
    old, new: the last part of the name.
    kind: the type of the message or action now.
    message: what is said about the file of the controller.
    in_code: whether only code may name it: launch files that remap it stay right.
    is_done: whether nothing is left to do in packages without a file that names it.
    """

    pattern: str
    old: str
    new: str
    kind: str
    message: str
    authority: str
    in_code: bool = False
    is_done: bool = False


_OF_ROS1 = (
    MovedTopic(
        pattern=r"(?:effort_controllers/Joint(?:Position|Velocity)|velocity_controllers/JointPosition)Controller\b",
        old="command",
        new="reference",
        kind="control_msgs/msg/MultiDOFCommand",
        message="controllers that became PidController read ~/reference of type control_msgs/msg/MultiDOFCommand, not "
        "~/command of type Float64: change who publishes it",
        authority="ros2_controllers pid_controller.cpp: ControllerCommandMsg",
    ),
    MovedTopic(
        pattern=r"(?:position_controllers/JointPosition|velocity_controllers/JointVelocity|effort_controllers/JointEffort)"
        r"Controller\b",
        old="command",
        new="commands",
        kind="std_msgs/msg/Float64MultiArray",
        message="the controllers of single joints read ~/commands of type std_msgs/msg/Float64MultiArray now, not "
        "~/command of type Float64: change who publishes it",
        authority="ros2_controllers forward_controllers_base.cpp",
    ),
    MovedTopic(
        pattern=r"(?:position|velocity|effort)_controllers/JointGroup(?:Position|Velocity|Effort)Controller\b",
        old="command",
        new="commands",
        kind="std_msgs/msg/Float64MultiArray",
        message="the controllers of groups of joints read ~/commands now, not ~/command: change who publishes it",
        authority="ros2_controllers forward_controllers_base.cpp",
    ),
    MovedTopic(
        pattern=r"_controllers/JointTrajectoryController\b",
        old="command",
        new="joint_trajectory",
        kind="trajectory_msgs/msg/JointTrajectory",
        message="trajectories are read from ~/joint_trajectory now, not from ~/command",
        authority="ros2_controllers joint_trajectory_controller.cpp",
    ),
)
_STAMPED = MovedTopic(
    pattern=r"\b(?:diff_drive_controller/DiffDriveController|ackermann_steering_controller/|mecanum_drive_controller/)",
    old="cmd_vel",
    new="cmd_vel",
    kind="geometry_msgs/msg/TwistStamped",
    message="it reads geometry_msgs/msg/TwistStamped, not Twist: change who publishes its velocities",
    authority="ros2_controllers diff_drive_controller.cpp: create_subscription<TwistStamped>",
    in_code=True,
)
_STAMPED_IN_HUMBLE = _STAMPED._replace(
    message="it reads geometry_msgs/msg/TwistStamped unless use_stamped_vel is false, which keeps Twist",
    authority="ros2_controllers humble diff_drive_controller_parameter.yaml: use_stamped_vel",
)
_UNSTAMPED = _STAMPED._replace(
    new="cmd_vel_unstamped",
    kind="geometry_msgs/msg/Twist",
    message="it reads Twist from ~/cmd_vel_unstamped, not from ~/cmd_vel: change who publishes its velocities",
    authority="ros2_controllers humble diff_drive_controller.cpp: DEFAULT_COMMAND_UNSTAMPED_TOPIC",
    in_code=False,
)
_GRIPPER = MovedTopic(
    pattern=r"\bparallel_gripper_action_controller/GripperActionController\b",
    old="gripper_cmd",
    new="gripper_cmd",
    kind="control_msgs/action/ParallelGripperCommand",
    message="its action ~/gripper_cmd is of type control_msgs/action/ParallelGripperCommand, no longer GripperCommand",
    authority="ros2_controllers parallel_gripper_action_controller.hpp: GripperCommandAction",
    in_code=True,
    is_done=True,
)


def moved_topics(scratch: Scratch, target: str, changed: Iterable[Change], *, from_ros1: bool) -> Iterator[ReportLine]:
    """Yield a line for each file of controllers whose topics change, and one for each file that names such a topic.

    changed: what the migration changed. from_ros1: whether the packages were for ROS 1.
    """
    named: dict[str, MovedTopic] = {}
    for change in changed:
        if change.after is None or not change.file.endswith((".yaml", ".yml")):
            continue
        for data, each in _moved(change, target, from_ros1=from_ros1):
            names = list(dict.fromkeys(_controllers(data, each.pattern)))
            found = re.search(each.pattern, data.decode("utf-8", "replace"))
            if found is None:
                continue
            after = change.after.decode("utf-8", "replace")
            line = after.count("\n", 0, max(after.find(found[0]), 0)) + 1
            kind = EntryKind.DONE if each.is_done else EntryKind.FOR_YOU
            message = f"{each.message} ({shortened(names, _MOST_NAMES)})" if names else each.message
            yield ReportLine(kind, message, file=change.file, line=line, authority=each.authority)
            if each is not _STAMPED_IN_HUMBLE:
                named.update(dict.fromkeys(names, each))
    if named:
        yield from _users(scratch, named)


def _moved(change: Change, target: str, *, from_ros1: bool) -> Iterator[tuple[bytes, MovedTopic]]:
    """The topics that may change with a file, each with the text in which the types are looked for."""
    before, after = change.before or b"", change.after or b""
    if from_ros1:
        yield from ((before, each) for each in _OF_ROS1)
        if target in since("jazzy"):
            yield after, _STAMPED
        else:
            yield after, _UNSTAMPED if re.search(rb"use_stamped_vel\s*:\s*false", after) else _STAMPED_IN_HUMBLE
    if not re.search(_GRIPPER.pattern.encode(), before):
        yield after, _GRIPPER


def _controllers(data: bytes, pattern: str) -> Iterator[str]:
    """The names of the controllers of a type in a file."""
    for root in read_yaml(SourceText("", data)).documents:
        yield from _typed(root, "", pattern)


def _typed(node: Node, name: str, pattern: str) -> Iterator[str]:
    for entry in node.entries if isinstance(node, Mapping) else ():
        is_type = entry.key.text == "type" and isinstance(entry.value, Scalar)
        if is_type and name and isinstance(entry.value, Scalar) and re.search(pattern, entry.value.text):
            yield name
        yield from _typed(entry.value, entry.key.text.strip("/").rpartition("/")[2], pattern)


def _users(scratch: Scratch, named: dict[str, MovedTopic]) -> Iterator[ReportLine]:
    """The files that name a topic as it was before."""
    names = sorted(named, key=len, reverse=True)
    groups = [names[start : start + _PARTS] for start in range(0, len(names), _PARTS)]
    patterns = [
        re.compile(rf"[\w/~]*(?<!\w)({'|'.join(map(re.escape, group))})/(command|cmd_vel|gripper_cmd)(?![\w/])")
        for group in groups
    ]
    for path in scratch.files():
        if os.path.splitext(path)[1] not in (*CODE, *_OTHERS):
            continue
        text = beginning(path).decode("utf-8", "replace")
        is_code = path.endswith(CODE) and "generate_launch_description" not in text
        for found in (one for pattern in patterns for one in pattern.finditer(text)):
            its = named[found[1]]
            if found[2] == its.old and (is_code or not its.in_code):
                new = f"{found[0].removesuffix(its.old)}{its.new}"
                is_same = new == found[0]
                what = f"takes {its.kind} now" if is_same else f"is '{new}' of type {its.kind} now"
                line = text.count("\n", 0, found.start()) + 1
                message = f"'{found[0]}' {what}: change it here"
                file = scratch.real(path)
                yield ReportLine(EntryKind.FOR_YOU, message, file=file, line=line, authority=its.authority)


def beginning(path: str) -> bytes:
    """Return the beginning of a file; nothing of a link, whose file is listed by itself, or of what is no regular
    file."""
    try:
        return b"" if os.path.islink(path) else first_bytes(path, _MOST_BYTES)
    except OSError:
        return b""
