"""Controller files: of every type in every distro, for joints with any name, from any list."""

from __future__ import annotations

import sys
from pathlib import Path

import pytest
from folder import Folder
from generating import JOINTS, ROBOT, TEMPLATES, command, made, read, roles_of, told
from hypothesis import given, settings
from hypothesis import strategies as st
from sampling import examples, sample

from urdfctl.catalog.catalog import CATALOG
from urdfctl.catalog.distros import ALL
from urdfctl.errors import UserError
from urdfctl.generate.controllers.recipes import recipes
from urdfctl.generate.controllers.values import NAMES
from urdfctl.generate.options import GeneratorOptions, Roles
from urdfctl.generate.request.choice import chosen
from urdfctl.generate.request.joint_list import joints_listed
from urdfctl.generate.robot.facts import JointFacts, PartFacts, RobotFacts

ARM = """<robot name="arm">
  <link name="base"/>
  <link name="upper"><inertial><mass value="1"/><origin xyz="0.5 0 0"/>
    <inertia ixx="0.01" ixy="0" ixz="0" iyy="0.01" iyz="0" izz="0.01"/></inertial></link>
  <link name="fore"/>
  <joint name="shoulder" type="revolute"><parent link="base"/><child link="upper"/><axis xyz="0 0 1"/>
    <limit lower="-1" upper="1" effort="40" velocity="2"/></joint>
  <joint name="elbow" type="revolute"><parent link="upper"/><child link="fore"/><axis xyz="0 0 1"/>
    <limit lower="-1" upper="1" effort="10" velocity="2"/></joint>
  <joint name="mimicking" type="revolute"><parent link="base"/><child link="third"/><mimic joint="elbow"/>
    <limit lower="-1" upper="1" effort="10" velocity="2"/></joint>
  <link name="third"/>
</robot>
"""
ROVER = """<robot name="rover"><link name="base_link"/>
  <link name="left"><collision><geometry><cylinder radius="0.1" length="0.02"/></geometry></collision></link>
  <link name="right"><visual><geometry><cylinder radius="0.1" length="0.02"/></geometry></visual></link>
  <joint name="left_joint" type="continuous"><parent link="base_link"/><child link="left"/>
    <origin xyz="0 0.25 0" rpy="-1.5707963 0 0"/><axis xyz="0 0 1"/><limit effort="5" velocity="10"/></joint>
  <joint name="right_joint" type="continuous"><parent link="base_link"/><child link="right"/>
    <origin xyz="0 -0.25 0" rpy="-1.5707963 0 0"/><axis xyz="0 0 1"/><limit effort="5" velocity="10"/></joint>
</robot>
"""


def of_types(distro: str) -> list[str]:
    kinds = [name for name, plain in recipes()["kinds"].items() if f"ros{1 if distro in ALL[:7] else 2}" in plain]
    return [*CATALOG.known_types(distro), *kinds]


@pytest.mark.parametrize("distro", sample(ALL, 5))
def test_every_type_of_controller_is_written_so_that_lint_finds_nothing_and_twice_the_same(
    distro: str, tmp_path: Path
) -> None:
    found = {}
    written = 0
    for name in of_types(distro):
        options = GeneratorOptions(distro, types=(name,), roles=roles_of(name))
        try:
            [file] = made("gen-controllers", options)
        except UserError as error:
            assert any(words in str(error) for words in (f"{distro} has no '", "is deprecated", "requires "))  # noqa: PT017
            continue
        written += 1
        found[name] = told(tmp_path, {"controllers.yaml": file.text}, distro)
        assert made("gen-controllers", options) == [file]
    assert {name: findings for name, findings in found.items() if findings} == {}
    assert written > 20


def test_a_type_that_is_deprecated_in_the_distro_is_not_written() -> None:
    with pytest.raises(UserError, match="use 'parallel_gripper_action_controller/GripperActionController'"):
        made("gen-controllers", GeneratorOptions("jazzy", types=("position_controllers/GripperActionController",)))
    [file] = made("gen-controllers", GeneratorOptions("humble", types=("gripper",)), JOINTS[:1])
    assert "position_controllers/GripperActionController" in file.text


@pytest.mark.parametrize("distro", ["kilted", "lyrical"])
def test_a_group_controller_is_written_where_the_distro_has_it(distro: str) -> None:
    options = GeneratorOptions(distro, types=("effort",), group=True)
    if distro == "lyrical":
        with pytest.raises(UserError, match="lyrical has no 'effort_controllers/JointGroupEffortController'"):
            made("gen-controllers", options)
    else:
        assert "type: effort_controllers/JointGroupEffortController" in made("gen-controllers", options)[0].text


