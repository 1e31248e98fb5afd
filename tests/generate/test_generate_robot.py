"""Transmissions, `<ros2_control>` tags, simulator plugins, launch files, and packages with all of it."""

from __future__ import annotations

import re
from itertools import product
from pathlib import Path

import pytest
import yaml
from folder import Folder
from generating import JOINTS, ROBOT, command, made, read, roles_of, told
from sampling import sample

from urdfctl.catalog.catalog import CATALOG
from urdfctl.catalog.distros import ALL, ROS1
from urdfctl.errors import UserError
from urdfctl.generate.controllers.recipes import recipes
from urdfctl.generate.options import GeneratorOptions, Roles
from urdfctl.generate.robot.facts import JointFacts, PartFacts, RobotFacts

SIMULATORS = ("gz", "gazebo-classic", "mujoco", "none")
REFUSED = (
    "has no",
    "does not accept",
    "is deprecated",
    "requires",
    "does not simulate",
    "does not support controllers in",
)
EXPECTED = ("UC705", "UC706")
"""What is told of a package for an old distro: later ones lack things."""
FORMS = ("python", "xml", "yaml")


def axis(joint: JointFacts) -> str:
    x, y, z = joint.axis or (1, 0, 0)
    return f'<axis xyz="{x:g} {y:g} {z:g}"/>'


def robot() -> str:
    """The tests' robot as a description: every joint hangs on the root, and every link weighs something."""
    weight = '<inertial><mass value="1"/><inertia ixx="1" ixy="0" ixz="0" iyy="1" iyz="0" izz="1"/></inertial>'
    limit = '<limit lower="-1" upper="1" effort="9" velocity="3"/>'
    joints = [
        f'<link name="{one.name}_link">{weight}</link><joint name="{one.name}" type="{one.type}">'
        f'<parent link="body"/><child link="{one.name}_link"/>{axis(one)}{limit}</joint>'
        for one in JOINTS
    ]
    return f"""<robot name="everything">
      <link name="base_link"/><link name="body">{weight}</link><link name="tool0">{weight}</link>
      <joint name="base" type="fixed"><parent link="base_link"/><child link="body"/></joint>
      <joint name="tool" type="fixed"><parent link="arm_link"/><child link="tool0"/></joint>{"".join(joints)}</robot>"""


def package(options: GeneratorOptions) -> dict[str, str]:
    """The files of gen-all for the tests' robot, the robot's first."""
    found = {f"all/{file.name}": file.text for file in made("gen-all", options)}
    first = "all/urdf/robot.urdf.xacro"
    return {first: found.pop(first), **found, "all/urdf/everything.urdf": robot()}


@pytest.mark.parametrize(("distro", "simulator"), sample(product(ALL, SIMULATORS), 9))
def test_a_package_of_every_kind_of_controller_lints_clean(distro: str, simulator: str, tmp_path: Path) -> None:
    """Every kind in every distro and simulator; of the types' full names each simulator has its share."""
    found: dict[str, list[str]] = {}
    kinds = [kind for kind, plain in recipes()["kinds"].items() if f"ros{1 if distro in ROS1 else 2}" in plain]
    turn = SIMULATORS.index(simulator) + ALL.index(distro)
    for index, name in enumerate([*kinds, *CATALOG.known_types(distro)[turn % 4 :: 4]], turn):
        options = GeneratorOptions(
            distro,
            simulator,
            (name,),
            roles=roles_of(name),
            package="all",
            robot_file="everything.urdf",
            form=FORMS[index % 3],
            namespace="" if index % 2 else "r1",
            macro=index % 5 > 2,
            group=index % 7 > 3,
        )
        try:
            files = package(options)
            assert package(options) == files
        except UserError as error:
            assert any(words in str(error) for words in REFUSED), error  # noqa: PT017
            continue
        found[name] = [one for one in told(tmp_path, files, distro, simulator) if one[:5] not in EXPECTED]
    assert {name: findings for name, findings in found.items() if findings} == {}


@pytest.mark.parametrize("form", ["python", "xml", "yaml"])
@pytest.mark.parametrize("distro", [distro for distro in ALL if distro not in ROS1])
def test_launch_files_start_the_broadcaster_first(distro: str, form: str) -> None:
    for simulator in ("gazebo-classic", "none"):
        options = GeneratorOptions(distro, simulator, ("effort",), package="p", form=form, namespace="r1")
        [file] = made("gen-launch", options)
        assert file.text.index("joint_state_broadcaster") < file.text.index("effort_controller")
        if distro in ("foxy", "galactic"):
            assert "/r1/controller_manager" in file.text
        else:
            assert [line for line in file.text.splitlines() if '"r1"' in line and "namespace of the robot" in line]
        assert ("--param-file" in file.text) == (distro in ("jazzy", "kilted", "lyrical", "rolling"))
        assert ("spawner.py" in file.text) == (distro == "foxy")
        assert made("gen-launch", options) == [file]


