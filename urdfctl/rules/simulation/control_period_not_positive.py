"""UC528."""

from __future__ import annotations

from collections.abc import Iterator

from urdfctl.catalog.distros import ROS1
from urdfctl.rule import Finding, Project, Severity, rule
from urdfctl.rules.common import is_known
from urdfctl.rules.simulation.common import control_plugins, number


@rule(
    "UC528",
    severity=Severity.WARNING,
    distros=ROS1,
    authority="gazebo_ros_control src/gazebo_ros_control_plugin.cpp: 'Desired controller update period (0 s) is faster than the "
    "gazebo simulation period (0.001 s).'",
    bad={
        "robot.urdf": """
            <gazebo>
              <plugin name="gazebo_ros_control" filename="libgazebo_ros_control.so">
                <controlPeriod>«0»</controlPeriod>
              </plugin>
            </gazebo>
        """,
    },
    good={
        "robot.urdf": """
            <gazebo>
              <plugin name="gazebo_ros_control" filename="libgazebo_ros_control.so">
                <controlPeriod>0.002</controlPeriod>
              </plugin>
            </gazebo>
        """,
    },
)
def control_period_not_positive(project: Project) -> Iterator[Finding]:
    """The period of ros_control's plugin is not more than 0 seconds, or so long that a rate in Hz was meant.

    It is the time between two updates of the controllers, in seconds; without it they are updated in each step of the
    simulation.
    """
    for one in control_plugins(project):
        setting = one.setting("controlPeriod")
        value = number(setting.text) if setting and is_known(setting.text) else None
        if setting is None or value is None or 0 < value <= _LONGEST:
            continue
        message = (
            f"<controlPeriod> is {setting.text} s, and must be more than 0; without it, it is the simulation's step"
        )
        if value > 0:
            message = f"<controlPeriod> is {setting.text} s between two updates; is a rate in Hz meant?"
        yield Finding(setting.at.content, message)


_LONGEST = 1.0
"""In s. Nobody controls more slowly."""
