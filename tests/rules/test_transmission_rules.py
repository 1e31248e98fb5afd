"""The transmission rules beyond their examples: findings by distro and simulator, notes and fixes."""

from __future__ import annotations

from pathlib import Path

import pytest
from folder import Folder
from robots import Robot, findings, notes, whole

from urdfctl.load.target import Target

SOUND = """
    <transmission name="elbow_trans">
      <type>transmission_interface/SimpleTransmission</type>
      <joint name="elbow"><hardwareInterface>hardware_interface/EffortJointInterface</hardwareInterface></joint>
      <actuator name="elbow_motor"><mechanicalReduction>1</mechanicalReduction></actuator>
    </transmission>
"""
EFFORT = "<hardwareInterface>hardware_interface/EffortJointInterface</hardwareInterface>"
DIFFERENTIAL = f"""
    <transmission name="wrist">
      <type>transmission_interface/DifferentialTransmission</type>
      <joint name="shoulder"><role>joint1</role>{EFFORT}</joint>
      <joint name="elbow"><role>joint2</role>{EFFORT}</joint>
      <actuator name="left"><role>actuator1</role><mechanicalReduction>5</mechanicalReduction></actuator>
      <actuator name="right"><role>actuator2</role><mechanicalReduction>5</mechanicalReduction></actuator>
    </transmission>
"""
PLUGIN = '<gazebo><plugin name="control" filename="libgazebo_ros_control.so"/></gazebo>'
OTHER_SIMULATION = """
    <gazebo>
      <plugin name="control" filename="libgazebo_ros_control.so">
        <robotSimType>franka_gazebo/FrankaHWSim</robotSimType>
      </plugin>
    </gazebo>
"""


# -- names of interfaces ---------------------------------------------------------------------------------------------

BARE = SOUND.replace("hardware_interface/", "")


@pytest.mark.parametrize(
    ("distro", "simulator", "expected"),
    [
        (None, None, ["warning UC202"]),
        ("noetic", None, ["warning UC202"]),
        ("noetic", "gazebo-classic", ["warning UC202"]),
        ("noetic", "none", ["error UC202"]),
        ("indigo", "gazebo-classic", []),
        ("jazzy", None, ["warning UC330"]),
    ],
)
def test_a_bare_interface_is_deprecated_in_gazebo_and_rejected_by_hardware(
    robot: Robot, distro: str, simulator: str, expected: list[str]
) -> None:
    assert robot.says(BARE, distro=distro, simulator=simulator) == expected


def test_adding_the_prefix_is_safe_only_if_the_distro_is_known_to_accept_it(robot: Robot) -> None:
    known = robot.only("UC202", BARE, distro="melodic")
    assert known.fix is not None
    assert known.fix.safe
    assert ">hardware_interface/EffortJointInterface<" in robot.fixed(known)
    unknown = robot.only("UC202", BARE)
    assert unknown.fix is not None
    assert not unknown.fix.safe


@pytest.mark.parametrize(
    ("distro", "simulator", "expected"),
    [
        ("jade", "gazebo-classic", ["error UC226"]),
        ("jade", None, ["warning UC226"]),
        ("jade", "none", []),
        (None, "gazebo-classic", []),
        ("kinetic", "gazebo-classic", []),
    ],
)
def test_a_prefixed_interface_stops_the_simulation_up_to_jade(
    robot: Robot, distro: str, simulator: str, expected: list[str]
) -> None:
    assert robot.says(SOUND, distro=distro, simulator=simulator) == expected


def test_an_unknown_interface_is_corrected_in_the_form_of_the_distro(robot: Robot) -> None:
    written = SOUND.replace("hardware_interface/EffortJointInterface", "position")
    finding = robot.only("UC203", written, distro="noetic")
    assert "did you mean 'hardware_interface/PositionJointInterface'?" in finding.message
    assert ">hardware_interface/PositionJointInterface<" in robot.fixed(finding)
    assert "did you mean 'PositionJointInterface'?" in robot.only("UC203", written, distro="indigo").message


