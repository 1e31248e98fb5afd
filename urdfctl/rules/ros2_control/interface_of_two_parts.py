"""UC337."""

from __future__ import annotations

from collections.abc import Iterator

from urdfctl.catalog.distros import ROS2
from urdfctl.model.ros2_control import Part, Ros2Control
from urdfctl.rule import Finding, Note, Project, Severity, rule
from urdfctl.rules.common import in_words, is_known
from urdfctl.rules.ros2_control.common import component, of_part, parts


@rule(
    "UC337",
    severity=Severity.WARNING,
    distros=ROS2,
    authority='ros2_control hardware_interface/src/resource_manager.cpp: "ResourceStorage: Tried to insert '
    'CommandInterface with already existing key. Insert[elbow/position]"',
    in_library=False,
    bad={
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
    good={
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
)
def interface_of_two_parts(project: Project) -> Iterator[Finding]:
    """Two joints, sensors or gpios of one name have the same interface.

    An interface is known by both names, such as elbow/position: the second is dropped, in whichever component it
    stands, and what it should have driven is driven by nobody.
    """
    first: dict[tuple[str, str, str], tuple[Ros2Control, Part]] = {}
    for control, part in parts(project):
        name = (part.name or "").strip()
        if not name or not is_known(name):
            continue
        keys = [(name, interface.kind, (interface.name or "").strip()) for interface in part.interfaces]
        known = [key for key in keys if is_known(key[2]) and first.setdefault(key, (control, part))[1] is not part]
        if known:
            where, before = first[known[0]]
            shared = in_words(dict.fromkeys(f"{name}/{key[2]}" for key in known))
            there = "this component" if where is control else component(where)
            be = "is" if len({key[2] for key in known}) == 1 else "are"
            message = f"{shared} of {of_part(control, part)} {be} already in {there}, and dropped here"
            yield Finding(part.at["name"], message, (Note("it is here", before.at["name"]),))
