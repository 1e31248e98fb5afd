"""`urdfctl schema`: what its schemas accept and reject, and where `--check` says so."""

from __future__ import annotations

import importlib.util
import json
from pathlib import Path
from typing import Any

import pytest
import yaml
from folder import CHECKOUT
from generating import command
from sampling import assert_each, sample

pytest.importorskip("lxml", reason="lxml is not installed")
pytest.importorskip("jsonschema", reason="jsonschema is not installed")
from jsonschema import Draft202012Validator
from lxml import etree

from urdfctl.catalog.catalog import CATALOG
from urdfctl.catalog.distros import ALL, ROS2, generation
from urdfctl.control.parameters.minimal import minimal_parameters
from urdfctl.errors import UserError
from urdfctl.schemas.checking import faults_in_controllers, faults_in_robot
from urdfctl.schemas.controllers import controllers_schema
from urdfctl.schemas.robot import ros2_control_schema, urdf_schema
from urdfctl.source.span import SourceText

JTC = "joint_trajectory_controller/JointTrajectoryController"
CONTROLLERS = """\
controller_manager:
  ros__parameters:
    update_rate: 100
    arm: {type: joint_trajectory_controller/JointTrajectoryController}
arm:
  ros__parameters:
    joints: [shoulder, elbow]
    command_interfaces: [position]
    state_interfaces: [position]
    gains:
      elbow: {p: 5.0}
"""
ROBOT = """\
<robot name="r">
  <link name="base"/>
  <link name="upper"/>
  <joint name="shoulder" type="revolute">
    <limit lower="-1" upper="1" effort="5" velocity="2"/>
    <parent link="base"/>
    <child link="upper"/>
  </joint>
  <ros2_control name="arm" type="system">
    <hardware><plugin>mock_components/GenericSystem</plugin></hardware>
    <joint name="shoulder"><command_interface name="position"/></joint>
  </ros2_control>
</robot>
"""


def told(text: str, distro: str = "jazzy") -> list[str]:
    """Return where a controller file does not fit, as LINE:COLUMN message."""
    source = SourceText("c.yaml", text.encode())
    return [_line(source, fault) for fault in faults_in_controllers(source, distro)]


def told_of_robot(text: str, schema: str) -> list[str]:
    """Return where a robot does not fit."""
    source = SourceText("r.urdf", text.encode())
    return [_line(source, fault) for fault in faults_in_robot(source, schema)]


def _line(source: SourceText, fault: Any) -> str:
    at = source.position(fault.at.start)
    return f"{at.line}:{at.column} {fault.message}"


# -- controllers -------------------------------------------------------------------------------------------------------


@pytest.mark.parametrize("distro", sample(ALL, 7))
def test_the_schema_of_controllers_is_a_json_schema(distro: str) -> None:
    schema = json.loads(json.dumps(controllers_schema(distro)))
    Draft202012Validator.check_schema(schema)
    assert schema["$schema"] == "https://json-schema.org/draft/2020-12/schema"
    assert len(schema["$defs"]) > 0.9 * len(CATALOG.known_types(distro))


def test_a_right_controller_file_fits() -> None:
    assert told(CONTROLLERS) == []


@pytest.mark.parametrize(
    ("right", "wrong", "said"),
    [
        (
            "update_rate: 100",
            "update_rate: fast",
            "3:18 'controller_manager.update_rate': 'fast' is not of type 'integer'",
        ),
        ("[shoulder, elbow]", "shoulder", "7:13 'arm.joints': 'shoulder' is not of type 'array'"),
        ("update_rate: 100", "update_rate: 100\n    extra: []", "4:5 'controller_manager.extra': [] "),
        ("update_rate: 100", "update_rate: 100\n    extra: {}", "4:5 'controller_manager.extra': {} "),
        ("[shoulder, elbow]", "[shoulder, elbow]\n    extra: []", "8:5 'arm.extra': [] "),
        ("p: 5.0", "p: 5", "11:18 'arm.gains.elbow.p': 5 is not of type double; ROS 2 tells 1 from 1.0"),
        ("    joints: [shoulder, elbow]\n", "", "6:3 'arm': 'joints' is a required property"),
        ("[position]\n    state", "[speed]\n    state", "8:26 'arm.command_interfaces.0': 'speed' is not one of"),
        ("JointTrajectoryController}", "JointTrajectoryControler}", "4:17 'controller_manager.arm.type': "),
    ],
)
def test_a_fault_of_form_is_told_at_its_place(right: str, wrong: str, said: str) -> None:
    faults = told(CONTROLLERS.replace(right, wrong))
    assert any(fault.replace(".0'", "'").startswith(said.replace(".0'", "'")) for fault in faults), faults


def test_parameters_can_be_written_with_dots_and_unknown_ones_are_ignored() -> None:
    assert (
        told(CONTROLLERS.replace("    gains:\n      elbow: {p: 5.0}\n", "    gains.elbow.p: 5.0\n    mine: [1, 2]\n"))
        == []
    )


