"""What the elements of a roslaunch file say by themselves, without what is around them."""

from __future__ import annotations

import re
from collections.abc import Collection, Iterator

from urdfctl.model.launch.parts import Simulation, Word
from urdfctl.model.launch.scope import Substitutions
from urdfctl.names import nearest
from urdfctl.source.xml.dom import Element

_ONLY_IN_ROS_2 = frozenset("let executable timer node_container load_composable_node push_ros_namespace".split())
"""Elements that roslaunch does not have."""
_USED = r"\$\(arg\s+([\w-]+)\s*\)"
_OF_WORLD = frozenset(
    "debug enable_ros_network extra_gazebo_args gui gui_required headless output paused physics pub_clock_frequency "
    "recording required respawn_gazebo server_required use_clock_frequency use_sim_time verbose world_name".split()
)
"""The arguments of gazebo_ros/launch/empty_world.launch, indigo to noetic."""


def is_of_ros2(root: Element) -> bool:
    """Return whether a launch file in XML is for ROS 2, by its attributes, elements or substitutions."""
    for element in all_elements(root):
        if "exec" in element.attrs or "namespace" in element.attrs or element.tagName in _ONLY_IN_ROS_2:
            return True
        if any("$(var " in value or "$(find-pkg-share " in value for value in element.attrs.values()):
            return True
    return False


def all_elements(element: Element) -> Iterator[Element]:
    """Yield an element and all elements in it, in no particular order."""
    pending = [element]
    while pending:
        current = pending.pop()
        yield current
        pending.extend(current.elements())


def held_of(element: Element, texts: Substitutions) -> bool | None:
    """Return whether the condition of an element is true; None if unknown."""
    if "if" in element.attrs:
        return texts.truth(element.attrs["if"])
    if "unless" in element.attrs:
        truth = texts.truth(element.attrs["unless"])
        return None if truth is None else not truth
    return True


def declared_in(root: Element) -> frozenset[str]:
    """Return the names of all arguments that a launch file declares, wherever it does; not those that it passes on."""
    outer = (each for each in all_elements(root) if each.tagName != "include")
    inner = (child for each in outer for child in each.elements())
    return frozenset(child.attrs.get("name", "") for child in inner if child.tagName == "arg")


def undeclared_in(element: Element, declared: Collection[str], names: Collection[str]) -> Iterator[Word]:
    """Yield the arguments whose values some attributes of an element use, but which are not declared."""
    for name in names:
        for used in re.finditer(_USED, element.attrs[name]):
            if used[1] not in declared:
                yield Word(used[1], next(iter(element.at[name].words([used[0]]))))


def makes_urdf(element: Element) -> bool:
    """Return whether the value of a parameter comes from xacro or a URDF file."""
    command = element.attrs.get("command", "")
    return "xacro" in command or element.attrs.get("textfile", "").endswith(".urdf")


def not_declared(
    element: Element, declared: Collection[str], *, passes_all: bool
) -> tuple[list[Word], list[tuple[Word, str]]]:
    """Return the arguments for an included file that it does not declare, and those with the one that is meant.

    passes_all: whether the including file passes all that it has: then roslaunch accepts what is not declared.
    """
    arguments = (child for child in element.elements() if child.tagName == "arg" and "name" in child.attrs)
    given = {child.attrs["name"]: Word(child.attrs["name"], child.at["name"]) for child in arguments}
    strays = [word for name, word in given.items() if name not in declared]
    if not passes_all:
        return strays, []
    left = set(declared).difference(given)
    return [], [(word, meant) for word in strays if (meant := nearest(word.text, left)) is not None]


def strays_of_world(element: Element) -> list[Word]:
    """Return the arguments that gazebo_ros's launch file of a world does not declare in any distro."""
    if not element.attrs.get("file", "").endswith("gazebo_ros)/launch/empty_world.launch"):
        return []
    given = (child for child in element.elements() if child.tagName == "arg" and "name" in child.attrs)
    return [Word(arg.attrs["name"], arg.at["name"]) for arg in given if arg.attrs["name"] not in _OF_WORLD]


def world_of(element: Element, texts: Substitutions, *, sure: bool) -> Simulation | None:
    """Return the simulator that an included launch file of Gazebo starts; None if that starts none."""
    if "world" not in element.attrs.get("file", ""):
        return None
    arguments = [child for child in element.elements() if child.tagName == "arg"]
    given = [argument for argument in arguments if argument.attrs.get("name") == "paused"]
    paused = texts.truth(given[-1].attrs.get("value", "")) if given else False
    at = given[-1].at if given else element.at
    clocks = [child for child in arguments if child.attrs.get("name") == "use_sim_time" and child.attrs.get("value")]
    clock = Word(texts.resolve(clocks[-1].attrs["value"]), clocks[-1].at["value"]) if clocks else None
    return Simulation("gazebo-classic", at, paused, sure, clock)
