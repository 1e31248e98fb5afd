"""The plugin that runs ros_control in Gazebo becomes that of ros2_control; mimic plugins become <mimic>."""

from __future__ import annotations

import os
from collections.abc import Iterator

from urdfctl.catalog.distros import since
from urdfctl.diagnostic import Edit
from urdfctl.load.loader import LoadedTarget
from urdfctl.migrate.edits.markup import (
    CONDITIONS,
    attribute,
    child,
    content,
    element_at,
    end_of,
    indent_of,
    indented,
    merged,
    parent_of,
    removal,
    root_of,
    span_of,
    step_of,
    with_attribute,
)
from urdfctl.migrate.edits.places import ElementKey, key_of, key_of_element, plugin_elements
from urdfctl.migrate.options import Part
from urdfctl.migrate.packages import MigratedPackages
from urdfctl.migrate.ros1.controller_addresses import addresses, declared_again
from urdfctl.migrate.ros1.controller_map import controller_maps
from urdfctl.migrate.ros1.described import described_for, spaces_of_robots
from urdfctl.migrate.ros1.followers import is_mimic_plugin, mimic_plugins
from urdfctl.migrate.shared.hardware import host_plugin, simulated_by
from urdfctl.migrate.shared.manager import BROADCASTER, RATE, manager_text
from urdfctl.migrate.step import EntryKind, Proposal, ReportEntry, Row, Step
from urdfctl.migrate.todo import for_you
from urdfctl.model.robot import Plugin
from urdfctl.source.disk.gate import exists
from urdfctl.source.opaque import UNKNOWN
from urdfctl.source.span import SourceSpan
from urdfctl.source.workspaces.packages import package_around, package_name
from urdfctl.source.xml.dom import Element

CONTROL = "libgazebo_ros_control.so"
_CONTROLS = (CONTROL, "libhwi_switch_gazebo_ros_control.so")
"""The second is the first with joints that change their interface (cob_gazebo_ros_control), as any does in ros2_control."""
_SIM_TYPES = ("gazebo_ros_control/DefaultRobotHWSim", "")
_DROPPED = ("robotSimType", "legacyModeNS", "controlPeriod", "eStopTopic", "robotParam", "filterJointsParam")
_AUTHORITY = "gz_ros2_control doc/index.rst; gazebo_ros2_control doc/index.rst"
_JOINED = "gz_ros2_control gz_ros2_control_plugin.cpp: <ros><namespace>, <remapping>; controller_manager.cpp: robot_description"
_MIMIC = "gz_ros2_control doc/index.rst: mimic joints by <mimic> of the URDF"


def _plugins(packages: MigratedPackages) -> Iterator[Proposal]:
    robots = _robots_by_plugin(packages)
    for element in plugin_elements(packages):
        if attribute(element, "filename") in _CONTROLS and not _has_successor(element):
            yield from _migrated(packages, element, robots.get(key_of_element(element), []))


def _has_successor(element: Element) -> bool:
    """Whether the file is half migrated: it also has the plugin of ros2_control, and chooses one by an argument."""
    return any(name in element.source.data for name in (b"libgazebo_ros2_control.so", b"gz_ros2_control-system"))


def _robots_by_plugin(packages: MigratedPackages) -> dict[ElementKey, list[LoadedTarget]]:
    found: dict[ElementKey, list[LoadedTarget]] = {}
    for loaded in packages.loaded():
        for plugin in loaded.project.robot.plugins if loaded.project.robot else ():
            found.setdefault(key_of(plugin.at), []).append(loaded)
    return found


