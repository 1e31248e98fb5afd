"""What a project's configuration says of its robots: which files belong together, and with which arguments."""

from __future__ import annotations

import json

import pytest
from folder import Folder
from smoking_engines import needs_an_engine

from urdfctl.config.file import config_of
from urdfctl.config.robots import MOST_VARIANTS, ConfiguredRobot
from urdfctl.errors import UserError

ARM = """\
<robot name="arm" xmlns:xacro="http://www.ros.org/wiki/xacro">
  <xacro:arg name="kind" default="revolute"/>
  <xacro:arg name="reach" default="1"/>
  <link name="world"/>
  <link name="tip">
    <inertial><mass value="1"/><inertia ixx="1" ixy="0" ixz="0" iyy="1" iyz="0" izz="1"/></inertial>
  </link>
  <joint name="elbow" type="$(arg kind)">
    <parent link="world"/><child link="tip"/>
    <limit lower="-1" upper="$(arg reach)" effort="1" velocity="1"/>
  </joint>
</robot>
"""
CONTROLLERS = """\
controller_manager:
  ros__parameters:
    update_rate: 100
    arm_controller:
      type: position_controllers/JointGroupPositionController
arm_controller:
  ros__parameters:
    joints: [elbow]
"""


def found(folder: Folder, *words: str) -> tuple[list[str], int]:
    """The codes of the findings, and how many targets were looked at."""
    ran = folder.run("lint", *words, "--format", "json", "--exit-zero")
    assert ran.returncode == 0, ran.stderr
    report = json.loads(ran.stdout)
    return [finding["code"] for finding in report["findings"]], len(report["targets"])


def test_all_that_may_be_said_of_a_robot_is_read(folder: Folder) -> None:
    text = """
        [[robot]]
        path = "urdf/arm.xacro"
        args = { sim = true, reach = 2, prefix = "" }
        controllers = ["config/arm.yaml"]
        launch = ["launch/arm.launch.py"]
        matrix = { kind = ["revolute", "prismatic", "revolute"], scale = [0.5] }
        [[robot]]
        path = "urdf/other.urdf"
    """
    names = ("urdf/arm.xacro", "urdf/other.urdf", "config/arm.yaml", "launch/arm.launch.py")
    folder.write({"sub/urdfctl.toml": text, **{f"sub/{name}": "" for name in names}})
    config = config_of("sub/urdfctl.toml")
    fixed = (("sim", "true"), ("reach", "2"), ("prefix", ""))
    assert config is not None
    assert config.robots == (
        ConfiguredRobot(
            "sub/urdf/arm.xacro",
            tuple((*fixed, ("kind", kind), ("scale", "0.5")) for kind in ("revolute", "prismatic")),
            ("sub/config/arm.yaml",),
            ("sub/launch/arm.launch.py",),
        ),
        ConfiguredRobot("sub/urdf/other.urdf"),
    )


@pytest.mark.parametrize(
    ("text", "told"),
    [
        ("[robot]\npath = 'arm.urdf'", "robot: must be a list, not {"),
        ("[[robot]]\nargs = {}", "robot[0]: required key 'path' is missing"),
        ("[[robot]]\npath = 'arm.urdf'\nmatrx = {}", "robot[0]: unknown key 'matrx'; did you mean 'matrix'?"),
        ("[[robot]]\npath = 'arm.urdf'\nmatrix.a = []", "robot[0].matrix.a: must have at least 1 element"),
        ("[[robot]]\npath = 'arm.urdf'\nmatrix.a = 'b'", 'robot[0].matrix.a: must be a list, not "b"'),
        ("[[robot]]\npath = 'arm.urdf'\nargs.a = ['b']", 'robot[0].args.a: must be a string, not ["b"]'),
        ("[[robot]]\npath = 'arm.urdf'\nargs.a = 1\nmatrix.a = [2]", "robot[0].matrix: 'a' is also defined in args"),
        ("[[robot]]\npath = 'arm.udrf'", "robot[0].path: file 'arm.udrf' does not exist; did you mean 'arm.urdf'?"),
        ("[[robot]]\npath = 'no/arm.urdf'", "robot[0].path: file 'no/arm.urdf' does not exist"),
        ("[[robot]]\npath = 'arm.urdf'\nlaunch = ['a.py']", "robot[0].launch[0]: file 'a.py' does not exist"),
        (
            "[[robot]]\npath = 'arm.urdf'\ncontrollers = ['a.yaml']",
            "robot[0].controllers[0]: file 'a.yaml' does not exist",
        ),
    ],
)
def test_what_means_nothing_is_told_with_file_and_key(folder: Folder, text: str, told: str) -> None:
    folder.write({"urdfctl.toml": text, "arm.urdf": ARM})
    with pytest.raises(UserError) as error:
        config_of("urdfctl.toml")
    assert str(error.value).startswith(f"urdfctl.toml: {told}")


def test_a_matrix_has_an_end(folder: Folder) -> None:
    axes = "\n".join(f"matrix.a{number} = {list(range(10))}" for number in range(9))
    folder.write({"urdfctl.toml": f"[[robot]]\npath = 'arm.urdf'\n{axes}", "arm.urdf": ARM})
    with pytest.raises(UserError, match=f"defines more than {MOST_VARIANTS} variants"):
        config_of("urdfctl.toml")


MATRIX = "[[robot]]\npath = 'arm.xacro'\nmatrix.kind = ['revolute', 'sideways']\n"


