"""UC337."""

from __future__ import annotations

from collections.abc import Iterator

from urdfctl.catalog.distros import ROS2
from urdfctl.model.robot import ComponentPart, Ros2Control
from urdfctl.rule import Finding, Note, Project, Severity, rule
from urdfctl.rules.common import in_words, is_known
from urdfctl.rules.ros2_control.common import component, of_part, parts


@rule(
    "UC337",
    severity=Severity.WARNING,
    runtime="ignores",
    distros=ROS2,
    authority='ros2_control hardware_interface/src/resource_manager.cpp: "ResourceStorage: Tried to insert '
    'CommandInterface with already existing key. Insert[elbow/position]"',
    in_library=False,
    bad=[
        {
            "robot.urdf": """
                <ros2_control name="arm" type="system">
                  <hardware><plugin>mock_components/GenericSystem</plugin></hardware>
                  <joint name="elbow"><command_interface name="position"/><state_interface name="position"/></joint>
                </ros2_control>
                <ros2_control name="forearm" type="system">
                  <hardware><plugin>mock_components/GenericSystem</plugin></hardware>
                  <joint name="«elbow»"><command_interface name="position"/><state_interface name="position"/></joint>
                </ros2_control>
            """,
        },
    ],
    good=[
        {
            "robot.urdf": """
                <ros2_control name="arm" type="system">
                  <hardware><plugin>mock_components/GenericSystem</plugin></hardware>
                  <joint name="elbow"><command_interface name="position"/><state_interface name="position"/></joint>
                </ros2_control>
                <ros2_control name="base" type="system">
                  <hardware><plugin>mock_components/GenericSystem</plugin></hardware>
                  <joint name="shoulder"><command_interface name="position"/><state_interface name="position"/></joint>
                </ros2_control>
            """,
        },
    ],
)
def interface_of_two_parts(project: Project) -> Iterator[Finding]:
    """Interface declared by two joints, sensors or gpios of the same name.

    An interface is identified by both names, such as `elbow/position`. The second one is dropped, whichever component
    it is in, and nothing drives its hardware.
    """
    first: dict[tuple[str, str, str], tuple[Ros2Control, ComponentPart]] = {}
    for control, part in parts(project):
        name = (part.name or "").strip()
        if not name or not is_known(name):
            continue
        keys = [(name, interface.kind, (interface.name or "").strip()) for interface in part.interfaces]
        repeated = [key for key in keys if is_known(key[2]) and first.setdefault(key, (control, part))[1] is not part]
        if repeated:
            where, before = first[repeated[0]]
            shared = in_words(dict.fromkeys(f"{name}/{key[2]}" for key in repeated))
            owner = "this component" if where is control else component(where)
            dropped = "it is" if len({key[2] for key in repeated}) == 1 else "they are"
            message = f"{of_part(control, part)} declares {shared}, as {owner} already does; {dropped} dropped here"
            yield Finding(part.at["name"], message, (Note("first declared here", before.at["name"]),))
