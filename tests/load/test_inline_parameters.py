"""Parameters that a ROS 1 launch file contains itself: they count as if a file had them."""

from __future__ import annotations

from pathlib import Path

import pytest
from robots import findings, whole

TRANSMISSION = """
  <transmission name="t"><type>transmission_interface/SimpleTransmission</type>
    <joint name="elbow"><hardwareInterface>hardware_interface/PositionJointInterface</hardwareInterface></joint>
    <actuator name="m"><mechanicalReduction>1</mechanicalReduction></actuator></transmission>
"""
LAUNCH = """<launch>
  <param name="robot_description" textfile="$(find arm)/arm.urdf"/>
  <rosparam file="$(find arm)/controllers.yaml" command="load"/>
  {}
  <node name="spawner" pkg="controller_manager" type="spawner" args="arm"/>
</launch>
"""
TYPE = "arm: {type: position_controllers/JointPositionController}\n"


def found(tmp_path: Path, inline: str, yaml: str = TYPE) -> list[str]:
    """Return code and severity of the errors and warnings of the launch file with some inline parameters."""
    (tmp_path / "package.xml").write_text("<package><name>arm</name></package>")
    (tmp_path / "arm.urdf").write_text(whole("arm.urdf", TRANSMISSION))
    (tmp_path / "controllers.yaml").write_text(yaml)
    (tmp_path / "arm.launch").write_text(LAUNCH.format(inline))
    told = findings(
        tmp_path / "arm.launch", ("UC42", "UC43", "UC44", "UC601"), workspace=str(tmp_path), distro="noetic"
    )
    return [f"{one.code} {Path(one.at.file).name}:{one.at.line}" for one in told if one.severity.value != "info"]


@pytest.mark.parametrize(
    "inline",
    [
        '<param name="arm/joint" value="elbow"/>',
        '<param name="/arm/joint" value="elbow" type="str"/>',
        '<group ns="arm"><param name="joint" value="elbow"/></group>',
        '<rosparam param="arm/joint">elbow</rosparam>',
        '<rosparam param="arm">\n    joint: elbow\n  </rosparam>',
        '<rosparam ns="arm">{joint: elbow}</rosparam>',
        "<rosparam>\n    arm:\n      joint: elbow\n  </rosparam>",
        "<rosparam><![CDATA[\n    arm:\n      joint: elbow\n  ]]></rosparam>",
    ],
)
def test_a_required_parameter_may_be_in_the_launch_file(tmp_path: Path, inline: str) -> None:
    assert found(tmp_path, "") == ["UC431 controllers.yaml:1"]
    assert found(tmp_path, inline) == []


def test_a_controller_may_be_declared_in_the_launch_file(tmp_path: Path) -> None:
    block = "<rosparam>\n    arm: {type: position_controllers/JointPositionController, joint: elbow}\n  </rosparam>"
    assert found(tmp_path, block, "other: {rate: 1}\n") == []


def test_a_wrong_value_is_found_in_the_launch_file(tmp_path: Path) -> None:
    assert found(tmp_path, '<param name="arm/joint" value="elbwo"/>') == ["UC440 arm.launch:4"]
    block = "<rosparam>\n    arm:\n      joint: elbwo\n  </rosparam>"
    assert found(tmp_path, block) == ["UC440 arm.launch:6"]


def test_a_parameter_under_an_unknown_condition_may_be_given(tmp_path: Path) -> None:
    conditional = '<param name="arm/joint" value="elbow" if="$(env SIMULATED)"/>'
    assert found(tmp_path, conditional) == []


@pytest.mark.parametrize(("joint", "expected"), [("elbow", []), ("elbw", ["UC440 controllers.yaml:2"])])
@pytest.mark.parametrize("load", ['<rosparam file="{}" ns="arm"/>', '<group ns="arm"><rosparam file="{}"/></group>'])
def test_a_whole_file_may_be_a_controller_s_namespace(
    tmp_path: Path, load: str, joint: str, expected: list[str]
) -> None:
    (tmp_path / "package.xml").write_text("<package><name>arm</name></package>")
    (tmp_path / "arm.urdf").write_text(whole("arm.urdf", TRANSMISSION))
    (tmp_path / "controllers.yaml").write_text(f"type: position_controllers/JointPositionController\njoint: {joint}\n")
    before = LAUNCH.replace('<rosparam file="$(find arm)/controllers.yaml" command="load"/>', "{}")
    (tmp_path / "arm.launch").write_text(before.format(load.format("$(find arm)/controllers.yaml"), ""))
    select = ("UC42", "UC43", "UC44", "UC601")
    told = findings(tmp_path / "arm.launch", select, workspace=str(tmp_path), distro="noetic")
    assert [f"{one.code} {Path(one.at.file).name}:{one.at.line}" for one in told] == expected
