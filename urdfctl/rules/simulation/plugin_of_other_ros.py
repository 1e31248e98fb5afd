"""UC504."""

from __future__ import annotations

from collections.abc import Iterator

from urdfctl.catalog.distros import ROS1, in_words, since
from urdfctl.rule import Finding, Note, Project, Severity, rule
from urdfctl.rules.common import replaced
from urdfctl.rules.simulation.common import ROS_2, Loaded, control_plugins, loaded, of_sensors
from urdfctl.rules.simulation.facts import IN_PLACE, LIBRARIES


@rule(
    "UC504",
    severity=Severity.ERROR,
    authority="gazebo common/Plugin.hh: 'Failed to load plugin libgazebo_ros_control.so: cannot open shared object file'; "
    "gz-sim src/SystemLoader.cc: 'couldn't find shared library'",
    options=["--distro=humble"],
    bad={
        "robot.urdf": """
            <gazebo>
              <plugin name="gazebo_ros_control" filename="«libgazebo_ros_control.so»"/>
            </gazebo>
        """,
    },
    good={
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
)
def plugin_of_other_ros(project: Project) -> Iterator[Finding]:
    """A plugin of Gazebo does not exist in this distro: it is of the other ROS, or of a later or earlier distro.

    The library is not found and the plugin not loaded. Of ros_control's own plugin everything depends: without it no
    controller manager runs in the simulator, and spawners wait for it until they give up.
    """
    for one in (*loaded(project), *of_sensors(project)):
        where = _where(project, one)
        if where is None:
            continue
        at = one.plugin.at["filename"]
        right = _in_place(project, one)
        vital = one.hosts_control or one.moves_joints
        sure = vital and not (one.any and one.any.external) and not any(host.known for host in control_plugins(project))
        severity = Severity.ERROR if sure else Severity.WARNING
        message = f"'{one.filename}' is not in {in_words(project.distros)}, but in {where}"
        fix = replaced(at, one.plugin.filename or "", right) if right else None
        yield Finding(at, message, tuple(_notes(project, one)), fix, severity)


def _where(project: Project, one: Loaded) -> str | None:
    """In which distros a plugin is that none of the project's has; None where one has it, or it is not known.

    That Gazebo Classic is gone from jazzy on is told apart, by a rule on moving on."""
    if one.known or (set(project.distros) <= set(since("jazzy")) and one.simulator == "gazebo-classic"):
        return None
    if one.distros:
        return in_words(one.distros)
    ros = project.ros
    other = {1: 2, 2: 1}.get(ros or 0)
    if ros is None or other is None or one.library in LIBRARIES[ros] or one.library not in LIBRARIES[other]:
        return None
    return f"ROS {other}"


def _in_place(project: Project, one: Loaded) -> str | None:
    """The file to load instead."""
    if one.hosts_control and project.ros == ROS_2:
        last = project.distros[-1]
        wanted = "gz" if project.named_simulator == "gz" or one.simulator == "gz" or last in since("jazzy") else None
        hosts = [plugin for plugin in project.catalog.simulator_plugins(last) if plugin.hosts_control]
        found = [plugin for plugin in hosts if plugin.simulator == (wanted or "gazebo-classic")]
        return found[-1].filenames[0] if found else None
    return IN_PLACE[project.ros or 1].get(one.library)


def _notes(project: Project, one: Loaded) -> Iterator[Note]:
    if one.hosts_control and project.ros == ROS_2 and set(one.distros) <= set(ROS1):
        yield Note("in ROS 2 it reads <parameters> and <ros><namespace>, and the joints from <ros2_control>")
    if one.library == "gazebo_ros_skid_steer_drive" and project.ros == ROS_2:
        yield Note("write <num_wheel_pairs>2</num_wheel_pairs>, and <left_joint> and <right_joint> twice")
