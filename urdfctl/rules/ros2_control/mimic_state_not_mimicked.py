"""UC360."""

from __future__ import annotations

from collections.abc import Iterator

from urdfctl.rule import Finding, Project, Severity, rule
from urdfctl.rules.common import is_all_there, is_known, severity_where
from urdfctl.rules.ros2_control.common import JAZZY, followers, known_hardware
from urdfctl.rules.ros2_control.facts import MOCK


@rule(
    "UC360",
    severity=Severity.ERROR,
    runtime="refuses",
    distros=JAZZY,
    authority="measured with jazzy's mock_components/GenericSystem: \"The requested state interface not found: "
    "'elbow/velocity'\", thrown during the first read",
    options=["--distro=jazzy"],
    bad=[
        {
            "robot.urdf": """
                <link name="finger"/>
                <joint name="grip" type="prismatic">
                  <parent link="fore"/><child link="finger"/>
                  <limit lower="-1" upper="1" effort="1" velocity="1"/><mimic joint="elbow"/>
                </joint>
                <ros2_control name="arm" type="system">
                  <hardware><plugin>mock_components/GenericSystem</plugin></hardware>
                  <joint name="elbow"><command_interface name="position"/><state_interface name="position"/></joint>
                  <joint name="grip">
                    <state_interface name="position"/>
                    «<state_interface name="velocity"/>»
                  </joint>
                </ros2_control>
            """,
        },
    ],
    good=[
        {
            "robot.urdf": """
                <link name="finger">
                  <inertial><mass value="1"/><inertia ixx="0.01" ixy="0" ixz="0" iyy="0.01" iyz="0" izz="0.01"/></inertial>
                </link>
                <joint name="grip" type="prismatic">
                  <parent link="fore"/><child link="finger"/>
                  <limit lower="-1" upper="1" effort="1" velocity="1"/><mimic joint="elbow"/>
                </joint>
                <ros2_control name="arm" type="system">
                  <hardware><plugin>mock_components/GenericSystem</plugin></hardware>
                  <joint name="elbow"><command_interface name="position"/><state_interface name="position"/></joint>
                  <joint name="grip"><state_interface name="position"/></joint>
                </ros2_control>
            """,
        },
    ],
)
def mimic_state_not_mimicked(project: Project) -> Iterator[Finding]:
    """Mimic joint of mock hardware has a state that the mimicked joint lacks.

    Since jazzy, mock hardware copies each state from the mimicked joint. At the first read it does not find this one
    and is deactivated.
    """
    for joint, (control, mimicked) in followers(project):
        if not any(each.type == MOCK for each in known_hardware(project, control)) or not is_all_there(
            project, control.tag
        ):
            continue
        sources = [other for other in control.of_kind("joint") if (other.name or "").strip() == mimicked]
        mirrored = {(state.name or "").strip() for source in sources for state in source.states}
        for state in joint.states if sources else ():
            name = (state.name or "").strip()
            if name and name not in mirrored and is_known(name, *mirrored):
                message = f"joint '{joint.name}' has state interface '{name}', but mimics joint '{mimicked}', which does not have it"
                yield Finding(state.at, message, severity=severity_where(project, JAZZY))
