"""Where generated files go, what is asked wrongly, and how each file can be made again."""

from __future__ import annotations

import os
import re
import shlex
import shutil
from pathlib import Path

import pytest
from folder import CHECKOUT, Folder
from generating import command

from urdfctl import commands
from urdfctl.errors import UserError
from urdfctl.generate.options import File
from urdfctl.generate.text.parse_again import checked

ROBOT = """<robot name="r">
  <link name="a"/><link name="b"/>
  <joint name="j" type="continuous"><parent link="a"/><child link="b"/></joint>
</robot>
"""
EFFORT = ("--type", "effort", "--distro", "jazzy")


def test_what_the_robot_itself_cannot_do_is_said_after_writing(folder: Folder) -> None:
    weight = '<inertial><mass value="9"/><inertia ixx="1" ixy="0" ixz="0" iyy="1" iyz="0" izz="1"/></inertial>'
    arm = """<robot name="r"><link name="a"/><link name="b">{}</link><link name="c"/>
        <joint name="lift" type="prismatic"><parent link="a"/><child link="b"/><axis xyz="0 0 1"/>
        <limit lower="0" upper="1" effort="20" velocity="1"/></joint>
        <joint name="other" type="prismatic"><parent link="b"/><child link="c"/><axis xyz="0 0 1"/>
        <limit lower="0" upper="1" effort="20" velocity="1"/><mimic joint="lift"/></joint></robot>"""
    folder.write({"heavy.urdf": arm.format(weight), "light.urdf": arm.format("")})
    words = ("gen-all", "--distro", "noetic", "--simulator", "gazebo-classic", "--force")
    said = {name: command(*words, name, "-o", name[:5]).stderr for name in ("heavy.urdf", "light.urdf")}
    assert (
        "joint 'lift' cannot hold the weight in every pose: 'lift' needs 88.3 N, and its <limit> has effort 20\n"
        in said["heavy.urdf"]
    )
    assert "joint 'other' will hang: Gazebo Classic moves no mimic joints in ROS 1" in said["heavy.urdf"]
    assert "the robot has no masses, and a simulator drops moving links without them" in said["light.urdf"]
    assert "no masses" not in said["heavy.urdf"]


