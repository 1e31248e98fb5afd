"""UC507."""

from __future__ import annotations

from collections.abc import Iterator

from urdfctl.catalog.distros import ROS2
from urdfctl.control.hardware.simulator_plugins import IN_GAZEBO, components, control_plugins
from urdfctl.rule import Finding, Fix, Project, Severity, Stage, rule
from urdfctl.rules.common import is_conditional, is_known, is_xacro

_ROBOT = """
    <ros2_control name="arm" type="system">
      <hardware>%s</hardware>
      <joint name="elbow"><command_interface name="position"/><state_interface name="position"/></joint>
    </ros2_control>
    <gazebo>
      <plugin filename="gz_ros2_control-system" name="gz_ros2_control::GazeboSimROS2ControlPlugin">
        <parameters>/opt/arm/controllers.yaml</parameters>
      </plugin>
    </gazebo>
"""


def _own(plugin: str, base: str) -> dict[str, str]:
    """Return the files of a package with a robot and its own hardware."""
    name, _, _ = base.partition("::")
    build = "<export><build_type>ament_cmake</build_type></export>"
    export = f"pluginlib_export_plugin_description_file({name} arm.xml)"
    return {
        "robot.urdf": _ROBOT % plugin,
        "package.xml": f'<package format="3"><name>arm</name><depend>gz_ros2_control</depend>{build}</package>',
        "CMakeLists.txt": f"project(arm)\nfind_package(ament_cmake REQUIRED)\n{export}\nament_package()\n",
        "arm.xml": f"""
            <library path="arm"><class name="arm/ArmSystem" type="arm::ArmSystem" base_class_type="{base}"/></library>
        """,
        "src/arm.cpp": f"PLUGINLIB_EXPORT_CLASS(arm::ArmSystem, {base})\n",
    }


@rule(
    "UC507",
    severity=Severity.ERROR,
    stage=Stage.HARDWARE,
    runtime="refuses",
    distros=ROS2,
    in_library=False,
    authority="gz_ros2_control src/gz_ros2_control_plugin.cpp loads only GazeboSimSystemInterface: 'The plugin failed to "
    "load for some reason. Error: According to the loaded plugin descriptions the class "
    "mock_components/GenericSystem with base class type gz_ros2_control::GazeboSimSystemInterface does not exist'",
    options=["--distro=jazzy", "--simulator=gz"],
    bad=[
        {"robot.urdf": _ROBOT % "«<plugin>»mock_components/GenericSystem</plugin>"},
        _own("«<plugin>»arm/ArmSystem</plugin>", "hardware_interface::SystemInterface"),
    ],
    good=[
        {"robot.urdf": _ROBOT % "<plugin>gz_ros2_control/GazeboSimSystem</plugin>"},
        _own("<plugin>arm/ArmSystem</plugin>", "gz_ros2_control::GazeboSimSystemInterface"),
    ],
)
def hardware_not_simulated(project: Project) -> Iterator[Finding]:
    """Hardware that Gazebo's plugin cannot load.

    The plugin in Gazebo loads only simulated hardware, neither drivers nor mock hardware. The component's joints have
    no interfaces in the simulator. Outside Gazebo the same description may be correct. It is therefore an error only if
    you name the simulator, and a warning in a file that cannot choose.
    """
    hosts = control_plugins(project)
    robot = project.robot
    if not hosts or robot is None:
        return
    severity = Severity.ERROR if project.named_simulator else Severity.INFO if is_xacro(robot) else Severity.WARNING
    for control in components(project):
        name = control.plugin or ""
        known = [project.catalog.hardware(name, distro) for distro in project.distros] if is_known(name) else []
        simulators = {hardware.simulator for hardware in known if hardware}
        is_other = bool(simulators) and not simulators & set(IN_GAZEBO)
        chosen = not project.named_simulator and is_conditional(control.hardware[-1].at)
        if chosen or not (is_other or _is_own_driver(project, name)):
            continue
        default = hosts[0].any.default_hardware if hosts[0].any else None
        message = f"'{name}' is not simulated hardware; '{hosts[0].filename}' cannot load it in Gazebo"
        fix = Fix(f"write <plugin>{default}</plugin> for the simulation") if default else None
        yield Finding(control.hardware[-1].plugins[0].at, message, fix=fix, severity=severity)


def _is_own_driver(project: Project, name: str) -> bool:
    """Whether a package of the workspace exports the hardware for controller managers, and not for a simulator."""
    own = project.own.classes.get(name)
    return own is not None and own.base.startswith("hardware_interface::")
