"""Texts and questions of the tests of names in the server."""

from __future__ import annotations

import os

from editor import types
from folder import Folder

from urdfctl.server.analysis.question import Question
from urdfctl.server.analysis.workspace import EditorSettings, Workspace
from urdfctl.source.span import SourceText

MACROS = """<robot xmlns:xacro="http://www.ros.org/wiki/xacro">
  <xacro:macro name="wheel" params="side radius:=0.1">
    <link name="${side}_wheel"/>
    <joint name="${side}_hinge" type="continuous">
      <parent link="base"/><child link="${side}_wheel"/><axis xyz="0 1 0"/>
      <limit effort="1" velocity="${2 * radius}"/>
    </joint>
  </xacro:macro>
</robot>
"""
ROBOT = """<robot name="r" xmlns:xacro="http://www.ros.org/wiki/xacro">
  <xacro:include filename="macros.xacro"/>
  <link name="base"/>
  <link name="head"/>
  <joint name="neck" type="revolute">
    <parent link="base"/><child link="head"/><axis xyz="0 0 1"/>
    <limit lower="-1" upper="1" effort="5" velocity="2"/>
  </joint>
  <xacro:wheel side="left"/>
  <xacro:wheel side="right" radius="0.2"/>
  <ros2_control name="c" type="system">
    <hardware><plugin>mock_components/GenericSystem</plugin></hardware>
    <joint name="neck"><command_interface name="position"/><state_interface name="position"/></joint>
  </ros2_control>
</robot>
"""
CONTROLLERS = """controller_manager:
  ros__parameters:
    update_rate: 100
    turn:
      type: position_controllers/JointGroupPositionController
turn:
  ros__parameters:
    joints: [neck]
"""
LAUNCH = """from launch import LaunchDescription
from launch_ros.actions import Node
from launch.substitutions import Command, PathJoinSubstitution
from ament_index_python.packages import get_package_share_directory
import os
def generate_launch_description():
    share = get_package_share_directory('p')
    robot = Command(['xacro ', os.path.join(share, 'urdf', 'robot.xacro')])
    return LaunchDescription([
        Node(package='robot_state_publisher', executable='robot_state_publisher',
             parameters=[{'robot_description': robot}]),
        Node(package='controller_manager', executable='ros2_control_node',
             parameters=[os.path.join(share, 'config', 'controllers.yaml')]),
        Node(package='controller_manager', executable='spawner', arguments=['turn']),
    ])
"""
XACRO, URDF, YAML, STARTS = "urdf/macros.xacro", "urdf/robot.xacro", "config/controllers.yaml", "launch/r.launch.py"
FILES = {XACRO: MACROS, URDF: ROBOT, YAML: CONTROLLERS, STARTS: LAUNCH}


def question(folder: Folder, file: str, at: types.Position, typed: str | None = None, **written: str) -> Question:
    """A question about a place in a package whose files are open; one of them perhaps as it is being typed.

    written: other texts of files, by the names of their constants.
    """
    folder.write({".git/HEAD": "", "package.xml": "<package format='3'><name>p</name></package>"})
    folder.write({**FILES, **{globals()[name]: text for name, text in written.items()}})
    folder.write({"urdfctl.toml": 'distro = "jazzy"\n'})
    workspace = Workspace(str(folder.path), EditorSettings())
    workspace.check()
    if typed is not None:
        workspace.changed(str(folder.path / file), typed.encode())
        workspace.check()
    path = os.path.realpath(folder.path / file)
    robots = workspace.robots_with(path)
    source = SourceText(path, typed.encode() if typed is not None else (folder.path / file).read_bytes())
    packages = workspace.packages_for(path)
    return Question(robots, source, at.line + 1, at.character + 1, is_current=typed is None, packages=packages)
