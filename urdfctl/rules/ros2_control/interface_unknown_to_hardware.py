"""UC355."""

from __future__ import annotations

from collections.abc import Iterator

from urdfctl.catalog.distros import ROS2
from urdfctl.control.hardware.behaviour import validates
from urdfctl.names import did_you_mean
from urdfctl.rule import Finding, Project, Severity, rule
from urdfctl.rules.common import in_words, is_known, label, severity_where
from urdfctl.rules.ros2_control.common import called, interfaces_exported, known_hardware, parts


@rule(
    "UC355",
    severity=Severity.WARNING,
    runtime="ignores",
    distros=ROS2,
    authority="gz_ros2_control gz_ros2_control_plugin.cpp: GZResourceManager imports the components without "
    'validate_storage(); elsewhere ros2_control resource_manager.cpp: "Wrong state or command interface configuration. '
    'missing command interfaces: elbow/acceleration"',
    bad=[
        {
            "robot.urdf": """
                <ros2_control name="arm" type="system">
                  <hardware><plugin>gz_ros2_control/GazeboSimSystem</plugin></hardware>
                  <joint name="elbow">
                    <command_interface name="«acceleration»"/>
                    <state_interface name="position"/>
                  </joint>
                </ros2_control>
            """,
        },
    ],
    good=[
        {
            "robot.urdf": """
                <ros2_control name="arm" type="system">
                  <hardware><plugin>gz_ros2_control/GazeboSimSystem</plugin></hardware>
                  <joint name="elbow">
                    <command_interface name="effort"/>
                    <state_interface name="position"/>
                  </joint>
                </ros2_control>
                <gazebo>
                  <plugin filename="gz_ros2_control-system" name="gz_ros2_control::GazeboSimROS2ControlPlugin">
                    <parameters>/opt/arm/controllers.yaml</parameters>
                  </plugin>
                </gazebo>
            """,
        },
    ],
)
def interface_unknown_to_hardware(project: Project) -> Iterator[Finding]:
    """Interface is not provided by the hardware.

    A simulator provides position, velocity and effort; Gazebo Classic also provides two with a PID. Any other interface
    is ignored: a controller that claims it is not activated. Outside of Gazebo the exported interfaces are compared with
    the description, which is then rejected.
    """
    for control, part in parts(project, "joint"):
        hardware = known_hardware(project, control)
        for interface in part.interfaces if hardware else ():
            name = (interface.name or "").strip()
            if not name or not is_known(name):
                continue
            exported = [interfaces_exported(each, interface.kind) for each in hardware]
            if any(names is None or name in names for names in exported):
                continue
            known = exported[-1] or ()
            strict = (each.distro for each in hardware if validates(project.catalog, each.type, each.distro))
            severity = severity_where(project, strict) if hardware[0].host else Severity.WARNING
            hint = did_you_mean(name, known) or f"; it provides {in_words(known, len(known))}"
            message = f"'{hardware[0].type}' has no {called(interface)} for {label('joint', part.name)}{hint}"
            yield Finding(interface.at["name"], message, severity=severity)
