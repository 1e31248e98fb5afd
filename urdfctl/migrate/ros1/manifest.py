"""package.xml of packages without compiled code: format 3 and ament."""

from __future__ import annotations

import ast
import os
import re
from collections.abc import Iterator, Mapping

from urdfctl.catalog.catalog import catalog_with
from urdfctl.diagnostic import Edit
from urdfctl.generate.files.bringup import gz_names
from urdfctl.migrate.edits.markup import child, children, content, end_of, indent_of, lines_of, merged, root_of, step_of
from urdfctl.migrate.options import Part
from urdfctl.migrate.packages import MigratedPackages
from urdfctl.migrate.ros1.build_file import ament_build_file
from urdfctl.migrate.ros1.circles import closing
from urdfctl.migrate.ros1.looked_up import looked_up_packages
from urdfctl.migrate.ros1.lost_packages import lost_dependencies
from urdfctl.migrate.ros1.moveit_pipelines import planners_of
from urdfctl.migrate.shared.hardware import host_plugin, started_by_launch_files, system
from urdfctl.migrate.step import EntryKind, Proposal, ReportEntry, Row, Step
from urdfctl.source.span import SourceSpan
from urdfctl.source.xml.dom import Element

_AUTHORITY = "docs.ros.org, Migrating packages from ROS 1 to ROS 2"
_CIRCLE = "colcon-core topological_order.py: packages that run each other cannot be ordered, and none is built"
_FORMAT = "REP 149: package.xml format 3"
_DEPENDS = ("depend", "exec_depend", "run_depend", "build_depend", "build_export_depend", "test_depend")
_NEW_NAMES: Mapping[str, tuple[str, ...]] = {
    "joint_state_controller": ("joint_state_broadcaster",),
    "imu_sensor_controller": ("imu_sensor_broadcaster",),
    "force_torque_sensor_controller": ("force_torque_sensor_broadcaster",),
    "ros_control": ("ros2_control",),
    "ros_controllers": ("ros2_controllers",),
    "rviz": ("rviz2",),
    "tf": ("tf2_ros",),
    "rospy": ("rclpy",),
    "roscpp": ("rclcpp",),
    "roslaunch": ("launch_ros",),
    "gazebo_msgs": ("gazebo_msgs",),
    "roboticsgroup_gazebo_plugins": (),
    "roboticsgroup_upatras_gazebo_plugins": (),
    "rosbag": ("rosbag2",),
    "roslib": ("ament_index_python",),
    **dict.fromkeys(("message_generation", "message_runtime", "genmsg", "rosmsg", "rosout", "rosmaster"), ()),
    **dict.fromkeys(("rosnode", "rosparam", "rosservice", "rostopic", "rostest", "rosunit", "roslint"), ()),
    "catkin": (),
    "moveit_fake_controller_manager": (),
    "amcl": ("nav2_amcl", "nav2_lifecycle_manager"),
    "map_server": ("nav2_map_server", "nav2_lifecycle_manager"),
    "move_base": ("nav2_bringup",),
}
"""By name in ROS 1: the packages of ROS 2 that take its place. Others keep their name."""
_OF_CLASSIC = ("gazebo", "gazebo_dev", "gazebo_plugins", "libgazebo-dev")
_NAMED_IN_LAUNCH = r"(?:FindPackageShare\(|find-pkg-share |package=|pkg=)['\"]?([\w-]+)"
_LAUNCHES = (".launch.py", ".launch.xml")
_COMMENT = r"(?ms)^[ \t]*#[^\n]*|<!--.*?-->"
_NO_PACKAGES = ("mock_components", "fake_components")
_COMPILED = r"(?im)^\s*(?:add_executable|add_library|generate_messages|pybind11_add_module|add_message_files)\s*\("


def _manifests(packages: MigratedPackages) -> Iterator[Proposal]:
    yield from looked_up_packages(packages)
    for path, root in _manifest_roots(packages):
        if not _is_catkin(root):
            continue
        lost = lost_dependencies([one for one in root.elements() if one.tagName in _DEPENDS])
        cmake = packages.read(os.path.join(os.path.dirname(path), "CMakeLists.txt"))
        if re.search(_COMPILED, cmake.data.decode("utf-8", "replace")):
            text = "this package compiles code or messages: port them, then package.xml and CMakeLists.txt"
            yield Proposal(entries=(ReportEntry(EntryKind.FOR_YOU, text, root.at, authority=_AUTHORITY), *lost))
            continue
        yield Proposal(
            (merged(_manifest_edits(packages, root)),),
            entries=(
                ReportEntry(EntryKind.DONE, "the package is built by ament", root.at, authority=_AUTHORITY),
                *lost,
                *_circular(packages, root),
            ),
        )
        if cmake.data:
            is_classic = started_by_launch_files(packages) == "gazebo-classic"
            yield ament_build_file(packages, cmake, name=content(child(root, "name") or root), is_classic=is_classic)


