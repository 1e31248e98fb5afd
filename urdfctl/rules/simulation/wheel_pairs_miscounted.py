"""UC529."""

from __future__ import annotations

from collections.abc import Iterator

from urdfctl.catalog.distros import ROS2
from urdfctl.control.hardware.simulator_plugins import LoadedPlugin, loaded_plugins
from urdfctl.rule import Finding, Project, Severity, rule
from urdfctl.rules.common import is_all_there, is_known
from urdfctl.rules.simulation.common import number


@rule(
    "UC529",
    runtime="drops",
    severity=Severity.ERROR,
    distros=ROS2,
    authority="gazebo_plugins (ROS 2) src/gazebo_ros_diff_drive.cpp: 'Inconsistent number of joints specified. Plugin will not "
    "work.'",
    options=["--distro=galactic"],
    bad=[
        {
            "robot.urdf": """
                <gazebo>
                  «<plugin name="drive" filename="libgazebo_ros_diff_drive.so">»
                    <num_wheel_pairs>2</num_wheel_pairs>
                    <left_joint>shoulder</left_joint>
                    <right_joint>elbow</right_joint>
                    <wheel_separation>0.3</wheel_separation>
                    <wheel_diameter>0.1</wheel_diameter>
                  </plugin>
                </gazebo>
            """,
        },
    ],
    good=[
        {
            "robot.urdf": """
                <gazebo>
                  <plugin name="drive" filename="libgazebo_ros_diff_drive.so">
                    <num_wheel_pairs>1</num_wheel_pairs>
                    <left_joint>shoulder</left_joint>
                    <right_joint>elbow</right_joint>
                    <wheel_separation>0.3</wheel_separation>
                    <wheel_diameter>0.1</wheel_diameter>
                  </plugin>
                </gazebo>
            """,
        },
    ],
)
def wheel_pairs_miscounted(project: Project) -> Iterator[Finding]:
    """Number of wheel joints does not match the number of wheel pairs.

    The plugin then does nothing. Without `<num_wheel_pairs>` it expects one pair.
    """
    for sim_plugin in loaded_plugins(project):
        if sim_plugin.library != "gazebo_ros_diff_drive" or "num_wheel_pairs" not in sim_plugin.children:
            continue
        expected = _pairs(sim_plugin)
        counts = [sum(name == side for name, _ in sim_plugin.settings()) for side in ("left_joint", "right_joint")]
        if (
            expected is None
            or not all(counts)
            or not is_all_there(project, sim_plugin.plugin.tag)
            or set(counts) == {expected}
        ):
            continue
        message = (
            f"'{sim_plugin.filename}' expects {_counted(expected, 'pair')} of wheels, but has "
            f"{_counted(counts[0], 'left joint')} and {_counted(counts[1], 'right joint')}"
        )
        yield Finding(sim_plugin.plugin.at, message)


def _counted(count: int, what: str) -> str:
    return f"{count} {what}" if count == 1 else f"{count} {what}s"


def _pairs(sim_plugin: LoadedPlugin) -> int | None:
    """The number of pairs that the plugin expects; None if it is not known."""
    setting = sim_plugin.setting("num_wheel_pairs")
    if setting is None:
        return 1
    value = number(setting.text) if is_known(setting.text) else None
    return int(value) if value is not None and value == value // 1 else None