TRAPS = ["on", "1e3", "~", "null", "a b", "it's", 'say "x"', "größe", "a: b", "# no", "0x10", "yes", "-", "{}", "1_000"]


@pytest.mark.parametrize("distro", ["noetic", "jazzy"])
@pytest.mark.parametrize("name", TRAPS)
def test_a_joint_keeps_its_name_whatever_yaml_would_make_of_it(name: str, distro: str) -> None:
    [file] = made("gen-controllers", GeneratorOptions(distro, types=("trajectory",)), (JointFacts(name),), RobotFacts())
    plain = read(file.text)["joint_trajectory_controller"]
    assert plain.get("ros__parameters", plain)["joints"] == [name]


@settings(max_examples=examples(20))
@given(st.lists(st.text(st.characters(exclude_categories=("Cs",)), min_size=1), min_size=1, max_size=20, unique=True))
def test_any_names_come_back_in_their_order(names: list[str]) -> None:
    joints = tuple(JointFacts(name) for name in names)
    [file] = made("gen-controllers", GeneratorOptions("jazzy", types=("effort",)), joints, RobotFacts())
    assert read(file.text)["effort_controller"]["ros__parameters"]["joints"] == names
    [file] = made("gen-controllers", GeneratorOptions("noetic", types=("effort",)), joints, RobotFacts())
    plain = read(file.text)
    assert [one["joint"] for name, one in plain.items() if name != "joint_state_controller"] == names


@pytest.mark.parametrize("count", [1, 2, 50, 200])
def test_each_joint_has_its_gains(count: int) -> None:
    joints = tuple(JointFacts(f"joint_{number}", effort=5.0) for number in range(count))
    options = GeneratorOptions("jazzy", types=("trajectory",), interfaces=("effort",))
    [file] = made("gen-controllers", options, joints, RobotFacts())
    assert len(read(file.text)["joint_trajectory_controller"]["ros__parameters"]["gains"]) == count


def test_the_robots_joints_are_those_that_move_and_mimic_no_other(folder: Folder) -> None:
    folder.write({"robot.urdf": ARM})
    done = command("gen-controllers", "--type", "effort", "--distro", "jazzy")
    assert read(done.stdout)["effort_controller"]["ros__parameters"]["joints"] == ["shoulder", "elbow"]
    assert done.stdout.startswith("# made by urdfctl gen-controllers robot.urdf --type effort --distro jazzy\n")


def test_joints_are_chosen_by_regular_expressions(folder: Folder) -> None:
    folder.write({"robot.urdf": ARM})
    done = command("gen-controllers", "robot.urdf", "--type", "effort", "--distro", "noetic", "--exclude", "s.*")
    assert [one.get("joint") for one in read(done.stdout).values()] == [None, "elbow"]
    wrong = command("gen-controllers", "robot.urdf", "--type", "effort", "--joints", "elbo")
    assert (wrong.returncode, wrong.stdout) == (2, "")
    assert "no joint matches 'elbo'; did you mean 'elbow'?" in wrong.stderr


def test_a_joint_that_the_robot_does_not_have_is_told(folder: Folder) -> None:
    folder.write({"robot.urdf": ARM})
    done = command("gen-controllers", "robot.urdf", "--joint", "elbwo", "--type", "effort", "--distro", "jazzy")
    assert (done.returncode, done.stdout) == (2, "")
    assert done.stderr == "urdfctl: the robot has no joint 'elbwo'; did you mean 'elbow'?\n"


def test_gains_begin_with_the_inertia_that_a_joint_moves(folder: Folder) -> None:
    folder.write({"robot.urdf": ARM})
    done = command("gen-controllers", "--type", "position", "--interface", "effort", "--distro", "noetic")
    gains = read(done.stdout)["shoulder_position_controller"]["pid"]
    assert gains == {"p": 41.1, "i": 0.0, "d": 6.53}  # 0.01 + 1 kg at 0.5 m = 0.26 kg m2, at 2 Hz
    assert "starting values, to be tuned, from the load of 0.26 kg m2" in done.stdout
    assert read(done.stdout)["elbow_position_controller"]["pid"]["p"] == 50.0
    assert "from the effort limit" in done.stdout


