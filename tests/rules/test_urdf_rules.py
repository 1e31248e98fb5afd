"""The URDF rules beyond their examples: severity by distro, fixes, and cases without findings."""

from __future__ import annotations

from pathlib import Path

import pytest
import robots

from urdfctl.diagnostic import Diagnostic

MASS = '<inertial><mass value="1"/><inertia ixx="0.1" ixy="0" ixz="0" iyy="0.1" iyz="0" izz="0.1"/></inertial>'
MOUNT = '<joint name="mount" type="fixed"><parent link="world"/><child link="base"/></joint>'
BASE = f'<link name="world"/><link name="base">{MASS}</link>{MOUNT}'
LIMIT = '<limit lower="-1" upper="1" effort="1" velocity="1"/>'


def findings(folder: Path, text: str, name: str = "robot.urdf", **options: str) -> list[Diagnostic]:
    """Return the findings of the URDF rules in one file."""
    path = folder / name
    path.write_bytes(text.encode())
    return robots.findings(path, ("UC1", "UC000"), workspace=str(folder), **options)


def codes(folder: Path, text: str, name: str = "robot.urdf", **options: str) -> list[str]:
    """Return code and severity of each finding."""
    return [f"{d.code} {d.severity.value}" for d in findings(folder, text, name, **options)]


def robot(inside: str) -> str:
    """Return a robot with a base and the given parts."""
    return f'<robot name="arm">{BASE}{inside}</robot>'


def joint(inside: str, kind: str = "revolute", link: str = MASS) -> str:
    """Return a robot with a joint `wrist` between its base and a link `tool`."""
    ends = '<parent link="base"/><child link="tool"/>'
    return robot(f'<link name="tool">{link}</link><joint name="wrist" type="{kind}">{ends}{inside}</joint>')


def hung(name: str, parent: str, kind: str = "continuous", inside: str = "") -> str:
    """Return another link with mass, and its joint."""
    ends = f'<parent link="{parent}"/><child link="{name}"/>'
    return f'<link name="{name}">{MASS}</link><joint name="{name}_joint" type="{kind}">{ends}{inside}</joint>'


def with_more(text: str, more: str) -> str:
    """Return a robot with more elements."""
    return text.removesuffix("</robot>") + more + "</robot>"


def as_xacro(text: str) -> str:
    """Return the text of a robot as a xacro file."""
    return text.replace("<robot ", '<robot xmlns:xacro="http://www.ros.org/wiki/xacro" ', 1)


def fixed(folder: Path, text: str, **options: str) -> str:
    """Return the file after all fixes of the findings."""
    edits = [edit for d in findings(folder, text, **options) if d.fix for edit in d.fix.edits]
    data = text.encode()
    for edit in sorted(edits, key=lambda edit: edit.start, reverse=True):
        data = data[: edit.start] + edit.text.encode() + data[edit.end :]
    return data.decode()


# -- by distro -------------------------------------------------------------------------------------------------------


@pytest.mark.parametrize(
    ("distro", "expected"),
    [
        ("noetic", []),
        ("foxy", []),
        ("galactic", ["UC103 error"]),
        ("rolling", ["UC103 error"]),
        (None, ["UC103 warning"]),
    ],
)
def test_the_version_of_the_format_is_read_from_galactic_on(tmp_path: Path, distro: str, expected: list[str]) -> None:
    assert codes(tmp_path, f'<robot name="arm" version="2.0">{BASE}</robot>', distro=distro) == expected


def test_a_wrong_version_is_a_warning_if_the_distro_is_unknown(tmp_path: Path) -> None:
    assert codes(tmp_path, f'<robot name="arm" version="2.0">{BASE}</robot>') == ["UC103 warning"]


@pytest.mark.parametrize(
    ("distro", "expected"), [("kinetic", []), ("melodic", ["UC127 error"]), ("jazzy", ["UC127 error"])]
)
def test_old_readers_accept_inf_and_newer_ones_do_not(tmp_path: Path, distro: str, expected: list[str]) -> None:
    text = joint('<limit lower="-inf" upper="1" effort="1" velocity="1"/>')
    assert codes(tmp_path, text, distro=distro) == expected


def test_a_value_that_only_some_possible_distros_reject_is_a_warning(tmp_path: Path) -> None:
    text = joint('<limit lower="-inf" upper="1" effort="1" velocity="1"/>')
    assert codes(tmp_path, text) == ["UC127 warning"]


