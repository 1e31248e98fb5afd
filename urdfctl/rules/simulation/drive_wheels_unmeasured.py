"""UC517."""

from __future__ import annotations

from collections.abc import Iterator

from urdfctl.rule import Finding, Project, Severity, rule
from urdfctl.rules.common import is_all_there
from urdfctl.rules.simulation.common import loaded, unread_settings, wheel_measures


@rule(
    "UC517",
    severity=Severity.WARNING,
    authority="gazebo_plugins gazebo_ros_diff_drive.cpp: wheelSeparation 0.34, wheelDiameter 0.15 where none is given; gz-sim "
    "DiffDrive.cc: wheel_separation 1.0, wheel_radius 0.2",
    bad={
        "robot.urdf": """
            <gazebo>
              «<plugin name="drive" filename="libgazebo_ros_diff_drive.so">»
                <leftJoint>shoulder</leftJoint>
                <rightJoint>elbow</rightJoint>
                <wheelDiameter>0.1</wheelDiameter>
              </plugin>
            </gazebo>
        """,
    },
    good={
        "robot.urdf": """
            <gazebo>
              <plugin name="drive" filename="libgazebo_ros_diff_drive.so">
                <leftJoint>shoulder</leftJoint>
                <rightJoint>elbow</rightJoint>
                <wheelSeparation>0.3</wheelSeparation>
                <wheelDiameter>0.1</wheelDiameter>
              </plugin>
            </gazebo>
        """,
    },
)
def drive_wheels_unmeasured(project: Project) -> Iterator[Finding]:
    """A drive is not told how large its wheels are, or how far apart.

    It takes a default that is hardly ever yours: the robot turns and drives faster or slower than it is told, and its
    odometry is wrong.
    """
    misspelt = {(unread.one.plugin.at, unread.meant) for unread in unread_settings(project)}
    for one in loaded(project):
        if not one.drives or not is_all_there(project, one.plugin.tag):
            continue
        for name, default in wheel_measures(one):
            if one.setting(name) is None and (one.plugin.at, name) not in misspelt:
                message = f"'{one.filename}' is not told its <{name}>, and takes {default:g} m"
                yield Finding(one.plugin.at, message)