def _migrated(packages: MigratedPackages, element: Element, robots: list[LoadedTarget]) -> Iterator[Proposal]:
    host = host_plugin(packages)
    sim_type = child(element, "robotSimType")
    if host is None:
        around = parent_of(element)
        is_alone = around is not None and len(around.elements()) == 1
        edit = removal(around if around is not None and is_alone else element)
        message = f"the plugin for ros_control is removed: simulator '{simulated_by(packages)}' needs none"
        yield Proposal((edit,), entries=(ReportEntry(EntryKind.DONE, message, element.at),))
        return
    if sim_type is not None and content(sim_type) not in _SIM_TYPES and "$" not in content(sim_type):
        text = f"the simulated hardware '{content(sim_type)}' is a class of its own: port it to ros2_control"
        yield Proposal(entries=(ReportEntry(EntryKind.FOR_YOU, text, sim_type.at),))
    name = host.names[0] if host.names else "gazebo_ros2_control"
    edits = [with_attribute(element, "filename", host.filenames[0]), with_attribute(element, "name", name)]
    dropped = [one for one in element.elements() if one.tagName in _DROPPED]
    edits += [removal(one) for one in dropped]
    space = child(element, "robotNamespace")
    text = content(space) if space is not None else ""
    step = step_of(element.source)
    spaces = spaces_of_robots(packages, robots)
    remapping, note = _joined(packages, text, spaces)
    is_root = text.strip("/") == ""
    lines = ("" if is_root else f"{step}<namespace>{text}</namespace>\n") + (f"{step}{remapping}" if remapping else "")
    inner = f"<ros>\n{lines}</ros>" if lines else ""
    if space is not None:
        edits.append(Edit(span_of(space), indented(inner, indent_of(space)).lstrip()) if inner else removal(space))
    files = controller_files(packages, robots)
    created: tuple[tuple[str, str], ...] = ()
    if not files and (new := _new_file(packages, element, text)) is not None:
        files, created = [new[0]], (new[1:],)
    edits += _chosen_namespaces(packages, element, spaces, step)
    edits.append(_with_parameters(element, files, step, inner if space is None else ""))
    edits = [edit for edit in edits if edit.text or edit.span.start != edit.span.end]
    entries = [
        ReportEntry(
            EntryKind.DONE,
            f"the plugin for ros_control became {host.names[0] if host.names else host.id}",
            element.at,
            authority=_AUTHORITY,
        )
    ]
    entries += [ReportEntry(EntryKind.DECIDED, note, element.at, authority=_JOINED)] if note else []
    entries += _chosen(element, files, _fitting(packages, robots))
    entries += declared_again(element, files, robots)
    if created:
        message = "no launch file says which controllers the robot has: a new file has the joint state broadcaster"
        entries.append(ReportEntry(EntryKind.DECIDED, message, file=created[0][0]))
    elif not files:
        message = "name the controller file in <parameters>: no launch file says which one belongs to this robot"
        entries.append(ReportEntry(EntryKind.FOR_YOU, message, element.at))
    yield Proposal((merged(edits), *_as_xacro(element, files)), created=created, entries=tuple(entries))


def _chosen_namespaces(
    packages: MigratedPackages, element: Element, spaces: frozenset[str], step: str
) -> Iterator[Edit]:
    """The edits of namespaces within conditions of xacro."""
    for choice in element.elements():
        space = child(choice, "robotNamespace") if choice.tagName in CONDITIONS else None
        if space is not None:
            remapping, _ = _joined(packages, content(space), spaces)
            text = f"<ros>\n{step}<namespace>{content(space)}</namespace>\n{step * bool(remapping)}{remapping}</ros>"
            yield Edit(span_of(space), indented(text, indent_of(space)).lstrip())


def _joined(packages: MigratedPackages, space: str, spaces: frozenset[str]) -> tuple[str, str]:
    """What makes the controller manager in a namespace read the description where it is published, and the entry."""
    published = described_for(spaces, space.strip("/"))
    if "$(" in published or published == space.strip("/") or packages.options.target not in since("jazzy"):
        return "", ""
    topic = "/".join(("", *filter(None, [published]), "robot_description"))
    note = f"the controller manager in '{space}' reads the robot description from {topic}, where it is published"
    return f"<remapping>robot_description:={topic}</remapping>\n", note


def _chosen(element: Element, files: list[str], fitting: list[str]) -> Iterator[ReportEntry]:
    """The entry on the choice of a controller file among several."""
    others = [one for one in addresses(fitting[1:]) if one not in files]
    if others and files == addresses(fitting[:1]):
        more = "1 more controller file names" if len(others) == 1 else f"{len(others)} more controller files name"
        message = f"'{files[0]}' is chosen: {more} only joints of the robot"
        yield ReportEntry(EntryKind.DECIDED, message, element.at, option=f"<parameters>{others[0]}</parameters>")


def _as_xacro(element: Element, files: list[str]) -> Iterator[Edit]:
    """The edit that makes a plain URDF one for xacro, which expands the addresses of its controller files."""
    root = root_of(element.source)
    if files and root is not None and not element.source.is_xacro and "xmlns:xacro" not in root.attrs:
        at = root.start + len(f"<{root.tagName}")
        yield Edit(SourceSpan(element.source, at, at), ' xmlns:xacro="http://www.ros.org/wiki/xacro"')


