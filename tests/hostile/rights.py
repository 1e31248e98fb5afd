"""Files that may not be read or written, and disks without room: a command line, and what is said or which file stays.

`secret.urdf`, `secret.log` and the folder `shut` may not be read; nothing may be made in the folder.
"""

from __future__ import annotations

GEN = "--type effort --distro noetic"
ROBOT = """\
<robot name="arm">
  <link name="base"/><link name="fore"/>
  <joint name="elbow" type="revolute">
    <parent link="base"/><child link="fore"/><axis xyz="0 0 1"/><limit lower="-1" upper="1" effort="1" velocity="1"/>
  </joint>
  <transmission name="t">
    <type>transmission_interface/SimpleTransmission</type>
    <joint name="elbow"><hardwareInterface>PositionJointInterface</hardwareInterface></joint>
    <actuator name="m"><mechanicalReduction>1</mechanicalReduction></actuator>
  </transmission>
  <gazebo reference="bas"><mu1>0.9</mu1></gazebo>
</robot>
"""
BARE = """\
<robot name="arm">
  <link name="base"/><link name="fore"/>
  <joint name="elbow" type="revolute">
    <parent link="base"/><child link="fore"/><axis xyz="0 0 1"/><limit lower="-1" upper="1" effort="1" velocity="1"/>
  </joint>
</robot>
"""

FORBIDDEN = [
    ("lint a.urdf --write-baseline k.json", "'k.json' cannot be written: Permission denied"),
    ("lint a.urdf --format json=o.json", "'o.json' cannot be written: Permission denied"),
    ("lint a.urdf --baseline secret.urdf", "'secret.urdf' cannot be read: Permission denied"),
    ("lint a.urdf --config secret.urdf", "secret.urdf: Permission denied"),
    ("lint shut", "'shut' cannot be read: Permission denied"),
    ("expand a.urdf -o x.urdf", "'x.urdf' cannot be written: Permission denied"),
    (f"gen-controllers joints.txt {GEN} -o c.yaml", "'c.yaml' cannot be written: Permission denied"),
    (f"gen-all joints.txt {GEN} -o made", "'made' cannot be written: Permission denied"),
    (f"gen-transmissions bare.urdf {GEN} --into secret.urdf", "'secret.urdf' cannot be read: Permission denied"),
    (f"gen-transmissions bare.urdf {GEN} --into bare.urdf", "'bare.urdf' cannot be written: Permission denied"),
    ("gen-check shut", "'shut' cannot be read: Permission denied"),
    ("explain secret.log", "'secret.log' cannot be read: Permission denied"),
    ("smoke a.urdf --engine none --report r.html", "'r.html' cannot be written: Permission denied"),
]

WITHOUT_ROOM = [
    ("lint a.urdf --unsafe-fixes", "a.urdf"),
    ("lint a.urdf --write-baseline k.json", "k.json"),
    ("lint a.urdf --format json=o.json", "o.json"),
    ("expand a.urdf -o x.urdf --force", "x.urdf"),
    (f"gen-controllers joints.txt {GEN} -o c.yaml --force", "c.yaml"),
    (f"gen-transmissions bare.urdf {GEN} --into bare.urdf", "bare.urdf"),
    ("smoke a.urdf --engine none --report r.html", "r.html"),
]
"""The file of which only the first hundred bytes fit on the disk, and that stays as it was."""
