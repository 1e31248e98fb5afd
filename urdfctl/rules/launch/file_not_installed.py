"""UC615."""

from __future__ import annotations

from collections.abc import Iterator

from urdfctl.model.launch import Launch, Package
from urdfctl.rule import Finding, Note, Project, Severity, rule
from urdfctl.rules.launch.common import ROS_2
from urdfctl.rules.launch_samples import MANIFEST, SOUND
from urdfctl.source.span import Place

_MANIFEST = MANIFEST.replace("</package>", "<export><build_type>ament_cmake</build_type></export></package>")


def _files(folders: str, mark: str = "") -> dict[str, str]:
    launch = SOUND["arm.launch.xml"].replace("share arm)/controllers.yaml", "share arm)/config/controllers.yaml")
    if mark:
        launch = launch.replace(f'param from="{mark}"', f'param from="«{mark}»"').replace(f"-p {mark}", f"-p «{mark}»")
    return {
        "launch/arm.launch.xml": launch.replace("arm)/arm.urdf", "arm)/urdf/arm.urdf"),
        "config/controllers.yaml": SOUND["controllers.yaml"],
        "urdf/arm.urdf": SOUND["arm.urdf"],
        "package.xml": _MANIFEST,
        "CMakeLists.txt": f"""
            cmake_minimum_required(VERSION 3.8)
            project(arm)
            find_package(ament_cmake REQUIRED)
            install(DIRECTORY {folders} DESTINATION share/${{PROJECT_NAME}})
            ament_package()
        """,
    }


@rule(
    "UC615",
    severity=Severity.ERROR,
    runtime="refuses",
    authority="ament_index_python get_package_share_directory(): <prefix>/share/<package>, where only install() rules and "
    "data_files of setup.py put files",
    bad=[_files("launch urdf", "$(find-pkg-share arm)/config/controllers.yaml")],
    good=[_files("launch urdf config")],
)
def file_not_installed(project: Project) -> Iterator[Finding]:
    """File used by a launch file is not installed.

    `ros2 launch` looks in the installed package. It contains only what `install()` in CMakeLists.txt or `data_files` in
    setup.py lists. The launch fails, although the file is in the source tree. ROS 1 needs install rules only for
    `catkin_make install` and for binary packages; there the rule reports files that an installed launch file uses.
    Without a file that a program gets as an argument, such as RViz's configuration, only that program does not work as
    intended: a warning.
    """
    launch = project.launch
    package = launch.package if launch else None
    if launch is None or package is None or package.ros != launch.ros:
        return
    severity = None if launch.ros == ROS_2 else Severity.WARNING
    if severity and not package.installs(launch.path):
        return
    for path, at, use in _own(launch, package):
        if package.installs(path) is False:
            inner = path.removeprefix(package.folder).lstrip("/")
            folder = inner.rpartition("/")[0]
            what = f"folder '{folder}'" if folder else "it"
            message = f"'{inner}' is not installed: {package.build_file} does not list {what}"
            manifest = Note("the package's manifest is here", package.at)
            yield Finding(at, message, (manifest,), severity=Severity.WARNING if use == "argument" else severity)


def _own(launch: Launch, package: Package) -> Iterator[tuple[str, Place, str]]:
    """Yield the package's files that the launch file uses in every case, and what for."""
    for reference in launch.references:
        path = reference.file.path
        if path and reference.sure and reference.file.exists and path.startswith(f"{package.folder}/"):
            yield path, reference.file.at, reference.use
