"""UC202."""

from __future__ import annotations

from collections.abc import Iterator

from urdfctl.catalog.distros import since
from urdfctl.control.hardware.gazebo_ros1 import GAZEBO_INTERFACES, in_gazebo
from urdfctl.rule import Finding, Fix, Project, Severity, rule
from urdfctl.rules.transmissions.common import in_place_of, named_joints, on_hardware
from urdfctl.rules.transmissions.facts import HARDWARE_INTERFACES, PREFIX


@rule(
    "UC202",
    runtime="warns",
    severity=Severity.WARNING,
    distros=since("kinetic"),
    authority="gazebo_ros_pkgs gazebo_ros_control/src/default_robot_hw_sim.cpp: 'Deprecated syntax, please prepend "
    "'hardware_interface/' to'; ros_control transmission_interface/src/transmission_interface_loader.cpp: "
    "'It contains no valid hardware interfaces.'",
    bad=[
        {
            "robot.urdf": """
                <transmission name="elbow_trans">
                  <type>transmission_interface/SimpleTransmission</type>
                  <joint name="elbow">
                    <hardwareInterface>«EffortJointInterface»</hardwareInterface>
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
    ],
)
def hardware_interface_without_prefix(project: Project) -> Iterator[Finding]:
    """Hardware interface without the prefix `hardware_interface/`.

    From kinetic on, Gazebo's hardware simulation accepts the bare name with a deprecation warning. The loader of real
    hardware looks up the name as a plugin and does not find it. It loads neither this transmission nor the later ones.
    """
    known = set(GAZEBO_INTERFACES)
    if in_gazebo(project) is not Severity.ERROR:
        known.update(HARDWARE_INTERFACES)
    certain = set(project.distros) <= set(since("kinetic"))
    for transmission, joint, name in named_joints(project):
        for interface in joint.named_interfaces:
            if interface.value in known:
                right = PREFIX + interface.value
                message = (
                    f"interface '{interface.value}' of joint '{name}' of {transmission.label} has no prefix; "
                    f"from kinetic on, use '{right}'"
                )
                fix = Fix(f"write '{right}'", in_place_of(interface, right), safe=certain)
                yield Finding(interface.at.content, message, fix=fix, severity=on_hardware(project))
