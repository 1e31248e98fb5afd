"""What commands a mobile base, from jazzy on with a stamp: the nodes that do so, and their topics."""

from __future__ import annotations

import re
from collections.abc import Iterator, Mapping

from urdfctl.diagnostic import Edit
from urdfctl.migrate.edits.tokens import tokens_in
from urdfctl.migrate.edits.yaml_edits import MapEdits
from urdfctl.migrate.options import Part
from urdfctl.migrate.packages import MigratedPackages
from urdfctl.migrate.shared.controller_files import FileSection, sections, type_names
from urdfctl.migrate.step import EntryKind, Proposal, ReportEntry, Row, Step
from urdfctl.source.disk.files import is_launch
from urdfctl.source.span import Place, SourceSpan

SINCE = "jazzy"
_STAMPED = "ros2_controllers#812, #958: ~/cmd_vel is always geometry_msgs/msg/TwistStamped"
_NAV2 = "docs.nav2.org, Iron to Jazzy: enable_stamped_cmd_vel"
_READERS = (
    "diff_drive_controller/",
    "tricycle_controller/",
    "mecanum_drive_controller/",
    "omni_wheel_drive_controller/",
    "ackermann_steering_controller/",
    "bicycle_steering_controller/",
    "tricycle_steering_controller/",
)
"""The beginnings of the types of controllers that read stamped velocities."""
PARAMETERS: Mapping[str, tuple[str, str]] = {
    **dict.fromkeys(
        ("controller_server", "behavior_server", "velocity_smoother", "collision_monitor", "docking_server"),
        ("enable_stamped_cmd_vel", _NAV2),
    ),
    "twist_mux": ("use_stamped", "ros-teleop twist_mux: use_stamped"),
    "teleop_twist_joy_node": ("publish_stamped_twist", "ros2 teleop_twist_joy README: publish_stamped_twist"),
    "teleop_twist_keyboard": ("stamped", "ros2 teleop_twist_keyboard README: stamped"),
}
"""By node: its parameter for velocities with a stamp, and the authority."""
_OF_JOYSTICK = ("axis_linear", "scale_linear", "axis_angular")
_OLD_TOPIC = re.compile(r"(\w+)/(cmd_vel|reference)_unstamped\Z")


def drives(packages: MigratedPackages) -> set[str]:
    """Return the controllers of the packages that read stamped velocities, if they did not before the migration."""
    readers = (one for one in packages.found(type_names) if one.value.text.startswith(_READERS))
    return {one.controller for one in readers if packages.crosses(SINCE, one.path)}


def _publishers(packages: MigratedPackages) -> Iterator[Proposal]:
    for section in packages.found(sections) if drives(packages) else ():
        parameter = _parameter(section)
        known = {entry.key.text for entry in section.parameters.entries}
        if parameter is None or parameter[0] in known or not packages.may_change(section.path):
            continue
        name, authority = parameter
        edits = MapEdits(packages.read(section.path))
        edits.insert(section.parameters, f"{name}: true")
        what = f"'{section.node}' publishes velocities with a stamp, which the controllers read: {name}"
        entry = ReportEntry(
            EntryKind.DECIDED, what, section.parameters.at, authority=authority, option=f"remove {name}"
        )
        yield Proposal(edits.edits(), entries=(entry,))


def _parameter(section: FileSection) -> tuple[str, str] | None:
    if not section.parameters.entries:
        return None
    names = {entry.key.text.partition(".")[0] for entry in section.parameters.entries}
    node = "teleop_twist_joy_node" if names & {*_OF_JOYSTICK} else section.node
    return PARAMETERS.get(node)


def _topics(packages: MigratedPackages) -> Iterator[Proposal]:
    readers = drives(packages)
    for path in packages.files(".py", ".xml", ".launch", ".yaml", ".yml") if readers else ():
        source = packages.read(path)
        is_read = b"_unstamped" in source.data and (_starts(path, source.data) or path.endswith((".yaml", ".yml")))
        for token in tokens_in(source) if is_read and packages.may_change(path) else ():
            found = _OLD_TOPIC.search(token.text)
            if found is None or found[1] not in readers:
                continue
            start = token.end - len(b"_unstamped")
            what = f"the topic '{token.text}' is now '{token.text.removesuffix('_unstamped')}'"
            entry = ReportEntry(EntryKind.DONE, what, Place(source, token.start, end=token.end), authority=_STAMPED)
            yield Proposal((Edit(SourceSpan(source, start, token.end), ""),), entries=(entry,))


def _starts(path: str, data: bytes) -> bool:
    """Whether a file starts nodes; other code publishes the message itself, and its type would stay."""
    return is_launch(path) and (not path.endswith(".py") or b"generate_launch_description" in data)


STAMPED = Step(
    name="stamped-velocities",
    part=Part.YAML,
    summary="Nodes that command a mobile base",
    propose=_publishers,
    rows=tuple(
        Row(f"{node} without {parameter}", f"{parameter}: true", SINCE, authority)
        for node, (parameter, authority) in PARAMETERS.items()
    ),
    before=[
        {
            "options": "--from=humble --to=jazzy",
            "config/controllers.yaml": """
                controller_manager:
                  ros__parameters:
                    update_rate: 100
                    base:
                      type: diff_drive_controller/DiffDriveController
                base:
                  ros__parameters:
                    left_wheel_names: [left]
                    right_wheel_names: [right]
                    wheel_separation: 0.4
                    wheel_radius: 0.1
            """,
            "config/nav.yaml": """
                controller_server:
                  ros__parameters:
                    controller_frequency: 20.0
            """,
        },
    ],
    after=[
        {
            "config/nav.yaml": """
                controller_server:
                  ros__parameters:
                    controller_frequency: 20.0
                    enable_stamped_cmd_vel: true
            """,
        },
    ],
)
STAMPED_TOPICS = Step(
    name="stamped-topics",
    part=Part.LAUNCH,
    summary="Topics that command a mobile base",
    propose=_topics,
    rows=(
        Row("CONTROLLER/cmd_vel_unstamped", "CONTROLLER/cmd_vel", SINCE, _STAMPED),
        Row("CONTROLLER/reference_unstamped", "CONTROLLER/reference", SINCE, _STAMPED),
    ),
    before=[
        {
            "options": "--from=humble --to=jazzy",
            "config/controllers.yaml": """
                controller_manager:
                  ros__parameters:
                    update_rate: 100
                    base:
                      type: diff_drive_controller/DiffDriveController
                base:
                  ros__parameters:
                    left_wheel_names: [left]
                    right_wheel_names: [right]
                    wheel_separation: 0.4
                    wheel_radius: 0.1
            """,
            "launch/arm.launch.xml": """
                <launch>
                  <node pkg="teleop" exec="teleop">
                    <remap from="cmd_vel" to="base/cmd_vel_unstamped"/>
                  </node>
                </launch>
            """,
        },
    ],
    after=[
        {
            "launch/arm.launch.xml": """
                <launch>
                  <node pkg="teleop" exec="teleop">
                    <remap from="cmd_vel" to="base/cmd_vel"/>
                  </node>
                </launch>
            """,
        },
    ],
)