@pytest.mark.parametrize(("distro", "expected"), [("kinetic", ["UC127 error"]), ("jazzy", [])])
def test_only_newer_readers_accept_a_space_before_a_number(tmp_path: Path, distro: str, expected: list[str]) -> None:
    text = joint('<limit lower=" -1" upper="1" effort="1" velocity="1"/>')
    assert codes(tmp_path, text, distro=distro) == expected


def test_a_joint_may_have_the_name_of_a_link_in_ros_1(tmp_path: Path) -> None:
    text = joint(LIMIT).replace('joint name="wrist"', 'joint name="tool"')
    assert codes(tmp_path, text, distro="noetic") == []
    assert codes(tmp_path, text, distro="jazzy") == ["UC113 info"]
    friction = '<gazebo reference="base"><mu1>1</mu1></gazebo>'
    assert codes(tmp_path, with_more(text, friction), distro="jazzy") == ["UC113 warning"]
    assert codes(tmp_path, text, distro="jazzy", simulator="gz") == ["UC113 error"]
    assert codes(tmp_path, text.replace("revolute", "fixed"), distro="jazzy") == []


# -- numbers ---------------------------------------------------------------------------------------------------------


LEADER = """
    <link name="pad">
      <inertial><mass value="1"/><inertia ixx="0.01" ixy="0" ixz="0" iyy="0.01" iyz="0" izz="0.01"/></inertial>
    </link>
    <joint name="lead" type="continuous"><parent link="base"/><child link="pad"/></joint>
"""


@pytest.mark.parametrize("number", ["1", "+1", "1.", ".5", "-0.5e-3", "1E3", "1e-05", "0"])
def test_decimals_are_numbers(tmp_path: Path, number: str) -> None:
    text = joint(f'<dynamics damping="0" friction="0"/>{LIMIT}<mimic joint="lead" offset="{number}"/>')
    assert codes(tmp_path, with_more(text, LEADER)) == []


@pytest.mark.parametrize("number", ["", " ", "1 ", "1,5", "0x10", "1deg", "pi", "nan", "1e400", ".", "--1", "${pi}"])
def test_other_texts_are_not_numbers(tmp_path: Path, number: str) -> None:
    text = joint(f'{LIMIT}<mimic joint="lead" offset="{number}"/>')
    assert codes(tmp_path, with_more(text, LEADER), distro="jazzy") == ["UC127 error"]


@pytest.mark.parametrize("vector", ["0 0 1", " 0  0 1 ", "0 0 1e-05"])
def test_three_numbers_separated_by_spaces_are_a_vector(tmp_path: Path, vector: str) -> None:
    assert codes(tmp_path, joint(f'<axis xyz="{vector}"/>{LIMIT}')) == []


@pytest.mark.parametrize("vector", ["", "0 1", "0 0 0 1", "0,0,1", "0\t0\t1", "0 0\n 1", "0 0 1\n", "0 0 z"])
def test_other_texts_are_not_vectors(tmp_path: Path, vector: str) -> None:
    assert codes(tmp_path, joint(f'<axis xyz="{vector}"/>{LIMIT}'), distro="jazzy") == ["UC127 error"]


def test_xacro_turns_tabs_into_spaces(tmp_path: Path) -> None:
    text = joint(f'<axis xyz="0\t0\t1"/>{LIMIT}')
    assert codes(tmp_path, as_xacro(text), "robot.xacro") == []


def test_a_number_too_small_for_gazebo_is_a_warning(tmp_path: Path) -> None:
    text = joint('<limit lower="-1" upper="1e-320" effort="1" velocity="1"/>')
    assert codes(tmp_path, text) == ["UC127 warning"]
    assert codes(tmp_path, text, simulator="none") == []


def test_an_axis_that_is_not_read_is_not_checked(tmp_path: Path) -> None:
    assert codes(tmp_path, joint('<axis xyz="0 0 0"/>', "fixed")) == []
    assert codes(tmp_path, joint('<axis xyz="nowhere"/>', "fixed")) == []


def test_certain_fixes_of_numbers_are_safe_and_guesses_are_not(tmp_path: Path) -> None:
    text = joint('<axis xyz="0\t0  1"/><limit lower="-1 " upper="1,5" effort="1" velocity="1"/>')
    assert [d.fix.safe for d in findings(tmp_path, text) if d.fix] == [True, True, False]
    mended = fixed(tmp_path, text)
    assert mended == joint('<axis xyz="0 0 1"/><limit lower="-1" upper="1.5" effort="1" velocity="1"/>')
    assert codes(tmp_path, mended) == []


# -- names and the tree ----------------------------------------------------------------------------------------------