@pytest.mark.parametrize(
    ("words", "message"),
    [
        (("gen-controllers", *EFFORT), "no robot found; name one, or a list of joints"),
        (("gen-controllers", "missing.txt", *EFFORT), "'missing.txt' cannot be read: No such file or directory"),
        (("gen-controllers", "latin.txt", *EFFORT), "'latin.txt' cannot be read: it is not UTF-8"),
        (("gen-controllers", "empty.txt", *EFFORT), "no joints: name a robot, a list of joints, or --joint NAME,NAME"),
        (
            ("gen-controllers", "one/still.urdf", *EFFORT),
            "the robot has no joint to control: each is fixed or mimics another\n",
        ),
        (
            ("gen-controllers", "two/r.urdf", "--exclude", ".*", *EFFORT),
            "the robot has no joint to control: each is fixed or mimics another, or is excluded",
        ),
        (("gen-controllers", ".", *EFFORT), "several robots found: one/still.urdf, two/r.urdf"),
        (("gen-controllers", "two/r.urdf", "--joints", "(", *EFFORT), "'(' is not a valid regular expression:"),
        (("gen-controllers", "one/still.urdf", "--joint", "f", *EFFORT), "joint 'f' cannot be controlled"),
        (("gen-controllers", "--joint", "a", "--distro", "jazzy"), "--type is missing: use e.g. --type effort"),
        (("gen-controllers", "two/r.urdf", *EFFORT, "--check"), "--check requires -o FILE, the file to check"),
        (("gen-all", "two/r.urdf", *EFFORT), "-o FOLDER is missing; the package is written to it"),
        (
            ("gen-all", "two/r.urdf", *EFFORT, "-o", "latin.txt/x"),
            "'latin.txt/x' cannot be written: Not a directory",
        ),
        (("gen-controllers", "two/r.urdf", *EFFORT, "--templates", "none"), "template folder does not exist: 'none'"),
        (
            ("gen-launch", "two/r.urdf", *EFFORT, "--form", "toml"),
            "--form must be one of python, xml, yaml, not 'toml'",
        ),
        (("gen-transmissions", "two/r.urdf", "--distro", "jazzy"), "jazzy does not read transmissions of this form"),
        (("gen-ros2-control", "two/r.urdf", "--distro", "noetic"), "noetic does not read <ros2_control>"),
        (
            ("gen-ros2-control", "two/r.urdf", "--distro", "jazzy", "--hardware", "fake_components/GenericSystem"),
            "jazzy has no 'fake_components/GenericSystem'; use 'mock_components/GenericSystem'",
        ),
        (
            ("gen-all", "two/r.urdf", "--type", "effort", "--distro", "noetic", "--hardware", "mock", "-o", "x"),
            "noetic has no hardware plugins in the description; leave out --hardware",
        ),
        (
            ("gen-all", "two/r.urdf", "--type", "effort", "--distro", "foxy", "--simulator", "mujoco", "-o", "x"),
            "foxy has no 'mujoco' hardware; choose from: mock",
        ),
        (
            ("gen-all", "two/r.urdf", *EFFORT, "--simulator", "gazebo-classic", "-o", "x"),
            "jazzy has no plugin that runs controllers in 'gazebo-classic'; use --simulator gz, mujoco or none",
        ),
        (
            ("gen-gazebo", "two/r.urdf", "--distro", "noetic", "--simulator", "gz"),
            "noetic does not support controllers in 'gz'",
        ),
        (
            ("gen-gazebo", "two/r.urdf", "--distro", "jazzy", "--simulator", "gz", "--into", "none.xacro"),
            "'none.xacro' cannot be read: No such file or directory",
        ),
        (
            ("gen-gazebo", "two/r.urdf", "--distro", "jazzy", "--simulator", "gz", "--into", "empty.txt"),
            "'empty.txt' has no </robot> to insert before",
        ),
    ],
)
def test_what_cannot_be_done_is_told_in_a_line(words: tuple[str, ...], message: str, folder: Folder) -> None:
    still = '<robot name="s"><link name="a"/><link name="b"/><joint name="f" type="fixed"><parent link="a"/>'
    folder.write(
        {
            "one/still.urdf": still + '<child link="b"/></joint></robot>',
            "two/r.urdf": ROBOT,
            "latin.txt": "gr\xf6\xdfe".encode("latin-1"),
            "empty.txt": "# nothing\n",
        }
        if "no robot" not in message
        else {}
    )
    ran = command(*words)
    assert (ran.returncode, ran.stdout) == (2, "")
    assert message in ran.stderr
    assert ran.stderr.count("\n") == 1


def test_a_distro_that_nobody_tells_is_taken_and_said(folder: Folder) -> None:
    folder.write({"r.urdf": ROBOT})
    ran = command("gen-controllers", "r.urdf", "--type", "effort")
    assert ran.stderr == "urdfctl: ROS distro is unknown; using lyrical, the newest one. Set it with --distro\n"
    assert ran.stdout.startswith("# made by urdfctl gen-controllers r.urdf --type effort --distro lyrical\n")


def test_the_newest_distro_that_has_what_was_asked_for_is_taken(folder: Folder) -> None:
    folder.write({"r.urdf": ROBOT})
    words = ("r.urdf", "--type", "effort", "--simulator", "gazebo-classic", "-o", "made", "--force")
    ran = command("gen-all", *words)
    assert ran.stderr.startswith(
        "urdfctl: ROS distro is unknown; using humble, the newest one that has all of this. Set it with --distro\n"
    )
    assert 'distro = "humble"' in (folder.path / "made/urdfctl.toml").read_text()
    plugin = '<gazebo><plugin name="c" filename="libgazebo_ros2_control.so"/></gazebo>'
    folder.write({"old.urdf": ROBOT.replace("</robot>", f"{plugin}</robot>")})
    assert "using humble, the newest one." in command("gen-controllers", "old.urdf", "--type", "effort").stderr
    nowhere = command("gen-all", "r.urdf", "--type", "effort", "--simulator", "gz", "--group", "--type", "none/Such")
    assert (nowhere.returncode, nowhere.stderr.count("\n")) == (2, 1)
    assert nowhere.stderr.endswith("No ROS distro is known, and none has all of this: set it with --distro\n")


