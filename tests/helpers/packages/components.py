"""`<ros2_control>` components for the small arm, and the findings of the rules on them."""

from __future__ import annotations

from robots import Robot

MOCK = "<hardware><plugin>mock_components/GenericSystem</plugin></hardware>"
GZ = "<hardware><plugin>gz_ros2_control/GazeboSimSystem</plugin></hardware>"
ELBOW = '<joint name="elbow"><command_interface name="position"/><state_interface name="position"/></joint>'
STATE = '<state_interface name="position"/>'
FINGER = """
    <link name="finger"/>
    <joint name="grip" type="prismatic">
      <parent link="fore"/><child link="finger"/><limit lower="0" upper="1" effort="1" velocity="1"/>
    </joint>
"""
MIMIC = FINGER.replace("</joint>", '<mimic joint="elbow"/></joint>')


def component(inside: str = MOCK + ELBOW, attributes: str = 'name="arm" type="system"') -> str:
    """Return a `<ros2_control>` element."""
    return f"<ros2_control {attributes}>{inside}</ros2_control>"


def joint(inside: str, attributes: str = "", hardware: str = MOCK) -> str:
    """Return a component with the joint elbow."""
    return component(f'{hardware}<joint name="elbow"{attributes}>{inside}</joint>')


def told(robot: Robot, part: str, distro: str | None = "jazzy", **options: str) -> list[str]:
    """Return the severities and codes of the findings of the UC3 family."""
    return [finding for finding in robot.says(part, distro=distro, **options) if " UC3" in finding]
