"""Transmissions in macros that make a result of their own kind: several for one joint, and macros in a namespace."""

from __future__ import annotations

from folder import Folder
from ros1_packages import migrated

MACROS = """\
<robot xmlns:xacro="http://www.ros.org/wiki/xacro">
  <xacro:macro name="limb" params="side:=left *pose">
    <link name="${side}_foot"/>
    <joint name="${side}_knee" type="continuous">
      <xacro:insert_block name="pose"/><parent link="body"/><child link="${side}_foot"/>
    </joint>
    <transmission name="${side}_t"><type>transmission_interface/SimpleTransmission</type>
      <joint name="${side}_knee"><hardwareInterface>hardware_interface/EffortJointInterface</hardwareInterface></joint>
      <actuator name="${side}_m"/></transmission>
  </xacro:macro>
</robot>
"""
WALKER = """\
<robot name="walker" xmlns:xacro="http://www.ros.org/wiki/xacro">
  <xacro:include filename="limbs.xacro" ns="parts"/>
  <link name="body"/>
  <xacro:parts.limb><origin xyz="0 1 0"/></xacro:parts.limb>
  <xacro:call macro="parts.limb" side="right"><origin xyz="0 -1 0"/></xacro:call>
</robot>
"""
BOTH = """\
<robot name="{name}">
  <link name="body"/><link name="foot"/>
  <joint name="knee" type="revolute"><parent link="body"/><child link="foot"/>
    <limit lower="-1" upper="1" effort="1" velocity="1"/></joint>
{transmissions}
</robot>
"""
ONE = """\
  <transmission name="{kind}"><type>transmission_interface/SimpleTransmission</type>
    <joint name="knee"><hardwareInterface>hardware_interface/{kind}JointInterface</hardwareInterface></joint>
    <actuator name="m"/></transmission>
"""


def expanded(folder: Folder, path: str) -> str:
    ran = folder.run("expand", path)
    assert ran.returncode == 0, ran.stderr
    return ran.stdout


def test_macros_of_a_file_in_a_namespace_are_called_by_their_new_names(folder: Folder) -> None:
    after = migrated(folder, {"limbs.xacro": MACROS, "walker.urdf.xacro": WALKER}, "--simulator", "none")
    assert "<xacro:parts.limb_ros2_control/>" in after["walker.urdf.xacro"]
    assert '<xacro:call macro="parts.limb_ros2_control" side="right"/>' in after["walker.urdf.xacro"]
    text = expanded(folder, "new/walker.urdf.xacro")
    assert text.count('<link name="left_foot"/>') == 1
    assert text.count('<command_interface name="effort"/>') == 2


def test_a_joint_with_a_transmission_for_each_interface_is_in_the_component_once(folder: Folder) -> None:
    both = "".join(ONE.format(kind=kind) for kind in ("Position", "Velocity"))
    after = migrated(folder, {"knee.urdf": BOTH.format(name="knee", transmissions=both)}, "--simulator", "none")
    component = after["knee.urdf"].partition("<ros2_control")[2]
    assert component.count('<joint name="knee">') == 1
    assert component.index('<command_interface name="position"/>') < component.index(
        '<command_interface name="velocity"/>'
    )
    assert "<transmission" not in after["knee.urdf"]


SHARED = """\
<robot xmlns:xacro="http://www.ros.org/wiki/xacro">
  <xacro:macro name="motor" params="joint">
    <transmission name="${joint}_t"><type>transmission_interface/SimpleTransmission</type>
      <joint name="${joint}"><hardwareInterface>PositionJointInterface</hardwareInterface>
        <hardwareInterface>VelocityJointInterface</hardwareInterface></joint>
      <actuator name="${joint}_m"/></transmission>
  </xacro:macro>
</robot>
"""
UNUSED = """\
<robot xmlns:xacro="http://www.ros.org/wiki/xacro">
  <xacro:include filename="motor.xacro"/>
  <xacro:macro name="old_arm" params="name">
    <xacro:motor joint="${name}"/><xacro:motor joint="${name}"/>
  </xacro:macro>
</robot>
"""


