"""The nodes of a ROS 1 launch file in ROS 2: spawners, the simulator, publishers, and all others."""

from __future__ import annotations

import re
from collections.abc import Collection, Iterator, Mapping, Sequence

from urdfctl.migrate.classic.launch_actions import CLASSIC_FILE, CLASSIC_PACKAGE, CLIENT_FILE
from urdfctl.migrate.classic.starting import SPAWN, WITHOUT_SUCCESSOR
from urdfctl.migrate.launch.actions import (
    Action,
    Text,
    is_literal,
    joined,
    literal,
    parsed,
    plain,
    without_quotes,
    words_of,
)
from urdfctl.migrate.ros1.classic_programs import CLIENT, given_to_simulator
from urdfctl.migrate.ros1.command_nodes import COMMANDS, published, transform_words
from urdfctl.migrate.ros1.described import names_description
from urdfctl.migrate.ros1.description_commands import description_command
from urdfctl.migrate.ros1.doubles import as_double
from urdfctl.migrate.ros1.joint_states import DECLARED_IN, NEW_NAME, OLD_NAME
from urdfctl.migrate.ros1.launch_target import LaunchTarget
from urdfctl.migrate.ros1.lost_to_simulator import remapped_in_simulator
from urdfctl.migrate.ros1.node_attributes import flags_of, lost_attributes, lost_commands, renamed_parameters
from urdfctl.migrate.ros1.roslaunch_values import namespace_of, parameters_of, unread_parameters_of
from urdfctl.migrate.ros1.spawned_models import file_text, words_for_file, words_for_parameter
from urdfctl.migrate.ros1.spawned_names import full_name
from urdfctl.migrate.ros1.word_remappings import without_remappings
from urdfctl.model.launch.abbreviations import whole_option
from urdfctl.model.launch.ros1.nodes import SPAWNER_OPTIONS
from urdfctl.source.xml.dom import Element


class Notes:
    """What is found out while a launch file is read.

    left: what a person must do.
    decided: the choices that were made.
    unpauses: whether a spawner of models lets the simulation run.
    defaults: the defaults of the arguments so far.
    required: the arguments so far that have none.
    """

    def __init__(self, target: LaunchTarget) -> None:
        self.target = target
        self.left: list[str] = []
        self.decided: list[str] = []
        self.unpauses = False
        self.defaults: dict[str, str] = {}
        self.required: set[str] = set()

    def words_of(self, word: Text, *, unknown: int) -> int:
        """Return the number of words that an argument has by default, or 2 if it gets several; 1 for other words."""
        if len(word) != 1 or word[0].kind != "arg":
            return 1
        name = word[0].text
        if name in self.target.split:
            return 2
        return (
            unknown
            if name in self.required or name not in self.defaults
            else len(words_of(parsed(self.defaults[name])))
        )

    def options_in(self, word: Text) -> list[str]:
        """Return the words that look like options in the default of an argument, also in its expression."""
        is_argument = len(word) == 1 and word[0].kind == "arg"
        return re.findall(r"(?<![\w.)-])-[A-Za-z_]\w*", self.defaults.get(word[0].text, "")) if is_argument else []

    def with_shell(self, action: Action) -> Action:
        """Return a node that is started by a shell if a word of its command line is several words by default, or none.

        roslaunch split the command line after it put the arguments in.
        """
        if all(self.words_of(word, unknown=1) == 1 for word in action.words):
            return action
        return action._replace(flags=(*action.flags, ("shell", "True")))

    def names_controllers(self, written: str) -> bool:
        """Return whether a file name is that of a controller file, by the defaults of the arguments in it."""
        return self.target.is_controllers_file(_ARGUMENT.sub(lambda one: self.defaults.get(one[1], one[0]), written))