def test_what_a_launch_file_replaces_is_not_judged() -> None:
    assert told(CONTROLLERS.replace("update_rate: 100", "update_rate: $(var rate)")) == []


def test_a_type_of_ones_own_package_fits_and_its_section_is_not_judged() -> None:
    assert told(CONTROLLERS.replace(JTC, "my_controllers/Arm").replace("[shoulder, elbow]", "5")) == []


def test_the_printed_schema_judges_by_the_only_type_of_a_file() -> None:
    judged = Draft202012Validator(controllers_schema("jazzy"))
    right = yaml.safe_load(CONTROLLERS)
    assert judged.is_valid(right)
    del right["arm"]["ros__parameters"]["joints"]
    assert not judged.is_valid(right)


def test_the_printed_schema_does_not_judge_the_sections_of_types_that_it_does_not_know() -> None:
    judged = Draft202012Validator(controllers_schema("jazzy"))
    mixed = yaml.safe_load(CONTROLLERS.replace("    arm:", "    mine: {type: my_package/Mine}\n    arm:"))
    mixed["mine"] = {"ros__parameters": {"joints": "a text"}}
    assert judged.is_valid(mixed)
    mixed["controller_manager"]["ros__parameters"]["mine"]["type"] = "joint_state_broadcaster/JointStateBroadcaster"
    assert not judged.is_valid(mixed)


def test_the_schema_of_ros_1_judges_each_controller_by_its_type() -> None:
    text = "arm:\n  type: effort_controllers/JointTrajectoryController\n  joints: [a]\n  constraints: {goal_time: 1}\n"
    assert told(text, "noetic") == []
    assert told(text.replace("[a]", "{a: 1}"), "noetic") != []


def test_the_least_parameters_of_each_type_fit() -> None:
    def check(case: tuple[str, str]) -> None:
        distro, kind = case
        controller = CATALOG.controller(kind, distro)
        assert controller is not None
        values = minimal_parameters(controller)
        if generation(distro) == 1:
            document: dict[str, Any] = {"it": {"type": kind, **nested(values)}}
        else:
            manager = {"ros__parameters": {"it": {"type": kind}}}
            document = {"controller_manager": manager, "it": {"ros__parameters": nested(values) or {"mine": 1}}}
        assert told(yaml.safe_dump(document), distro) == []
        assert Draft202012Validator(controllers_schema(distro)).is_valid(document)

    cases = {f"{distro} {kind}": (distro, kind) for distro in ALL for kind in CATALOG.known_types(distro)}
    assert_each(check, dict(sample(cases.items(), 31)))


def nested(values: dict[str, object]) -> dict[str, Any]:
    """Return dotted parameters as maps in maps."""
    root: dict[str, Any] = {}
    for name, value in values.items():
        *above, last = name.split(".")
        level = root
        for part in above:
            level = level.setdefault(part, {})
        level[last] = value
    return root


def test_a_fault_is_told_once_although_two_keywords_see_it() -> None:
    assert len(told(CONTROLLERS.replace("100", "0.5"))) == 1
    assert len(told(CONTROLLERS.replace("100", "100.0"))) == 1


@pytest.mark.parametrize("text", ["5", "[" * 70, "a: " + "{a: " * 60 + "1" + "}" * 60, "a: *b", "\ta: 1"])
def test_what_is_no_controller_file_is_told(text: str) -> None:
    assert told(text) != []


@pytest.mark.parametrize(
    "text", ["", "<a", '<!DOCTYPE r [<!ENTITY a "b">]><robot name="&a;"/>', "<html/>", "<a>" * 300]
)
def test_what_is_no_robot_is_told(text: str) -> None:
    assert told_of_robot(text, urdf_schema()) != []


# -- robots ------------------------------------------------------------------------------------------------------------


@pytest.mark.parametrize("distro", ROS2)
def test_a_right_robot_fits_in_each_distro(distro: str) -> None:
    assert told_of_robot(ROBOT, ros2_control_schema(distro)) == []


def test_a_robot_without_ros2_control_fits_the_schema_of_urdf_alone() -> None:
    plain = ROBOT[: ROBOT.index("  <ros2_control")] + "  <of_a_tool/>\n</robot>\n"
    assert told_of_robot(plain, urdf_schema()) == []
    assert told_of_robot(plain, ros2_control_schema("jazzy")) != []


@pytest.mark.parametrize(
    ("right", "wrong", "line"),
    [
        ('effort="5" ', "", 5),
        ('lower="-1"', 'lower="-pi"', 5),
        ('<child link="upper"/>', "", 4),
        ('<child link="upper"/>', '<child link="uper"/>', 7),
        ('type="revolute"', 'type="hinge"', 4),
        ('<link name="upper"/>', '<link name="base"/>', 3),
    ],
)
def test_a_fault_of_urdf_is_told_in_its_line(right: str, wrong: str, line: int) -> None:
    faults = told_of_robot(ROBOT.replace(right, wrong), urdf_schema())
    assert {fault.partition(":")[0] for fault in faults} >= {str(line)}, faults