def test_the_joints_of_a_macro_that_nothing_calls_are_not_taken_for_one(folder: Folder) -> None:
    motor = '  <xacro:include filename="motor.xacro"/>\n  <xacro:motor joint="knee"/>'
    robot = BOTH.format(name='knee" xmlns:xacro="http://www.ros.org/wiki/xacro', transmissions=motor)
    files = {"motor.xacro": SHARED, "old_arm.xacro": UNUSED, "knee.urdf.xacro": robot}
    migrated(folder, files, "--simulator", "gz")
    component = expanded(folder, "new/knee.urdf.xacro").partition("<ros2_control")[2]
    assert '<command_interface name="position"/>' in component
    assert '<command_interface name="velocity"/>' in component


HAND = """\
<robot name="hand" xmlns:xacro="http://www.ros.org/wiki/xacro">
  <link name="body"/>
  <xacro:macro name="simple" params="name number">
    <transmission name="${name}_${number}_t"><type>transmission_interface/SimpleTransmission</type>
      <joint name="${name}_${number}"><hardwareInterface>hardware_interface/{kind}</hardwareInterface></joint>
      <actuator name="${name}_${number}_m"/></transmission>
  </xacro:macro>
  <xacro:macro name="hinge" params="name parent *more">
    <link name="${name}_link"/>
    <joint name="${name}" type="revolute"><parent link="${parent}"/><child link="${name}_link"/>
      <limit lower="-1" upper="1" effort="1" velocity="1"/><xacro:insert_block name="more"/></joint>
  </xacro:macro>
  <xacro:macro name="arm" params="name">
    <xacro:hinge name="${name}_1" parent="body"><axis xyz="0 0 1"/></xacro:hinge>
    <xacro:hinge name="${name}_2" parent="body"><axis xyz="0 0 1"/></xacro:hinge>
    <xacro:simple name="${name}" number="1"/><xacro:simple name="${name}" number="2"/>
  </xacro:macro>
  <xacro:macro name="gripper" params="name">
    <xacro:hinge name="${name}_joint" parent="body"><axis xyz="0 0 1"/></xacro:hinge>
    <xacro:hinge name="${name}_finger" parent="body"><mimic joint="${name}_joint"/></xacro:hinge>
    <transmission name="${name}_t"><type>transmission_interface/SimpleTransmission</type>
      <joint name="${name}_joint"><hardwareInterface>hardware_interface/{kind}</hardwareInterface></joint>
      <actuator name="${name}_m"/></transmission>
  </xacro:macro>
  <xacro:arm name="arm"/>
  <xacro:gripper name="gripper"/>
</robot>
""".replace("{kind}", "PositionJointInterface")


def test_a_joint_that_mimics_another_is_in_the_component_of_that_one_only(folder: Folder) -> None:
    migrated(folder, {"hand.urdf.xacro": HAND}, "--simulator", "gz")
    text = expanded(folder, "new/hand.urdf.xacro")
    components = text.split("<ros2_control")[1:]
    assert len(components) == 2
    assert [part.count("gripper_finger") for part in (one.partition("</ros2_control>")[0] for one in components)] == [
        0,
        1,
    ]


SPARE = """\
<robot xmlns:xacro="http://www.ros.org/wiki/xacro">
  <xacro:macro name="toe" params="side">
    <link name="${side}_toe"/>
    <joint name="${side}_bend" type="continuous"><parent link="body"/><child link="${side}_toe"/></joint>
    <transmission name="${side}_t"><type>transmission_interface/SimpleTransmission</type>
      <joint name="${side}_bend"><hardwareInterface>hardware_interface/EffortJointInterface</hardwareInterface></joint>
      <actuator name="${side}_m"/></transmission>
  </xacro:macro>
  <xacro:macro name="fore_paw" params="side"><xacro:toe side="${side}"/></xacro:macro>
  <xacro:macro name="hind_paw" params="side"><xacro:toe side="${side}"/></xacro:macro>
</robot>
"""


def test_macros_that_no_robot_calls_do_not_keep_the_robot_from_its_components(folder: Folder) -> None:
    """They are expanded for themselves: the definition of one is where it is called, too."""
    robots = {"limbs.xacro": MACROS, "walker.urdf.xacro": WALKER}
    after = migrated(folder, {**robots, "old/paws.xacro": SPARE}, "--simulator", "none")
    assert "has no counterpart in ROS 2" not in after["MIGRATION.md"]
    assert "<xacro:parts.limb_ros2_control/>" in after["walker.urdf.xacro"]
    assert after["old/paws.xacro"].count('<xacro:toe_ros2_control side="${side}"/>') == 2
