"""Only what a launch file starts counts: neither what a condition leaves out, nor what belongs to another robot."""

from __future__ import annotations

import json

import pytest
from folder import Folder

ROBOT = """\
<robot name="arm">
  <link name="base"/>
  <link name="upper"><inertial><mass value="1"/>
    <inertia ixx="1" iyy="1" izz="1" ixy="0" ixz="0" iyz="0"/></inertial></link>
  <joint name="elbow" type="revolute"><parent link="base"/><child link="upper"/>
    <limit lower="-1" upper="1" effort="1" velocity="1"/></joint>
  <ros2_control name="arm" type="system">
    <hardware><plugin>mock_components/GenericSystem</plugin></hardware>
    <joint name="elbow"><command_interface name="position"/><state_interface name="position"/></joint>
  </ros2_control>
</robot>
"""
CONTROLLERS = """\
{0}controller_manager:
  ros__parameters:
    mover: {{type: forward_command_controller/ForwardCommandController}}
{0}mover:
  ros__parameters: {{joints: [elbow], interface_name: position}}
"""
MANIFEST = "<package format='3'><name>arm</name><depend>controller_manager</depend></package>"
FILE = "$(find-pkg-share arm)/config/controllers.yaml"


def publisher(command: str, namespace: str = "") -> str:
    return f"""\
  <node pkg="robot_state_publisher" exec="robot_state_publisher" namespace="{namespace}">
    <param name="robot_description" type="str" value="$(command '{command}')"/>
  </node>
"""


def manager(file: str = FILE, namespace: str = "") -> str:
    node = f'<node pkg="controller_manager" exec="ros2_control_node" namespace="{namespace}">'
    return f'  {node}<param from="{file}"/></node>\n'


def spawner(args: str, more: str = "") -> str:
    return f'  <node pkg="controller_manager" exec="spawner" args="{args}" {more}/>\n'


def write(folder: Folder, *actions: str, **files: str) -> None:
    folder.write(
        {
            "package.xml": MANIFEST,
            "urdf/arm.urdf": ROBOT,
            "config/controllers.yaml": CONTROLLERS.format(""),
            "launch/arm.launch.xml": f"<launch>\n{''.join(actions)}</launch>\n",
            **files,
        }
    )


def shown(folder: Folder) -> list[dict[str, object]]:
    ran = folder.run("show", ".", "--format", "json")
    assert ran.returncode == 0, ran.stderr
    return [target for target in json.loads(ran.stdout)["targets"] if target["robot"]]


def codes(folder: Folder) -> list[str]:
    ran = folder.run("lint", ".", "--format", "json", "--distro", "jazzy")
    return [found["code"] for found in json.loads(ran.stdout)["findings"] if found["severity"] == "error"]


PUBLISHER = publisher("cat $(find-pkg-share arm)/urdf/arm.urdf")


@pytest.mark.parametrize("left_out", ['if="false"', 'if="$(var some)"'])
def test_a_spawner_that_does_not_run_or_may_run_hides_no_fault_with_a_file_that_is_loaded_anyway(
    folder: Folder, left_out: str
) -> None:
    argument = '  <arg name="some" default="$(env SOME)"/>\n'
    both = spawner(f"movre --param-file {FILE}") + spawner(f"mover --param-file {FILE}", left_out)
    write(folder, argument, PUBLISHER, manager(), both)
    assert codes(folder) == ["UC601"]


def test_a_description_that_is_made_when_the_package_is_built_is_that_of_its_namespace(folder: Folder) -> None:
    made = publisher("cat $(find-pkg-share arm)/urdf/other.urdf", "cell")
    cmake = "project(arm)\nxacro_add_files(urdf/other.urdf.xacro TARGET t INSTALL DESTINATION urdf)\n"
    write(folder, made, manager(namespace="cell"), **{"CMakeLists.txt": cmake, "urdf/other.urdf.xacro": ROBOT})
    [target] = [each for each in shown(folder) if each["launch"]]
    assert (target["robot"], target["namespace"]) == ("urdf/other.urdf.xacro", "/cell")


