"""The programs of gazebo_ros that a launch file of ROS 1 starts as nodes: the simulator, its server or its window."""

from __future__ import annotations

from collections.abc import Iterator, Sequence

from urdfctl.migrate.classic.starting import OPTIONS_WITH_VALUE
from urdfctl.migrate.edits.markup import elements
from urdfctl.migrate.launch.actions import Text, is_literal, literal, parsed, plain
from urdfctl.migrate.ros1.roslaunch_values import root_around
from urdfctl.source.xml.dom import Element

SERVERS = ("gazebo", "gzserver", "debug", "gdbrun", "perf")
"""The programs of gazebo_ros in ROS 1 that start a simulator."""
CLIENT = "gzclient"
_WITH_WINDOW = "gazebo"
_FLAGS = {"-u": "paused", "--pause": "paused", "--verbose": "verbose"}
_Value = tuple[str, Element | None]
"""A value, and the <arg> that gives it; None if it is written where it is used."""


def programs_of(node: Element) -> frozenset[str]:
    """Return the programs that a node may be: the values of the argument that is its type, or that alone."""
    return frozenset(text for text, _ in _values(node, parsed(node.attrs.get("type", ""))))


def given_to_simulator(node: Element, words: Sequence[Text]) -> dict[str, Text]:
    """Return the arguments of gazebo_ros' empty_world.launch that mean what the command line of a node does.

    An argument in it may stand for an option, as in the copies of that file.
    """
    programs = programs_of(node)
    given = {"gui": literal("false")} if programs and programs <= {*SERVERS} - {_WITH_WINDOW} else {}
    worlds, empty = [], []
    rest = iter(words)
    for word in rest:
        values = list(_values(node, word))
        texts = [text for text, _ in values]
        if any(text in OPTIONS_WITH_VALUE for text in texts):
            next(rest, None)
        elif texts and not any(texts):
            empty.append(word)
        elif not texts or not all(text.startswith("-") for text in filter(None, texts)):
            worlds.append(word)
        for text, argument in values:
            if text in _FLAGS:
                given[_FLAGS[text]] = _condition_of(argument)
    world = next(iter([*worlds, *reversed(empty)]), None)
    return {**given, "world_name": world} if world is not None else given


def _values(node: Element, word: Text) -> Iterator[_Value]:
    """Yield the values that a word may have by default; nothing if one is not known."""
    if is_literal(word):
        yield plain(word), None
    elif len(word) == 1 and word[0].kind == "arg":
        given = [one for one in elements(root_around(node)) if _gives(one, word[0].text)]
        texts = [one.attrs.get("value", one.attrs.get("default", "$(")) for one in given]
        if not any("$(" in text for text in texts):
            yield from zip(texts, given, strict=True)


def _gives(element: Element, argument: str) -> bool:
    """Whether an element is an <arg> of the file with that name, and not the value that an include passes on."""
    outer = element.parentNode
    is_passed = isinstance(outer, Element) and outer.tagName == "include"
    return element.tagName == "arg" and element.attrs.get("name") == argument and not is_passed


def _condition_of(argument: Element | None) -> Text:
    """When an option is given: on the condition of the argument that has it, or always."""
    return parsed(argument.attrs.get("if", "true")) if argument is not None else literal("true")
