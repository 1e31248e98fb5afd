"""Actions of a launch file that start Gazebo Classic, and spawn robots in it, as actions that do so in gz."""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence

from urdfctl.generate.files.bringup import gz_names
from urdfctl.migrate.classic.initial_positions import joints_with_position
from urdfctl.migrate.classic.starting import EMPTY_WORLDS, OPTIONS, SPAWN, GzOption, create_options
from urdfctl.migrate.launch.actions import (
    Action,
    PartOfText,
    Text,
    all_actions,
    is_literal,
    joined,
    literal,
    parsed,
    plain,
)
from urdfctl.migrate.packages import MigratedPackages
from urdfctl.migrate.shared.bridge_file import bridge_file_of
from urdfctl.migrate.shared.install_rules import BRIDGE_FILE
from urdfctl.startup.records import NamedTuple

CLASSIC_PACKAGE = "gazebo_ros"
CLASSIC_FILE = f"$(find {CLASSIC_PACKAGE})/launch/gazebo.launch.py"
"""The launch file that starts Gazebo Classic in ROS 2."""
CLIENT_FILE = f"$(find {CLASSIC_PACKAGE})/launch/gzclient.launch.py"
"""The launch file that opens a window of a simulator which is started already."""
_EMPTY = "empty.sdf"


def gz_for(packages: MigratedPackages, path: str) -> Gz:
    """Return what the actions of a launch file need to know."""
    bridge = bridge_file_of(packages, path) or ""
    return Gz(gz_names(packages.options.target), bridge, frozenset(joints_with_position(packages)))


class Gz(NamedTuple):
    """What actions that start gz need to know.

    names: the names of the packages of gz in the distro.
    bridge: the package with the file for the bridge of the robot's topics; empty if there is none.
    placed: the joints whose position at the start is in the description.
    """

    names: Mapping[str, str]
    bridge: str
    placed: frozenset[str]

    def started(self, actions: Sequence[Action]) -> Iterator[Action]:
        """Yield the actions that start in gz what some actions start in Gazebo Classic; others as they are."""
        every = [one for one in all_actions(tuple(actions)) if starts_classic(one)]
        worlds = {part.text for one in every for part in dict(one.pairs).get("world", ()) if part.kind == "arg"}
        for action in actions:
            if action.kind == "group":
                yield action._replace(inner=tuple(self.started(action.inner)))
            elif action.kind == "argument" and action.value == () and action.name in worlds:
                yield action._replace(value=literal(_EMPTY))
            elif starts_classic(action):
                its = self._simulator(dict(action.pairs))
                yield from (one._replace(condition=action.condition) for one in its)
            elif action.kind == "include" and action.value == parsed(CLIENT_FILE):
                yield self._included(literal("-g"))._replace(condition=action.condition)
            elif is_spawner(action):
                yield self._spawner(action)
            elif action.kind == "argument" and action.value is not None:
                yield action._replace(value=_world(action.value))
            elif action.kind == "include":
                yield action._replace(pairs=tuple((name, _world(value)) for name, value in action.pairs))
            else:
                yield action

    def left(self, actions: Sequence[Action]) -> list[str]:
        """Return what a person must do, because a spawner of Gazebo Classic does it and that of gz does not."""
        joints = [joint for action in actions for joint in _placed_by(action)]
        known = (is_literal(joint) and plain(joint).rpartition("::")[2] in self.placed for joint in joints)
        return [] if all(known) else ["joint positions at the start: set initial_value of the state interfaces"]

    def _simulator(self, given: Mapping[str, Text]) -> Iterator[Action]:
        world = given.get("world", ())
        flags = joined(*(_option(option, given.get(option.argument, ())) for option in OPTIONS))
        is_empty = is_literal(world) and plain(world) in ("", *EMPTY_WORLDS)
        yield self._included(joined(flags, literal(_EMPTY) if is_empty else world))
        bridge = Action("node", "parameter_bridge", package=self.names["bridge"])
        if self.bridge:
            yield bridge._replace(pairs=(("config_file", parsed(f"$(find {self.bridge})/{BRIDGE_FILE}")),))
        else:
            yield bridge._replace(words=(literal(f"/clock@rosgraph_msgs/msg/Clock[{self.names['messages']}.Clock"),))

    def _included(self, options: Text) -> Action:
        """The action that starts gz with some options."""
        file = parsed(f"$(find {self.names['package']})/launch/{self.names['launch']}")
        return Action("include", value=file, pairs=((self.names["argument"], options),))

    def _spawner(self, action: Action) -> Action:
        words = [(plain(word) if is_literal(word) else "", word) for word in action.words]
        kept = (literal(text) if text else word for text, word in create_options(words))
        return action._replace(name="create", package=self.names["package"], words=tuple(kept))


def starts_classic(action: Action) -> bool:
    """Return whether an action includes the launch file of Gazebo Classic."""
    return action.kind == "include" and action.value == parsed(CLASSIC_FILE)


def is_spawner(action: Action) -> bool:
    """Return whether an action spawns a robot in Gazebo Classic."""
    return action.kind == "node" and (action.package, action.name) == (CLASSIC_PACKAGE, SPAWN)


def _placed_by(action: Action) -> Iterator[Text]:
    """The joints that a spawner places, also of those in a group."""
    for one in action.inner:
        yield from _placed_by(one)
    if is_spawner(action):
        at = (index for index, word in enumerate(action.words) if word == literal("-J"))
        yield from (joint for index in at for joint in action.words[index + 1 : index + 2])


def _option(option: GzOption, value: Text) -> Text:
    """An option of gz for the value of an argument of Gazebo Classic; its default if the value is not known here."""
    if len(value) == 1 and value[0].kind == "arg":
        return (PartOfText("eval", option.expression(f"arg('{value[0].text}')")),)
    return literal(option.given(plain(value) if is_literal(value) else ""))


def _world(value: Text) -> Text:
    """A value, which may be the empty world of Gazebo Classic."""
    return literal(_EMPTY) if is_literal(value) and plain(value) in EMPTY_WORLDS else value
