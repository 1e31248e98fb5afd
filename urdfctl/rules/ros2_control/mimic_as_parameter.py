"""UC341."""

from __future__ import annotations

from collections.abc import Iterator

from urdfctl.catalog.distros import ROS2
from urdfctl.model.robot import ComponentPart, HardwareParameter
from urdfctl.names import did_you_mean
from urdfctl.rule import Finding, Fix, Project, Severity, rule
from urdfctl.rules.common import is_all_there, is_known, robot_in, severity_where
from urdfctl.rules.ros2_control.common import component, is_deaf, known_hardware, parts


@rule(
    "UC341",
    severity=Severity.WARNING,
    runtime="ignores",
    distros=ROS2,
    authority='ros2_control doc/migration.rst (jazzy): "The mimic-joint configuration is now done via URDF"; '
    "mock_components generic_system.cpp up to iron: \"Mimicked joint 'elbw' not found\"",
    options=["--distro=jazzy"],
    bad=[
        {
            "robot.urdf": """
                <link name="finger"/>
                <joint name="grip" type="prismatic">
                  <parent link="fore"/><child link="finger"/><limit lower="-1" upper="1" effort="1" velocity="1"/>
                </joint>
                <ros2_control name="arm" type="system">
                  <hardware><plugin>mock_components/GenericSystem</plugin></hardware>
                  <joint name="elbow"><command_interface name="position"/><state_interface name="position"/></joint>
                  <joint name="grip">
                    «<param name="mimic">»elbow</param>
                    <state_interface name="position"/>
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
                  <parent link="fore"/><child link="finger"/><limit lower="-1" upper="1" effort="1" velocity="1"/>
                  <mimic joint="elbow"/>
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
def mimic_as_parameter(project: Project) -> Iterator[Finding]:
    """Mimic parameter of a joint is ignored or names an unknown joint.

    Up to iron, the hardware reads the parameter, and fails if its component has no joint of that name. Since jazzy, the
    parameter is ignored and the URDF's `<mimic>` is used; without one the joint does not move.
    """
    robot = robot_in(project)
    mimics = {joint.name for joint in robot.joints if joint.mimic} if robot else set()
    for control, joint in parts(project, "joint"):
        parameter = joint.parameter("mimic")
        if parameter is None or not is_known(parameter.value, joint.name, control.plugin):
            continue
        readers = [each for each in known_hardware(project, control) if "mimic" in (each.joint_parameters or ())]
        joints = [other.name for other in control.of_kind("joint")]
        if readers and parameter.value not in joints and is_known(*joints) and is_all_there(project, control.tag):
            severity = severity_where(project, (each.distro for each in readers))
            hint = did_you_mean(parameter.value, (name for name in joints if name)) or "; add it there"
            message = f"joint '{joint.name}' mimics '{parameter.value}', which is not in {component(control)}{hint}"
            yield Finding(parameter.at, message, severity=severity)
        elif is_deaf(project, control, "mimic") and not project.library and (joint.name not in mimics or not readers):
            message = (
                f"parameter 'mimic' of joint '{joint.name}' is ignored since jazzy, which reads <mimic> of the URDF"
            )
            title = f"add {_in_urdf(joint, parameter)} to joint '{joint.name}' in the URDF"
            fix = Fix("remove the parameter" if joint.name in mimics else title)
            yield Finding(parameter.at, message, fix=fix)


def _in_urdf(joint: ComponentPart, parameter: HardwareParameter) -> str:
    multiplier = joint.parameter("multiplier")
    times = f' multiplier="{multiplier.value}"' if multiplier else ""
    return f'<mimic joint="{parameter.value}"{times}/>'