@pytest.mark.parametrize(
    ("text", "meant"),
    [
        ("hardware_interface::EffortJointInterface", "EffortJointInterface"),
        ("transmission_interface/VelocityJointInterface", "VelocityJointInterface"),
        ("hardware_interfaces/PosVelJointInterface", "PosVelJointInterface"),
        ("EfortJointInterface", "EffortJointInterface"),
    ],
)
def test_the_intended_interface_is_suggested(robot: Robot, text: str, meant: str) -> None:
    finding = robot.only("UC203", SOUND.replace("hardware_interface/EffortJointInterface", text), simulator="none")
    assert finding.severity.value == "error"
    assert f"did you mean 'hardware_interface/{meant}'?" in finding.message


def test_an_interface_without_a_suggestion_is_an_error_only_if_the_runtime_is_known(robot: Robot) -> None:
    foo = SOUND.replace("hardware_interface/EffortJointInterface", "foo")
    assert robot.says(foo) == ["warning UC203"]
    assert robot.says(foo, simulator="none") == ["error UC203"]
    assert robot.says(foo, simulator="gazebo-classic") == ["error UC203"]
    assert robot.says(foo, simulator="mujoco") == ["warning UC203"]
    assert robot.says(foo + PLUGIN) == ["error UC203"]


def test_interfaces_of_hardware_only_are_errors_only_in_gazebo(robot: Robot) -> None:
    posvel = SOUND.replace("EffortJointInterface", "PosVelJointInterface")
    assert robot.says(posvel) == []
    assert robot.says(posvel, simulator="none") == []
    finding = robot.only("UC203", posvel, simulator="gazebo-classic", distro="noetic")
    assert (
        "'hardware_interface/EffortJointInterface', 'hardware_interface/PositionJointInterface' and" in finding.message
    )


def test_a_bare_interface_of_hardware_only_is_reported_once_in_gazebo(robot: Robot) -> None:
    posvel = SOUND.replace("hardware_interface/EffortJointInterface", "PosVelJointInterface")
    assert robot.says(posvel, simulator="gazebo-classic") == ["error UC203"]
    assert robot.says(posvel) == ["warning UC202"]


def test_an_interface_of_another_package_is_left_to_its_own_hardware(robot: Robot) -> None:
    franka = SOUND.replace("hardware_interface/EffortJointInterface", "franka_hw/FrankaModelInterface")
    assert robot.says(franka) == []
    assert robot.says(franka, simulator="none") == []
    assert robot.says(franka + PLUGIN) == ["info UC203"]
    assert robot.says(franka, simulator="gazebo-classic") == ["error UC203"]
    assert robot.says(franka + OTHER_SIMULATION, simulator="gazebo-classic") == []


def test_gazebo_reads_the_first_of_several_interfaces(robot: Robot) -> None:
    second = SOUND.replace("</hardwareInterface>", "</hardwareInterface><hardwareInterface>foo</hardwareInterface>")
    assert robot.says(second, simulator="gazebo-classic") == ["warning UC217"]
    assert robot.says(second) == ["warning UC203"]
    assert robot.says(second + PLUGIN) == ["warning UC217", "warning UC203"]


def test_an_actuator_may_name_the_interface_of_its_joint_in_any_form(robot: Robot) -> None:
    same = SOUND.replace("<mech", "<hardwareInterface>EffortJointInterface</hardwareInterface><mech")
    assert robot.says(same) == []
    assert robot.says(same.replace(">EffortJoint", ">hardware_interface/EffortActuator")) == []


def test_a_comment_that_hides_an_interface_is_noted(robot: Robot) -> None:
    hidden = SOUND.replace("<hardware", "<hardwareInterface><!-- c -->x</hardwareInterface><hardware", 1)
    assert "a comment precedes the text" in notes(robot.only("UC223", hidden))


