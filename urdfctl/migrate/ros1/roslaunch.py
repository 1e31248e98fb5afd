"""Read a launch file of ROS 1 as the actions that start the same things in ROS 2."""

from __future__ import annotations

import re
from collections.abc import Iterator, Sequence

from urdfctl.migrate.launch.actions import (
    Action,
    ActionCondition,
    PartOfText,
    Text,
    all_actions,
    literal,
    parsed,
)
from urdfctl.migrate.ros1.choices import LoadedFile, choices_in, chosen, loaded_files, without
from urdfctl.migrate.ros1.described import described_for, is_description, names_description
from urdfctl.migrate.ros1.description_commands import about_command, command_in
from urdfctl.migrate.ros1.doubles import as_double
from urdfctl.migrate.ros1.idle_publishers import with_description
from urdfctl.migrate.ros1.included import IncludedFile, kept_apart, passed_on, said_by
from urdfctl.migrate.ros1.joint_states import DECLARED_IN
from urdfctl.migrate.ros1.launch_target import LaunchTarget
from urdfctl.migrate.ros1.launches import new_name
from urdfctl.migrate.ros1.lost_to_simulator import lost_arguments, remapped_in_simulator
from urdfctl.migrate.ros1.moveit_launch import LOADED_BY_MOVEIT, MADE_BY_MOVEIT, is_loaded_by_moveit
from urdfctl.migrate.ros1.pausing import DECIDED, must_run, running
from urdfctl.migrate.ros1.roslaunch_nodes import (
    ARGUMENTS_OF_WORLD,
    Notes,
    description_publisher,
    migrated_node,
    remapping,
    simulator_actions,
)
from urdfctl.migrate.ros1.roslaunch_values import (
    given_by_name,
    inline_parameters,
    parameter_name,
    root_around,
    space_around,
    space_beyond,
    value_of,
)
from urdfctl.migrate.ros1.set_descriptions import (
    SetDescription,
    conditions_of,
    descriptions_of,
    is_overridden,
    overriding,
    said,
)
from urdfctl.migrate.ros1.simulated_time import needs_time, time_first
from urdfctl.migrate.ros1.spawned_models import is_spawned_as_sdf
from urdfctl.names import shortened
from urdfctl.source.xml.dom import COMMENT, Element, XmlText

_OF_WORLD = ("gazebo_ros", "gazebo_worlds")
_SURE_ENDINGS = (".launch.xml", ".launch")
_MOST_CHOICES = 3
"""Conditions in one node or include; it is written once for each combination."""
_WITHOUT_COUNTERPART = {
    "machine": "has no counterpart: start the launch file on that machine",
    "test": "has no counterpart: write the test with launch_testing",
}


