"""What a migration from ROS 1 makes of a package of MoveIt's Setup Assistant."""

from __future__ import annotations

import pytest
from folder import Folder
from ros1_packages import EFFORT, MANIFEST, PLUGIN, arm, transmission

SRDF = '<robot name="arm">\n  <group name="all"><joint name="shoulder"/></group>\n</robot>\n'
KINEMATICS = "all:\n  kinematics_solver: kdl_kinematics_plugin/KDLKinematicsPlugin\n"
LIST = """\
controller_list:
  - name: arm/ctl
    action_ns: follow_joint_trajectory
    type: FollowJointTrajectory
    default: True
    joints:
      - shoulder
"""
PIPELINE = """\
<launch>
  <arg name="planning_plugin" value="ompl_interface/OMPLPlanner"/>
  <arg name="planning_adapters" default="default_planner_request_adapters/FixWorkspaceBounds
    default_planner_request_adapters/AddTimeParameterization"/>
  <param name="planning_plugin" value="$(arg planning_plugin)"/>
  <param name="request_adapters" value="$(arg planning_adapters)"/>
  <param name="start_state_max_bounds_error" value="$(arg unknown)"/>
  <rosparam command="load" file="$(find arm_moveit)/config/ompl_planning.yaml"/>
</launch>
"""
OMPL = "# the planners\nplanner_configs:\n  RRT:\n    type: geometric::RRT\n"
EXECUTION = '<launch>\n  <param name="trajectory_execution/allowed_goal_duration_margin" value="1"/>\n</launch>\n'


def migrated(folder: Folder, files: dict[str, str], target: str = "humble", *, mark: bool = True) -> dict[str, str]:
    """The files of a package of MoveIt after its migration from noetic, with the package of its robot.

    mark: whether the package has the hidden file of the Setup Assistant.
    """
    of_assistant = {"src/moveit/.setup_assistant": "moveit_setup_assistant_config:\n  URDF: {package: arm}\n"}
    folder.write(
        {
            "src/arm/package.xml": MANIFEST,
            "src/arm/urdf/arm.xacro": arm(transmission("EffortJointInterface")),
            "src/moveit/package.xml": MANIFEST.replace("<name>arm<", "<name>arm_moveit<"),
            "src/moveit/CMakeLists.txt": "project(arm_moveit)\nfind_package(catkin REQUIRED)\ncatkin_package()\n",
            **(of_assistant if mark else {}),
            "src/moveit/config/arm.srdf": SRDF,
            "src/moveit/config/kinematics.yaml": KINEMATICS,
            "src/moveit/config/joint_limits.yaml": "joint_limits: {}\n",
            **{f"src/moveit/{name}": text for name, text in files.items()},
        }
    )
    words = ("--from", "noetic", "--to", target, "--simulator", "none", "-o", "new", "--force")
    ran = folder.run("migrate", "src", *words)
    assert ran.returncode == 0, ran.stderr
    new = folder.path / "new" / "moveit"
    return {path.relative_to(new).as_posix(): path.read_text() for path in new.rglob("*") if path.is_file()}


def test_the_list_of_controllers_becomes_a_map_by_name(folder: Folder) -> None:
    after = migrated(folder, {"config/simple.yaml": LIST, "launch/trajectory_execution.launch.xml": EXECUTION})
    assert "config/simple.yaml" not in after
    assert (
        after["config/moveit_controllers.yaml"]
        == """\
moveit_controller_manager: moveit_simple_controller_manager/MoveItSimpleControllerManager

trajectory_execution:
  allowed_goal_duration_margin: 1.0

moveit_simple_controller_manager:
  controller_names:
    - arm/ctl

  arm/ctl:
    action_ns: follow_joint_trajectory
    type: FollowJointTrajectory
    default: True
    joints:
      - shoulder
"""
    )


def test_the_other_content_of_the_file_with_the_list_stays(folder: Folder) -> None:
    ctl = "ctl:\n  type: effort_controllers/JointEffortController\n  joint: shoulder\n"
    after = migrated(folder, {"config/ros_controllers.yaml": ctl + LIST})
    assert "controller_list" not in after["config/ros_controllers.yaml"]
    assert "forward_command_controller/ForwardCommandController" in after["config/ros_controllers.yaml"]
    assert "- arm/ctl" in after["config/moveit_controllers.yaml"]