_RENAMED = {
    ("rviz", "rviz"): ("rviz2", "rviz2"),
    ("rqt_gui", "rqt_gui"): ("rqt_gui", "rqt_gui"),
    ("robot_localization", "ekf_localization_node"): ("robot_localization", "ekf_node"),
    ("robot_localization", "ukf_localization_node"): ("robot_localization", "ukf_node"),
    ("robot_localization", "navsat_transform_node"): ("robot_localization", "navsat_transform_node"),
    ("map_server", "map_server"): ("nav2_map_server", "map_server"),
    ("amcl", "amcl"): ("nav2_amcl", "amcl"),
    ("teleop_twist_keyboard", "teleop_twist_keyboard.py"): ("teleop_twist_keyboard", "teleop_twist_keyboard"),
    ("urg_node", "urg_node"): ("urg_node", "urg_node_driver"),
    ("tf", "static_transform_publisher"): ("tf2_ros", "static_transform_publisher"),
    ("robot_state_publisher", "state_publisher"): ("robot_state_publisher", "robot_state_publisher"),
}
_ARGUMENT = re.compile(r"\$\(arg ([\w-]+)\)")
_DROPPED_WORDS = ("--shutdown-timeout", "--wait-for")
_SPAWNER_WORDS = {"--timeout": "--controller-manager-timeout", "--stopped": "--inactive"}
_SAME = frozenset(
    "diagnostic_aggregator image_view joint_state_publisher_gui joy rqt_controller_manager rqt_graph "
    "rqt_joint_trajectory_controller rqt_robot_steering teleop_twist_joy topic_tools twist_mux".split()
)
"""Packages of ROS 1 that exist for ROS 2, with programs of the same names."""
_ARGUMENTS = {"world": "world_name", "gui": "gui", "pause": "paused", "verbose": "verbose"}
"""The arguments of gazebo.launch.py, with their names in empty_world.launch of ROS 1."""
ARGUMENTS_OF_WORLD = tuple(_ARGUMENTS.values())
_POSES = ("-x", "-y", "-z", "-R", "-P", "-Y")
_OF_ROS1 = ("-urdf", "-sdf", "-unpause", "-wait", "-b")
"""Options of ROS 1's spawn_model that ROS 2's spawn_entity.py does not have, or has with another meaning."""


def migrated_node(reading: Notes, element: Element, description: Text, files: Sequence[Text]) -> Iterator[Action]:
    """Yield the actions for a node. What is left to a person is added to the reading."""
    package, program = element.attrs.get("pkg", ""), element.attrs.get("type", "")
    words = split_words(element.attrs.get("args", ""))
    reading.left += [*lost_attributes(element), *renamed_parameters(element)]
    if package in ("gazebo_ros", "controller_manager"):
        reading.left += lost_commands(element)
    if package == "controller_manager" and program == "unspawner":
        names = " ".join(plain(word) for word in words if is_literal(word))
        text = f"'unspawner {names}' waited, and stopped the controllers when it ended: ROS 2 has 'ros2 run "
        reading.left.append(f"{text}controller_manager unspawner {names}', which stops them at once")
    elif package == "controller_manager" and program in ("spawner", "controller_manager"):
        yield from _spawner(reading, element, words, files)
    elif package == "gazebo_ros" and program == "spawn_model":
        reading.unpauses |= any(plain(word) == "-unpause" for word in words)
        yield from [_spawned_model(reading, element, words)] if reading.target.started != "none" else []
    elif package == "gazebo_ros":
        yield from _program_of_classic(reading, element, words)
    elif package == "robot_state_publisher":
        yield state_publisher(element, reading.target.apart)._replace(description=description)
    elif package == "joint_state_publisher":
        yield _joint_states(element)
    elif package == "tf2_ros" or (package == "tf" and program == "static_transform_publisher"):
        yield _plain(element, "tf2_ros", program)._replace(words=tuple(transform_words(words, is_tf=package == "tf")))
    elif package in COMMANDS:
        yield from _command(reading, element, words)
    elif package in {"xacro", "nodelet"}:
        reading.left.append(f"nodes of package '{package}' have another form in ROS 2")
    else:
        yield _other_node(reading, element)


def _command(reading: Notes, element: Element, words: Sequence[Text]) -> Iterator[Action]:
    """A command of ROS 1; nothing if it is left to a person, because a node of no package ends the launch."""
    program = element.attrs.get("type", "")
    known = published(words, tuple(flags_of(element.attrs))) if program == "rostopic" else None
    if known is not None:
        yield known
    else:
        what = f"'{program} {element.attrs.get('args', '')}'".replace(" '", "'")
        reading.left.append(f"{what} is a command of ROS 1: start that of ROS 2 by ExecuteProcess")


def _other_node(reading: Notes, element: Element) -> Action:
    """A node of any other package, with what is left to a person."""
    package, program = element.attrs.get("pkg", ""), element.attrs.get("type", "")
    new = _RENAMED.get((package, program), (package, program))
    if not has_successor(element, reading.target.own | reading.target.renamed):
        reading.left.append(f"check that package '{package}' exists for ROS 2, and the name of '{program}'")
    for name in unread_parameters_of(element):
        what = f"parameter '{name}'" if name else "parameters of this <rosparam>"
        text = f"give node '{program}' its {what}: launch files of ROS 2 have no such form"
        reading.left.append(text)
    if new[0].startswith("nav2_") or package == "move_base":
        text = f"'{program}' is a lifecycle node of nav2 with other parameters: convert these, and let a "
        reading.left.append(f"{text}lifecycle_manager of nav2_lifecycle_manager configure and activate it")
    if package == "rviz":
        reading.decided.append("RViz 2 reads other files: convert the .rviz file with rviz1_to_rviz2.py")
    return _plain(element, *new)


