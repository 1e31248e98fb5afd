"""What a description says of its hardware: <ros2_control>, transmissions, and the simulator's plugin."""

from __future__ import annotations

from systems.system import CLASSIC, GZ, Joint, Robot, System

_INTERFACES = {
    "position": "PositionJointInterface",
    "velocity": "VelocityJointInterface",
    "effort": "EffortJointInterface",
}


WEBOTS = '<webots>\n  <plugin type="webots_ros2_control::Ros2Control"/>\n</webots>\n'
"""What runs the controllers in Webots' driver."""


def hardware_of(system: System, robot: Robot, prefix: str, *, in_webots: bool = False) -> str:
    """Return the part that offers interfaces. prefix: as the description writes it."""
    if system.generation == 1:
        return "".join(_transmission(joint, prefix) for joint in robot.joints)
    joints = "".join(_part(joint, prefix) for joint in robot.joints)
    plugin = {
        "": "mock_components/GenericSystem",
        CLASSIC: "gazebo_ros2_control/GazeboSystem",
        GZ: "ign_ros2_control/IgnitionSystem" if system.distro == "humble" else "gz_ros2_control/GazeboSimSystem",
    }[system.simulator]
    plugin = "webots_ros2_control::Ros2ControlSystem" if in_webots else plugin
    return (
        f'<ros2_control name="{prefix}{robot.model}_hardware" type="system">\n  <hardware>\n'
        f"    <plugin>{plugin}</plugin>\n  </hardware>\n{joints}</ros2_control>\n"
    )


def _part(joint: Joint, prefix: str) -> str:
    commands = "".join(f'    <command_interface name="{name}"/>\n' for name in joint.commands)
    states = "".join(f'    <state_interface name="{name}"/>\n' for name in ("position", "velocity"))
    return f'  <joint name="{prefix}{joint.name}">\n{commands}{states}  </joint>\n'


def _transmission(joint: Joint, prefix: str) -> str:
    interface = f"hardware_interface/{_INTERFACES[joint.commands[0]]}"
    name = f"{prefix}{joint.name}"
    return (
        f'<transmission name="{name}_transmission">\n  <type>transmission_interface/SimpleTransmission</type>\n'
        f'  <joint name="{name}">\n    <hardwareInterface>{interface}</hardwareInterface>\n  </joint>\n'
        f'  <actuator name="{name}_motor_of_transmission">\n    <mechanicalReduction>1</mechanicalReduction>\n'
        f"  </actuator>\n</transmission>\n"
    )


def plugin_of(system: System, robot: Robot, namespace: str, files: tuple[str, ...]) -> str:
    """Return the simulator's plugin that runs the controllers, if there is one.

    namespace, files: as the description writes them.
    """
    if not system.is_simulated:
        return ""
    if system.generation == 1:
        return _classic_of_ros1(namespace)
    inside = "".join(f"    <parameters>{file}</parameters>\n" for file in files)
    if robot.manager != "controller_manager":
        inside += f"    <controller_manager_name>{robot.manager}</controller_manager_name>\n"
    if namespace:
        inside += f"    <ros>\n      <namespace>{namespace}</namespace>\n    </ros>\n"
    if system.simulator == CLASSIC:
        head = '<plugin name="gazebo_ros2_control" filename="libgazebo_ros2_control.so">'
    elif system.distro == "humble":
        head = '<plugin filename="ign_ros2_control-system" name="ign_ros2_control::IgnitionROS2ControlPlugin">'
    else:
        head = '<plugin filename="gz_ros2_control-system" name="gz_ros2_control::GazeboSimROS2ControlPlugin">'
    return f"<gazebo>\n  {head}\n{inside}  </plugin>\n</gazebo>\n"


def _classic_of_ros1(namespace: str) -> str:
    where = f"    <robotNamespace>/{namespace}</robotNamespace>\n" if namespace else ""
    kind = "    <robotSimType>gazebo_ros_control/DefaultRobotHWSim</robotSimType>\n"
    head = '<plugin name="gazebo_ros_control" filename="libgazebo_ros_control.so">'
    return f"<gazebo>\n  {head}\n{where}{kind}  </plugin>\n</gazebo>\n"
