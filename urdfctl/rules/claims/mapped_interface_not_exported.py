"""UC470."""

from __future__ import annotations

from collections.abc import Iterator

from urdfctl.catalog.distros import since
from urdfctl.control.session import Configured, Session
from urdfctl.names import did_you_mean
from urdfctl.rule import Finding, Project, Severity, rule
from urdfctl.rules.claims.common import of_each_candidate
from urdfctl.rules.common import is_known

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
    runtime="ignores",
    distros=since("galactic"),
    authority='ros2_controllers joint_state_broadcaster/src/joint_state_broadcaster.cpp, on_configure: "Mapping from '
    "'angel' to interface 'position'.\"",
    whole_robot=True,
    in_library=False,
    options=["--distro=jazzy"],
    bad=[{"robot.urdf": _ROBOT, "controllers.yaml": _CONTROLLERS % "«angel»"}],
    good=[{"robot.urdf": _ROBOT, "controllers.yaml": _CONTROLLERS % "angle"}],
)
def mapped_interface_not_exported(project: Project) -> Iterator[Finding]:
    """Mapped state interface is not exported.

    `map_interface_to_joint_state` publishes this interface as position, velocity or effort, but no hardware exports it.
    The broadcaster reports nothing, and does not use the interface with the usual name instead: the joint states lack
    these values.
    """
    return of_each_candidate(project, _mapped)


def _mapped(session: Session, controller: Configured) -> Iterator[Finding]:
    hardware, kind = session.hardware, controller.type
    if kind is None or not kind.publishes_joint_states or not hardware.known or hardware.open:
        return
    exported = {offer.interface for offers in hardware.state.values() for offer in offers}
    for parameter in controller.controller.parameters.below(_MAP):
        name = parameter.value.text
        if name and is_known(name) and parameter.value.is_known and name not in exported and name != parameter.last:
            message = f"no hardware exports state interface '{name}'; the joint states have no {parameter.last}"
            yield Finding(parameter.value.at, f"{message}{did_you_mean(name, exported)}")
