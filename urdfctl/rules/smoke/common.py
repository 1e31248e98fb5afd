"""The parts of the examples of the faults that the smoke test finds."""

from __future__ import annotations

HARDWARE = """
    <ros2_control name="arm" type="system">
      <hardware><plugin>mock_components/GenericSystem</plugin></hardware>
      <joint name="shoulder"><command_interface name="position"/><state_interface name="position"/></joint>
      <joint name="elbow"><command_interface name="position"/><state_interface name="position"/></joint>
    </ros2_control>
"""
CONTROLLERS = """
    controller_manager:
      ros__parameters:
        update_rate: 100
        states: {type: joint_state_broadcaster/JointStateBroadcaster}
        %s: {type: forward_command_controller/ForwardCommandController}
    arm:
      ros__parameters:
        %s
        interface_name: position
"""
ROVER = """
    <robot name="rover">
      <link name="base_footprint"/>
      <joint name="foot" type="fixed">
        <parent link="base_footprint"/><child link="base_link"/><origin xyz="0 0 0.1"/>
      </joint>
      <link name="base_link">
        <inertial><mass value="5"/><inertia ixx="0.1" ixy="0" ixz="0" iyy="0.1" iyz="0" izz="0.1"/></inertial>
        <collision><origin xyz="0 0 0.05"/><geometry><box size="0.4 0.2 0.1"/></geometry></collision>
      </link>
      <link name="front">
        <inertial><mass value="0.1"/><inertia ixx="0.001" ixy="0" ixz="0" iyy="0.001" iyz="0" izz="0.001"/></inertial>
        <collision><geometry><sphere radius="0.05"/></geometry></collision>
      </link>
      <joint name="front_mount" type="fixed">
        <parent link="base_link"/><child link="front"/><origin xyz="0.15 0 -0.05"/>
      </joint>
      <link name="rear">
        <inertial><mass value="0.1"/><inertia ixx="0.001" ixy="0" ixz="0" iyy="0.001" iyz="0" izz="0.001"/></inertial>
        <collision><geometry><sphere radius="0.05"/></geometry></collision>
      </link>
      <joint name="rear_mount" type="fixed">
        <parent link="base_link"/><child link="rear"/><origin xyz="-0.15 0 -0.05"/>
      </joint>
      <link name="left">
        <inertial><mass value="0.5"/><inertia ixx="0.002" ixy="0" ixz="0" iyy="0.002" iyz="0" izz="0.003"/></inertial>
        <collision><geometry><cylinder radius="0.1" length="0.04"/></geometry></collision>
      </link>
      <joint name="left_wheel" type="continuous">
        <parent link="base_link"/><child link="left"/><origin xyz="0 0.15 0" rpy="-1.5708 0 0"/>
        <axis xyz="0 0 1"/><!-- left --><limit effort="20" velocity="20"/>
      </joint>
      <link name="right">
        <inertial><mass value="0.5"/><inertia ixx="0.002" ixy="0" ixz="0" iyy="0.002" iyz="0" izz="0.003"/></inertial>
        <collision><geometry><cylinder radius="0.1" length="0.04"/></geometry></collision>
      </link>
      <joint name="right_wheel" type="continuous">
        <parent link="base_link"/><child link="right"/><origin xyz="0 -0.15 0" rpy="-1.5708 0 0"/>
        <axis xyz="0 0 1"/><limit effort="20" velocity="20"/>
      </joint>
      <ros2_control name="wheels" type="system">
        <hardware><plugin>mock_components/GenericSystem</plugin></hardware>
        <joint name="left_wheel">
          <command_interface name="velocity"/><state_interface name="position"/><state_interface name="velocity"/>
        </joint>
        <joint name="right_wheel">
          <command_interface name="velocity"/><state_interface name="position"/><state_interface name="velocity"/>
        </joint>
      </ros2_control>
    </robot>
"""
WHEELS = """
    controller_manager:
      ros__parameters:
        update_rate: 100
        states: {type: joint_state_broadcaster/JointStateBroadcaster}
        %s: {type: diff_drive_controller/DiffDriveController}
    base:
      ros__parameters:
        left_wheel_names: [left_wheel]
        right_wheel_names: [right_wheel]
        wheel_separation: 0.3
        wheel_radius: 0.1
        base_frame_id: base_link
"""
LIFT = """
    <robot name="lift">
      <link name="base_link"/>
      <link name="mast">
        <inertial><mass value="20"/><inertia ixx="0.5" ixy="0" ixz="0" iyy="0.5" iyz="0" izz="0.5"/></inertial>
      </link>
      <joint name="foot" type="fixed"><parent link="base_link"/><child link="mast"/></joint>
      <link name="carriage">
        <inertial><mass value="5"/><inertia ixx="0.05" ixy="0" ixz="0" iyy="0.05" iyz="0" izz="0.05"/></inertial>
      </link>
      <joint name="lift" type="prismatic">
        <parent link="mast"/><child link="carriage"/><origin xyz="0.2 0 0.5"/><axis xyz="0 0 1"/>
        <limit lower="-0.4" upper="0.4" effort="500" velocity="1"/>
      </joint>
      <ros2_control name="lift" type="system">
        <hardware><plugin>mock_components/GenericSystem</plugin></hardware>
        <joint name="lift">
          <command_interface name="effort"/><state_interface name="position"/><state_interface name="velocity"/>
        </joint>
      </ros2_control>
    </robot>
"""
LIGHT = (
    LIFT.replace('mass value="5"', 'mass value="0.01"')
    .replace('ixx="0.05"', 'ixx="0.00001"')
    .replace('iyy="0.05"', 'iyy="0.00001"')
    .replace('izz="0.05"', 'izz="0.00001"')
)
GAINS = """
    controller_manager:
      ros__parameters:
        update_rate: 500
        states: {type: joint_state_broadcaster/JointStateBroadcaster}
        %s: {type: joint_trajectory_controller/JointTrajectoryController}
    mover:
      ros__parameters:
        joints: [lift]
        command_interfaces: [effort]
        state_interfaces: [position, velocity]
        gains:
          lift: {p: 4000.0, i: 100.0, d: 400.0}
"""
GRIPPER = """
    <robot name="gripper">
      <link name="world"/>
      <joint name="bench" type="fixed"><parent link="world"/><child link="palm"/></joint>
      <link name="palm">
        <inertial><mass value="1"/><inertia ixx="0.001" ixy="0" ixz="0" iyy="0.001" iyz="0" izz="0.001"/></inertial>
      </link>
      <link name="one">
        <inertial><mass value="0.1"/><inertia ixx="0.0001" ixy="0" ixz="0" iyy="0.0001" iyz="0" izz="0.0001"/></inertial>
      </link>
      <joint name="finger" type="prismatic">
        <parent link="palm"/><child link="one"/><axis xyz="0 1 0"/>
        <limit lower="0" upper="0.04" effort="20" velocity="0.2"/>
      </joint>
      <link name="two">
        <inertial><mass value="0.1"/><inertia ixx="0.0001" ixy="0" ixz="0" iyy="0.0001" iyz="0" izz="0.0001"/></inertial>
      </link>
      <joint name="thumb" type="prismatic">
        <parent link="palm"/><child link="two"/><axis xyz="0 -1 0"/>
        <limit lower="0" upper="0.04" effort="20" velocity="0.2"/><mimic joint="finger" multiplier="1"/>
      </joint>
      <ros2_control name="gripper" type="system">
        <hardware><plugin>mock_components/GenericSystem</plugin></hardware>
        <joint name="finger">
          <command_interface name="position"/><state_interface name="position"/><state_interface name="velocity"/>
        </joint>
      </ros2_control>
    </robot>
"""
GRIPPER_CONTROLLER = """
    controller_manager:
      ros__parameters:
        update_rate: 100
        states: {type: joint_state_broadcaster/JointStateBroadcaster}
        gripper: {type: forward_command_controller/ForwardCommandController}
    gripper:
      ros__parameters: {joints: [finger], interface_name: position}
"""
PLAIN_WHEELS = """
    controller_manager:
      ros__parameters:
        update_rate: 100
        states: {type: joint_state_broadcaster/JointStateBroadcaster}
        wheels: {type: forward_command_controller/ForwardCommandController}
    wheels:
      ros__parameters: {joints: [left_wheel, right_wheel], interface_name: velocity}
"""