def test_a_type_in_the_wrong_case_has_a_safe_fix(tmp_path: Path) -> None:
    (finding,) = findings(tmp_path, joint(LIMIT, "Revolute"))
    assert finding.fix
    assert finding.fix.safe
    assert fixed(tmp_path, joint(LIMIT, "Revolute")) == joint(LIMIT, "revolute")


def test_a_trailing_space_makes_a_name_different(tmp_path: Path) -> None:
    (finding,) = findings(tmp_path, joint(LIMIT).replace('child link="tool"', 'child link="tool "'))
    assert finding.message == "child link 'tool ' of joint 'wrist' is not defined; did you mean 'tool'?"
    assert fixed(tmp_path, joint(LIMIT).replace('child link="tool"', 'child link="tool "')) == joint(LIMIT)


def test_the_link_is_misspelt_if_the_joint_names_match(tmp_path: Path) -> None:
    text = joint(LIMIT).replace('"wrist"', '"imu_joint"').replace('child link="tool"', 'child link="imu_link"')
    text = text.replace('link name="tool"', 'link name="mu_link"')
    (finding,) = findings(tmp_path, text)
    assert finding.message.endswith("not defined; is link 'mu_link', which has no parent joint, misspelt?")
    assert fixed(tmp_path, text) == text.replace("mu_link", "imu_link").replace("iimu", "imu")


def test_a_joint_from_a_link_to_itself_is_a_loop(tmp_path: Path) -> None:
    ends = '<parent link="a"/><child link="a"/>'
    alone = f'<robot name="r"><link name="a">{MASS}</link><joint name="j" type="fixed">{ends}</joint></robot>'
    assert codes(tmp_path, alone) == ["UC106 error"]


def test_a_loop_beside_a_tree_is_a_warning(tmp_path: Path) -> None:
    text = robot(
        '<link name="x"/><link name="y"/>'
        '<joint name="xy" type="fixed"><parent link="x"/><child link="y"/></joint>'
        '<joint name="yx" type="fixed"><parent link="y"/><child link="x"/></joint>'
    )
    (finding,) = findings(tmp_path, text)
    assert finding.severity.value == "warning"
    assert finding.message.startswith("links 'x' and 'y' form a loop, and nothing connects it to the rest of the robot")


def test_the_root_with_the_most_links_is_the_main_root(tmp_path: Path) -> None:
    (finding,) = findings(tmp_path, f'<robot name="arm"><link name="lost"/>{BASE}</robot>')
    assert finding.message == "link 'lost' is not the child of any joint, so it is a second root besides 'world'"


def test_a_link_with_two_parents_is_reported_once(tmp_path: Path) -> None:
    again = '<joint name="again" type="fixed"><parent link="base"/><child link="tool"/></joint>'
    text = with_more(joint(LIMIT), again + '<link name="lost"/>')
    assert codes(tmp_path, text) == ["UC107 warning", "UC105 error"]


def test_the_first_links_of_a_long_loop_are_named(tmp_path: Path) -> None:
    names = "abcdefg"
    links = "".join(f'<link name="{name}"/>' for name in names)
    joints = "".join(
        f'<joint name="{a}{b}" type="fixed"><parent link="{a}"/><child link="{b}"/></joint>'
        for a, b in zip(names, names[1:] + names[0], strict=True)
    )
    (finding,) = findings(tmp_path, f'<robot name="ring">{links}{joints}</robot>')
    expected = "links 'a', 'b', 'c', 'd', 'e' and 2 more form a loop, so the robot has no root link"
    assert finding.message == expected


def test_an_unknown_link_is_not_also_reported_as_a_second_root(tmp_path: Path) -> None:
    assert codes(tmp_path, joint(LIMIT).replace('child link="tool"', 'child link="tol"')) == ["UC116 error"]


def test_two_materials_of_the_same_colour_are_duplicates(tmp_path: Path) -> None:
    grey = '<material name="grey"><color rgba="0.5 0.5 0.5 1"/></material>'
    assert codes(tmp_path, robot(grey + grey)) == ["UC112 error"]


def test_joints_that_mimic_each_other_are_reported_once(tmp_path: Path) -> None:
    leader = hung("a", "base", inside='<mimic joint="b_joint"/>')
    followers = [hung(name, "base", inside='<mimic joint="a_joint"/>') for name in "bc"]
    (finding,) = findings(tmp_path, robot(leader + "".join(followers)))
    assert finding.message == "joint 'a_joint' mimics itself through 'b_joint'"


def test_urdfdom_accepts_empty_names_and_gazebo_rejects_them(tmp_path: Path) -> None:
    assert codes(tmp_path, robot("").replace('name="arm"', 'name=""')) == ["UC102 warning"]
    assert codes(tmp_path, joint(LIMIT).replace('name="wrist"', 'name=""')) == ["UC109 warning"]
    assert codes(tmp_path, joint(LIMIT + '<mimic joint=""/>')) == ["UC119 warning"]


