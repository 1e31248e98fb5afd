"""The rules on package.xml, installed files and the files that launch files name, on whole small packages."""

from __future__ import annotations

from textwrap import dedent

import pytest
import robots
from folder import Folder
from launched_packages import found, ros1

from urdfctl.rules import launch_samples as samples
from urdfctl.rules.launch_samples import (
    ARM,
    BROADCASTER,
    CONTROLLERS,
    MANAGER,
    MANIFEST,
    PUBLISHER,
    launched,
)


def without(*names: str) -> str:
    """The manifest of the examples without some dependencies."""
    text = MANIFEST
    for name in names:
        text = text.replace(f"<exec_depend>{name}</exec_depend>", "")
    return text


def test_what_a_launch_file_needs_is_told_once_and_mended_in_the_manifest(folder: Folder) -> None:
    files = {**samples.SOUND, "package.xml": without("xacro", "joint_trajectory_controller", "controller_manager")}
    assert found(folder, files, "UC614") == [
        (
            "UC614",
            "warning",
            "launch file uses package 'controller_manager', but package.xml has no <exec_depend> for it",
        ),
        (
            "UC614",
            "warning",
            "launch file uses package 'joint_trajectory_controller', but package.xml has no <exec_depend> for it",
        ),
        ("UC614", "info", "launch file uses package 'xacro', but package.xml has no <exec_depend> for it"),
    ]
    findings = robots.findings("arm.launch.xml", ("UC614",))
    fix = next(finding.fix for finding in findings if "trajectory" in finding.message)
    assert fix is not None
    text = (folder.path / "package.xml").read_bytes()
    (edit,) = fix.edits
    mended = text[: edit.start] + edit.text.encode() + text[edit.end :]
    assert mended.endswith(b"  <exec_depend>joint_trajectory_controller</exec_depend>\n</package>\n")


@pytest.mark.parametrize(
    "more",
    [
        "<depend>ros2_controllers</depend><exec_depend>ros2_control</exec_depend>",
        "<exec_depend>arm_meta</exec_depend>",
        "<exec_depend>moveit</exec_depend>",
    ],
    ids=["by metapackages", "by a package among the sources", "by nearly everything"],
)
def test_a_package_may_come_with_another(folder: Folder, more: str) -> None:
    lacking = without("joint_trajectory_controller", "joint_state_broadcaster", "controller_manager")
    files = {**samples.SOUND, "package.xml": lacking.replace("</package>", f"{more}</package>")}
    inner = "".join(
        f"<depend>{name}</depend>"
        for name in ("joint_trajectory_controller", "controller_manager", "joint_state_broadcaster", "arm")
    )
    files["src/meta/package.xml"] = f"<package><name>arm_meta</name>{inner}<!-- <depend>x</depend> --></package>"
    assert found(folder, files, "UC614") == []


def test_of_a_controller_that_is_gone_no_package_is_asked_for(folder: Folder) -> None:
    gone = samples.SOUND["controllers.yaml"].replace(
        "joint_state_broadcaster/JointStateBroadcaster", "joint_state_controller/JointStateController"
    )
    files = {**samples.SOUND, "controllers.yaml": gone, "package.xml": without("joint_trajectory_controller")}
    assert [one[2] for one in found(folder, files, "UC614")] == [
        "launch file uses package 'joint_trajectory_controller', but package.xml has no <exec_depend> for it"
    ]


def test_a_manifest_of_the_first_format_has_another_word_for_it(folder: Folder) -> None:
    files = {**samples.SOUND, "package.xml": "<package><name>arm</name></package>"}
    messages = [one[2] for one in found(folder, files, "UC614")]
    assert "launch file uses package 'controller_manager', but package.xml has no <run_depend> for it" in messages


def test_without_a_manifest_that_can_be_read_nothing_is_missed_in_it(folder: Folder) -> None:
    files = {**samples.SOUND, "package.xml": "<project><name>arm</name></project>"}
    assert found(folder, files, "UC614", "UC615") == []


