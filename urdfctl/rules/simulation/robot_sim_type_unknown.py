"""UC526."""

from __future__ import annotations

from collections.abc import Iterator

from urdfctl.catalog.distros import ROS1
from urdfctl.control.hardware.simulator_plugins import control_plugins
from urdfctl.names import folded, is_slip
from urdfctl.rule import Finding, Project, Severity, rule
from urdfctl.rules.common import is_known, replaced


@rule(
    "UC526",
    severity=Severity.ERROR,
    runtime="drops",
    distros=ROS1,
    authority="gazebo_ros_control src/gazebo_ros_control_plugin.cpp: 'Failed to create robot simulation interface loader: "
    "According to the loaded plugin descriptions the class ... does not exist'",
    bad=[
        {
            "robot.urdf": """
                <gazebo>
                  <plugin name="gazebo_ros_control" filename="libgazebo_ros_control.so">
                    <robotSimType>«gazebo_ros_control::DefaultRobotHWSim»</robotSimType>
                  </plugin>
                </gazebo>
            """,
        },
    ],
    good=[
        {
            "robot.urdf": """
                <gazebo>
                  <plugin name="gazebo_ros_control" filename="libgazebo_ros_control.so">
                    <robotSimType>gazebo_ros_control/DefaultRobotHWSim</robotSimType>
                  </plugin>
                </gazebo>
            """,
        },
    ],
)
def robot_sim_type_unknown(project: Project) -> Iterator[Finding]:
    """Misspelt `<robotSimType>` of the ros_control plugin.

    The name is looked up as `package/Class`. If the class does not exist, Gazebo goes on without a controller manager.
    A name that resembles no known class may be your own, and is not reported.
    """
    known = {name for distro in project.distros if distro in ROS1 for name in project.catalog.known_hardware(distro)}
    for sim_plugin in control_plugins(project):
        setting = sim_plugin.setting("robotSimType")
        name = setting.text if setting else ""
        meant = _meant(name, known) if is_known(name) and name not in project.own.hardware else None
        if setting is None or meant is None:
            continue
        at = setting.at.content
        yield Finding(at, f"unknown <robotSimType> '{name}'; did you mean '{meant}'?", fix=replaced(at, name, meant))


def _meant(name: str, known: set[str]) -> str | None:
    if not name or name in known:
        return None
    key = folded(name.replace("::", "/"))
    for candidate in sorted(known):
        other = folded(candidate)
        if key in (other, other.partition("/")[2]) or is_slip(key, other):
            return candidate
    return None
