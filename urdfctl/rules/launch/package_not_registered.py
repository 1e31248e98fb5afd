"""UC600."""

from __future__ import annotations

from collections.abc import Iterator

from urdfctl.catalog.distros import ROS2
from urdfctl.rule import Edit, Finding, Fix, Project, Severity, rule
from urdfctl.source.span import Place, SourceSpan


def _files(end: str, *, mark: tuple[str, str] = ("", ""), start: str = "") -> dict[str, str]:
    project = f"project({mark[0]}arm{mark[1]})"
    return {
        "arm.urdf": "",
        "package.xml": """
            <package format="3">
              <name>arm</name>
              <export><build_type>ament_cmake</build_type></export>
            </package>
        """,
        "CMakeLists.txt": f"{start}{project}\nfind_package(ament_cmake REQUIRED)\n{end}\n",
    }


@rule(
    "UC600",
    severity=Severity.ERROR,
    runtime="refuses",
    distros=ROS2,
    authority="ament_cmake_core core/ament_package.cmake: 'It must be called once for each package', installs package.xml and "
    "registers the package; ament_index_python get_package_prefix(): PackageNotFoundError \"package 'arm' not found\"",
    bad=[
        _files("# ament_package()", mark=("«", "»")),
        _files("include(CTest)", mark=("«", "»")),
        _files(
            "install(FILES arm.urdf DESTINATION share/arm)",
            mark=("«", "»"),
            start="cmake_minimum_required(VERSION 3.8)\n",
        ),
    ],
    good=[
        _files("ament_package()"),
        _files("ament_auto_package()"),
        _files("company_package()"),
        _files("include(cmake/package.cmake)"),
        _files("include(CTest)\nament_package()"),
        {**_files(""), "CMakeLists.txt": "project(arm)\n"},
    ],
)
def package_not_registered(project: Project) -> Iterator[Finding]:
    """CMakeLists.txt never calls ament_package().

    colcon builds the package and installs its files, but does not register it: `ros2 launch` and all that look for the
    package say that it is not found.
    """
    for name, at in project.build.unregistered:
        message = f"CMakeLists.txt never calls ament_package(), so ROS 2 does not find package '{name}' after the build"
        yield Finding(at, message, fix=Fix("call ament_package() at its end", _at_the_end(at), safe=True))


def _at_the_end(at: Place) -> tuple[Edit, ...]:
    end = len(at.source.data)
    line = "ament_package()\n" if at.source.data.endswith(b"\n") else "\nament_package()\n"
    return (Edit(SourceSpan(at.source, end, end), line),)