def test_a_missing_interface_has_a_note_where_it_may_be(robot: Robot) -> None:
    snake = SOUND.replace("hardwareInterface", "hardware_interface")
    finding = robot.only("UC201", snake)
    assert "<hardware_interface> is ignored; the element is called <hardwareInterface>" in notes(finding)
    assert finding.fix is not None
    assert finding.fix.title == "rename <hardware_interface> to <hardwareInterface>"
    assert robot.fixed(finding) == f'<joint name="elbow">{EFFORT}</joint>'
    hidden = robot.only("UC201", SOUND.replace("<hardwareInterface>", "<hardwareInterface><!-- c -->"))
    assert "joint 'elbow' of transmission 'elbow_trans' has an empty <hardwareInterface>" in hidden.message
    assert "a comment precedes the text" in notes(hidden)
    assert notes(robot.only("UC201", SOUND.replace(EFFORT, "<hardwareInterface/>"), distro="noetic")) == ""
    beside = SOUND.replace(EFFORT, "").replace("<actuator", EFFORT + "<!-- c --><note/><actuator")
    assert "is outside the joint; move it into <joint>" in notes(robot.only("UC201", beside))
    assert robot.lint(beside, distro="indigo")[0].fix is not None


def test_a_missing_interface_is_added_as_the_actuator_names_it(robot: Robot) -> None:
    actuator = SOUND.replace(EFFORT, "").replace('_motor">', '_motor"><hardwareInterface>Velocity</hardwareInterface>')
    actuator = actuator.replace("Velocity", "VelocityJointInterface")
    finding = robot.only("UC201", actuator, distro="kinetic")
    assert robot.fixed(finding) == f'<joint name="elbow">{EFFORT.replace("Effort", "Velocity")}</joint>'
    closed = robot.only("UC201", actuator.replace('"elbow"></joint>', '"elbow" />'), distro="indigo")
    assert robot.fixed(closed) == (
        '<joint name="elbow" ><hardwareInterface>VelocityJointInterface</hardwareInterface></joint>'
    )
    unknown = robot.only("UC201", SOUND.replace(EFFORT, ""))
    assert unknown.fix is not None
    assert (unknown.fix.edits, unknown.fix.safe) == ((), False)


# -- types -----------------------------------------------------------------------------------------------------------


def test_a_misspelt_or_hidden_type_is_noted(robot: Robot) -> None:
    case = SOUND.replace("<type>", "<Type>").replace("</type>", "</Type>")
    assert "<Type> is ignored; the element is called <type>" in notes(robot.only("UC204", case))
    comment = SOUND.replace("<type>", "<type><!-- simple -->")
    assert "a comment precedes the text" in notes(robot.only("UC204", comment))
    attribute = robot.only(
        "UC204", SOUND.replace("<type>", "<kind>").replace("</type>", "</kind>").replace('s"', 's" type="x"', 1)
    )
    assert "ros_control does not read the attribute 'type'" in notes(attribute)
    two = DIFFERENTIAL.replace("<type>transmission_interface/DifferentialTransmission</type>", "<type/>")
    finding = robot.only("UC204", two)
    assert finding.fix is not None
    assert "DifferentialTransmission" in finding.fix.title


def test_the_form_of_the_pr2_is_left_to_the_pr2(robot: Robot) -> None:
    pr2 = """
        <transmission name="elbow_trans" type="pr2_mechanism_model/SimpleTransmission">
          <joint name="elbow"/><actuator name="elbow_motor"/><mechanicalReduction>1</mechanicalReduction>
        </transmission>
    """
    assert robot.says(pr2) == []
    assert robot.says(pr2, simulator="gazebo-classic") == []
    assert robot.says(pr2 + PLUGIN) == ["error UC204"]
    assert (
        robot.says(
            f"<link name='x'>{pr2}</link><joint name='j' type='fixed'><parent link='fore'/><child link='x'/></joint>"
        )
        == []
    )


