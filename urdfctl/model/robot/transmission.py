"""The model of ROS 1 `<transmission>` elements, including the older PR2 form."""

from __future__ import annotations

from urdfctl.model.robot.parts import ElementText, Tag
from urdfctl.source.span import Place
from urdfctl.startup.records import NamedTuple


class TransmissionEnd(NamedTuple):
    """A `<joint>` or `<actuator>` of a transmission.

    role: text of `<role>`; None if missing.
    interfaces, reductions, offsets: all `<hardwareInterface>`, `<mechanicalReduction>` and `<offset>` elements,
        including empty ones.
    others: child elements that no reader uses.
    tag: the element with its attributes.
    """

    name: str | None
    at: Place
    role: ElementText | None
    interfaces: tuple[ElementText, ...]
    reductions: tuple[ElementText, ...]
    offsets: tuple[ElementText, ...]
    others: tuple[Tag, ...]
    tag: Tag

    @property
    def named_interfaces(self) -> tuple[ElementText, ...]:
        """The interfaces that are not empty; ros_control's parser keeps only these."""
        return tuple(interface for interface in self.interfaces if interface.value)


TransmissionJoint = TransmissionEnd
Actuator = TransmissionEnd


class Transmission(NamedTuple):
    """A `<transmission>` element.

    type: text of the first `<type>` child; None if missing.
    type_attribute: the attribute `type`, which the PR2 form uses.
    others: the remaining child elements.
    parent: name of the parent element; ros_control reads only children of the root element.
    tag: the element with its attributes.
    """

    name: str | None
    at: Place
    type: ElementText | None
    type_attribute: str | None
    joints: tuple[TransmissionJoint, ...]
    actuators: tuple[Actuator, ...]
    others: tuple[Tag, ...]
    parent: str
    tag: Tag

    @property
    def is_pr2(self) -> bool:
        """Whether it has the form `<transmission type="...">` of pr2_mechanism_model, which ros_control skips."""
        return self.type_attribute is not None and self.type is None and not self._has_interfaces

    @property
    def _has_interfaces(self) -> bool:
        return any(end.interfaces for end in (*self.joints, *self.actuators))

    @property
    def label(self) -> str:
        """Its name in messages: `transmission 'x'`; the transmission of its joint if it has no name."""
        if self.name:
            return f"transmission '{self.name}'"
        joint = next((joint.name for joint in self.joints if joint.name), None)
        return f"the transmission of joint '{joint}'" if joint else "a transmission"

    @property
    def kept_joints(self) -> tuple[TransmissionJoint, ...]:
        """The joints with a name and an interface; ros_control's parser keeps only these (transmission_parser.cpp)."""
        return tuple(joint for joint in self.joints if joint.name and joint.named_interfaces)
