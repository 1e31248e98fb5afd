"""UC419."""

from __future__ import annotations

from collections.abc import Iterator

from urdfctl.catalog.distros import since
from urdfctl.control.parameters.readers import controllers_in, robot_of
from urdfctl.names import nearest
from urdfctl.rule import Finding, Project, Severity, rule
from urdfctl.rules.common import is_known, replaced

_STATES = "hardware_components_initial_state"
_ROBOT = """
    <ros2_control name="arm_hardware" type="system">
      <hardware><plugin>mock_components/GenericSystem</plugin></hardware>
      <joint name="shoulder"><command_interface name="position"/><state_interface name="position"/></joint>
    </ros2_control>
"""
_FILE = """
    controller_manager:
      ros__parameters:
        update_rate: 100
        hardware_components_initial_state:
          inactive: [%s]
        states: {type: joint_state_broadcaster/JointStateBroadcaster}
"""


@rule(
    "UC419",
    runtime="warns",
    severity=Severity.WARNING,
    distros=since("humble"),
    authority="ros2_control controller_manager/src/controller_manager.cpp: 'Hardware component 'arm_hardwre' is unknown, "
    "therefore not set in 'inactive' state.'",
    whole_robot=True,
    in_library=False,
    options=["--distro=jazzy"],
    bad=[{"robot.urdf": _ROBOT, "controllers.yaml": _FILE % "«arm_hardwre»"}],
    good=[{"robot.urdf": _ROBOT, "controllers.yaml": _FILE % "arm_hardware"}],
)
def hardware_component_unknown(project: Project) -> Iterator[Finding]:
    """Unknown hardware component in hardware_components_initial_state.

    The names must be those of `<ros2_control>` elements. For an unknown name the manager prints a warning, and
    activates all components.
    """
    robot = robot_of(project)
    names = [control.name for control in robot.ros2_controls] if robot else []
    if not names or not is_known(*names):
        return
    for manager in controllers_in(project).managers:
        for state in ("inactive", "unconfigured"):
            given = manager.parameters.value(f"{_STATES}.{state}")
            for name, at in given.strings if given and given.is_known else ():
                if name not in names:
                    right = nearest(name, [known for known in names if known])
                    hint = f"; did you mean '{right}'?" if right else ""
                    fix = replaced(at, name, right) if right else None
                    yield Finding(at, f"hardware component '{name}' does not exist in the robot{hint}", fix=fix)