def test_a_drive_is_measured(folder: Folder) -> None:
    folder.write({"robot.urdf": ROVER})
    done = command("gen-controllers", "--type", "diff_drive", "--distro", "jazzy")
    drive = read(done.stdout)["diff_drive_controller"]["ros__parameters"]
    assert (drive["left_wheel_names"], drive["right_wheel_names"]) == (["left_joint"], ["right_joint"])
    assert (drive["wheel_separation"], drive["wheel_radius"]) == (0.5, 0.1)
    assert drive["linear"]["x"]["max_velocity"] == 1.0
    assert "m, measured from the wheels" in done.stdout


def test_what_cannot_be_measured_is_a_todo() -> None:
    options = GeneratorOptions("jazzy", types=("diff_drive",), roles=Roles(left=("l",), right=("r",)))
    [file] = made("gen-controllers", options, (JointFacts("l"), JointFacts("r")), RobotFacts())
    assert "wheel_separation: 0.5  # m between left and right wheels, TODO: measure it" in file.text
    assert "Fill in each TODO." in file.text.splitlines()[1]


def test_lint_finds_what_waits_to_be_set(folder: Folder) -> None:
    words = ("gen-controllers", "--type", "diff_drive", "--joint", "l,r", "--left", "l", "--right", "r")
    assert command(*words, "--distro", "jazzy", "-o", "c.yaml").returncode == 0
    found = [line for line in command("lint", "c.yaml", "--format", "concise").stdout.splitlines() if "UC449" in line]
    [message] = [line.rpartition(" UC449 ")[2] for line in found]
    assert message.startswith("'wheel_separation' of controller 'diff_drive_controller' is still a placeholder")
    assert "(also 'wheel_radius' (line 22))" in message


def test_a_drive_whose_wheels_nobody_knows_is_told() -> None:
    with pytest.raises(
        UserError, match=r"requires --left with joints; cannot be determined from the robot; choose from: a$"
    ):
        made("gen-controllers", GeneratorOptions("jazzy", types=("diff_drive",)), (JointFacts("a"),), RobotFacts())
    with pytest.raises(UserError, match="'bicycle' requires --traction with 1 joint; 4 given"):
        made("gen-controllers", GeneratorOptions("jazzy", types=("bicycle",)))


@pytest.mark.parametrize(
    ("names", "left"),
    [
        (("left_wheel", "right_wheel"), ["left_wheel"]),
        (("wheelFL", "wheelFR", "wheelRL", "wheelRR"), ["wheelFL", "wheelRL"]),
        (("left_right_wheel", "right_wheel"), None),
        (("left_wheel", "left_arm", "right_wheel"), None),
    ],
)
def test_without_positions_the_names_of_wheels_say_their_sides(names: tuple[str, ...], left: list[str] | None) -> None:
    listed = tuple(JointFacts(name) for name in names)
    options = GeneratorOptions("jazzy", types=("diff_drive",))
    if left is None:
        with pytest.raises(UserError, match="requires --left"):
            made("gen-controllers", options, listed, RobotFacts())
        return
    [file] = made("gen-controllers", options, listed, RobotFacts())
    assert read(file.text)["diff_drive_controller"]["ros__parameters"]["left_wheel_names"] == left


def test_drives_leave_their_joints_to_no_other_controller() -> None:
    [file] = made("gen-controllers", GeneratorOptions("jazzy", types=("trajectory", "diff_drive")))
    plain = read(file.text)
    assert list(plain) == ["controller_manager", "joint_trajectory_controller", "diff_drive_controller"]
    assert plain["joint_trajectory_controller"]["ros__parameters"]["joints"][-1] == "arm"


def test_the_interfaces_that_a_robot_has_are_taken() -> None:
    robot = ROBOT._replace(interfaces={"arm": ("effort",)})
    [file] = made("gen-controllers", GeneratorOptions("noetic", types=("position",)), JOINTS[-1:], robot)
    assert read(file.text)["arm_position_controller"]["type"] == "effort_controllers/JointPositionController"


@pytest.mark.parametrize(
    ("distro", "key"),
    [("jazzy", "/**/effort_controller:"), ("galactic", "/r1/effort_controller:"), ("noetic", "arm_effort_controller:")],
)
def test_a_file_is_for_any_namespace_if_the_distro_can_read_it(distro: str, key: str, tmp_path: Path) -> None:
    [file] = made("gen-controllers", GeneratorOptions(distro, types=("effort",), namespace="r1"))
    assert f"\n{key}" in file.text.replace('"', "")
    assert "/r1" in file.text.splitlines()[2]  # the command that starts them
    assert told(tmp_path, {"controllers.yaml": file.text}, distro) == []


