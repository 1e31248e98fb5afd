"""UC615."""

from __future__ import annotations

from collections.abc import Iterator

from urdfctl.model.launch import LeftOut, Package
from urdfctl.rule import Finding, Note, Project, Severity, rule
from urdfctl.rules.launch.common import ROS_2
from urdfctl.rules.launch_samples import MANIFEST, SOUND

_FIND = "$(find "
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


def _of_other_package(folders: str) -> dict[str, str]:
    """A package beside, whose file the launch file gives to a program."""
    mark = ("", "") if "config" in folders else ("«", "»")
    node = '<node pkg="teleop" exec="teleop"><param from="{0}$(find-pkg-share pad)/config/pad.yaml{1}"/></node>'
    launch = _files("")["launch/arm.launch.xml"].replace("</launch>", node.format(*mark) + "</launch>")
    return {
        "launch/arm.launch.xml": launch,
        "package.xml": _MANIFEST.replace(
            "<export>", "<exec_depend>pad</exec_depend><exec_depend>teleop</exec_depend><export>"
        ),
        "pad/package.xml": _MANIFEST.replace("<name>arm<", "<name>pad<"),
        "pad/config/pad.yaml": "teleop: {ros__parameters: {axis: 1}}\n",
        "pad/CMakeLists.txt": f"project(pad)\ninstall(DIRECTORY {folders} DESTINATION share/pad)\nament_package()\n",
    }


def _of_plugin(folders: str, mark: tuple[str, str] = ("", "")) -> dict[str, str]:
    """A description whose simulator plugin finds its controllers in the package."""
    files = _files(folders)
    plugin = f"""<gazebo><plugin filename="gz_ros2_control-system" name="gz_ros2_control::GazeboSimROS2ControlPlugin">
          <parameters>{mark[0]}$(find arm)/config/controllers.yaml{mark[1]}</parameters></plugin></gazebo>"""
    launch = """<launch>
          <node pkg="robot_state_publisher" exec="robot_state_publisher">
            <param name="robot_description" value="$(command 'xacro $(find-pkg-share arm)/urdf/arm.xacro')" type="str"/>
          </node>
          <node pkg="controller_manager" exec="spawner" args="joint_state_broadcaster arm_controller"/>
        </launch>"""
    robot = files["urdf/arm.urdf"].replace("mock_components/GenericSystem", "gz_ros2_control/GazeboSimSystem")
    files = {name: text for name, text in files.items() if name != "urdf/arm.urdf"}
    manifest = _MANIFEST.replace("<export>", "<exec_depend>gz_ros2_control</exec_depend><export>")
    return {
        **files,
        "options": "--distro=jazzy --simulator=gz",
        "launch/arm.launch.xml": launch,
        "urdf/arm.xacro": robot + plugin,
        "package.xml": manifest,
    }


def _of_launch_file(folders: str, manifest: str) -> dict[str, str]:
    """A package that does not install its launch files."""
    return {**_files(folders), "package.xml": manifest}


@rule(
    "UC615",
    severity=Severity.ERROR,
    runtime="refuses",
    authority="ament_index_python get_package_share_directory(): <prefix>/share/<package>, where only install() rules and "
    "data_files of setup.py put files",
    bad=[
        _files("launch urdf", "$(find-pkg-share arm)/config/controllers.yaml"),
        {**_files("launch urdf config"), **_of_other_package("launch")},
        _of_plugin("launch urdf", ("«", "»")),
        _of_launch_file("urdf config", _MANIFEST.replace('<package format="3">', '«<package format="3">»')),
    ],
    good=[
        _files("launch urdf config"),
        {**_files("launch urdf config"), **_of_other_package("config")},
        _of_plugin("launch urdf config"),
    ],
)
def file_not_installed(project: Project) -> Iterator[Finding]:
    """File used by a launch file is not installed.

    `ros2 launch` looks in the installed package. It contains only what `install()` in CMakeLists.txt or `data_files` in
    setup.py lists. The launch fails, although the file is in the source tree. ROS 1 needs install rules only for
    `catkin_make install` and for binary packages; there the rule reports files that an installed launch file uses.
    Without a file that a program gets as an argument, such as RViz's configuration, only that program does not work as
    intended: a warning. The launch file itself is found only if it is installed.
    """
    launch = project.launch
    package = launch.package if launch else None
    if launch is None or package is None or package.ros != launch.ros:
        return
    severity = None if launch.ros == ROS_2 else Severity.WARNING
    if severity and not package.installs(launch.path):
        return
    told = set()
    for reference in launch.references:
        file = reference.file
        left_out = package.left_out(file.path) if file.path and file.exists and reference.sure else None
        if left_out is None:
            continue
        is_own = left_out.folder == package.folder
        if not is_own and (launch.ros != ROS_2 or file.text != file.path):
            continue
        notes = (Note("the package's manifest is here", package.at),) if is_own else ()
        told.add(file.path)
        worst = Severity.WARNING if reference.use == "argument" else severity
        yield Finding(file.at, _message(left_out, package), notes, severity=worst)
    if launch.ros == ROS_2:
        yield from (finding for path, finding in _of_description(project, package) if path not in told)
        left_out = package.left_out(launch.path)
        if left_out is not None and left_out.folder == package.folder and not _is_for_tests(left_out):
            message = f"{_message(left_out, package)}; 'ros2 launch {package.name}' does not find it"
            yield Finding(package.at, message)


def _is_for_tests(launch_file: LeftOut) -> bool:
    """Whether a launch file is only run in the source tree."""
    return any(part.startswith(("test", "example")) for part in launch_file.inner.split("/"))


def _of_description(project: Project, package: Package) -> Iterator[tuple[str | None, Finding]]:
    """Yield the controller files that a simulator's plugin looks for in a package that does not install them."""
    for file in project.controllers.references if project.controllers else ():
        left_out = package.left_out(file.path) if file.path and file.exists else None
        if left_out and file.at.source.is_xacro and _FIND in file.at.span.text:
            yield file.path, Finding(file.at, _message(left_out, package))


def _message(left_out: LeftOut, package: Package) -> str:
    what = f"folder '{left_out.above}'" if left_out.above else "it"
    of = "" if left_out.folder == package.folder else f" of package '{left_out.package}'"
    return f"'{left_out.inner}'{of} is not installed: {left_out.build} does not list {what}"
