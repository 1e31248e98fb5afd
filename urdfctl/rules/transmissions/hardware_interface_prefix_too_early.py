"""UC226."""

from __future__ import annotations

from collections.abc import Iterator

from urdfctl.catalog.distros import until
from urdfctl.rule import Finding, Fix, Project, Severity, rule
from urdfctl.rules.transmissions.common import in_gazebo, in_place_of, named_joints, takes_prefix
from urdfctl.rules.transmissions.facts import GAZEBO_INTERFACES, PREFIX


@rule(
    "UC226",
    severity=Severity.ERROR,
    distros=until("jade"),
    authority="gazebo_ros_pkgs gazebo_ros_control/src/default_robot_hw_sim.cpp (hydro to jade): 'No matching "
    "hardware interface found for'",
    options=("--distro=indigo", "--simulator=gazebo-classic"),
    bad={
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
    good={
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
)
def hardware_interface_prefix_too_early(project: Project) -> Iterator[Finding]:
    """A hardware interface is named with `hardware_interface/` in a distro whose Gazebo does not know the prefix.

    Up to jade, Gazebo's hardware simulation knows the bare names only: it stops, and there is no controller manager
    at all. The loader of real hardware wants the prefix.
    """
    severity = in_gazebo(project)
    if severity is None or takes_prefix(project):
        return
    for transmission, joint, name in named_joints(project):
        for interface in joint.named_interfaces:
            right = interface.value.removeprefix(PREFIX)
            if right != interface.value and right in GAZEBO_INTERFACES:
                message = (
                    f"the interface '{interface.value}' of joint '{name}' of {transmission.label} has a prefix that "
                    f"Gazebo takes from kinetic on: up to jade it is '{right}'"
                )
                fix = Fix(f"write '{right}'", in_place_of(interface, right))
                yield Finding(interface.at.content, message, fix=fix, severity=severity)
