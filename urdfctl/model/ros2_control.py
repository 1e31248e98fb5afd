"""The `<ros2_control>` components of ROS 2."""

from __future__ import annotations

from collections.abc import Iterator

from urdfctl.model.parts import Tag, Text
from urdfctl.record import NamedTuple
from urdfctl.source.span import Place


class Parameter(NamedTuple):
    """A `<param name="...">value</param>`; ros2_control reads the value past a comment."""

    name: str | None
    value: str
    at: Place
    tag: Tag


class Interface(NamedTuple):
    """A `<command_interface>` or `<state_interface>` (`kind`: command or state)."""

    kind: str
    name: str | None
    at: Place
    parameters: tuple[Parameter, ...]
    tag: Tag

    @property
    def element(self) -> str:
        """The name of its element."""
        return self.tag.name

    def parameter(self, name: str) -> Parameter | None:
        """The parameter of a name: of several the last, as the parser has it."""
        return _last(self.parameters, name)


class Part(NamedTuple):
    """A `<joint>`, `<sensor>` or `<gpio>` of a component (`kind`)."""

    kind: str
    name: str | None
    at: Place
    commands: tuple[Interface, ...]
    states: tuple[Interface, ...]
    parameters: tuple[Parameter, ...]
    others: tuple[Tag, ...]
    tag: Tag

    @property
    def interfaces(self) -> tuple[Interface, ...]:
        """All its interfaces, command interfaces first, as the parser reads them."""
        return self.commands + self.states

    def parameter(self, name: str) -> Parameter | None:
        """The parameter of a name: of several the last, as the parser has it."""
        return _last(self.parameters, name)


class Hardware(NamedTuple):
    """The `<hardware>` element: every `<plugin>` it names, and its parameters."""

    at: Place
    plugins: tuple[Text, ...]
    parameters: tuple[Parameter, ...]
    others: tuple[Tag, ...]
    tag: Tag

    @property
    def plugin(self) -> str | None:
        """The class that is loaded: that of the first `<plugin>`; None where there is none."""
        return self.plugins[0].past_comments if self.plugins else None

    def parameter(self, name: str) -> Parameter | None:
        """The parameter of a name: of several the last, as the parser has it."""
        return _last(self.parameters, name)


class ControlTransmissionEnd(NamedTuple):
    """A `<joint>` or `<actuator>` (`kind`) of a transmission of ROS 2; of its numbers the first is read."""

    kind: str
    name: str | None
    role: str | None
    at: Place
    reductions: tuple[Text, ...]
    offsets: tuple[Text, ...]
    tag: Tag


class ControlTransmission(NamedTuple):
    """A `<transmission>` inside `<ros2_control>`: the form of ROS 2, or that of ROS 1 at a wrong place."""

    name: str | None
    at: Place
    plugins: tuple[Text, ...]
    joints: tuple[ControlTransmissionEnd, ...]
    actuators: tuple[ControlTransmissionEnd, ...]
    parameters: tuple[Parameter, ...]
    tag: Tag

    @property
    def is_ros1(self) -> bool:
        """Whether it is written as ROS 1 has it: with a `<type>`, or a `<hardwareInterface>` at its ends."""
        if self.plugins:
            return False
        ends = (*self.joints, *self.actuators)
        return any(self.tag.named("type")) or any(any(end.tag.named("hardwareInterface")) for end in ends)


class Ros2Control(NamedTuple):
    """One `<ros2_control>` tag: a hardware component. `others` are the children it does not know; `parent` is the name
    of the element it stands in."""

    name: str | None
    type: str | None
    at: Place
    hardware: tuple[Hardware, ...]
    parts: tuple[Part, ...]
    transmissions: tuple[ControlTransmission, ...]
    others: tuple[Tag, ...]
    parent: str
    tag: Tag

    def of_kind(self, kind: str) -> Iterator[Part]:
        """Its joints, sensors or gpios."""
        return (part for part in self.parts if part.kind == kind)

    @property
    def plugin(self) -> str | None:
        """The class that is loaded: a second `<hardware>` replaces the first; None where no element names one."""
        return self.hardware[-1].plugin if self.hardware else None


def _last(parameters: tuple[Parameter, ...], name: str) -> Parameter | None:
    return next((parameter for parameter in reversed(parameters) if parameter.name == name), None)
