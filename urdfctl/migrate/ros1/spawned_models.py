"""The words with which models are spawned: from a file, a topic, or a parameter of ROS 1 that no node of ROS 2 has."""

from __future__ import annotations

from itertools import pairwise

from urdfctl.migrate.edits.markup import attribute, elements
from urdfctl.migrate.launch.actions import PartOfText, Text, is_literal, literal, parsed, plain, words_of
from urdfctl.migrate.ros1.described import described_for, sets_text
from urdfctl.migrate.ros1.description_commands import description_command
from urdfctl.migrate.ros1.launch_target import LaunchTarget
from urdfctl.migrate.ros1.roslaunch_values import namespace_of, root_around
from urdfctl.migrate.ros1.set_descriptions import read_by
from urdfctl.source.xml.dom import Element


def file_text(file: Text) -> str:
    """Return a text as it is written in a launch file of ROS 1."""
    return "".join(part.text if part.kind == "text" else f"$({part.kind} {part.text})" for part in file)


def words_for_file(target: LaunchTarget, file: Text) -> list[Text]:
    """Return the words with which a robot in a file is spawned: what xacro makes of it if the file alone is no robot any
    more."""
    written = file_text(file)
    if target.started != "gz" or not target.is_expanded(written):
        return [literal("-file"), file]
    return [literal("-string"), (PartOfText("command", f"xacro {written}"),)]


def words_for_parameter(target: LaunchTarget, node: Element, parameter: Text) -> list[Text]:
    """Return the words with which a model in a parameter is spawned: from the topic of the node that publishes it, or
    from what the launch file sets the parameter to."""
    setting = _unpublished(node, plain(parameter)) if is_literal(parameter) and target.started == "gz" else None
    if setting is None:
        return [literal("-topic"), _topic_of(target, node, parameter)]
    if "textfile" in setting.attrs:
        return words_for_file(target, parsed(setting.attrs["textfile"]))
    return [literal("-string"), (PartOfText("command", file_text(description_command(setting))),)]


def is_spawned_as_sdf(param: Element) -> bool:
    """Return whether a launch file spawns a model in SDF from a parameter, which no robot_state_publisher can read."""
    name = _last(attribute(param, "name"))
    every = elements(root_around(param))
    return sets_text(param) and any(_is_sdf(one) and name in _parameters_of(one) for one in every)


def _unpublished(node: Element, parameter: str) -> Element | None:
    """The last <param> that sets what a spawner reads, unless a robot_state_publisher of the file publishes it."""
    every = list(elements(root_around(node)))
    settings = {_last(attribute(one, "name")): one for one in every if sets_text(one)}
    read = {read_by(one) for one in every if attribute(one, "pkg") == "robot_state_publisher"} & settings.keys()
    is_published = not _is_sdf(node) and (not read or _last(parameter) in read)
    return None if is_published else settings.get(_last(parameter))


def _is_sdf(node: Element) -> bool:
    return attribute(node, "type") == "spawn_model" and "-sdf" in attribute(node, "args").split()


def _parameters_of(node: Element) -> set[str]:
    words = [plain(word) for word in words_of(parsed(attribute(node, "args")))]
    return {_last(value) for option, value in pairwise(words) if option == "-param"}


def _last(name: str) -> str:
    return name.rpartition("/")[2]


def _topic_of(target: LaunchTarget, node: Element, parameter: Text) -> Text:
    """The topic on which robot_state_publisher publishes the description that was a parameter, whatever its name."""
    if not is_literal(parameter):
        return parameter
    space, slash, last = plain(parameter).rpartition("/")
    topic = last if last in target.apart else "robot_description"
    own = "/".join(part for part in ("" if slash and not space else namespace_of(node), space.strip("/")) if part)
    published = described_for(target.described_in, own)
    if "$(" not in f"{published}{own}" and own != published:
        return literal("/".join(("", *filter(None, [published]), topic)))
    return literal(f"{space}{slash}{topic}")
