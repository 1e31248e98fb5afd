"""A package of MoveIt's setup assistant, whose demo starts the robot on mock hardware."""

from __future__ import annotations

from textwrap import dedent, indent

from systems.possible import Idioms
from systems.render.description import XACRO, descriptions
from systems.render.packages import package_files, runtime_packages
from systems.render.parameters import dumped, parameter_files
from systems.render.places import Places, description_name, pick
from systems.render.workspace import ExpectedRobot, Workspace
from systems.system import BROADCASTER, Joint, Robot, System

_PACKAGES = (
    "moveit_ros_move_group moveit_configs_utils moveit_simple_controller_manager moveit_planners moveit_kinematics "
    "moveit_ros_visualization rviz2 tf2_ros launch launch_ros"
)


def assembled_moveit(system: System, idioms: Idioms) -> Workspace:
    """Return the workspace of a system that MoveIt's demo starts."""
    (robot,) = system.robots
    package, described = f"{robot.model}_moveit_config", f"{robot.model}_description"
    workspace = Workspace(system, idioms)
    workspace.files |= _described(system, idioms, robot, described)
    own = {**_config(system, idioms, robot, described), **_launch(system, idioms, robot, package)}
    modified = (package, f"config/{robot.model}.urdf.xacro")
    original = (described, f"urdf/{description_name(system, idioms, robot)}")
    own[".setup_assistant"] = _setup_assistant(robot, *pick(system, "setup assistant", (modified, original)))
    depends = {*runtime_packages(system), *_PACKAGES.split(), described}
    manifests = package_files(system, package, own, depends)
    manifests["CMakeLists.txt"] = manifests["CMakeLists.txt"].replace(
        "ament_package()", "install(FILES .setup_assistant DESTINATION share/${PROJECT_NAME})\nament_package()"
    )
    workspace.files |= {f"{package}/{name}": text for name, text in {**own, **manifests}.items()}
    workspace.starts = [f"{package}/launch/demo.launch.py"]
    workspace.included = [path for path in workspace.files if "/launch/" in path and path not in workspace.starts]
    spawned = {spawn.name for spawn in robot.spawned}
    parameters = frozenset({f"{package}/config/ros2_controllers.yaml"})
    extra = frozenset({f"{package}/config/moveit_controllers.yaml"})
    description = f"{package}/config/{robot.model}.urdf.xacro"
    workspace.robots = [ExpectedRobot(description, (), "", parameters, frozenset(spawned), extra)]
    return workspace


def moveit_places(system: System) -> Places:
    """Return the packages of such a workspace."""
    name = system.robots[0].model
    return Places(f"{name}_description", f"{name}_moveit_config", f"{name}_moveit_config")


def _described(system: System, idioms: Idioms, robot: Robot, package: str) -> dict[str, str]:
    """The package with links and joints only."""
    files = descriptions(system, idioms, Places(package, package, package))
    (path, text), *others = files.items()
    before, _, rest = text.partition("  <ros2_control")
    found = {path: before + rest.partition("</ros2_control>\n")[2], **dict(others)}
    inside = {name.partition("/")[2]: each for name, each in found.items()}
    own = package_files(system, package, inside, ["xacro"])
    return {**found, **{f"{package}/{name}": each for name, each in own.items()}}


def _config(system: System, idioms: Idioms, robot: Robot, described: str) -> dict[str, str]:
    model = robot.model
    (parameters,) = parameter_files(system, idioms, robot, ("ros2_controllers.yaml",)).values()
    names = [joint.name for joint in robot.joints]
    limits = {"has_velocity_limits": True, "max_velocity": 2.0}
    limits |= {"has_acceleration_limits": True, "max_acceleration": 2.0}
    joints = "".join(f'    <joint name="{name}"/>\n' for name in names)
    solver = {"kinematics_solver": "kdl_kinematics_plugin/KDLKinematicsPlugin", "kinematics_solver_timeout": 0.005}
    return {
        f"config/{model}.urdf.xacro": _main(model, f"{described})/urdf/{description_name(system, idioms, robot)}"),
        f"config/{model}.ros2_control.xacro": _control(robot),
        f"config/{model}.srdf": f'<robot name="{model}">\n  <group name="arm">\n{joints}  </group>\n</robot>\n',
        "config/initial_positions.yaml": dumped({"initial_positions": dict.fromkeys(names, 0)}),
        "config/ros2_controllers.yaml": parameters,
        "config/moveit_controllers.yaml": dumped(_moveit_controllers(robot)),
        "config/kinematics.yaml": dumped({"arm": solver}),
        "config/joint_limits.yaml": dumped(
            {
                "default_velocity_scaling_factor": 0.1,
                "default_acceleration_scaling_factor": 0.1,
                "joint_limits": {name: dict(limits) for name in names},
            }
        ),
        "config/moveit.rviz": "Panels: []\n",
    }