def test_a_single_link_without_a_name_is_a_warning(tmp_path: Path) -> None:
    assert codes(tmp_path, '<robot name="r"><link/></robot>') == ["UC108 warning"]


def test_a_parent_needs_the_name_of_a_link(tmp_path: Path) -> None:
    (finding,) = findings(tmp_path, joint(LIMIT).replace('parent link="base"', 'parent name="base"'))
    assert finding.message == "<parent> of joint 'wrist' has no 'link'"
    (finding,) = findings(tmp_path, joint(LIMIT).replace('parent link="base"', 'parent link=""'))
    assert finding.message == "<parent> of joint 'wrist' has an empty 'link'"


@pytest.mark.parametrize(
    ("written", "meant", "is_sure"),
    [("hinge", "revolute", False), ("slider", "prismatic", False), ("fixd", "fixed", True)],
)
def test_types_of_other_formats_are_translated(tmp_path: Path, written: str, meant: str, *, is_sure: bool) -> None:
    (finding,) = findings(tmp_path, joint(LIMIT, written))
    assert finding.message.endswith(f"did you mean '{meant}'?")
    assert finding.fix
    assert finding.fix.safe is is_sure


def test_the_known_types_are_listed_for_an_unknown_type(tmp_path: Path) -> None:
    (finding,) = findings(tmp_path, joint(LIMIT, "ball"))
    assert finding.message.endswith("use revolute, continuous, prismatic, fixed, floating or planar")


def test_a_floating_joint_matters_less_on_hardware(tmp_path: Path) -> None:
    assert codes(tmp_path, joint("", "floating")) == ["UC122 warning"]
    assert codes(tmp_path, joint("", "floating"), simulator="none") == ["UC122 info"]


def test_an_axis_without_xyz_is_zero(tmp_path: Path) -> None:
    (finding,) = findings(tmp_path, joint(f"<axis/>{LIMIT}"))
    assert finding.message == "<axis> of joint 'wrist' has no 'xyz' and is read as 0 0 0; add a direction"


def test_missing_limits_are_0(tmp_path: Path) -> None:
    (finding,) = findings(tmp_path, joint('<limit upper="-1" effort="1" velocity="1"/>'))
    assert finding.message == "'lower' of joint 'wrist' is 0, but 'upper' is -1 (a missing limit is 0)"
    assert finding.fix is None


def test_a_number_too_small_for_gazebo_is_also_reported_in_links(tmp_path: Path) -> None:
    text = joint(LIMIT, link=MASS.replace('ixy="0"', 'ixy="1e-320"'))
    assert codes(tmp_path, text) == ["UC139 warning"]
    assert codes(tmp_path, text, simulator="none") == []


# -- parts of robots -------------------------------------------------------------------------------------------------


def test_a_part_attached_to_a_link_of_another_file_is_not_a_robot(tmp_path: Path) -> None:
    gripper = """<robot name="gripper" xmlns:xacro="http://www.ros.org/wiki/xacro">
      <link name="palm"/><link name="finger"/>
      <joint name="palm_joint" type="fixed"><parent link="left_hand"/><child link="palm"/></joint>
      <joint name="finger_joint" type="fixed"><parent link="palm"/><child link="finger"/></joint>
      <gazebo reference="left_hand"/>
    </robot>"""
    assert codes(tmp_path, gripper, "gripper.xacro") == []
    assert codes(tmp_path, gripper, "gripper.urdf") == []
    plain = gripper.replace(' xmlns:xacro="http://www.ros.org/wiki/xacro"', "")
    assert codes(tmp_path, plain, "gripper.urdf") == ["UC116 error", "UC156 warning"]


def test_an_unknown_link_in_a_whole_xacro_robot_is_reported(tmp_path: Path) -> None:
    text = joint(LIMIT).replace('parent link="base"', 'parent link="bsae"')
    whole = as_xacro(text)
    assert codes(tmp_path, whole, "robot.xacro") == ["UC116 error"]


def test_a_file_of_materials_is_not_a_robot(tmp_path: Path) -> None:
    text = '<robot xmlns:xacro="http://www.ros.org/wiki/xacro">{}</robot>'
    grey = '<material name="grey"><color rgba="0 0 0 1"/></material>'
    assert codes(tmp_path, text.format(grey), "materials.xacro") == []