def _with_parameters(element: Element, files: list[str], step: str, more: str) -> Edit:
    """The edit that adds the controller files, and further lines, at the end of a plugin."""
    indent = indent_of(element)
    lines = indented(more and f"{more}\n", f"{indent}{step}")
    lines += "".join(f"{indent}{step}<parameters>{file}</parameters>\n" for file in files)
    if element.close is None or ((tag := element.source.start_tag(element.start)) and tag.self_closed):
        end = end_of(element)
        return Edit(SourceSpan(element.source, end - 2, end), f">\n{lines}{indent}</plugin>" if lines else "/>")
    line = element.source.data.rfind(b"\n", 0, element.close) + 1
    if element.source.data[line : element.close].strip():
        return Edit(SourceSpan(element.source, element.close, element.close), f"\n{lines}{indent}" if lines else "")
    return Edit(SourceSpan(element.source, line, line), lines)


def controller_files(packages: MigratedPackages, robots: list[LoadedTarget]) -> list[str]:
    """Return the controller files of some robots as xacro names them.

    They are those of the launch files; otherwise the file that names most joints of the robots, and no others. Several
    robots may have different ones; of launch files that declare the same controllers, the first one counts. Files of
    other nodes, which ROS 1 loads beside them, end the controller manager of ROS 2.
    """
    alone = {source.path for source, _, items in controller_maps(packages) for item in items if item.is_file}
    paths: list[str] = []
    known: set[str] = set()
    for started in (one.project.controllers for one in robots if one.project.controllers):
        declared = [each for each in started.controllers if each.declared_at is not None]
        again = {each.declared_at.source.path for each in declared if each.declared_at and each.full_name in known}
        again -= {each.declared_at.source.path for each in declared if each.declared_at and each.full_name not in known}
        files = (file for file in started.files if not file.is_moveit and file.path not in again)
        paths += (file.path for file in files if file.form or file.path in alone)
        known |= {each.full_name for each in declared}
    return addresses(paths or _fitting(packages, robots)[:1])


def _fitting(packages: MigratedPackages, robots: list[LoadedTarget]) -> list[str]:
    """The files that name only joints of some robots: that with most of them first."""
    joints = {name for one in robots if one.project.robot for name in one.project.robot.joint_names}
    fitting = {path: names for path, names in _joints_by_file(packages).items() if names <= joints}
    return sorted(fitting, key=lambda path: (-len(fitting[path]), path))


def _new_file(packages: MigratedPackages, element: Element, namespace: str) -> tuple[str, str, str] | None:
    """The address, path and text of a new controller file in the package of a description, for all of its plugins."""
    folder = package_around(os.path.dirname(element.source.path))
    name = package_name(os.path.join(folder, "package.xml")) if folder else None
    path = os.path.join(folder or "", "config", "ros2_controllers.yaml")
    if not folder or not name or exists(path):
        return None
    own = (one for one in plugin_elements(packages) if one.source.path.startswith(folder + os.sep))
    spaces = {_space(one) for one in own if attribute(one, "filename") in _CONTROLS}
    is_any = "$" in namespace or len(spaces) > 1
    space = "/**" if is_any else f"/{namespace.strip('/')}" if namespace.strip("/") else ""
    manager = manager_text(space, {"joint_state_broadcaster": BROADCASTER}, RATE, simulated=True)
    return f"$(find {name})/config/ros2_controllers.yaml", path, manager


def _space(plugin: Element) -> str:
    space = child(plugin, "robotNamespace")
    return content(space).strip("/") if space is not None else ""


def _joints_by_file(packages: MigratedPackages) -> dict[str, set[str]]:
    """The joints that the controllers in each file name."""
    found: dict[str, set[str]] = {}
    for loaded in packages.loaded():
        for controller in loaded.project.controllers.controllers if loaded.project.controllers else ():
            at = controller.declared_at
            names = {
                text for p in controller.own.leaves if p.last in {"joint", "joints"} for text, _ in p.value.strings
            }
            if at is not None and names:
                found.setdefault(at.source.path, set()).update(names)
    return found


# -- mimic plugins ---------------------------------------------------------------------------------------------------


def _mimics(packages: MigratedPackages) -> Iterator[Proposal]:
    added: dict[ElementKey, list[Edit]] = {}
    kept: set[ElementKey] = set()
    for loaded in packages.loaded():
        robot = loaded.project.robot
        for plugin, follower, leader in mimic_plugins(robot) if robot else ():
            key = key_of(plugin.at)
            joint = robot.joint(follower) if robot else None
            if joint is None or UNKNOWN in leader + follower:
                kept.add(key)
                continue
            if joint.mimic is None:
                edit = _mimic_edit(packages, key_of(joint.at), plugin, leader)
                kept |= set() if edit else {key}
                added.setdefault(key, []).extend([edit] if edit else [])
            added.setdefault(key, [])
    for element in plugin_elements(packages):
        if not is_mimic_plugin(attribute(element, "filename")):
            continue
        key = key_of_element(element)
        around = parent_of(element)
        if key in kept or around is None:
            yield for_you(element.at, "write <mimic> in the joint that this plugin moves, and remove the plugin")
            continue
        edit = removal(around if len(around.elements()) == 1 else element)
        message = "a mimic plugin became <mimic> of the joint, which ros2_control reads"
        yield Proposal(
            (edit, *dict.fromkeys(added.get(key, ()))),
            entries=(ReportEntry(EntryKind.DONE, message, element.at, authority=_MIMIC),),
        )