LISTS = {
    "joints.txt": "elbow\n# the next one\nwrist\n",
    "joints.csv": "name,interface,effort,p\nelbow,effort,5,2.5\nwrist,,,\n",
    "plain.csv": "elbow, wrist\n",
    "joints.yaml": "- {name: elbow, interface: effort, gains: {p: 2.5}, limits: {effort: 5}}\n- wrist\n",
    "map.yaml": "joints:\n  elbow: {reduction: 50}\n  wrist:\n",
}


@pytest.mark.parametrize("source", LISTS)
def test_joints_are_read_from_lists(source: str) -> None:
    elbow, wrist = joints_listed(LISTS[source], source)
    assert (elbow.name, wrist) == ("elbow", JointFacts("wrist"))
    if source in ("joints.csv", "joints.yaml"):
        assert (elbow.interface, elbow.effort, elbow.gains) == ("effort", 5.0, (("p", 2.5),))


@pytest.mark.parametrize(
    ("text", "message"),
    [
        ("- {name: a, efort: 3}", "list.yaml: unknown key 'efort'; did you mean 'effort'?"),
        ("- on", "list.yaml: 'True' is not a joint name"),
        ("- {name: a, effort: much}", "list.yaml: 'effort' must be a number, not 'much'"),
        ("- {effort: 3}", "list.yaml: a joint without a name"),
        ("3", "list.yaml: not a list of joints"),
        ("[", "list.yaml: not valid YAML"),
    ],
)
def test_a_list_that_is_none_is_told(text: str, message: str) -> None:
    with pytest.raises(UserError, match=message.replace("?", "\\?")):
        joints_listed(text, "list.yaml")


@pytest.mark.parametrize(
    "text", ["[" * 2000 + "]" * 2000, "- " * 2000 + "a", "? " * 2000 + "a", "{a: " * 999 + "}" * 999]
)
def test_a_list_that_is_nested_too_deep_is_told(text: str) -> None:
    sys.setrecursionlimit(max(sys.getrecursionlimit(), 5000))  # as xacro's expansion does
    with pytest.raises(UserError, match=r"^list.yaml: the YAML file is nested more than 64 deep"):
        joints_listed(text, "list.yaml")


def test_a_list_goes_over_what_the_robot_says() -> None:
    [arm] = chosen(ROBOT, joints_listed("- {name: arm, effort: 3, interface: effort}", "list.yaml"))
    assert (arm.effort, arm.interface, arm.inertia) == (3.0, "effort", 0.2)


def test_a_list_comes_from_standard_input(folder: Folder) -> None:
    done = command("gen-controllers", "-", "--type", "velocity", "--distro", "jazzy", text="a\nb\n")
    assert read(done.stdout)["velocity_controller"]["ros__parameters"] == {
        "joints": ["a", "b"],
        "interface_name": "velocity",
    }


def test_a_file_is_written_checked_and_not_overwritten(folder: Folder) -> None:
    words = ("gen-controllers", "--joint", "a", "--type", "effort", "--distro", "jazzy", "-o", "c.yaml")
    assert command(*words, "--check").stdout == "c.yaml is out of date\n"
    assert command(*words).returncode == 0
    assert command(*words, "--check").returncode == 0
    before = (folder.path / "c.yaml").read_bytes()
    (folder.path / "c.yaml").write_bytes(before + b"mine: 1\n")
    assert command(*words, "--check").returncode == 1
    assert "-mine: 1" in command(*words, "--diff").stdout
    refused = command(*words)
    assert (refused.returncode, refused.stderr) == (
        2,
        "urdfctl: 'c.yaml' exists; --force overwrites it, --diff shows what would change\n",
    )
    assert command(*words, "--force").returncode == 0
    assert (folder.path / "c.yaml").read_bytes() == before


def test_a_robot_that_cannot_be_read_is_told_with_its_place(folder: Folder) -> None:
    folder.write({"robot.urdf": '<robot name="x"><link></robot>'})
    done = command("gen-controllers", "robot.urdf", "--type", "effort")
    assert (done.returncode, done.stdout) == (1, "")
    assert "robot.urdf:1:" in done.stderr