@pytest.mark.parametrize(
    ("distro", "interface"), [("indigo", "EffortJointInterface"), ("noetic", "hardware_interface/EffortJointInterface")]
)
def test_transmissions_name_interfaces_as_their_distro_does(distro: str, interface: str) -> None:
    [file] = made("gen-transmissions", GeneratorOptions(distro), (JointFacts("elbow", reduction=50.0),))
    assert f"<hardwareInterface>{interface}</hardwareInterface>" in file.text
    assert "<mechanicalReduction>50.0</mechanicalReduction>" in file.text
    with pytest.raises(UserError, match="use gen-ros2-control"):
        made("gen-transmissions", GeneratorOptions("jazzy"))


def test_a_macro_is_called_for_each_joint(folder: Folder) -> None:
    [file] = made("gen-transmissions", GeneratorOptions("noetic", macro=True), (JointFacts('a"b'), JointFacts("$(x)")))
    assert file.text.count("<xacro:joint_transmission") == 2
    folder.write({"t.xacro": file.text})
    expanded = command("expand", "t.xacro").stdout
    assert expanded.count("hardware_interface/EffortJointInterface") == 2
    assert '<joint name="$(x)">' in expanded


def test_limits_stand_in_the_ros2_control_tag() -> None:
    [file] = made(
        "gen-ros2-control", GeneratorOptions("jazzy", interfaces=("position",), states=("position",)), JOINTS[-1:]
    )
    assert '<param name="min">-1.0</param>' in file.text
    assert "<plugin>mock_components/GenericSystem</plugin>" in file.text
    assert file.text.count("<state_interface") == 1


def test_only_joints_that_are_commanded_have_transmissions_and_by_the_interface_that_is_looked_for() -> None:
    roles = Roles(left=("front_left",), right=("front_right",))
    [file] = made("gen-transmissions", GeneratorOptions("noetic", types=("diff_drive",), roles=roles))
    assert file.text.count("<transmission ") == 2
    assert file.text.count("hardware_interface/VelocityJointInterface") == 2
    [file] = made(
        "gen-transmissions", GeneratorOptions("noetic", types=("pos_vel_controllers/JointTrajectoryController",))
    )
    assert "hardware_interface/PosVelJointInterface" in file.text
    strange = GeneratorOptions("noetic", types=("position_controllers/ScaledJointTrajectoryController",))
    with pytest.raises(
        UserError, match="transmissions do not provide ScaledPositionJointInterface; they provide Effort"
    ):
        made("gen-transmissions", strange)


def test_transmissions_that_the_robot_has_are_not_written_again() -> None:
    robot = ROBOT._replace(interfaces={"arm": ("effort",)})
    files = made("gen-all", GeneratorOptions("noetic", types=("position",), package="all"), JOINTS[-2:], robot)
    control = next(file.text for file in files if file.name == "urdf/control.xacro")
    assert '<joint name="steer_rear_right">' in control
    assert '<joint name="arm">' not in control


def two_arms(transmission: str) -> str:
    """Two arms from a macro; each shoulder has a transmission, which is in the macro too."""
    links = "".join(f'<link name="${{prefix}}{name}"/>' for name in ("upper", "fore"))
    joints = "".join(
        f"""<joint name="${{prefix}}{name}" type="revolute"><parent link="{parent}"/><child link="${{prefix}}{child}"/>
        <axis xyz="0 1 0"/><limit lower="-1" upper="1" effort="50" velocity="2"/></joint>"""
        for name, parent, child in (("shoulder", "base", "upper"), ("elbow", "${prefix}upper", "fore"))
    )
    return f"""<robot name="r" xmlns:xacro="http://www.ros.org/wiki/xacro"><link name="base"/>
        <xacro:macro name="arm" params="prefix">{links}{joints}{transmission}</xacro:macro>
        <xacro:arm prefix="left_"/><xacro:arm prefix="right_"/></robot>"""


IN_MACRO = """<transmission name="${prefix}t"><type>transmission_interface/SimpleTransmission</type>
    <joint name="${prefix}shoulder">
    <hardwareInterface>hardware_interface/EffortJointInterface</hardwareInterface></joint>
    <actuator name="${prefix}m"/></transmission>"""


