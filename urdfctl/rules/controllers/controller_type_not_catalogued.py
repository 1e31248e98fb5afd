"""UC424."""

from __future__ import annotations

from collections.abc import Iterator

from urdfctl.catalog.distros import ROS2
from urdfctl.control.parameters.controller_types import may_be_installed, meant_by, typed, types_beside
from urdfctl.rule import Finding, Project, Severity, rule

_LAUNCH = """
    <launch>
      <rosparam command="load" file="$(find arm)/controllers.yaml"/>
      <node name="spawner" pkg="controller_manager" type="spawner" args="base"/>
    </launch>
"""
_MANIFEST = "<package><name>arm</name><depend>%s</depend></package>"


@rule(
    "UC424",
    severity=Severity.INFO,
    runtime="works",
    authority="the catalogue of urdfctl: ros_controllers, ros2_controllers and some third-party packages",
    options=["--distro=jazzy"],
    bad=[
        {
            "controllers.yaml": """
                controller_manager:
                  ros__parameters:
                    update_rate: 100
                    arm: {type: «our_controllers/ImpedanceController»}
            """
        },
        {
            "options": "--distro=noetic",
            "arm.launch": _LAUNCH,
            "controllers.yaml": "base: {type: «my_wheels/WheelController»}",
            "package.xml": _MANIFEST % "controller_manager",
        },
    ],
    good=[
        {
            "controllers.yaml": """
                controller_manager:
                  ros__parameters:
                    update_rate: 100
                    joint_states: {type: joint_state_broadcaster/JointStateBroadcaster}
            """
        },
        {
            "options": "--distro=noetic",
            "arm.launch": _LAUNCH,
            "controllers.yaml": "base: {type: my_wheels/WheelController}",
            "package.xml": _MANIFEST % "controller_manager</depend><depend>my_wheels",
        },
    ],
)
def controller_type_not_catalogued(project: Project) -> Iterator[Finding]:
    """Controller type is not in the catalogue.

    Its parameters and interfaces cannot be checked. The type may be correct: many packages bring their own. But if
    package.xml names none that may have it, the controller manager hardly finds it. Add it to urdfctl.toml to have its
    parameters checked.
    """
    reported = set()
    for controller in typed(project):
        kind, distros = controller.type, controller.distros
        own = project.own.controllers.get(kind)
        if own is not None and "parameters" not in own and kind not in reported:
            reported.add(kind)
            why = f"package '{own['package']}' of this workspace does not define them as data"
            yield Finding(controller.at.at, f"parameters of controller type '{kind}' are not checked: {why}")
        catalog = project.catalog
        is_other = any(kind in (*catalog.known_hardware(each), *catalog.known_transmissions(each)) for each in distros)
        if controller.known_in or is_other or not kind.strip() or kind in reported or meant_by(project, controller):
            continue
        if types_beside(project, controller):
            continue
        if not set(distros) & set(ROS2) and not _is_named_like_a_controller(kind):
            continue  # in ROS 1 other things have a type too, and no manager's section lists the controllers
        reported.add(kind)
        declared = may_be_installed(project, kind)
        if declared is False:
            message = (
                f"controller type '{kind}' is unknown to urdfctl, and package.xml names no package that may have it"
            )
            yield Finding(controller.at.at, message, severity=Severity.WARNING)
        elif declared is None:
            message = f"controller type '{kind}' is unknown to urdfctl; its parameters and interfaces are not checked"
            yield Finding(controller.at.at, message)


def _is_named_like_a_controller(name: str) -> bool:
    return "controller" in name.lower() or "broadcaster" in name.lower()