def has_successor(node: Element, own: frozenset[str]) -> bool:
    """Return whether ROS 2 surely has the program of a node, or a package to migrate does."""
    package, program = node.attrs.get("pkg", ""), node.attrs.get("type", "")
    return (package, program) in _RENAMED or package in own | _SAME


def _plain(element: Element, package: str, program: str) -> Action:
    attrs = element.attrs
    children = element.elements()
    files = [parsed(one.attrs["file"]) for one in children if one.tagName == "rosparam" and "file" in one.attrs]
    remaps = [remapping(one) for one in children if one.tagName == "remap"]
    node = Action(
        "node",
        program,
        value=parsed(attrs["ns"]) if attrs.get("ns") else None,
        package=package,
        node_name=parsed(attrs.get("name", "")),
        words=split_words(attrs.get("args", "")),
        pairs=tuple((name, as_double(program, name, value)) for name, value in parameters_of(element)),
        files=tuple(files),
        remaps=tuple(remaps),
        flags=tuple(flags_of(attrs)),
        env=tuple(
            (one.attrs.get("name", ""), parsed(one.attrs.get("value", ""))) for one in children if one.tagName == "env"
        ),
    )
    return without_remappings(node)


def split_words(args: str) -> tuple[Text, ...]:
    """Return the words of the command line of a node, which roslaunch splits as a shell does."""
    return tuple(map(without_quotes, words_of(parsed(args))))


def remapping(element: Element) -> tuple[Text, Text]:
    """Return the old and the new name of a <remap>."""
    return parsed(element.attrs.get("from", "")), parsed(element.attrs.get("to", ""))


def _spawner(reading: Notes, element: Element, words: Sequence[Text], files: Sequence[Text]) -> Iterator[Action]:
    if element.attrs.get("type") == "controller_manager":
        verb = plain(words[0]) if words else ""
        if verb not in ("spawn", "load"):
            reading.left.append(f"'controller_manager {verb}' has no counterpart: use 'ros2 control'")
            return
        words = [*words[1:], *([literal("--inactive")] if verb == "load" else [])]
    named = [(word, reading.target.controllers_in(file_text(word))) for word in words]
    files = [*files, *(word for word, controllers in named if controllers)]
    names: list[Text] = []
    rest = iter(
        [each for word, controllers in named for each in (map(literal, controllers) if controllers else [word])]
    )
    space = parsed(element.attrs.get("ns", ""))
    for word in rest:
        written, value = _option(word)
        option = whole_option(written, SPAWNER_OPTIONS)
        if option in _SPAWNER_WORDS:
            names.append(literal(_SPAWNER_WORDS[option]))
            if option == "--timeout":
                names.append(next(rest, ()) if value is None else value)
        elif option == "--namespace":
            space = next(rest, ()) if value is None else value
        elif option in _DROPPED_WORDS:
            if value is None:
                next(rest, None)
        elif option == "__ns:":
            space = value or ()
        else:
            spawned = reading.target.spawned.get(full_name(element, plain(word))) if is_literal(word) else None
            last = word[-1].text.rpartition("/")[2] if word and word[-1].kind == "text" else ""
            if spawned is not None or (last and not is_literal(word) and "/" in word[-1].text):
                name = spawned.name if spawned is not None else last
                if spawned is None:
                    reading.decided.append(f"'{file_text(word)}' is spawned as '{name}': names have no slash in ROS 2")
                word = literal(name)  # noqa: PLW2901 (the same name in ROS 2)
            is_declared_elsewhere = option == OLD_NAME and DECLARED_IN in map(file_text, files)
            names.append(literal(NEW_NAME) if is_declared_elsewhere else word)
    manager = (
        [literal("-c"), joined(space, literal("/controller_manager"))]
        if plain(space).strip("/") or not is_literal(space)
        else []
    )
    known = tuple(file for file in files if reading.names_controllers(file_text(file)))
    flags = (("shell", "True"),) if any(reading.words_of(name, unknown=0) != 1 for name in names) else ()
    yield Action("node", "spawner", package="controller_manager", words=(*names, *manager), files=known, flags=flags)


def _option(word: Text) -> tuple[str, Text | None]:
    """The option that a word of a command line begins with, and the text after its equals sign; None without one."""
    first = word[0].text if word and word[0].kind == "text" else ""
    option, mark, value = first.partition("=")
    return option, joined(literal(value), word[1:]) if mark else None


