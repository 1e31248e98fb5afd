"""UC504."""

from __future__ import annotations

from collections.abc import Iterator

from urdfctl.catalog.distros import ROS1, in_words, since
from urdfctl.control.hardware.gazebo_plugins import IN_PLACE, LIBRARIES
from urdfctl.control.hardware.simulator_plugins import (
    LoadedPlugin,
    control_plugins,
    has_other_hardware,
    loaded_plugins,
    of_sensors,
)
from urdfctl.rule import Finding, Note, Project, Severity, rule
from urdfctl.rules.common import replaced
from urdfctl.rules.simulation.common import ROS_2


@rule(
    "UC504",
    severity=Severity.ERROR,
    runtime="drops",
    authority="gazebo common/Plugin.hh: 'Failed to load plugin libgazebo_ros_control.so: cannot open shared object file'; "
    "gz-sim src/SystemLoader.cc: 'couldn't find shared library'",
    options=["--distro=humble"],
    bad=[
        {
            "robot.urdf": """
                <gazebo>
                  <plugin name="gazebo_ros_control" filename="«libgazebo_ros_control.so»"/>
                </gazebo>
            """,
        },
    ],
    good=[
        {
            "robot.urdf": """
                <ros2_control name="arm" type="system">
                  <hardware><plugin>gz_ros2_control/GazeboSimSystem</plugin></hardware>
                  <joint name="elbow"><command_interface name="position"/><state_interface name="position"/></joint>
                </ros2_control>
                <gazebo>
                  <plugin filename="gz_ros2_control-system" name="gz_ros2_control::GazeboSimROS2ControlPlugin">
                    <parameters>/opt/arm/controllers.yaml</parameters>
                  </plugin>
                </gazebo>
            """,
        },
    ],
)
def plugin_of_other_ros(project: Project) -> Iterator[Finding]:
    """Gazebo plugin is not available in this distro.

    The plugin belongs to the other ROS version, or to an earlier or later distro. Its library is not found, and the
    plugin is not loaded. Without the plugin of ros_control, no controller manager runs in the simulator. Spawners wait
    for it until they give up. It is only a warning for a robot whose hardware does not run in a simulator.
    """
    for sim_plugin in (*loaded_plugins(project), *of_sensors(project)):
        where = _where(project, sim_plugin)
        if where is None:
            continue
        at = sim_plugin.plugin.at["filename"]
        replacement = _in_place(project, sim_plugin)
        vital = sim_plugin.hosts_control or sim_plugin.moves_joints
        sure = (
            vital
            and not (sim_plugin.any and sim_plugin.any.external)
            and not any(host.known for host in control_plugins(project))
            and not has_other_hardware(project)
            and _is_controlled(project)
        )
        severity = Severity.ERROR if sure else Severity.WARNING
        here = (
            f"ROS {project.ros}"
            if where in ("ROS 1", "ROS 2") and project.distro is None
            else in_words(project.distros)
        )
        message = f"'{sim_plugin.filename}' is not available in {here}, only in {where}"
        fix = replaced(at, sim_plugin.plugin.filename or "", replacement) if replacement else None
        yield Finding(at, message, tuple(_notes(project, sim_plugin)), fix, severity)


def _is_controlled(project: Project) -> bool:
    """Whether the user names the distro, or the robot has parts for its controllers: otherwise it may only be shown."""
    parts = project.robot is not None and project.robot.ros2_controls
    return project.distro is not None or project.controllers is not None or bool(parts)


def _where(project: Project, sim_plugin: LoadedPlugin) -> str | None:
    """The distros of a plugin that none of the project's distros has; None if one has it, or it is not known.

    Gazebo Classic is gone since jazzy: a migration rule reports that.
    """
    if sim_plugin.known or (set(project.distros) <= set(since("jazzy")) and sim_plugin.simulator == "gazebo-classic"):
        return None
    if sim_plugin.distros:
        return in_words(sim_plugin.distros)
    ros = project.ros
    other = {1: 2, 2: 1}.get(ros or 0)
    if (
        ros is None
        or other is None
        or sim_plugin.library in LIBRARIES[ros]
        or sim_plugin.library not in LIBRARIES[other]
    ):
        return None
    return f"ROS {other}"


def _in_place(project: Project, sim_plugin: LoadedPlugin) -> str | None:
    """The file to load instead."""
    if sim_plugin.hosts_control and project.ros == ROS_2:
        last = project.distros[-1]
        wanted = (
            "gz" if project.named_simulator == "gz" or sim_plugin.simulator == "gz" or last in since("jazzy") else None
        )
        hosts = [plugin for plugin in project.catalog.simulator_plugins(last) if plugin.hosts_control]
        fitting = [plugin for plugin in hosts if plugin.simulator == (wanted or "gazebo-classic")]
        return fitting[-1].filenames[0] if fitting else None
    return IN_PLACE[project.ros or 1].get(sim_plugin.library)


def _notes(project: Project, sim_plugin: LoadedPlugin) -> Iterator[Note]:
    if sim_plugin.hosts_control and project.ros == ROS_2 and set(sim_plugin.distros) <= set(ROS1):
        yield Note("in ROS 2, the plugin reads <parameters>, <ros><namespace>, and the joints of <ros2_control>")
    if sim_plugin.library == "gazebo_ros_skid_steer_drive" and project.ros == ROS_2:
        yield Note("add <num_wheel_pairs>2</num_wheel_pairs>, and two each of <left_joint> and <right_joint>")
