"""UC315."""

from __future__ import annotations

from collections.abc import Iterator

from urdfctl.rule import Finding, Project, Severity, rule
from urdfctl.rules.common import is_all_there, is_known, severity_where
from urdfctl.rules.ros2_control.common import JAZZY, component, followers


@rule(
    "UC315",
    severity=Severity.ERROR,
    runtime="refuses",
    distros=JAZZY,
    authority="ros2_control hardware_interface/src/component_parser.cpp: \"Mimic joint 'elbow' not found in "
    '<ros2_control> tag"',
    in_library=False,
    options=["--distro=jazzy"],
    bad=[
        {
            "robot.urdf": """
                <link name="finger"/>
                <joint name="grip" type="prismatic">
                  <parent link="fore"/><child link="finger"/>
                  <limit lower="0" upper="0.1" effort="1" velocity="1"/><mimic joint="elbow"/>
                </joint>
                <ros2_control name="gripper" type="system">
                  <hardware><plugin>mock_components/GenericSystem</plugin></hardware>
                  <joint name="«grip»"><state_interface name="position"/></joint>
                </ros2_control>
            """,
        },
    ],
    good=[
        {
            "robot.urdf": """
                <ros2_control name="arm" type="system">
                  <hardware><plugin>mock_components/GenericSystem</plugin></hardware>
                  <joint name="elbow">
                    <command_interface name="position"/>
                    <state_interface name="position"/>
                  </joint>
                </ros2_control>
            """,
        },
    ],
)
def mimicked_joint_not_in_component(project: Project) -> Iterator[Finding]:
    """Mimicked joint is not in the same component.

    Since jazzy, the URDF's `<mimic>` is used. The mimicked joint must be in the same `<ros2_control>`, or the
    controller manager rejects the description.
    """
    for joint, (control, mimicked) in followers(project):
        names = {(other.name or "").strip() for other in control.of_kind("joint")}
        if not is_known(mimicked, *names) or mimicked in names or not is_all_there(project, control.tag):
            continue
        message = f"joint '{joint.name}' mimics '{mimicked}', which is not in {component(control)}; add it there"
        yield Finding(joint.at["name"], message, severity=severity_where(project, JAZZY))
