"""What the fuzzer starts from: small folders of files, by their names."""

from __future__ import annotations

from collections.abc import Iterator
from pathlib import Path

from urdfctl.rules import FAMILIES
from urdfctl.rules.examples import unmarked

Tree = dict[str, bytes]

CHECKOUT = Path(__file__).parents[2]
SHARED = CHECKOUT.parent / "shared"
MOST_FILES, MOST_BYTES = 60, 60_000
_TEXTS = {".xacro", ".urdf", ".xml", ".yaml", ".yml", ".launch", ".py", ".txt", ".gazebo", ".toml", ".trans", ".csv"}
_TEXTS |= {".srdf", ".world", ".sdf"}

ARM = b"""\
<robot name="arm" xmlns:xacro="http://www.ros.org/wiki/xacro">
  <xacro:arg name="prefix" default=""/>
  <xacro:property name="limits" value="${xacro.load_yaml('joints.yaml')}"/>
  <link name="base"/><link name="fore"/>
  <joint name="$(arg prefix)elbow" type="revolute">
    <parent link="base"/><child link="fore"/><axis xyz="0 0 1"/><limit lower="-1" upper="1" effort="1" velocity="1"/>
  </joint>
  <ros2_control name="arm" type="system">
    <hardware><plugin>mock_components/GenericSystem</plugin></hardware>
    <joint name="$(arg prefix)elbow"><command_interface name="position"/><state_interface name="position"/></joint>
  </ros2_control>
</robot>
"""
OTHER_TEXTS: Tree = {
    "package.xml": b"<package format='3'><name>arm</name><version>1.0.0</version><exec_depend>xacro</exec_depend>"
    b"<export><build_type>ament_cmake</build_type></export></package>",
    "CMakeLists.txt": b"cmake_minimum_required(VERSION 3.8)\nproject(arm)\nset(X launch config)\n"
    b"install(DIRECTORY ${X} urdf/ DESTINATION share/${PROJECT_NAME})\nament_package()\n",
    "setup.py": b"import os\nfrom glob import glob\nfrom setuptools import setup\npackage_name = 'arm'\n"
    b"setup(name=package_name, data_files=[(os.path.join('share', package_name, 'urdf'), glob('urdf/*.xacro')),\n"
    b"    ('share/' + package_name, ['package.xml'])])\n",
    "urdfctl.toml": b'distro = "jazzy"\nselect = ["UC"]\nignore = ["UC970"]\nexclude = ["build/**", "[a-z]"]\n'
    b'package-paths = ["."]\n[per-file-ignores]\n"*.urdf" = ["UC2"]\n',
    ".git/info/exclude": b"*.bak\n",
    ".gitignore": b"build/\n*.log\n!keep.log\n/a/**/b\n[a-c]x\n\\#y\n",
    "joints.yaml": b"joints:\n  - {name: elbow, type: revolute, lower: -1.0, upper: 1.0, gains: {p: 1, d: 0.1}}\n"
    b"  - name: wrist\n    interface: velocity\n",
    "joints.csv": b"name,type,lower,upper,p\nelbow,revolute,-1,1,10\nwrist,continuous,,,\n",
    "joints.txt": b"elbow\nwrist\n# a comment\n",
    "gazebo.log": b"[INFO] [1700000000.1, 0.0]: Loading controller: arm_controller\n"
    b"[ERROR] [1700000000.2]: No p gain specified for pid.  Namespace: /arm/gazebo_ros_control/pid_gains/elbow\n"
    b"[ros2_control_node-1] [FATAL] [resource_manager]: Not acceptable command interfaces combination: \n"
    b"Start interfaces: \n[\n  elbow/position\n]\nStop interfaces: \n[\n]\nNot existing: \n[\n  elbow/position\n]\n\n",
    "urdf/arm.xacro": ARM,
    "config/controllers.yaml": b"controller_manager:\n  ros__parameters:\n    update_rate: 100\n"
    b"    arm: {type: joint_trajectory_controller/JointTrajectoryController}\n"
    b"arm:\n  ros__parameters:\n    joints: [elbow]\n    command_interfaces: [position]\n"
    b"    state_interfaces: [position]\n",
    "config/old.yaml": b"# made by urdfctl gen-controllers urdf/arm.xacro --type effort --distro noetic\narm: {}\n",
    "launch/arm.launch.yaml": b"launch:\n- arg: {name: prefix, default: ''}\n- let: {name: x, value: $(var prefix)}\n"
    b"- group:\n  - push_ros_namespace: {namespace: a}\n  - node:\n      pkg: controller_manager\n"
    b"      exec: ros2_control_node\n      param:\n      - from: $(find-pkg-share arm)/config/controllers.yaml\n"
    b"  - node: {pkg: controller_manager, exec: spawner, args: arm --controller-manager /a/controller_manager}\n",
    "launch/arm.launch.xml": b"<launch><arg name='prefix' default=''/>"
    b"<include file='$(find-pkg-share arm)/launch/x.xml'/>"
    b"<node pkg='controller_manager' exec='ros2_control_node'>"
    b"<param from='$(find-pkg-share arm)/config/controllers.yaml'/>"
    b"<param name='robot_description' value=\"$(command 'xacro $(find-pkg-share arm)/urdf/arm.xacro')\"/></node>"
    b"<node pkg='controller_manager' exec='spawner' args='arm' if='$(eval 1 == 1)'/></launch>",
    "launch/arm.launch.py": b"""\
import os
from launch import LaunchDescription
from launch.actions import DeclareLaunchArgument, OpaqueFunction, RegisterEventHandler, TimerAction
from launch.event_handlers import OnProcessExit
from launch.substitutions import Command, LaunchConfiguration, PathJoinSubstitution, PythonExpression
from launch_ros.actions import Node
from launch_ros.substitutions import FindPackageShare
from ament_index_python.packages import get_package_share_directory

def more(context, *args, **kwargs):
    return [Node(package="controller_manager", executable="spawner", arguments=["arm"])]

def generate_launch_description():
    share = get_package_share_directory("arm")
    names = ["a", "b"] + [f"c{n:02d}" for n in range(3)]
    text = Command(["xacro ", os.path.join(share, "urdf", "arm.xacro"), " prefix:=", LaunchConfiguration("prefix")])
    node = Node(package="controller_manager", executable="ros2_control_node", parameters=[
        {"robot_description": text}, PathJoinSubstitution([FindPackageShare("arm"), "config", "controllers.yaml"])])
    later = RegisterEventHandler(OnProcessExit(target_action=node, on_exit=[TimerAction(period=2.0, actions=[node])]))
    return LaunchDescription([DeclareLaunchArgument("prefix", default_value="", choices=["", *names]), node, later,
        OpaqueFunction(function=more), *[x for x in (node, None) if x]])
""",
    "known.json": b'{"version": 1, "tool": "urdfctl", "findings": [\n  {"code": "UC154", "file": "urdf/arm.xacro", '
    b'"message": "<lnk> of the robot is ignored", "mark": "c805e5b5521075a042fe1ec0c20e1965", "times": 1}\n]}\n',
}


