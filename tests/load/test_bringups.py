"""Whatever is named, what is started together with it is linted; `show` prints it."""

from __future__ import annotations

import json

import pytest
from folder import Folder

ROBOT = """\
<robot name="arm" xmlns:xacro="http://www.ros.org/wiki/xacro">
  <xacro:arg name="prefix" default=""/>
  <xacro:include filename="parts.xacro"/>
  <link name="$(arg prefix)base"/>
  <xacro:upper prefix="$(arg prefix)"/>
  <ros2_control name="arm" type="system">
    <hardware><plugin>mock_components/GenericSystem</plugin></hardware>
    <joint name="$(arg prefix)elbow"><command_interface name="position"/><state_interface name="position"/></joint>
  </ros2_control>
</robot>
"""
PARTS = """\
<robot xmlns:xacro="http://www.ros.org/wiki/xacro">
  <xacro:macro name="upper" params="prefix">
    <link name="${prefix}upper"><inertial><mass value="1"/><inertia ixx="1" iyy="1" izz="1" ixy="0" ixz="0" iyz="0"/>
    </inertial></link>
    <joint name="${prefix}elbow" type="revolute"><parent link="${prefix}base"/><child link="${prefix}upper"/>
      <limit lower="-1" upper="1" effort="1" velocity="1"/></joint>
  </xacro:macro>
</robot>
"""
CONTROLLERS = """\
controller_manager:
  ros__parameters:
    mover: {type: forward_command_controller/ForwardCommandController}
mover:
  ros__parameters:
    joints: [left_elbow]
    interface_name: %s
"""
LAUNCH = """\
<launch>
  <node pkg="robot_state_publisher" exec="robot_state_publisher">
    <param name="robot_description" type="str"
           value="$(command 'xacro $(find-pkg-share arm_description)/urdf/arm.xacro prefix:=left_')"/>
  </node>
  <node pkg="controller_manager" exec="ros2_control_node">
    <param from="$(find-pkg-share arm_bringup)/config/controllers.yaml"/>
  </node>
  <node pkg="controller_manager" exec="spawner" args="mover"/>
</launch>
"""
LAUNCH_WITHOUT_CONTROLLERS = LAUNCH.partition('  <node pkg="controller_manager"')[0] + "</launch>\n"


def manifest(name: str) -> str:
    return f"<package format='3'><name>{name}</name><build_depend>ament_cmake</build_depend></package>"


def workspace(folder: Folder, interface: str = "position") -> None:
    """A description in one package, what starts it in the package beside it."""
    folder.write(
        {
            ".git/HEAD": "",
            "src/arm_description/package.xml": manifest("arm_description"),
            "src/arm_description/urdf/arm.xacro": ROBOT,
            "src/arm_description/urdf/parts.xacro": PARTS,
            "src/arm_bringup/package.xml": manifest("arm_bringup"),
            "src/arm_bringup/config/controllers.yaml": CONTROLLERS % interface,
            "src/arm_bringup/launch/arm.launch.xml": LAUNCH,
        }
    )


def targets(folder: Folder, *words: str, cwd: str = ".") -> list[tuple[str, dict[str, str], list[str]]]:
    """Robot, arguments and controller files of each target of a run, which is made in a folder of the workspace."""
    ran = folder.run("lint", *words, "--format", "json", "--distro", "jazzy", cwd=folder.path / cwd)
    assert ran.returncode in (0, 1), ran.stderr
    return [
        (
            target["robot"].rpartition("/")[2],
            target["arguments"],
            [file.rpartition("/")[2] for file in target["controllers"]],
        )
        for target in json.loads(ran.stdout)["targets"]
    ]


TOGETHER = [("arm.xacro", {"prefix": "left_"}, ["controllers.yaml"])]


