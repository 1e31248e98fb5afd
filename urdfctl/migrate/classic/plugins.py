"""Plugins of Gazebo Classic become systems of gz, or the plugin of ros2_control for gz."""

from __future__ import annotations

import re
from collections.abc import Iterator

from urdfctl.catalog.hardware import SimulatorPlugin
from urdfctl.diagnostic import Edit
from urdfctl.migrate.classic.axles import axles
from urdfctl.migrate.classic.bodies import OF_MODEL, moving_body
from urdfctl.migrate.classic.choice import is_chosen, is_started, keeps_classic, replaced
from urdfctl.migrate.classic.loose_sensors import LOOSE
from urdfctl.migrate.classic.published import AUTHORITY, published_elsewhere, reading
from urdfctl.migrate.classic.sdf import OF_SDF
from urdfctl.migrate.classic.sensor_topics import SENSORS
from urdfctl.migrate.classic.systems import NO_SUCCESSOR, SYSTEMS, dropped_settings, flush, library_of, system_text
from urdfctl.migrate.edits.markup import (
    ancestors,
    attribute,
    child,
    content,
    elements,
    indented,
    parent_of,
    removal,
    root_of,
    step_of,
    with_attribute,
)
from urdfctl.migrate.edits.places import place_of, plugin_elements
from urdfctl.migrate.options import Part
from urdfctl.migrate.packages import OF_XML, MigratedPackages
from urdfctl.migrate.shared.hardware import (
    HARDWARE_OPTION,
    goes_to_gz,
    host_plugin,
    leaves_classic,
    simulated_by,
    system_plugin,
    without_hardware,
)
from urdfctl.migrate.step import EntryKind, Proposal, ReportEntry, Row, Step
from urdfctl.migrate.todo import for_you, todo_line
from urdfctl.source.span import SourceSpan
from urdfctl.source.xml.dom import Element

CONTROL = "gazebo_ros2_control"
_OF_ROS1 = "gazebo_ros_control"
_HARDWARE = "gazebo_ros2_control/GazeboSystem"
_OLD_HARDWARE = (_HARDWARE, "gazebo_ros2_control/GazeboSystemInterface")
_WITH_LOOP = rb"(?<![\w.])((?:position|velocity)_pid)(?=[\"'\s\],])"
_OF_GZ = ("gz-", "gz_", "ign_", "ign-", "ignition-")
_KEPT = ("parameters", "ros", "hold_joints", "controller_manager_name")
_TRICYCLE = "gazebo_ros_tricycle_drive"
_POSE = "gazebo_ros_p3d"
_AUTHORITY = "gazebosim.org, Migrating Gazebo Classic ROS 2 packages"
_CONTROL = "gz_ros2_control doc/index.rst; rosdistro#41224: gazebo_ros2_control ends with iron"


def _control(packages: MigratedPackages) -> Iterator[Proposal]:
    if not leaves_classic(packages):
        return
    for element in plugin_elements(packages):
        library = library_of(attribute(element, "filename"))
        if library == _OF_ROS1 and not packages.is_ros1:
            yield _removed(element, "the plugin for ros_control is removed: ROS 2 does not have it")
        if (
            library != CONTROL
            or is_chosen(element)
            or (_has_both(element) and not is_started(packages, element, CONTROL))
        ):
            continue
        host = host_plugin(packages)
        if host is None:
            message = f"the plugin of Gazebo Classic is removed: simulator '{simulated_by(packages)}' needs none"
            yield _removed(element, message)
            continue
        entry = ReportEntry(
            EntryKind.DONE, f"the plugin for ros2_control became '{host.names[0]}'", element.at, authority=_CONTROL
        )
        entries, edits = [entry], list(_for_gz(packages, element, host))
        topic = published_elsewhere(packages, element)
        if topic and not packages.options.keep_classic:
            edits.append(reading(element, topic))
            what = f"the controller manager reads the robot description from {topic}, where it is published"
            entries.append(ReportEntry(EntryKind.DECIDED, what, element.at, authority=AUTHORITY))
        yield Proposal(tuple(edits), entries=tuple(entries))


