"""The programs that spawn a model into a simulator, and what they are told."""

from __future__ import annotations

from itertools import zip_longest

from urdfctl.model.launch import Launch, Node, Word

MODEL_SPAWNERS = {
    ("gazebo_ros", "spawn_model"): "-model",
    ("gazebo_ros", "urdf_spawner"): "-model",
    ("gazebo_ros", "spawn_entity.py"): "-entity",
    ("ros_gz_sim", "create"): "-name",
    ("ros_ign_gazebo", "create"): "-name",
}
"""The programs that spawn a model, with the option that names it."""


def model_spawners(launch: Launch) -> list[Node]:
    """Return the nodes that spawn a model into a simulator."""
    return [node for node in launch.nodes if (node.package.text, node.executable.text) in MODEL_SPAWNERS]


def spawns_unread_model(launch: Launch | None) -> bool:
    """Return whether a launch file spawns a model from a file that is not a description, and was not read: one that is
    found only by the simulator, as `model://arm`, or is written at launch."""
    files = [option_of(node, "file") for node in model_spawners(launch)] if launch else []
    texts = [file.text for file in files if file is not None and not file.text.endswith((".urdf", ".xacro"))]
    there = [one.file.path for one in launch.references if one.file.exists] if launch else []
    return any(text not in there for text in texts)


def option_name(word: Word) -> str | None:
    """Return the name of an option, without hyphens and value; None if the word is none, such as a negative number."""
    name = word.text.lstrip("-").partition("=")[0]
    is_number = name.lstrip(".")[:1].isdigit()
    return name if word.text.startswith("-") and not is_number else None


def option_of(node: Node, name: str) -> Word | None:
    """Return the value of an option of a node, by its word or the parameter of the same name; None if not given."""
    for word, after in zip_longest(node.words, node.words[1:]):
        if option_name(word) == name:
            _, is_joint, value = word.text.partition("=")
            return Word(value, word.at) if is_joint else after
    given = dict(node.values).get(name)
    at = next((word.at for word in node.parameters if word.text == name), node.at)
    return Word(given, at) if given else None
