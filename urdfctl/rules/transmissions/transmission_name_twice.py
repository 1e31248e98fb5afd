"""UC209."""

from __future__ import annotations

from collections.abc import Iterator

from urdfctl.catalog.distros import ROS1
from urdfctl.rule import Finding, Note, Project, Severity, rule
from urdfctl.rules.common import is_known
from urdfctl.rules.transmissions.common import read_transmissions
from urdfctl.source.span import Place


@rule(
    "UC209",
    severity=Severity.WARNING,
    runtime="works",
    because="log messages do not tell the two apart",
    in_library=False,
    distros=ROS1,
    authority="ros_control transmission_interface/src/transmission_parser.cpp keeps both; its messages and "
    "those of its loaders identify a transmission by its name, as in 'Failed to load transmission'",
    bad=[
        {
            "robot.urdf": """
                <transmission name="tran1">
                  <type>transmission_interface/SimpleTransmission</type>
                  <joint name="shoulder">
                    <hardwareInterface>hardware_interface/EffortJointInterface</hardwareInterface>
                  </joint>
                  <actuator name="shoulder_motor">
                    <mechanicalReduction>1</mechanicalReduction>
                  </actuator>
                </transmission>
                <transmission name="«tran1»">
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
def transmission_name_twice(project: Project) -> Iterator[Finding]:
    """Duplicate transmission name.

    Nothing checks it, but ros_control's messages identify a transmission by its name. They do not show which of the two
    failed.
    """
    seen: dict[str, Place] = {}
    for transmission in read_transmissions(project):
        name = transmission.name
        if not name or not is_known(name):
            continue
        if name in seen:
            message = f"transmission '{name}' is already defined; give each transmission its own name"
            yield Finding(transmission.at["name"], message, (Note("first defined here", seen[name]),))
        seen.setdefault(name, transmission.at["name"])
