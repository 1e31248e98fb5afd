"""UC203."""

from __future__ import annotations

from collections.abc import Iterator

from urdfctl.catalog.distros import since
from urdfctl.control.hardware.gazebo_ros1 import GAZEBO_INTERFACES, in_gazebo
from urdfctl.model.robot import ElementText
from urdfctl.names import is_slip, nearest
from urdfctl.rule import Finding, Fix, Project, Severity, rule
from urdfctl.rules.common import is_known
from urdfctl.rules.transmissions.common import in_place_of, listed, named_joints, with_prefix
from urdfctl.rules.transmissions.facts import HARDWARE_INTERFACES, PACKAGE, PREFIX, ROS2_WORDS


@rule(
    "UC203",
    severity=Severity.ERROR,
    runtime="refuses",
    distros=since("indigo"),
    authority="gazebo_ros_pkgs gazebo_ros_control/src/default_robot_hw_sim.cpp: 'No matching hardware interface "
    "found for'; ros_control transmission_interface/src/transmission_interface_loader.cpp: 'Failed to "
    "process the '",
    bad=[
        {
            "robot.urdf": """
                <transmission name="elbow_trans">
                  <type>transmission_interface/SimpleTransmission</type>
                  <joint name="elbow">
                    <hardwareInterface>«hardware_interface/effortJointInterface»</hardwareInterface>
                  </joint>
                  <actuator name="elbow_motor">
                    <mechanicalReduction>1</mechanicalReduction>
                  </actuator>
                </transmission>
            """,
        },
        {
            "options": "--distro=noetic",
            "robot.urdf": """
                <transmission name="elbow_trans">
                  <type>transmission_interface/SimpleTransmission</type>
                  <joint name="elbow">
                    <hardwareInterface>«hardware_interface/jointStateInterface»</hardwareInterface>
                    <hardwareInterface>«hardware_interface/posVelJointInterface»</hardwareInterface>
                    <hardwareInterface>«hardware_interface/posVelAccJointInterface»</hardwareInterface>
                    <hardwareInterface>«hardware_interface/positionVelocityTorqueGainsJointInterface»</hardwareInterface>
                    <hardwareInterface>«hardware_interface/jointModeInterface»</hardwareInterface>
                    <hardwareInterface>«hardware_interface/biDirectionalPositionJointInterface»</hardwareInterface>
                    <hardwareInterface>«hardware_interface/biDirectionalVelocityJointInterface»</hardwareInterface>
                    <hardwareInterface>«hardware_interface/biDirectionalEffortJointInterface»</hardwareInterface>
                    <hardwareInterface>«hardware_interface/jointTrajectoryInterface»</hardwareInterface>
                    <hardwareInterface>«hardware_interface/cartesianTrajectoryInterface»</hardwareInterface>
                  </joint>
                  <actuator name="elbow_motor">
                    <mechanicalReduction>1</mechanicalReduction>
                  </actuator>
                </transmission>
            """,
        },
        {
            "options": "--distro=noetic",
            "robot.urdf": """
                <transmission name="elbow_trans">
                  <type>transmission_interface/SimpleTransmission</type>
                  <joint name="elbow">
                    <hardwareInterface>«effort»</hardwareInterface>
                    <hardwareInterface>«hardware_interface::PositionJointInterface»</hardwareInterface>
                    <hardwareInterface>«velocity»</hardwareInterface>
                    <hardwareInterface>«position»</hardwareInterface>
                  </joint>
                  <actuator name="elbow_motor">
                    <mechanicalReduction>1</mechanicalReduction>
                  </actuator>
                </transmission>
            """,
        },
        {
            "options": "--distro=noetic --simulator=gazebo-classic",
            "robot.urdf": """
                <transmission name="elbow_trans">
                  <type>transmission_interface/SimpleTransmission</type>
                  <joint name="elbow">
                    <hardwareInterface>«hardware_interface/PosVelJointInterface»</hardwareInterface>
                  </joint>
                  <actuator name="elbow_motor">
                    <mechanicalReduction>1</mechanicalReduction>
                  </actuator>
                </transmission>
            """,
        },
        {
            "options": "--distro=noetic --simulator=gazebo-classic",
            "robot.urdf": """
                <transmission name="elbow_trans">
                  <type>transmission_interface/SimpleTransmission</type>
                  <joint name="elbow">
                    <hardwareInterface>«my_robot/ForceInterface»</hardwareInterface>
                  </joint>
                  <actuator name="elbow_motor">
                    <mechanicalReduction>1</mechanicalReduction>
                  </actuator>
                </transmission>
            """,
        },
        {
            "options": "--distro=noetic --simulator=none",
            "robot.urdf": """
                <transmission name="elbow_trans">
                  <type>transmission_interface/SimpleTransmission</type>
                  <joint name="elbow">
                    <hardwareInterface>«hardware_interface/ForceInterface»</hardwareInterface>
                  </joint>
                  <actuator name="elbow_motor">
                    <mechanicalReduction>1</mechanicalReduction>
                  </actuator>
                </transmission>
            """,
        },
    ],
    good=[
        {
            "robot.urdf": """
                <transmission name="elbow_trans">
                  <type>transmission_interface/SimpleTransmission</type>
                  <joint name="elbow">
                    <hardwareInterface>hardware_interface/EffortJointInterface</hardwareInterface>
                  </joint>
                  <actuator name="elbow_motor">
                    <mechanicalReduction>1</mechanicalReduction>
                  </actuator>
                </transmission>
            """,
        },
        {
            "options": "--distro=noetic",
            "robot.urdf": """
                <transmission name="elbow_trans">
                  <type>transmission_interface/SimpleTransmission</type>
                  <joint name="elbow">
                    <hardwareInterface>hardware_interface/PosVelJointInterface</hardwareInterface>
                  </joint>
                  <actuator name="elbow_motor">
                    <mechanicalReduction>1</mechanicalReduction>
                  </actuator>
                </transmission>
            """,
        },
    ],
)
def hardware_interface_unknown(project: Project) -> Iterator[Finding]:
    """Unknown hardware interface.

    Gazebo's hardware simulation knows three interfaces. At any other it stops, and there is no controller manager. The
    loader of real hardware skips the interface. Interfaces of other packages need the hardware of those packages.
    """
    for transmission, joint, name in named_joints(project):
        for index, interface in enumerate(joint.named_interfaces):
            meant = _meant(interface.value)
            severity = _severity(project, interface, meant, first=index == 0)
            if severity is None or not is_known(interface.value):
                continue
            right = with_prefix(meant, project) if meant else None
            interface_label = f"interface '{interface.value}' of joint '{name}' of {transmission.label}"
            message = (
                f"unknown {interface_label}; did you mean '{right}'?"
                if right
                else f"{interface_label} {_unknown_to(project)}"
            )
            is_sure = right is not None and is_slip(interface.value, right)
            fix = Fix(f"write '{right}'", in_place_of(interface, right), is_sure) if right else None
            yield Finding(interface.at.content, message, fix=fix, severity=severity)


