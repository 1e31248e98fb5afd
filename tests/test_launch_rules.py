"""The rules on launch files, on whole small packages; Python, XML and YAML, of ROS 1 and ROS 2."""

from __future__ import annotations

from collections.abc import Mapping
from textwrap import dedent

import pytest
import robots
from folder import Folder

from urdfctl.rules import launch_samples as samples
from urdfctl.rules.examples import completed
from urdfctl.rules.launch_samples import (
    ARM,
    BROADCASTER,
    CONTROLLERS,
    FILE,
    MANAGER,
    MANIFEST,
    PUBLISHER,
    launched,
    spawner,
)

ALL = ("UC6",)


def found(
    folder: Folder, files: Mapping[str, str], *codes: str, distro: str | None = None, path: str | None = None
) -> list[tuple[str, str, str]]:
    """Return code, severity and message of the findings in the first file and its companions, in order of codes."""
    folder.write({name: completed(name, dedent(text).strip("\n") + "\n") for name, text in files.items()})
    findings = robots.findings(path or next(iter(files)), codes or ALL, workspace=str(folder.path), distro=distro)
    findings.sort(key=lambda finding: (finding.code, finding.order))
    return [(finding.code, finding.severity.value, finding.message) for finding in findings]


def ros1(*nodes: str, controllers: str = "", robot: str = "") -> dict[str, str]:
    """A package of ROS 1 with a launch file of some nodes, which loads controllers."""
    load = '<rosparam file="$(find arm)/controllers.yaml" command="load"/>' if controllers else ""
    return {
        "arm.launch": f"""
            <launch>
              <param name="robot_description" textfile="$(find arm)/arm.urdf"/>
              {load}
              {"".join(nodes)}
            </launch>
        """,
        "arm.urdf": robot,
        "package.xml": "<package><name>arm</name></package>",
        **({"controllers.yaml": controllers} if controllers else {}),
    }


def test_the_sound_package_is_silent_by_all_rules_for_each_distro(folder: Folder) -> None:
    for distro in ("humble", "jazzy", "rolling"):
        assert found(folder, samples.SOUND, "UC", distro=distro) == []


# -- what is spawned -------------------------------------------------------------------------------------------------


def test_a_controller_is_looked_for_in_the_namespace_of_its_manager(folder: Folder) -> None:
    there = [part.replace("<node ", '<node namespace="left" ') for part in (MANAGER, ARM)]
    files = launched(PUBLISHER, *there)
    assert found(folder, files, "UC601") == [
        ("UC601", "error", "controller 'arm_controller' is spawned in namespace '/left', but declared in '/'"),
    ]
    anywhere = CONTROLLERS.replace("    controller_manager:", "    /**/controller_manager:")
    assert found(folder, launched(PUBLISHER, *there, controllers=anywhere), "UC601") == []


def test_of_a_name_that_is_like_no_other_the_declared_ones_are_told(folder: Folder) -> None:
    assert found(folder, launched(MANAGER, spawner(f"gripper {FILE}")), "UC601") == [
        (
            "UC601",
            "error",
            (
                "controller 'gripper' is spawned, but no file declares it; "
                "declared: 'arm_controller' and 'joint_state_broadcaster'"
            ),
        ),
    ]


@pytest.mark.parametrize(
    "nodes",
    [
        (spawner("gripper"),),
        (MANAGER, spawner("gripper -t p/Gripper")),
        (MANAGER.replace("</node>", '<param name="gripper.type" value="p/Gripper"/></node>'), spawner("gripper")),
        (MANAGER, '<include file="$(env NOWHERE)"/>', spawner("gripper")),
        (MANAGER.replace("controllers.yaml", "other.yaml"), spawner("gripper")),
    ],
    ids=["no manager", "its type is given", "the manager is told", "something included", "a file that is not there"],
)
def test_nothing_is_said_of_controllers_that_something_else_may_declare(folder: Folder, nodes: tuple[str, ...]) -> None:
    assert found(folder, launched(*nodes), "UC601") == []


def test_of_ros_1_what_a_launch_file_loads_is_all_there_is(folder: Folder) -> None:
    node = '<node name="s" pkg="controller_manager" type="spawner" args="{}"/>'
    controllers = "arm: {type: position_controllers/JointPositionController, joint: elbow}"
    assert found(folder, ros1(node.format("hand"), controllers=controllers), "UC601") == [
        ("UC601", "warning", "controller 'hand' is spawned, but no file declares it; declared: 'arm'"),
    ]
    assert found(folder, ros1(node.format("arm"), controllers=controllers), "UC601") == []
    both = [("UC601", "warning", "controller 'arms' is spawned, but no file declares it; declared: 'arm'")]
    assert found(folder, ros1(node.format("arms arm"), controllers=controllers), "UC601") == both