def test_a_template_of_the_users_comes_before_the_own(folder: Folder) -> None:
    folder.write(
        {"mine/controllers/ros2.yaml.j2": "# {{ command }}\nx: 1\n", "bad/controllers/ros2.yaml.j2": "{{ no }}"}
    )
    words = ("gen-controllers", "--joint", "a", "--type", "effort", "--distro", "jazzy", "--templates")
    assert command(*words, "mine").stdout.endswith("x: 1\n")
    assert command(*words, "bad").stderr == "urdfctl: template 'controllers/ros2.yaml.j2': 'no' is undefined\n"
    assert "controllers/ros2.yaml.j2\n" in command("gen-controllers", "--list-templates").stdout


@pytest.mark.parametrize(
    ("text", "told"),
    [
        (b"\xff", "'utf-8' codec can't decode byte 0xff in position 0: invalid start byte"),
        (b"{{ 1 / 0 }}", "division by zero"),
        (b"{{ 1 + 'a' }}", "unsupported operand type(s) for +: 'int' and 'str'"),
        (b"{{ 'a' * 99999999999999 }}", "MemoryError"),
    ],
)
def test_what_a_template_of_the_users_cannot_do_is_told_in_a_line(folder: Folder, text: bytes, told: str) -> None:
    folder.write({"mine/controllers/ros2.yaml.j2": text})
    ran = command("gen-controllers", "--joint", "a", "--type", "effort", "--distro", "jazzy", "--templates", "mine")
    assert (ran.returncode, ran.stderr) == (2, f"urdfctl: template 'controllers/ros2.yaml.j2': {told}\n")


def test_what_our_own_templates_cannot_do_is_our_own_fault() -> None:
    with pytest.raises(TypeError):
        TEMPLATES.render(
            "controllers/ros2.yaml",
            command="",
            title="",
            distro="",
            todos=(),
            start="",
            manager="m",
            movable=True,
            rate=1,
            simulated=False,
            controllers=1,
        )


def test_the_recipes_speak_of_what_there_is() -> None:
    plain = recipes()
    entries = [
        entry
        for one in (*plain["parameters"].values(), *plain["groups"].values())
        for name, entry in one.items()
        if name != "also"
    ]
    names = [
        part[1:]
        for value, _ in entries
        for part in (value if isinstance(value, list) else [value])
        if str(part).startswith("$")
    ]
    assert set(names) <= NAMES
    for name, recipe in plain["parameters"].items():
        known = {p for distro in ALL if (one := CATALOG.controller(name, distro)) for p in one.parameters}
        assert any(parameter in known for parameter in recipe if parameter != "also") or "also" in recipe, name


def test_a_full_name_takes_the_interfaces_that_the_robot_has() -> None:
    robot = ROBOT._replace(interfaces={"arm": ("velocity",)})
    for name in ("forward_command_controller/ForwardCommandController", "joint_trajectory_controller/"):
        full = name + "JointTrajectoryController" if name.endswith("/") else name
        [file] = made("gen-controllers", GeneratorOptions("jazzy", types=(full,)), JOINTS[-1:], robot)
        of_arm = read(file.text)[full.partition("/")[0]]["ros__parameters"]
        assert of_arm.get("interface_name", *of_arm.get("command_interfaces", ())) == "velocity"


def test_a_chain_ends_at_the_hardware_and_starts_there() -> None:
    options = GeneratorOptions("jazzy", types=("trajectory", "pid"), chain=True, states=("position", "velocity"))
    [file] = made("gen-controllers", options, JOINTS[-1:])
    plain = read(file.text)
    assert list(plain) == ["controller_manager", "pid_controller", "joint_trajectory_controller"]
    above = plain["joint_trajectory_controller"]["ros__parameters"]
    assert (above["joints"], above["command_joints"]) == (["arm"], ["pid_controller/arm"])
    assert above["command_interfaces"] == ["position", "velocity"]


def test_a_chain_of_a_drive_asks_for_speeds() -> None:
    options = GeneratorOptions("jazzy", types=("diff_drive", "pid"), chain=True, interfaces=("effort",))
    [file] = made("gen-controllers", options)
    plain = read(file.text)
    assert plain["pid_controller"]["ros__parameters"]["reference_and_state_interfaces"] == ["velocity"]
    drive = plain["diff_drive_controller"]["ros__parameters"]
    assert drive["left_wheel_names"] == ["pid_controller/front_left", "pid_controller/rear_left"]
    assert drive["position_feedback"] is False


