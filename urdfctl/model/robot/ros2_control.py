"""The model of `<ros2_control>` components (ROS 2)."""

from __future__ import annotations

from collections.abc import Iterator

from urdfctl.model.robot.parts import ElementText, Tag
from urdfctl.source.span import Place
from urdfctl.startup.records import NamedTuple


class HardwareParameter(NamedTuple):
    """A `<param name="...">value</param>`. Like ros2_control, `value` skips comments before the text."""

    name: str | None
    value: str
    at: Place
    tag: Tag


class Interface(NamedTuple):
    """A `<command_interface>` or `<state_interface>`; `kind` is `command` or `state`."""

    kind: str
    name: str | None
    at: Place
    parameters: tuple[HardwareParameter, ...]
    tag: Tag

    @property
    def element(self) -> str:
        """The name of the XML element."""
        return self.tag.name

    def parameter(self, name: str) -> HardwareParameter | None:
        """Return the last parameter with a name, which is the one that ros2_control uses."""
        return _last(self.parameters, name)


class ComponentPart(NamedTuple):
    """A `<joint>`, `<sensor>` or `<gpio>` of a component.

    kind: `joint`, `sensor` or `gpio`.
    commands, states: the command and state interfaces.
    others: the remaining child elements.
    """

    kind: str
    name: str | None
    at: Place
    commands: tuple[Interface, ...]
    states: tuple[Interface, ...]
    parameters: tuple[HardwareParameter, ...]
    others: tuple[Tag, ...]
    tag: Tag

    @property
    def interfaces(self) -> tuple[Interface, ...]:
        """All interfaces, with the command interfaces first, as the parser reads them."""
        return self.commands + self.states

    def parameter(self, name: str) -> HardwareParameter | None:
        """Return the last parameter with a name, which is the one that ros2_control uses."""
        return _last(self.parameters, name)


class Hardware(NamedTuple):
    """A `<hardware>` element.

    plugins: the texts of all `<plugin>` elements; only the first is used.
    others: the remaining child elements.
    """

    at: Place
    plugins: tuple[ElementText, ...]
    parameters: tuple[HardwareParameter, ...]
    others: tuple[Tag, ...]
    tag: Tag

    @property
    def plugin(self) -> str | None:
        """The class that is loaded: the first `<plugin>`; None if there is none."""
        return self.plugins[0].past_comments if self.plugins else None

    def parameter(self, name: str) -> HardwareParameter | None:
        """Return the last parameter with a name, which is the one that ros2_control uses."""
        return _last(self.parameters, name)


class ControlTransmissionEnd(NamedTuple):
    """A `<joint>` or `<actuator>` of a ROS 2 transmission.

    kind: `joint` or `actuator`.
    reductions, offsets: all `<mechanical_reduction>` and `<offset>` elements; only the first of each is used.
    """

    kind: str
    name: str | None
    role: str | None
    at: Place
    reductions: tuple[ElementText, ...]
    offsets: tuple[ElementText, ...]
    tag: Tag


class ControlTransmission(NamedTuple):
    """A `<transmission>` inside `<ros2_control>`: in the ROS 2 form, or misplaced in the ROS 1 form."""

    name: str | None
    at: Place
    plugins: tuple[ElementText, ...]
    joints: tuple[ControlTransmissionEnd, ...]
    actuators: tuple[ControlTransmissionEnd, ...]
    parameters: tuple[HardwareParameter, ...]
    tag: Tag

    @property
    def is_ros1(self) -> bool:
        """Whether it has the ROS 1 form: a `<type>`, or a `<hardwareInterface>` in a joint or actuator."""
        if self.plugins:
            return False
        ends = (*self.joints, *self.actuators)
        return any(self.tag.named("type")) or any(any(end.tag.named("hardwareInterface")) for end in ends)


class Ros2Control(NamedTuple):
    """A `<ros2_control>` element: one hardware component.

    type: `system`, `actuator` or `sensor`.
    hardware: all `<hardware>` elements; only the last is used.
    parts: the joints, sensors and gpios.
    others: child elements that ros2_control does not know.
    parent: name of the parent element.
    """

    name: str | None
    type: str | None
    at: Place
    hardware: tuple[Hardware, ...]
    parts: tuple[ComponentPart, ...]
    transmissions: tuple[ControlTransmission, ...]
    others: tuple[Tag, ...]
    parent: str
    tag: Tag

    def of_kind(self, kind: str) -> Iterator[ComponentPart]:
        """Return the parts of one kind: `joint`, `sensor` or `gpio`."""
        return (part for part in self.parts if part.kind == kind)

    @property
    def plugin(self) -> str | None:
        """The class that is loaded, from the last `<hardware>` element; None if that names none."""
        return self.hardware[-1].plugin if self.hardware else None


def _last(parameters: tuple[HardwareParameter, ...], name: str) -> HardwareParameter | None:
    return next((parameter for parameter in reversed(parameters) if parameter.name == name), None)