@pytest.mark.parametrize(
    ("more", "severity"),
    [
        ((MANAGER,), "info"),
        ((MANAGER, '<include file="$(find-pkg-share ros_gz_sim)/launch/gz_sim.launch.py"/>'), "error"),
        ((), "warning"),
    ],
)
def test_gazebo_loses_no_link_of_a_robot_that_a_launch_file_starts_without_it(
    folder: Folder, more: tuple[str, ...], severity: str
) -> None:
    tool = '<link name="tool"/><joint name="wrist" type="continuous"><parent link="fore"/><child link="tool"/></joint>'
    files = launched(PUBLISHER, *more, robot=samples.ROBOT + tool)
    assert [one[1] for one in found(folder, files, "UC133")] == [severity]


def test_a_spawner_that_only_other_arguments_start_makes_a_warning(folder: Folder) -> None:
    sometimes = spawner("gripper").replace("<node ", '<node if="$(env WHAT)" ')
    assert [one[1] for one in found(folder, launched(MANAGER, sometimes), "UC601")] == ["warning"]


def test_what_a_command_loads_and_then_activates_is_not_spawned_twice(folder: Folder) -> None:
    command = '<executable cmd="ros2 control set_controller_state arm_controller active"/>'
    assert found(folder, launched(MANAGER, ARM, command), "UC602") == []
    unknown = ARM.replace("<node ", '<node namespace="$(env WHERE)" ')
    assert found(folder, launched(MANAGER, unknown, ARM), "UC602") == []


def test_controllers_that_are_alternatives_are_told_of_in_one_finding(folder: Folder) -> None:
    gripper = "        gripper:\n          type: p/Gripper\n        arm_controller:"
    more = CONTROLLERS.replace("        arm_controller:", gripper, 1)
    nodes = (PUBLISHER, MANAGER, spawner("joint_state_broadcaster"))
    assert found(folder, launched(*nodes, controllers=more), "UC603") == [
        (
            "UC603",
            "info",
            "controllers 'gripper' and 'arm_controller' are configured but not spawned by the launch file",
        ),
    ]
    slip = spawner("grippr")
    assert [one[2] for one in found(folder, launched(*nodes, slip, controllers=more), "UC603")] == [
        "controller 'arm_controller' is configured but not spawned by the launch file"
    ]
    elsewhere = spawner("gripper arm_controller").replace("<node ", '<node if="false" ')
    assert found(folder, launched(*nodes, elsewhere, controllers=more), "UC603") == []


# -- the states of joints --------------------------------------------------------------------------------------------


@pytest.mark.parametrize(
    "inside",
    [
        '<param name="source_list" value="x"/>',
        '<remap from="joint_states" to="other"/>',
        '<param from="$(env FILE)"/>',
    ],
)
def test_joint_state_publisher_may_be_told_to_publish_something_else(folder: Folder, inside: str) -> None:
    node = f'<node pkg="joint_state_publisher" exec="joint_state_publisher">{inside}</node>'
    assert found(folder, launched(MANAGER, BROADCASTER, ARM, node), "UC604") == []
    assert found(folder, launched(MANAGER, spawner("joint_state_broadcaster --inactive"), node), "UC604") == []


@pytest.mark.parametrize("distro", ["noetic", "jazzy"])
def test_a_launch_file_of_the_other_generation_is_not_judged(folder: Folder, distro: str) -> None:
    node = '<node name="s" pkg="controller_manager" type="spawner" args="--stopped arm"/>'
    files = ros1(node, robot='<gazebo><plugin name="c" filename="libgazebo_ros_control.so"/></gazebo>')
    if distro == "noetic":
        files = launched(PUBLISHER, spawner("--stopped arm_controller", "spawner.py"))
    codes = ("UC605", "UC606", "UC607", "UC608", "UC609", "UC610", "UC611", "UC612", "UC613")
    assert found(folder, files, *codes, distro=distro) == []


# -- managers --------------------------------------------------------------------------------------------------------

CONTROL = """
    <gazebo>
      <plugin filename="gz_ros2_control-system" name="gz_ros2_control::GazeboSimROS2ControlPlugin">
        <parameters>$(find arm)/controllers.yaml</parameters>
        {}
      </plugin>
    </gazebo>
"""