@pytest.mark.parametrize(
    ("words", "cwd"),
    [
        (["src/arm_description/urdf/arm.xacro"], "."),
        (["src/arm_description/urdf/parts.xacro"], "."),
        (["src/arm_description/urdf"], "."),
        (["src/arm_bringup/config/controllers.yaml"], "."),
        (["src/arm_bringup/config"], "."),
        (["src/arm_bringup/launch/arm.launch.xml"], "."),
        (["src/arm_bringup"], "."),
        (["arm.xacro"], "src/arm_description/urdf"),
        ([], "src/arm_bringup/config"),
    ],
)
def test_any_path_finds_what_is_started_together(folder: Folder, words: list[str], cwd: str) -> None:
    workspace(folder)
    assert TOGETHER[0] in targets(folder, *words, cwd=cwd)


def test_a_named_robot_is_linted_as_it_is_started_and_not_also_alone(folder: Folder) -> None:
    workspace(folder)
    assert targets(folder, "src/arm_description/urdf/arm.xacro") == TOGETHER


SDF = '<sdf version="1.8"><model name="arm"><link name="base"/></model></sdf>\n'


@pytest.mark.parametrize(
    ("dependency", "expected"),
    [
        ("robot_state_publisher", "warning UC101 the description is SDF: robot_state_publisher reads it only if"),
        ("sdformat_urdf", "info UC101 SDF is not checked"),
    ],
)
def test_sdf_may_be_a_description_in_ros_2(folder: Folder, dependency: str, expected: str) -> None:
    workspace(folder)
    depends = f"<exec_depend>{dependency}</exec_depend></package>"
    folder.write(
        {
            "src/arm_description/urdf/arm.xacro": SDF,
            "src/arm_bringup/package.xml": manifest("arm_bringup").replace("</package>", depends),
            "src/arm_bringup/launch/arm.launch.xml": LAUNCH_WITHOUT_CONTROLLERS,
        }
    )
    ran = folder.run("lint", "--select", "UC101", "--format", "concise")
    assert f"src/arm_description/urdf/arm.xacro:1:1: {expected}" in ran.stdout
    assert folder.run("smoke").returncode == 5  # nothing to test


def test_sdf_is_no_description_for_a_controller_manager_or_for_ros_1(folder: Folder) -> None:
    workspace(folder)
    folder.write({"src/arm_description/urdf/arm.xacro": SDF})
    says = "error UC101 root element is <sdf>; it must be <robot>"
    assert says in folder.run("lint", "--distro", "jazzy", "--format", "concise").stdout
    folder.write({"src/arm_bringup/launch/arm.launch.xml": LAUNCH_WITHOUT_CONTROLLERS})
    assert says in folder.run("lint", "--distro", "noetic", "--format", "concise").stdout
    folder.write({"alone/arm.urdf": SDF})
    assert says in folder.run("lint", "alone/arm.urdf", "--distro", "jazzy", "--format", "concise").stdout


MOUNTED = """\
<robot name="arm" xmlns:xacro="http://www.ros.org/wiki/xacro">
  <xacro:arg name="on_table" default="false"/>
  <link name="world"/><link name="base"/><link name="tip"/>
  <joint name="tip_mount" type="fixed"><parent link="base"/><child link="tip"/></joint>
  <xacro:if value="$(arg on_table)">
    <joint name="mount" type="fixed"><parent link="world"/><child link="base"/></joint>
  </xacro:if>
</robot>
"""


@pytest.mark.parametrize(
    ("words", "given", "expected"),
    [
        ([], "on_table:=true", None),
        ([], "on_table:=false", "error"),
        ([], "", "error"),
        (["src/arm_description/urdf/arm.xacro", "on_table:=false"], "on_table:=true", "error"),
    ],
)
def test_what_only_the_defaults_show_that_no_launch_file_leaves_is_not_told(
    folder: Folder, words: list[str], given: str, expected: str | None
) -> None:
    workspace(folder)
    launch = LAUNCH.replace("prefix:=left_", given)
    folder.write({"src/arm_description/urdf/arm.xacro": MOUNTED, "src/arm_bringup/launch/arm.launch.xml": launch})
    ran = folder.run("lint", *words, "--distro", "jazzy", "--format", "json", "--select", "UC105", "--exit-zero")
    found = [(finding["severity"], len(finding["notes"])) for finding in json.loads(ran.stdout)["findings"]]
    assert found == ([] if expected is None else [(expected, 1)])


