"""UC210."""

from __future__ import annotations

from collections.abc import Iterator

from urdfctl.catalog.distros import ROS1
from urdfctl.rule import Finding, Note, Project, Severity, rule
from urdfctl.rules.common import is_known
from urdfctl.rules.transmissions.common import read_transmissions
from urdfctl.source.span import Place


@rule(
    "UC210",
    severity=Severity.WARNING,
    runtime="misbehaves",
    in_library=False,
    distros=ROS1,
    authority="ros_control transmission_interface/src/transmission_interface_loader.cpp looks up an "
    "actuator by its name: 'Actuator '<name>' does not expose the required hardware interface'",
    bad=[
        {
            "robot.urdf": """
                <transmission name="shoulder_trans">
                  <type>transmission_interface/SimpleTransmission</type>
                  <joint name="shoulder">
                    <hardwareInterface>hardware_interface/EffortJointInterface</hardwareInterface>
                  </joint>
                  <actuator name="motor1">
                    <mechanicalReduction>1</mechanicalReduction>
                  </actuator>
                </transmission>
                <transmission name="elbow_trans">
                  <type>transmission_interface/SimpleTransmission</type>
                  <joint name="elbow">
                    <hardwareInterface>hardware_interface/EffortJointInterface</hardwareInterface>
                  </joint>
                  <actuator name="«motor1»">
                    <mechanicalReduction>1</mechanicalReduction>
                  </actuator>
                </transmission>
            """,
        },
    ],
    good=[
        {
            "robot.urdf": """
                <transmission name="shoulder_trans">
                  <type>transmission_interface/SimpleTransmission</type>
                  <joint name="shoulder">
                    <hardwareInterface>hardware_interface/EffortJointInterface</hardwareInterface>
                  </joint>
                  <actuator name="shoulder_motor">
                    <mechanicalReduction>1</mechanicalReduction>
                  </actuator>
                </transmission>
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
def actuator_name_twice(project: Project) -> Iterator[Finding]:
    """Duplicate actuator name.

    Real hardware offers its actuators by name. Both transmissions then drive the same motor, and each overwrites the
    commands of the other. Gazebo's hardware simulation ignores actuators.
    """
    seen: dict[str, tuple[Place, str]] = {}
    for transmission in read_transmissions(project):
        for actuator in transmission.actuators:
            name = actuator.name
            if not name or not is_known(name):
                continue
            if name in seen:
                place, label = seen[name]
                message = f"actuator '{name}' of {transmission.label} has the same name as another actuator; rename one"
                yield Finding(actuator.at["name"], message, (Note(f"the first one is in {label}", place),))
            seen.setdefault(name, (actuator.at["name"], transmission.label))
