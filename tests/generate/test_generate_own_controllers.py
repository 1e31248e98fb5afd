"""MoveIt's configuration of a robot whose simulator's plugin loads controllers from a file of its own."""

from __future__ import annotations

import xml.etree.ElementTree as ET
from pathlib import Path

import pytest
import yaml
from folder import Folder
from generating import command
from planned_arm import JAZZY, ROW, arm, semantic

pytest.importorskip("mujoco")

PLUGIN = "the simulator's plugin in the robot"
REMEDY = "leave it out by an argument of the robot"
OTHERWISE = "name a description without the plugin, or leave it out by an argument"
THE_TYPE = "the type of the robot's own controller"
TRAJECTORY = "joint_trajectory_controller/JointTrajectoryController"
SIMULATED = "gz_ros2_control/GazeboSimSystem"
OWN_FILE = """controller_manager:
  ros__parameters:
    update_rate: 100
    publisher: {type: joint_state_broadcaster/JointStateBroadcaster}
    joint_trajectory_controller: {type: joint_trajectory_controller/JointTrajectoryController}
    scaled_controller: {type: joint_trajectory_controller/JointTrajectoryController}
    wrist: {type: position_controllers/JointGroupPositionController}
joint_trajectory_controller:
  ros__parameters:
    joints: [pan, lift, elbow, roll, bend, turn]
    command_interfaces: [position]
    state_interfaces: [position, velocity]
scaled_controller:
  ros__parameters:
    joints: [pan, lift, elbow, roll, bend, turn]
    command_interfaces: [position]
    state_interfaces: [position, velocity]
wrist: {ros__parameters: {joints: [turn]}}
"""


def with_own_controllers(folder: Folder, hardware: str, more: str = "", controllers: str = OWN_FILE) -> str:
    """Return the arm, fixed to the world, whose simulator's plugin loads controllers of its own."""
    offered = '<command_interface name="position"/><state_interface name="position"/><state_interface name="velocity"/>'
    moved = "".join(
        f'<joint name="{name}">{offered}</joint>' for name in (*(name for name, _, _ in ROW), "left_finger_joint")
    )
    component = f"""<ros2_control name="own" type="system"><hardware><plugin>{hardware}</plugin></hardware>
      {moved}</ros2_control>"""
    folder.write({"own.yaml": controllers})
    plugin = f"""<gazebo><plugin filename="gz_ros2_control-system"
      name="gz_ros2_control::GazeboSimROS2ControlPlugin"><parameters>{folder.path}/own.yaml</parameters>{more}
      </plugin></gazebo>"""
    fixed = f"""<link name="world"/><joint name="stand" type="fixed"><parent link="world"/><child link="base_link"/>
      </joint>{plugin}{component}"""
    return arm().replace("</robot>", f"{fixed}</robot>")


def test_moveit_uses_the_controllers_that_the_plugin_of_a_simulated_robot_loads(folder: Folder) -> None:
    folder.write({"six.urdf": with_own_controllers(folder, SIMULATED)})
    ran = command("gen-moveit", "six.urdf", *JAZZY)
    assert "MoveIt uses the controllers of 'own.yaml', which the simulator's plugin in the robot loads" in ran.stderr
    listed = yaml.safe_load(Path("out/config/moveit_controllers.yaml").read_text())["moveit_simple_controller_manager"]
    assert listed["controller_names"] == ["joint_trajectory_controller"]
    assert listed["joint_trajectory_controller"]["joints"] == [name for name, _, _ in ROW]
    assert [group.get("name") for group in semantic(folder).findall("group")] == ["arm", "gripper"]
    launched = Path("out/launch/control.launch.py").read_text()
    assert '"publisher"' in launched
    assert '"joint_trajectory_controller"' in launched
    assert "scaled_controller" not in launched
    assert not Path("out/config/controllers.yaml").exists()
    assert not Path("out/urdf/control.xacro").exists()
    assert command("lint", "out", "--format", "concise", "--fail-on", "error").returncode == 0
    assert command("gen-check", "out") == (0, "", "")


def test_an_own_controller_of_a_finger_that_follows_has_the_group_of_the_whole_hand(folder: Folder) -> None:
    moved = OWN_FILE.replace("    wrist:", f"    fist: {{type: {TRAJECTORY}}}\n    wrist:")
    moved += "fist: {ros__parameters: {joints: [right_finger_joint], command_interfaces: [position],"
    moved += " state_interfaces: [position, velocity]}}\n"
    text = with_own_controllers(folder, SIMULATED, controllers=moved)
    folder.write(
        {"six.urdf": text.replace('<joint name="left_finger_joint"><c', '<joint name="right_finger_joint"><c')}
    )
    ran = command("gen-moveit", "six.urdf", *JAZZY, "--force")  # it has a command interface, which a follower must not
    assert "no controller of the robot moves group 'fist', which MoveIt can plan for and not move" in ran.stderr
    groups = {one.get("name"): [part.get("name") for part in one] for one in semantic(folder).findall("group[joint]")}
    assert groups == {"fist": ["left_finger_joint", "right_finger_joint"]}
    assert [one.get("group") for one in semantic(folder).findall("end_effector")] == ["fist"]


MANIFEST = """<package format="3"><name>base</name><version>0.0.0</version><description>a</description>
  <maintainer email="a@b.cc">a</maintainer><license>a</license></package>"""