@pytest.mark.parametrize(
    ("target", "lines"),
    [
        (
            "humble",
            """\
planning_plugin: ompl_interface/OMPLPlanner
request_adapters: >-
  default_planner_request_adapters/FixWorkspaceBounds
  default_planner_request_adapters/AddTimeParameterization
""",
        ),
        (
            "jazzy",
            """\
planning_plugins:
  - ompl_interface/OMPLPlanner
request_adapters:
  - default_planning_request_adapters/ValidateWorkspaceBounds
response_adapters:
  - default_planning_response_adapters/AddTimeOptimalParameterization
""",
        ),
    ],
)
def test_a_planning_pipeline_names_its_plugin_and_adapters(folder: Folder, target: str, lines: str) -> None:
    files = {"launch/ompl_planning_pipeline.launch.xml": PIPELINE, "config/ompl_planning.yaml": OMPL}
    after = migrated(folder, files, target)
    head, tail = OMPL.split("\n", 1)
    assert after["config/ompl_planning.yaml"].startswith(f"{head}\n{lines}")
    assert after["config/ompl_planning.yaml"].endswith(tail)
    assert "launch/ompl_planning_pipeline.launch.xml" not in after


def test_limits_of_joints_are_doubles(folder: Folder) -> None:
    limits = "joint_limits:\n  shoulder:\n    has_velocity_limits: true\n    max_velocity: 2  # rad/s\n"
    after = migrated(folder, {"config/joint_limits.yaml": limits})
    assert after["config/joint_limits.yaml"] == limits.replace("2  #", "2.0  #")


def test_the_launch_files_are_made_by_moveit_and_find_their_description(folder: Folder) -> None:
    launch = '<launch>\n  <node pkg="moveit_ros_move_group" type="move_group" name="move_group"/>\n</launch>\n'
    after = migrated(folder, {"launch/move_group.launch": launch})
    assert (
        after["launch/move_group.launch.py"]
        == """\
from moveit_configs_utils import MoveItConfigsBuilder
from moveit_configs_utils.launches import generate_move_group_launch


def generate_launch_description():
    moveit_config = (
        MoveItConfigsBuilder("arm", package_name="arm_moveit")
        .planning_pipelines(pipelines=["ompl"])
        .to_moveit_configs()
    )
    return generate_move_group_launch(moveit_config)
"""
    )
    assert "launch/move_group.launch" not in after
    assert "install(FILES .setup_assistant DESTINATION share/${PROJECT_NAME})" in after["CMakeLists.txt"]
    assert "<exec_depend>moveit_configs_utils</exec_depend>" in after["package.xml"]


CONTEXT = """\
<launch>
  <arg name="left" default="true"/>
  <param name="robot_description" command="xacro '$(find arm)/urdf/arm.xacro' left:=$(arg left) size:=2" if="false"/>
  <param name="robot_description_semantic" textfile="$(find arm_moveit)/config/right.srdf" unless="$(arg left)"/>
  <param name="robot_description_semantic" textfile="$(find arm_moveit)/config/left.srdf" if="$(arg left)"/>
</launch>
"""
BUILT = """\
from ament_index_python.packages import get_package_share_directory
from moveit_configs_utils import MoveItConfigsBuilder
from moveit_configs_utils.launches import generate_move_group_launch


def generate_launch_description():
    moveit_config = (
        MoveItConfigsBuilder("arm", package_name="arm_moveit")
        .robot_description(file_path=get_package_share_directory("arm") + "/urdf/arm.xacro", \
mappings={"left": "true", "size": "2"})
        .robot_description_semantic(file_path="config/left.srdf")
        .planning_pipelines(pipelines=["ompl"])
        .to_moveit_configs()
    )
    return generate_move_group_launch(moveit_config)
"""
STARTED = '<launch>\n  <node pkg="moveit_ros_move_group" type="move_group" name="move_group"/>\n</launch>\n'


def without_mark(folder: Folder, context: str) -> dict[str, str]:
    """The files of a package of MoveIt without the hidden file of its Setup Assistant, after its migration."""
    launches = {"launch/move_group.launch": STARTED, "launch/planning_context.launch": context}
    return migrated(folder, {**launches, "config/left.srdf": SRDF, "config/right.srdf": SRDF}, mark=False)


def test_the_planning_context_says_where_the_descriptions_are_if_nothing_else_does(folder: Folder) -> None:
    after = without_mark(folder, CONTEXT)
    assert after["launch/move_group.launch.py"] == BUILT
    assert "launch/planning_context.launch" not in after
    assert "launch/rsp.launch.py" in after


