"""Faults that a newcomer planted, one at a time, into a package that gen-all made: each is found where it is edited.

The robot is a 6-axis arm with a two-finger mimic gripper, in xacro with macros; the package is for jazzy and gz.
"""

from __future__ import annotations

import json
import shutil
from pathlib import Path

import pytest
from folder import Folder
from generating import command

ARM = """\
<?xml version="1.0"?>
<robot name="arm" xmlns:xacro="http://www.ros.org/wiki/xacro">
  <xacro:arg name="prefix" default=""/>
  <xacro:property name="prefix" value="$(arg prefix)"/>
  <xacro:property name="width" value="0.1"/>
  <xacro:property name="depth" value="${width*2}"/>

  <!-- a solid box, and the joint that turns it -->
  <xacro:macro name="segment" params="name mass length">
    <link name="${prefix}${name}">
      <visual><geometry><box size="${width} ${depth} ${length}"/></geometry></visual>
      <collision><geometry><box size="${width} ${depth} ${length}"/></geometry></collision>
      <inertial>
        <mass value="${mass}"/>
        <inertia ixx="${mass*(depth**2+length**2)/12}" ixy="0" ixz="0"
                 iyy="${mass*(width**2+length**2)/12}" iyz="0" izz="${mass*(width**2+depth**2)/12}"/>
      </inertial>
    </link>
  </xacro:macro>

  <xacro:macro name="axis" params="name parent child xyz height">
    <joint name="${prefix}${name}" type="revolute">
      <origin xyz="0 0 ${height}"/>
      <parent link="${prefix}${parent}"/>
      <child link="${prefix}${child}"/>
      <axis xyz="${xyz}"/>
      <limit lower="-2.5" upper="2.5" effort="80" velocity="2"/>
      <dynamics damping="0.5"/>
    </joint>
  </xacro:macro>

  <xacro:macro name="finger" params="side y xyz *follows">
    <link name="${prefix}${side}_finger">
      <visual><geometry><box size="0.02 0.02 0.08"/></geometry></visual>
      <inertial>
        <mass value="0.1"/>
        <inertia ixx="0.0001" ixy="0" ixz="0" iyy="0.0001" iyz="0" izz="0.00001"/>
      </inertial>
    </link>
    <joint name="${prefix}${side}_finger_joint" type="prismatic">
      <origin xyz="0 ${y} 0.14"/>
      <parent link="${prefix}tool"/>
      <child link="${prefix}${side}_finger"/>
      <axis xyz="${xyz}"/>
      <limit lower="0" upper="0.04" effort="20" velocity="0.1"/>
      <xacro:insert_block name="follows"/>
    </joint>
  </xacro:macro>

  <link name="world"/>
  <joint name="mount" type="fixed">
    <parent link="world"/>
    <child link="${prefix}base"/>
  </joint>
  <xacro:segment name="base" mass="9" length="0.2"/>
  <xacro:axis name="joint_1" parent="base" child="turret" xyz="0 0 1" height="0.2"/>
  <xacro:segment name="turret" mass="4" length="0.2"/>
  <xacro:axis name="joint_2" parent="turret" child="upper_arm" xyz="0 1 0" height="0.2"/>
  <xacro:segment name="upper_arm" mass="3" length="0.3"/>
  <xacro:axis name="joint_3" parent="upper_arm" child="forearm" xyz="0 1 0" height="0.3"/>
  <xacro:segment name="forearm" mass="2" length="0.25"/>
  <xacro:axis name="joint_4" parent="forearm" child="wrist" xyz="0 0 1" height="0.25"/>
  <xacro:segment name="wrist" mass="1" length="0.1"/>
  <xacro:axis name="joint_5" parent="wrist" child="hand" xyz="0 1 0" height="0.1"/>
  <xacro:segment name="hand" mass="0.6" length="0.08"/>
  <xacro:axis name="joint_6" parent="hand" child="tool" xyz="0 0 1" height="0.08"/>
  <xacro:segment name="tool" mass="0.4" length="0.06"/>
  <xacro:finger side="left" y="0.02" xyz="0 1 0"><dynamics damping="1"/></xacro:finger>
  <xacro:finger side="right" y="-0.02" xyz="0 -1 0"><mimic joint="${prefix}left_finger_joint"/></xacro:finger>
</robot>
"""
PACKAGE = """\
<package format="3">
  <name>arm_description</name><version>0.1.0</version><description>An arm.</description>
  <maintainer email="you@example.com">you</maintainer><license>MIT</license>
  <buildtool_depend>ament_cmake</buildtool_depend><exec_depend>xacro</exec_depend>
  <export><build_type>ament_cmake</build_type></export>
</package>
"""
BUILD = """\
cmake_minimum_required(VERSION 3.8)
project(arm_description)
find_package(ament_cmake REQUIRED)
install(DIRECTORY urdf DESTINATION share/${PROJECT_NAME})
ament_package()
"""
ROBOT = "arm_description/urdf/arm.xacro"
WHOLE = "arm_control/urdf/robot.urdf.xacro"
CONTROL = "arm_control/urdf/control.xacro"
YAML = "arm_control/config/controllers.yaml"
LAUNCH = "arm_control/launch/control.launch.py"
CMAKE = "arm_control/CMakeLists.txt"
JOINTS = "[joint_1, joint_2, joint_3, joint_4, joint_5, joint_6, left_finger_joint]"
GZ_PLUGIN = 'filename="gz_ros2_control-system" name="gz_ros2_control::GazeboSimROS2ControlPlugin"'
WRIST = '<xacro:segment name="wrist" mass="1"'