@pytest.mark.parametrize(
    ("text", "expected"),
    [
        ("pr2_mechanism_model/SimpleTransmission", "did you mean 'transmission_interface/SimpleTransmission'?"),
        ("transmission_interface::SimpleTransmission", "did you mean 'transmission_interface/SimpleTransmission'?"),
        ("transmission_interfaces/SimpleTransmission", "did you mean 'transmission_interface/SimpleTransmission'?"),
        (
            "transmission_interface/FourBarLinkTransmission",
            "did you mean 'transmission_interface/FourBarLinkageTransmission'?",
        ),
        ("transmission_interface/Gear", "ros_control knows 'transmission_interface/SimpleTransmission', "),
    ],
)
def test_the_intended_type_is_suggested(robot: Robot, text: str, expected: str) -> None:
    unknown = SOUND.replace("transmission_interface/SimpleTransmission", text)
    assert expected in robot.only("UC205", unknown).message
    assert robot.says(unknown, simulator="gazebo-classic") == ["warning UC205"]
    assert robot.says(unknown, simulator="none") == ["error UC205"]


def test_a_type_of_another_package_is_left_to_that_package(robot: Robot) -> None:
    other = SOUND.replace("transmission_interface/SimpleTransmission", "my_robot/CoupledTransmission")
    assert robot.says(other) == []
    assert robot.says(other.replace("<mechanicalReduction>1</mechanicalReduction>", "")) == []
    assert robot.says(other.replace(">1<", ">one<")) == []


# -- joints ----------------------------------------------------------------------------------------------------------


@pytest.mark.parametrize(("simulator", "expected"), [(None, "error"), ("gazebo-classic", "error"), ("none", "warning")])
def test_an_unknown_joint_stops_the_simulation(robot: Robot, simulator: str, expected: str) -> None:
    finding = robot.only("UC206", SOUND.replace('"elbow"', '"elbw"'), simulator=simulator)
    assert finding.severity.value == expected
    assert '<joint name="elbow">' in robot.fixed(finding)


@pytest.mark.parametrize(
    ("library", "expected"), [("libgazebo_ros_control.so", "error"), ("libgazebo_ros_skid_steer_drive.so", "warning")]
)
def test_an_unknown_joint_is_a_warning_if_another_plugin_moves_the_robot(
    robot: Robot, library: str, expected: str
) -> None:
    plugin = f'<gazebo><plugin name="p" filename="{library}"/></gazebo>'
    found = robot.lint(SOUND.replace('"elbow"', '"elbw"') + plugin)
    assert [one.severity.value for one in found if one.code == "UC206"] == [expected]


def test_a_link_in_place_of_a_joint_is_noted(robot: Robot) -> None:
    finding = robot.only("UC206", SOUND.replace('"elbow"', '"fore"'))
    assert finding.fix is not None
    assert (finding.fix.title, finding.fix.safe) == ("write 'elbow'", False)
    assert "'fore' is a link; the joint that moves it is 'elbow'" in notes(finding)
    assert "is a link" in notes(robot.only("UC206", SOUND.replace('"elbow"', '"base"')))


OTHER_ARM = """\
<robot xmlns:xacro="http://www.ros.org/wiki/xacro">
  <xacro:macro name="drives" params="arm">
    <xacro:property name="hardware" value="hardware_interface/EffortJointInterface"/>
    LINK
    <transmission name="t1">
      <type>transmission_interface/SimpleTransmission</type>
      <joint name="${arm}_axis_1"><hardwareInterface>${hardware}</hardwareInterface></joint>
      <actuator name="m1"><mechanicalReduction>1</mechanicalReduction></actuator>
    </transmission>
    <transmission name="t2">
      <type>transmission_interface/SimpleTransmission</type>
      <joint name="SECOND"><hardwareInterface>${hardware}</hardwareInterface></joint>
      <actuator name="m2"><mechanicalReduction>1</mechanicalReduction></actuator>
    </transmission>
  </xacro:macro>
</robot>
"""
CALLING = """\
<robot name="r" xmlns:xacro="http://www.ros.org/wiki/xacro">
  <xacro:include filename="drives.xacro"/>
  <link name="base"/><link name="upper"/>
  <joint name="elbow" type="continuous">
    <parent link="base"/><child link="upper"/><axis xyz="0 0 1"/>
  </joint>
  <xacro:drives arm="other"/>
</robot>
"""