class LaunchReading(Notes):
    """The actions of one launch file, and what is found out about them."""

    def __init__(self, target: LaunchTarget) -> None:
        super().__init__(target)
        self._included: dict[Text, IncludedFile] = {}

    def actions(self, root: Element) -> list[Action]:
        """Return the actions of a file, which start Gazebo Classic.

        The files of a spawner are those that it may need.
        """
        found = kept_apart(time_first(list(self._children(root, root))), self._included)
        spawns = must_run(found) or any(one.spawns for one in self._included.values())
        if (self.unpauses or spawns) and (started := running(found)) != found:
            found = started
            self.decided.append(DECIDED)
        if self.target.started != "none" and needs_time(found, self._included, self.target):
            found = [Action("set_parameter", "use_sim_time", literal("true")), *found]
        has_description = any(action.description for action in all_actions(tuple(found)))
        if has_description or self.target.describes:
            return found
        return with_description(found, makes_publisher=self.target.makes_publisher)

    def _children(self, parent: Element, root: Element) -> Iterator[Action]:
        files = loaded_files(parent)
        node = parent.firstChild
        while node is not None:
            if isinstance(node, XmlText) and node.nodeType == COMMENT and "--" not in node.data:
                text = "\n".join(line.strip() for line in node.data.strip().splitlines())
                if text and "<" not in text:
                    yield Action("comment", text)
            elif isinstance(node, Element):
                for action in self._with_choices(node, root, self._descriptions(node), files):
                    yield self._conditional(action, node)
            node = node.nextSibling

    def _with_choices(
        self, element: Element, root: Element, described: Sequence[SetDescription] | None, files: Sequence[LoadedFile]
    ) -> Iterator[Action]:
        """The actions of an element. Conditions inside of a node or an include choose between two of these, and those
        of the descriptions that it may have; None for what has none."""
        choices = choices_in(element) if element.tagName in ("node", "include") else []
        if element.attrs.get("type") == "spawner":
            choices += [text for one in files for text in one.conditions]
        choices = list(dict.fromkeys((*choices, *conditions_of(described or ()))))
        is_too_much = len(choices) > _MOST_CHOICES
        if is_too_much:
            self.left.append(f"choose inside of '{_name_of(element)}' by {', '.join(choices)}: all of it is written")
        if not choices or is_too_much:
            yield from self._element(element, root, said(described or ()), files)
            return
        first, both = choices[0], []
        for is_true in (True, False):
            with chosen(element, first, is_true=is_true):
                left = [one.when(first, is_true=is_true) for one in files]
                kept = [one for one in left if one is not None]
                texts = [one.when(first, is_true=is_true) for one in described or ()]
                own = [one for one in texts if one is not None]
                has_none = bool(described) and not own
                both.append([] if has_none else list(self._with_choices(element, root, own, kept)))
        if both[0] == both[1]:
            yield from both[0]
            return
        for negated, inner in enumerate(both):
            if inner:
                yield Action("group", inner=tuple(inner), condition=ActionCondition(parsed(first), bool(negated)))

    def _conditional(self, action: Action, element: Element) -> Action:
        for name in ("if", "unless"):
            if name in element.attrs and action.kind != "comment":
                condition = ActionCondition(parsed(element.attrs[name]), name == "unless")
                if action.condition is not None:
                    return Action("group", inner=(action,), condition=condition)
                return action._replace(condition=condition)
        return action

    def _element(
        self, element: Element, root: Element, description: Text, files: Sequence[LoadedFile]
    ) -> Iterator[Action]:
        attrs = element.attrs
        if element.tagName == "arg":
            self.defaults[attrs.get("name", "")] = attrs.get("default", attrs.get("value", ""))
            self.required |= set() if attrs.keys() & {"default", "value"} else {attrs.get("name", "")}
            if "value" in attrs:
                yield Action("let", attrs.get("name", ""), command_in(attrs["value"]) or parsed(attrs["value"]))
            else:
                default = self._value(attrs["default"]) if "default" in attrs else None
                default = command_in(attrs.get("default", "")) or default
                yield Action("argument", attrs.get("name", ""), default, about=attrs.get("doc", ""))
        elif element.tagName == "group":
            inner = tuple(self._children(element, root))
            if inner:
                yield Action("group", value=parsed(attrs["ns"]) if "ns" in attrs else None, inner=inner)
        elif element.tagName == "include":
            yield from self._include(element)
        elif element.tagName == "node":
            yield from self._node(element, description, files)
        elif element.tagName == "param":
            yield from self._param(element)
        elif element.tagName == "rosparam":
            yield from self._rosparam(element)
        elif element.tagName == "remap" and not names_description(remapping(element)[0]):
            yield Action("set_remap", remaps=(remapping(element),))
        elif element.tagName == "env":
            yield _variable(element)
        elif element.tagName in _WITHOUT_COUNTERPART:
            self.left.append(f"<{element.tagName}> {_WITHOUT_COUNTERPART[element.tagName]}")

    def _node(self, element: Element, description: Text, files: Sequence[LoadedFile]) -> Iterator[Action]:
        """The actions for a node, with the parameters that the file sets by the node's name."""
        pairs, own_files = self._given(element)
        for action in migrated_node(self, element, description, [one.address for one in files]):
            if action.kind != "node" or action.name == "spawner":
                yield action
            else:
                given = tuple((name, as_double(action.name, name, value)) for name, value in pairs)
                own = action._replace(pairs=(*given, *action.pairs), files=(*own_files, *action.files))
                yield self.with_shell(own)

    def _given(self, node: Element) -> tuple[list[tuple[str, Text]], list[Text]]:
        """The parameters, and the files with parameters, that the file sets outside of a node by its name."""
        pairs: list[tuple[str, Text]] = []
        files: list[Text] = []
        for owner, element, name in given_by_name(root_around(node)):
            if owner is not node:
                continue
            if "file" in element.attrs:
                files += [] if name else [parsed(element.attrs["file"])]
            elif element.tagName == "rosparam":
                pairs += inline_parameters(element, parameter_name(name))
            elif "value" in element.attrs:
                pairs.append((parameter_name(name), value_of(element)))
        files += map(parsed, self.target.files_of(node.attrs.get("name", "")))
        return pairs, list(dict.fromkeys(files))

    def _is_given(self, element: Element) -> bool:
        """Whether a parameter outside of nodes is given to the node of its name."""
        found = (name for _, one, name in given_by_name(root_around(element)) if one is element)
        return any("file" not in element.attrs or not name for name in found)

    # -- includes ------------------------------------------------------------------------------------------------------

    def _include(self, element: Element) -> Iterator[Action]:
        file = parsed(element.attrs.get("file", ""))
        given = tuple(
            (child.attrs.get("name", ""), self._value(child.attrs.get("value", child.attrs.get("default", ""))))
            for child in element.elements()
            if child.tagName == "arg"
        )
        packages = [part.text for part in file if part.kind == "find"]
        variables = [one for one in element.elements() if one.tagName == "env"]
        if variables:  # they are for what the include starts
            with without(element, variables):
                included = tuple(self._include(element))
            yield Action("group", inner=(*map(_variable, variables), *included))
            return
        if packages and packages[0] in _OF_WORLD:
            self.left += remapped_in_simulator(element) if self.target.has_controllers else ()
            self.left += lost_arguments(dict(given), self.defaults) if self.target.started == "gz" else ()
            of_world = dict.fromkeys(ARGUMENTS_OF_WORLD)
            passed = passed_on(element, dict(given), self.defaults, of_world)
            yield from simulator_actions(self, dict((*given, *passed)))
            return
        if self._is_left(file):
            self.left.append(f"start here what replaces MoveIt's '{file[-1].text.rpartition('/')[2]}'")
            return
        made = self._made_by_moveit(file)
        its = self.target.included(element.attrs.get("file", ""))
        if made and is_loaded_by_moveit(made, dict(given), its.arguments):
            return  # MoveItConfigsBuilder reads the parameters that it loaded
        if made:
            action = Action("include", value=(*file[:-1], PartOfText("text", made)))
        else:
            more = passed_on(element, dict(given), self.defaults, its.arguments)
            action = Action("include", value=self._new_path(file), pairs=(*given, *more))
            self._included[action.value or ()] = its
        if "ns" in element.attrs:
            action = Action("group", value=parsed(element.attrs["ns"]), inner=(action,))
        yield action

    def _value(self, text: str) -> Text:
        """The value of an argument, which may be the path of a launch file that is migrated too."""
        value = parsed(text)
        is_launch = text.endswith(_SURE_ENDINGS) and not self._is_left(value)
        packages = [part.text for part in value if part.kind == "find"]
        is_own = not packages or packages[0] in self.target.own
        return self._new_path(value) if is_launch and is_own else value

    def _is_left(self, file: Text) -> bool:
        """Whether a launch file is left to a person, so that no new one can be started."""
        package = next((part.text for part in file if part.kind == "find"), self.target.own_package)
        name = file[-1].text.rpartition("/")[2] if file and file[-1].kind == "text" else ""
        return (package, name) in self.target.left

    def _made_by_moveit(self, file: Text) -> str:
        """The end of the path of an included launch file that MoveIt makes, with other arguments; empty for others.

        It is the old one for a file that only loaded parameters.
        """
        package = next((part.text for part in file if part.kind == "find"), self.target.own_package)
        if package not in self.target.moveit or not file or file[-1].kind != "text":
            return ""
        folder, slash, name = file[-1].text.rpartition("/")
        if name.endswith(LOADED_BY_MOVEIT) and name not in MADE_BY_MOVEIT and folder.endswith("/launch"):
            return file[-1].text
        return f"{folder}{slash}{MADE_BY_MOVEIT[name]}.launch.py" if name in MADE_BY_MOVEIT else ""

    def _new_path(self, file: Text) -> Text:
        """The path of an included file: that of the migrated one."""
        packages = [part.text for part in file if part.kind == "find"]
        if packages and packages[0] not in self.target.own:
            self.left.append(f"check the name of the launch file of package '{packages[0]}' in ROS 2")
        if not file or file[-1].kind != "text":
            return file
        new = new_name(file[-1].text, self.target.ending, self.target.doubled)
        return (*file[:-1], PartOfText("text", new))

    # -- parameters ----------------------------------------------------------------------------------------------------

    def _descriptions(self, element: Element) -> list[SetDescription] | None:
        """The descriptions that a robot_state_publisher may have; None for other elements."""
        is_its = element.attrs.get("pkg") == "robot_state_publisher"
        return descriptions_of(element, self.target.descriptions) if is_its else None

    def _param(self, element: Element) -> Iterator[Action]:
        name, names = element.attrs.get("name", ""), self.target.descriptions
        if self.target.started == "gz" and is_spawned_as_sdf(element):
            return  # the spawner reads the file
        if is_description(element, names):
            self.left += about_command(element.attrs.get("command", ""))
            is_published = said_by(element) in self.target.published or is_overridden(element, names)
            if not is_published and not _has_publisher(root_around(element)):
                action = description_publisher(self.target, element)
                for text, negated in overriding(element, names):
                    condition = ActionCondition(parsed(text), not negated)
                    action = Action("group", inner=(action,), condition=condition)
                yield action
            return
        last = name.rpartition("/")[2]
        if "value" in element.attrs and self._is_given(element):
            return
        if last == "use_sim_time":
            value = parsed(element.attrs.get("value", "true"))
            yield Action("set_parameter", "use_sim_time", value)
        else:
            self.left.append(f"ROS 2 has no global parameters: give '{name}' to the node that reads it")

    def _rosparam(self, element: Element) -> Iterator[Action]:
        file = element.attrs.get("file")
        if self._is_given(element) and not (file and self.names_controllers(file)):
            return
        if file is None:
            text = "ROS 2 has no global parameters: give those of this <rosparam> to the node that reads them"
            self.left.append(text)
        elif file == DECLARED_IN:
            return  # the spawner starts the broadcaster, which the controller file declares
        elif not self.names_controllers(file):
            self.left.append(f"ROS 2 has no global parameters: give '{file}' to the node that reads it")
        elif self.target.elsewhere:
            text = (
                f"the robot's description is in another package: let the plugin of {self.target.simulator} in it load"
            )
            self.left.append(f"{text} '{file}' by <parameters>")
        elif self.target.simulated:
            if names := shortened(self.target.undeclared(file), 3):
                text = f"no plugin of {self.target.simulator} loads '{file}', which declares {names}"
                self.left.append(f"{text}: name it in <parameters> too, on the same condition")
        elif not self.target.has_manager:
            self.target = self.target._replace(has_manager=True)
            yield self._manager(element, parsed(file))

    def _manager(self, element: Element, file: Text) -> Action:
        """The controller manager, in the namespace of the spawners."""
        spawners = [node for node in _all(root_around(element)) if node.attrs.get("type") == "spawner"]
        spaces = [_space_of(node) or space_beyond(node, element) for node in spawners]
        usual = "" if spaces else element.attrs.get("ns", "")
        space = next((each for each in spaces if each.strip("/")), usual)
        groups = "" if space.startswith("/") else space_around(element)
        full = "/".join(filter(None, (groups, space.strip("/"))))
        return Action(
            "node",
            "ros2_control_node",
            value=parsed(space) if space else None,
            package="controller_manager",
            files=(file,),
            remaps=tuple(self._remapped_description(full)),
        )

    def _remapped_description(self, space: str) -> Iterator[tuple[Text, Text]]:
        """The remapping with which the manager in a namespace reads the description where it is published."""
        published = described_for(self.target.described_in, space)
        topic = (
            f"/{published}/robot_description" if published else "/robot_description" if space else "robot_description"
        )
        if self.target.remaps_description:
            yield literal("~/robot_description"), parsed(topic)
        elif published != space:
            yield literal("robot_description"), parsed(topic)


def _variable(element: Element) -> Action:
    return Action("set_env", element.attrs.get("name", ""), parsed(element.attrs.get("value", "")))


def _space_of(spawner: Element) -> str:
    """The namespace of the manager of a spawner, as it says itself."""
    given = re.search(r"--namespace[=\s]+(\S+)", spawner.attrs.get("args", ""))
    return given[1] if given else spawner.attrs.get("ns", "")


def _name_of(element: Element) -> str:
    return element.attrs.get("name") or element.attrs.get("type") or element.attrs.get("file", "")


def _has_publisher(root: Element) -> bool:
    return any(element.attrs.get("pkg") == "robot_state_publisher" for element in _all(root))


def _all(element: Element) -> Iterator[Element]:
    yield element
    for child in element.elements():
        yield from _all(child)