def _main(model: str, included: str) -> str:
    return dedent(f"""\
        <?xml version="1.0" encoding="UTF-8"?>
        <robot {XACRO} name="{model}">
          <xacro:arg name="initial_positions_file" default="initial_positions.yaml"/>
          <xacro:include filename="$(find {included}"/>
          <xacro:include filename="{model}.ros2_control.xacro"/>
          <xacro:{model}_ros2_control name="FakeSystem" initial_positions_file="$(arg initial_positions_file)"/>
        </robot>
        """)


def _control(robot: Robot) -> str:
    joints = "".join(_part(joint) for joint in robot.joints)
    hardware = "<hardware>\n  <plugin>mock_components/GenericSystem</plugin>\n</hardware>\n"
    whole = f'<ros2_control name="${{name}}" type="system">\n{indent(hardware + joints, "  ")}</ros2_control>\n'
    positions = "${xacro.load_yaml(initial_positions_file)['initial_positions']}"
    body = f'<xacro:property name="initial_positions" value="{positions}"/>\n{whole}'
    head = f'  <xacro:macro name="{robot.model}_ros2_control" params="name initial_positions_file">\n'
    return f'<?xml version="1.0"?>\n<robot {XACRO}>\n{head}{indent(body, "    ")}  </xacro:macro>\n</robot>\n'


def _part(joint: Joint) -> str:
    commands = "".join(f'  <command_interface name="{name}"/>\n' for name in joint.commands)
    initial = f"<param name=\"initial_value\">${{initial_positions['{joint.name}']}}</param>"
    states = f'  <state_interface name="position">\n    {initial}\n  </state_interface>\n'
    return f'<joint name="{joint.name}">\n{commands}{states}  <state_interface name="velocity"/>\n</joint>\n'


def _moveit_controllers(robot: Robot) -> dict[str, object]:
    states = next(one.name for one in robot.controllers if one.family == BROADCASTER)
    names = [spawn.name for spawn in robot.spawned if spawn.name != states]
    joints = [joint.name for joint in robot.joints]
    each = {"type": "FollowJointTrajectory", "action_ns": "follow_joint_trajectory", "default": True, "joints": joints}
    manager = "moveit_simple_controller_manager"
    return {
        "moveit_controller_manager": f"{manager}/MoveItSimpleControllerManager",
        manager: {"controller_names": names, **{name: {**each, "joints": list(joints)} for name in names}},
    }


def _setup_assistant(robot: Robot, package: str, path: str) -> str:
    main = {"package": package, "relative_path": path}
    settings = {"author_name": "Someone", "author_email": "someone@example.org", "generated_timestamp": 1700000000}
    semantic = {"relative_path": f"config/{robot.model}.srdf"}
    return dumped({"moveit_setup_assistant_config": {"urdf": main, "srdf": semantic, "package_settings": settings}})


# -- launch files -------------------------------------------------------------------------------------------------

_GENERATED = ("demo", "move_group", "moveit_rviz", "rsp", "spawn_controllers", "static_virtual_joint_tfs")


def _launch(system: System, idioms: Idioms, robot: Robot, package: str) -> dict[str, str]:
    files = {f"launch/{name}.launch.py": _generated(name, robot, package) for name in _GENERATED}
    form = idioms["demo"]
    if form == "by hand":
        files["launch/demo.launch.py"] = _BY_HAND.format(model=robot.model, package=package)
        files["launch/move_group.launch.py"] = _DEBUGGABLE.format(model=robot.model, package=package)
    elif form == "merged":
        files["launch/demo.launch.py"] = _MERGED.format(model=robot.model, package=package)
    elif form == "own nodes":
        names = [spawn.name for spawn in robot.spawned]
        files["launch/demo.launch.py"] = _OWN_NODES.format(model=robot.model, package=package, names=names)
        for name in _GENERATED[2:]:
            del files[f"launch/{name}.launch.py"]
    return files


def _generated(name: str, robot: Robot, package: str) -> str:
    return dedent(f"""\
        from moveit_configs_utils import MoveItConfigsBuilder
        from moveit_configs_utils.launches import generate_{name}_launch


        def generate_launch_description():
            moveit_config = MoveItConfigsBuilder("{robot.model}", package_name="{package}").to_moveit_configs()
            return generate_{name}_launch(moveit_config)
        """)