@pytest.mark.parametrize(
    ("right", "wrong", "line"),
    [
        ("<plugin>mock_components/GenericSystem</plugin>", "", 9),
        ('<command_interface name="position"/>', '<command_interface size="0" name="a"/>', 11),
        ('<command_interface name="position"/>', "<command_interface>position</command_interface>", 11),
        ('<joint name="shoulder"><command', '<joint name="elbow"><command', 11),
        ("  </ros2_control>", "    <group/>\n  </ros2_control>", 12),
    ],
)
def test_a_fault_of_ros2_control_is_told_in_its_line(right: str, wrong: str, line: int) -> None:
    faults = told_of_robot(ROBOT.replace(right, wrong), ros2_control_schema("jazzy"))
    assert {fault.partition(":")[0] for fault in faults} >= {str(line)}, faults


def test_a_distro_judges_only_what_its_parser_reads() -> None:
    limited = ROBOT.replace("</joint>\n  </ros2", "<limits/></joint>\n  </ros2")
    assert told_of_robot(limited, ros2_control_schema("humble")) == []
    assert told_of_robot(limited, ros2_control_schema("jazzy")) != []


def test_a_schema_of_robots_has_no_marks_of_distros_in_it() -> None:
    for distro in ROS2:
        assert not etree.fromstring(ros2_control_schema(distro).encode()).xpath("//comment()[contains(., 'since ')]")


# -- the command -------------------------------------------------------------------------------------------------------


def test_the_command_prints_schemas_and_checks_files(tmp_path: Path) -> None:
    assert json.loads(command("schema", "controllers", "--distro", "jazzy").stdout)["$defs"]
    assert etree.fromstring(command("schema", "urdf").stdout.encode()).tag.endswith("schema")
    for name, text in (("c.yaml", CONTROLLERS.replace("100", "x")), ("r.urdf", ROBOT.replace(' type="system"', ""))):
        (tmp_path / name).write_text(text, encoding="utf-8")
    checks = ("--check", str(tmp_path / "c.yaml"), "--check", str(tmp_path / "r.urdf"))
    found = command("schema", "--distro", "jazzy", *checks)
    assert found.returncode == 1
    places = [line.partition(": ")[0].rpartition("/")[2] for line in found.stdout.splitlines()]
    assert places == ["c.yaml:3:18", "r.urdf:9:3"]


def test_the_samples_fit(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.chdir(CHECKOUT)
    found = command("schema", "--distro", "humble", "--check", "samples/gripper/config/controllers.yaml")
    assert (found.returncode, found.stdout) == (0, "")


@pytest.mark.parametrize(
    ("words", "said"),
    [
        (("controllers",), "the schema depends on the distro; name it: --distro jazzy"),
        (("srdf",), "there is no schema of 'srdf'; known are controllers, ros2_control, urdf"),
        ((), "name what the schema is of: controllers, ros2_control, urdf; or a file with --check"),
        (("ros2_control", "--distro", "noetic"), "<ros2_control> needs a distro of ROS 2, not 'noetic'"),
    ],
)
def test_a_command_that_lacks_something_says_what(
    words: tuple[str, ...], said: str, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.delenv("ROS_DISTRO", raising=False)
    ran = command("schema", *words)
    assert ran.returncode == 2
    assert ran.stderr.startswith(f"urdfctl: {said}")


def test_a_missing_library_is_one_line(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(importlib.util, "find_spec", lambda name: None)
    with pytest.raises(UserError, match=r"--check needs jsonschema: pip install 'urdfctl\[schema\]'"):
        told(CONTROLLERS)


def test_xacro_has_to_be_expanded_first() -> None:
    xacro = '<robot name="r" xmlns:xacro="http://www.ros.org/wiki/xacro"><xacro:include filename="a"/></robot>'
    with pytest.raises(UserError, match=r"r\.urdf is xacro; expand it first: urdfctl expand"):
        told_of_robot(xacro, urdf_schema())


@pytest.mark.parametrize(("distro", "is_said"), [("jazzy", True), ("foxy", False)])
def test_a_schema_says_where_an_integer_is_rejected(distro: str, *, is_said: bool) -> None:
    """JSON Schema takes 1 for a number, and ROS 2 does not from galactic on: the description says so to the user."""
    assert ("write 1.0 instead of 1" in json.dumps(controllers_schema(distro))) == is_said


def test_a_wrong_value_is_told_without_what_libxml2_says_about_itself(tmp_path: Path) -> None:
    inertia = '<inertia ixx="0.01*a" ixy="0" ixz="0" iyy="1" iyz="0" izz="1"/>'
    robot = f'<robot name="r"><link name="l"><inertial><mass value="1"/>{inertia}</inertial></link></robot>'
    (tmp_path / "r.urdf").write_text(robot)
    found = command("schema", "urdf", "--distro", "noetic", "--check", str(tmp_path / "r.urdf"))
    assert found.returncode == 1
    assert "The value '0.01*a' is not accepted" in found.stdout
    assert "Warning" not in found.stdout
