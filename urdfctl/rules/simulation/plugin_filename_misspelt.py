"""UC503."""

from __future__ import annotations

from collections.abc import Iterator

from urdfctl.catalog.distros import generation
from urdfctl.catalog.hardware import library_of
from urdfctl.control.hardware.gazebo_plugins import DRIVES, LIBRARIES
from urdfctl.control.hardware.simulator_plugins import LoadedPlugin, loaded_plugins
from urdfctl.names import folded, is_slip
from urdfctl.rule import Finding, Project, Severity, rule
from urdfctl.rules.common import is_known, replaced


@rule(
    "UC503",
    severity=Severity.WARNING,
    runtime="warns",
    authority="gazebo common/Plugin.hh: 'Failed to load plugin libgazebo_ros_contol.so: cannot open shared object file'; "
    "gz-sim src/SystemLoader.cc: 'couldn't find shared library'",
    bad=[
        {
            "robot.urdf": """
                <gazebo>
                  <plugin name="gazebo_ros_control" filename="«gazebo_ros_control.so»"/>
                </gazebo>
            """,
        },
        {
            "options": "--distro=jazzy",
            "robot.urdf": """
                <ros2_control name="arm" type="system">
                  <hardware><plugin>gz_ros2_control/GazeboSimSystem</plugin></hardware>
                  <joint name="elbow"><command_interface name="position"/><state_interface name="position"/></joint>
                </ros2_control>
                <gazebo>
                  <plugin name="gz_ros2_control::GazeboSimROS2ControlPlugin" filename="«gz_ros2_control»">
                    <parameters>/opt/arm/controllers.yaml</parameters>
                  </plugin>
                </gazebo>
            """,
        },
    ],
    good=[
        {
            "robot.urdf": """
                <gazebo>
                  <plugin name="gazebo_ros_control" filename="libgazebo_ros_control.so"/>
                </gazebo>
            """,
        },
    ],
)
def plugin_filename_misspelt(project: Project) -> Iterator[Finding]:
    """Misspelt file name of a plugin.

    Gazebo Classic requires the complete file name with `lib` and `.so`; gz also accepts it without them. Gazebo prints
    an error if it does not find a library, and goes on without it. The class in `name` says which library is meant.
    """
    known = {library: f"lib{library}.so" for of in LIBRARIES.values() for library in of}
    classes: dict[str, list[str]] = {}
    for ros_distro in ("noetic", "humble", "jazzy"):
        for plugin in project.catalog.simulator_plugins(ros_distro):
            known |= {name.removeprefix("lib").removesuffix(".so"): name for name in reversed(plugin.filenames)}
            for name in plugin.names if plugin.filenames else ():
                classes.setdefault(name, []).append(plugin.filenames[0])
    for sim_plugin in loaded_plugins(project):
        if not sim_plugin.filename or not is_known(sim_plugin.filename) or "/" in sim_plugin.filename:
            continue
        meant = _meant(sim_plugin, known) or _of_class(sim_plugin, classes)
        if meant and not _is_of_other_ros(project, meant):
            at = sim_plugin.plugin.at["filename"]
            vital = library_of(meant) in DRIVES or _hosts_control(project, meant)
            severity = Severity.ERROR if vital else None
            message = f"unknown plugin library '{sim_plugin.filename}'; did you mean '{meant}'?"
            fix = replaced(at, sim_plugin.plugin.filename or "", meant, safe=is_slip(sim_plugin.filename, meant))
            yield Finding(at, message, fix=fix, severity=severity)


def _is_of_other_ros(project: Project, filename: str) -> bool:
    """Whether only the other generation of ROS has a library: another rule reports that, and what to load instead."""
    having = {generation(distro) for distro in project.catalog.distros_of_library(filename)}
    having |= {ros for ros, libraries in LIBRARIES.items() if library_of(filename) in libraries}
    return bool(having) and project.ros is not None and project.ros not in having


def _hosts_control(project: Project, filename: str) -> bool:
    distros = project.catalog.distros_of_library(filename)
    plugin = project.catalog.simulator_plugin(filename, distros[-1]) if distros else None
    return plugin is not None and plugin.hosts_control


def _of_class(sim_plugin: LoadedPlugin, classes: dict[str, list[str]]) -> str | None:
    """The library of the class that a plugin names, if its own library is not known and is a part of that name."""
    libraries = classes.get((sim_plugin.plugin.name or "").strip(), ()) if sim_plugin.any is None else ()
    return next((one for one in libraries if sim_plugin.library in library_of(one)), None)


def _meant(sim_plugin: LoadedPlugin, known: dict[str, str]) -> str | None:
    if sim_plugin.library in known:
        whole = known[sim_plugin.library].endswith(".so") and sim_plugin.simulator == "gazebo-classic"
        return known[sim_plugin.library] if whole and sim_plugin.filename != known[sim_plugin.library] else None
    if sim_plugin.any is not None:
        return None
    if sim_plugin.library.rstrip("0123456789") in known:
        return None
    same = {folded(library): name for library, name in known.items()}.get(folded(sim_plugin.library))
    return same or next((name for library, name in known.items() if is_slip(sim_plugin.library, library)), None)
