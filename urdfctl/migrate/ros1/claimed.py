"""Interfaces that the controllers of a simulated robot claim, and that its transmissions did not name."""

from __future__ import annotations

from collections.abc import Iterator

from urdfctl.control.hardware.interfaces import ClaimKind
from urdfctl.control.session import session_of
from urdfctl.diagnostic import Edit
from urdfctl.load.loader import LoadedTarget
from urdfctl.migrate.edits.markup import children, element_at, end_of, indent_of
from urdfctl.migrate.edits.places import ElementKey, key_of
from urdfctl.migrate.options import Part
from urdfctl.migrate.packages import MigratedPackages
from urdfctl.migrate.shared.hardware import simulated_by
from urdfctl.migrate.step import EntryKind, Proposal, ReportEntry, Row, Step
from urdfctl.source.span import SourceSpan
from urdfctl.source.xml.dom import Element

_AUTHORITY = (
    "gz_ros2_control src/gz_system.cpp: position, velocity and effort of any joint; resource_manager.cpp: claims"
)
_SIMULATED = ("position", "velocity", "effort")


def _claimed(packages: MigratedPackages) -> Iterator[Proposal]:
    if simulated_by(packages) not in ("gz", "gazebo-classic"):
        return
    missing: dict[ElementKey, dict[str, str]] = {}
    for loaded in packages.loaded(packages.options.target):
        for key, interface, controller in _missing(loaded, packages.options.target):
            missing.setdefault(key, {}).setdefault(interface, controller)
    for key, interfaces in missing.items():
        element = element_at(packages.read(key[0]), key[1]) if packages.may_change(key[0]) else None
        commands = list(children(element, "command_interface")) if element is not None else []
        if commands:
            yield _proposal(commands, interfaces)


def _missing(loaded: LoadedTarget, distro: str) -> Iterator[tuple[ElementKey, str, str]]:
    """Yield the joints as they are written, with an interface that they lack, and the controller that claims it."""
    robot = loaded.project.robot
    controls = robot.ros2_controls if robot is not None and loaded.project.controllers is not None else ()
    joints = {part.name: part for control in controls for part in control.of_kind("joint") if part.name}
    for controller in session_of(loaded.project, distro).controllers if joints else ():
        for claim in controller.claimed(ClaimKind.COMMAND):
            part = joints.get(claim.component)
            known = {str(one.name) for one in part.commands} if part is not None else set()
            if part is not None and known and claim.interface in _SIMULATED and claim.interface not in known:
                yield key_of(part.at), claim.interface, controller.name


def _proposal(commands: list[Element], interfaces: dict[str, str]) -> Proposal:
    last = commands[-1]
    indent, end = indent_of(last), end_of(last)
    text = "".join(f'\n{indent}<command_interface name="{name}"/>' for name in interfaces)
    entries = tuple(
        ReportEntry(
            EntryKind.DECIDED,
            f"controller '{controller}' claims '{name}', which no transmission named: the simulated joint has it too",
            last.at,
            authority=_AUTHORITY,
        )
        for name, controller in interfaces.items()
    )
    return Proposal((Edit(SourceSpan(last.source, end, end), text),), entries=entries)


CLAIMED = Step(
    name="claimed-interfaces",
    part=Part.URDF,
    summary="Interfaces that controllers of simulated joints claim",
    propose=_claimed,
    generation=1,
    rows=(Row("a controller for effort, a transmission for velocity", 'command "effort" too', "", _AUTHORITY),),
    before=[
        {
            "options": "--from=noetic --to=jazzy --simulator=gz",
            "robot.urdf": """
                <ros2_control name="arm" type="system">
                  <hardware>
                    <plugin>gz_ros2_control/GazeboSimSystem</plugin>
                  </hardware>
                  <joint name="elbow">
                    <command_interface name="velocity"/>
                    <state_interface name="position"/>
                  </joint>
                </ros2_control>
                <gazebo>
                  <plugin filename="gz_ros2_control-system" name="gz_ros2_control::GazeboSimROS2ControlPlugin">
                    <parameters>config/controllers.yaml</parameters>
                  </plugin>
                </gazebo>
            """,
            "config/controllers.yaml": """
                controller_manager:
                  ros__parameters:
                    push:
                      type: forward_command_controller/ForwardCommandController
                push:
                  ros__parameters:
                    joints: [elbow]
                    interface_name: effort
            """,
        },
    ],
    after=[
        {
            "robot.urdf": """
                <ros2_control name="arm" type="system">
                  <hardware>
                    <plugin>gz_ros2_control/GazeboSimSystem</plugin>
                  </hardware>
                  <joint name="elbow">
                    <command_interface name="velocity"/>
                    <command_interface name="effort"/>
                    <state_interface name="position"/>
                  </joint>
                </ros2_control>
                <gazebo>
                  <plugin filename="gz_ros2_control-system" name="gz_ros2_control::GazeboSimROS2ControlPlugin">
                    <parameters>config/controllers.yaml</parameters>
                  </plugin>
                </gazebo>
            """,
        },
    ],
)
