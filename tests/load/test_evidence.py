"""The distro is told by the user, else by the environment, else by what the files say."""

from __future__ import annotations

import os

import pytest
from folder import Folder

from urdfctl.catalog.distros import ROS2, since, until
from urdfctl.config.settings import Settings
from urdfctl.diagnostic import Severity
from urdfctl.lint.results import TargetResult
from urdfctl.lint.selection import Selection
from urdfctl.lint.target import lint_target
from urdfctl.load.loader import Loader
from urdfctl.load.origin.distro import weighed
from urdfctl.load.origin.evidence import EXPLICIT, ROS1
from urdfctl.load.target import Target
from urdfctl.model.project import Evidence, EvidenceItem, Project

PLAIN = '<robot name="r"><link name="a"/>{}</robot>'
ROS2_CONTROL = '<ros2_control name="c" type="system"/>'
TRANSMISSION = '<transmission name="t"/>'


def plugin(filename: str) -> str:
    return f'<gazebo><plugin name="p" filename="{filename}"/></gazebo>'


def manifest(text: str) -> str:
    return f"<package><name>r</name>{text}</package>"


def linted(folder: Folder, files: dict[str, str], settings: Settings = Settings()) -> TargetResult:  # noqa: B008 (immutable)
    folder.write(files)
    return lint_target(Loader(settings), Target("r.urdf"), Selection()).result


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


@pytest.mark.parametrize(("simulator", "is_read"), [(None, True), ("gz", True), ("none", False)])
def test_without_a_simulator_nothing_loads_the_controllers_that_its_plugin_names(
    folder: Folder, simulator: str | None, is_read: bool
) -> None:
    hosted = plugin("gz_ros2_control-system").replace("/></gazebo>", "><parameters>{}</parameters></plugin></gazebo>")
    broken = "controller_manager: {ros__parameters: {arm: {type: no_such/Type}}}\n"
    files = {"r.urdf": PLAIN.format(hosted.format(f"{folder.path}/own.yaml")), "own.yaml": broken}
    result = linted(folder, files, Settings("jazzy", simulator))
    assert any("no_such/Type" in one.message for one in result.outcome.diagnostics) is is_read


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
        loader = Loader(Settings())
        for target in (Target("r.urdf", controllers=(name,)), Target(name)):
            found = lint_target(loader, target, Selection()).result
            assert (found.ros, found.distro_from) == (ros, told_by)
    named = lint_target(Loader(Settings(distro="jazzy")), Target("1.yaml"), Selection()).result
    assert (named.ros, named.distro, named.distro_from) == (2, "jazzy", "--distro")


# -- the weight of evidence ------------------------------------------------------------------------------------------


def item(distros: tuple[str, ...], weight: int, kind: str = "a") -> EvidenceItem:
    return EvidenceItem(kind, f"{kind} {weight}", distros, weight)


def test_the_majority_decides_the_generation_and_the_first_item_a_tie() -> None:
    assert weighed([]).ros is None
    assert weighed([item(ROS1, 4), item(ROS2, 6, "b")]).ros == 2
    assert weighed([item(ROS1, 4), item(ROS2, 6, "b"), item(ROS1, 3, "c")]).ros == 1
    assert weighed([item(ROS1, 4), item(ROS1, 4), item(ROS2, 6, "b")]).ros == 2  # of one kind, the heaviest counts
    assert weighed([item(ROS1, 4), item(ROS2, 4, "b")]).ros == 1
    assert weighed([item(ROS2, 4), item(ROS1, 4, "b")]).source == "a 4"


def test_what_only_some_distros_have_narrows_the_candidates() -> None:
    assert weighed([item(ROS2, 6), item(("humble", "jazzy"), 2, "b")]).distros == ("humble", "jazzy")
    assert weighed([item(ROS2, 6), item(("humble", "jazzy"), 2, "b"), item(("humble",), 2, "c")]).distro == "humble"
    one_against_two = [item(("jazzy",), 2, "a"), item(("humble",), 2, "b"), item(("humble",), 2, "c")]
    assert weighed(one_against_two).distros == ("humble",)
    assert weighed([item(ROS2, 6), item(("foxy",), 2, "b")]).distros == ROS2, "more likely a fault"
    assert weighed([item(ROS2, 6), item(("foxy",), EXPLICIT, "b")]).distros == ("foxy",)


