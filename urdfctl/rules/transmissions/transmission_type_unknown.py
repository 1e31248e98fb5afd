"""UC205."""

from __future__ import annotations

from collections.abc import Iterator

from urdfctl.catalog.distros import since
from urdfctl.names import is_slip, nearest
from urdfctl.rule import Finding, Fix, Project, Severity, rule
from urdfctl.rules.common import is_known
from urdfctl.rules.transmissions.common import in_place_of, listed, on_hardware, read_transmissions
from urdfctl.rules.transmissions.facts import NO_PLUGIN_TYPES, PACKAGE, TYPES


@rule(
    "UC205",
    severity=Severity.WARNING,
    runtime="refuses",
    because="only the loader of real hardware does",
    distros=since("indigo"),
    authority="ros_control transmission_interface/src/transmission_interface_loader.cpp: 'Unsupported type'",
    bad=[
        {
            "robot.urdf": """
                <transmission name="elbow_trans">
                  <type>«SimpleTransmission»</type>
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
                  <type>«transmission_interface/SimpleTransmision»</type>
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
            "options": "--distro=noetic --simulator=none",
            "robot.urdf": """
                <transmission name="elbow_trans">
                  <type>«hardware_interface/ChainTransmission»</type>
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
                  <type>«pr2_mechanism_model/ChainTransmission»</type>
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
                  <type>«transmission_interface::FourBarLinkageTransmission»</type>
                  <joint name="elbow">
                    <hardwareInterface>hardware_interface/EffortJointInterface</hardwareInterface>
                  </joint>
                  <actuator name="elbow_motor">
                    <mechanicalReduction>1</mechanicalReduction>
                  </actuator>
                </transmission>
                <transmission name="x">
                  <type>«DifferentialTransmission»</type>
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
                  <type>my_robot/BeltTransmission</type>
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
def transmission_type_unknown(project: Project) -> Iterator[Finding]:
    """Unknown transmission type.

    Gazebo's hardware simulation ignores the type. On real hardware, the loader stops at this transmission, and does not
    load the later ones either. Types of other packages may be plugins of those packages, and are not reported.
    """
    for transmission in read_transmissions(project):
        kind = transmission.type
        if kind is None or not kind.value or kind.value in TYPES or not is_known(kind.value):
            continue
        right = _meant(kind.value)
        if right is None and "/" in kind.value and not kind.value.startswith(NO_PLUGIN_TYPES):
            continue
        hint = f"did you mean '{right}'?" if right else f"ros_control knows {listed(TYPES)}"
        message = f"unknown type '{kind.value}' of {transmission.label}; {hint}"
        fix = Fix(f"write '{right}'", in_place_of(kind, right), safe=is_slip(kind.value, right)) if right else None
        yield Finding(kind.at.content, message, fix=fix, severity=on_hardware(project))


def _meant(text: str) -> str | None:
    package, _, short = text.replace("::", "/").rpartition("/")
    if package and f"{package}/" not in NO_PLUGIN_TYPES and nearest(package, [PACKAGE.rstrip("/")]) is None:
        return None
    shorts = {known.removeprefix(PACKAGE): known for known in TYPES}
    return shorts.get(short) or shorts.get(nearest(short, shorts) or "")