def geared(robot: str, joint: str, reduction: str) -> str:
    """Return a robot with a transmission for a joint in its `<ros2_control>`."""
    transmission = f"""<transmission name="{joint}_gear">
          <plugin>transmission_interface/SimpleTransmission</plugin>
          <actuator name="{joint}_motor" role="actuator1"/>
          <joint name="{joint}" role="joint1"><mechanical_reduction>{reduction}</mechanical_reduction></joint>
        </transmission>
      """
    return robot.replace("</ros2_control>", f"{transmission}</ros2_control>")


def _wheel(name: str, place: str, parent: str = "base_link") -> str:
    return f"""
      <link name="{name}_link">
        <inertial><mass value="0.5"/><inertia ixx="0.002" ixy="0" ixz="0" iyy="0.002" iyz="0" izz="0.003"/></inertial>
        <collision><geometry><cylinder radius="0.1" length="0.04"/></geometry></collision>
      </link>
      <joint name="{name}" type="continuous">
        <parent link="{parent}"/><child link="{name}_link"/><origin xyz="{place}" rpy="-1.5708 0 0"/>
        <axis xyz="0 0 1"/><limit effort="50" velocity="20"/>
      </joint>
    """


def _control(name: str, interface: str) -> str:
    states = '<state_interface name="position"/><state_interface name="velocity"/>'
    return f'<joint name="{name}"><command_interface name="{interface}"/>{states}</joint>'