def _unknown_to(project: Project) -> str:
    known = listed(with_prefix(short, project) for short in GAZEBO_INTERFACES)
    reader = "Gazebo's hardware simulation" if project.may_be_simulated else "ros_control"
    return f"is unknown to {reader}, which knows {known}"


def _severity(project: Project, interface: ElementText, meant: str | None, *, first: bool) -> Severity | None:
    """None if the interface is known or cannot be checked. Gazebo reads only a joint's first interface."""
    short = interface.value.removeprefix(PREFIX)
    simulated = in_gazebo(project) if first else None
    if short in GAZEBO_INTERFACES:
        return None
    if short in HARDWARE_INTERFACES:
        return simulated if simulated is Severity.ERROR else None
    if meant is None and "/" in interface.value and not interface.value.startswith((PREFIX, PACKAGE)):
        return _of_another_package(project) if simulated is Severity.ERROR else None
    if simulated is Severity.ERROR or (project.named_simulator == "none" and first):
        return Severity.ERROR
    if project.named_simulator == "gazebo-classic":
        return None
    return Severity.ERROR if meant and first and project.named_simulator is None else Severity.WARNING


def _of_another_package(project: Project) -> Severity:
    return Severity.ERROR if project.named_simulator == "gazebo-classic" else Severity.INFO


def _meant(text: str) -> str | None:
    """The interface most likely meant: wrong case or spelling, `::`, a wrong package, or the ROS 2 name."""
    if text.removeprefix(PREFIX) in HARDWARE_INTERFACES:
        return None
    package, slash, short = text.replace("::", "/").rpartition("/")
    own = (PREFIX.rstrip("/"), PACKAGE.rstrip("/"))
    if slash and package not in own and nearest(package, own) is None:
        return None
    known = (*GAZEBO_INTERFACES, *HARDWARE_INTERFACES)
    return ROS2_WORDS.get(short.lower()) or (short if short in known else nearest(short, known))