def test_the_simulator_of_gen_gazebo_is_that_of_the_distro(folder: Folder) -> None:
    folder.write({"r.urdf": ROBOT})
    for distro, plugin in (("noetic", "libgazebo_ros_control.so"), ("jazzy", "gz_ros2_control-system")):
        ran = command("gen-gazebo", "r.urdf", "--distro", distro, "--package", "p")
        assert plugin in ran.stdout
        assert f"-simulator {'gz' if distro == 'jazzy' else 'gazebo-classic'} -->" in ran.stdout


def test_after_writing_the_next_steps_are_told(folder: Folder) -> None:
    folder.write({"r.urdf": ROBOT})
    ran = command("gen-all", "r.urdf", *EFFORT, "-o", "made")
    assert [line.removeprefix("urdfctl: ") for line in ran.stderr.splitlines()] == [
        "8 files written to 'made'",
        "next: colcon build --packages-select made && source install/setup.bash",
        "next: ros2 launch made control.launch.py",
        'next: ros2 topic pub --once /effort_controller/commands std_msgs/msg/Float64MultiArray "{data: [0.0]}"',
        "next: urdfctl lint made && urdfctl smoke made",
    ]
    assert (folder.path / "made/urdf/r.urdf").read_text() == ROBOT
    assert "$(find made)/urdf/r.urdf" in (folder.path / "made/urdf/robot.urdf.xacro").read_text()
    part = command("gen-ros2-control", "r.urdf", "--distro", "jazzy", "--hardware", "mock", "-o", "urdf/c.xacro")
    include = '<xacro:include filename="$(find my_robot_control)/urdf/c.xacro"/>'
    assert part.stderr.splitlines()[-1] == f"urdfctl: next: include it in the robot: {include}"


COMMANDS = [
    "gen-controllers r.urdf --type effort --no-broadcaster --distro jazzy",
    "gen-controllers --joint a --joint 'b c' --type velocity --rate 250 --namespace n --name wheels --distro jazzy",
    "gen-controllers r.urdf --type trajectory --type pid --chain --state position,velocity --distro jazzy",
    "gen-transmissions r.urdf --interface velocity --macro --distro noetic",
    "gen-ros2-control r.urdf --command effort --state position --hardware mock --distro humble",
    "gen-gazebo r.urdf --package p --controllers c.yaml --distro humble --simulator gazebo-classic",
    "gen-launch r.urdf --type effort --package p --form xml --distro humble --simulator gz",
]


@pytest.mark.parametrize("words", COMMANDS)
def test_a_file_says_the_command_that_makes_it_again(words: str, folder: Folder) -> None:
    folder.write({"r.urdf": ROBOT})
    first = command(*shlex.split(words), "-o", "made")
    assert first.returncode == 0
    line = next(line for line in (folder.path / "made").read_text().splitlines() if "made by urdfctl" in line)
    said = line.partition("made by urdfctl ")[2].removesuffix(" -->")
    assert sorted(shlex.split(re.sub("(?<= )-(?=[a-z])", "--", said))) == sorted(shlex.split(words))
    assert command(*shlex.split(said), "-o", "made", "--check").returncode == 0


def test_the_folder_of_a_file_is_made(folder: Folder) -> None:
    assert command("gen-controllers", "--joint", "a", *EFFORT, "-o", "config/controllers.yaml").returncode == 0
    assert (folder.path / "config/controllers.yaml").is_file()


def test_what_would_be_inserted_is_shown_and_checked_and_inserted_once(folder: Folder) -> None:
    folder.write({"r.urdf": ROBOT, "x.xacro": "<robot><link name='a'/></robot>"})
    words = ("gen-transmissions", "r.urdf", "--distro", "noetic", "--interface", "effort", "--into", "x.xacro")
    assert command(*words, "--check") == (1, "x.xacro is out of date\n", "")
    shown = command(*words, "--diff")
    assert shown.returncode == 0
    assert "+      <hardwareInterface>hardware_interface/EffortJointInterface</hardwareInterface>\n" in shown.stdout
    assert (folder.path / "x.xacro").read_text() == "<robot><link name='a'/></robot>"
    assert command(*words).returncode == 0
    once = (folder.path / "x.xacro").read_text()
    assert once.startswith("<robot><link name='a'/>\n")
    assert command(*words) == (0, "", "urdfctl: 'x.xacro' has it already; nothing was written\n")
    assert command(*words, "--check") == (0, "", "")
    assert (folder.path / "x.xacro").read_text() == once


