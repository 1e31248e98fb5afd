"""What other programs own is not checked as ros_control's: their sections, their placeholders, their simulation."""

from __future__ import annotations

import pytest
from folder import Folder
from robots import findings

from urdfctl.load.target import Target
from urdfctl.model.controllers import Parameters, Section
from urdfctl.source.span import Place, SourceText


def codes(folder: Folder, text: str, **options: str) -> list[str]:
    folder.write({"c.yaml": text})
    return [one.code for one in findings(Target("c.yaml"), **options)]


@pytest.mark.parametrize("key", ["package: planners", "module: planners.fast"])
def test_a_section_with_package_or_module_beside_its_type_is_for_another_stack(folder: Folder, key: str) -> None:
    plugin = f"type: effort_controllers/JointTrajectoryControler\n{{0}}{key}\n{{0}}joints: [a]\n"
    assert codes(folder, "planner:\n  " + plugin.format("  "), distro="noetic") == []
    ros2 = "planner:\n  ros__parameters:\n    " + plugin.format("    ")
    assert codes(folder, ros2, distro="jazzy") == []
    alone = "planner: {type: effort_controllers/JointTrajectoryControler, joints: [a]}"
    assert "UC421" in codes(folder, alone, distro="noetic")


MANAGED = """
{0}controller_manager:
  ros__parameters:
    update_rate: 100
    arm: {{type: joint_trajectory_controller/JointTrajectoryController}}
{0}arm:
  ros__parameters:
    joints: ["<prefix>shoulder", "{{{{ side }}}}_elbow"]
    command_interfaces: [position]
    state_interfaces: [position]
    allow_partial_joints_goal: <partial>
    constraints: {{goal_time: {1}}}
"""


@pytest.mark.parametrize("prefix", ["", "<robot_namespace>", "<robot_namespace>/", "/<robot_namespace>/", "/**/"])
def test_a_placeholder_that_a_launch_file_replaces_is_an_unknown_value(folder: Folder, prefix: str) -> None:
    assert codes(folder, MANAGED.format(prefix, "<time>"), distro="jazzy") == []
    assert codes(folder, MANAGED.format(prefix, "soon"), distro="jazzy") == ["UC432"]


@pytest.mark.parametrize(
    ("path", "name", "namespace", "node"),
    [
        ("<ns>/arm", "arm", None, "/left/arm"),
        ("<ns>arm", "arm", None, "/left/arm"),
        ("/{{ ns }}/arm", "arm", None, "/a/b/arm"),
        ("left/arm", "arm", "/left", "/left/arm"),
    ],
)
def test_the_path_of_a_section_may_have_placeholders(path: str, name: str, namespace: str | None, node: str) -> None:
    section = Section(path, Place(SourceText("c.yaml", b""), 0, end=0), Parameters())
    assert (section.name, section.namespace) == (name, namespace)
    assert section.names(node)
    assert not section.names("/left/leg")


ROBOT = """<robot name="r"><link name="a"/><link name="b"/>
<joint name="j" type="fixed"><parent link="a"/><child link="b"/></joint>
<transmission name="t"><type>our_transmission</type><joint name="j"/></transmission>
<gazebo><plugin name="p" filename="libgazebo_ros_control.so">{}</plugin></gazebo></robot>"""


def test_transmissions_for_a_simulation_of_another_package_are_not_judged(folder: Folder) -> None:
    folder.write({"r.urdf": ROBOT.format(""), "own.urdf": ROBOT.format("<robotSimType>ours/OurHWSim</robotSimType>")})
    assert {one.code for one in findings("r.urdf", ("UC2",), distro="noetic")} >= {"UC201"}
    assert findings("own.urdf", ("UC2",), distro="noetic") == []


def test_hardware_of_another_simulation_offers_what_is_not_known(folder: Folder) -> None:
    yaml = "arm: {type: position_controllers/JointPositionController, joint: j}"
    moving = ROBOT.replace("fixed", "continuous").replace(
        "our_transmission", "transmission_interface/SimpleTransmission"
    )
    interface = "<hardwareInterface>hardware_interface/EffortJointInterface</hardwareInterface>"
    moving = moving.replace('<joint name="j"/>', f'<joint name="j">{interface}</joint><actuator name="m"/>')
    folder.write({"r.urdf": moving.format(""), "own.urdf": moving.format("<robotSimType>ours/OurHWSim</robotSimType>")})
    folder.write({"c.yaml": yaml})
    assert [one.code for one in findings(Target("r.urdf", controllers=("c.yaml",)), ("UC461",), distro="noetic")] != []
    assert findings(Target("own.urdf", controllers=("c.yaml",)), ("UC461",), distro="noetic") == []
