"""The `<transmission>`s of ROS 1, and the older form of the PR2."""

from __future__ import annotations

from urdfctl.model.parts import Tag, Text
from urdfctl.record import NamedTuple
from urdfctl.source.span import Place


class TransmissionEnd(NamedTuple):
    """What a transmission's joint and its actuator have in common.

    `interfaces`, `reductions` and `offsets` hold every such child, empty ones too; `others` the children that no reader
    asks for.
    """

    name: str | None
    at: Place
    role: Text | None
    interfaces: tuple[Text, ...]
    reductions: tuple[Text, ...]
    offsets: tuple[Text, ...]
    others: tuple[Tag, ...]

    @property
    def named_interfaces(self) -> tuple[Text, ...]:
        """The interfaces that ros_control's parser keeps: those with a text."""
        return tuple(interface for interface in self.interfaces if interface.value)


TransmissionJoint = TransmissionEnd
Actuator = TransmissionEnd


class Transmission(NamedTuple):
    """One `<transmission>`. `type` is its first `<type>` child; `type_attribute` belongs to the PR2's form.

    `parent` is the name of the element it stands in: ros_control reads children of the root element only.
    """

    name: str | None
    at: Place
    type: Text | None
    type_attribute: str | None
    joints: tuple[TransmissionJoint, ...]
    actuators: tuple[Actuator, ...]
    others: tuple[Tag, ...]
    parent: str

    @property
    def is_pr2(self) -> bool:
        """Whether this is the old form `<transmission type="...">` of pr2_mechanism_model, which ros_control skips."""
        return self.type_attribute is not None and self.type is None and not self._has_interfaces

    @property
    def _has_interfaces(self) -> bool:
        return any(end.interfaces for end in (*self.joints, *self.actuators))

    @property
    def label(self) -> str:
        """What a message calls it: `transmission 'x'`, or the joint's name where it has none of its own."""
        if self.name:
            return f"transmission '{self.name}'"
        joint = next((joint.name for joint in self.joints if joint.name), None)
        return f"the transmission of joint '{joint}'" if joint else "a transmission"

    @property
    def kept_joints(self) -> tuple[TransmissionJoint, ...]:
        """The joints that ros_control's parser keeps: named, and with an interface (transmission_parser.cpp)."""
        return tuple(joint for joint in self.joints if joint.name and joint.named_interfaces)