def test_arguments_on_the_command_line_go_before_those_of_the_launch_file(folder: Folder) -> None:
    workspace(folder)
    found = targets(folder, "src/arm_description/urdf/arm.xacro", "prefix:=right_")
    assert found == [("arm.xacro", {"prefix": "right_"}, ["controllers.yaml"])]


def test_controllers_named_beside_a_robot_are_all_that_belongs_to_it(folder: Folder) -> None:
    workspace(folder)
    folder.write({"mine.yaml": CONTROLLERS % "position"})
    assert targets(folder, "src/arm_description/urdf/arm.xacro", "mine.yaml") == [("arm.xacro", {}, ["mine.yaml"])]


def test_a_fault_between_packages_is_found_from_the_robot(folder: Folder) -> None:
    workspace(folder, interface="velocity")
    ran = folder.run("lint", "src/arm_description/urdf/arm.xacro", "--distro", "jazzy", "--format", "concise")
    assert ran.returncode == 1
    assert "src/arm_bringup/config/controllers.yaml:6:14: error UC450" in ran.stdout


def test_a_launch_file_that_starts_another_robot_is_not_reported(folder: Folder) -> None:
    workspace(folder)
    folder.write({"src/arm_description/urdf/other.xacro": ROBOT.replace('name="arm"', 'name="other"')})
    assert targets(folder, "src/arm_description/urdf/other.xacro") == [("other.xacro", {}, [])]


def test_show_prints_what_is_started_together(folder: Folder) -> None:
    workspace(folder)
    folder.write({"src/arm_bringup/config/old.yaml": CONTROLLERS % "position"})
    ran = folder.run("show", "src/arm_bringup", "--distro", "jazzy")
    assert ran.returncode == 0, ran.stderr
    assert [line.split() for line in ran.stdout.splitlines()] == [
        ["src/arm_bringup/launch/arm.launch.xml"],
        ["description", "src/arm_description/urdf/arm.xacro", "prefix:=left_"],
        ["controllers", "src/arm_bringup/config/controllers.yaml"],
        ["spawned", "mover"],
        ["distro", "jazzy,", "from", "--distro"],
        ["src/arm_bringup/config/old.yaml", "(no", "robot", "uses", "it)"],
    ]


def test_show_gives_the_same_as_json(folder: Folder) -> None:
    workspace(folder)
    shown = json.loads(folder.run("show", "src/arm_bringup", "--format", "json").stdout)
    [target] = shown["targets"]
    assert (target["launch"], target["spawned"], target["arguments"]) == (
        "src/arm_bringup/launch/arm.launch.xml",
        ["mover"],
        {"prefix": "left_"},
    )


def test_show_names_the_launch_file_of_a_robot_without_controllers(folder: Folder) -> None:
    workspace(folder)
    display = LAUNCH[: LAUNCH.index('  <node pkg="controller_manager"')] + "</launch>\n"
    (folder.path / "src/arm_bringup/launch/arm.launch.xml").write_text(display)
    ran = folder.run("show", "src")
    assert [line for line in ran.stdout.splitlines() if not line.startswith(" ")] == [
        "src/arm_bringup/launch/arm.launch.xml",
        "src/arm_description/urdf/arm.xacro  (no launch file starts it with these arguments)",
        "src/arm_bringup/config/controllers.yaml  (no robot uses it)",
    ]