def _spawned_model(reading: Notes, element: Element, words: Sequence[Text]) -> Action:
    target = reading.target
    shown: list[Text] = []
    rest = iter(words)
    for word in rest:
        option = plain(word) if is_literal(word) else ""
        if option == "-model":
            shown += [literal("-entity"), next(rest, ())]
        elif option == "-param":
            shown += words_for_parameter(target, element, next(rest, ()))
        elif option == "-file":
            shown += words_for_file(target, next(rest, ()))
        elif option in _POSES:
            shown += [literal(option), next(rest, ())]
        elif option in WITHOUT_SUCCESSOR:
            values = [next(rest, ()) for _ in range(WITHOUT_SUCCESSOR[option])]
            shown += [] if option in _OF_ROS1 else [word, *values]
        elif not option:
            lost = [one for one in reading.options_in(word) if one in WITHOUT_SUCCESSOR]
            shown += [] if lost else [word]
            reading.unpauses |= "-unpause" in lost
            told = [one for one in lost if one not in _OF_ROS1]
            if told:
                text = f"'{file_text(word)}' gave the spawner {', '.join(dict.fromkeys(told))}, which 'create' does not"
                reading.left.append(f"{text} have: set initial_value of the state interfaces instead of -J")
    space = element.attrs.get("ns")
    return Action(
        "node",
        SPAWN,
        value=parsed(space) if space else None,
        package=CLASSIC_PACKAGE,
        words=tuple(shown),
        flags=(("output", "screen"),),
    )


def _program_of_classic(reading: Notes, element: Element, words: Sequence[Text]) -> Iterator[Action]:
    if element.attrs.get("type") != CLIENT:
        reading.left += remapped_in_simulator(element) if reading.target.has_controllers else ()
        yield from simulator_actions(reading, given_to_simulator(element, words))
    elif reading.target.started != "none":
        yield Action("include", value=parsed(CLIENT_FILE))


def simulator_actions(reading: Notes, given: Mapping[str, Text]) -> Iterator[Action]:
    """Yield the action that starts Gazebo Classic with the arguments of gazebo_ros' empty_world.launch."""
    if reading.target.started != "none":
        named = ((new, given.get(old, ())) for new, old in _ARGUMENTS.items())
        yield Action("include", value=parsed(CLASSIC_FILE), pairs=tuple((new, value) for new, value in named if value))


def state_publisher(element: Element, apart: Collection[str] = ()) -> Action:
    """Return robot_state_publisher with the parameters that ROS 2 has (robot_state_publisher README).

    apart: the names of the parameters whose description has a topic of that name.
    """
    node = _plain(element, "robot_state_publisher", "robot_state_publisher")
    known = ("publish_frequency", "ignore_timestamp", "frame_prefix")
    pairs = [(name, value) for name, value in node.pairs if name in known]
    prefixes = [value for name, value in node.pairs if name == "tf_prefix" and value]
    pairs += [("frame_prefix", joined(value, literal("/"))) for value in prefixes]
    remaps = tuple(
        pair for pair in node.remaps if not names_description(pair[0]) or plain(pair[1]).rpartition("/")[2] in apart
    )
    return node._replace(pairs=tuple(pairs), remaps=remaps)


def description_publisher(target: LaunchTarget, element: Element) -> Action:
    """Return the node that publishes the description which a parameter sets."""
    description = description_command(element)
    space, _, last = element.attrs.get("name", "").rpartition("/")
    remaps = ((literal("robot_description"), literal(last)),) if last in target.apart else ()
    if target.publisher is not None:  # it is in a launch file without the description, and dropped there
        node = state_publisher(target.publisher)
        own = namespace_of(target.publisher)
        own_remaps = (*node.remaps, *remaps)
        return node._replace(value=parsed(f"/{own}") if own else None, description=description, remaps=own_remaps)
    return Action(
        "node",
        "robot_state_publisher",
        value=parsed(space) if space else None,
        package="robot_state_publisher",
        description=description,
        remaps=remaps,
    )


def _joint_states(element: Element) -> Action:
    """The publisher of joint states; with its window if `use_gui` asks for it."""
    gui = next((child for child in element.elements() if child.attrs.get("name", "").endswith("use_gui")), None)
    program = "joint_state_publisher"
    if gui is not None and gui.attrs.get("value", "").lower() in ("true", "1"):
        program = "joint_state_publisher_gui"
    node = _plain(element, program, program)
    return node._replace(pairs=tuple(pair for pair in node.pairs if not pair[0].endswith("use_gui")))