def test_several_files_are_compared_each(folder: Folder) -> None:
    folder.write(
        {"r.urdf": ROBOT, "out/package.xml": "<!-- made by urdfctl gen-all -->\n<package><name>mine</name></package>"}
    )
    words = ("gen-all", "r.urdf", *EFFORT, "-o", "out")
    stale = command(*words, "--check")
    assert stale.returncode == 1
    assert f"{os.path.join('out', 'package.xml')} is out of date\n" in stale.stdout
    assert "'out/package.xml' exists; --force overwrites it" in command(*words).stderr
    assert command(*words, "--force").returncode == 0
    assert "<name>mine</name>" in (folder.path / "out/package.xml").read_text()
    assert command(*words, "--check").returncode == 0


@pytest.mark.parametrize(
    ("name", "text"), [("a.yaml", "a: ["), ("a.xacro", "<robot>"), ("a.launch.py", "def ("), ("a.xml", "\udc80")]
)
def test_what_a_template_spoils_does_not_leave(name: str, text: str) -> None:
    with pytest.raises(UserError, match=name):
        checked(File(name, text))


def test_files_of_other_kinds_leave_as_they_are() -> None:
    assert checked(File("CMakeLists.txt", "project(")) == File("CMakeLists.txt", "project(")


def test_a_package_that_cannot_be_written_as_a_whole_is_not_written_at_all(folder: Folder) -> None:
    folder.write({"r.urdf": ROBOT, "out/launch": "a file in the place of a folder", "out/config/own": ""})
    before = sorted(folder.path.rglob("*"))
    ran = command("gen-all", "r.urdf", *EFFORT, "-o", "out", "--force")
    assert ran.stderr.splitlines()[-1].endswith("cannot be written: Not a directory")
    assert (ran.returncode, sorted(folder.path.rglob("*"))) == (2, before)


def test_a_folder_in_the_place_of_a_file_of_the_package_is_named(folder: Folder) -> None:
    folder.write({"r.urdf": ROBOT, "out/package.xml/file": ""})
    ran = command("gen-all", "r.urdf", *EFFORT, "-o", "out", "--force")
    assert (ran.returncode, ran.stderr.splitlines()[-1]) == (
        2,
        "urdfctl: 'out/package.xml' cannot be read: it is not a regular file",
    )


def test_generated_files_are_made_again_by_the_commands_that_they_name(folder: Folder, tmp_path: Path) -> None:
    folder.write({"src/r/package.xml": "<package format='3'><name>r</name></package>", "src/r/urdf/r.urdf": ROBOT})
    package = folder.path / "src/r"
    os.chdir(package)
    assert command("gen-controllers", "urdf/r.urdf", *EFFORT, "-o", "controllers.yaml").returncode == 0
    assert command("gen-ros2-control", "--command", "effort", "--distro", "jazzy", "-o", "urdf/c.xacro").returncode == 0
    os.chdir(folder.path)
    assert command("gen-all", "src/r/urdf/r.urdf", *EFFORT, "-o", "src/made").returncode == 0
    assert command("gen-check") == (0, "", "")
    (package / "urdf/r.urdf").write_text(ROBOT.replace('name="j"', 'name="k"'))
    stale = command("gen-check", "src")
    assert stale.returncode == 1
    assert "controllers.yaml is out of date\n" in stale.stdout
    assert "made/config/controllers.yaml is out of date\n" in stale.stdout
    assert command("gen-check", "src", "--update").returncode == 0
    assert "joints: [k]" in (package / "controllers.yaml").read_text()
    assert command("gen-check", "src/r/controllers.yaml", "src/made/package.xml") == (0, "", "")


def test_a_package_of_the_robot_that_was_found_is_made_again(folder: Folder) -> None:
    folder.write({"package.xml": "<package format='3'><name>r</name></package>", "urdf/r.urdf": ROBOT})
    assert command("gen-all", *EFFORT, "-o", "made").returncode == 0
    assert (
        (folder.path / "made/config/controllers.yaml").read_text().startswith("# made by urdfctl gen-all urdf/r.urdf")
    )
    assert command("gen-check") == (0, "", "")