def _for_gz(packages: MigratedPackages, element: Element, host: SimulatorPlugin) -> Iterator[Edit]:
    """Yield the edits that make a plugin that of gz; with `--keep-classic`, that put it beside the old one."""
    filename, name = host.filenames[0], host.names[0]
    inner = element.elements()
    is_kept = {id(one): one.tagName in _KEPT or one.tagName.startswith("xacro:") for one in inner}
    if keeps_classic(packages, element):
        text = "".join(indented(f"{flush(one)}\n", step_of(element.source)) for one in inner if is_kept[id(one)])
        plugin = f'<plugin filename="{filename}" name="{name}">\n{text}</plugin>\n'
        yield from replaced(packages, element, plugin)
        return
    yield with_attribute(element, "filename", filename)
    yield with_attribute(element, "name", name)
    yield from (removal(one) for one in inner if not is_kept[id(one)])


def _removed(element: Element, message: str) -> Proposal:
    """The proposal to remove a plugin, and the element around it if nothing else is in it."""
    around = parent_of(element)
    alone = around is not None and len(around.elements()) == 1
    edit = removal(around if around is not None and alone else element)
    return Proposal((edit,), entries=(ReportEntry(EntryKind.DONE, message, element.at, authority=_CONTROL),))


def _has_both(element: Element) -> bool:
    """Whether a file already has the plugin for gz, and chooses one by an argument."""
    return b"gz_ros2_control-system" in element.source.data or b"ign_ros2_control-system" in element.source.data


def _hardware(packages: MigratedPackages) -> Iterator[Proposal]:
    if not leaves_classic(packages):
        return
    new = system_plugin(packages)
    for path in packages.files(*OF_XML):
        source = packages.read(path)
        root = root_of(source) if _HARDWARE.encode() in source.data else None
        for element in elements(root) if root is not None else ():
            if element.tagName != "plugin" or content(element) not in _OLD_HARDWARE or is_chosen(element):
                continue
            message = f"the simulated hardware became '{new}'"
            entries = [ReportEntry(EntryKind.DONE, message, element.at, authority=_CONTROL)]
            text = f"<plugin>{new}</plugin>\n"
            if todo := without_hardware(packages, _component_of(element)):
                text = f"{todo_line(path, todo)}\n{text}"
                entries.append(ReportEntry(EntryKind.FOR_YOU, todo, element.at, option=HARDWARE_OPTION))
            yield Proposal(tuple(replaced(packages, element, text)), entries=tuple(entries))


def _component_of(plugin: Element) -> str:
    """The name of the component that a plugin belongs to, as it is written."""
    return next((attribute(one, "name") for one in ancestors(plugin) if one.tagName == "ros2_control"), "")


def _interfaces(packages: MigratedPackages) -> Iterator[Proposal]:
    """Replace the interfaces with a PID loop in the simulator, which only Gazebo Classic's hardware has."""
    if not goes_to_gz(packages):
        return
    for path in packages.files(*OF_XML, ".yaml"):
        source = packages.read(path)
        found = list(re.finditer(_WITH_LOOP, source.data))
        if found and not packages.options.keep_classic:
            edits = [
                Edit(SourceSpan(source, *match.span(1)), match[1].decode().removesuffix("_pid")) for match in found
            ]
            at = edits[0].span
            message = (
                f"'{at.text}' became '{edits[0].text}': gz has no PID loop of the joint; its controllers command it"
            )
            yield Proposal(
                tuple(edits), entries=(ReportEntry(EntryKind.DECIDED, message, place_of(at), authority=_CONTROL),)
            )


def _without_successor(element: Element, library: str) -> str:
    """What a person must do for a plugin that no system of gz replaces."""
    if library != _TRICYCLE:
        return f"no system of gz replaces plugin '{library}': choose another way, and remove it"
    given = {one.tagName.replace("_", "").lower(): content(one) for one in element.elements()}
    wheel = given.get("actuatedwheeljoint", "front_wheel_joint")
    steering = given.get("steeringjoint", "front_steering_joint")
    names = f"velocity of '{wheel}' and position of '{steering}'"
    return f"gz has no tricycle drive: give <ros2_control> {names}, start tricycle_controller, and remove '{library}'"