def test_joints_whose_transmissions_come_from_a_macro_are_left_out(folder: Folder) -> None:
    folder.write({"r.xacro": two_arms(IN_MACRO)})
    made = command("gen-transmissions", "r.xacro", "--type", "trajectory", "--distro", "noetic").stdout
    assert re.findall(r'<joint name="(.*)">', made) == ["left_elbow", "right_elbow"]
    assert made.count("hardware_interface/EffortJointInterface") == 2
    assert command("gen-all", "r.xacro", "--distro", "noetic", "--force", "-o", "made").returncode == 0
    plain = read((folder.path / "made/config/controllers.yaml").read_text())
    assert [one["joints"] for one in plain.values() if "joints" in one] == [
        ["left_shoulder", "left_elbow"],
        ["right_shoulder", "right_elbow"],
    ]
    expanded = command("expand", "made/urdf/robot.urdf.xacro").stdout
    assert len(re.findall("<transmission", expanded)) == 4
    folder.write({"r.xacro": two_arms(IN_MACRO + IN_MACRO.replace("shoulder", "elbow").replace("}t", "}t2"))})
    ran = command("gen-transmissions", "r.xacro", "--distro", "noetic")
    assert (ran.returncode, ran.stderr) == (
        2,
        "urdfctl: the robot already has transmissions for all of these joints; change their <hardwareInterface>\n",
    )


def test_generated_transmissions_are_written_again_although_the_robot_includes_them(folder: Folder) -> None:
    folder.write({"r.xacro": two_arms("").replace("</robot>", '<xacro:include filename="t.xacro"/></robot>')})
    folder.write({"t.xacro": "<robot/>"})
    words = ("gen-transmissions", "r.xacro", "--distro", "noetic", "-o", "t.xacro")
    assert command(*words, "--force").returncode == 0
    assert (folder.path / "t.xacro").read_text().count("<transmission") == 4
    assert command(*words, "--check").returncode == 0


def test_a_controller_of_joints_that_are_not_there_is_refused() -> None:
    options = GeneratorOptions("noetic", types=("franka_gazebo/FrankaGripperSim",))
    with pytest.raises(UserError, match="requires joint 'front_left_finger_joint1', which the robot does not have"):
        made("gen-all", options)
    many = GeneratorOptions("noetic", types=("franka_example_controllers/DualArmCartesianImpedanceExampleController",))
    with pytest.raises(UserError, match="requires more than 9 joints"):
        made("gen-all", many)


@pytest.mark.parametrize(
    ("hardware", "plugin"),
    [("gz", "gz_ros2_control/GazeboSimSystem"), ("mujoco", "mujoco_ros2_control/Mujoco"), ("my/Robot", "my/Robot")],
)
def test_hardware_has_short_names(hardware: str, plugin: str) -> None:
    assert f"<plugin>{plugin}" in made("gen-ros2-control", GeneratorOptions("jazzy", hardware=hardware))[0].text


def test_hardware_that_the_distro_does_not_have_is_told() -> None:
    with pytest.raises(UserError, match="jazzy has no plugin that runs controllers in 'gazebo-classic'"):
        made("gen-ros2-control", GeneratorOptions("jazzy", hardware="gazebo-classic"))
    with pytest.raises(UserError, match="unknown hardware 'mok'; did you mean 'mock'"):
        made("gen-ros2-control", GeneratorOptions("jazzy", hardware="mok"))


def test_nothing_is_written_twice_that_the_robot_has() -> None:
    parts = tuple(PartFacts("joint", joint.name, ("effort",), ("position",)) for joint in JOINTS)
    has = ROBOT._replace(components=("RobotSystem",), hosts=("gz_ros2_control-system",), parts=parts)
    files = {
        file.name: file.text
        for file in made("gen-all", GeneratorOptions("jazzy", "gz", ("effort",), package="all"), robot=has)
    }
    assert "urdf/control.xacro" not in files
    assert "control.xacro" not in files["urdf/robot.urdf.xacro"]
    with pytest.raises(UserError, match="<ros2_control> already has all of these joints"):
        made("gen-ros2-control", GeneratorOptions("jazzy"), robot=has)


