"""Interfaces that Gazebo's default hardware simulation of ROS 1 offers, according to the transmissions.

gazebo_ros_control/src/default_robot_hw_sim.cpp: for each transmission that ros_control's parser keeps, the only joint
is registered with the JointStateInterface, and with the first interface that it names. Real hardware registers whatever
its driver implements.
"""

from __future__ import annotations

from collections.abc import Iterator

from urdfctl.control.hardware.interfaces import UNKNOWN_HARDWARE, Offer, OfferedHardware, by_component, fixed_joints
from urdfctl.model.robot import ElementText, Robot, Transmission
from urdfctl.source.opaque import UNKNOWN
from urdfctl.startup.records import NamedTuple

PREFIX = "hardware_interface/"
JOINT_STATES = f"{PREFIX}JointStateInterface"


class _Registered(NamedTuple):
    joint: str
    interface: ElementText


def simulated_hardware(robot: Robot) -> OfferedHardware:
    """Return the interfaces that the simulation offers of a robot's joints."""
    if any(_is_unknown(transmission) for transmission in robot.transmissions):
        return UNKNOWN_HARDWARE
    registered = [each for transmission in robot.transmissions for each in _registered(transmission)]
    command = by_component(
        Offer(each.joint, _qualified(each.interface.value), each.interface.at) for each in registered
    )
    state = by_component(Offer(each.joint, JOINT_STATES, each.interface.at) for each in registered)
    return OfferedHardware(command, state, joints=frozenset(robot.joint_names), fixed=fixed_joints(robot))


def _registered(transmission: Transmission) -> Iterator[_Registered]:
    """The joint of a transmission, if the simulation uses it: it has a type, an actuator and exactly one joint."""
    kept = transmission.kept_joints
    actuators = any(actuator.name for actuator in transmission.actuators)
    if transmission.type is None or not transmission.type.value or not actuators or len(kept) != 1:
        return
    yield _Registered(kept[0].name or "", kept[0].named_interfaces[0])


def _is_unknown(transmission: Transmission) -> bool:
    texts = [text.value for joint in transmission.joints for text in joint.interfaces]
    return any(UNKNOWN in (text or "") for text in (*texts, *(joint.name for joint in transmission.joints)))


def _qualified(interface: str) -> str:
    return interface if "/" in interface else PREFIX + interface
