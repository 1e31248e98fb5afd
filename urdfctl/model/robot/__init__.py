"""The model of a robot description: what its URDF says, each part with its place."""

from __future__ import annotations

from urdfctl.model.robot.parts import ElementText, Number, PartReference, Tag, leading_number, text_of
from urdfctl.model.robot.robot import Geometry, Inertial, Joint, Limit, Link, Mesh, MeshFile, Mimic, Plugin, Robot
from urdfctl.model.robot.ros2_control import (
    ComponentPart,
    ControlTransmission,
    ControlTransmissionEnd,
    Hardware,
    HardwareParameter,
    Interface,
    Ros2Control,
)
from urdfctl.model.robot.transmission import Transmission, TransmissionEnd

__all__ = [
    "ComponentPart",
    "ControlTransmission",
    "ControlTransmissionEnd",
    "ElementText",
    "Geometry",
    "Hardware",
    "HardwareParameter",
    "Inertial",
    "Interface",
    "Joint",
    "Limit",
    "Link",
    "Mesh",
    "MeshFile",
    "Mimic",
    "Number",
    "PartReference",
    "Plugin",
    "Robot",
    "Ros2Control",
    "Tag",
    "Transmission",
    "TransmissionEnd",
    "leading_number",
    "text_of",
]