def _base(wheels: str, controls: str) -> str:
    """A base with some wheels, and with the control of some joints."""
    return f"""
    <robot name="base">
      <link name="base_footprint"/>
      <joint name="foot" type="fixed"><parent link="base_footprint"/><child link="base_link"/></joint>
      <link name="base_link">
        <inertial><mass value="20"/><inertia ixx="0.3" ixy="0" ixz="0" iyy="0.6" iyz="0" izz="0.8"/></inertial>
        <collision><origin xyz="0 0 0.05"/><geometry><box size="0.6 0.3 0.15"/></geometry></collision>
      </link>
      {wheels}
      <ros2_control name="base" type="system">
        <hardware><plugin>mock_components/GenericSystem</plugin></hardware>
        {controls}
      </ros2_control>
    </robot>
    """


MECANUM = _base(
    _wheel("fl", "0.2 0.2 0") + _wheel("fr", "0.2 -0.2 0") + _wheel("rl", "-0.2 0.2 0") + _wheel("rr", "-0.2 -0.2 0"),
    "".join(_control(name, "velocity") for name in ("fl", "fr", "rl", "rr")),
)
MECANUM_CONTROLLER = """
    controller_manager:
      ros__parameters:
        update_rate: 100
        states: {type: joint_state_broadcaster/JointStateBroadcaster}
        base: {type: mecanum_drive_controller/MecanumDriveController}
    base:
      ros__parameters:
        front_left_wheel_command_joint_name: fl
        front_right_wheel_command_joint_name: fr
        rear_left_wheel_command_joint_name: rl
        rear_right_wheel_command_joint_name: rr
        base_frame_id: base_link
        kinematics:
          base_frame_offset: {x: 0.0, y: 0.0, theta: 0.0}
          wheels_radius: 0.1
          sum_of_robot_center_projection_on_X_Y_axis: 0.4
"""
TRICYCLE = _base(
    """
      <link name="fork">
        <inertial><mass value="0.5"/><inertia ixx="0.002" ixy="0" ixz="0" iyy="0.002" iyz="0" izz="0.002"/></inertial>
      </link>
      <joint name="steer" type="revolute">
        <parent link="base_link"/><child link="fork"/><origin xyz="0.3 0 0"/><axis xyz="0 0 1"/><!-- steer -->
        <limit lower="-0.6" upper="0.6" effort="50" velocity="3"/>
      </joint>
    """
    + _wheel("front", "0 0 0", "fork")
    + _wheel("rear_left", "-0.3 0.2 0")
    + _wheel("rear_right", "-0.3 -0.2 0"),
    _control("rear_left", "velocity") + _control("rear_right", "velocity") + _control("steer", "position"),
)
TRICYCLE_CONTROLLER = """
    controller_manager:
      ros__parameters:
        update_rate: 100
        states: {type: joint_state_broadcaster/JointStateBroadcaster}
        base: {type: tricycle_steering_controller/TricycleSteeringController}
    base:
      ros__parameters:
        traction_joints_names: [rear_right, rear_left]
        steering_joints_names: [steer]
        wheelbase: 0.6
        traction_track_width: 0.4
        traction_wheels_radius: 0.1
        base_frame_id: base_link
"""
REACHER = """
    <robot name="reacher">
      <link name="world"/>
      <joint name="bolted" type="fixed"><parent link="world"/><child link="base"/></joint>
      <link name="base">
        <inertial><mass value="8"/><inertia ixx="0.03" ixy="0" ixz="0" iyy="0.03" iyz="0" izz="0.04"/></inertial>
        <collision><origin xyz="0 0 0.1"/><geometry><box size="0.2 0.2 0.2"/></geometry></collision>
      </link>
      <joint name="turn" type="revolute">
        <parent link="base"/><child link="upper"/><origin xyz="0 0 0.22" rpy="0 0 0"/><axis xyz="0 0 1"/>
        <limit lower="-3" upper="3" effort="80" velocity="2"/>
      </joint>
      <link name="upper">
        <inertial><origin xyz="0 0 0.15"/><mass value="2"/>
          <inertia ixx="0.016" ixy="0" ixz="0" iyy="0.016" iyz="0" izz="0.002"/></inertial>
        <collision><origin xyz="0 0 0.15"/><geometry><box size="0.06 0.06 0.26"/></geometry></collision>
      </link>
      <joint name="bend" type="revolute">
        <parent link="upper"/><child link="fore"/><origin xyz="0 0 0.3" rpy="0 0.3 0"/><axis xyz="0 1 0"/>
        <limit lower="-2" upper="2" effort="80" velocity="2"/><!-- bend -->
      </joint>
      <link name="fore">
        <inertial><origin xyz="0 0 0.12"/><mass value="1"/>
          <inertia ixx="0.005" ixy="0" ixz="0" iyy="0.005" iyz="0" izz="0.001"/></inertial>
        <collision><origin xyz="0 0 0.12"/><geometry><box size="0.05 0.05 0.2"/></geometry></collision>
      </link>
      <joint name="reach" type="prismatic">
        <parent link="fore"/><child link="hand"/><origin xyz="0 0 0.24" rpy="0 0 0"/><axis xyz="0 0 1"/>
        <limit lower="0" upper="0.2" effort="60" velocity="0.5"/>
      </joint>
      <link name="hand">
        <inertial><origin xyz="0 0 0.04"/><mass value="0.2"/>
          <inertia ixx="0.0004" ixy="0" ixz="0" iyy="0.0004" iyz="0" izz="0.0001"/></inertial>
        <collision><origin xyz="0 0 0.04"/><geometry><box size="0.03 0.03 0.06"/></geometry></collision>
      </link>
      <ros2_control name="reacher" type="system">
        <hardware><plugin>mock_components/GenericSystem</plugin></hardware>
        <joint name="turn">
          <command_interface name="position"/><state_interface name="position"/><state_interface name="velocity"/>
        </joint>
        <joint name="bend">
          <command_interface name="position"/><state_interface name="position"/><state_interface name="velocity"/>
        </joint>
        <joint name="reach">
          <command_interface name="position"/><state_interface name="position"/><state_interface name="velocity"/>
        </joint>
      </ros2_control>
    </robot>
"""
REACHER_CONTROLLER = """
    controller_manager:
      ros__parameters:
        update_rate: 100
        states: {type: joint_state_broadcaster/JointStateBroadcaster}
        reacher: {type: joint_trajectory_controller/JointTrajectoryController}
    reacher:
      ros__parameters:
        joints: [turn, bend, reach]
        command_interfaces: [position]
        state_interfaces: [position, velocity]
"""


def marked(robot: str, element: str, old: str = "", new: str = "") -> str:
    """Return a bad example: a robot with an element between « and », in which an old text is replaced."""
    changed = robot.replace(old, new) if old else robot
    return changed.replace(element, f"«{element}»")
