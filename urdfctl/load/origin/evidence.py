"""What indicates the ROS generation and distro of a robot: its parts, its package, and the files beside it."""

from __future__ import annotations

import os
import re
from collections.abc import Iterable, Iterator
from typing import TYPE_CHECKING

from urdfctl.catalog.distros import ALL, ROS2, since, spanned, until
from urdfctl.model.project import EvidenceItem
from urdfctl.model.robot import Robot
from urdfctl.source.disk.files import first_bytes
from urdfctl.source.disk.gate import names_in
from urdfctl.source.span import SourceText

if TYPE_CHECKING:
    from urdfctl.load.controller_files import ControllerFiles
    from urdfctl.model.launch import Launch
    from urdfctl.model.moveit import MoveIt, Pipeline
    from urdfctl.source.workspaces.packages import Packages

ROS1 = since("indigo")
"""What a robot of ROS 1 may be for when nothing says more: hydro read transmissions in another form, ten years ago."""
EXPLICIT = 8
"""The weight of an item that names the distro itself."""
_MANIFEST_BYTES = 65536
_HEADER_BYTES = 2048
_MADE, _MADE_FOR = b"made by urdfctl ", rb"made by urdfctl [^\n]*--distro[ =](\w+)"
_CONTROL_OF_ROS2 = ("gazebo_ros2_control", "gz_ros2_control", "ign_ros2_control")
_XML_COMMENT = r"(?s)<!--.*?(?:-->|\Z)"
_DEPENDENCY = re.compile(
    r"<(?:(?:build|exec|run|test|build_export)_)?depend(?![^<>]*\bcondition\s*=)[^<>]*>\s*([^<\s]+)\s*<"
)
_FOUND_BY_CMAKE = r"(?im)^[^#\n]*\bfind_package\s*\(\s*(ament_cmake\w*|catkin)\b"
_BUILD_SYSTEM = r"<(?:build_type|buildtool_depend)[^<>]*>\s*(ament|catkin)"
_ROS2_NUMBER = 2

_ROS1_ONLY = (
    "roscpp rospy roslaunch roslib rosbuild gazebo_ros_control ros_control ros_controllers message_generation "
    "message_runtime dynamic_reconfigure nodelet tf actionlib"
)
_ROS2_ONLY = (
    "rclcpp rclpy rclcpp_lifecycle rclcpp_components launch launch_ros ros2launch ros2run "
    "ament_index_python ament_index_cpp ament_lint_auto ros2_control ros2_controllers ros2controlcli "
    "joint_state_broadcaster rosidl_default_generators rosidl_default_runtime tf2_ros_py "
    "generate_parameter_library nav2_bringup"
)
_SPANS_OF_PACKAGES = {
    **dict.fromkeys(_ROS1_ONLY.split(), "indigo..noetic"),
    **dict.fromkeys(_ROS2_ONLY.split(), "foxy.."),
    **dict.fromkeys(
        "ros_gz ros_gz_sim ros_gz_bridge ros_gz_image ros_gz_interfaces gz_ros2_control".split(), "humble.."
    ),
    **dict.fromkeys("ros_ign ros_ign_gazebo ros_ign_bridge ros_ign_image".split(), "melodic..noetic, foxy..iron"),
    "gazebo_ros2_control": "foxy..iron",
    "ign_ros2_control": "foxy..jazzy",
}
"""Packages that only some distros have, so that who depends on them says what distro it is for."""


def items_of_robot(robot: Robot | None) -> Iterator[EvidenceItem]:
    """Yield what a description says: its hardware components, its plugins, its transmissions."""
    if robot is None:
        return
    if robot.ros2_controls:
        yield EvidenceItem("components", "<ros2_control>", ROS2, 6)
    for filename in dict.fromkeys(plugin.filename or "" for plugin in robot.plugins):
        distros = _distros_of_library(filename)
        if distros:
            weight = 4 if "_control" in filename else 2
            yield EvidenceItem("plugins", f"the plugin '{filename}'", distros, weight)
    names = (plugin.value for control in robot.ros2_controls for part in control.hardware for plugin in part.plugins)
    for name in dict.fromkeys(names):
        distros = _distros_of_hardware(name)
        if distros:
            yield EvidenceItem("hardware", f"the hardware '{name}'", distros, 2)
    if robot.transmissions:
        yield EvidenceItem("transmissions", "<transmission>", ROS1, 1)