@pytest.mark.parametrize("words", [(), (".",), ("arm.xacro",), ("urdf/..",)])
def test_each_variant_is_looked_at_however_the_robot_is_named(folder: Folder, words: tuple[str, ...]) -> None:
    folder.write({"urdfctl.toml": MATRIX, "arm.xacro": ARM, "urdf/x.txt": ""})
    assert found(folder, *words) == (["UC121"], 2)


def test_an_argument_of_the_command_line_goes_over_the_configurations(folder: Folder) -> None:
    folder.write({"urdfctl.toml": MATRIX, "arm.xacro": ARM})
    assert found(folder, "arm.xacro", "kind:=revolute") == ([], 1)
    assert found(folder, "kind:=revolute") == ([], 1)


def test_with_no_path_the_same_is_looked_at_as_in_the_current_folder(folder: Folder) -> None:
    other = ARM.replace('default="revolute"', 'default="sideways"')
    folder.write({"urdfctl.toml": "[[robot]]\npath = 'arm.xacro'", "arm.xacro": ARM, "other.xacro": other})
    assert found(folder) == (["UC121"], 2)
    assert found(folder, ".") == (["UC121"], 2)


def test_a_configured_robot_that_others_include_is_looked_at_too(folder: Folder) -> None:
    outer = '<robot name="o" xmlns:xacro="http://www.ros.org/wiki/xacro"><xacro:include filename="arm.xacro"/></robot>'
    folder.write({"urdfctl.toml": MATRIX, "arm.xacro": ARM, "outer.xacro": outer})
    assert found(folder, ".") == (["UC121"], 3)


def test_what_each_variant_shows_is_told_once(folder: Folder) -> None:
    text = "[[robot]]\npath = 'arm.xacro'\nmatrix.kind = ['sideways', 'upwards', 'sideways']\nmatrix.reach = [1, 2]\n"
    folder.write({"urdfctl.toml": text, "arm.xacro": ARM})
    assert found(folder) == (["UC121"], 4)


def test_the_files_that_belong_to_a_robot_are_read_with_it(folder: Folder) -> None:
    text = "distro = 'jazzy'\n[[robot]]\npath = 'arm.xacro'\ncontrollers = ['arm.yaml']\n"
    folder.write({"urdfctl.toml": text, "arm.xacro": ARM, "arm.yaml": CONTROLLERS.replace("[elbow]", "[ebow]")})
    assert "UC440" in found(folder)[0]
    folder.write({"other.yaml": CONTROLLERS})
    assert "UC440" not in found(folder, "arm.xacro", "other.yaml")[0]


LAUNCH = """\
<launch>
  <arg name="kind" default="sideways"/>
  <param name="robot_description" command="xacro $(dirname)/arm.xacro kind:=$(arg kind)"/>
</launch>
"""


def test_a_launch_file_that_belongs_to_a_robot_is_looked_at_with_it_and_not_alone(folder: Folder) -> None:
    text = "[[robot]]\npath = 'arm.xacro'\nlaunch = ['arm.launch']\n"
    folder.write({"urdfctl.toml": text, "arm.xacro": ARM, "arm.launch": LAUNCH})
    assert found(folder, ".") == (["UC121"], 1)


def test_a_robots_own_argument_goes_over_its_launch_files(folder: Folder) -> None:
    text = "[[robot]]\npath = 'arm.xacro'\nargs.kind = 'revolute'\nlaunch = ['arm.launch']\n"
    folder.write({"urdfctl.toml": text, "arm.xacro": ARM, "arm.launch": LAUNCH})
    assert found(folder) == ([], 1)


def test_the_files_of_a_robot_are_in_one_share(folder: Folder) -> None:
    text = "distro = 'jazzy'\n[[robot]]\npath = 'a/arm.xacro'\ncontrollers = ['c/arm.yaml']\n"
    folder.write({".git/HEAD": "", "urdfctl.toml": text, "a/arm.xacro": ARM, "c/arm.yaml": CONTROLLERS})
    whole = found(folder, ".")
    shares = [found(folder, ".", "--shard", f"{number}/2") for number in (1, 2)]
    assert sorted(shares) == sorted([whole, ([], 0)])


REVERSED = ARM.replace('lower="-1" upper="$(arg reach)"', 'lower="1" upper="-1"')


def test_what_only_some_variants_show_is_not_mended(folder: Folder) -> None:
    text = "[[robot]]\npath = 'arm.xacro'\nmatrix.kind = ['revolute', 'continuous']\n"
    folder.write({"urdfctl.toml": text, "arm.xacro": REVERSED})
    ran = folder.run("lint", "--unsafe-fixes", "--exit-zero")
    assert (folder.path / "arm.xacro").read_text() == REVERSED
    assert "UC125 is not fixed: the fix would also change a robot without this finding" in ran.stderr


def test_what_all_variants_show_is_mended_once(folder: Folder) -> None:
    text = "[[robot]]\npath = 'arm.xacro'\nmatrix.kind = ['revolute', 'prismatic']\n"
    folder.write({"urdfctl.toml": text, "arm.xacro": REVERSED})
    folder.run("lint", "--unsafe-fixes", "--exit-zero")
    assert (folder.path / "arm.xacro").read_text() == REVERSED.replace('lower="1" upper="-1"', 'lower="-1" upper="1"')


@needs_an_engine
def test_smoke_tests_the_configurations_robots_too(folder: Folder) -> None:
    folder.write({"urdfctl.toml": "[[robot]]\npath = 'arm.xacro'\n", "arm.xacro": ARM, "other.xacro": ARM})
    ran = folder.run("smoke")
    assert ran.stdout.startswith("arm.xacro (")
    assert "other.xacro (" in ran.stdout