SETUP = """
    from setuptools import setup
    from glob import glob
    import os
    package_name = 'arm'
    setup(name=package_name, data_files=[
        ('share/' + package_name, ['package.xml']),
        {}
    ])
"""


@pytest.mark.parametrize(
    ("build", "text", "expected"),
    [
        ("CMakeLists.txt", "project(arm)\ninstall(DIRECTORY launch DESTINATION share/arm)", True),
        (
            "CMakeLists.txt",
            "project(arm)\ninstall(FILES controllers.yaml arm.urdf arm.launch.xml DESTINATION share/arm)",
            False,
        ),
        ("CMakeLists.txt", "foreach(d launch)\ninstall(DIRECTORY ${d} DESTINATION share/arm)\nendforeach()", True),
        ("CMakeLists.txt", "foreach(d ${all})\ninstall(DIRECTORY ${d} DESTINATION share/arm)\nendforeach()", False),
        ("CMakeLists.txt", "install(DIRECTORY ${FOLDERS} DESTINATION share/arm)", False),
        ("CMakeLists.txt", "ament_auto_package(INSTALL_TO_SHARE config)", True),
        ("CMakeLists.txt", "ament_auto_package(INSTALL_TO_SHARE ${all})", False),
        ("CMakeLists.txt", "set(all rclcpp)\nforeach(d IN ITEMS ${all})\nfind_package(${d})\nendforeach()", True),
        ("setup.py", SETUP.format(""), True),
        ("setup.py", SETUP.format("(os.path.join('share', package_name), glob('*.*ml') + ['arm.urdf'])"), False),
        (
            "setup.py",
            SETUP.format("(os.path.join('share', package_name), ['controllers.yaml', 'arm.urdf', 'arm.launch.xml'])"),
            False,
        ),
        ("setup.py", SETUP.format("(os.path.join('share', package_name), glob('*.*'))"), False),
        ("setup.py", SETUP.format("(os.path.join('share', package_name), found())"), False),
        ("setup.py", SETUP.format("*more"), False),
        ("setup.py", "setup(data_files=listed)", False),
        ("setup.py", "setup(", False),
    ],
)
def test_what_is_installed_is_only_judged_where_all_of_it_is_said(
    folder: Folder, build: str, text: str, expected: bool
) -> None:
    kind = "ament_python" if build == "setup.py" else "ament_cmake"
    manifest = MANIFEST.replace("</package>", f"<export><build_type>{kind}</build_type></export></package>")
    files = {**samples.SOUND, "package.xml": manifest, build: text}
    told = [one[2] for one in found(folder, files, "UC615")]
    assert bool(told) == expected
    assert all(build in message for message in told)


def test_a_missing_file_is_looked_for_where_the_build_installs_its_folder_from(folder: Folder) -> None:
    launch = samples.SOUND["arm.launch.xml"].replace("arm)/controllers.yaml", "arm)/config/controler.yaml")
    build = "project(arm)\ninstall(DIRECTORY launch bringup/config DESTINATION share/arm)"
    controllers = {"bringup/config/controllers.yaml": samples.SOUND["controllers.yaml"]}
    files = {"launch/arm.launch.xml": launch, **controllers, "CMakeLists.txt": build, "package.xml": MANIFEST}
    told = {one[2] for one in found(folder, files, "UC616")}
    assert [each.partition("; ")[2] for each in told if "config" in each] == ["did you mean 'controllers.yaml'?"]


def test_a_file_that_only_rviz_misses_makes_a_warning(folder: Folder) -> None:
    manifest = MANIFEST.replace("</package>", "<export><build_type>ament_cmake</build_type></export></package>")
    rviz = '<node pkg="rviz2" exec="rviz2" args="-d $(find-pkg-share arm)/view.rviz"/></launch>'
    to = "DESTINATION share/arm)"
    install = f"install(DIRECTORY launch {to}\ninstall(FILES controllers.yaml arm.urdf arm.launch.xml {to}"
    build = f"project(arm)\n{install}"
    files = {**samples.SOUND, "package.xml": manifest, "CMakeLists.txt": build, "view.rviz": ""}
    [launch] = [name for name in files if ".launch" in name]
    files[launch] = files[launch].replace("</launch>", rviz)
    assert [one[:2] for one in found(folder, files, "UC615")] == [("UC615", "warning")]