@pytest.mark.parametrize(
    ("distro", "types", "message"),
    [
        ("foxy", ("trajectory", "effort"), "foxy does not support chained controllers; they require humble or later"),
        (
            "jazzy",
            ("trajectory", "effort"),
            "'joint_trajectory_controller' commands 'effort_controller/arm/position', but",
        ),
        ("jazzy", ("trajectory", "gripper"), "'gripper' needs several controllers for these joints"),
        ("jazzy", ("multi_interface", "nothing"), "unknown type 'nothing'"),
    ],
)
def test_what_cannot_stand_in_a_chain_is_told(distro: str, types: tuple[str, ...], message: str) -> None:
    with pytest.raises(UserError, match=message):
        made("gen-controllers", GeneratorOptions(distro, types=types, chain=True), JOINTS[-1:])


def test_one_interface_too_many_is_told() -> None:
    with pytest.raises(UserError, match="'effort' commands one interface per joint, not effort, velocity"):
        made("gen-controllers", GeneratorOptions("jazzy", types=("effort",), interfaces=("effort", "velocity")))
    with pytest.raises(UserError, match="no 'trajectory' controller commands 'torque' in jazzy; choose from: position"):
        made("gen-controllers", GeneratorOptions("jazzy", types=("trajectory",), interfaces=("torque",)))


def test_a_sensor_is_chosen_by_what_it_measures() -> None:
    parts = (PartFacts("sensor", "eye", (), ("range",)), PartFacts("sensor", "foot", (), ("force.x",)))
    robot = ROBOT._replace(parts=parts)
    [file] = made("gen-controllers", GeneratorOptions("jazzy", types=("range_broadcaster",)), JOINTS, robot)
    assert read(file.text)["range_sensor_broadcaster"]["ros__parameters"]["sensor_name"] == "eye"
    [file] = made("gen-controllers", GeneratorOptions("jazzy", types=("imu_broadcaster",)), JOINTS, robot)
    assert "sensor_name: imu_sensor  # name of the <sensor> in the ros2_control tag; TODO: set its name" in file.text


def test_no_more_states_are_read_than_the_robot_offers() -> None:
    robot = ROBOT._replace(parts=(PartFacts("joint", "arm", ("position",), ("position",)),))
    [file] = made("gen-controllers", GeneratorOptions("jazzy", types=("trajectory",)), JOINTS[-1:], robot)
    assert "state_interfaces: [position]" in file.text
    options = GeneratorOptions("jazzy", types=("trajectory",), interfaces=("effort",), states=("velocity",))
    with pytest.raises(UserError, match="'joint_trajectory_controller/JointTrajectoryController': 'state_interfaces'"):
        made("gen-controllers", options, JOINTS[-1:], robot)


def test_the_gpios_of_a_robot_are_commanded() -> None:
    robot = ROBOT._replace(parts=(PartFacts("gpio", "flange", ("light",), ("light", "key")),))
    [file] = made("gen-controllers", GeneratorOptions("jazzy", types=("gpio",)), JOINTS, robot)
    assert read(file.text)["gpio_controller"]["ros__parameters"] == {
        "gpios": ["flange"],
        "command_interfaces": {"flange": {"interfaces": ["light"]}},
        "state_interfaces": {"flange": {"interfaces": ["light", "key"]}},
    }
    [file] = made("gen-controllers", GeneratorOptions("jazzy", types=("gpio",)))
    assert "interfaces: [output]  # command interfaces; TODO: set its interfaces" in file.text


def test_a_joint_whose_limits_hold_it_fast_is_left_out_and_told(folder: Folder) -> None:
    folder.write({"robot.urdf": ARM.replace('lower="-1" upper="1" effort="40"', 'lower="0" upper="0" effort="40"')})
    ran = command("gen-controllers", "robot.urdf", "--type", "effort", "--distro", "jazzy")
    assert read(ran.stdout)["effort_controller"]["ros__parameters"]["joints"] == ["elbow"]
    assert ran.stderr == "urdfctl: left out because their limits allow no motion: shoulder. Include them with --joint\n"
    ran = command("gen-controllers", "robot.urdf", "--type", "effort", "--distro", "jazzy", "--joint", "shoulder")
    assert read(ran.stdout)["effort_controller"]["ros__parameters"]["joints"] == ["shoulder"]