def findings_of_calls(folder: Folder, second: str = "${arm}_axis_2", link: str = "") -> list[str]:
    folder.write({"drives.xacro": OTHER_ARM.replace("SECOND", second).replace("LINK", link), "robot.xacro": CALLING})
    output = folder.run("lint", "robot.xacro", "--select", "UC206", "--format", "concise").stdout
    return output.splitlines()


def test_a_macro_for_another_robot_is_reported_once_at_its_call(folder: Folder) -> None:
    missing = "but this robot has none of these joints"
    assert findings_of_calls(folder) == [
        f"robot.xacro:7:3: error UC206 macro 'drives' drives 'other_axis_1' and 'other_axis_2', {missing}",
    ]


@pytest.mark.parametrize(
    ("second", "link"), [("elbow", ""), ("elbo", ""), ("other_axis_2", '<link name="${arm}_tool"/>')]
)
def test_a_macro_that_partly_fits_the_robot_is_reported_in_the_macro(second: str, link: str, folder: Folder) -> None:
    assert [line.partition(":")[0] for line in findings_of_calls(folder, second, link) if "UC206" in line] == [
        "drives.xacro" for name in ("other_axis_1", second) if name != "elbow"
    ]


def test_an_unknown_joint_is_not_reported_if_a_part_of_the_robot_is_missing(robot: Robot) -> None:
    part = "<xacro:no_such_macro/>" + SOUND.replace('"elbow"', '"elbw"')
    assert "UC206" not in {finding.code for finding in robot.lint(part, name="robot.xacro")}


def test_a_robot_without_joints_is_a_fragment(robot: Robot) -> None:
    assert robot.says(f"<robot name='r'><link name='base'/>{SOUND}</robot>") == []


TOOL = "<link name='tool'/><joint name='mount' type='fixed'><parent link='fore'/><child link='tool'/></joint>"


@pytest.mark.parametrize(
    ("simulator", "expected"), [(None, "warning"), ("gazebo-classic", "error"), ("none", "warning")]
)
def test_a_fixed_joint_stops_the_simulation(robot: Robot, simulator: str, expected: str) -> None:
    finding = robot.only("UC207", TOOL + SOUND.replace('"elbow"', '"mount"'), simulator=simulator)
    assert finding.severity.value == expected
    assert "which is fixed" in finding.message


def test_a_preserved_fixed_joint_does_not_stop_gazebo(robot: Robot) -> None:
    kept = "<gazebo reference='mount'><preserveFixedJoint>true</preserveFixedJoint></gazebo>"
    finding = robot.only("UC207", TOOL + kept + SOUND.replace('"elbow"', '"mount"'), simulator="gazebo-classic")
    assert finding.severity.value == "warning"


def test_different_interfaces_in_two_transmissions_of_a_joint_are_noted(robot: Robot) -> None:
    second = SOUND.replace("elbow_", "other_").replace("Effort", "Position")
    finding = robot.only("UC208", SOUND + second)
    assert "it is first used in transmission 'elbow_trans'" in notes(finding)
    assert "their interfaces differ" in notes(finding)
    assert "differ" not in notes(robot.only("UC208", SOUND + SOUND.replace("elbow_", "other_")))


# -- what the parser skips -------------------------------------------------------------------------------------------


def test_misspelt_joints_and_actuators_are_noted(robot: Robot) -> None:
    joint = SOUND.replace("<joint", "<Joint").replace("</joint", "</Joint")
    assert "<Joint> is ignored" in notes(robot.only("UC219", joint))
    assert notes(robot.only("UC219", SOUND.replace(f'<joint name="elbow">{EFFORT}</joint>', ""))) == ""
    actuator = SOUND.replace("<actuator", "<Actuator").replace("</actuator", "</Actuator")
    assert "<Actuator> is ignored" in notes(robot.only("UC211", actuator))