def test_of_a_package_that_installs_nothing_each_file_is_told(folder: Folder) -> None:
    manifest = MANIFEST.replace("</package>", "<export><build_type>ament_cmake</build_type></export></package>")
    files = {**samples.SOUND, "package.xml": manifest, "CMakeLists.txt": "install(FILES x DESTINATION share/arm)"}
    include = '<include file="$(find-pkg-share arm)/nowhere.launch.xml"/>'
    files["arm.launch.xml"] = files["arm.launch.xml"].replace("</launch>", f"{include}</launch>")
    assert {one[2] for one in found(folder, files, "UC615")} == {
        "'arm.urdf' is not installed: CMakeLists.txt does not list it",
        "'controllers.yaml' is not installed: CMakeLists.txt does not list it",
        "'arm.launch.xml' is not installed: CMakeLists.txt does not list it; 'ros2 launch arm' does not find it",
    }


CONFIGURED = """
    import os
    from ament_index_python.packages import get_package_share_directory
    from launch import LaunchDescription
    from launch.actions import IncludeLaunchDescription
    from launch.substitutions import PathJoinSubstitution
    from launch_ros.actions import Node
    from launch_ros.substitutions import FindPackageShare

    def generate_launch_description():
        file = os.path.join(get_package_share_directory("arm"), "config", "NAME.yaml")
        joined = PathJoinSubstitution([FindPackageShare("arm"), "config", "NAME.yaml"])
        robot = os.path.join(get_package_share_directory("arm"), "arm.urdf")
        publisher = Node(package="robot_state_publisher", executable="robot_state_publisher", arguments=[robot])
        return LaunchDescription([publisher, STARTED])
"""
DESCRIBED = '<param name="robot_description" textfile="$(find arm)/arm.urdf"/>'
GIVEN = {
    "an argument of ROS": "Node(package='b', executable='b', arguments=['--ros-args', '-p', f'config_file:={file}'])",
    "a parameter": "Node(package='b', executable='b', parameters=[{'config_file': joined}])",
    "an included file": "IncludeLaunchDescription('/opt/b.launch.py', launch_arguments={'params': file}.items())",
}


@pytest.mark.parametrize("started", GIVEN.values(), ids=GIVEN)
def test_a_missing_file_that_a_program_gets_is_told(folder: Folder, started: str) -> None:
    written = dedent(CONFIGURED).replace("STARTED", started)
    files = {"config/bridge.yaml": "", "package.xml": "<package format='3'><name>arm</name></package>"}
    files |= {"launch/all.launch.py": written.replace("NAME", "brige"), "arm.urdf": "<robot name='r'/>"}
    missing = "configuration file does not exist: 'arm/config/brige.yaml'; did you mean 'bridge.yaml'?"
    assert found(folder, files, "UC616", path="launch/all.launch.py") == [("UC616", "warning", missing)]
    assert (
        found(
            folder,
            {**files, "launch/all.launch.py": written.replace("NAME", "bridge")},
            "UC616",
            path="launch/all.launch.py",
        )
        == []
    )


@pytest.mark.parametrize(
    "started",
    [
        '<include file="$(find other)/nav.launch"><arg name="map" value="$(find arm)/config/hall.yaml"/></include>',
        '<node pkg="map_server" type="map_server" name="map" args="$(find arm)/config/hall.yaml"/>',
        '<node pkg="b" type="b" name="b"><param name="file" value="$(find arm)/config/hall.yaml"/></node>',
    ],
)
def test_a_missing_file_that_a_program_of_ros_1_gets_is_told(folder: Folder, started: str) -> None:
    files = {"config/floor.yaml": "", "package.xml": "<package><name>arm</name></package>"}
    files |= {"all.launch": f"<launch>{DESCRIBED}{started}</launch>", "arm.urdf": "<robot name='r'/>"}
    missing = "configuration file does not exist: 'arm/config/hall.yaml'"
    assert found(folder, files, "UC616", path="all.launch") == [("UC616", "warning", missing)]
    assert found(folder, {**files, "config/hall.yaml": ""}, "UC616", path="all.launch") == []