def _manifest_roots(packages: MigratedPackages) -> Iterator[tuple[str, Element]]:
    """The manifests of the packages, by their paths."""
    for path in packages.files("/package.xml"):
        root = root_of(packages.read(path))
        if root is not None and root.tagName == "package":
            yield path, root


def _circles(packages: MigratedPackages) -> frozenset[tuple[str, str]]:
    """The dependencies that the manifests would have, but that would close a circle, each with its package."""
    known: dict[str, set[str]] = {}
    needed: dict[str, set[str]] = {}
    for path, root in _manifest_roots(packages):
        own = content(child(root, "name") or root)
        known[own] = {content(one) for name in _DEPENDS for one in children(root, name)}
        if _is_catkin(root):
            needed[own] = {*_needed(packages, os.path.dirname(path))} - {own}
    return closing(known, {own: names & known.keys() for own, names in needed.items()})


def _circular(packages: MigratedPackages, root: Element) -> Iterator[ReportEntry]:
    """The entries about what a package uses, and does not depend on."""
    own = content(child(root, "name") or root)
    for package, name in sorted(packages.found(_circles)):
        if package == own:
            what = f"'{name}' is used, but no dependency: it uses this package, too"
            yield ReportEntry(EntryKind.DECIDED, what, root.at, authority=_CIRCLE)


def _is_catkin(root: Element) -> bool:
    return any(content(tool) == "catkin" for tool in children(root, "buildtool_depend"))


def _manifest_edits(packages: MigratedPackages, root: Element) -> Iterator[Edit]:
    source = root.source
    tag = source.start_tag(root.start)
    if tag is not None and "format" in tag.attributes:
        start, end = tag.attributes["format"]
        yield Edit(SourceSpan(source, start, end), "3")
    else:
        at = root.start + len(b"<package")
        yield Edit(SourceSpan(source, at, at), ' format="3"')
    known = {content(one) for name in _DEPENDS for one in children(root, name)}
    added: set[tuple[str, str]] = set()
    for element in root.elements():
        if element.tagName == "buildtool_depend" and content(element) == "catkin":
            yield _text_edit(element, "ament_cmake")
        elif element.tagName in _DEPENDS:
            yield from _dependency(packages, element, known, added)
    known |= {name for _, name in added}
    yield from _additions(packages, root, known)
    yield _export(root)


def _additions(packages: MigratedPackages, root: Element, known: set[str]) -> Iterator[Edit]:
    own = content(child(root, "name") or root)
    needed = {*_needed(packages, os.path.dirname(root.source.path))} - known - {own}
    needed -= {name for package, name in packages.found(_circles) if package == own}
    missing = sorted(needed, key=lambda name: _rank(packages, name))
    last = [element for element in root.elements() if element.tagName in (*_DEPENDS, "buildtool_depend")][-1:]
    if missing and last:
        end = lines_of(last[0]).end
        lines = "".join(f"{indent_of(last[0])}<exec_depend>{name}</exec_depend>\n" for name in missing)
        yield Edit(SourceSpan(root.source, end, end), lines)


def _rank(packages: MigratedPackages, name: str) -> tuple[str, bool]:
    """The order of a package: one of gz is where that of Gazebo Classic would be, which a later migration replaces."""
    gz = gz_names(packages.options.target)
    host = host_plugin(packages)
    if host is not None and name == host.package:
        return "gazebo_ros2_control", False
    return ("gazebo_ros", name == gz["bridge"]) if name in (gz["package"], gz["bridge"]) else (name, False)


def _text_edit(element: Element, text: str) -> Edit:
    tag = element.source.start_tag(element.start)
    start = tag.end if tag else element.start
    return Edit(SourceSpan(element.source, start, element.close or start), text)


def _dependency(
    packages: MigratedPackages, element: Element, known: set[str], written: set[tuple[str, str]]
) -> Iterator[Edit]:
    """The edit of a dependency.

    known: the packages that the manifest names. written: what was put in their place, each with its kind.
    """
    name = content(element)
    new = _successors(packages, name)
    kind = "exec_depend" if element.tagName in {"run_depend", "depend"} and new != (name,) else element.tagName
    kind = "exec_depend" if kind == "run_depend" else kind
    if new != (name,) and kind in {"build_depend", "build_export_depend"}:
        kind = "exec_depend"  # nothing is compiled
    added = [each for each in new if each == name or (each not in known and (kind, each) not in written)]
    written.update((kind, each) for each in added)
    if added == [name] and kind == element.tagName:
        return
    indent = indent_of(element)
    lines = "".join(f"{indent}<{kind}>{each}</{kind}>\n" for each in added)
    span = lines_of(element)
    is_whole = span.start != element.start
    yield Edit(span, lines if is_whole else lines.strip())


