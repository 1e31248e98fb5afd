"""UC614."""

from __future__ import annotations

from collections.abc import Iterator

from urdfctl.catalog.distros import MAINTAINED
from urdfctl.control.hardware.simulator_plugins import components, control_plugins
from urdfctl.model.launch import Launch, Package
from urdfctl.rule import Edit, Finding, Fix, Note, Project, Severity, rule
from urdfctl.rules.common import is_conditional
from urdfctl.rules.launch_samples import MANIFEST, SOUND
from urdfctl.source.span import Place, SourceSpan

_LACKING = MANIFEST.replace("<exec_depend>xacro</exec_depend>", "").replace(
    '<package format="3">', '«<package format="3">»'
)
_CHECKED = frozenset(
    "xacro robot_state_publisher joint_state_publisher joint_state_publisher_gui controller_manager gazebo_ros ros_gz_sim "
    "ros_ign_gazebo ros_gz_bridge gazebo_ros_control gazebo_ros2_control gz_ros2_control".split()
)
"""The packages that control requires besides the controllers. Other packages are not checked."""
_BRINGS = {
    "ros2_control": "controller_manager",
    "ros_control": "controller_manager",
    "gazebo_ros_control": "controller_manager gazebo_ros",
    "gazebo_ros2_control": "controller_manager gazebo_ros",
    "gz_ros2_control": "controller_manager",
    "ign_ros2_control": "controller_manager",
    "gazebo_ros_pkgs": "gazebo_ros",
    "ros_gz": "ros_gz_sim ros_gz_bridge",
    "joint_state_publisher_gui": "joint_state_publisher",
    "joint_state_publisher": "xacro",
    "urdf_launch": "robot_state_publisher joint_state_publisher joint_state_publisher_gui xacro",
}
"""Packages, and the packages that they depend on."""
_EVERYTHING = ("desktop", "desktop_full", "robot", "viz", "simulators", "moveit", "ros_base")
_CONTROLLERS = ("ros_controllers", "ros2_controllers")


def _using(packages: str, declared: str, root: str = '<package format="3">') -> dict[str, str]:
    """Return the files of a package that depends on one package, and starts a node of each of some others."""
    nodes = (f'<node pkg="{package}" exec="$(var program)"/>' for package in packages.split())
    return {
        "arm.launch.xml": f"<launch><arg name='program'/>{''.join(nodes)}</launch>",
        "package.xml": f"{root}<name>arm</name><exec_depend>{declared}</exec_depend></package>",
    }


def _simulated(declared: str, root: str = '<package format="2">') -> dict[str, str]:
    """Return the files of a package of ROS 1 whose robot runs ros_control in Gazebo."""
    return {
        "options": "--distro=noetic",
        "robot.urdf": '<gazebo><plugin name="control" filename="libgazebo_ros_control.so"/></gazebo>',
        "arm.launch": '<launch><param name="robot_description" textfile="$(find arm)/robot.urdf"/></launch>',
        "package.xml": f"{root}<name>arm</name><exec_depend>rviz</exec_depend>{declared}</package>",
    }