def test_an_empty_name_skips_one_end_and_a_missing_name_skips_the_transmission(robot: Robot) -> None:
    motor = "<actuator name='m2'><mechanicalReduction>1</mechanicalReduction></actuator></transmission>"
    two = SOUND.replace("</transmission>", motor)
    assert robot.only("UC211", two.replace('"elbow_motor"', '""')).severity.value == "warning"
    assert robot.only("UC211", SOUND.replace('"elbow_motor"', '""')).severity.value == "error"
    assert robot.only("UC211", two.replace(' name="elbow_motor"', "")).severity.value == "error"
    assert robot.only("UC219", SOUND.replace('"elbow"', '""')).severity.value == "error"
    joints = SOUND.replace("<joint", "<joint name=''/><joint")
    assert robot.only("UC219", joints).severity.value == "warning"


def test_an_empty_transmission_name_is_accepted_only_by_hydro(robot: Robot) -> None:
    empty = SOUND.replace('"elbow_trans"', '""')
    finding = robot.only("UC220", empty)
    assert "the transmission of joint 'elbow' has an empty 'name'" in finding.message
    assert finding.fix is not None
    assert finding.fix.title == 'add name="elbow_trans"'
    nameless = empty.replace('"elbow"', '""').replace('"elbow_motor"', '""')
    assert robot.says(nameless, distro="hydro", simulator="none") == []


def test_a_transmission_inside_another_element_is_not_read(robot: Robot) -> None:
    assert "inside <link>" in robot.only("UC221", f"<link name='x'>{SOUND}</link>").message
    inside = f"<ros2_control name='x' type='system'>{SOUND}</ros2_control>"
    assert "UC221" in robot.only("UC221", inside, distro="noetic").code
    assert "UC221" not in {finding.code for finding in robot.lint(inside)}
    settings = (
        "<gazebo><plugin name='p' filename='libp.so'><transmission><type>x</type></transmission></plugin></gazebo>"
    )
    assert robot.says(settings, distro="noetic") == []
    assert robot.says("<gazebo><transmission/></gazebo>", distro="noetic") == []
    control = (
        "<ros2_control name='x' type='system'><transmission name='t'><plugin>p</plugin></transmission></ros2_control>"
    )
    assert "UC221" not in {finding.code for finding in robot.lint(control, distro="noetic")}


def test_parts_that_could_not_be_expanded_are_not_reported_as_missing(robot: Robot) -> None:
    part = """
        <transmission name="elbow_trans">
          <xacro:no_such_macro/>
        </transmission>
    """
    assert {finding.code for finding in robot.lint(part, name="robot.xacro", distro="noetic")} == {"UC008"}
    texts = (
        SOUND.replace("effort", "effort")
        .replace("hardware_interface/EffortJointInterface", "${nothing}")
        .replace(">1<", ">${nothing}<")
    )
    texts = (
        texts.replace("SimpleTransmission", "${nothing}")
        .replace('"elbow"', '"${nothing}"')
        .replace("elbow_motor", "${nothing}")
    )
    assert {finding.code for finding in robot.lint(texts, name="robot.xacro", distro="noetic")} == {"UC006"}


# -- what only real hardware reads -----------------------------------------------------------------------------------


@pytest.mark.parametrize(
    ("reduction", "problem"),
    [
        ("", "is empty"),
        ("abc", "is not a number: 'abc'"),
        ("0.0", "is zero"),
        ("1,5", "is read as 1: '1,5' is not a plain number"),
        ("50rpm", "is read as 50: '50rpm' is not a plain number"),
        ("nan", "is read as nan: 'nan' is not a plain number"),
    ],
)
def test_a_reduction_is_read_as_its_leading_number(robot: Robot, reduction: str, problem: str) -> None:
    written = SOUND.replace(">1<", f">{reduction}<")
    assert robot.only("UC225", written).message.endswith(problem)
    expected = "warning" if "read as" in problem else "error"
    assert robot.says(written, simulator="none") == [f"{expected} UC225"]
    assert robot.says(written, simulator="gazebo-classic") == ["warning UC225"]


@pytest.mark.parametrize("reduction", ["1", "-50", "+.5", "1e2", " 100. "])
def test_a_plain_number_is_a_valid_reduction(robot: Robot, reduction: str) -> None:
    assert robot.says(SOUND.replace(">1<", f">{reduction}<")) == []