def test_a_file_of_a_package_without_build_type_need_not_be_installed(folder: Folder) -> None:
    assert found(folder, {**samples.SOUND, "CMakeLists.txt": "project(arm)"}, "UC615") == []


def test_a_file_that_is_not_there_is_told_of_unless_it_may_be_made(folder: Folder) -> None:
    include = '<include file="$(find-pkg-share arm)/{}"/>'
    assert found(folder, launched(include.format("other.launch.xml")), "UC616") == [
        ("UC616", "error", "included launch file does not exist: 'arm/other.launch.xml'"),
    ]
    sometimes = include.format("other.launch.xml").replace("<include", '<include if="$(env WHAT)"')
    assert [one[1] for one in found(folder, launched(sometimes), "UC616")] == ["warning"]
    assert found(folder, launched(include.format("made/other.launch.xml")), "UC616") == []
    make = "add_custom_command(OUTPUT other.launch.xml COMMAND make_it)"
    files = {**launched(include.format("other.launch.xml")), "CMakeLists.txt": make}
    assert found(folder, files, "UC616") == []
    (folder.path / "CMakeLists.txt").unlink()
    assert found(folder, launched('<include file="/nowhere/else.launch.xml"/>'), "UC616") == []
    (folder.path / "package.xml").unlink()
    files = launched(f'<include file="{folder.path}/other.launch.xml"/>')
    del files["package.xml"]
    assert found(folder, files, "UC616") == [
        ("UC616", "error", f"included launch file does not exist: '{folder.path}/other.launch.xml'"),
    ]


SETUP = """
    from glob import glob
    from os.path import join
    from setuptools import setup

    data_files = [(join("share", "arm", "launch"), glob("launch/*.launch.py"))]
    setup(name="arm", data_files=data_files{})
"""


@pytest.mark.parametrize(
    ("more", "told"),
    [
        ({"setup.py": SETUP.format("")}, True),
        ({"setup.py": SETUP.format(", cmdclass={'build_py': Make}")}, False),
        ({"setup.py": SETUP.format(""), "other/spawn.launch.py": ""}, False),
    ],
)
def test_a_setup_file_installs_files_and_makes_none(folder: Folder, more: dict[str, str], *, told: bool) -> None:
    include = """
        from os.path import join

        from ament_index_python.packages import get_package_share_directory
        from launch import LaunchDescription
        from launch.actions import IncludeLaunchDescription


        def generate_launch_description():
            path = join(get_package_share_directory("arm"), "launch", "spawn.launch.py")
            return LaunchDescription([IncludeLaunchDescription(path)])
    """
    files = {"launch/world.launch.py": include, "package.xml": MANIFEST, **more}
    missing = [("UC616", "error", "included launch file does not exist: 'arm/launch/spawn.launch.py'")]
    assert found(folder, files, "UC616") == (missing if told else [])


@pytest.mark.parametrize(
    ("name", "told"),
    [
        ("$(optenv KIND NONE)", []),
        ("$(arg kind)", []),
        ("$(arg other)", [("UC616", "error", "included launch file does not exist: 'arm/plain.launch'")]),
    ],
)
def test_a_path_that_the_environment_decides_need_not_exist_by_default(
    folder: Folder, name: str, told: list[tuple[str, str, str]]
) -> None:
    arguments = '<arg name="kind" default="$(optenv KIND NONE)"/><arg name="other" default="plain"/>'
    files = ros1(f'{arguments}<include file="$(find arm)/{name}.launch"/>', robot='<link name="a"/>')
    assert found(folder, files, "UC616") == told


