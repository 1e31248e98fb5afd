"""Inertias that no body can have: Gazebo Classic simulates them, gz rejects the whole robot."""

from __future__ import annotations

from collections.abc import Iterator, Mapping

from urdfctl.control.hardware.simulator_plugins import sure_simulator
from urdfctl.diagnostic import Edit
from urdfctl.migrate.edits.markup import attribute, element_at
from urdfctl.migrate.edits.places import ElementKey, key_of
from urdfctl.migrate.options import Part
from urdfctl.migrate.packages import MigratedPackages
from urdfctl.migrate.shared.hardware import simulated_by
from urdfctl.migrate.step import EntryKind, Proposal, ReportEntry, Row, Step
from urdfctl.rules.urdf.inertia import Moments, moments_of, principal_moments
from urdfctl.rules.urdf.numbers import MOMENTS
from urdfctl.source.span import SourceSpan
from urdfctl.source.xml.dom import Element

_AUTHORITY = "gz-math MassMatrix3::IsValid(), sdformat src/Link.cc: 'A link named ... has invalid inertia.'"
_TOLERANCE = 1e-6
"""Of gz-math, relative to the greatest principal moment."""
_MARGIN = 1e-3
"""By how much more than needed a moment is raised, so that it is enough after rounding."""
_DIAGONAL = ("ixx", "iyy", "izz")


def possible(moments: Moments) -> Moments | None:
    """Return moments that a body can have, with the principal axes of others that none can; None if one can.

    All principal moments are raised by the same amount, so that the greatest is at most the sum of the other two.
    """
    least, middle, most = principal_moments(moments)
    missing = max(-least, most - least - middle)
    if missing <= _TOLERANCE * max(abs(most), abs(least)):
        return None
    more = missing * (1 + _MARGIN)
    ixx, ixy, ixz, iyy, iyz, izz = moments
    return ixx + more, ixy, ixz, iyy + more, iyz, izz + more


def _inertias(packages: MigratedPackages) -> Iterator[Proposal]:
    for (path, start), links in _impossible(packages).items():
        element = element_at(packages.read(path), start) if packages.may_change(path) else None
        written = _written(element) if element is not None else None
        new = possible(written) if written else None
        if element is None or new is None:
            continue
        edits = tuple(_edits(element, dict(zip(MOMENTS, new, strict=True))))
        named = ", ".join(f"'{name}'" for name in sorted(links))
        message = f"no body has the <inertia> of link {named}, and gz rejects the robot: ixx, iyy and izz are raised"
        entry = ReportEntry(
            EntryKind.DECIDED, message, element.at, authority=_AUTHORITY, option="write the moments that were measured"
        )
        yield Proposal(edits, entries=(entry,), moves=frozenset(links))


def _impossible(packages: MigratedPackages) -> Mapping[ElementKey, set[str]]:
    """The names of the links whose inertia no body can have, by the element with the moments, of robots in Gazebo.

    Launch files may still start Gazebo Classic.
    """
    found: dict[ElementKey, set[str]] = {}
    for loaded in packages.loaded() if simulated_by(packages) == "gz" else ():
        robot = loaded.project.robot
        if robot is None or sure_simulator(loaded.project) is None:
            continue
        for link in robot.links:
            inertial = link.inertials[0] if link.inertials else None
            moments = moments_of(inertial)
            if inertial and inertial.inertia_at and moments and possible(moments):
                found.setdefault(key_of(inertial.inertia_at), set()).add(link.name or "")
    return found


def _written(element: Element) -> Moments | None:
    """The moments of an element as they are written; None if one is an expression, or missing."""
    try:
        ixx, ixy, ixz, iyy, iyz, izz = (float(attribute(element, name)) for name in MOMENTS)
    except ValueError:
        return None
    return ixx, ixy, ixz, iyy, iyz, izz


def _edits(element: Element, moments: Mapping[str, float]) -> Iterator[Edit]:
    tag = element.source.start_tag(element.start)
    for name in _DIAGONAL if tag is not None else ():
        assert tag is not None  # noqa: S101 (the loop is empty otherwise)
        yield Edit(SourceSpan(element.source, *tag.attributes[name]), f"{moments[name]:.6g}")


INERTIAS = Step(
    name="inertias",
    part=Part.URDF,
    summary="Inertias that no body can have",
    propose=_inertias,
    rows=(Row("<inertia> that no body can have", "the same axes with greater moments", "", _AUTHORITY),),
    before=[
        {
            "options": "--to=jazzy --simulator=gz",
            "config/controllers.yaml": """
                controller_manager:
                  ros__parameters:
                    update_rate: 100
                    states:
                      type: joint_state_broadcaster/JointStateBroadcaster
            """,
            "arm.xacro": """
                <robot name="arm" xmlns:xacro="http://www.ros.org/wiki/xacro">
                  <link name="base"/>
                  <link name="upper">
                    <inertial>
                      <mass value="1"/>
                      <inertia ixx="1.0" ixy="0" ixz="0" iyy="0.2" iyz="0" izz="0.3"/>
                    </inertial>
                  </link>
                  <joint name="elbow" type="continuous">
                    <parent link="base"/>
                    <child link="upper"/>
                  </joint>
                  <ros2_control name="arm" type="system">
                    <hardware>
                      <plugin>gz_ros2_control/GazeboSimSystem</plugin>
                    </hardware>
                    <joint name="elbow">
                      <command_interface name="position"/>
                      <state_interface name="position"/>
                    </joint>
                  </ros2_control>
                  <gazebo>
                    <plugin name="gz_ros2_control::GazeboSimROS2ControlPlugin" filename="gz_ros2_control-system">
                      <parameters>$(find arm)/config/controllers.yaml</parameters>
                    </plugin>
                  </gazebo>
                </robot>
            """,
        },
    ],
    after=[
        {
            "arm.xacro": """
                <robot name="arm" xmlns:xacro="http://www.ros.org/wiki/xacro">
                  <link name="base"/>
                  <link name="upper">
                    <inertial>
                      <mass value="1"/>
                      <inertia ixx="1.5005" ixy="0" ixz="0" iyy="0.7005" iyz="0" izz="0.8005"/>
                    </inertial>
                  </link>
                  <joint name="elbow" type="continuous">
                    <parent link="base"/>
                    <child link="upper"/>
                  </joint>
                  <ros2_control name="arm" type="system">
                    <hardware>
                      <plugin>gz_ros2_control/GazeboSimSystem</plugin>
                    </hardware>
                    <joint name="elbow">
                      <command_interface name="position"/>
                      <state_interface name="position"/>
                    </joint>
                  </ros2_control>
                  <gazebo>
                    <plugin name="gz_ros2_control::GazeboSimROS2ControlPlugin" filename="gz_ros2_control-system">
                      <parameters>$(find arm)/config/controllers.yaml</parameters>
                    </plugin>
                  </gazebo>
                </robot>
            """,
        },
    ],
)