def _distros_of_library(filename: str) -> tuple[str, ...]:
    """The distros that have a simulator plugin; none if that is unknown, or it comes with the simulator."""
    from urdfctl.catalog.catalog import CATALOG
    from urdfctl.catalog.hardware import library_of
    from urdfctl.control.hardware.gazebo_plugins import LIBRARIES

    library = library_of(filename)
    known = CATALOG.distros_of_library(filename)
    plugin = CATALOG.simulator_plugin(filename, known[-1]) if known else None
    if plugin is not None and not plugin.external and plugin.package is not None:
        return _usual(known)
    if any(name in filename for name in _CONTROL_OF_ROS2):
        return ROS2
    of_ros1, of_ros2 = (library in LIBRARIES[ros] for ros in (1, 2))
    return () if of_ros1 == of_ros2 else ROS1 if of_ros1 else ROS2


def _distros_of_hardware(name: str) -> tuple[str, ...]:
    """The distros that have a hardware plugin of ros2_control or of Gazebo; none for drivers, which may be built for
    any."""
    from urdfctl.catalog.catalog import CATALOG

    if not name.startswith((*_CONTROL_OF_ROS2, "mock_components/", "fake_components/")):
        return ()
    return tuple(distro for distro in ROS2 if CATALOG.hardware(name, distro))


def _usual(distros: Iterable[str]) -> tuple[str, ...]:
    return tuple(distro for distro in distros if distro in ROS1 or distro in ROS2)


def items_of_package(folder: str | None) -> Iterator[EvidenceItem]:
    """Yield what the manifest, the build file and the launch folder of a package say."""
    if folder is None:
        return
    manifest = os.path.join(folder, "package.xml")
    text = _text(manifest)
    text = re.sub(_XML_COMMENT, "", text) if "<!--" in text else text
    systems = set(re.findall(_BUILD_SYSTEM, text))
    ament, catkin = "ament" in systems, "catkin" in systems
    if ament != catkin:
        yield EvidenceItem("manifest", "package.xml", ROS2 if ament else ROS1, 6, manifest)
    if not (ament and catkin):
        yield from _of_dependencies(dict.fromkeys(_DEPENDENCY.findall(text)), manifest)
    build = os.path.join(folder, "CMakeLists.txt")
    found = {name.lower() for name in re.findall(_FOUND_BY_CMAKE, _text(build))}
    if found and ("catkin" in found) != (found != {"catkin"}):
        yield EvidenceItem("build", f"find_package({min(found)})", ROS1 if "catkin" in found else ROS2, 3, build)
    yield from _of_launch_folder(os.path.join(folder, "launch"))


def _of_dependencies(names: Iterable[str], manifest: str) -> Iterator[EvidenceItem]:
    """What dependencies say that only some distros have."""
    for name in names:
        distros = _distros_of_package(name)
        if distros:
            yield EvidenceItem("dependencies", f"the dependency '{name}'", distros, 3, manifest)


def _of_launch_folder(folder: str) -> Iterator[EvidenceItem]:
    try:
        names = names_in(folder)
    except OSError:
        return
    python, xml = (any(name.endswith(end) for name in names) for end in (".launch.py", ".launch"))
    if python != xml:
        what = f"the launch files *{'.launch.py' if python else '.launch'}"
        yield EvidenceItem("launch folder", what, ROS2 if python else ROS1, 2, folder)


def _text(path: str) -> str:
    try:
        return first_bytes(path, _MANIFEST_BYTES).decode("utf-8", "replace")
    except OSError:
        return ""


def package_of_file(packages: Packages) -> str | None:
    """Return the package whose manifest says what a controller file or a launch file is for.

    Without one of its own, it is one of those beside the file if all are for ROS 2.
    """
    return packages.own() or _ament_package(packages.beside())


def package_of_robot(packages: Packages) -> str | None:
    """Return the package whose manifest says what a robot is for.

    Without one of its own, it is one of the workspace if all are for ROS 2.
    """
    return packages.own() or _package_of_workspace(packages)


