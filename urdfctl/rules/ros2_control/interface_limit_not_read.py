"""UC352."""

from __future__ import annotations

from collections.abc import Iterator

from urdfctl.catalog.distros import ROS2
from urdfctl.model.robot import Interface
from urdfctl.rule import Finding, Project, Severity, rule
from urdfctl.rules.common import in_words, is_known, label, replaced
from urdfctl.rules.ros2_control.common import JAZZY, called, known_hardware, parts

_READ = ("min", "max", "initial_value")
_MEANT = {"minimum": "min", "lower": "min", "maximum": "max", "upper": "max", "initialvalue": "initial_value"}
_LIMITED = ("position", "velocity", "effort", "acceleration", "jerk")


@rule(
    "UC352",
    severity=Severity.WARNING,
    runtime="ignores",
    distros=ROS2,
    authority='ros2_control hardware_interface/src/component_parser.cpp: "Jerk only accepts max limits."; it looks '
    "for min and max in lower case",
    bad=[
        {
            "robot.urdf": """
                <ros2_control name="arm" type="system">
                  <hardware><plugin>mock_components/GenericSystem</plugin></hardware>
                  <joint name="elbow">
                    <command_interface name="position">
                      <param name="«Min»">-1</param>
                    </command_interface>
                    <state_interface name="position"/>
                  </joint>
                </ros2_control>
            """,
        },
        {
            "options": "--distro=jazzy",
            "robot.urdf": """
                <ros2_control name="arm" type="system">
                  <hardware><plugin>mock_components/GenericSystem</plugin></hardware>
                  <joint name="elbow">
                    <command_interface name="position">
                      <param name="«minimum»">-1</param>
                      <param name="«upper»">1</param>
                    </command_interface>
                    <command_interface name="velocity"><param name="«Maximum»">1</param></command_interface>
                    <command_interface name="acceleration"><param name="«lower»">-1</param><param name="«MAX»">1</param></command_interface>
                    <command_interface name="jerk">«<param name="min">»-1</param></command_interface>
                    <command_interface name="current">«<param name="max">»1</param></command_interface>
                    <state_interface name="position"><param name="«initialValue»">0</param></state_interface>
                    <state_interface name="velocity"><param name="«Initial_Value»">0</param></state_interface>
                  </joint>
                </ros2_control>
            """,
        },
    ],
    good=[
        {
            "robot.urdf": """
                <ros2_control name="arm" type="system">
                  <hardware><plugin>mock_components/GenericSystem</plugin></hardware>
                  <joint name="elbow">
                    <command_interface name="position">
                      <param name="min">-1</param>
                    </command_interface>
                    <state_interface name="position"/>
                  </joint>
                </ros2_control>
            """,
        },
        {
            "options": "--distro=jazzy",
            "robot.urdf": """
                <ros2_control name="arm" type="system">
                  <hardware><plugin>mock_components/GenericSystem</plugin></hardware>
                  <joint name="elbow">
                    <command_interface name="position"><param name="max">1</param></command_interface>
                    <command_interface name="velocity"><param name="max">1</param></command_interface>
                    <command_interface name="effort"><param name="max">1</param></command_interface>
                    <command_interface name="acceleration"><param name="max">1</param></command_interface>
                    <command_interface name="jerk"><param name="max">1</param></command_interface>
                    <state_interface name="position"/>
                  </joint>
                </ros2_control>
            """,
        },
        {
            "robot.urdf": """
                <ros2_control name="arm" type="system">
                  <hardware><plugin>arm_driver/ArmSystem</plugin></hardware>
                  <joint name="elbow">
                    <command_interface name="position"><param name="lower">-1</param></command_interface>
                    <state_interface name="position"/>
                  </joint>
                </ros2_control>
            """,
        },
    ],
)
def interface_limit_not_read(project: Project) -> Iterator[Finding]:
    """Ignored limit of an interface.

    The parameter must be `min` or `max` in lower case, and jerk has only a `max`. Limits exist for position, velocity,
    effort, acceleration and jerk of a joint. Since jazzy, limits of other interfaces are left to the hardware, and
    simulated hardware ignores them.
    """
    for control, part in parts(project):
        simulated = [each.distro for each in known_hardware(project, control) if each.simulator]
        for interface in part.interfaces:
            of = f"{called(interface)} of {label(part.kind, part.name)}"
            for parameter in interface.parameters:
                name = parameter.name or ""
                meant = _meant(name, simulated=bool(simulated))
                if meant:
                    at = parameter.at["name"]
                    fix = replaced(at, name, meant, safe=name.lower() == meant)
                    yield Finding(at, f"'{name}' of {of} is ignored; did you mean '{meant}'?", fix=fix)
                elif name == "min" and interface.name == "jerk" and interface.kind == "command":
                    message = f"'min' of {of} is ignored; jerk has only 'max', for both directions"
                    yield Finding(parameter.at, message)
            if part.kind == "joint" and set(JAZZY) & set(simulated):
                yield from _of_others(interface, of)


def _meant(name: str, *, simulated: bool) -> str | None:
    """The parameter that an ignored name means; hardware that is not simulated may read any name."""
    if name.lower() in _READ:
        return name.lower() if name not in _READ else None
    return _MEANT.get(name.lower()) if simulated else None


def _of_others(interface: Interface, of: str) -> Iterator[Finding]:
    """The finding for a joint's command interface whose limits are ignored."""
    limits = [parameter for parameter in interface.parameters if parameter.name in ("min", "max")]
    if interface.kind == "command" and limits and interface.name not in _LIMITED and is_known(interface.name):
        yield Finding(limits[0].at, f"limits of {of} are ignored; limits exist only for {in_words(_LIMITED)}")
