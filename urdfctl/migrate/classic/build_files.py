"""CMakeLists.txt that looks for packages of Gazebo Classic, at which the build ends because the target has none."""

from __future__ import annotations

import os
import re
from collections.abc import Iterator

from urdfctl.catalog.distros import since
from urdfctl.diagnostic import Edit
from urdfctl.migrate.options import Part
from urdfctl.migrate.packages import MigratedPackages
from urdfctl.migrate.shared.hardware import leaves_classic
from urdfctl.migrate.step import EntryKind, Proposal, ReportEntry, Row, Step
from urdfctl.migrate.todo import for_you
from urdfctl.source.span import Place, SourceSpan, SourceText

_AUTHORITY = "rosdistro#41224: not in jazzy; cmake-commands: find_package(REQUIRED) ends the build"
_GONE = rb"gazebo(?:_ros|_plugins|_ros2_control|_ros_pkgs|_msgs|_dev)?"
_FOUND = re.compile(rb"(?im)^[ \t]*find_package\s*\(\s*(%s)\b[^()]*\)[ \t]*(?:#[^\n]*)?(?:\r?\n|\Z)" % _GONE)
_USED = re.compile(rb"(?i)\bament_(?:target|export)_dependencies\s*\([^()]*\)")
_NAME = re.compile(rb"(?:\s+|(?<=\())(%s)(?![\w.-])" % _GONE)
_CODE = (".cpp", ".cc", ".cxx", ".c", ".hpp", ".h", ".hh")
_INCLUDE = re.compile(rb"#\s*include\s*[<\"](%s)/" % _GONE)
_VARIABLE = re.compile(rb"(?i)\$\{%s_|\bgazebo(?:_\w+)?::" % _GONE)


def _build_files(packages: MigratedPackages) -> Iterator[Proposal]:
    if not leaves_classic(packages) or packages.options.target not in since("jazzy") or packages.options.keep_classic:
        return
    for path in packages.files("CMakeLists.txt"):
        source = packages.read(path)
        if b"ament" in source.data and packages.may_change(path):
            yield from _without_classic(packages, source)


def _without_classic(packages: MigratedPackages, source: SourceText) -> Iterator[Proposal]:
    """Remove what nothing compiled needs; a package with code for Gazebo Classic is left to a person."""
    found = [one for one in _FOUND.finditer(source.data) if not _is_comment(source, one.start(1))]
    if not found:
        return
    names = list(dict.fromkeys(f"'{one[1].decode()}'" for one in found))
    at = Place(source, found[0].start(1), end=found[0].end(1))
    if _is_compiled(packages, os.path.dirname(source.path)) or _VARIABLE.search(source.data):
        gone, it = (f"packages {', '.join(names)}", "them") if names[1:] else (f"package {names[0]}", "it")
        what = f"{packages.options.target} has no {gone}, at which the build ends: port what needs {it} to gz"
        yield for_you(at, what, authority=_AUTHORITY)
        return
    edits = [Edit(SourceSpan(source, *one.span()), "") for one in found]
    for call in _USED.finditer(source.data):
        edits += [
            Edit(SourceSpan(source, *one.span()), "")
            for one in _NAME.finditer(source.data, *call.span())
            if not _is_comment(source, one.start(1))
        ]
    message = f"the build no longer looks for {', '.join(names)}: nothing that it compiles needs it"
    yield Proposal(tuple(edits), entries=(ReportEntry(EntryKind.DONE, message, at, authority=_AUTHORITY),))


def _is_compiled(packages: MigratedPackages, folder: str) -> bool:
    """Whether a package has code that includes headers of Gazebo Classic."""
    own = (path for path in packages.files(*_CODE) if path.startswith(folder + os.sep))
    return any(_INCLUDE.search(packages.read(path).data) for path in own)


def _is_comment(source: SourceText, position: int) -> bool:
    line = source.data.rfind(b"\n", 0, position) + 1
    return b"#" in source.data[line:position]


BUILD_FILES = Step(
    name="classic-build-files",
    part=Part.MANIFEST,
    summary="Packages of Gazebo Classic in CMakeLists.txt",
    propose=_build_files,
    rows=(
        Row("find_package(gazebo_ros REQUIRED)", "", "jazzy", _AUTHORITY),
        Row("ament_target_dependencies(... gazebo_ros)", "without it", "jazzy", _AUTHORITY),
    ),
    before=[
        {
            "options": "--from=humble --to=jazzy --simulator=gz",
            "CMakeLists.txt": """
                cmake_minimum_required(VERSION 3.8)
                project(arm)
                find_package(ament_cmake REQUIRED)
                find_package(gazebo_ros REQUIRED)
                # find_package(gazebo_dev REQUIRED)
                add_executable(mover src/mover.cpp)
                ament_target_dependencies(mover rclcpp gazebo_ros)
                ament_package()
            """,
            "src/mover.cpp": """
                #include <rclcpp/rclcpp.hpp>
            """,
        },
        {
            "options": "--from=humble --to=jazzy --simulator=gz",
            "CMakeLists.txt": """
                find_package(ament_cmake REQUIRED)
                find_package(gazebo_dev REQUIRED)
                add_library(pusher src/pusher.cpp)
                ament_target_dependencies(pusher gazebo_dev)
                ament_package()
            """,
            "src/pusher.cpp": """
                #include <gazebo/common/Plugin.hh>
            """,
        },
        {
            "options": "--from=humble --to=jazzy --simulator=gz",
            "CMakeLists.txt": """
                find_package(ament_cmake REQUIRED)
                find_package(gazebo REQUIRED)
                find_package(gazebo_ros REQUIRED)
                link_directories(${GAZEBO_LIBRARY_DIRS})
                ament_package()
            """,
        },
    ],
    after=[
        {
            "CMakeLists.txt": """
                cmake_minimum_required(VERSION 3.8)
                project(arm)
                find_package(ament_cmake REQUIRED)
                # find_package(gazebo_dev REQUIRED)
                add_executable(mover src/mover.cpp)
                ament_target_dependencies(mover rclcpp)
                ament_package()
            """,
        },
        {
            "CMakeLists.txt": """
                find_package(ament_cmake REQUIRED)
                # TODO(urdfctl): jazzy has no package 'gazebo_dev', at which the build ends: port what needs it to gz
                find_package(gazebo_dev REQUIRED)
                add_library(pusher src/pusher.cpp)
                ament_target_dependencies(pusher gazebo_dev)
                ament_package()
            """,
        },
        {
            "CMakeLists.txt": """
                find_package(ament_cmake REQUIRED)
                # TODO(urdfctl): jazzy has no packages 'gazebo', 'gazebo_ros', at which the build ends: port what needs them to gz
                find_package(gazebo REQUIRED)
                find_package(gazebo_ros REQUIRED)
                link_directories(${GAZEBO_LIBRARY_DIRS})
                ament_package()
            """,
        },
    ],
)
