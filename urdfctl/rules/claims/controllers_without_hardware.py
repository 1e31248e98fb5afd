"""UC471."""

from __future__ import annotations

from collections.abc import Iterator

from urdfctl.control.hardware.gazebo_ros1 import in_gazebo
from urdfctl.model.launch import Launch
from urdfctl.rule import Finding, Note, Project, Severity, Stage, rule
from urdfctl.rules.common import whole_robot_in
from urdfctl.source.opaque import is_known
from urdfctl.source.span import Place

_ROS2 = 2
_WITHOUT_CLAIMS = ("joint_state_controller/JointStateController",)
"""Types that start even if there is no interface."""
_CONTROLLERS = """
    controller_manager:
      ros__parameters:
        states: {type: joint_state_broadcaster/JointStateBroadcaster}
        arm: {type: forward_command_controller/ForwardCommandController}
    arm:
      ros__parameters:
        joints: [elbow]
        interface_name: position
"""


@rule(
    "UC471",
    severity=Severity.ERROR,
    runtime="refuses",
    stage=Stage.HARDWARE,
    authority="ros2_control controller_manager.cpp: claimed interfaces come only from <ros2_control> of the description; "
    "gazebo_ros_control default_robot_hw_sim.cpp: only from <transmission>",
    whole_robot=True,
    in_library=False,
    options=["--distro=jazzy"],
    bad=[
        {
            "robot.urdf": """
                «<robot name="arm">»
                  <link name="base"/>
                  <link name="fore"/>
                  <joint name="elbow" type="revolute">
                    <parent link="base"/><child link="fore"/><limit lower="-1" upper="1" effort="1" velocity="1"/>
                  </joint>
                </robot>
            """,
            "controllers.yaml": _CONTROLLERS,
        },
        {
            "options": "--distro=noetic --simulator=gazebo-classic",
            "robot.urdf": """
                «<robot name="arm">»
                  <link name="base"/>
                  <link name="fore"/>
                  <joint name="elbow" type="revolute">
                    <parent link="base"/><child link="fore"/><limit lower="-1" upper="1" effort="1" velocity="1"/>
                  </joint>
                  <gazebo><plugin name="control" filename="libgazebo_ros_control.so"/></gazebo>
                </robot>
            """,
            "controllers.yaml": """
                states: {type: joint_state_controller/JointStateController, publish_rate: 50}
                arm: {type: position_controllers/JointPositionController, joint: elbow}
            """,
        },
    ],
    good=[
        {
            "robot.urdf": """
                <ros2_control name="arm" type="system">
                  <hardware><plugin>mock_components/GenericSystem</plugin></hardware>
                  <joint name="elbow"><command_interface name="position"/><state_interface name="position"/></joint>
                </ros2_control>
            """,
            "controllers.yaml": _CONTROLLERS,
        },
        {
            "options": "--distro=noetic",
            "robot.urdf": """
                <transmission name="elbow_trans">
                  <type>transmission_interface/SimpleTransmission</type>
                  <joint name="elbow"><hardwareInterface>hardware_interface/PositionJointInterface</hardwareInterface></joint>
                  <actuator name="elbow_motor"><mechanicalReduction>1</mechanicalReduction></actuator>
                </transmission>
                <gazebo><plugin name="control" filename="libgazebo_ros_control.so"/></gazebo>
            """,
            "controllers.yaml": "states: {type: joint_state_controller/JointStateController, publish_rate: 50}",
        },
        {
            "options": "--distro=noetic --simulator=gazebo-classic",
            "robot.urdf": '<gazebo><plugin name="control" filename="libgazebo_ros_control.so"/></gazebo>',
            "controllers.yaml": "states: {type: joint_state_controller/JointStateController, publish_rate: 50}",
        },
    ],
)
def controllers_without_hardware(project: Project) -> Iterator[Finding]:
    """Controllers without hardware.

    Controllers are declared or spawned, but the description has no <ros2_control> (ROS 2) and no <transmission> (ROS 1
    in Gazebo), so no hardware exports an interface: every controller is refused when it is activated. In ROS 1 without
    a simulator a driver may bring its own hardware interface; then this is only a remark.
    """
    robot = whole_robot_in(project)
    first = _first_controller(project)
    if robot is None or first is None or project.ros is None:
        return
    name, at = first
    note = (Note(f"controller '{name}' is here", at),)
    if project.ros == _ROS2:
        if robot.ros2_controls:
            return
        message = "robot has controllers, but no <ros2_control>: no hardware exports an interface. Add a <ros2_control>"
        yield Finding(robot.at, message, note)
    elif not robot.transmissions and not robot.nested_transmissions:
        simulated = in_gazebo(project)
        message = "robot has controllers, but no <transmission>: no hardware offers an interface. Add transmissions"
        if simulated is not None:  # another hardware simulation may need none
            yield Finding(robot.at, message, note, severity=None if simulated is Severity.ERROR else Severity.INFO)


def _first_controller(project: Project) -> tuple[str, Place] | None:
    """The first controller that is declared with a type; in ROS 2 also one that is only spawned."""
    declared = project.controllers.controllers if project.controllers else ()
    for controller in declared:
        type_name = controller.type.text if controller.type is not None else None
        if type_name and controller.declared_at is not None and type_name not in _WITHOUT_CLAIMS:
            return controller.name, controller.declared_at
    launch: Launch | None = project.launch
    for spawn in launch.spawns if launch and not declared and project.ros == _ROS2 else ():
        for name, at in spawn.names if spawn.sure else ():
            if is_known(name):
                return name, at
    return None