def test_the_same_description_with_two_managers_is_two_robots(folder: Folder) -> None:
    below = publisher("cat $(find-pkg-share arm)/urdf/arm.urdf", "cell")
    write(folder, PUBLISHER, below, manager())
    assert len(shown(folder)) == 1
    write(folder, PUBLISHER, below, manager(), manager(FILE.replace("controllers", "cell"), "cell"))
    folder.write({"config/cell.yaml": CONTROLLERS.format("/cell/")})
    assert [(each["namespace"] or "", each["controllers"]) for each in shown(folder)] == [
        ("", ["config/controllers.yaml"]),
        ("/cell", ["config/cell.yaml"]),
    ]


def test_a_file_that_ros_1_loads_for_one_of_two_robots_by_its_key_is_not_of_the_other(folder: Folder) -> None:
    actions = [
        f'  <param name="{name}/robot_description" textfile="$(find arm)/urdf/arm.urdf"/>\n'
        f'  <rosparam command="load" file="$(find arm)/config/{name}.yaml"/>\n'
        f'  <node pkg="controller_manager" type="spawner" name="s" ns="{name}" args="mover"/>\n'
        for name in ("left", "right")
    ]
    mover = "{{mover: {{type: position_controllers/JointPositionController, joint: elbow}}}}"
    files = {f"config/{name}.yaml": f"{name}: {mover.format()}\n" for name in ("left", "right")}
    write(folder, **files)
    folder.write({"launch/arm.launch.xml": "", "launch/arm.launch": f"<launch>\n{''.join(actions)}</launch>\n"})
    loaded = {each["namespace"]: each["controllers"] for each in shown(folder) if each["launch"]}
    assert loaded == {"/left": ["config/left.yaml"], "/right": ["config/right.yaml"]}


def test_a_manager_that_gets_the_description_of_a_moveit_builder_is_known(folder: Folder) -> None:
    launch = """\
from launch import LaunchDescription
from launch_ros.actions import Node
from launch_ros.substitutions import FindPackageShare
from moveit_configs_utils import MoveItConfigsBuilder

def generate_launch_description():
    config = MoveItConfigsBuilder("arm", package_name="arm").robot_description("urdf/arm.urdf").to_moveit_configs()
    return LaunchDescription([
        Node(package="robot_state_publisher", executable="robot_state_publisher",
             parameters=[config.robot_description]),
        Node(package="controller_manager", executable="ros2_control_node",
             parameters=[config.robot_description, [FindPackageShare("arm"), "/config/controllers.yaml"]]),
        Node(package="controller_manager", executable="spawner", arguments=["movre"]),
    ])
"""
    write(folder)
    folder.write({"launch/arm.launch.xml": "<launch/>", "launch/arm.launch.py": launch})
    assert codes(folder) == ["UC601"]


def test_hardware_that_depends_on_an_unknown_argument_is_not_judged(folder: Folder) -> None:
    hardware = """<hardware>
      <xacro:if value="$(arg sim)"><plugin>gz_ros2_control/GazeboSimSystem</plugin></xacro:if>
      <xacro:unless value="$(arg sim)"><plugin>mock_components/GenericSystem</plugin></xacro:unless></hardware>"""
    root = '<robot name="arm" xmlns:xacro="http://www.ros.org/wiki/xacro"><xacro:arg name="sim" default="true"/>'
    plain = "<hardware><plugin>mock_components/GenericSystem</plugin></hardware>"
    robot = ROBOT.replace(plain, hardware).replace('<robot name="arm">', root)

    def started(value: str) -> list[str]:
        arm = publisher(f"xacro $(find-pkg-share arm)/urdf/arm.xacro sim:={value}")
        write(folder, arm, manager(), spawner("mover"), **{"urdf/arm.xacro": robot})
        return codes(folder)

    assert "UC607" not in started("$(var nowhere)")
    assert "UC607" in started("true")


