"""UC226."""

from __future__ import annotations

from collections.abc import Iterator

from urdfctl.catalog.distros import until
from urdfctl.control.hardware.gazebo_ros1 import GAZEBO_INTERFACES, in_gazebo
from urdfctl.rule import Finding, Fix, Project, Severity, rule
from urdfctl.rules.transmissions.common import in_place_of, named_joints, takes_prefix
from urdfctl.rules.transmissions.facts import PREFIX


@rule(
    "UC226",
    severity=Severity.ERROR,
    runtime="refuses",
    distros=until("jade"),
    authority="gazebo_ros_pkgs gazebo_ros_control/src/default_robot_hw_sim.cpp (hydro to jade): 'No matching "
    "hardware interface found for'",
    options=("--distro=indigo", "--simulator=gazebo-classic"),
    bad=[
        {
            "robot.urdf": """
                <transmission name="elbow_trans">
                  <type>transmission_interface/SimpleTransmission</type>
                  <joint name="elbow">
                    <hardwareInterface>«hardware_interface/EffortJointInterface»</hardwareInterface>
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
                    <hardwareInterface>EffortJointInterface</hardwareInterface>
                  </joint>
                  <actuator name="elbow_motor">
                    <mechanicalReduction>1</mechanicalReduction>
                  </actuator>
                </transmission>
            """,
        },
    ],
)
def hardware_interface_prefix_too_early(project: Project) -> Iterator[Finding]:
    """Hardware interface with the prefix `hardware_interface/` before kinetic.

    Up to jade, Gazebo's hardware simulation knows only the bare names. It stops, and there is no controller manager.
    The loader of real hardware requires the prefix.
    """
    severity = in_gazebo(project)
    if severity is None or takes_prefix(project):
        return
    for transmission, joint, name in named_joints(project):
        for interface in joint.named_interfaces:
            right = interface.value.removeprefix(PREFIX)
            if right != interface.value and right in GAZEBO_INTERFACES:
                message = (
                    f"interface '{interface.value}' of joint '{name}' of {transmission.label} has a prefix, which "
                    f"Gazebo accepts only from kinetic on; use '{right}'"
                )
                fix = Fix(f"write '{right}'", in_place_of(interface, right))
                yield Finding(interface.at.content, message, fix=fix, severity=severity)
