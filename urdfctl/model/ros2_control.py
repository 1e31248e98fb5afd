"""The `<ros2_control>` components of ROS 2."""

from __future__ import annotations

from typing import NamedTuple

from urdfctl.model.parts import Tag, Text
from urdfctl.source.span import Place


class Parameter(NamedTuple):
    """A `<param name="...">value</param>`."""

    name: str | None
    value: str
    at: Place


class Interface(NamedTuple):
    """A `<command_interface>` or `<state_interface>`."""

    name: str | None
    at: Place
    parameters: tuple[Parameter, ...]


class Part(NamedTuple):
    """A `<joint>`, `<sensor>` or `<gpio>` of a component (`kind`)."""

    kind: str
    name: str | None
    at: Place
    commands: tuple[Interface, ...]
    states: tuple[Interface, ...]
    parameters: tuple[Parameter, ...]
    others: tuple[Tag, ...]


class Hardware(NamedTuple):
    """The `<hardware>` element: every `<plugin>` it names, and its parameters."""

    at: Place
    plugins: tuple[Text, ...]
    parameters: tuple[Parameter, ...]
    others: tuple[Tag, ...]


class Ros2Control(NamedTuple):
    """One `<ros2_control>` tag, `transmissions` and `others` as they are; `parent` is the element it stands in."""

    name: str | None
    type: str | None
    at: Place
    hardware: tuple[Hardware, ...]
    parts: tuple[Part, ...]
    transmissions: tuple[Tag, ...]
    others: tuple[Tag, ...]
    parent: str