def test_unknown_values_are_not_reported(tmp_path: Path) -> None:
    text = joint('<axis xyz="${nowhere}"/><limit lower="${low}" upper="-2" effort="${e}" velocity="1"/>')
    whole = as_xacro(text)
    assert codes(tmp_path, whole, "robot.xacro") == []


# -- masses ----------------------------------------------------------------------------------------------------------


def test_a_link_without_mass_is_fine_if_a_link_with_mass_is_fixed_to_it(tmp_path: Path) -> None:
    flange = hung("flange", "tool", "fixed")
    assert codes(tmp_path, with_more(joint(LIMIT, link=""), flange)) == []


def test_a_kept_fixed_joint_needs_mass_on_both_sides(tmp_path: Path) -> None:
    frame = (
        '<link name="frame"/><joint name="f" type="fixed"><parent link="tool"/><child link="frame"/></joint>'
        '<gazebo reference="f"><preserveFixedJoint>true</preserveFixedJoint></gazebo>'
    )
    text = with_more(joint(LIMIT), frame)
    assert codes(tmp_path, text) == ["UC133 warning"]
    assert codes(tmp_path, text.replace("true", "false")) == []


def test_the_number_of_joints_lost_with_a_link_is_reported(tmp_path: Path) -> None:
    finger = hung("finger", "tool")
    (finding,) = findings(tmp_path, with_more(joint(LIMIT, link=""), finger))
    assert finding.message == "link 'tool' of joint 'wrist' has no <inertial>; Gazebo drops it and 2 moving joints"


def test_a_robot_without_any_mass_is_reported_once(tmp_path: Path) -> None:
    text = joint(LIMIT).replace(MASS, "")
    assert codes(tmp_path, text) == ["UC133 warning"]
    assert codes(tmp_path, text, simulator="gz") == ["UC133 error"]
    assert codes(tmp_path, text, simulator="none") == []


@pytest.mark.parametrize("mass", ["0", "0.0", "1e-9"])
def test_a_moving_link_without_mass_is_dropped(tmp_path: Path, mass: str) -> None:
    assert codes(tmp_path, joint(LIMIT, link=MASS.replace('mass value="1"', f'mass value="{mass}"'))) == [
        "UC135 warning"
    ]


def test_a_fixed_frame_without_mass_is_harmless(tmp_path: Path) -> None:
    assert codes(tmp_path, joint("", "fixed", MASS.replace('mass value="1"', 'mass value="0"'))) == []


@pytest.mark.parametrize(
    ("moments", "expected"),
    [
        ('ixx="1" ixy="0" ixz="0" iyy="1" iyz="0" izz="2"', []),  # a flat plate, just possible
        ('ixx="0" ixy="0" ixz="0" iyy="0" iyz="0" izz="0"', ["UC158 info"]),  # a point, which sdformat accepts
        ('ixx="1" ixy="0" ixz="0" iyy="1" iyz="0" izz="2.1"', ["UC136 warning"]),
        ('ixx="-1" ixy="0" ixz="0" iyy="1" iyz="0" izz="1"', ["UC136 warning"]),
        ('ixx="1" ixy="2" ixz="0" iyy="1" iyz="0" izz="1"', ["UC136 warning"]),
        ('ixx="1" ixy="0.9" ixz="0" iyy="1" iyz="0" izz="1"', ["UC136 warning"]),
    ],
)
def test_an_inertia_is_judged_by_its_principal_moments(tmp_path: Path, moments: str, expected: list[str]) -> None:
    inertial = f'<inertial><mass value="1"/><inertia {moments}/></inertial>'
    assert codes(tmp_path, joint(LIMIT, link=inertial), distro="jazzy") == expected


def test_rounding_of_an_inertia_matters_to_ros_2_only(tmp_path: Path) -> None:
    inertial = '<inertial><mass value="1"/><inertia ixx="1" ixy="0" ixz="0" iyy="1" iyz="0" izz="2.001"/></inertial>'
    assert codes(tmp_path, joint(LIMIT, link=inertial), distro="jazzy") == ["UC136 warning"]
    assert codes(tmp_path, joint(LIMIT, link=inertial), distro="noetic") == []


def test_a_negative_mass_is_also_reported_for_fixed_links(tmp_path: Path) -> None:
    text = joint("", "fixed", MASS.replace('mass value="1"', 'mass value="-1"'))
    assert codes(tmp_path, text) == ["UC135 warning"]


def test_a_malformed_origin_drops_the_inertial(tmp_path: Path) -> None:
    (finding,) = findings(tmp_path, joint(LIMIT, link=MASS.replace("<mass", '<origin xyz="0 0"/><mass')))
    assert finding.message.endswith("'0 0', so the <inertial> is dropped: expected 3 numbers, found 2")


