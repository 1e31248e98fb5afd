"""The parts of a launch file: texts, descriptions, parameters, spawners, nodes and simulators, each with its place."""

from __future__ import annotations

from typing import TYPE_CHECKING

from urdfctl.source.lengths import MOST_CHARACTERS
from urdfctl.source.opaque import UNKNOWN
from urdfctl.source.span import Place
from urdfctl.startup.records import NamedTuple

if TYPE_CHECKING:
    from urdfctl.model.controllers import FileReference
    from urdfctl.source.yaml.tree import Mapping

# Fields of the same meaning in all classes:
# sure: False if it depends on an unknown condition.
# namespace: empty at the root; None if unknown.
# A text that is not fully known contains UNKNOWN.


class Word(NamedTuple):
    """A text with its place, such as a name or an argument of a program."""

    text: str
    at: Place

    @property
    def known(self) -> str | None:
        """The text; None if it is not fully known."""
        return None if UNKNOWN in self.text else self.text


class Description(NamedTuple):
    """A robot description that is set on the parameter server or passed to a node.

    file: the URDF or xacro file.
    arguments: the arguments for xacro, whose values may be unknown; None if it is unknown which ones are given.
    names: the names of all arguments, known or not.
    command: the command that prints it; None if there is none.
    node: executable of the node that gets it; None for the parameter server.
    in_node: ROS 1: the namespace is a node's own name.
    alternatives: other arguments that it may have, where an unknown condition decides.
    more: whether other arguments may be given too, which are not known.
    as_yaml: ROS 2: whether launch parses the text as YAML, because nothing says that it is a string.
    edited: ROS 2: whether the launch file replaces parts of the text, such as comments.
    by_xacro: whether xacro expands the file, whatever its name is.
    """

    file: FileReference
    arguments: tuple[tuple[str, str], ...] | None
    namespace: str | None
    at: Place
    sure: bool = True
    names: tuple[Word, ...] = ()
    command: str | None = None
    node: str | None = None
    in_node: bool = False
    alternatives: tuple[tuple[tuple[str, str], ...], ...] = ()
    as_yaml: bool = False
    more: bool = False
    edited: bool = False
    by_xacro: bool = False

    @property
    def usable(self) -> bool:
        """Whether its file exists, and its arguments are known by name."""
        return bool(self.file.exists) and self.arguments is not None


class Rewriting(NamedTuple):
    """How a launch file rewrites a parameter file before a node gets it.

    texts: texts that are replaced anywhere (`ReplaceString`, `$(var ...)`), with what replaces them.
    values: values by their keys (`RewrittenYaml`).
    root: the key that everything is put below; empty if there is none.
    """

    texts: tuple[tuple[str, str], ...] = ()
    values: tuple[tuple[str, str], ...] = ()
    root: str = ""


UNCHANGED = Rewriting()


class ParameterLoad(NamedTuple):
    """A YAML file whose parameters are loaded.

    namespace: ROS 1: the namespace that the parameters are loaded into. ROS 2: empty; the file names its nodes.
    in_node: ROS 1: the namespace is a node's own name.
    node: ROS 2: executable of the node that gets the file.
    of: ROS 2: namespace of that node.
    rewriting: how the launch file rewrites the file.
    substituted: ROS 1: whether `$(...)` in the file is evaluated.
    """

    file: FileReference
    namespace: str | None
    at: Place
    sure: bool = True
    in_node: bool = False
    node: str | None = None
    of: str | None = None
    rewriting: Rewriting = UNCHANGED
    substituted: bool = False


class InlineParameters(NamedTuple):
    """Parameters that a ROS 1 launch file itself contains, in <param value="..."> or <rosparam>.

    namespace: what they are loaded into, and for <param> the name before the last slash.
    name: the parameter that has the value; empty if the text is a map of parameters in YAML.
    at: the text, as YAML.
    """

    namespace: str
    name: str
    at: Place
    sure: bool = True


class GivenParameters(NamedTuple):
    """Parameters that a ROS 2 launch file gives a controller manager in a dict.

    document: as launch writes them for the node.
    at: the dict.
    of: namespace of the node; None if unknown.
    """

    document: Mapping
    at: Place
    sure: bool = True
    of: str | None = None


class ProgramOption(NamedTuple):
    """An option of a program, as written, with its value; None if it has no value."""

    name: str
    value: Word | None
    at: Place