def test_a_ros2_control_tag_is_extended_by_what_it_lacks() -> None:
    parts = tuple(PartFacts("joint", joint.name, ("effort",), ("position",)) for joint in JOINTS[:-1])
    has = ROBOT._replace(components=("RobotSystem",), parts=parts)
    [file] = made("gen-ros2-control", GeneratorOptions("jazzy", types=("effort",)), robot=has)
    assert file.text.count("<joint ") == 1
    assert '<joint name="arm">' in file.text
    assert '<ros2_control name="RobotSystem2"' in file.text


REFUSALS = {
    ("jazzy", "diff_drive"): """'diff_drive_controller' (diff_drive_controller/DiffDriveController) commands
        'velocity' of joint 'front_left', which has only 'position' in <ros2_control>: choose a type that commands
        position, or add <command_interface name="velocity"/> to the joint""",
    ("noetic", "diff_drive"): """'diff_drive_controller' (diff_drive_controller/DiffDriveController) commands
        'velocity' of joint 'front_left', whose transmission has 'position': choose a type that commands position,
        or change its <hardwareInterface> to hardware_interface/VelocityJointInterface""",
    ("jazzy", "effort"): """'effort_controller' (forward_command_controller/ForwardCommandController) commands
        'effort' of joint 'front_left', which has only 'position' in <ros2_control>: choose a type that commands
        position, or add <command_interface name="effort"/> to the joint""",
}


@pytest.mark.parametrize(("distro", "kind"), REFUSALS)
def test_a_controller_of_another_interface_than_the_robot_has_is_refused(distro: str, kind: str) -> None:
    parts = tuple(PartFacts("joint", joint.name, ("position",), ("position", "velocity")) for joint in JOINTS)
    has = ROBOT._replace(parts=parts, interfaces={joint.name: ("position",) for joint in JOINTS})
    for command_name in ("gen-controllers", "gen-launch", "gen-all"):
        with pytest.raises(UserError) as caught:
            made(command_name, GeneratorOptions(distro, types=(kind,), package="all"), robot=has)
        assert str(caught.value) == " ".join(REFUSALS[distro, kind].split())
    if kind == "effort":
        with pytest.raises(UserError, match="use --interface position, or add"):
            made("gen-controllers", GeneratorOptions(distro, types=("trajectory",), interfaces=("effort",)), robot=has)


@pytest.mark.parametrize(("distro", "parameters"), [("jazzy", 0), ("humble", 2)])
def test_a_mimic_joint_has_states_only_and_up_to_iron_parameters(distro: str, parameters: int) -> None:
    finger = JointFacts("finger", "prismatic", lower=0, upper=0.1)
    other = JointFacts("other", "prismatic", mimics=True, mimic=("finger", -1.0, 0.0))
    robot = RobotFacts("hand", joints=(finger, other))
    [file] = made("gen-ros2-control", GeneratorOptions(distro, "gz", ("gripper",)), (finger,), robot)
    block = file.text.partition('<joint name="other">')[2].partition("</joint>")[0]
    assert "<command_interface" not in block
    assert block.count("<state_interface") == 2
    assert block.count("<param") == parameters


def test_a_block_is_inserted_and_every_other_byte_stays(folder: Folder) -> None:
    before = b"<robot name='r'  >\r\n\t<link name='a'/>\r\n</robot>\r\n<!-- </robot> -->\r\n"
    folder.write({"robot.xacro": before})
    words = (
        "gen-gazebo",
        "robot.xacro",
        "--distro",
        "jazzy",
        "--simulator",
        "gz",
        "--package",
        "p",
        "--into",
        "robot.xacro",
    )
    assert command(*words).returncode == 0
    after = (folder.path / "robot.xacro").read_bytes()
    start = after.index(b"\r\n  <!-- made by urdfctl gen-gazebo")
    end = after.index(b"</robot>")
    assert after[:start] + after[end:] == before
    assert b"\n" not in after.replace(b"\r\n", b"")


def test_everything_is_written_and_can_be_checked_again(folder: Folder) -> None:
    folder.write({"everything.urdf": robot()})
    words = (
        "gen-all",
        "everything.urdf",
        "--type",
        "trajectory",
        "--distro",
        "jazzy",
        "--simulator",
        "gz",
        "-o",
        "out",
    )
    assert command(*words).returncode == 0
    assert command(*words, "--check").returncode == 0
    assert command("lint", "out", "--distro", "jazzy").returncode == 0
    files = [path for path in (folder.path / "out").rglob("*") if path.is_file()]
    texts = [path.read_text() for path in files if path.name != "everything.urdf"]
    assert len(texts) == 8
    moveit = yaml.safe_load((folder.path / "out/config/moveit_controllers.yaml").read_text())
    assert moveit["moveit_simple_controller_manager"]["controller_names"] == ["joint_trajectory_controller"]
    assert all("made by urdfctl gen-all everything.urdf" in text for text in texts)
    made_by = (folder.path / "out/urdf/control.xacro").read_text().splitlines()[1]
    again = made_by.removeprefix("<!-- made by urdfctl ").removesuffix(" -->").split()
    assert command(*again, "-o", "out", "--check").returncode == 0


