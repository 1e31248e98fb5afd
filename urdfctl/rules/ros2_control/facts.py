"""What ros2_control's parser takes: types of components, elements, words of ROS 1 and what became of them."""

from __future__ import annotations

TYPES = ("system", "actuator", "sensor")
"""Of a component, in exactly these letters."""

CHILDREN = ("hardware", "joint", "sensor", "gpio", "transmission", "properties")
"""Of `<ros2_control>`; `<properties>` from jazzy on."""

INTERFACES_OF_ROS1 = {
    "PositionJointInterface": "position",
    "VelocityJointInterface": "velocity",
    "EffortJointInterface": "effort",
}
"""What ROS 2 calls the hardware interfaces of ROS 1."""

DATA_TYPES = ("double", "bool", "float32", "uint8", "int8", "uint16", "int16", "uint32", "int32")
"""Of interfaces, from jazzy on (hardware_info.hpp)."""
