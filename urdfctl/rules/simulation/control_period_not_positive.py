"""UC528."""

from __future__ import annotations

from collections.abc import Iterator

from urdfctl.catalog.distros import ROS1
from urdfctl.control.hardware.simulator_plugins import control_plugins
from urdfctl.rule import Finding, Project, Severity, rule
from urdfctl.rules.common import is_known
from urdfctl.rules.simulation.common import number


@rule(
    "UC528",
    runtime="misbehaves",
    severity=Severity.WARNING,
    distros=ROS1,
    authority="gazebo_ros_control src/gazebo_ros_control_plugin.cpp: 'Desired controller update period (0 s) is faster than the "
    "gazebo simulation period (0.001 s).'",
    bad=[
        {
            "robot.urdf": """
                <gazebo>
                  <plugin name="gazebo_ros_control" filename="libgazebo_ros_control.so">
                    <controlPeriod>«0»</controlPeriod>
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
                    <controlPeriod>0.002</controlPeriod>
                  </plugin>
                </gazebo>
            """,
        },
    ],
)
def control_period_not_positive(project: Project) -> Iterator[Finding]:
    """Control period is not positive, or too long to be in seconds.

    `<controlPeriod>` is the time between two updates of the controllers, in seconds. Without it, they are updated in
    each step of the simulation.
    """
    for sim_plugin in control_plugins(project):
        setting = sim_plugin.setting("controlPeriod")
        value = number(setting.text) if setting and is_known(setting.text) else None
        if setting is None or value is None or 0 < value <= _LONGEST:
            continue
        message = (
            f"<controlPeriod> must be greater than 0 s, not {setting.text}; without it, the simulation step is used"
        )
        if value > 0:
            message = f"<controlPeriod> is {setting.text} s between two updates; did you mean a rate in Hz?"
        yield Finding(setting.at.content, message)


_LONGEST = 1.0
"""The longest plausible period, in s."""