def test_an_ignored_element_may_be_malformed(tmp_path: Path) -> None:
    assert codes(tmp_path, joint(LIMIT + '<limit effort="much"/>')) == ["UC153 warning"]


def test_an_incomplete_inertial_is_dropped(tmp_path: Path) -> None:
    (finding,) = findings(tmp_path, joint(LIMIT, link='<inertial><mass value="1"/></inertial>'))
    assert finding.message == "<inertial> of link 'tool' has no <inertia>; it is dropped"


def test_parts_that_a_library_leaves_open_are_not_missing(tmp_path: Path) -> None:
    text = """<robot name="lib" xmlns:xacro="http://www.ros.org/wiki/xacro">
      <xacro:macro name="part" params="name *inertial">
        <link name="${name}"><inertial><xacro:insert_block name="inertial"/><xacro:from_elsewhere/></inertial></link>
        <joint name="${name}_joint" type="revolute"><xacro:from_elsewhere/></joint>
      </xacro:macro>
    </robot>"""
    assert codes(tmp_path, text, "lib.xacro") == []


def test_a_fault_in_a_library_is_reported_at_its_place(tmp_path: Path) -> None:
    text = """<robot name="lib" xmlns:xacro="http://www.ros.org/wiki/xacro">
      <xacro:macro name="part" params="name">
        <link name="${name}"><inertial><mass value="1kg"/></inertial></link>
        <joint name="${name}_joint" type="Fixed"/>
      </xacro:macro>
    </robot>"""
    assert codes(tmp_path, text, "lib.xacro") == ["UC139 warning", "UC121 error"]


@pytest.mark.parametrize(
    ("shape", "expected"),
    [
        ('<box size="1 1 1"/>', ["UC137 info"]),
        ('<cylinder length="1" radius="0.2"/>', ["UC137 info"]),
        ('<sphere radius="0.5"/>', ["UC137 info"]),
        ('<box size="1 1"/>', ["UC139 warning"]),
        ('<box size="0.001 0.001 0.001"/>', []),
        ("<mesh filename='http://x/a.stl'/>", []),
        ("<cone/>", ["UC141 warning"]),
    ],
)
def test_the_size_of_a_link_is_that_of_its_simple_shapes(tmp_path: Path, shape: str, expected: list[str]) -> None:
    link = MASS.replace("0.1", "1e-8") + f"<collision><geometry>{shape}</geometry></collision>"
    assert codes(tmp_path, joint(LIMIT, link=link)) == expected


# -- limits ----------------------------------------------------------------------------------------------------------

COMMANDED = """<transmission name="t"><type>transmission_interface/SimpleTransmission</type>
  <joint name="wrist"><hardwareInterface>hardware_interface/EffortJointInterface</hardwareInterface></joint>
  <actuator name="m"><mechanicalReduction>1</mechanicalReduction></actuator></transmission>"""


def test_a_velocity_limit_of_0_is_reported_if_the_joint_is_commanded(tmp_path: Path) -> None:
    passive = joint('<limit lower="-1" upper="1" effort="1" velocity="0"/>')
    assert codes(tmp_path, passive) == []
    assert codes(tmp_path, with_more(passive, COMMANDED)) == ["UC131 warning"]


LIBRARY = """<robot name="lib" xmlns:xacro="http://www.ros.org/wiki/xacro">
  <xacro:macro name="part" params="prefix">
    <link name="${{prefix}}palm"/><link name="${{prefix}}finger"/>
    <joint name="${{prefix}}finger_joint" type="prismatic">
      <parent link="${{prefix}}palm"/><child link="${{prefix}}finger"/>{}
    </joint>
  </xacro:macro>
</robot>"""


def test_a_velocity_limit_of_0_is_reported_in_a_library_for_joints_that_look_driven(tmp_path: Path) -> None:
    driven = LIBRARY.format('<limit lower="-1" upper="1" effort="1" velocity="0"/>')
    assert codes(tmp_path, driven, "lib.xacro") == ["UC131 warning"]
    assert codes(tmp_path, driven.replace('effort="1"', 'effort="0"'), "lib.xacro") == []
    assert codes(tmp_path, driven.replace('upper="1"', 'upper="-1"'), "lib.xacro") == []