ROS1_ROBOT = PLAIN.format(plugin("libgazebo_ros_control.so") + TRANSMISSION)
AMENT = manifest("<buildtool_depend>ament_cmake</buildtool_depend>")


def test_one_plugin_of_the_other_generation_is_the_fault_and_does_not_flip_the_package(folder: Folder) -> None:
    found = linted(folder, {"r.urdf": ROS1_ROBOT, "package.xml": AMENT})
    assert (found.ros, found.distro_from) == (2, "package.xml")
    [finding] = [one for one in found.outcome.diagnostics if one.code == "UC504"]
    assert finding.message == "'libgazebo_ros_control.so' is not available in ROS 2, only in ROS 1"
    assert finding.severity is Severity.WARNING  # nothing says that the robot is controlled at all


def evidence(folder: Folder, files: dict[str, str], **target: tuple[str, ...] | str) -> Evidence:
    folder.write(files)
    given = {"controllers": (), "launch": None, **target}
    found = (
        Loader(Settings())
        .load(Target("r.urdf", controllers=given["controllers"], launch=given["launch"]))
        .project.evidence
    )
    assert found is not None
    return found


@pytest.mark.parametrize(
    ("files", "ros", "distros"),
    [
        ({"package.xml": manifest("<exec_depend>ros_gz_sim</exec_depend>")}, 2, since("humble")),
        ({"package.xml": manifest("<exec_depend>ign_ros2_control</exec_depend>")}, 2, until("jazzy")),
        ({"package.xml": manifest("<run_depend>roscpp</run_depend>")}, 1, ROS1),
        ({"package.xml": manifest('<depend condition="$ROS_VERSION == 1">roscpp</depend>')}, None, (*ROS1, *ROS2)),
        ({"package.xml": manifest(""), "CMakeLists.txt": "find_package(ament_cmake REQUIRED)"}, 2, ROS2),
        ({"package.xml": manifest(""), "CMakeLists.txt": "# find_package(catkin)"}, None, (*ROS1, *ROS2)),
        ({"package.xml": manifest(""), "launch/a.launch.py": ""}, 2, ROS2),
        ({"package.xml": manifest(""), "launch/a.launch": ""}, 1, ROS1),
    ],
)
def test_the_package_indicates_generation_and_distro(
    folder: Folder, files: dict[str, str], ros: int | None, distros: tuple[str, ...]
) -> None:
    found = evidence(folder, {"r.urdf": PLAIN.format(""), **files})
    assert (found.ros, found.distros) == (ros, distros)


def test_hardware_plugins_controller_types_and_spawner_options_narrow_the_distro(folder: Folder) -> None:
    mock = CONTROL.format("mock_components/GenericSystem")
    assert evidence(folder, {"r.urdf": PLAIN.format(mock)}).distros == since("humble")
    yaml = "controller_manager: {ros__parameters: {a: {type: gpio_controllers/GpioCommandController}}}"
    files = {"r.urdf": PLAIN.format(ROS2_CONTROL), "c.yaml": yaml}
    assert evidence(folder, files, controllers=("c.yaml",)).distros == ("humble", *since("jazzy"))
    launch = """<launch>
        <node pkg="controller_manager" exec="spawner" args="a --switch-asap"/>
        <node pkg="robot_state_publisher" exec="robot_state_publisher" namespace=""/>
    </launch>"""
    files = {"r.urdf": PLAIN.format(ROS2_CONTROL), "l.launch.xml": launch}
    assert evidence(folder, files, launch="l.launch.xml").distros == since("jazzy")


def test_the_header_of_a_generated_file_names_the_distro(folder: Folder) -> None:
    header = "<!-- made by urdfctl gen-gazebo robot.xacro --distro kilted -->"
    found = evidence(folder, {"r.urdf": header + PLAIN.format(ROS2_CONTROL)})
    assert (found.distro, found.distros) == ("kilted", ("kilted",))


