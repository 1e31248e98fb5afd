"""UC637."""

from __future__ import annotations

from collections.abc import Iterator

from urdfctl.catalog.distros import ROS2
from urdfctl.rule import Finding, Project, Severity, rule


def _files(folders: str) -> dict[str, str]:
    return {
        "arm.urdf": "",
        "package.xml": """
            <package format="3">
              <name>arm</name>
              <export><build_type>ament_cmake</build_type></export>
            </package>
        """,
        "CMakeLists.txt": f"""
            cmake_minimum_required(VERSION 3.8)
            project(arm)
            find_package(ament_cmake REQUIRED)
            install(DIRECTORY {folders} DESTINATION share/${{PROJECT_NAME}})
            ament_package()
        """,
        "config/arm.rviz": "Panels: []",
    }


@rule(
    "UC637",
    severity=Severity.WARNING,
    runtime="refuses",
    because="the folder may exist on the machine of the author",
    distros=ROS2,
    authority="CMake install(): 'file INSTALL cannot find \"/ws/src/arm/launch\": No such file or directory.'; "
    "ament_cmake_core: \"ament_cmake_symlink_install_directory() can't find '/ws/src/arm/launch'\"",
    bad=[_files("config «launch»")],
    good=[_files("config")],
)
def installed_file_missing(project: Project) -> Iterator[Finding]:
    """CMakeLists.txt installs a file or folder that does not exist.

    colcon stops at the missing one, and the package is not installed. git does not store empty folders, so the folder
    may exist on the machine of the author.
    """
    for name, at in project.build.absent:
        message = f"CMakeLists.txt installs '{name}', which does not exist, so the build fails; create or remove it"
        yield Finding(at, message)
