"""What the rules of the smoke test share: their check, which finds nothing, and the parts of their examples."""

from __future__ import annotations

from collections.abc import Iterator

from urdfctl.rule import Finding, Project

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


def found_by_smoke_test(_: Project) -> Iterator[Finding]:
    """Return no findings: `urdfctl smoke` makes them, from what the robot does."""
    return iter(())
