"""Robots that `lint --fix` mends."""

from __future__ import annotations

HEAD = """\
<robot name="arm">
  <link name="world"/>
  <link name="tip">
    <inertial><mass value="1"/><inertia ixx="1" ixy="0" ixz="0" iyy="1" iyz="0" izz="1"/></inertial>
  </link>
  <joint name="elbow" type="revolute">
    <parent link="world"/><child link="tip"/><limit lower="-1" upper="1" effort="1" velocity="1"/>
  </joint>
"""
PLAIN = """\
  <transmission name="elbow_trans">
    <type>transmission_interface/SimpleTransmission</type>
    <joint name="elbow">
      <hardwareInterface>EffortJointInterface</hardwareInterface>
    </joint>
    <actuator name="elbow_motor"><mechanicalReduction>1</mechanicalReduction></actuator>
  </transmission>
</robot>
"""
ARM = HEAD + PLAIN
