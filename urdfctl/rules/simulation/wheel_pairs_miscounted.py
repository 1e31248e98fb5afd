"""UC529."""

from __future__ import annotations

from collections.abc import Iterator

from urdfctl.catalog.distros import ROS2
from urdfctl.rule import Finding, Project, Severity, rule
from urdfctl.rules.common import is_all_there, is_known
from urdfctl.rules.simulation.common import Loaded, loaded, number


@rule(
    "UC529",
    severity=Severity.ERROR,
    distros=ROS2,
    authority="gazebo_plugins (ROS 2) src/gazebo_ros_diff_drive.cpp: 'Inconsistent number of joints specified. Plugin will not "
    "work.'",
    options=["--distro=galactic"],
    bad={
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
    good={
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
)
def wheel_pairs_miscounted(project: Project) -> Iterator[Finding]:
    """A drive has not as many left and right joints as pairs of wheels.

    The plugin then does nothing. Without `<num_wheel_pairs>` it is one pair.
    """
    for one in loaded(project):
        if one.library != "gazebo_ros_diff_drive" or "num_wheel_pairs" not in one.children:
            continue
        wanted = _pairs(one)
        found = [sum(name == side for name, _ in one.settings()) for side in ("left_joint", "right_joint")]
        if wanted is None or not all(found) or not is_all_there(project, one.plugin.tag) or set(found) == {wanted}:
            continue
        message = (
            f"'{one.filename}' has {_counted(wanted, 'pair')} of wheels, and {_counted(found[0], 'left joint')} and "
            f"{_counted(found[1], 'right joint')}"
        )
        yield Finding(one.plugin.at, message)


def _counted(count: int, what: str) -> str:
    return f"{count} {what}" if count == 1 else f"{count} {what}s"


def _pairs(one: Loaded) -> int | None:
    """How many pairs the plugin expects; None where it cannot be told."""
    setting = one.setting("num_wheel_pairs")
    if setting is None:
        return 1
    value = number(setting.text) if is_known(setting.text) else None
    return int(value) if value is not None and value == value // 1 else None