@pytest.mark.parametrize(
    "other",
    [
        '<node pkg="arm_driver" exec="driver"/>',
        '<executable cmd="gz sim -r empty.sdf"/>',
        '<include file="$(env NOWHERE)"/>',
    ],
    ids=["a driver", "a simulator", "something included"],
)
def test_a_manager_may_run_in_what_is_not_known(folder: Folder, other: str) -> None:
    assert found(folder, launched(PUBLISHER, ARM, other), "UC605", "UC606") == []
    strange = spawner(f"arm_controller -c /left/controller_manager {FILE}")
    if "gz" not in other:
        assert found(folder, launched(PUBLISHER, MANAGER, strange, other), "UC606") == []


def test_without_the_robot_the_spawner_may_be_for_any(folder: Folder) -> None:
    assert found(folder, launched(ARM), "UC605") == []
    command = '<executable cmd="ros2 control load_controller arm_controller"/>'
    assert found(folder, launched(PUBLISHER, command), "UC605") == []


def test_the_manager_of_a_simulator_s_plugin_runs_where_the_plugin_says(folder: Folder) -> None:
    robot = samples.ROBOT.replace("mock_components/GenericSystem", "gz_ros2_control/GazeboSimSystem")
    left = CONTROL.format("<ros><namespace>left</namespace></ros>")
    gz = '<executable cmd="gz sim -r empty.sdf"/>'
    files = {**launched(PUBLISHER, gz, ARM, robot=robot + left)}
    message = (
        "the spawner contacts '/controller_manager', but the running controller manager is '/left/controller_manager'"
    )
    assert found(folder, files, "UC605", "UC606") == [("UC606", "error", message)]
    asked = spawner(f"arm_controller -c /left/controller_manager {FILE}")
    assert found(folder, launched(PUBLISHER, gz, asked, robot=robot + left), "UC606") == []
    placed = '<node pkg="gazebo_ros" exec="spawn_entity.py" args="-entity arm -robot_namespace left"/>'
    assert found(folder, launched(PUBLISHER, gz, placed, ARM, robot=robot + left), "UC606") == []
    ros1 = '<gazebo><plugin filename="libgazebo_ros_control.so" name="p"/></gazebo>'
    assert found(folder, launched(PUBLISHER, MANAGER, ARM, robot=samples.ROBOT + ros1), "UC606") == []


def test_a_second_manager_in_another_namespace_is_for_another_robot(folder: Folder) -> None:
    robot = samples.ROBOT.replace("mock_components/GenericSystem", "gz_ros2_control/GazeboSimSystem")
    manager = MANAGER.replace("<node ", '<node namespace="left" ')
    assert found(folder, launched(PUBLISHER, manager, robot=robot), "UC607") == []
    assert [one[1] for one in found(folder, launched(PUBLISHER, MANAGER, robot=robot), "UC607")] == ["error"]


# -- the spawner's program and options -------------------------------------------------------------------------------


@pytest.mark.parametrize(
    ("distro", "severity"), [(None, ["warning"]), ("humble", ["error"]), ("galactic", []), ("foxy", [])]
)
def test_spawner_py_is_told_of_by_distro(folder: Folder, distro: str | None, severity: list[str]) -> None:
    files = launched(MANAGER, spawner("arm_controller", "spawner.py"))
    assert [one[1] for one in found(folder, files, "UC608", distro=distro)] == severity


def test_the_unspawner_and_the_verbs_of_foxy_are_called_otherwise_too(folder: Folder) -> None:
    verb = '<executable cmd="ros2 control load_start_controller arm_controller"/>'
    files = launched(MANAGER, spawner("arm_controller", "unspawner.py"), verb)
    assert [one[2] for one in found(folder, files, "UC608", distro="jazzy")] == [
        "'unspawner.py' does not exist in humble and later; use 'unspawner'",
        "'load_start_controller' does not exist in galactic and later; use 'load_controller --set-state active'",
    ]


@pytest.mark.parametrize(
    ("args", "distro", "expected"),
    [
        ("--stopped", "jazzy", [("error", "the spawner has no option '--stopped'; use '--inactive'")]),
        ("--stopped", "humble", []),
        ("--inactive", None, []),
        ("--inactive", "foxy", [("error", "the spawner has no option '--inactive'")]),
        ("--controller-manager-time 5", "jazzy", []),
        ("--wait", "jazzy", [("error", "the spawner has no option '--wait'")]),
        ("--load-onyl", "jazzy", [("error", "the spawner has no option '--load-onyl'; did you mean '--load-only'?")]),
        (
            "-t p/T",
            None,
            [
                (
                    "warning",
                    "the spawner has no option '-t' in kilted to rolling; set the type in the parameter file",
                )
            ],
        ),
        ("--ros-args -r __ns:=/left", "jazzy", []),
    ],
)
def test_options_are_those_of_the_distro(
    folder: Folder, args: str, distro: str | None, expected: list[tuple[str, str]]
) -> None:
    files = launched(MANAGER, spawner(f"arm_controller {args}"))
    assert [one[1:] for one in found(folder, files, "UC609", distro=distro)] == expected


