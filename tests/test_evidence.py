"""The distro is told by the user, else by the environment, else by what the files say."""

from __future__ import annotations

import pytest
from folder import Folder

from urdfctl.catalog.distros import ROS2
from urdfctl.evidence import ROS1
from urdfctl.lint import Linted, Selection
from urdfctl.load import Loader, Target
from urdfctl.model.project import Project
from urdfctl.settings import Settings

PLAIN = '<robot name="r"><link name="a"/>{}</robot>'
ROS2_CONTROL = '<ros2_control name="c" type="system"/>'
TRANSMISSION = '<transmission name="t"/>'


def plugin(filename: str) -> str:
    return f'<gazebo><plugin name="p" filename="{filename}"/></gazebo>'


def manifest(text: str) -> str:
    return f"<package><name>r</name>{text}</package>"


def linted(folder: Folder, files: dict[str, str], settings: Settings = Settings()) -> Linted:  # noqa: B008 (immutable)
    folder.write(files)
    return Loader(settings, Selection()).lint(Target("r.urdf"))


@pytest.mark.parametrize(
    ("inside", "ros", "told_by"),
    [
        ("", None, None),
        (ROS2_CONTROL, 2, "<ros2_control>"),
        (TRANSMISSION, 1, "<transmission>"),
        (TRANSMISSION + ROS2_CONTROL, 2, "<ros2_control>"),
        (plugin("libgazebo_ros_control.so"), 1, "the plugin 'libgazebo_ros_control.so'"),
        (plugin("libgazebo_ros2_control.so"), 2, "the plugin 'libgazebo_ros2_control.so'"),
        (plugin("libgz_ros2_control-system.so"), 2, "the plugin 'libgz_ros2_control-system.so'"),
        (plugin("gz_ros2_control-system"), 2, "the plugin 'gz_ros2_control-system'"),
        (plugin("libign_ros2_control-system.so"), 2, "the plugin 'libign_ros2_control-system.so'"),
        (plugin("libgazebo_ros_camera.so"), None, None),
    ],
)
def test_the_robot_tells_the_generation(folder: Folder, inside: str, ros: int | None, told_by: str | None) -> None:
    found = linted(folder, {"r.urdf": PLAIN.format(inside)})
    assert (found.ros, found.distro, found.distro_from) == (ros, None, told_by)


@pytest.mark.parametrize(
    ("text", "ros"),
    [
        ("<buildtool_depend>catkin</buildtool_depend>", 1),
        ("<buildtool_depend>ament_cmake</buildtool_depend>", 2),
        ("<export><build_type>ament_python</build_type></export>", 2),
        ("<!-- <buildtool_depend>catkin</buildtool_depend> --><build_type>ament_cmake</build_type>", 2),
        ("<buildtool_depend>catkin</buildtool_depend><buildtool_depend>ament_cmake</buildtool_depend>", None),
        ("", None),
    ],
)
def test_the_manifest_tells_it_where_the_robot_does_not(folder: Folder, text: str, ros: int | None) -> None:
    found = linted(folder, {"r.urdf": PLAIN.format(""), "package.xml": manifest(text)})
    assert (found.ros, found.distro_from) == (ros, "package.xml" if ros else None)


def test_the_robot_is_believed_before_the_manifest_and_that_before_a_transmission(folder: Folder) -> None:
    catkin = manifest("<buildtool_depend>catkin</buildtool_depend>")
    assert linted(folder, {"r.urdf": PLAIN.format(ROS2_CONTROL), "package.xml": catkin}).ros == 2
    ament = manifest("<buildtool_depend>ament_cmake</buildtool_depend>")
    assert linted(folder, {"r.urdf": PLAIN.format(TRANSMISSION), "package.xml": ament}).ros == 2


