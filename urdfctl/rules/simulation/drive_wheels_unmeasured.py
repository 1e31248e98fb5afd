"""UC517."""

from __future__ import annotations

from collections.abc import Iterator

from urdfctl.control.hardware.simulator_plugins import loaded_plugins
from urdfctl.rule import Finding, Project, Severity, rule
from urdfctl.rules.common import is_all_there
from urdfctl.rules.simulation.common import unread_settings, wheel_measures


@rule(
    "UC517",
    severity=Severity.WARNING,
    runtime="misbehaves",
    authority="gazebo_plugins gazebo_ros_diff_drive.cpp: wheelSeparation 0.34, wheelDiameter 0.15 by default; gz-sim "
    "DiffDrive.cc: wheel_separation 1.0, wheel_radius 0.2",
    bad=[
        {
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
    ],
    good=[
        {
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
    ],
)
def drive_wheels_unmeasured(project: Project) -> Iterator[Finding]:
    """Drive without wheel size or wheel separation.

    The plugin uses a default that rarely fits. The robot turns and drives faster or slower than commanded, and its
    odometry is wrong.
    """
    misspelt = {(unread.sim_plugin.plugin.at, unread.meant) for unread in unread_settings(project)}
    for sim_plugin in loaded_plugins(project):
        if not sim_plugin.drives or not is_all_there(project, sim_plugin.plugin.tag):
            continue
        for name, default in wheel_measures(sim_plugin):
            if sim_plugin.setting(name) is None and (sim_plugin.plugin.at, name) not in misspelt:
                message = f"'{sim_plugin.filename}' has no <{name}> and uses the default of {default:g} m"
                yield Finding(sim_plugin.plugin.at, message)