def test_a_mimicked_joint_of_a_library_is_looked_up_in_the_library(tmp_path: Path) -> None:
    text = LIBRARY.format(LIMIT + '<mimic joint="${{prefix}}gripper"/>'.replace("{{", "{").replace("}}", "}"))
    (finding,) = findings(tmp_path, text, "lib.xacro")
    assert finding.message == "joint '${prefix}finger_joint' mimics unknown joint '${prefix}gripper'"
    assert codes(tmp_path, text.replace("prefix}gripper", "prefix}"), "lib.xacro") == []
    assert codes(tmp_path, text.replace('name="${prefix}finger_joint"', 'name="${prefix}"'), "lib.xacro") == []


def test_an_effort_limit_of_0_is_reported_if_the_joint_is_commanded_by_effort(tmp_path: Path) -> None:
    passive = joint('<limit lower="-1" upper="1" effort="0" velocity="1"/>')
    assert codes(tmp_path, passive) == []
    assert codes(tmp_path, with_more(passive, COMMANDED)) == ["UC161 warning"]
    assert codes(tmp_path, with_more(passive, COMMANDED.replace("Effort", "Position"))) == []


@pytest.mark.parametrize(
    ("limits", "mimic", "told"),
    [
        ('lower="-1" upper="1"', "", []),
        ('lower="-1" upper="1"', 'multiplier="-1"', []),
        ('lower="-0.99" upper="0.99"', "", []),
        ('lower="-1" upper="1"', 'multiplier="2"', ["UC160 warning"]),
        ('lower="-1" upper="1"', 'offset="0.5"', ["UC160 warning"]),
        ('lower="0" upper="2"', 'offset="1"', []),
        ('lower="0" upper="1"', 'multiplier="-0.5"', ["UC160 warning"]),
    ],
)
def test_a_mimic_joint_is_compared_with_its_limits(tmp_path: Path, limits: str, mimic: str, told: list[str]) -> None:
    follower = joint(f'<limit {limits} effort="1" velocity="1"/><mimic joint="elbow" {mimic}/>')
    leader = """<link name="lower"/><joint name="elbow" type="revolute"><parent link="base"/><child link="lower"/>
      <limit lower="-1" upper="1" effort="1" velocity="1"/></joint>"""
    assert [one for one in codes(tmp_path, with_more(follower, leader)) if "UC160" in one] == told


def test_equal_limits_of_a_passive_joint_are_fine(tmp_path: Path) -> None:
    passive = joint('<limit lower="0" upper="0" effort="1" velocity="1"/>')
    assert codes(tmp_path, passive) == []
    assert codes(tmp_path, with_more(passive, COMMANDED)) == ["UC132 warning"]


def test_reversed_limits_have_a_fix(tmp_path: Path) -> None:
    assert fixed(tmp_path, joint('<limit lower="2" upper="-1" effort="1" velocity="1"/>')) == joint(
        '<limit lower="-1" upper="2" effort="1" velocity="1"/>'
    )


def test_the_limit_of_a_fixed_joint_is_read_too(tmp_path: Path) -> None:
    assert codes(tmp_path, joint('<limit lower="0" upper="0"/>', "fixed")) == ["UC124 error"]


# -- looks -----------------------------------------------------------------------------------------------------------


def shown(material: str) -> str:
    """Return a robot whose tool is a box with a material."""
    return joint(LIMIT, link=f'{MASS}<visual><geometry><box size="1 1 1"/></geometry>{material}</visual>')


def test_colours_in_bytes_have_a_fix(tmp_path: Path) -> None:
    text = shown('<material name="red"><color rgba="255 0 51 255"/></material>')
    assert codes(tmp_path, text) == ["UC147 warning"]
    assert fixed(tmp_path, text) == shown('<material name="red"><color rgba="1 0 0.2 1"/></material>')
    opaque = shown('<material name="white"><color rgba="1 1 1 2"/></material>')
    assert codes(tmp_path, opaque) == ["UC147 warning"]
    assert fixed(tmp_path, opaque) == opaque


def test_a_soft_limit_without_its_ending_that_is_zero_anyway_loses_nothing(tmp_path: Path) -> None:
    safety = '<safety_controller k_velocity="1" soft_lower_limit="-1" soft_upper="{}"/>'
    assert codes(tmp_path, joint(LIMIT + safety.format("0"))) == ["UC163 info"]
    assert codes(tmp_path, joint(LIMIT + safety.format("0.9"))) == ["UC163 warning"]


def test_an_empty_material_name_is_accepted_and_a_missing_one_is_not(tmp_path: Path) -> None:
    assert codes(tmp_path, shown('<material name=""><color rgba="1 0 0 1"/></material>')) == []
    assert codes(tmp_path, shown('<material><color rgba="1 0 0 1"/></material>')) == ["UC144 warning"]


