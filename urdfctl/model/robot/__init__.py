"""The model of a robot description: what its URDF says, each part with its place."""

from __future__ import annotations

from urdfctl.model.robot.parts import Number, Reference, Tag, Text, leading_number, text_of
from urdfctl.model.robot.robot import Geometry, Inertial, Joint, Limit, Link, Mesh, MeshFile, Mimic, Plugin, Robot
from urdfctl.model.robot.ros2_control import (
    ControlTransmission,
    ControlTransmissionEnd,
    Hardware,
    Interface,
    Parameter,
    Part,
    Ros2Control,
)
from urdfctl.model.robot.transmission import Transmission, TransmissionEnd

__all__ = [
    "ControlTransmission",
    "ControlTransmissionEnd",
    "Geometry",
    "Hardware",
    "Inertial",
    "Interface",
    "Joint",
    "Limit",
    "Link",
    "Mesh",
    "MeshFile",
    "Mimic",
    "Number",
    "Parameter",
    "Part",
    "Plugin",
    "Reference",
    "Robot",
    "Ros2Control",
    "Tag",
    "Text",
    "Transmission",
    "TransmissionEnd",
    "leading_number",
    "text_of",
]