@rule(
    "UC614",
    runtime="works",
    because="a computer that lacks the package cannot start the robot",
    severity=Severity.WARNING,
    authority="REP 149: <exec_depend> declares what is needed at run time, and rosdep installs that; "
    "ament_index: 'package 'xacro' not found, searching: ...'",
    bad=[
        {**SOUND, "package.xml": _LACKING},
        _using(
            "xacro robot_state_publisher joint_state_publisher joint_state_publisher_gui controller_manager gazebo_ros "
            "ros_gz_sim ros_ign_gazebo ros_gz_bridge gazebo_ros_control gazebo_ros2_control gz_ros2_control",
            declared="rviz2",
            root='«<package format="3">»',
        ),
        _simulated("", root='«<package format="2">»'),
    ],
    good=[
        SOUND,
        _using("controller_manager", declared="ros2_control"),
        _simulated("<exec_depend>gazebo_ros_control</exec_depend>"),
        _using("controller_manager", declared="ros_control"),
        _using("controller_manager gazebo_ros", declared="gazebo_ros_control"),
        _using("controller_manager gazebo_ros", declared="gazebo_ros2_control"),
        _using("controller_manager", declared="gz_ros2_control"),
        _using("controller_manager", declared="ign_ros2_control"),
        _using("gazebo_ros", declared="gazebo_ros_pkgs"),
        _using("ros_gz_sim ros_gz_bridge", declared="ros_gz"),
        _using("joint_state_publisher", declared="joint_state_publisher_gui"),
        _using("xacro", declared="joint_state_publisher"),
        _using("robot_state_publisher joint_state_publisher joint_state_publisher_gui xacro", declared="urdf_launch"),
        *(
            _using("robot_state_publisher", declared=everything)
            for everything in ("desktop", "desktop_full", "robot", "viz", "simulators", "moveit", "ros_base")
        ),
        *(
            {**SOUND, "package.xml": MANIFEST.replace(">joint_trajectory_controller<", f">{controllers}<")}
            for controllers in ("ros_controllers", "ros2_controllers")
        ),
    ],
)
def package_not_in_manifest(project: Project) -> Iterator[Finding]:
    """Package used by a launch file is missing in package.xml.

    `rosdep install` does not install it, so the robot starts only on computers that already have it. The rule checks
    the packages that control requires: controllers, controller manager, simulator, state publishers and xacro.
    """
    launch = project.launch
    package = launch.package if launch else None
    if launch is None or package is None:
        return
    reported: set[str] = set()
    for name, at, severity in _used(project, launch, package):
        if name and name not in reported and not _is_declared(name, package):
            reported.add(name)
            user = "robot" if at.source.is_xacro or at.source.path.endswith(".urdf") else "launch file"
            message = f"{user} uses package '{name}', but package.xml has no <{package.tag}> for it"
            yield Finding(package.at, message, (Note("the package is used here", at),), _fix(package, name), severity)


def _used(project: Project, launch: Launch, package: Package) -> Iterator[tuple[str, Place, Severity]]:
    """Yield the packages that the package's own launch files use in every case, with place and severity.

    A missing controller or plugin is a warning, since the robot does not move. Other missing packages are noticed at once. A
    hardware plugin counts if the package describes the robot itself.
    """
    for spawn in launch.spawns:
        for name, at in spawn.names if package.holds(spawn.at) else ():
            yield _of_controller(project, name), at, Severity.WARNING
    for word in (*(node.package for node in launch.nodes if node.sure), *launch.packages):
        if word.text in _CHECKED and package.holds(word.at):
            severity = Severity.WARNING if word.text == "controller_manager" else Severity.INFO
            yield word.text, word.at, severity
    for sim_plugin in control_plugins(project):
        if sim_plugin.known and package.holds(sim_plugin.plugin.at) and launch.ros == 1:
            yield sim_plugin.known[-1].package or "", sim_plugin.plugin.at, Severity.WARNING
    for control in components(project):
        at = control.hardware[-1].plugins[0].at
        if package.holds(at) and not is_conditional(control.hardware[-1].at):
            yield _of_hardware(project, control.plugin or ""), at, Severity.INFO
    for described in launch.descriptions:
        if (described.command or "").startswith("xacro") and described.sure and package.holds(described.at):
            yield "xacro", described.at, Severity.INFO


def _of_controller(project: Project, name: str) -> str:
    """Return the package of a spawned controller's type. Empty if it is unknown or in no maintained distro."""
    controller = project.controllers.controller(name.rpartition("/")[2]) if project.controllers else None
    kind = controller.type.text if controller and controller.type else ""
    distros = [distro for distro in project.distros if distro in MAINTAINED] or project.distros
    known = (project.catalog.controller(kind, distro) for distro in distros) if kind else ()
    return next((entry.package for entry in known if entry), "")


def _of_hardware(project: Project, name: str) -> str:
    """Return the package of a hardware plugin; empty if it is unknown, has a new name, or comes with the manager."""
    known = (project.catalog.hardware(name, distro) for distro in project.distros)
    package = next((entry.package for entry in known if entry and not entry.deprecated), "")
    return "" if package == "hardware_interface" else package


def _is_declared(name: str, package: Package) -> bool:
    declared = package.dependencies
    if name == package.name or name in declared or package.reaches(name) or set(_EVERYTHING) & declared:
        return True
    if name.endswith(("_controller", "_controllers", "_broadcaster")) and set(_CONTROLLERS) & declared:
        return True
    return any(name in brought.split() and package.reaches(bringing) for bringing, brought in _BRINGS.items())


def _fix(package: Package, name: str) -> Fix:
    element = f"<{package.tag}>{name}</{package.tag}>"
    source, end = package.at.source, package.at.closing or package.at.start
    edit = Edit(SourceSpan(source, end, end), f"  {element}\n")
    return Fix(f"add {element}", (edit,), safe=package.at.closing is not None)