@pytest.mark.parametrize("form", ["python", "xml", "yaml"])
def test_a_spawner_of_lyrical_gets_the_parameters_of_own_controllers_from_their_package(
    form: str, folder: Folder
) -> None:
    listed = "\n".join(line for line in OWN_FILE.splitlines() if "wrist" not in line)
    text = with_own_controllers(folder, SIMULATED, controllers=listed)
    folder.write({"six.urdf": text, "package.xml": MANIFEST})
    words = ["--distro", "lyrical", "--samples", "10", "--form", form, "-o", "out"]
    ran = command("gen-moveit", "six.urdf", *words)
    assert ran.returncode == 0, ran.stderr
    [launched] = Path("out/launch").glob("control.launch.*")
    assert "--param-file" in launched.read_text()
    assert "<exec_depend>base</exec_depend>" in Path("out/package.xml").read_text()
    assert command("lint", "out", "--fail-on", "error").returncode == 0
    assert command("gen-check", "out") == (0, "", "")


def test_a_tool_that_no_own_controller_moves_is_an_end_effector_all_the_same(folder: Folder) -> None:
    folder.write({"six.urdf": with_own_controllers(folder, SIMULATED)})
    ran = command("gen-moveit", "six.urdf", *JAZZY)
    assert "no controller of the robot moves group 'gripper', which MoveIt can plan for and not move" in ran.stderr
    [effector] = semantic(folder).findall("end_effector")
    assert effector.attrib == {"name": "gripper", "parent_link": "hand", "group": "gripper", "parent_group": "arm"}
    moved = OWN_FILE.replace("    wrist:", f"    fist: {{type: {TRAJECTORY}}}\n    wrist:")
    moved += "fist: {ros__parameters: {joints: [left_finger_joint], command_interfaces: [position],"
    moved += " state_interfaces: [position, velocity]}}\n"
    folder.write({"six.urdf": with_own_controllers(folder, SIMULATED, controllers=moved)})
    ran = command("gen-moveit", "six.urdf", *JAZZY[:-1], "moved")
    assert (ran.returncode, "moves group" in ran.stderr) == (0, False), ran.stderr
    root = ET.parse("moved/config/six.srdf").getroot()
    assert [one.attrib["group"] for one in root.findall("end_effector")] == ["fist"]


def test_a_robot_with_mock_hardware_is_started_without_the_simulator_that_its_plugin_is_for(folder: Folder) -> None:
    folder.write({"six.urdf": with_own_controllers(folder, "mock_components/GenericSystem")})
    ran = command("gen-moveit", "six.urdf", *JAZZY)
    assert "written for the hardware in the robot, without a simulator" in ran.stderr
    assert (
        'package="controller_manager",\n        executable="ros2_control_node"'
        in Path("out/launch/control.launch.py").read_text()
    )
    assert command("smoke", "out", "--engine", "none").returncode == 0


@pytest.mark.parametrize(
    ("more", "controllers", "said"),
    [
        (
            "<ros><namespace>/one</namespace></ros>",
            OWN_FILE,
            f"{PLUGIN} runs its controllers in namespace 'one', and MoveIt's configuration has no namespace: {REMEDY}",
        ),
        (
            "",
            OWN_FILE.replace("joint_trajectory_controller/J", "own/J"),
            f"jazzy has no 'own/JointTrajectoryController', {THE_TYPE} 'joint_trajectory_controller'",
        ),
        (
            "",
            OWN_FILE.replace("[pan,", "[pam,"),
            "the robot's own controller 'joint_trajectory_controller' names joint 'pam', which the robot lacks",
        ),
        (
            "",
            OWN_FILE.replace("joint_trajectory_controller/JointT", "own/T"),
            f"{PLUGIN} loads the controllers of 'own.yaml', and not these: {OTHERWISE}",
        ),
    ],
)
def test_own_controllers_that_moveit_cannot_use_are_one_line_and_nothing_is_written(
    more: str, controllers: str, said: str, folder: Folder
) -> None:
    folder.write({"six.urdf": with_own_controllers(folder, SIMULATED, more, controllers)})
    ran = command("gen-moveit", "six.urdf", *JAZZY)
    assert (ran.returncode, ran.stderr.splitlines()[-1]) == (2, f"urdfctl: {said}")
    assert not Path("out").exists()


def test_of_own_controllers_for_the_same_joints_the_first_of_a_known_type_is_used(folder: Folder) -> None:
    own = OWN_FILE.replace("joint_trajectory_controller/J", "own/J", 1)
    folder.write({"six.urdf": with_own_controllers(folder, SIMULATED, controllers=own)})
    assert command("gen-moveit", "six.urdf", *JAZZY, "--force").returncode == 0
    listed = yaml.safe_load(Path("out/config/moveit_controllers.yaml").read_text())["moveit_simple_controller_manager"]
    assert listed["controller_names"] == ["scaled_controller"]


@pytest.mark.parametrize(
    ("space", "words", "status", "said"),
    [
        ("/one", (), 0, "written for MoveIt's fake controllers, without a simulator"),
        ("/one", ("--simulator", "gazebo-classic"), 2, "runs its controllers in namespace 'one'"),
        ("/", ("--simulator", "gazebo-classic"), 0, ""),
    ],
)
def test_in_noetic_a_simulator_that_runs_its_controllers_in_a_namespace_is_left_alone(
    space: str, words: tuple[str, ...], status: int, said: str, folder: Folder
) -> None:
    plugin = f"""<gazebo><plugin filename="libgazebo_ros_control.so" name="control">
      <robotNamespace>{space}</robotNamespace></plugin></gazebo></robot>"""
    folder.write({"six.urdf": arm().replace("</robot>", plugin)})
    ran = command("gen-moveit", "six.urdf", "--distro", "noetic", "--samples", "10", "-o", "out", *words)
    assert ran.returncode == status, ran.stderr
    assert said in ran.stderr
    assert Path("out").exists() is not bool(status)