WORLDS = """
    import os
    from ament_index_python.packages import get_package_share_directory
    from launch import LaunchDescription
    from launch.actions import IncludeLaunchDescription

    def generate_launch_description():
        gazebo = os.path.join(get_package_share_directory("gazebo_ros"), "launch", "gazebo.launch.py")
        world = os.path.join(get_package_share_directory("arm"), "worlds", "empty.world")
        return LaunchDescription([IncludeLaunchDescription(gazebo, launch_arguments={"world": world}.items())])
"""


@pytest.mark.parametrize(
    ("beside", "told"),
    [(None, ["warning"]), ("full.world", ["warning"]), ("README", ["info"]), ("empty.world", [])],
)
def test_a_world_that_does_not_exist_is_told_of_also_if_its_folder_is_missing(
    folder: Folder, beside: str | None, told: list[str]
) -> None:
    files = {"arm.launch.py": WORLDS, "package.xml": MANIFEST, "CMakeLists.txt": "ament_package()"}
    files |= {f"worlds/{beside}": ""} if beside else {}
    assert [one[1:] for one in found(folder, files, "UC616")] == [
        (severity, "world file does not exist: 'arm/worlds/empty.world'") for severity in told
    ]


@pytest.mark.parametrize(
    ("package", "value", "told"),
    [
        ("robot_state_publisher", "$(find-pkg-share arm)/arm.urdf", True),
        ("robot_state_publisher", "$(var model)", True),
        ("robot_state_publisher", "$(command 'cat $(find-pkg-share arm)/arm.urdf')", False),
        ("robot_state_publisher", "$(env DESCRIPTION)", False),
        ("robot_state_publisher", "<robot name='r'><link name='a.urdf'/></robot>", False),
        ("webots_ros2_driver", "$(find-pkg-share arm)/arm.urdf", False),
    ],
)
def test_a_path_in_place_of_the_description_is_an_error_for_what_reads_xml(
    folder: Folder, package: str, value: str, told: bool
) -> None:
    declared = '<arg name="model" default="$(find-pkg-share arm)/arm.urdf"/>'
    escaped = value.replace("<", "&lt;")
    node = f'<node pkg="{package}" exec="{package}"><param name="robot_description" value="{escaped}"/></node>'
    expected = ("UC645", "error", "'robot_description' is the path 'arm.urdf', but must be the text of the description")
    assert found(folder, launched(declared, node), "UC645") == ([expected] if told else [])


def test_an_argument_for_the_simulator_may_contain_its_own_former_value(folder: Folder) -> None:
    changes = {
        "import IncludeLaunchDescription": (
            "import DeclareLaunchArgument, IncludeLaunchDescription\n"
            "    from launch.substitutions import LaunchConfiguration"
        ),
        'os.path.join(get_package_share_directory("arm"), "worlds", "empty.world")': (
            '[get_package_share_directory("arm"), "/worlds/", LaunchConfiguration("world")]'
        ),
        "LaunchDescription([Inc": 'LaunchDescription([DeclareLaunchArgument("world", default_value="empty.world"), Inc',
    }
    named = WORLDS
    for before, after in changes.items():
        named = named.replace(before, after, 1)
    files = {"arm.launch.py": named, "package.xml": MANIFEST, "CMakeLists.txt": "ament_package()"}
    assert [one[2] for one in found(folder, files, "UC616")] == ["world file does not exist: 'arm/worlds/empty.world'"]


@pytest.mark.parametrize("text", ["$(var side)", "$(arg side)", "$(find-pkg-share arm)", "${side}"])
def test_what_launch_would_substitute_is_text_in_a_controller_file(folder: Folder, text: str) -> None:
    controllers = CONTROLLERS.replace("joints: [shoulder, elbow]", f"joints: ['{text}shoulder', elbow]")
    files = launched(PUBLISHER, MANAGER, BROADCASTER, ARM, controllers=controllers)
    assert found(folder, files, "UC033", distro="jazzy") == [
        ("UC033", "error", f"'{text}' in 'joints' is not expanded: nothing evaluates it in a controller file")
    ]