def test_every_host_of_the_catalogue_is_written() -> None:
    for distro in ALL:
        for simulator in {one.simulator for one in CATALOG.simulator_plugins(distro) if one.hosts_control}:
            [file] = made("gen-gazebo", GeneratorOptions(distro, simulator, package="p"))
            assert "<plugin" in file.text


def test_what_the_robot_is_given_is_passed_on(folder: Folder, tmp_path: Path) -> None:
    folder.write(
        {
            "package.xml": "<package format='3'><name>p</name></package>",
            "urdf/r.xacro": """<robot name="r" xmlns:xacro="http://www.ros.org/wiki/xacro">
              <xacro:arg name="side" default="left"/><link name="a"/><link name="b"/>
              <joint name="$(arg side)_joint" type="continuous"><parent link="a"/><child link="b"/></joint></robot>""",
        }
    )
    words = ("--type", "velocity", "--distro", "jazzy")
    assert command("gen-all", "urdf/r.xacro", "side:=right one", *words, "-o", "q").returncode == 0
    expanded = command("expand", "q/urdf/robot.urdf.xacro", "--package-path", ".").stdout
    assert expanded.count('<joint name="right one_joint"') == 2
    launch = command("gen-launch", "urdf/r.xacro", "side:=right", *words).stdout
    assert 'DeclareLaunchArgument("side", default_value="right")' in launch
    assert """" side:='",\n            LaunchConfiguration("side"),\n            "'",""" in launch
    for form, default in (("xml", 'default="right"'), ("yaml", 'default: "right"')):
        launch = command("gen-launch", "urdf/r.xacro", "side:=right", *words, "--form", form).stdout
        assert "urdf/r.xacro side:=$(var side)' 'warn')" in launch
        assert default in launch
    launch = command("gen-launch", "urdf/r.xacro", "--type", "velocity", "--distro", "noetic").stdout
    assert '<arg name="side" default="left"/>' in launch
    assert "urdf/r.xacro' side:=$(arg side)" in launch
    refused = command("gen-launch", "urdf/r.xacro", "side:=right one", *words, "--form", "xml")
    assert "cannot pass 'side:=right one'; use --form python" in refused.stderr


def test_a_robot_in_no_package_is_copied_unless_it_includes_files(folder: Folder) -> None:
    include = '<robot xmlns:xacro="http://www.ros.org/wiki/xacro"><xacro:include filename="everything.urdf"/></robot>'
    folder.write({"everything.urdf": robot(), "outer.xacro": include})
    words = ("--type", "velocity", "--distro", "jazzy", "--joint", "arm")
    assert command("gen-all", "everything.urdf", *words, "-o", "out").returncode == 0
    assert (folder.path / "out/urdf/everything.urdf").read_text() == robot()
    ran = command("gen-all", "outer.xacro", *words, "-o", "other")
    assert "'outer.xacro' is not in a package, so installed files cannot find it" in ran.stderr


@pytest.mark.parametrize("distro", sample(ALL, 5))
def test_a_package_smokes_clean(distro: str, folder: Folder) -> None:
    folder.write({"everything.urdf": robot(), "package.xml": "<package format='3'><name>here</name></package>"})
    words = ("everything.urdf", "--type", "position", "--joint", "arm,steer_left", "--distro", distro)
    assert command("gen-all", *words, "-o", "made").returncode == 0
    ran = command("smoke", "made", "--distro", distro, "--engine", "none")
    assert (ran.returncode, ran.stderr) == (0, "")
    assert ran.stdout.count("> activate ") == (3 if distro in ROS1 else 2)


def test_an_admittance_ends_at_what_the_last_joint_moves() -> None:
    joints = (JOINTS[-1]._replace(link="hand"),)
    [file] = made("gen-controllers", GeneratorOptions("jazzy", types=("admittance",)), joints)
    last = "last link of the kinematic chain: the tool"
    assert f"tip: hand  # {last}; TODO: check it; this is the last joint's link" in file.text
    [file] = made("gen-controllers", GeneratorOptions("jazzy", types=("admittance",), frame="tool"), joints)
    assert f"tip: tool  # {last}\n" in file.text
