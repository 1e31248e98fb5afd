"""What ros2_control's parser takes: types of components, elements, words of ROS 1 and what became of them."""

from __future__ import annotations

from urdfctl.catalog.distros import ROS2, since

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

INTERFACE_ELEMENTS = ("command_interface", "state_interface")

_END = ("mechanical_reduction", "offset")
_PART = (*INTERFACE_ELEMENTS, "param")
ELEMENTS = {
    "hardware": ("plugin", "param"),
    "joint": _PART,
    "sensor": _PART,
    "gpio": _PART,
    "command_interface": ("param",),
    "state_interface": ("param",),
    "transmission": ("plugin", "joint", "actuator", "param"),
    "joint of a transmission": _END,
    "actuator of a transmission": _END,
}
"""That are read, by the element they stand in."""

ELEMENTS_FROM_JAZZY = {
    "hardware": ("group",),
    "joint": ("limits",),
    "sensor": ("limits",),
    "command_interface": ("limits",),
    "state_interface": ("limits",),
}
"""That are read from jazzy on, by the element they stand in."""

_NAMED: dict[str, tuple[str, ...]] = {"name": ROS2}
ATTRIBUTES: dict[str, dict[str, tuple[str, ...]]] = {
    "ros2_control": {
        "name": ROS2,
        "type": ROS2,
        "is_async": since("iron"),
        "rw_rate": since("jazzy"),
        "thread_priority": since("jazzy"),
    },
    "joint": {"name": ROS2, "mimic": since("jazzy")},
    "sensor": _NAMED,
    "gpio": _NAMED,
    "interface": {"name": ROS2, "data_type": since("jazzy"), "size": since("jazzy")},
    "gpio interface": {"name": ROS2, "data_type": ROS2, "size": ROS2},
    "param": _NAMED,
}
"""That are read, by the element, with the distros that read them."""

MOCK = "mock_components/GenericSystem"