@pytest.mark.parametrize(("distro", "severity"), [(None, "info"), ("kilted", "warning"), ("rolling", "error")])
def test_parameters_reach_a_controller_by_its_spawner(folder: Folder, distro: str | None, severity: str) -> None:
    files = launched(MANAGER, BROADCASTER, spawner("arm_controller"))
    assert [one[1] for one in found(folder, files, "UC610", distro=distro)] == [severity]
    told = spawner("arm_controller --controller-ros-args '--params-file x.yaml'")
    assert found(folder, launched(MANAGER, told), "UC610", distro=distro) == []
    named = CONTROLLERS.replace("TrajectoryController\n", "TrajectoryController\n          params_file: x.yaml\n")
    assert found(folder, launched(MANAGER, spawner("arm_controller"), controllers=named), "UC610") == []


# -- descriptions ----------------------------------------------------------------------------------------------------

BARE = MANAGER.replace('<remap from="~/robot_description" to="/robot_description"/>', "")


@pytest.mark.parametrize(
    ("publisher", "manager", "distro", "expected"),
    [
        (PUBLISHER, BARE, "jazzy", []),
        (
            "",
            BARE,
            "jazzy",
            [
                (
                    "warning",
                    "no node in the launch file publishes '/robot_description', which the controller manager waits for",
                )
            ],
        ),
        (
            PUBLISHER,
            BARE,
            "humble",
            [
                (
                    "error",
                    "the controller manager gets no robot description, neither as a parameter nor through a remapping",
                )
            ],
        ),
        (PUBLISHER, MANAGER, "humble", []),
        (PUBLISHER, BARE.replace("</node>", '<param name="robot_description" value="x"/></node>'), "humble", []),
        (PUBLISHER, BARE.replace("</node>", '<remap from="robot_description" to="/d"/></node>'), None, []),
        (PUBLISHER, BARE.replace("<node ", '<node namespace="$(env WHERE)" '), "jazzy", []),
        (
            PUBLISHER,
            BARE.replace("</node>", '<remap from="robot_description" to="/d"/></node>'),
            "humble",
            [
                (
                    "error",
                    "the controller manager gets no robot description, neither as a parameter nor through a remapping",
                )
            ],
        ),
    ],
)
def test_the_manager_needs_a_description(
    folder: Folder, publisher: str, manager: str, distro: str | None, expected: list[tuple[str, str]]
) -> None:
    files = launched(publisher, manager)
    assert [one[1:] for one in found(folder, files, "UC611", distro=distro)] == expected


def test_a_publisher_that_something_unknown_is_given_may_publish_anything(folder: Folder) -> None:
    publisher = PUBLISHER.replace("<node ", '<node if="$(env WHAT)" namespace="left" ')
    assert [one[1] for one in found(folder, launched(publisher, BARE), "UC611", distro="jazzy")] == ["warning"]
    nowhere = '<include file="$(env NOWHERE)"/>'
    assert found(folder, launched(BARE, nowhere), "UC611", distro="jazzy") == []
    everywhere = '<set_remap from="robot_description" to="x"/>'
    assert found(folder, launched(everywhere, PUBLISHER, BARE), "UC611", distro="humble") == []


def test_a_simulation_that_runs_or_is_waited_for_longer_is_right(folder: Folder) -> None:
    gz = '<executable cmd="gz sim {} empty.sdf"/>'
    assert found(folder, launched(gz.format("-r"), ARM), "UC612") == []
    patient = spawner(f"arm_controller --switch-timeout 60 {FILE}")
    assert found(folder, launched(gz.format(""), patient), "UC612") == []
    assert [one[0] for one in found(folder, launched(gz.format("-v4"), ARM), "UC612")] == ["UC612"]