def test_an_argument_that_hangs_on_the_file_s_name_is_told(folder: Folder) -> None:
    publisher = PUBLISHER.replace("arm.urdf'", "arm.urdfprefix:=left_'")
    assert [one[2] for one in found(folder, launched(publisher), "UC617")] == [
        "the command has no space before 'prefix:='",
    ]


@pytest.mark.parametrize(
    ("command", "distro", "told"),
    [
        ("rosrun xacro xacro.py $(find arm)/arm.urdf", "noetic", ["error"]),
        ("$(find xacro)/xacro.py $(find arm)/arm.urdf", None, ["info"]),
        ("$(find xacro)/xacro.py $(find arm)/arm.urdf", "melodic", []),
        ("$(find arm)/xacro.py $(find arm)/arm.urdf", "noetic", []),
    ],
)
def test_xacro_is_called_by_its_old_name(folder: Folder, command: str, distro: str | None, told: list[str]) -> None:
    files = ros1(robot='<gazebo><plugin name="c" filename="libgazebo_ros_control.so"/></gazebo>')
    files["arm.launch"] = f'<launch><param name="robot_description" command="{command}"/></launch>'
    assert [one[1] for one in found(folder, files, "UC620", distro=distro)] == told


def test_an_included_file_that_takes_all_arguments_is_given_those_that_it_has(folder: Folder) -> None:
    include = '<include file="$(find arm)/inner.launch" pass_all_args="true"><arg name="gui" value="1"/></include>'
    files = {**ros1(include), "inner.launch": '<launch><group><arg name="gui" default="0"/></group></launch>'}
    assert found(folder, files, "UC618") == []
    elsewhere = include.replace("<include", '<include if="false"')
    files = {**ros1(elsewhere), "inner.launch": "<launch/>"}
    assert found(folder, files, "UC618") == []


def test_joints_that_a_package_lists_for_a_driver_are_the_robot_s(folder: Folder) -> None:
    def told(listed: str) -> list[str]:
        files = {"urdf/arm.urdf": "<link name='x'/>", "config/joint_names_arm.yaml": listed}
        return [one[2] for one in found(folder, files, "UC619")]

    assert told("controller_joint_names: [shoulder, elbov]") == [
        "controller_joint_names lists joint 'elbov', which the robot does not have; did you mean 'elbow'?",
    ]
    assert told("controller_joint_names: ['', shoulder, elbow]") == []
    assert told("controller_joint_names: [a, b, elbow]") == []
    assert told("controller_joint_names: {a: 1}") == []
    assert told("[1, 2]") == []
    (folder.path / "config/joint_names_arm.yaml").unlink()
    (folder.path / "config/joint_names_arm.yaml").symlink_to("/etc/hostname")
    files = {"urdf/arm.urdf": "<link name='x'/>"}
    assert found(folder, files, "UC619") == []


def test_the_package_of_the_examples_is_whole() -> None:
    assert all(f"<exec_depend>{name}<" in MANIFEST for name in ("controller_manager", "xacro"))


def test_the_package_of_the_hardware_belongs_into_the_manifest_too(folder: Folder) -> None:
    simulated = samples.ROBOT.replace("mock_components/GenericSystem", "gz_ros2_control/GazeboSimSystem")
    files = {**samples.SOUND, "arm.urdf": simulated}
    message = "robot uses package 'gz_ros2_control', but package.xml has no <exec_depend> for it"
    assert found(folder, files, "UC614", distro="jazzy") == [("UC614", "info", message)]
    declared = MANIFEST.replace("</package>", "  <exec_depend>gz_ros2_control</exec_depend>\n</package>")
    assert found(folder, {**files, "package.xml": declared}, "UC614", distro="jazzy") == []
    mocked = {**samples.SOUND, "package.xml": MANIFEST}
    assert found(folder, mocked, "UC614", distro="jazzy") == []
    renamed = {**files, "arm.urdf": simulated.replace("gz_ros2_control/GazeboSim", "ign_ros2_control/Ignition")}
    assert found(folder, renamed, "UC614", distro="jazzy") == []