def _successors(packages: MigratedPackages, name: str) -> tuple[str, ...]:
    gz = gz_names(packages.options.target)
    host = host_plugin(packages)
    if name == "gazebo_ros_control":
        return (host.package,) if host and host.package else ()
    if name in {"gazebo_ros", "gazebo_ros_pkgs"}:
        in_gz = (gz["package"], gz["bridge"])
        return {"gz": in_gz, "gazebo-classic": (name,)}.get(started_by_launch_files(packages), ())
    if name in _OF_CLASSIC:
        return (name,) if started_by_launch_files(packages) == "gazebo-classic" else ()
    return _NEW_NAMES.get(name, (name,))


def _export(root: Element) -> Edit:
    """The edit that names the build type, instead of a metapackage."""
    source, step = root.source, step_of(root.source)
    export = child(root, "export")
    build = "<build_type>ament_cmake</build_type>"
    if export is None:
        end = root.close or len(source.data)
        at = source.data.rfind(b"\n", 0, end) + 1
        if source.data[at:end].strip():
            return Edit(SourceSpan(source, end, end), f"<export>{build}</export>")
        return Edit(SourceSpan(source, at, at), f"\n{step}<export>\n{step * 2}{build}\n{step}</export>\n")
    meta = child(export, "metapackage")
    if meta is not None:
        return Edit(SourceSpan(source, meta.start, end_of(meta)), build)
    tag = source.start_tag(export.start)
    if tag is None or tag.self_closed or export.close is None:
        return Edit(SourceSpan(source, export.start, end_of(export)), f"<export>\n{step * 2}{build}\n{step}</export>")
    return Edit(SourceSpan(source, tag.end, tag.end), f"\n{step * 2}{build}")


def _can_be_read(packages: MigratedPackages, path: str) -> bool:
    """Whether a launch file is valid: what a broken one names is not started."""
    source = packages.read(path)
    if path.endswith(".xml"):
        return root_of(source) is not None
    try:
        ast.parse(source.data)
    except (SyntaxError, ValueError, RecursionError):
        return False
    return True


def _needed(packages: MigratedPackages, folder: str) -> Iterator[str]:
    """The packages that the launch files, controllers and plugins of a package need."""
    catalog = catalog_with(packages.settings.additions)
    for path in packages.files(".launch.py", ".launch.xml", ".yaml", ".xacro", ".urdf"):
        if not path.startswith(folder + os.sep):
            continue
        text = packages.read(path).data.decode("utf-8", "replace")
        if path.endswith(_LAUNCHES) and _can_be_read(packages, path):
            text = re.sub(_COMMENT, "", text)
            yield from re.findall(_NAMED_IN_LAUNCH, text)
            yield from ["xacro"] if "xacro " in text else []
            yield from ["moveit_configs_utils", *planners_of(text)] if "moveit_configs_utils" in text else []
        elif path.endswith(".yaml"):
            types = re.findall(r"(?m)^\s+type:\s*['\"]?(\w+/\w+)", text)
            yield from (kind.package for name in types if (kind := catalog.controller(name, packages.options.target)))
        elif "<ros2_control" in text:
            yield from (name for name in [system(packages).package] if name not in _NO_PACKAGES)


MANIFEST = Step(
    name="manifest",
    part=Part.MANIFEST,
    summary="package.xml and CMakeLists.txt",
    propose=_manifests,
    generation=1,
    is_needed=True,
    rows=(
        Row("package.xml format 1 or 2, catkin", "format 3, ament_cmake", "", _FORMAT),
        Row("gazebo_ros_control", "gz_ros2_control or gazebo_ros2_control", "", _AUTHORITY),
        Row("joint_state_controller", "joint_state_broadcaster", "", _AUTHORITY),
        Row(
            "catkin_package(), CATKIN_PACKAGE_SHARE_DESTINATION",
            "ament_package(), share/${PROJECT_NAME}",
            "",
            _AUTHORITY,
        ),
    ),
    before=[
        {
            "package.xml": """
                <package format="2">
                  <name>arm</name>
                  <buildtool_depend>catkin</buildtool_depend>
                  <exec_depend>joint_state_controller</exec_depend>
                </package>
            """,
            "CMakeLists.txt": """
                cmake_minimum_required(VERSION 3.0.2)
                project(arm)
                find_package(catkin REQUIRED)
                catkin_package()
                install(DIRECTORY launch DESTINATION ${CATKIN_PACKAGE_SHARE_DESTINATION})
            """,
        },
    ],
    after=[
        {
            "CMakeLists.txt": """
                cmake_minimum_required(VERSION 3.8)
                project(arm)
                find_package(ament_cmake REQUIRED)
                install(DIRECTORY launch DESTINATION share/${PROJECT_NAME})

                ament_package()
            """,
            "package.xml": """
                <package format="3">
                  <name>arm</name>
                  <buildtool_depend>ament_cmake</buildtool_depend>
                  <exec_depend>joint_state_broadcaster</exec_depend>

                  <export>
                    <build_type>ament_cmake</build_type>
                  </export>
                </package>
            """,
        },
    ],
)
