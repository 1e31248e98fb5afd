"""The dependencies of packages that leave Gazebo Classic."""

from __future__ import annotations

import os
from collections.abc import Iterator

from urdfctl.diagnostic import Edit
from urdfctl.generate.files.bringup import gz_names
from urdfctl.migrate.edits.markup import content, indent_of, lines_of, root_of
from urdfctl.migrate.options import Part
from urdfctl.migrate.packages import MigratedPackages
from urdfctl.migrate.shared.hardware import goes_to_gz, host_plugin, leaves_classic, simulated_by, system
from urdfctl.migrate.step import EntryKind, Proposal, ReportEntry, Row, Step
from urdfctl.model.launch.package import run_dependency_tag
from urdfctl.source.span import SourceSpan
from urdfctl.source.xml.dom import Element

_AUTHORITY = "rosdistro#41224; ros_gz README"
_CONTROL = "gazebo_ros2_control"
_GAZEBO = ("gazebo_ros", "gazebo_ros_pkgs", "gazebo_plugins")


def _manifests(packages: MigratedPackages) -> Iterator[Proposal]:
    if not leaves_classic(packages) or packages.options.keep_classic:
        return
    for path in packages.files("package.xml"):
        source = packages.read(path)
        root = root_of(source) if b"gazebo" in source.data or not packages.was_in_gz else None
        if root is None or root.tagName != "package":
            continue
        known = {content(one) for one in root.elements() if one.tagName.endswith("depend")}
        if packages.was_in_gz and not any("gazebo" in one for one in known):
            continue
        edits = []
        for element in root.elements():
            new = _successors(packages, content(element)) if element.tagName.endswith("depend") else None
            if new is None or any(content(element) == name for name in new):
                continue
            added = [name for name in new if name not in known]
            known.update(added)
            indent, kind = indent_of(element), "depend" if element.tagName == "depend" else run_dependency_tag(root)
            edits.append(Edit(lines_of(element), "".join(f"{indent}<{kind}>{name}</{kind}>\n" for name in added)))
        edits += _missing(packages, root, known)
        if edits:
            entry = ReportEntry(
                EntryKind.DONE, "the package needs gz instead of Gazebo Classic", root.at, authority=_AUTHORITY
            )
            yield Proposal(tuple(edits), entries=(entry,))


def _missing(packages: MigratedPackages, root: Element, known: set[str]) -> Iterator[Edit]:
    """The packages of gz that launch files and robots of the package use, and that it does not name."""
    gz, host = gz_names(packages.options.target), host_plugin(packages)
    wanted = dict.fromkeys([gz["package"], gz["bridge"], *([host.package] if host and host.package else [])])
    folder = os.path.dirname(root.source.path) + os.sep
    files = [path for path in packages.files(".py", ".xml", ".xacro", ".urdf") if path.startswith(folder)]
    texts = [packages.read(path).data for path in files if os.path.basename(path) != "package.xml"]
    needed = [name for name in wanted if name not in known and any(name.encode() in text for text in texts)]
    last = [element for element in root.elements() if element.tagName.endswith("depend")][-1:]
    if needed and last:
        end = lines_of(last[0]).end
        kind = run_dependency_tag(root)
        lines = "".join(f"{indent_of(last[0])}<{kind}>{name}</{kind}>\n" for name in needed)
        yield Edit(SourceSpan(root.source, end, end), lines)


def _successors(packages: MigratedPackages, name: str) -> tuple[str, ...] | None:
    """The packages that replace one of Gazebo Classic; None for other packages."""
    if name == _CONTROL:
        host = host_plugin(packages)
        mock = system(packages).package in ("mock_components", "fake_components")
        return (host.package,) if host and host.package else ("hardware_interface",) if mock else ()
    if name not in _GAZEBO:
        return None
    gz = gz_names(packages.options.target)
    is_started = name != "gazebo_plugins" and (simulated_by(packages) == "gz" or goes_to_gz(packages))
    return (gz["package"], gz["bridge"]) if is_started else ()


CLASSIC_MANIFEST = Step(
    name="classic-manifest",
    part=Part.MANIFEST,
    summary="Packages of Gazebo Classic",
    propose=_manifests,
    rows=(
        Row("gazebo_ros2_control", "gz_ros2_control", "jazzy", _AUTHORITY),
        Row("gazebo_ros, gazebo_ros_pkgs", "ros_gz_sim, ros_gz_bridge", "jazzy", _AUTHORITY),
        Row("gazebo_plugins", "", "jazzy", _AUTHORITY),
    ),
    before=[
        {
            "options": "--to=jazzy --simulator=gz",
            "package.xml": """
                <package>
                  <name>arm</name>
                  <run_depend>gazebo_ros</run_depend>
                </package>
            """,
            "robot.xacro": """
                <gazebo>
                  <plugin name="drive" filename="libgazebo_ros_diff_drive.so"/>
                </gazebo>
            """,
            "launch/start.launch.py": """
                from launch import LaunchDescription
                from launch_ros.actions import Node


                def generate_launch_description():
                    return LaunchDescription([
                        Node(package='gazebo_ros', executable='spawn_entity.py', arguments=['-topic', 'robot_description', '-entity', 'arm']),
                    ])
            """,
        },
        {
            "options": "--to=jazzy --simulator=gz",
            "package.xml": """
                <package format="3">
                  <name>arm</name>
                  <exec_depend>gazebo_ros2_control</exec_depend>
                  <exec_depend>gazebo_ros</exec_depend>
                  <exec_depend>gazebo_plugins</exec_depend>
                </package>
            """,
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
            "package.xml": """
                <package>
                  <name>arm</name>
                  <run_depend>ros_gz_sim</run_depend>
                  <run_depend>ros_gz_bridge</run_depend>
                </package>
            """,
        },
        {
            "package.xml": """
                <package format="3">
                  <name>arm</name>
                  <exec_depend>gz_ros2_control</exec_depend>
                  <exec_depend>ros_gz_sim</exec_depend>
                  <exec_depend>ros_gz_bridge</exec_depend>
                </package>
            """,
        },
    ],
)
