"""Names that the parser of ros2_control knows: component types, elements and attributes; and ROS 1 interfaces."""

from __future__ import annotations

from urdfctl.catalog.distros import ROS2, since

TYPES = ("system", "actuator", "sensor")
"""The types of a component; case-sensitive."""

CHILDREN = ("hardware", "joint", "sensor", "gpio", "transmission", "properties")
"""The children of `<ros2_control>`; `<properties>` since jazzy."""

INTERFACES_OF_ROS1 = {
    "PositionJointInterface": "position",
    "VelocityJointInterface": "velocity",
    "EffortJointInterface": "effort",
}
"""The ROS 2 interface for each hardware interface of ROS 1."""

DATA_TYPES = ("double", "bool", "float32", "uint8", "int8", "uint16", "int16", "uint32", "int32")
"""The data types of an interface, since jazzy (hardware_info.hpp)."""

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
"""The children that the parser reads, by element."""

ELEMENTS_FROM_JAZZY = {
    "hardware": ("group",),
    "joint": ("limits",),
    "sensor": ("limits",),
    "command_interface": ("limits",),
    "state_interface": ("limits",),
}
"""The children that the parser reads since jazzy, by element."""

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
    "hardware": {},
}
"""The attributes that the parser reads, by element, each with the distros that read it."""

MOCK = "mock_components/GenericSystem"
"""The plugin of mock hardware."""