def _systems(packages: MigratedPackages) -> Iterator[Proposal]:
    if not goes_to_gz(packages):
        return
    for element in plugin_elements(packages, *OF_SDF):
        library = library_of(attribute(element, "filename"))
        around = parent_of(element)
        if is_chosen(element) or (around is not None and around.tagName in {"world", "gui"}):
            continue
        if _is_own(element, library) and not packages.options.keep_classic:
            what = f"plugin '{library}' is built for Gazebo Classic: port it to gz, or remove it"
            yield for_you(element.at, what, authority=_AUTHORITY)
        if around is not None and around.tagName == "sensor":
            continue
        if library in SYSTEMS:
            system = SYSTEMS[library]
            measures = list(axles(packages, element)) if system.has_axles else []
            text = system_text(element, system, step_of(element.source), measures)
            message = f"plugin '{library}' became '{system.filename}'"
            entries = [ReportEntry(EntryKind.DONE, message, element.at, authority=_AUTHORITY)]
            if dropped := dropped_settings(element, system):
                message = f"'{system.filename}' does not have {', '.join(dropped)} of '{library}': dropped"
                entries.append(ReportEntry(EntryKind.DONE, message, element.at, authority=_AUTHORITY))
            if library == _POSE and (body := moving_body(packages, element)):
                message = f"gz publishes the pose of the model, not that of link '{body}': read that from /tf"
                entries.append(ReportEntry(EntryKind.FOR_YOU, message, element.at, authority=OF_MODEL))
            yield Proposal(tuple(replaced(packages, element, text)), entries=tuple(entries))
        elif library in NO_SUCCESSOR and child(element, "urdfctl") is None:
            yield for_you(element.at, _without_successor(element, library))


def _is_own(element: Element, library: str) -> bool:
    """Whether a plugin is for Gazebo Classic, and not from gazebo_ros_pkgs: gz names the class of each plugin."""
    filename, name = attribute(element, "filename"), attribute(element, "name")
    known = (CONTROL, _OF_ROS1, *SYSTEMS, *SENSORS, *LOOSE, *NO_SUCCESSOR)
    is_for_classic = filename.endswith(".so") and not library.startswith(_OF_GZ) and "::" not in name
    return is_for_classic and library not in known and "$" not in filename and "mimic_joint" not in library