_BY_HAND = """\
from launch import LaunchDescription
from launch.actions import IncludeLaunchDescription
from launch.launch_description_sources import PythonLaunchDescriptionSource
from launch_ros.actions import Node
from moveit_configs_utils import MoveItConfigsBuilder
from moveit_configs_utils.launch_utils import DeclareBooleanLaunchArg


def generate_launch_description():
    moveit_config = MoveItConfigsBuilder("{model}", package_name="{package}").to_moveit_configs()
    launch_package_path = moveit_config.package_path
    ld = LaunchDescription()
    ld.add_action(DeclareBooleanLaunchArg("db", default_value=False))
    for name in ("rsp", "move_group", "moveit_rviz"):
        path = str(launch_package_path / f"launch/{{name}}.launch.py")
        ld.add_action(IncludeLaunchDescription(PythonLaunchDescriptionSource(path)))
    ld.add_action(
        Node(
            package="controller_manager",
            executable="ros2_control_node",
            parameters=[moveit_config.robot_description, str(launch_package_path / "config/ros2_controllers.yaml")],
            remappings=[("/controller_manager/robot_description", "/robot_description")],
        )
    )
    ld.add_action(
        IncludeLaunchDescription(
            PythonLaunchDescriptionSource(str(launch_package_path / "launch/spawn_controllers.launch.py"))
        )
    )
    return ld
"""
_DEBUGGABLE = """\
from launch import LaunchDescription
from moveit_configs_utils import MoveItConfigsBuilder
from moveit_configs_utils.launch_utils import DeclareBooleanLaunchArg, add_debuggable_node


def generate_launch_description():
    moveit_config = MoveItConfigsBuilder("{model}", package_name="{package}").to_moveit_configs()
    ld = LaunchDescription()
    ld.add_action(DeclareBooleanLaunchArg("debug", default_value=False))
    add_debuggable_node(
        ld,
        package="moveit_ros_move_group",
        executable="move_group",
        commands_file=str(moveit_config.package_path / "launch" / "gdb_settings.gdb"),
        output="screen",
        parameters=[moveit_config.to_dict()],
        extra_debug_args=["--debug"],
    )
    return ld
"""
_MERGED = """\
from launch import LaunchDescription
from launch_ros.actions import Node
from moveit_configs_utils import MoveItConfigsBuilder
from moveit_configs_utils.launches import generate_move_group_launch, generate_spawn_controllers_launch


def generate_hardware_launch(moveit_config):
    parameters = [moveit_config.robot_description, str(moveit_config.package_path / "config/ros2_controllers.yaml")]
    ld = LaunchDescription(
        [
            Node(
                package="robot_state_publisher",
                executable="robot_state_publisher",
                parameters=[moveit_config.robot_description],
            )
        ]
    )
    ld.add_action(
        Node(
            package="controller_manager",
            executable="ros2_control_node",
            parameters=parameters,
            remappings=[("/controller_manager/robot_description", "/robot_description")],
        )
    )
    return ld


def generate_launch_description():
    moveit_config = MoveItConfigsBuilder("{model}", package_name="{package}").to_moveit_configs()
    ld = LaunchDescription()
    for part in (generate_hardware_launch, generate_move_group_launch, generate_spawn_controllers_launch):
        for action in part(moveit_config).entities:
            ld.add_action(action)
    return ld
"""
_OWN_NODES = """\
import os

from ament_index_python.packages import get_package_share_directory
from launch import LaunchDescription
from launch_ros.actions import Node
from moveit_configs_utils import MoveItConfigsBuilder


def generate_launch_description():
    moveit_config = (
        MoveItConfigsBuilder("{model}", package_name="{package}")
        .robot_description(file_path="config/{model}.urdf.xacro")
        .trajectory_execution(file_path="config/moveit_controllers.yaml")
        .to_moveit_configs()
    )
    move_group_node = Node(
        package="moveit_ros_move_group",
        executable="move_group",
        output="screen",
        parameters=[moveit_config.to_dict()],
    )
    robot_state_publisher = Node(
        package="robot_state_publisher",
        executable="robot_state_publisher",
        parameters=[moveit_config.robot_description],
    )
    ros2_controllers_path = os.path.join(
        get_package_share_directory("{package}"), "config", "ros2_controllers.yaml"
    )
    ros2_control_node = Node(
        package="controller_manager",
        executable="ros2_control_node",
        parameters=[moveit_config.robot_description, ros2_controllers_path],
        remappings=[("/controller_manager/robot_description", "/robot_description")],
    )
    load_controllers = []
    for controller in {names}:
        load_controllers.append(
            Node(
                package="controller_manager",
                executable="spawner",
                arguments=[controller, "-c", "/controller_manager"],
            )
        )
    return LaunchDescription([move_group_node, robot_state_publisher, ros2_control_node] + load_controllers)
"""