def trees() -> list[Tree]:
    """The folders: what is written here, the samples, the cases, the rules' examples, and the corpus if it is there."""
    return [OTHER_TEXTS] * 40 + [*_examples(), *_samples() * 10, *_corpus() * 4]


def _samples() -> list[Tree]:
    folders = [*CHECKOUT.glob("samples/*/package.xml"), *CHECKOUT.glob("samples/broken/*/package.xml")]
    return [tree for manifest in sorted(folders) for tree in _tree(manifest.parent)]


def _examples() -> Iterator[Tree]:
    for rule in (rule for family in FAMILIES for rule in family.load()):
        for example in (*rule.bad, *rule.good):
            yield {name: text.encode() for name, text in unmarked(example.files)[0].items()}


def _corpus() -> list[Tree]:
    manifests = sorted(SHARED.glob("corpus/*/**/package.xml"))
    return [tree for manifest in manifests for tree in _tree(manifest.parent)]


def _tree(folder: Path) -> Iterator[Tree]:
    """A folder's texts; nothing where they are many or none of them is a robot."""
    files = [path for path in sorted(folder.rglob("*")) if path.suffix in _TEXTS and path.is_file()]
    if len(files) > MOST_FILES or not any(path.suffix in {".xacro", ".urdf"} for path in files):
        return
    texts = {path.relative_to(folder).as_posix(): path.read_bytes() for path in files}
    yield {name: data for name, data in texts.items() if len(data) < MOST_BYTES}