def test_evidence_is_a_list_of_items_with_what_was_outweighed(folder: Folder) -> None:
    found = evidence(folder, {"r.urdf": ROS1_ROBOT, "package.xml": AMENT})
    assert [(one.what, one.ros, one.weight, one.file and os.path.basename(one.file)) for one in found.items] == [
        ("the plugin 'libgazebo_ros_control.so'", 1, 4, None),
        ("<transmission>", 1, 1, None),
        ("package.xml", 2, 6, "package.xml"),
    ]


def test_a_run_names_the_open_distro_once_before_its_summary(folder: Folder) -> None:
    folder.write({"r.urdf": PLAIN.format(ROS2_CONTROL), "plain.urdf": PLAIN.format("")})
    line = "ROS distro unknown (foxy to rolling): add --distro NAME"
    shown = folder.run("lint", "r.urdf").stdout
    assert shown.splitlines()[-2].startswith(line)
    assert shown.count(line) == 1
    assert line not in folder.run("lint", "r.urdf", "--distro", "jazzy").stdout
    assert "ROS distro unknown" not in folder.run("lint", "plain.urdf").stdout


NEW_PIPELINE = "planning_plugins: [ompl_interface/OMPLPlanner]\nrequest_adapters: [a/B]\n"
OLD_PIPELINE = "planning_plugin: ompl_interface/OMPLPlanner\nrequest_adapters: a/B\n"


@pytest.mark.parametrize(
    ("pipelines", "library", "distros"),
    [
        ([NEW_PIPELINE], "", since("jazzy")),
        ([OLD_PIPELINE], "", tuple(distro for distro in until("iron") if distro in ROS2)),
        ([NEW_PIPELINE], "libgazebo_ros_p3d.so", ROS2),
        ([NEW_PIPELINE, OLD_PIPELINE], "", ROS2),
        ([NEW_PIPELINE + OLD_PIPELINE], "", ROS2),
    ],
)
def test_the_form_of_planning_pipelines_tells_the_distro_and_is_no_fault_where_others_tell_another(
    folder: Folder, pipelines: list[str], library: str, distros: tuple[str, ...]
) -> None:
    files = {f"config/p{number}_planning.yaml": text for number, text in enumerate(pipelines)}
    robot = PLAIN.format(plugin(library) if library else "")
    files |= {"config/r.urdf": robot, "config/r.srdf": '<robot name="r"/>', "config/moveit_controllers.yaml": ""}
    folder.write({**files, "package.xml": manifest("<buildtool_depend>ament_cmake</buildtool_depend>")})
    found = lint_target(Loader(Settings()), Target("config/r.urdf"), Selection()).result
    assert (found.ros, found.distros) == (2, distros)
    assert "UC670" not in {finding.code for finding in found.outcome.diagnostics}


@pytest.mark.parametrize(("package", "distros", "codes"), [("moveit_ros_planning", ROS2, []), ("own", None, ["UC670"])])
def test_the_form_of_planning_pipelines_is_that_of_moveit_in_the_workspace(
    folder: Folder, package: str, distros: tuple[str, ...] | None, codes: list[str]
) -> None:
    ament = "<buildtool_depend>ament_cmake</buildtool_depend>"
    folder.write({"src/r/r.urdf": PLAIN.format(""), "src/r/r.srdf": '<robot name="r"/>', ".git/HEAD": ""})
    folder.write({"src/r/moveit_controllers.yaml": "", "src/r/ompl_planning.yaml": NEW_PIPELINE})
    folder.write({"src/r/package.xml": manifest(ament)})
    folder.write({"src/m/package.xml": manifest(ament).replace("<name>r<", f"<name>{package}<")})
    found = lint_target(Loader(Settings()), Target("src/r/r.urdf"), Selection()).result
    assert found.distros == (distros or since("jazzy"))
    found = lint_target(Loader(Settings(distro="humble")), Target("src/r/r.urdf"), Selection()).result
    assert sorted({finding.code for finding in found.outcome.diagnostics} & {"UC670"}) == codes