def test_the_reduction_of_a_joint_is_read_if_the_type_has_two_joints(robot: Robot) -> None:
    joint = DIFFERENTIAL.replace(
        "<role>joint1</role>", "<role>joint1</role><mechanicalReduction>two</mechanicalReduction>"
    )
    assert "of joint 'shoulder' of transmission 'wrist' is not a number" in robot.only("UC225", joint).message
    alone = SOUND.replace("<hardware", "<mechanicalReduction>two</mechanicalReduction><hardware", 1)
    assert robot.says(alone) == ["warning UC227"]


def test_a_reduction_in_the_wrong_place_is_noted(robot: Robot) -> None:
    reduction = "<mechanicalReduction>1</mechanicalReduction>"
    without = SOUND.replace(reduction, "")
    in_joint = without.replace('<joint name="elbow">', f'<joint name="elbow">{reduction}')
    assert "the one in <joint> does not apply to the actuator" in notes(robot.only("UC212", in_joint))
    beside = without.replace("</transmission>", f"{reduction}</transmission>")
    assert "is outside the actuator" in notes(robot.only("UC212", beside))
    misspelt = SOUND.replace("mechanicalReduction", "mechanical_reduction")
    assert "<mechanical_reduction> is ignored" in notes(robot.only("UC212", misspelt))
    assert notes(robot.only("UC212", without.replace("<actuator", "<note/><actuator"), distro="noetic")) == ""
    assert robot.says(without, simulator="none") == ["error UC212"]
    assert robot.says(without, simulator="gazebo-classic") == ["warning UC212"]


def test_an_offset_is_a_number_in_the_joint(robot: Robot) -> None:
    text = SOUND.replace("<hardware", "<offset>abc</offset><hardware", 1)
    assert robot.says(text, simulator="none") == ["error UC213"]
    assert robot.says(text) == ["warning UC213"]
    empty = robot.only("UC213", SOUND.replace("<hardware", "<offset/><hardware", 1))
    assert empty.message == "<offset> of joint 'elbow' of transmission 'elbow_trans' is empty"
    actuator = SOUND.replace("<mech", "<offset>1</offset><mech")
    assert robot.says(actuator, simulator="none") == ["warning UC213"]


@pytest.mark.parametrize(
    ("role", "problem"),
    [
        ("", "has no <role>; use 'actuator1' or 'actuator2'"),
        ("<role/>", "has an empty <role>; use 'actuator1' or 'actuator2'"),
        ("<role>actuator3</role>", "has unknown role 'actuator3'; use 'actuator1' or 'actuator2'"),
        (
            "<role>actuator1</role>",
            "has the same role 'actuator1' as another actuator; use 'actuator1' and 'actuator2'",
        ),
    ],
)
def test_each_end_has_a_role_of_its_own(robot: Robot, role: str, problem: str) -> None:
    written = DIFFERENTIAL.replace("<role>actuator2</role>", role)
    assert robot.only("UC214", written).message == f"actuator 'right' of transmission 'wrist' {problem}"
    assert robot.says(written, simulator="none") == ["error UC214"]
    assert robot.says(written) == ["warning UC214"]


def test_an_unknown_role_is_not_reported(robot: Robot) -> None:
    unknown = DIFFERENTIAL.replace(">joint1<", ">${nothing}<").replace("<role>joint2</role>", "<xacro:no_such_macro/>")
    assert "UC214" not in {finding.code for finding in robot.lint(unknown, name="robot.xacro", distro="noetic")}


def test_a_wrong_number_of_actuators_is_an_error_on_hardware(robot: Robot) -> None:
    two = SOUND.replace(
        "</transmission>", "<actuator name='m2'><mechanicalReduction>1</mechanicalReduction></actuator></transmission>"
    )
    finding = robot.only("UC215", two, simulator="none")
    assert finding.severity.value == "error"
    assert finding.message == "transmission 'elbow_trans' has 2 actuators; a SimpleTransmission has 1 actuator"
    assert robot.says(two) == ["warning UC215"]


