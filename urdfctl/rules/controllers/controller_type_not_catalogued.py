"""UC424."""

from __future__ import annotations

from collections.abc import Iterator

from urdfctl.catalog.distros import ROS2
from urdfctl.rule import Finding, Project, Severity, rule
from urdfctl.rules.controllers.types import meant_by, typed


@rule(
    "UC424",
    severity=Severity.INFO,
    authority="the catalogue of urdfctl: ros_controllers, ros2_controllers and some packages of others",
    options=["--distro=jazzy"],
    bad={
        "controllers.yaml": """
            controller_manager:
              ros__parameters:
                update_rate: 100
                arm: {type: «our_controllers/ImpedanceController»}
        """
    },
    good={
        "controllers.yaml": """
            controller_manager:
              ros__parameters:
                update_rate: 100
                joint_states: {type: joint_state_broadcaster/JointStateBroadcaster}
        """
    },
)
def controller_type_not_catalogued(project: Project) -> Iterator[Finding]:
    """A type of controller is in no catalogue, so that its parameters and interfaces are not judged.

    It may well be right: packages bring their own. Add it to urdfctl.toml, and its parameters are looked at too.
    """
    told = set()
    for one in typed(project):
        hardware = any(one.type in project.catalog.known_hardware(distro) for distro in one.distros)
        if one.known_in or hardware or not one.type.strip() or one.type in told or meant_by(project, one):
            continue
        if not set(one.distros) & set(ROS2) and not _is_named_like_a_controller(one.type):
            continue  # ROS 1 gives many things a type: no manager's section tells which are controllers
        told.add(one.type)
        message = f"'{one.type}' is not in the catalogue: its parameters and interfaces are not judged"
        yield Finding(one.at.at, message)


def _is_named_like_a_controller(name: str) -> bool:
    return "controller" in name.lower() or "broadcaster" in name.lower()
