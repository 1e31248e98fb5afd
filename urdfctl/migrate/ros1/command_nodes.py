"""Nodes of launch files that are commands of ROS 1, as `rostopic pub`: commands of ROS 2."""

from __future__ import annotations

import re
from collections.abc import Iterator, Mapping, Sequence

from urdfctl.migrate.launch.actions import Action, Text, is_literal, literal, plain

COMMANDS = frozenset({"rostopic", "rosservice", "rosbag", "rosparam", "rosnode"})
"""The packages whose programs are commands for a terminal. ROS 2 has none of them: a node of one ends the launch."""
_OPTIONS: Mapping[str, tuple[str, int]] = {
    "-1": ("--once", 0),
    "--once": ("--once", 0),
    "-r": ("-r", 1),
    "--rate": ("-r", 1),
    "-l": ("", 0),
    "--latch": ("", 0),
}
"""Options of `rostopic pub`, each with that of `ros2 topic pub` and the number of its values. A topic that is published
once a second needs no latch."""
_TYPE = re.compile(r"(\w+)/(?:msg/)?(\w+)")
_PARTS = 3


def published(words: Sequence[Text], output: Sequence[tuple[str, str]]) -> Action | None:
    """Return the process for the words after `rostopic`; None if it is not known what they are in ROS 2."""
    if not words or not all(map(is_literal, words)) or plain(words[0]) != "pub":
        return None
    options: list[str] = []
    parts: list[str] = []
    rest = iter([plain(word) for word in words[1:]])
    for word in rest:
        if word in _OPTIONS:
            new, values = _OPTIONS[word]
            options += [new] if new else []
            options += [next(rest, "") for _ in range(values)]
        else:
            parts.append(word)
    kind = _TYPE.fullmatch(parts[1]) if len(parts) >= _PARTS else None
    value = _value(kind[1], parts[2:]) if kind else ""
    if kind is None or not value:
        return None
    shown = ["ros2", "topic", "pub", *options, parts[0], f"{kind[1]}/msg/{kind[2]}", value]
    return Action("process", words=tuple(map(literal, shown)), flags=tuple(output))


def _value(package: str, parts: Sequence[str]) -> str:
    """The value of a message in YAML; empty if it is not known which fields the parts are of."""
    written = " ".join(parts).strip("'\"")
    if written.startswith("{"):
        return written
    return f"{{data: {written}}}" if package == "std_msgs" and len(parts) == 1 else ""


def transform_words(words: Sequence[Text], *, is_tf: bool) -> Iterator[Text]:
    """Yield the arguments of static_transform_publisher, by name (geometry2, tf2_ros static_transform_broadcaster)."""
    count = len(words) - (1 if is_tf else 0)
    angles = ("--yaw", "--pitch", "--roll") if count == 8 else ("--qx", "--qy", "--qz", "--qw")  # noqa: PLR2004
    names = ("--x", "--y", "--z", *angles, "--frame-id", "--child-frame-id")
    if len(names) != count:
        yield from words
        return
    for name, word in zip(names, words, strict=False):
        yield literal(name)
        yield word
