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
    in_library=False,
    distros=ROS1,
    authority="ros_control transmission_interface/src/transmission_parser.cpp keeps both: all that it and its "
    "loaders say of a transmission names it by its name, as in 'Failed to load transmission'",
    bad={
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
    good={
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
)
def transmission_name_twice(project: Project) -> Iterator[Finding]:
    """Two transmissions have one name.

    Nothing checks it, but all that ros_control says of a transmission names it so: one cannot tell which of them
    failed.
    """
    seen: dict[str, Place] = {}
    for transmission in read_transmissions(project):
        name = transmission.name
        if not name or not is_known(name):
            continue
        if name in seen:
            message = f"a second transmission is called '{name}': give each a name of its own"
            yield Finding(transmission.at["name"], message, (Note("the first one is here", seen[name]),))
        seen.setdefault(name, transmission.at["name"])