def test_a_material_is_known_after_its_definition(tmp_path: Path) -> None:
    box = '<visual><geometry><box size="1 1 1"/></geometry>{}</visual>'
    definition, reference = (
        box.format('<material name="red"><color rgba="1 0 0 1"/></material>'),
        box.format('<material name="red"/>'),
    )
    assert codes(tmp_path, joint(LIMIT, link=MASS + definition + reference)) == []
    (finding,) = findings(tmp_path, joint(LIMIT, link=MASS + reference + definition))
    assert finding.message == "material 'red' of link 'tool' is used before it is defined"


def test_a_negative_scale_mirrors_a_mesh(tmp_path: Path) -> None:
    mesh = '<visual><geometry><mesh filename="package://p/a.stl" scale="{}"/></geometry></visual>'
    assert "UC143 warning" not in codes(tmp_path, joint(LIMIT, link=MASS + mesh.format("1 -1 1")))
    assert "UC143 warning" in codes(tmp_path, joint(LIMIT, link=MASS + mesh.format("1 0 1")))


def test_elements_of_other_readers_are_not_misspelt(tmp_path: Path) -> None:
    others = '<contact><lateral_friction value="1"/></contact><self_collision_checking/><contact_coefficients mu="0"/>'
    assert codes(tmp_path, joint(LIMIT + '<limits_of_ours a="1"/>', link=MASS + others)) == []


@pytest.mark.parametrize(
    ("written", "meant"), [("limits", "limit"), ("Axis", "axis"), ("orgin", "origin"), ("mimick", "mimic")]
)
def test_misspelt_elements_are_reported(tmp_path: Path, written: str, meant: str) -> None:
    (finding,) = findings(tmp_path, joint(f"{LIMIT}<{written}/>"))
    assert finding.message == f"<{written}> of joint 'wrist' is ignored; did you mean <{meant}>?"


def test_colours_are_four_numbers(tmp_path: Path) -> None:
    for rgba in ("1 0 0", "red", "1 0 0 -1", "1,0,0,1"):
        assert codes(tmp_path, shown(f'<material name="m"><color rgba="{rgba}"/></material>')) == ["UC147 warning"]


def test_materials_of_the_robot_need_a_name(tmp_path: Path) -> None:
    assert codes(tmp_path, robot('<material><color rgba="1 0 0 1"/></material>')) == ["UC144 warning"]


def test_a_mesh_without_a_file_name_is_reported(tmp_path: Path) -> None:
    mesh = '<visual><geometry><mesh filename=""/></geometry></visual>'
    assert codes(tmp_path, joint(LIMIT, link=MASS + mesh)) == ["UC142 warning"]


@pytest.mark.parametrize(
    ("there", "meant"),
    [("link1.stl", ""), ("link0.STL", "; did you mean 'link0.STL'?"), ("link_0.stl", "; did you mean 'link_0.stl'?")],
)
def test_the_mesh_of_another_link_is_not_meant(tmp_path: Path, there: str, meant: str) -> None:
    (tmp_path / "package.xml").write_text("<package><name>arm</name></package>")
    (tmp_path / "meshes").mkdir()
    for name in {"link1.stl", there}:
        (tmp_path / "meshes" / name).write_text("solid a")
    visual = '<visual><geometry><mesh filename="package://arm/meshes/{}.stl"/></geometry></visual>'
    (finding,) = findings(tmp_path, joint(LIMIT, link=MASS + visual.format("link0") + visual.format("link1")))
    assert finding.message.endswith(f"/link0.stl'{meant}")


def test_one_mesh_of_a_missing_folder_is_reported(tmp_path: Path) -> None:
    (tmp_path / "package.xml").write_text("<package><name>arm</name></package>")
    visual = '<visual><geometry><mesh filename="package://arm/meshes/{}.stl"/></geometry></visual>'
    text = joint(LIMIT, link=MASS + visual.format("a") + visual.format("b") + visual.format("c"))
    (finding,) = findings(tmp_path, text)
    assert finding.message.endswith("/a.stl' (all 3 meshes of its folder are missing)")
    (tmp_path / "meshes").mkdir()
    (tmp_path / "meshes" / "a.stl").write_text("solid a")
    assert [d.code for d in findings(tmp_path, text)] == ["UC149", "UC149"]


def test_one_mesh_of_a_missing_package_is_reported(tmp_path: Path) -> None:
    visual = '<visual><geometry><mesh filename="package://nowhere/{}.stl"/></geometry></visual>'
    (finding,) = findings(tmp_path, joint(LIMIT, link=MASS + visual.format("a") + visual.format("b")))
    assert finding.message == "mesh package 'nowhere' was not found in this workspace (2 meshes)"