def test_the_only_description_is_a_robot_although_it_lacks_the_link_of_a_joint(folder: Folder) -> None:
    joint = '<joint name="j" type="fixed"><parent link="base"/><child link="nowhere"/></joint>'
    folder.write({"arm.urdf": f'<robot name="arm"><link name="base"/>{joint}</robot>'})
    assert codes(folder) == ["UC116"]
    folder.write({"whole.urdf": ROBOT})
    assert codes(folder) == []


def test_a_file_for_ros_2_beside_a_robot_of_ros_1_is_an_error_only_if_a_launch_file_loads_it(folder: Folder) -> None:
    launch = """<launch>
  <param name="robot_description" textfile="$(find arm)/urdf/arm.urdf"/>
  <rosparam command="load" file="$(find arm)/config/controllers.yaml"/>
  <node pkg="controller_manager" type="spawner" name="s" args="mover"/>
</launch>
"""
    interface = "<hardwareInterface>hardware_interface/PositionJointInterface</hardwareInterface>"
    transmission = (
        '<transmission name="t"><type>transmission_interface/SimpleTransmission</type>'
        f'<joint name="elbow">{interface}</joint>'
        '<actuator name="m"><mechanicalReduction>1</mechanicalReduction></actuator></transmission>'
    )
    robot = ROBOT.partition("  <ros2_control")[0] + transmission + "</robot>\n"
    folder.write({"package.xml": MANIFEST.replace("<depend>", "<buildtool_depend>catkin</buildtool_depend><depend>")})
    folder.write({"urdf/arm.urdf": robot, "config/controllers.yaml": CONTROLLERS.format("")})

    def found() -> list[str]:
        ran = folder.run("lint", ".", "--format", "json", "--distro", "noetic")
        return [each["severity"] for each in json.loads(ran.stdout)["findings"] if each["code"] == "UC402"]

    assert found() == ["warning"]
    folder.write({"launch/arm.launch": launch})
    assert found() == ["error"]


def test_a_dict_of_parameters_is_for_the_manager_in_its_namespace_only(folder: Folder) -> None:
    launch = """from launch import LaunchDescription
from launch.substitutions import Command
from launch_ros.actions import Node
from launch_ros.substitutions import FindPackageShare

def robot(namespace, kind):
    description = Command(["cat ", FindPackageShare("arm"), "/urdf/arm.urdf"])
    return [
        Node(package="robot_state_publisher", executable="robot_state_publisher", namespace=namespace,
             parameters=[{"robot_description": description}]),
        Node(package="controller_manager", executable="ros2_control_node", namespace=namespace,
             parameters=[[FindPackageShare("arm"), "/config/", namespace, ".yaml"], {"mover.type": kind}]),
        Node(package="controller_manager", executable="spawner", namespace=namespace, arguments=["mover"]),
    ]

def generate_launch_description():
    return LaunchDescription([
        *robot("left", "forward_command_controller/ForwardCommandController"),
        *robot("right", "joint_trajectory_controller/JointTrajectoryController"),
    ])
"""
    own = "/{}/mover:\n  ros__parameters: {{joints: [elbow], {}}}\n"
    both = "command_interfaces: [position], state_interfaces: [position]"
    write(folder, **{"config/left.yaml": own.format("left", "interface_name: position")})
    folder.write({"config/right.yaml": own.format("right", both), "launch/arm.launch.py": launch})
    folder.write({"launch/arm.launch.xml": "<launch/>"})
    assert [each["namespace"] for each in shown(folder) if each["launch"]] == ["/left", "/right"]
    assert codes(folder) == []


def test_a_launch_file_in_xml_with_nothing_but_commands_is_of_ros_2(folder: Folder) -> None:
    command = '<executable cmd="ros2 control load_controller --set-state active movre"/>'
    write(folder, PUBLISHER, manager(), **{"launch/spawn.launch.xml": f"<launch>{command}</launch>\n"})
    assert codes(folder) == ["UC601"]