def test_joints_of_one_transmission_have_the_same_interfaces_in_any_order(robot: Robot) -> None:
    position = "<hardwareInterface>hardware_interface/PositionJointInterface</hardwareInterface>"
    other_order = DIFFERENTIAL.replace(f"joint1</role>{EFFORT}", f"joint1</role>{EFFORT}{position}")
    other_order = other_order.replace(f"joint2</role>{EFFORT}", f"joint2</role>{position}{EFFORT}")
    assert robot.says(other_order, simulator="none") == []
    fewer = DIFFERENTIAL.replace(f"joint1</role>{EFFORT}", f"joint1</role>{EFFORT}{position}")
    assert robot.says(fewer, simulator="none") == ["error UC218"]


# -- what Gazebo cannot simulate -------------------------------------------------------------------------------------


def test_a_transmission_of_two_joints_is_an_error_only_in_gazebo(robot: Robot) -> None:
    assert robot.says(DIFFERENTIAL) == []
    assert robot.says(DIFFERENTIAL, simulator="none") == []
    assert robot.says(DIFFERENTIAL, simulator="gazebo-classic") == ["error UC216"]
    assert robot.says(DIFFERENTIAL + PLUGIN) == ["warning UC216"]
    assert robot.says(DIFFERENTIAL + OTHER_SIMULATION, simulator="gazebo-classic") == []


def test_joints_that_the_parser_skips_do_not_count_in_gazebo(robot: Robot) -> None:
    dropped = DIFFERENTIAL.replace(f"joint2</role>{EFFORT}", "joint2</role>")
    assert robot.says(dropped, simulator="gazebo-classic") == ["error UC201"]


# -- mimic joints ----------------------------------------------------------------------------------------------------

FINGER = """
    <link name="finger"><inertial><mass value="1"/>
      <inertia ixx="0.01" ixy="0" ixz="0" iyy="0.01" iyz="0" izz="0.01"/></inertial></link>
    <joint name="tip" type="revolute"><parent link="fore"/><child link="finger"/><axis xyz="0 0 1"/>
      <limit lower="-1" upper="1" effort="10" velocity="2"/><mimic joint="elbow"/></joint>
"""
CONTROLLER = """
states: {type: joint_state_controller/JointStateController, publish_rate: 50}
fingers: {type: effort_controllers/JointGroupEffortController, joints: [%s]}
"""


@pytest.mark.parametrize(
    ("controllers", "expected"),
    [
        (None, ["info UC224"]),
        (CONTROLLER % "elbow", ["warning UC224"]),
    ],
)
def test_a_mimic_joint_in_a_transmission_is_a_warning_if_it_is_known_who_controls_the_robot(
    folder: Folder, controllers: str | None, expected: list[str]
) -> None:
    tip = SOUND.replace("elbow", "tip")
    folder.write({"r.urdf": whole("r.urdf", SOUND + tip + FINGER), "c.yaml": controllers or ""})
    files = ("r.urdf", "c.yaml") if controllers else ("r.urdf",)
    told = folder.run("lint", *files, "--distro", "noetic", "--select", "UC224", "--format", "concise").stdout
    assert [" ".join(line.split()[1:3]) for line in told.splitlines()] == expected


@pytest.mark.parametrize("distro", [None, "indigo", "noetic"])
def test_the_interface_that_a_controller_requires_is_added_safely_in_every_distro(
    distro: str | None, tmp_path: Path
) -> None:
    robot, controllers = tmp_path / "robot.urdf", tmp_path / "controllers.yaml"
    robot.write_text(whole("robot.urdf", SOUND.replace(EFFORT, "")), "utf-8")
    controllers.write_text("arm:\n  type: effort_controllers/JointEffortController\n  joint: elbow\n", "utf-8")
    target = Target(str(robot), controllers=(str(controllers),))
    [finding] = findings(target, ("UC201",), distro=distro, workspace=str(tmp_path))
    assert finding.fix is not None
    assert finding.fix.safe
    prefix = "" if distro == "indigo" else "hardware_interface/"
    assert f"<hardwareInterface>{prefix}EffortJointInterface</hardwareInterface>" in finding.fix.edits[0].text
