"""The collector and the doctor on a ROS 1 system that really runs; skipped where its Debian packages are missing."""

from __future__ import annotations

import json
import subprocess
import time
from pathlib import Path
from typing import Any

import pytest
from folder import Folder
from ros1_system import PYTHON, Ros1System, is_installed

import urdfctl

pytestmark = pytest.mark.skipif(
    not is_installed(),
    reason="ROS 1 is not installed: apt-get install python3-rospy python3-rosmaster python3-tf2-msgs",
)
COLLECTOR = Path(urdfctl.__file__).parent / "doctor/collector_ros1.py"
LONGEST = 5.0
JOINT = """
  <link name="{0}_link"/>
  <joint name="{0}" type="revolute">
    <parent link="base"/><child link="{0}_link"/><axis xyz="0 0 1"/>
    <limit lower="-1" upper="1" effort="5" velocity="2"/>
  </joint>"""
DESCRIPTION = f'<robot name="arm">\n  <link name="base"/>{JOINT.format("pan")}{JOINT.format("tilt")}\n</robot>\n'
FILES = {
    "package.xml": '<package format="2"><name>arm</name><buildtool_depend>catkin</buildtool_depend></package>',
    "arm.urdf": DESCRIPTION,
    "config/controllers.yaml": """joint_state_controller:
  {type: joint_state_controller/JointStateController, publish_rate: 50}
head:
  type: position_controllers/JointGroupPositionController
  joints: [pan, tilt]
""",
    "launch/arm.launch": """<launch>
  <param name="robot_description" textfile="$(find arm)/arm.urdf"/>
  <rosparam command="load" file="$(find arm)/config/controllers.yaml"/>
  <node name="spawner" pkg="controller_manager" type="spawner" args="joint_state_controller head"/>
</launch>
""",
}
WHOLE: dict[str, Any] = {
    "parameters": {
        "/robot_description": DESCRIPTION,
        "/joint_state_controller": {"type": "joint_state_controller/JointStateController", "publish_rate": 50},
        "/head": {"type": "position_controllers/JointGroupPositionController", "joints": ["pan", "tilt"]},
        "/driver/serial_number": "A1",
    },
    "joints": ["pan", "tilt"],
    "positions": [0.1, 0.2],
    "frames": [["base", "pan_link"], ["base", "tilt_link"]],
    "commands": [],
}
LINK = "tilt_link"
BROKEN: dict[str, Any] = {
    "parameters": {
        **WHOLE["parameters"],
        "/robot_description": DESCRIPTION.replace('"tilt', '"tlit'),
        "/head": {"type": "position_controllers/JointGroupPositionController", "joints": ["pan", "tlit"]},
    },
    "joints": ["pan"],
    "positions": ["nan"],
    "frames": [*WHOLE["frames"], ["map", "tilt_link"]],
    "commands": ["/haed/command"],
}


def test_of_a_whole_system_nothing_is_told(folder: Folder) -> None:
    with Ros1System(folder.path, WHOLE) as system:
        folder.write(FILES)
        ran = folder.run("doctor", "--seconds", "1", "--snapshot", "now.json", environ=system.environ)
        assert (ran.returncode, ran.stdout[:4]) == (0, "ok: "), ran.stdout + ran.stderr
        recording = json.loads((folder.path / "now.json").read_text())
        assert recording["parameters"]["/"]["values"]["/driver/serial_number"] == "left out"
        assert "urdfctl_doctor" not in system.asked("getSystemState()")


def test_what_is_broken_is_told_causes_first(folder: Folder) -> None:
    with Ros1System(folder.path, BROKEN) as system:
        folder.write(FILES)
        ran = folder.run("doctor", "--seconds", "1", "--format", "json", environ=system.environ)
    codes = [finding["code"] for finding in json.loads(ran.stdout)["findings"]]
    assert codes == ["UC810", "UC834", "UC841", "UC844", "UC850", "UC861"]


def test_a_master_that_hangs_is_told_within_five_seconds(folder: Folder) -> None:
    with Ros1System(folder.path, WHOLE) as system:
        system.processes[0].send_signal(19)
        began = time.monotonic()
        ran = subprocess.run([PYTHON, COLLECTOR], env=system.environ, capture_output=True, text=True, check=False)
        assert time.monotonic() - began < LONGEST
    assert (ran.returncode, ran.stdout) == (3, "")
    assert ran.stderr.startswith("no ROS master answers at ROS_MASTER_URI: ")