CONTROL_PLUGIN = Step(
    name="classic-control-plugin",
    part=Part.URDF,
    summary="The plugin of Gazebo Classic that runs controllers",
    propose=_control,
    rows=(Row("libgazebo_ros2_control.so", "gz_ros2_control-system", "jazzy", _CONTROL),),
    before=[
        {
            "options": "--to=jazzy --simulator=gz",
            "robot.xacro": """
                <ros2_control name="arm" type="system">
                  <hardware>
                    <plugin>mock_components/GenericSystem</plugin>
                  </hardware>
                  <joint name="elbow">
                    <command_interface name="position"/>
                    <state_interface name="position"/>
                  </joint>
                </ros2_control>

                <gazebo>
                  <plugin name="gazebo_ros2_control" filename="libgazebo_ros2_control.so">
                    <parameters>$(find arm)/config/controllers.yaml</parameters>
                  </plugin>
                </gazebo>
            """,
            "config/controllers.yaml": """
                controller_manager:
                  ros__parameters:
                    update_rate: 100
                    states:
                      type: joint_state_broadcaster/JointStateBroadcaster
            """,
        },
    ],
    after=[
        {
            "robot.xacro": """
                <ros2_control name="arm" type="system">
                  <hardware>
                    <plugin>mock_components/GenericSystem</plugin>
                  </hardware>
                  <joint name="elbow">
                    <command_interface name="position"/>
                    <state_interface name="position"/>
                  </joint>
                </ros2_control>

                <gazebo>
                  <plugin name="gz_ros2_control::GazeboSimROS2ControlPlugin" filename="gz_ros2_control-system">
                    <parameters>$(find arm)/config/controllers.yaml</parameters>
                  </plugin>
                </gazebo>
            """,
        },
    ],
)
CLASSIC_HARDWARE = Step(
    name="classic-hardware",
    part=Part.URDF,
    summary="Simulated hardware of Gazebo Classic",
    propose=_hardware,
    rows=(Row(_HARDWARE, "gz_ros2_control/GazeboSimSystem", "jazzy", _CONTROL),),
    before=[
        {
            "options": "--to=jazzy --simulator=gz",
            "robot.xacro": """
                <ros2_control name="arm" type="system">
                  <hardware>
                    <plugin>gazebo_ros2_control/GazeboSystem</plugin>
                  </hardware>
                  <joint name="elbow">
                    <command_interface name="position"/>
                    <state_interface name="position"/>
                  </joint>
                </ros2_control>

                <gazebo>
                  <plugin name="gazebo_ros2_control" filename="libgazebo_ros2_control.so">
                    <parameters>$(find arm)/config/controllers.yaml</parameters>
                  </plugin>
                </gazebo>
            """,
        },
    ],
    after=[
        {
            "robot.xacro": """
                <ros2_control name="arm" type="system">
                  <hardware>
                    <plugin>gz_ros2_control/GazeboSimSystem</plugin>
                  </hardware>
                  <joint name="elbow">
                    <command_interface name="position"/>
                    <state_interface name="position"/>
                  </joint>
                </ros2_control>

                <gazebo>
                  <plugin name="gazebo_ros2_control" filename="libgazebo_ros2_control.so">
                    <parameters>$(find arm)/config/controllers.yaml</parameters>
                  </plugin>
                </gazebo>
            """,
        },
    ],
)
CLASSIC_INTERFACES = Step(
    name="classic-interfaces",
    part=Part.URDF,
    summary="Interfaces with a loop in Gazebo Classic",
    propose=_interfaces,
    rows=(Row('interfaces "position_pid", "velocity_pid"', '"position", "velocity"', "jazzy", _CONTROL),),
    before=[
        {
            "options": "--to=jazzy --simulator=gz",
            "robot.xacro": """
                <ros2_control name="arm" type="system">
                  <hardware>
                    <plugin>gz_ros2_control/GazeboSimSystem</plugin>
                  </hardware>
                  <joint name="elbow">
                    <command_interface name="position_pid"/>
                    <state_interface name="position"/>
                  </joint>
                </ros2_control>
            """,
        },
    ],
    after=[
        {
            "robot.xacro": """
                <ros2_control name="arm" type="system">
                  <hardware>
                    <plugin>gz_ros2_control/GazeboSimSystem</plugin>
                  </hardware>
                  <joint name="elbow">
                    <command_interface name="position"/>
                    <state_interface name="position"/>
                  </joint>
                </ros2_control>
            """,
        },
    ],
)
CLASSIC_PLUGINS = Step(
    name="classic-plugins",
    part=Part.URDF,
    summary="Plugins of Gazebo Classic",
    propose=_systems,
    rows=tuple(Row(f"lib{name}.so", system.filename, "jazzy", _AUTHORITY) for name, system in SYSTEMS.items()),
    before=[
        {
            "options": "--to=jazzy --simulator=gz",
            "robot.urdf": """
                <gazebo>
                  <plugin name="drive" filename="libgazebo_ros_diff_drive.so">
                    <left_joint>shoulder</left_joint>
                    <right_joint>elbow</right_joint>
                    <wheel_separation>0.4</wheel_separation>
                    <wheel_diameter>0.2</wheel_diameter>
                    <robot_base_frame>base</robot_base_frame>
                  </plugin>
                </gazebo>
            """,
        },
    ],
    after=[
        {
            "robot.urdf": """
                <gazebo>
                  <plugin filename="gz-sim-diff-drive-system" name="gz::sim::systems::DiffDrive">
                    <left_joint>shoulder</left_joint>
                    <right_joint>elbow</right_joint>
                    <wheel_separation>0.4</wheel_separation>
                    <wheel_radius>0.1</wheel_radius>
                    <child_frame_id>base</child_frame_id>
                    <topic>cmd_vel</topic>
                    <odom_topic>odom</odom_topic>
                  </plugin>
                </gazebo>
            """,
        },
    ],
)