def test_the_simulated_robot_s_description_is_looked_for_upwards(folder: Folder) -> None:
    plugin = '<gazebo><plugin name="c" filename="libgazebo_ros_control.so">{}</plugin></gazebo>'
    there = plugin.format("<robotNamespace>/arm</robotNamespace>")
    assert found(folder, ros1(robot=there), "UC613") == []
    assert found(folder, ros1(robot=plugin.format("")), "UC613") == []
    below = {**ros1(robot=plugin.format("<robotNamespace>/</robotNamespace>"))}
    below["arm.launch"] = (
        below["arm.launch"].replace("<param ", '<group ns="x"><param ').replace('urdf"/>', 'urdf"/></group>')
    )
    assert [one[2] for one in found(folder, below, "UC613")] == [
        "the robot description is in '/x', but the controller manager looks for it in '/'",
    ]
    below["arm.launch"] = below["arm.launch"].replace("<group", '<include file="$(env NOWHERE)"/><group')
    assert found(folder, below, "UC613") == []


# -- packages --------------------------------------------------------------------------------------------------------


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
        ("CMakeLists.txt", "project(arm)\ninstall(FILES controllers.yaml arm.urdf DESTINATION share/arm)", False),
        ("CMakeLists.txt", "foreach(d launch)\ninstall(DIRECTORY ${d} DESTINATION share/arm)\nendforeach()", True),
        ("CMakeLists.txt", "foreach(d ${all})\ninstall(DIRECTORY ${d} DESTINATION share/arm)\nendforeach()", False),
        ("CMakeLists.txt", "install(DIRECTORY ${FOLDERS} DESTINATION share/arm)", False),
        ("CMakeLists.txt", "ament_auto_package(INSTALL_TO_SHARE config)", False),
        ("setup.py", SETUP.format(""), True),
        ("setup.py", SETUP.format("(os.path.join('share', package_name), glob('*.yaml') + ['arm.urdf'])"), False),
        ("setup.py", SETUP.format("(os.path.join('share', package_name), ['controllers.yaml', 'arm.urdf'])"), False),
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


def test_a_file_that_only_rviz_misses_makes_a_warning(folder: Folder) -> None:
    manifest = MANIFEST.replace("</package>", "<export><build_type>ament_cmake</build_type></export></package>")
    rviz = '<node pkg="rviz2" exec="rviz2" args="-d $(find-pkg-share arm)/view.rviz"/></launch>'
    to = "DESTINATION share/arm)"
    install = f"install(DIRECTORY launch {to}\ninstall(FILES controllers.yaml arm.urdf {to}"
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
    }


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
    message = "launch file uses package 'gz_ros2_control', but package.xml has no <exec_depend> for it"
    assert found(folder, files, "UC614", distro="jazzy") == [("UC614", "info", message)]
    declared = MANIFEST.replace("</package>", "  <exec_depend>gz_ros2_control</exec_depend>\n</package>")
    assert found(folder, {**files, "package.xml": declared}, "UC614", distro="jazzy") == []
    mocked = {**samples.SOUND, "package.xml": MANIFEST}
    assert found(folder, mocked, "UC614", distro="jazzy") == []


# -- arguments of the description ------------------------------------------------------------------------------------


def test_an_argument_that_the_description_does_not_declare_is_reported_where_the_launch_file_gives_it(
    folder: Folder,
) -> None:
    robot = """
        <robot name="arm" xmlns:xacro="http://www.ros.org/wiki/xacro">
          <xacro:arg name="prefix" default=""/>
          <link name="$(arg prefix)base"/>
        </robot>
    """
    command = "$(find xacro)/xacro $(find arm)/arm.xacro prefx:=$(arg side)"
    in_ros1 = f"""
        <launch>
          <arg name="side" default="left_"/>
          <param name="robot_description" command="{command}"/>
        </launch>
    """
    in_ros2 = """
        import os
        from ament_index_python.packages import get_package_share_directory
        from launch import LaunchDescription
        from launch.substitutions import Command
        from launch_ros.actions import Node

        def generate_launch_description():
            path = os.path.join(get_package_share_directory("arm"), "arm.xacro")
            text = Command(["xacro ", path, " prefx:=", "left_"])
            node = Node(package="robot_state_publisher", executable="robot_state_publisher",
                        parameters=[{"robot_description": text}])
            return LaunchDescription([node])
    """
    for name, text in (("arm.launch", in_ros1), ("arm.launch.py", in_ros2)):
        files = {name: text, "arm.xacro": robot, "package.xml": "<package><name>arm</name></package>"}
        folder.write({file: dedent(content).strip("\n") + "\n" for file, content in files.items()})
        [one] = robots.findings(name, ("UC021",), workspace=str(folder.path))
        assert (
            one.message == "argument 'prefx' is given, but the description does not declare it; did you mean 'prefix'?"
        )
        assert (folder.path / name).read_bytes()[one.at.start : one.at.end].decode().strip(' "').startswith("prefx:=")
        assert [note.at.file for note in one.notes if note.at] == [str(folder.path / "arm.xacro")]