def test_only_launch_files_beside_that_of_move_group_are_moveits(folder: Folder) -> None:
    loads = '<launch><param name="octomap_resolution" value="0.1"/></launch>\n'
    demo = """\
<launch>
  <include file="$(find arm_moveit)/launch/sensor_manager.launch.xml"/>
  <include file="$(find arm_moveit)/launch/own/sensor_manager.launch.xml"/>
</launch>
"""
    files = {"launch/sensor_manager.launch.xml": loads, "launch/own/sensor_manager.launch.xml": loads}
    after = migrated(folder, {"launch/move_group.launch": STARTED, "launch/demo.launch": demo, **files})
    assert "launch/sensor_manager.launch.xml" not in after
    assert "launch/own/sensor_manager.launch.py" in after
    assert after["launch/demo.launch.py"].count("IncludeLaunchDescription(") == 1
    assert "/launch/own/sensor_manager.launch.py" in after["launch/demo.launch.py"]


def test_a_description_outside_of_packages_is_left_to_a_person(folder: Folder) -> None:
    after = without_mark(folder, CONTEXT.replace("$(find arm)", "/home/me/arm"))
    text = after["launch/move_group.launch.py"]
    assert "    # TODO(urdfctl): add .robot_description(file_path=...) with the robot's description\n" in text
    assert '.robot_description_semantic(file_path="config/left.srdf")' in text
    assert ".robot_description(file_path=get" not in text


def test_a_launch_file_that_includes_those_of_moveit_includes_the_new_ones(folder: Folder) -> None:
    launch = '<launch>\n  <node pkg="moveit_ros_move_group" type="move_group" name="move_group"/>\n</launch>\n'
    demo = """\
<launch>
  <include file="$(dirname)/planning_context.launch"><arg name="load_robot_description" value="true"/></include>
  <include file="$(find arm_moveit)/launch/move_group.launch"/>
</launch>
"""
    files = {"launch/move_group.launch": launch, "launch/planning_context.launch": launch, "launch/demo.launch": demo}
    after = migrated(folder, files)
    text = " ".join(after["launch/demo.launch.py"].split())
    assert 'AnyLaunchDescriptionSource([ThisLaunchFileDir(), "/rsp.launch.py"])' in text
    assert '[FindPackageShare("arm_moveit"), "/launch/move_group.launch.py"]' in text
    assert "load_robot_description" not in text
    assert "launch/demo.launch" not in after
    files["launch/demo.launch"] = demo.replace('value="true"', 'value="false"')
    assert "rsp.launch.py" not in migrated(folder, files)["launch/demo.launch.py"]


def test_a_launch_file_that_is_left_to_a_person_loads_the_new_file_with_controllers(folder: Folder) -> None:
    load = '<launch>\n  <rosparam file="$(find arm_moveit)/config/$(arg robot)_controllers.yaml"/>\n</launch>\n'
    files = {
        "config/a_controllers.yaml": LIST,
        "config/second.srdf": SRDF,
        "launch/arm_moveit_controller_manager.launch.xml": load,
    }
    after = migrated(folder, files)["launch/arm_moveit_controller_manager.launch.xml"]
    assert after == load.replace("$(arg robot)_controllers", "moveit_controllers")


def test_files_of_moveit_that_a_launch_file_of_ros_1_loads_are_none_of_the_controller_manager(folder: Folder) -> None:
    launch = """\
<launch>
  <param name="robot_description" command="xacro '$(find arm)/urdf/arm.xacro'"/>
  <rosparam file="$(find arm_moveit)/config/kinematics.yaml"/>
  <rosparam file="$(find arm)/config/c.yaml"/>
  <node pkg="controller_manager" type="spawner" name="s" ns="arm" args="ctl"/>
</launch>
"""
    folder.write(
        {
            "src/arm/package.xml": MANIFEST,
            "src/arm/urdf/arm.xacro": arm(transmission("EffortJointInterface"), PLUGIN),
            "src/arm/config/c.yaml": EFFORT,
            "src/arm/launch/arm.launch": launch,
            "src/moveit/package.xml": MANIFEST.replace("<name>arm<", "<name>arm_moveit<"),
            "src/moveit/config/kinematics.yaml": KINEMATICS,
        }
    )
    ran = folder.run("migrate", "src", "--from", "noetic", "--to", "jazzy", "-o", "new", "--force")
    assert ran.returncode == 0, ran.stderr
    after = (folder.path / "new/arm/urdf/arm.xacro").read_text()
    assert "<parameters>$(find arm)/config/c.yaml</parameters>" in after
    assert "kinematics.yaml" not in after


