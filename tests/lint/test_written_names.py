"""A wrong name that a macro call passes is reported at the call; a name that suits another robot is not wrong."""

from __future__ import annotations

import pytest
import robots
from folder import Folder

from urdfctl.diagnostic import Diagnostic

MACROS = """\
<robot name="r" xmlns:xacro="http://www.ros.org/wiki/xacro">
  <xacro:macro name="parts" params="prefix joint">
    <ros2_control name="${prefix}system" type="system">
      <hardware><plugin>mock_components/GenericSystem</plugin></hardware>
      <joint name="${prefix}${joint}">
        <command_interface name="position"/><state_interface name="position"/>
      </joint>
    </ros2_control>
    <gazebo reference="${prefix}${joint}"><implicitSpringDamper>true</implicitSpringDamper></gazebo>
    <transmission name="${prefix}transmission">
      <type>transmission_interface/SimpleTransmission</type>
      <joint name="${prefix}${joint}">
        <hardwareInterface>hardware_interface/PositionJointInterface</hardwareInterface>
      </joint>
      <actuator name="motor"/>
    </transmission>
  </xacro:macro>
  <link name="base"/>
  <link name="arm"/>
  <joint name="left_elbow" type="revolute">
    <parent link="base"/><child link="arm"/><limit lower="0" upper="1" effort="1" velocity="1"/>
  </joint>
  <xacro:parts prefix="PREFIX" joint="JOINT"/>
</robot>
"""


def found(folder: Folder, text: str, code: str, distro: str) -> Diagnostic:
    folder.write({"r.xacro": text})
    [one] = robots.findings("r.xacro", (code,), distro=distro, workspace=str(folder.path))
    return one


def fixed(folder: Folder, finding: Diagnostic) -> str:
    """Return the line of the finding with its fix."""
    assert finding.fix is not None
    [edit] = finding.fix.edits
    data = (folder.path / "r.xacro").read_bytes()
    text = (data[: edit.start] + edit.text.encode() + data[edit.end :]).decode()
    return text.splitlines()[finding.at.line - 1].strip()


@pytest.mark.parametrize(("code", "distro"), [("UC312", "jazzy"), ("UC156", "jazzy"), ("UC206", "noetic")])
@pytest.mark.parametrize(("prefix", "joint"), [("left_", "elbw"), ("lft_", "elbow")])
def test_a_wrong_name_is_reported_in_the_call_that_passes_it_and_repaired_there(
    folder: Folder, code: str, distro: str, prefix: str, joint: str
) -> None:
    one = found(folder, MACROS.replace("PREFIX", prefix).replace("JOINT", joint), code, distro)
    assert one.at.line == 23
    assert "did you mean 'left_elbow'?" in one.message
    assert [note.message for note in one.notes if note.at] == ["used here"]
    assert fixed(folder, one) == '<xacro:parts prefix="left_" joint="elbow"/>'


@pytest.mark.parametrize(
    ("code", "distro", "line"), [("UC312", "jazzy", 5), ("UC156", "jazzy", 9), ("UC206", "noetic", 12)]
)
def test_a_name_that_the_macro_itself_misspells_is_reported_in_the_macro(
    folder: Folder, code: str, distro: str, line: int
) -> None:
    text = MACROS.replace("${prefix}${joint}", "${prefix}elbw").replace("PREFIX", "left_").replace("JOINT", "elbow")
    one = found(folder, text, code, distro)
    assert one.at.line == line
    assert 'elbow"' in fixed(folder, one)


def test_a_name_that_is_used_elsewhere_is_not_suggested(folder: Folder) -> None:
    used = '<gazebo reference="left_elbow"><mu1>1</mu1></gazebo>\n</robot>'
    text = MACROS.replace("PREFIX", "left_").replace("JOINT", "elbw").replace("</robot>", used)
    one = found(folder, text, "UC156", "jazzy")
    assert "did you mean" not in one.message
    assert one.fix is None


ROBOT = """\
<robot name="{name}" xmlns:xacro="http://www.ros.org/wiki/xacro">
  <link name="base"/>
  <link name="{link}"/>
  <joint name="j" type="fixed"><parent link="base"/><child link="{link}"/></joint>
  <xacro:include filename="colours.xacro"/>
</robot>
"""
COLOURS = """\
<robot xmlns:xacro="http://www.ros.org/wiki/xacro">
  <gazebo reference="camera"><material>Gazebo/Red</material></gazebo>
  <gazebo reference="lidar"><material>Gazebo/Red</material></gazebo>
  <gazebo reference="lidr"><material>Gazebo/Red</material></gazebo>
</robot>
"""


def test_a_gazebo_part_of_a_shared_file_that_suits_another_robot_is_only_worth_knowing(folder: Folder) -> None:
    folder.write(
        {
            "colours.xacro": COLOURS,
            **{f"{link}.xacro": ROBOT.format(name=link, link=link) for link in ("camera", "lidar")},
        }
    )
    told = folder.run("lint", ".", "--no-cache", "--select", "UC156", "--format", "concise").stdout.splitlines()
    assert [line.partition(": ")[2] for line in told if line.startswith("colours")] == [
        "warning UC156 <gazebo> refers to 'lidr', which is not a link or joint of the robot",
        "info UC156 <gazebo> refers to 'camera', which is not a link or joint of the robot (also 'lidar' (line 3))",
    ]
    alone = folder.run("lint", "lidar.xacro", "--no-cache", "--select", "UC156", "--format", "concise").stdout
    assert "warning UC156 <gazebo> refers to 'camera'" in alone