def _package_of_workspace(packages: Packages) -> str | None:
    known = packages.known()
    return packages.once(("ament", *known), lambda: _ament_package(map(packages.find, known)))


def _ament_package(packages: Iterable[str]) -> str | None:
    """One of several packages, two at least, if the manifests of all say that they are for ROS 2."""
    folders = list(packages)
    said = {next((i.ros for i in items_of_package(folder) if i.kind == "manifest"), None) for folder in folders}
    return folders[0] if len(folders) > 1 and said == {_ROS2_NUMBER} else None


def items_of_controllers(controllers: ControllerFiles | None) -> Iterator[EvidenceItem]:
    """Yield what controller files say by their form and by the types that they name."""
    if controllers is None:
        return
    from urdfctl.catalog.catalog import CATALOG
    from urdfctl.model.controllers.controller_forms import form_of, types_in

    for yaml in {loaded.yaml.source.path: loaded.yaml for loaded in controllers.files}.values():
        form = form_of(yaml)
        if form is not None:
            is_ros2 = form == _ROS2_NUMBER
            what, weight = ("ros__parameters", 4) if is_ros2 else ("its controllers' types", 3)
            yield EvidenceItem("controller files", what, ROS2 if is_ros2 else ROS1, weight, yaml.source.path)
        for name in dict.fromkeys(types_in(yaml)):
            distros = CATALOG.distros_of(name)
            kind = CATALOG.controller(name, distros[-1]) if distros else None
            if kind is not None and not kind.external:
                what = f"the controller type '{name}'"
                yield EvidenceItem("controller types", what, _usual(distros), 2, yaml.source.path)


def items_of_launch(launch: Launch | None) -> Iterator[EvidenceItem]:
    """Yield what a launch file says by its form, its spawners and the packages that it names."""
    if launch is None:
        return
    is_ros2 = launch.ros == _ROS2_NUMBER
    yield EvidenceItem("launch file", "its launch file", ROS2 if is_ros2 else ROS1, 4 if is_ros2 else 3, launch.path)
    if is_ros2:
        from urdfctl.control.parameters.spawner_options import DISTROS, INSTEAD

        options = {option.name for spawn in launch.spawns for option in spawn.options if spawn.program is not None}
        for name in sorted(options):
            if name in DISTROS and name not in INSTEAD:  # a removed option is a fault rather
                yield EvidenceItem("spawner", f"the spawner's option '{name}'", DISTROS[name], 2, launch.path)
    for name in sorted({word.text for word in launch.packages}):
        distros = _distros_of_package(name)
        if distros:
            yield EvidenceItem("launched packages", f"the package '{name}'", distros, 2, launch.path)


def items_of_moveit(moveit: MoveIt | None) -> Iterator[EvidenceItem]:
    """Yield the distros that MoveIt's planning pipelines are written for, if all are written in one form.

    It says nothing where MoveIt is built in the workspace: its release need not be that of the distro.
    """
    pipelines = moveit.pipelines if moveit and not moveit.is_here else ()
    forms = {form for each in pipelines if (form := _form_of_pipeline(each))}
    if len(forms) == 1:
        yield EvidenceItem("MoveIt", "the form of MoveIt's planning pipelines", forms.pop(), 2)


def _form_of_pipeline(pipeline: Pipeline) -> tuple[str, ...]:
    old, new = pipeline.setting("planning_plugin"), pipeline.setting("planning_plugins")
    if bool(old) == bool(new):
        return ()
    return since("jazzy") if new else (*ROS1, *until("iron"))


def items_of_headers(sources: Iterable[SourceText]) -> Iterator[EvidenceItem]:
    """Yield the distros that files were generated for, by their first lines."""
    for source in sources:
        head = source.data[:_HEADER_BYTES]
        made = re.search(_MADE_FOR, head) if _MADE in head else None
        distro = made[1].decode() if made else ""
        if distro in ALL:
            yield EvidenceItem("headers", "the header of a generated file", (distro,), EXPLICIT, source.path)


def _distros_of_package(name: str) -> tuple[str, ...]:
    """Return the distros of both generations that have a package; none if all do, or that is unknown."""
    span = _SPANS_OF_PACKAGES.get(name)
    return (*spanned(span, 1), *spanned(span, 2)) if span else ()