def test_parameters_that_a_launch_file_of_ros_1_still_loads_are_not_judged_as_those_of_a_controller_manager(
    folder: Folder,
) -> None:
    launch = """\
<launch>
  <param name="robot_description" command="xacro '$(find arm)/urdf/arm.xacro'"/>
  <rosparam file="$(find arm)/config/kinematics.yaml"/>
</launch>
"""
    files = {"package.xml": MANIFEST, "urdf/arm.xacro": arm(""), "config/kinematics.yaml": KINEMATICS}
    folder.write({**{f"arm/{name}": text for name, text in files.items()}, "arm/launch/arm.launch": launch})
    assert "UC403" not in folder.run("lint", "arm", "--distro", "humble").stdout


def test_a_launch_file_does_not_include_those_of_moveit_that_are_left_to_a_person(folder: Folder) -> None:
    load = '<launch>\n  <rosparam file="$(find arm_moveit)/config/ompl_planning.yaml"/>\n</launch>\n'
    demo = '<launch>\n  <include file="$(dirname)/ompl_planning_pipeline.launch.xml"/>\n</launch>\n'
    files = {"launch/ompl_planning_pipeline.launch.xml": load, "launch/demo.launch": demo, "config/second.srdf": SRDF}
    folder.write({f"arm_moveit/{name}": text for name, text in {"package.xml": MANIFEST, **files}.items()})
    ran = folder.run("migrate", "arm_moveit", "--from", "noetic", "--to", "humble", "-o", "new")
    assert ran.returncode == 0, ran.stderr
    new = folder.path / "new"
    assert (new / "launch/ompl_planning_pipeline.launch.xml").read_text() == load
    assert "start here what replaces MoveIt's 'ompl_planning_pipeline.launch.xml'" in (new / "MIGRATION.md").read_text()
    assert "Include" not in (new / "launch/demo.launch.py").read_text()


def test_a_launch_file_that_is_left_includes_what_other_launch_files_became(folder: Folder) -> None:
    context = """\
<launch>
  <include file="$(find arm)/launch/$(arg model)_upload.launch"/>
  <include file="$(find arm)/launch/$(arg model)_none.launch"/>
</launch>
"""
    folder.write({"src/arm/launch/long_upload.launch": '<launch>\n  <arg name="a"/>\n</launch>\n'})
    files = {"launch/planning_context.launch": context, "config/second.srdf": SRDF}
    after = migrated(folder, files)["launch/planning_context.launch"]
    assert after == context.replace("_upload.launch", "_upload.launch.py")


ELSEWHERE = """\
<launch>
  <arg name="robot" default="left"/>
  <param name="robot_description" textfile="$(find arm)/urdf/arm.xacro"/>
  <param name="robot_description_semantic" textfile="$(find arm_moveit)/config/$(arg robot)/arm.srdf"/>
  <group ns="robot_description_planning">
    <rosparam command="load" file="$(find arm_moveit)/config/$(arg robot)/joint_limits.yaml"/>
  </group>
  <group ns="robot_description_kinematics"><rosparam file="$(find arm_moveit)/config/kinematics.yaml"/></group>
</launch>
"""


def test_files_that_are_not_directly_in_config_are_named(folder: Folder) -> None:
    files = {
        "launch/planning_context.launch": ELSEWHERE,
        "launch/move_group.launch": "<launch/>",
        "config/left/arm.srdf": SRDF,
        "config/left/joint_limits.yaml": "joint_limits: {}\n",
        "config/left/controllers.yaml": LIST,
    }
    after = migrated(folder, files, "jazzy", mark=False)
    assert """
        .robot_description_semantic(file_path="config/left/arm.srdf")
        .joint_limits(file_path="config/left/joint_limits.yaml")
        .trajectory_execution(file_path="config/left/moveit_controllers.yaml")
        .planning_pipelines(pipelines=["ompl"])
        .to_moveit_configs()
""" in after["launch/move_group.launch.py"]


@pytest.mark.parametrize("context", [True, False])
def test_a_publisher_without_a_description_is_the_one_that_moveit_makes(folder: Folder, context: bool) -> None:
    """In ROS 1 the planning context, which move_group.launch included, set its description."""
    publisher = '<node name="p" pkg="robot_state_publisher" type="robot_state_publisher"/>'
    include = '<include file="$(dirname)/move_group.launch"/>'
    files = {
        "launch/move_group.launch": '<launch><node name="m" pkg="moveit_ros_move_group" type="move_group"/></launch>\n',
        "launch/demo.launch": f'<launch><group if="$(optenv FAKE true)">{publisher}</group>{include}</launch>\n',
    }
    files |= {"launch/planning_context.launch": "<launch/>\n"} if context else {}
    demo = migrated(folder, files)["launch/demo.launch.py"]
    assert ('ThisLaunchFileDir(), "/rsp.launch.py"' in demo) == context
    assert 'executable="robot_state_publisher"' not in demo
    assert demo.count("GroupAction(") == context
    assert 'ThisLaunchFileDir(), "/move_group.launch.py"' in demo


