"""UC470."""

from __future__ import annotations

from collections.abc import Iterator

from urdfctl.catalog.distros import since
from urdfctl.control.session import Configured, Session
from urdfctl.rule import Finding, Project, Severity, rule
from urdfctl.rules.claims.common import of_each_candidate
from urdfctl.rules.common import is_known
from urdfctl.suggest import did_you_mean

_MAP = "map_interface_to_joint_state"
_ROBOT = """
    <ros2_control name="arm" type="system">
      <hardware><plugin>mock_components/GenericSystem</plugin></hardware>
      <joint name="shoulder"><command_interface name="position"/><state_interface name="angle"/></joint>
      <joint name="elbow"><command_interface name="position"/><state_interface name="angle"/></joint>
    </ros2_control>
"""
_CONTROLLERS = """
    controller_manager:
      ros__parameters:
        update_rate: 100
        states: {type: joint_state_broadcaster/JointStateBroadcaster}
    states:
      ros__parameters:
        map_interface_to_joint_state:
          position: %s
"""


@rule(
    "UC470",
    severity=Severity.WARNING,
    distros=since("galactic"),
    authority='ros2_controllers joint_state_broadcaster/src/joint_state_broadcaster.cpp, on_configure: "Mapping from '
    "'angel' to interface 'position'.\"",
    whole_robot=True,
    in_library=False,
    options=["--distro=jazzy"],
    bad={"robot.urdf": _ROBOT, "controllers.yaml": _CONTROLLERS % "«angel»"},
    good={"robot.urdf": _ROBOT, "controllers.yaml": _CONTROLLERS % "angle"},
)
def mapped_interface_not_exported(project: Project) -> Iterator[Finding]:
    """A state interface is to be published as position, velocity or effort, and no hardware exports it.

    The broadcaster does not complain: the joint states are published without those values, for what bears the usual name
    is not taken in its place.
    """
    return of_each_candidate(project, _mapped)


def _mapped(session: Session, one: Configured) -> Iterator[Finding]:
    hardware = session.hardware
    if one.type is None or not one.type.publishes_joint_states or not hardware.known or hardware.open:
        return
    exported = {offer.interface for offers in hardware.state.values() for offer in offers}
    for parameter in one.controller.parameters.below(_MAP):
        name = parameter.value.text
        if name and is_known(name) and parameter.value.is_known and name not in exported and name != parameter.last:
            message = f"no hardware exports a state interface '{name}', so that joint states have no {parameter.last}"
            yield Finding(parameter.value.at, f"{message}{did_you_mean(name, exported)}")