def test_a_path_of_another_machine_counts_in_a_robot_that_a_launch_file_starts(folder: Folder) -> None:
    path = "/home/me/ws/install/arm/share/arm/config/c.yaml"
    plugin = '<gazebo><plugin filename="gz_ros2_control-system" name="gz_ros2_control::GazeboSimROS2ControlPlugin">'
    joints = '<link name="a"/><link name="b"/><joint name="j" type="fixed"><parent link="a"/><child link="b"/></joint>'
    robot = f'<robot name="arm">{joints}{plugin}<parameters>{path}</parameters></plugin></gazebo></robot>'
    description = "$(command 'cat $(find-pkg-share arm)/arm.urdf')"
    launch = f"""<launch>
      <node pkg="robot_state_publisher" exec="robot_state_publisher">
        <param name="robot_description" type="str" value="{description}"/>
      </node>
    </launch>"""
    folder.write({"package.xml": manifest("arm"), "arm.urdf": robot, "config/c.yaml": CONTROLLERS % "position"})
    assert targets(folder, ".") == [("arm.urdf", {}, [])]
    folder.write({"launch/arm.launch.xml": launch})
    assert targets(folder, ".") == [("arm.urdf", {}, ["c.yaml"])]


def test_show_of_an_empty_folder_is_an_error(folder: Folder) -> None:
    folder.write({"empty/readme.txt": ""})
    ran = folder.run("show", "empty")
    assert (ran.returncode, ran.stderr) == (
        2,
        "urdfctl: no robot, no controller file and no launch file that starts either in empty\n",
    )


# -- by elimination --------------------------------------------------------------------------------------------------


def package(folder: Folder, interface: str = "velocity", **more: str) -> None:
    """A robot and a controller file in one package, and nothing that says that they belong together."""
    files = {"urdf/arm.xacro": ROBOT.replace('default=""', 'default="left_"'), "urdf/parts.xacro": PARTS}
    files |= {"package.xml": manifest("arm"), "config/controllers.yaml": CONTROLLERS % interface}
    folder.write({**files, **{name.replace("__", "/"): text for name, text in more.items()}})


def test_the_only_robot_and_the_only_controller_file_of_a_package_belong_together(folder: Folder) -> None:
    package(folder)
    assert targets(folder, ".") == [("arm.xacro", {}, ["controllers.yaml"])]


def test_what_depends_on_that_is_an_error(folder: Folder) -> None:
    package(folder)
    report = json.loads(folder.run("lint", ".", "--distro", "jazzy", "--format", "json").stdout)
    [found] = [finding for finding in report["findings"] if finding["code"] == "UC450"]
    assert found["severity"] == "error"


def test_an_error_of_the_controller_file_itself_stays_one(folder: Folder) -> None:
    package(folder, interface="[]")
    report = json.loads(folder.run("lint", ".", "--distro", "jazzy", "--format", "json").stdout)
    assert ["UC432", "error"] in [[finding["code"], finding["severity"]] for finding in report["findings"]]


@pytest.mark.parametrize(
    "more",
    [
        {"urdf__other.xacro": ROBOT.replace('name="arm"', 'name="other"')},
        {"config__other.yaml": CONTROLLERS % "position"},
        {"config__controllers.yaml": CONTROLLERS.replace("left_elbow", "wheel") % "position"},
    ],
    ids=["two robots", "two controller files", "no common joint"],
)
def test_where_anything_else_is_possible_nothing_is_paired(folder: Folder, more: dict[str, str]) -> None:
    package(folder, **more)
    assert all(controllers == [] for _, _, controllers in targets(folder, "."))


@pytest.mark.parametrize("copy", ["config/old/controllers.yaml", "config/controllers (1).yaml", "backup/arm.yml"])
def test_a_copy_of_the_controller_file_does_not_count(copy: str, folder: Folder) -> None:
    package(folder)
    folder.write({copy: CONTROLLERS % "position"})
    assert targets(folder, ".") == [("arm.xacro", {}, ["controllers.yaml"])]


def test_a_controller_file_that_is_kept_aside_is_paired_with_nothing(folder: Folder) -> None:
    package(folder)
    folder.write({"config/old/controllers.yaml": CONTROLLERS % "position"})
    (folder.path / "config/controllers.yaml").unlink()
    assert all(controllers == [] for _, _, controllers in targets(folder, "."))