PIPELINES = """\
<launch>
  <arg name="pipeline" default="ompl"/>
  <include file="$(dirname)/planning_pipeline.launch.xml"><arg name="pipeline" value="$(arg pipeline)"/></include>
  <include file="$(dirname)/planning_pipeline.launch.xml">
    <arg name="pipeline" value="pilz_industrial_motion_planner"/>
  </include>
  <include file="$(find arm_moveit)/launch/lattice_planning_pipeline.launch.xml"/>
</launch>
"""
OF_PILZ = (
    '<launch>\n  <param name="planning_plugin" value="pilz_industrial_motion_planner::CommandPlanner"/>\n</launch>\n'
)
LATTICE = '<launch>\n  <param name="planning_plugin" value="lattice/Planner"/>\n</launch>\n'


def with_pipelines(folder: Folder, more: dict[str, str]) -> dict[str, str]:
    """The files of a package whose move_group loads three planning pipelines in ROS 1, after its migration."""
    files = {
        "launch/move_group.launch": PIPELINES,
        "launch/pilz_industrial_motion_planner_planning_pipeline.launch.xml": OF_PILZ,
        "launch/lattice_planning_pipeline.launch.xml": LATTICE,
    }
    return migrated(folder, files | more, "jazzy")


def test_moveit_loads_the_pipelines_that_it_loaded_in_ros_1_and_no_others(folder: Folder) -> None:
    after = with_pipelines(folder, {"config/cartesian_limits.yaml": "cartesian_limits: {max_trans_vel: 1}\n"})
    call = '.planning_pipelines(pipelines=["ompl", "pilz_industrial_motion_planner"])'
    assert call in after["launch/move_group.launch.py"]
    for package in ("moveit_planners_ompl", "pilz_industrial_motion_planner"):
        assert f"<exec_depend>{package}</exec_depend>" in after["package.xml"]
    assert "moveit_planners_chomp" not in after["package.xml"]


def test_the_planner_of_pilz_has_the_name_and_the_limits_of_moveit_2(folder: Folder) -> None:
    limits = "cartesian_limits:\n  max_trans_vel: 1  # m/s\n  max_trans_dec: -5\n  max_rot_vel: 1.57\n"
    after = with_pipelines(folder, {"config/cartesian_limits.yaml": limits})
    doubles = limits.replace("vel: 1 ", "vel: 1.0 ").replace("-5", "-5.0")
    assert after["config/pilz_cartesian_limits.yaml"] == doubles
    assert "config/cartesian_limits.yaml" not in after
    pilz = after["config/pilz_industrial_motion_planner_planning.yaml"]
    assert "- pilz_industrial_motion_planner/CommandPlanner" in pilz


def test_the_planner_of_pilz_is_not_loaded_without_its_limits(folder: Folder) -> None:
    assert '.planning_pipelines(pipelines=["ompl"])' in with_pipelines(folder, {})["launch/move_group.launch.py"]


@pytest.mark.parametrize("own", [False, True])
def test_a_planner_that_moveit_2_has_not_is_told(folder: Folder, own: bool) -> None:
    declared = {"plugins.xml": '<library path="lattice"><class name="lattice/Planner"/></library>\n'} if own else {}
    with_pipelines(folder, declared)
    report = (folder.path / "new" / "MIGRATION.md").read_text()
    assert ("check that jazzy has the planner 'lattice/Planner'" in report) != own
    assert "has the planner 'pilz" not in report


def test_the_publisher_is_started_once_where_the_planning_context_is_included_too(folder: Folder) -> None:
    publisher = '<node name="p" pkg="robot_state_publisher" type="robot_state_publisher"/>'
    context = """\
<include file="$(find arm_moveit)/launch/planning_context.launch">
  <arg name="load_robot_description" value="true"/>
</include>
"""
    files = {
        "launch/move_group.launch": STARTED,
        "launch/planning_context.launch": '<launch><arg name="load_robot_description" default="false"/></launch>\n',
        "launch/demo.launch": f"<launch>{context}{publisher}</launch>\n",
    }
    assert migrated(folder, files)["launch/demo.launch.py"].count("/rsp.launch.py") == 1