class Spawn(NamedTuple):
    """A spawner.

    names: the controllers with their places.
    namespace: the namespace of their manager.
    active: False if the controllers are loaded, but not started.
    complete: False if some of its arguments are unknown.
    manager: the manager's name without namespace; None if unknown.
    program: `spawner`, `spawner.py`, or the verb of `ros2 control`.
    options: the options with their values.
    files: the parameter files that it gets.
    after: controllers whose spawner exits before this one starts.
    """

    names: tuple[tuple[str, Place], ...]
    namespace: str | None
    at: Place
    active: bool = True
    sure: bool = True
    complete: bool = True
    manager: str | None = "controller_manager"
    program: Word | None = None
    options: tuple[ProgramOption, ...] = ()
    files: tuple[FileReference, ...] = ()
    after: tuple[str, ...] = ()

    def full_name(self, name: str) -> str:
        """Return the name of one of the controllers with its namespace; as it is if that is unknown.

        A name that begins with a slash is absolute: controller_manager.cpp makes its NodeHandle below the manager's.
        """
        return name if self.namespace is None or name.startswith("/") else f"{self.namespace}/{name}"

    def option(self, *names: str) -> ProgramOption | None:
        """Return the first option with one of these names, if any."""
        return next((option for option in self.options if option.name in names), None)


class Node(NamedTuple):
    """A node that is started.

    name: None if not given or unknown.
    namespace: the full namespace.
    words: its command-line arguments.
    parameters: the names of its parameters.
    values: the texts of its single parameters by name.
    remaps: pairs of the old and the new name of a topic.
    complete: False if some arguments, parameters or remappings are unknown.
    files: the parameter files that it gets.
    """

    package: Word
    executable: Word
    name: str | None
    namespace: str | None
    at: Place
    words: tuple[Word, ...] = ()
    parameters: tuple[Word, ...] = ()
    remaps: tuple[tuple[str, str], ...] = ()
    sure: bool = True
    complete: bool = True
    files: tuple[Word, ...] = ()
    values: tuple[tuple[str, str], ...] = ()

    def runs(self, package: str, *executables: str) -> bool:
        """Return whether it runs one of these executables of a package."""
        return self.package.text == package and self.executable.text in executables


class Started(NamedTuple):
    """What an action starts: a program, and the controllers that it spawns."""

    program: str
    controllers: tuple[str, ...] = ()


class Waiting(NamedTuple):
    """What never starts, because it waits for an event that never comes.

    what: what waits.
    target: what it waits for.
    at: the event handler.
    event: the name of the event handler.
    is_started: whether the target starts. Then it is its exit that never comes, before the launch ends.
    """

    what: tuple[Started, ...]
    target: Started
    at: Place
    event: str
    is_started: bool


class Simulation(NamedTuple):
    """A simulator that is started.

    simulator: `gz` or `gazebo-classic`.
    paused: whether it starts paused; None if unknown.
    clock: ROS 1: the value of use_sim_time; None if not given.
    """

    simulator: str
    at: Place
    paused: bool | None = None
    sure: bool = True
    clock: Word | None = None


WEBOTS = ("webots_ros2_driver", "webots")
"""The package that starts Webots, and the program as which it is known here."""
FILE_ENDINGS = (".rviz", ".vcg", ".world", ".sdf", ".yaml", ".yml", ".urdf", ".xacro", ".srdf")
"""How a text ends that is taken for a file where a program, a parameter or an included launch file gets it."""


class LaunchedFile(NamedTuple):
    """A file that the launch file uses.

    use: `description`, `parameters`, `include`, `text` (ROS 1: its content is a parameter's value) or `argument`.
    has_siblings: whether it should be there: its folder has other files of its kind, or is missing too.
    package: the package that contains it; None if unknown.
    """

    file: FileReference
    use: str
    package: str | None = None
    sure: bool = True
    has_siblings: bool = False


def joined(namespace: str, name: str) -> str:
    """Return a name in a namespace, joined as launch files do; empty for the root, UNKNOWN if part of it is unknown, or
    it is longer than any name.
    """
    if UNKNOWN in name or len(namespace) + len(name) > MOST_CHARACTERS:
        return UNKNOWN
    full = name if name.startswith("/") else f"{namespace}/{name}"
    return UNKNOWN if UNKNOWN in full else "".join(f"/{part}" for part in full.split("/") if part)