def _mimic_edit(packages: MigratedPackages, joint: ElementKey, plugin: Plugin, leader: str) -> Edit | None:
    """The edit that adds <mimic> to a joint; None if the joint is written in a macro."""
    path, start = joint
    element = element_at(packages.read(path), start) if packages.may_change(path) else None
    if element is None or "$" in attribute(element, "name") or element.close is None:
        return None
    values = {name: tag.text for name in ("multiplier", "offset") if (tag := plugin.setting(name))}
    more = "".join(f' {name}="{value}"' for name, value in values.items() if value)
    line = element.source.data.rfind(b"\n", 0, element.close) + 1
    text = f'{indent_of(element)}{step_of(element.source)}<mimic joint="{leader}"{more}/>\n'
    return Edit(SourceSpan(element.source, line, line), text)


SIMULATOR_PLUGIN = Step(
    name="simulator-plugin",
    part=Part.URDF,
    summary="The plugin that runs controllers in the simulator",
    propose=_plugins,
    generation=1,
    is_needed=True,
    rows=(
        Row(CONTROL, "gz_ros2_control-system, or libgazebo_ros2_control.so up to iron", "", _AUTHORITY),
        Row("<robotNamespace>", "<ros><namespace>", "", _AUTHORITY),
        Row("<controlPeriod>", "update_rate of the controller manager", "", _AUTHORITY),
        Row("<robotSimType>, <legacyModeNS>, <eStopTopic>", "", "", _AUTHORITY),
    ),
    before=[
        {
            "robot.xacro": """
                <gazebo>
                  <plugin name="gazebo_ros_control" filename="libgazebo_ros_control.so">
                    <robotSimType>gazebo_ros_control/DefaultRobotHWSim</robotSimType>
                  </plugin>
                </gazebo>
            """,
        },
    ],
    after=[
        {
            "config/ros2_controllers.yaml": """
                controller_manager:
                  ros__parameters:
                    update_rate: 100  # Hz
                    use_sim_time: true

                    joint_state_broadcaster:
                      type: joint_state_broadcaster/JointStateBroadcaster
            """,
            "robot.xacro": """
                <gazebo>
                  <plugin name="gz_ros2_control::GazeboSimROS2ControlPlugin" filename="gz_ros2_control-system">
                    <parameters>$(find arm)/config/ros2_controllers.yaml</parameters>
                  </plugin>
                </gazebo>
            """,
        },
    ],
)
MIMIC_PLUGINS = Step(
    name="mimic-plugins",
    part=Part.URDF,
    summary="Plugins for mimicking joints",
    propose=_mimics,
    generation=1,
    rows=(Row("libroboticsgroup_gazebo_mimic_joint_plugin.so", "<mimic> of the joint", "", _MIMIC),),
    before=[
        {
            "arm.urdf": """
                <robot name="arm">
                  <link name="base"/>
                  <link name="upper"/>
                  <link name="fore"/>
                  <joint name="shoulder" type="continuous">
                    <parent link="base"/>
                    <child link="upper"/>
                  </joint>
                  <joint name="elbow" type="continuous">
                    <parent link="upper"/>
                    <child link="fore"/>
                  </joint>
                  <gazebo>
                    <plugin name="elbow_mimic" filename="libroboticsgroup_gazebo_mimic_joint_plugin.so">
                      <joint>shoulder</joint>
                      <mimicJoint>elbow</mimicJoint>
                      <multiplier>-1</multiplier>
                    </plugin>
                  </gazebo>
                </robot>
            """,
        },
    ],
    after=[
        {
            "arm.urdf": """
                <robot name="arm">
                  <link name="base"/>
                  <link name="upper"/>
                  <link name="fore"/>
                  <joint name="shoulder" type="continuous">
                    <parent link="base"/>
                    <child link="upper"/>
                  </joint>
                  <joint name="elbow" type="continuous">
                    <parent link="upper"/>
                    <child link="fore"/>
                    <mimic joint="shoulder" multiplier="-1"/>
                  </joint>
                </robot>
            """,
        },
    ],
)