def test_a_package_is_compared_with_the_robot_beside_it_and_not_with_its_own_copy(folder: Folder) -> None:
    folder.write({"src/r_description/urdf/r.urdf": ROBOT, "src/other/notes.txt": ""})
    os.chdir(folder.path / "src/r_description")
    assert command("gen-all", "urdf/r.urdf", *EFFORT, "-o", "../made").returncode == 0
    (folder.path / "src/r_description/urdf/r.urdf").write_text(ROBOT.replace('name="j"', 'name="k"'))
    for place in ("src/r_description", "src/made", "src", "."):
        os.chdir(folder.path / place)
        assert command("gen-check", str(folder.path / "src/made")).returncode == 1
    (folder.path / "src/r_description").rename(folder.path / "elsewhere")
    alone = command("gen-check", "src/made")
    assert alone.returncode == 0
    assert (
        "'src/made' was checked against the copy of the robot in it; to check it against the original" in alone.stderr
    )


def test_gen_check_works_in_the_package_and_in_the_workspace(folder: Folder) -> None:
    folder.write({"src/r.urdf": ROBOT})
    os.chdir(folder.path / "src")
    assert command("gen-all", "r.urdf", *EFFORT, "-o", "made").returncode == 0
    for place in ("src", "src/made", "src/made/config", "."):
        os.chdir(folder.path / place)
        assert command("gen-check") == (0, "", "")
    (folder.path / "src/r.urdf").write_text(ROBOT.replace('name="j"', 'name="k"'))
    for place in ("src", "src/made", "."):
        os.chdir(folder.path / place)
        assert command("gen-check").returncode == 1


def test_what_cannot_be_made_again_is_named(folder: Folder) -> None:
    folder.write({"r.urdf": ROBOT, "c.yaml": "# made by urdfctl gen-controllers r.urdf --type efort --distro jazzy\n"})
    assert command("gen-check").stderr.startswith("urdfctl: 'c.yaml' cannot be generated again: unknown type 'efort'")


@pytest.mark.parametrize(
    ("said", "why"),
    [
        ("gen-controllers gone.urdf --type effort", "its input 'gone.urdf' does not exist"),
        ("gen-controllers - --type effort", "it was generated from standard input"),
        ("gen-gazebo r.urdf --into r.urdf", "its command sets --into"),
        ("gen-controllers r.urdf -trust", "its command sets -trust"),
    ],
)
def test_what_cannot_or_may_not_be_made_again_is_passed_over(said: str, why: str, folder: Folder) -> None:
    folder.write({"r.urdf": ROBOT, "c.yaml": f"# made by urdfctl {said}\n", "d.yaml": "# made by urdfctl gen-all 'x\n"})
    ran = command("gen-check")
    assert (ran.returncode, ran.stdout) == (2, "")
    assert "no generated file was checked in this folder" in ran.stderr
    assert command("gen-check", "none").stderr == "urdfctl: file or folder 'none' does not exist\n"


def test_a_template_cannot_reach_out_of_itself(folder: Folder) -> None:
    folder.write({"mine/controllers/ros2.yaml.j2": "x: {{ ''.__class__.__mro__ }}\n"})
    ran = command("gen-controllers", "--joint", "a", *EFFORT, "--templates", "mine")
    assert "access to attribute '__class__' of 'str' object is unsafe" in ran.stderr


GENERATORS = [name for name, one in commands.COMMANDS.items() if one.group == commands.GENERATE and name != "gen-check"]


def example_of(name: str) -> str:
    """The command in a generator's help."""
    return (commands.command_named(name).options.__doc__ or "").partition("Example: ")[2].strip()


@pytest.mark.parametrize("name", GENERATORS)
def test_the_example_in_the_help_does_what_it_says(name: str, folder: Folder) -> None:
    shutil.copytree(CHECKOUT / "samples/picker", folder.path, dirs_exist_ok=True)
    example = example_of(name)
    ran = command(*shlex.split(example)[1:])
    assert ran.returncode == 0, ran.stderr
    assert example in " ".join(command(name, "--help").stdout.split())


def test_every_command_that_generates_is_in_the_list_of_commands() -> None:
    text = (CHECKOUT / "docs/commands.md").read_text(encoding="utf-8")
    assert [name for name in (*GENERATORS, "gen-check") if f"commands/{name}.md" not in text] == []
