"""UC635."""

from __future__ import annotations

from collections.abc import Iterator, Mapping

from urdfctl.model.launch import Word
from urdfctl.names import nearest
from urdfctl.rule import Finding, Project, Severity, rule
from urdfctl.rules.common import in_words, is_known, replaced
from urdfctl.rules.launch_samples import ARM, BROADCASTER, MANAGER, PUBLISHER, SOUND, launched, spawner

_PUBLISHERS = {
    "robot_state_publisher": ("robot_state_publisher", "state_publisher"),
    "joint_state_publisher": ("joint_state_publisher",),
    "joint_state_publisher_gui": ("joint_state_publisher_gui",),
}
_WHOLE: Mapping[int, Mapping[str, tuple[str, ...]]] = {
    1: {**_PUBLISHERS, "controller_manager": ("spawner", "unspawner", "controller_manager", "controller_group")},
    2: {
        **_PUBLISHERS,
        "controller_manager": (
            *("ros2_control_node", "spawner", "unspawner", "hardware_spawner"),
            *("spawner.py", "unspawner.py"),
        ),
    },
}
"""All programs that a package has in any distro, by the generation of ROS."""
_SOME: Mapping[int, Mapping[str, tuple[str, ...]]] = {
    1: {"gazebo_ros": ("gazebo", "gzserver", "gzclient", "spawn_model", "debug", "gdbrun", "perf", "gui")},
    2: {
        "gazebo_ros": ("spawn_entity.py",),
        "ros_gz_sim": ("create", "remove", "gzserver", "spawn_entity", "delete_entity", "set_entity_pose"),
        "ros_gz_bridge": ("parameter_bridge", "static_bridge", "bridge_node"),
    },
}
"""Programs of packages that may have others."""
_OF_ROS_1 = """
            <launch>
              <rosparam command="load" file="$(find arm)/controllers.yaml"/>
              {}
            </launch>
"""


def _ros1(*nodes: str) -> dict[str, str]:
    states = "states: {type: joint_state_controller/JointStateController, publish_rate: 50}\n"
    manifest = "".join(
        f"<exec_depend>{name}</exec_depend>" for name in ("controller_manager", "joint_state_controller")
    )
    return {
        "robot.urdf": "",
        "arm.launch": _OF_ROS_1.format("".join(nodes)),
        "controllers.yaml": states,
        "package.xml": f"<package><name>arm</name>{manifest}</package>",
        "options": "--distro=noetic",
    }


def _spawner(program: str) -> str:
    return f'<node name="spawner" pkg="controller_manager" type="{program}" args="states"/>'


def _nodes(ros: int, text: str) -> list[str]:
    """Return a node for each program. text: the value of its attribute, with {} for the program's name."""
    owned = ((package, name) for package, names in (*_WHOLE[ros].items(), *_SOME[ros].items()) for name in names)
    attribute = "name='a' type" if ros == 1 else "exec"
    return [f'<node pkg="{package}" {attribute}="{text.format(name)}"/>' for package, name in owned]


@rule(
    "UC635",
    severity=Severity.ERROR,
    runtime="refuses",
    options=("--distro=jazzy",),
    authority="launch_ros substitutions/executable_in_package.py: \"executable '{}' not found on the libexec directory\"; roslaunch "
    "nodeprocess.py: 'cannot launch node of type'; the programs: ros2_control controller_manager/setup.cfg and "
    "CMakeLists.txt, ros_control controller_manager/scripts",
    bad=[
        launched(PUBLISHER, MANAGER, BROADCASTER, ARM, spawner("arm_controller", "«spawners»")),
        launched(PUBLISHER, MANAGER, BROADCASTER, ARM, spawner("arm_controller", "«load»")),
        launched(PUBLISHER, MANAGER, BROADCASTER, ARM, spawner("arm_controller", "«robot_state_publisher»")),
        _ros1(_spawner("«spawner.py»")),
        *(_ros1(_spawner("spawner"), node) for node in _nodes(1, "«{}s»")),
        *(launched(node) for node in _nodes(2, "«{}s»")),
    ],
    good=[SOUND, _ros1(_spawner("spawner"))],
)
def program_unknown(project: Project) -> Iterator[Finding]:
    """Package has no program of this name.

    `ros2 launch` stops with 'executable not found', and starts nothing. `roslaunch` starts the other nodes: the one
    that spawns the controllers or the model is missing. If nothing says which program is meant, it is a warning.
    """
    launch = project.launch
    for node in launch.nodes if launch else ():
        package, program = node.package.text, node.executable
        if launch is None or not node.sure or not is_known(program.text) or not program.text:
            continue
        whole = _WHOLE[launch.ros].get(package)
        programs = whole or _SOME[launch.ros].get(package)
        if programs is None or program.text in programs:
            continue
        meant = nearest(program.text, programs)
        yield from _unknown(package, program, meant, programs, is_whole=whole is not None, ros=launch.ros)


def _unknown(
    package: str, program: Word, meant: str | None, programs: tuple[str, ...], *, is_whole: bool, ros: int
) -> Iterator[Finding]:
    message = f"package '{package}' has no program '{program.text}'"
    owner = next((name for name, others in (*_WHOLE[ros].items(), *_SOME[ros].items()) if program.text in others), None)
    if meant is not None:
        fix = replaced(program.at, program.text, meant)
        yield Finding(program.at, f"{message}; did you mean '{meant}'?", fix=fix)
    elif is_whole and owner is not None:
        yield Finding(program.at, f"{message}; it is one of package '{owner}'")
    elif is_whole:
        yield Finding(program.at, f"{message}, only {in_words(programs)}", severity=Severity.WARNING)