@pytest.mark.parametrize(
    ("settings", "distro", "told_by"),
    [
        (Settings(distro="noetic", environ={"ROS_DISTRO": "jazzy"}), "noetic", "--distro"),
        (Settings(environ={"ROS_DISTRO": "melodic"}), "melodic", "$ROS_DISTRO"),
        (Settings(environ={"ROS_DISTRO": "unheard-of"}), None, "<ros2_control>"),
        (Settings(environ={"ROS_DISTRO": ""}), None, "<ros2_control>"),
    ],
)
def test_the_option_comes_before_the_environment_and_that_before_the_files(
    folder: Folder, settings: Settings, distro: str | None, told_by: str
) -> None:
    found = linted(folder, {"r.urdf": PLAIN.format(ROS2_CONTROL)}, settings)
    assert (found.distro, found.distro_from) == (distro, told_by)


def test_the_distro_names_the_generation(folder: Folder) -> None:
    assert {linted(folder, {"r.urdf": PLAIN.format("")}, Settings(distro=name)).ros for name in ROS1} == {1}
    assert {linted(folder, {"r.urdf": PLAIN.format("")}, Settings(distro=name)).ros for name in ROS2} == {2}


def test_the_simulator_is_the_one_that_the_user_names(folder: Folder) -> None:
    assert linted(folder, {"r.urdf": PLAIN.format("")}).simulator is None
    assert linted(folder, {"r.urdf": PLAIN.format("")}, Settings(simulator="gz")).simulator == "gz"


CONTROL = '<ros2_control name="c" type="system"><hardware><plugin>{}</plugin></hardware></ros2_control>'


@pytest.mark.parametrize(
    ("inside", "simulator"),
    [
        (plugin("libgazebo_ros_control.so"), "gazebo-classic"),
        (plugin("libgazebo_ros2_control.so"), "gazebo-classic"),
        (plugin("libgz_ros2_control-system.so"), "gz"),
        (plugin("ign_ros2_control-system"), "gz"),
        (CONTROL.format("gz_ros2_control/GazeboSimSystem"), "gz"),
        (CONTROL.format("mujoco_ros2_control/MujocoSystem"), "mujoco"),
        (CONTROL.format("mock_components/GenericSystem"), None),
        (CONTROL.format("gz_ros2_control/GazeboSimSystem") + plugin("libgazebo_ros2_control.so"), None),
        (plugin("libgazebo_ros_laser.so"), None),
    ],
)
def test_else_it_is_the_one_that_the_plugins_of_control_are_made_for(
    folder: Folder, inside: str, simulator: str | None
) -> None:
    files = {"r.urdf": PLAIN.format(inside)}
    assert linted(folder, files).simulator == simulator
    assert linted(folder, files, Settings(simulator="none")).simulator == "none"


def test_a_simulator_that_only_a_plugin_names_leaves_hardware_open() -> None:
    guessed = Project(None, simulator="gz", simulator_from="the plugin 'gz_ros2_control-system'")
    assert guessed.named_simulator is None
    for source in ("--simulator", "urdfctl.toml", "$URDFCTL_SIMULATOR"):
        assert guessed._replace(simulator_from=source).named_simulator == "gz"


def test_the_form_of_the_controllers_files_tells_the_generation(folder: Folder) -> None:
    folder.write(
        {
            "r.urdf": PLAIN.format(TRANSMISSION),
            "2.yaml": "controller_manager: {ros__parameters: {update_rate: 100}}",
            "1.yaml": "arm: {type: position_controllers/JointPositionController}",
        }
    )
    for name, ros, told_by in (("2.yaml", 2, "ros__parameters"), ("1.yaml", 1, "its controllers' types")):
        loader = Loader(Settings(), Selection())
        for target in (Target("r.urdf", controllers=(name,)), Target(name)):
            found = loader.lint(target)
            assert (found.ros, found.distro_from) == (ros, told_by)
    named = Loader(Settings(distro="jazzy"), Selection()).lint(Target("1.yaml"))
    assert (named.ros, named.distro, named.distro_from) == (2, "jazzy", "--distro")