@pytest.fixture(scope="module")
def package(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """The workspace as gen-all makes it."""
    workspace = tmp_path_factory.mktemp("made")
    description = workspace / "arm_description"
    (description / "urdf").mkdir(parents=True)
    (workspace / ROBOT).write_text(ARM, encoding="utf-8")
    (description / "package.xml").write_text(PACKAGE, encoding="utf-8")
    (description / "CMakeLists.txt").write_text(BUILD, encoding="utf-8")
    with pytest.MonkeyPatch.context() as patch:
        patch.chdir(workspace)
        options = ("--type", "trajectory", "--distro", "jazzy", "--simulator", "gz", "-o", "arm_control")
        made = command("gen-all", ROBOT, *options)
    assert made.returncode == 0, made.stderr
    return workspace


class Planted:
    """The workspace with one fault in it."""

    def __init__(self, folder: Folder, package: Path) -> None:
        self.path = folder.path / "ws"
        shutil.copytree(package, self.path)

    def replace(self, file: str, old: str, new: str) -> None:
        """Replace the first `old` in a file, which must be there."""
        path = self.path / file
        text = path.read_text(encoding="utf-8")
        assert old in text
        path.write_text(text.replace(old, new, 1), encoding="utf-8")

    def remove(self, file: str, start: str, end: str) -> None:
        """Remove the text from `start` to `end`, both included."""
        text = (self.path / file).read_text(encoding="utf-8")
        first = text.index(start)
        self.replace(file, text[first : text.index(end, first) + len(end)], "")

    def found(self, *options: str) -> list[str]:
        """Return the errors and warnings in the report's order: severity, file name, the line's text, message, fix."""
        answer = json.loads(command("lint", str(self.path), "--format", "json", *options).stdout)
        found = []
        for one in answer["findings"]:
            if one["severity"] == "info":
                continue
            lines = Path(one["file"]).read_text(encoding="utf-8").splitlines()
            where = lines[one["line"] - 1].strip()
            fix = (one.get("fix") or {}).get("title", "")
            found.append(f"{one['severity']} {Path(one['file']).name}: {where}: {one['message']} [{fix}]")
        return found

    def only(self, *options: str) -> str:
        """Return the only error or warning."""
        found = self.found(*options)
        assert len(found) == 1, found
        return found[0]


@pytest.fixture
def arm(folder: Folder, package: Path) -> Planted:
    return Planted(folder, package)


def test_the_package_is_sound(arm: Planted) -> None:
    assert arm.found() == []


# -- the robot ------------------------------------------------------------------------------------------------------


def test_a_missing_limit_in_a_macro(arm: Planted) -> None:
    arm.replace(ROBOT, '      <limit lower="-2.5" upper="2.5" effort="80" velocity="2"/>\n', "")
    assert 'error arm.xacro: <joint name="${prefix}${name}" type="revolute">: joint' in arm.only()
    assert "has no <limit>; add one" in arm.only()


def test_an_undeclared_argument_is_found_where_a_property_asks_for_it(arm: Planted) -> None:
    arm.replace(ROBOT, "$(arg prefix)", "$(arg prefx)")
    line = '<xacro:property name="prefix" value="$(arg prefx)"/>'
    message = "argument 'prefx' is not defined; did you mean 'prefix'? [write $(arg prefix)]"
    assert arm.only() == f"error arm.xacro: {line}: {message}"


def test_an_unknown_name_is_found_in_the_property_that_uses_it(arm: Planted) -> None:
    arm.replace(ROBOT, "${width*2}", "${widht*2}")
    found = arm.only()
    assert found.startswith("""error arm.xacro: <xacro:property name="depth" value="${widht*2}"/>: 'widht' is not""")
    assert found.endswith("did you mean 'width'? [write 'width']")


def test_a_missing_brace_is_found_in_the_property(arm: Planted) -> None:
    arm.replace(ROBOT, "${width*2}", "${width*2")
    line = '<xacro:property name="depth" value="${width*2"/>'
    assert arm.only() == f"error arm.xacro: {line}: '${{width*2' is not a valid expression: '}}' is missing []"


def test_an_inertia_that_no_body_has_is_refused_by_gz(arm: Planted) -> None:
    arm.replace(ROBOT, 'izz="${mass*(width**2+depth**2)/12}"', 'izz="-0.1"')
    assert arm.only().startswith('error arm.xacro: <inertia ixx="${mass*(depth**2+length**2)/12}" ixy="0" ixz="0": ')
    assert "is impossible: moment -0.1 is negative; gz rejects the robot" in arm.only()


@pytest.mark.parametrize(
    "moments", ['ixx="0" ixy="0" ixz="0" iyy="0" iyz="0" izz="0"', 'ixx="1" ixy="0" ixz="0" iyy="1" iyz="0" izz="0"']
)
def test_an_inertia_of_zero(arm: Planted, moments: str) -> None:
    arm.remove(ROBOT, '<inertia ixx="${mass*(depth', '/12}"/>')
    arm.replace(ROBOT, '<mass value="${mass}"/>', f'<mass value="${{mass}}"/><inertia {moments}/>')
    found = arm.only()
    assert found.startswith(f'error arm.xacro: <mass value="${{mass}}"/><inertia {moments}/>: <inertia> of link')
    assert "has a moment of 0, but the link moves and has mass" in found


def test_an_inertia_that_no_body_has_is_a_warning_without_gz(arm: Planted, folder: Folder) -> None:
    folder.write({"alone.urdf": ALONE.format('ixx="1" iyy="1" izz="-1"')})
    answer = json.loads(command("lint", "alone.urdf", "--simulator", "none", "--format", "json").stdout)
    assert [(one["code"], one["severity"]) for one in answer["findings"]] == [("UC136", "warning")]


ALONE = """\
<robot name="r">
  <link name="base"/>
  <link name="tool"><inertial><mass value="1"/><inertia {} ixy="0" ixz="0" iyz="0"/></inertial></link>
  <joint name="j" type="continuous"><parent link="base"/><child link="tool"/><axis xyz="0 0 1"/></joint>
</robot>
"""


def test_a_moving_link_without_mass_is_found_at_the_call_that_gives_it(arm: Planted) -> None:
    arm.replace(ROBOT, WRIST, WRIST.replace("1", "0"))
    line = '<xacro:segment name="wrist" mass="0" length="0.1"/>'
    message = "link 'wrist' moves but has no mass; Gazebo drops it and everything below it"
    assert arm.only() == f"error arm.xacro: {line}: {message} []"


def test_a_zero_axis_is_found_at_the_call_that_gives_it(arm: Planted) -> None:
    arm.replace(ROBOT, 'child="wrist" xyz="0 0 1"', 'child="wrist" xyz="0 0 0"')
    line = '<xacro:axis name="joint_4" parent="forearm" child="wrist" xyz="0 0 0" height="0.25"/>'
    assert arm.only() == f"error arm.xacro: {line}: <axis> of joint 'joint_4' is 0 0 0; give it a direction []"


def test_a_link_misspelt_in_a_macro_is_found_in_the_macro(arm: Planted) -> None:
    arm.replace(ROBOT, '<child link="${prefix}${side}_finger"/>', '<child link="${prefix}${side}_fingr"/>')
    found = arm.only()
    assert found.startswith("error arm.xacro: <child link=\"${prefix}${side}_fingr\"/>: child link 'left_fingr'")
    assert found.endswith("did you mean 'left_finger'? [write '${prefix}${side}_finger']")


def test_a_link_misspelt_at_the_call_of_a_macro_is_found_at_the_call(arm: Planted) -> None:
    arm.replace(ROBOT, 'child="wrist"', 'child="wrst"')
    line = '<xacro:axis name="joint_4" parent="forearm" child="wrst" xyz="0 0 1" height="0.25"/>'
    message = "child link 'wrst' of joint 'joint_4' is not defined; did you mean 'wrist'? [write 'wrist']"
    assert arm.only() == f"error arm.xacro: {line}: {message}"


@pytest.mark.parametrize("name", ["axis", "segment"])
def test_a_macro_call_without_the_prefix(arm: Planted, name: str) -> None:
    arm.replace(ROBOT, f"<xacro:{name} name", f"<{name} name")
    found = arm.only()
    assert found.startswith(f"error arm.xacro: <{name} name=")
    assert f"macro call <{name}> needs the prefix: <xacro:{name}>." in found


def test_a_macro_call_without_a_parameter(arm: Planted) -> None:
    arm.replace(ROBOT, ' child="wrist" xyz', " xyz")
    line = '<xacro:axis name="joint_4" parent="forearm" xyz="0 0 1" height="0.25"/>'
    assert arm.only() == f"error arm.xacro: {line}: the macro call passes no value for 'child' []"


# -- XML by name ----------------------------------------------------------------------------------------------------

COMMENT = "a solid box, and the joint that turns it"


@pytest.mark.parametrize(
    ("old", "new", "message"),
    [
        (COMMENT, "a -- b", "'--' in the comment that begins in line 8; XML does not allow it inside a comment"),
        (COMMENT, "a <!-- b -->", "a comment inside the comment that begins in line 8; XML comments cannot be nested"),
        ('name="wrist" mass', 'name="wrist mass', "the value of attribute 'name' has no closing quote"),
        ('name="wrist" mass', 'name=wrist" mass', "the value of attribute 'name' has no quotes"),
        ("${width*2}", "${1 && 2}", "'&&' is not valid in XML, nor in an expression of xacro"),
        ("${width*2}", "${1 < 2}", "'<' is not allowed in the value of an attribute"),
    ],
)
def test_a_mistake_in_xml_is_named_at_its_line(arm: Planted, old: str, new: str, message: str) -> None:
    arm.replace(ROBOT, old, new)
    changed = next(line for line in (arm.path / ROBOT).read_text().splitlines() if new in line).strip()
    assert arm.only().startswith(f"error arm.xacro: {changed}: {message} [")


def test_a_prefix_that_is_not_declared_is_found_at_the_root(arm: Planted) -> None:
    arm.replace(ROBOT, ' xmlns:xacro="http://www.ros.org/wiki/xacro"', "")
    fix = 'add xmlns:xacro="http://www.ros.org/wiki/xacro" to the root element'
    message = "prefix 'xacro:' is not declared in the root element"
    assert arm.only() == f'error arm.xacro: <robot name="arm">: {message} [{fix}]'


# -- <ros2_control> and the plugin ----------------------------------------------------------------------------------


@pytest.mark.parametrize("options", [(), ("--simulator", "gz")])
def test_a_forgotten_simulator_plugin(arm: Planted, options: tuple[str, ...]) -> None:
    arm.remove(CONTROL, "  <gazebo>", "</gazebo>\n")
    found = arm.only(*options)
    assert found.startswith("error control.xacro: <plugin>gz_ros2_control/GazeboSimSystem</plugin>: ")
    assert "but no <plugin> of the robot loads it there [add <gazebo><plugin filename=" in found


@pytest.mark.parametrize("options", [(), ("--simulator", "gz")])
def test_the_plugin_of_gazebo_classic_under_gz(arm: Planted, options: tuple[str, ...]) -> None:
    classic = 'filename="libgazebo_ros2_control.so" name="gazebo_ros2_control"'
    arm.replace(CONTROL, GZ_PLUGIN, classic)
    found = arm.only(*options)
    assert found.startswith(
        f"error control.xacro: <plugin {classic}>: plugin 'libgazebo_ros2_control.so' is for Gazebo"
    )
    assert found.endswith(f"[in gz use {GZ_PLUGIN}]")


def test_the_include_of_ros2_control_deleted(arm: Planted) -> None:
    arm.replace(WHOLE, '  <xacro:include filename="$(find arm_control)/urdf/control.xacro"/>\n', "")
    found = arm.only()
    assert found.startswith('error robot.urdf.xacro: <robot name="arm" xmlns:xacro=')
    assert "robot has controllers, but no <ros2_control>" in found


def test_the_controller_file_of_the_plugin_does_not_exist(arm: Planted) -> None:
    arm.replace(CONTROL, "config/controllers.yaml", "config/controler.yaml")
    line = "<parameters>$(find arm_control)/config/controler.yaml</parameters>"
    assert arm.only().startswith(f"error control.xacro: {line}: controller file of 'gz_ros2_control-system' does not")


def test_a_misspelt_package_is_found_with_the_right_name(arm: Planted) -> None:
    arm.replace(WHOLE, "$(find arm_control)", "$(find arm_contol)")
    found = arm.only()
    assert found.startswith('error robot.urdf.xacro: <xacro:include filename="$(find arm_contol)/urdf/control.xacro"/>')
    assert found.endswith("did you mean 'arm_control'? [write 'arm_control']")


def test_a_joint_missing_in_ros2_control_is_not_taken_for_a_misspelt_one(arm: Planted) -> None:
    arm.remove(CONTROL, '    <joint name="joint_4">', "</joint>\n")
    found = arm.only()
    assert found.startswith(f"error controllers.yaml: joints: {JOINTS}")
    assert "joint 'joint_4' is in the robot, but not in <ros2_control>" in found


def test_a_mimic_joint_missing_in_ros2_control(arm: Planted) -> None:
    arm.remove(CONTROL, '    <joint name="right_finger_joint">', "</joint>\n")
    found = arm.only()
    assert found.startswith('warning arm.xacro: <joint name="${prefix}${side}_finger_joint" type="prismatic">: mimic')
    assert 'add <joint name="right_finger_joint"> with state interfaces only' in found


# -- the controller file --------------------------------------------------------------------------------------------


@pytest.mark.parametrize(
    ("old", "new", "line", "message"),
    [
        ("joint_3, ", "joint_33, ", "joints: [", "names joint 'joint_33', which the robot does not have"),
        ("[position]", "[velocity]", "command_interfaces: [velocity]", "have no 'velocity' command interface"),
        ("JointTrajectoryC", "JointTrajectorC", "type: joint_t", "did you mean 'joint_trajectory_controller/JointTraj"),
        ("update_rate: 100", "update_rate: fast", "update_rate:", "must be an integer, not the string 'fast'"),
        ("ros__parameters:\n    j", "ros_parameters:\n    j", "ros_parameters:", "should be 'ros__parameters'"),
        (
            "  ros__parameters:\n    joints",
            "    joints",
            '"/**/joint_trajectory_controller":',
            "'ros__parameters:' is missing",
        ),
        ("    update_rate", "\tupdate_rate", "update_rate", "indented with a tab, which YAML does not allow"),
        (f"joints: {JOINTS}", f"joints: !!python/tuple {JOINTS}", "joints: ", "'!!python/tuple' makes a Python object"),
        ("/**/joint_t", "/arm/joint_t", '"/arm/joint_t', "matches no node; the controller is '/joint_t"),
        ("update_rate", "updaterate", "updaterate: 100", "has no parameter 'updaterate'; did you mean 'update_rate'?"),
    ],
)
def test_a_fault_in_the_controller_file(arm: Planted, old: str, new: str, line: str, message: str) -> None:
    arm.replace(YAML, old, new)
    found = arm.found()
    assert len(found) == 1, found
    assert found[0].startswith(("warning" if "updaterate" in new else "error") + f" controllers.yaml: {line}")
    assert message in found[0]


def test_an_effort_controller_of_a_position_interface(arm: Planted) -> None:
    kind = "effort_controllers/JointGroupEffortController"
    arm.replace(YAML, "joint_trajectory_controller/JointTrajectoryController", kind)
    found = arm.found()[0]
    assert found.startswith(f"error controllers.yaml: type: {kind}: ")
    assert "have no 'effort' command interface" in found


def test_a_number_without_decimal_point(arm: Planted) -> None:
    arm.replace(YAML, "goal_time: 1.0", "goal_time: 1")
    assert arm.only().startswith("error controllers.yaml: goal_time: 1  # s after the end")
    assert "'constraints.goal_time' must be a number with a decimal point" in arm.only()
    assert arm.only().endswith("[add a decimal point]")


def test_a_controller_file_of_comments_is_reported_as_that_once(arm: Planted) -> None:
    (arm.path / YAML).write_text("# nothing yet\n")
    message = "controller file has only comments, but controller 'joint_state_broadcaster' is spawned"
    assert arm.only() == f"error controllers.yaml: # nothing yet: {message} []"


def test_a_controller_file_without_indentation_is_reported_as_that_once(arm: Planted) -> None:
    text = (arm.path / YAML).read_text()
    (arm.path / YAML).write_text("\n".join(line.lstrip() for line in text.splitlines()))
    assert arm.only().startswith(
        "error controllers.yaml: ros__parameters:: 'ros__parameters' is not indented below '/**/controller_manager'"
    )


# -- launch and installation ----------------------------------------------------------------------------------------


def test_a_broadcaster_that_no_file_declares(arm: Planted) -> None:
    arm.remove(YAML, "    joint_state_broadcaster:", "JointStateBroadcaster\n")
    line = '"joint_state_broadcaster",'
    assert arm.only().startswith(
        f"error control.launch.py: {line}: controller 'joint_state_broadcaster' is spawned, but"
    )


def test_a_misspelt_spawned_controller(arm: Planted) -> None:
    arm.replace(LAUNCH, '            "joint_trajectory_controller",', '            "joint_trajectory_controler",')
    found = arm.only()
    assert found.startswith('error control.launch.py: "joint_trajectory_controler",: controller')
    assert found.endswith("did you mean 'joint_trajectory_controller'? [write 'joint_trajectory_controller']")


def test_a_broadcaster_whose_spawner_is_not_started_is_missed_at_that_spawner(arm: Planted) -> None:
    arm.replace(LAUNCH, "target_action=robot, on_exit=[spawner_1]", "target_action=robot, on_exit=[spawner_2]")
    arm.remove(LAUNCH, "            RegisterEventHandler(OnProcessExit(target_action=spawner_1", "\n")
    found = arm.only()
    assert found.startswith("warning control.launch.py: spawner_1 = Node(: 'spawner_1' is created, but not started")


def test_a_state_publisher_without_the_time_of_the_simulator(arm: Planted) -> None:
    line = 'parameters=[robot_description, {"use_sim_time": False, "frame_prefix": frame_prefix}],'
    arm.replace(LAUNCH, line.replace("False", "True"), line)
    message = "'robot_state_publisher' has use_sim_time false, but a simulator runs; set it to true"
    assert arm.only() == f"warning control.launch.py: {line}: {message} []"


def test_a_folder_that_is_not_installed(arm: Planted) -> None:
    arm.replace(CMAKE, "config launch", "launch")
    assert arm.only().startswith("error control.launch.py: controllers_file = ")
    assert "'config/controllers.yaml' is not installed: CMakeLists.txt does not list folder 'config'" in arm.only()
