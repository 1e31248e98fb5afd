"""UC503."""

from __future__ import annotations

from collections.abc import Iterator

from urdfctl.catalog.hardware import library_of
from urdfctl.rule import Finding, Project, Severity, rule
from urdfctl.rules.common import is_known, replaced
from urdfctl.rules.simulation.common import Loaded, loaded
from urdfctl.rules.simulation.facts import DRIVES, LIBRARIES
from urdfctl.suggest import folded, is_slip


@rule(
    "UC503",
    severity=Severity.WARNING,
    authority="gazebo common/Plugin.hh: 'Failed to load plugin libgazebo_ros_contol.so: cannot open shared object file'; "
    "gz-sim src/SystemLoader.cc: 'couldn't find shared library'",
    bad={
        "robot.urdf": """
            <gazebo>
              <plugin name="gazebo_ros_control" filename="«gazebo_ros_control.so»"/>
            </gazebo>
        """,
    },
    good={
        "robot.urdf": """
            <gazebo>
              <plugin name="gazebo_ros_control" filename="libgazebo_ros_control.so"/>
            </gazebo>
        """,
    },
)
def plugin_filename_misspelt(project: Project) -> Iterator[Finding]:
    """A plugin's file is spelt nearly like one that exists.

    Gazebo Classic wants the whole name of the file, with `lib` and `.so`; gz takes it without them too. A library that
    is not found is not loaded, and the robot goes without it.
    """
    known = {library: f"lib{library}.so" for of in LIBRARIES.values() for library in of}
    for ros_distro in ("noetic", "humble", "jazzy"):
        for plugin in project.catalog.simulator_plugins(ros_distro):
            known |= {name.removeprefix("lib").removesuffix(".so"): name for name in reversed(plugin.filenames)}
    for one in loaded(project):
        if not one.filename or not is_known(one.filename) or "/" in one.filename:
            continue
        meant = _meant(one, known)
        if meant:
            at = one.plugin.at["filename"]
            vital = library_of(meant) in DRIVES or _hosts_control(project, meant)
            severity = Severity.ERROR if vital else None
            message = f"no plugin has the file '{one.filename}'; did you mean '{meant}'?"
            fix = replaced(at, one.plugin.filename or "", meant)
            yield Finding(at, message, fix=fix, severity=severity)


def _hosts_control(project: Project, filename: str) -> bool:
    distros = project.catalog.distros_of_library(filename)
    plugin = project.catalog.simulator_plugin(filename, distros[-1]) if distros else None
    return plugin is not None and plugin.hosts_control


def _meant(one: Loaded, known: dict[str, str]) -> str | None:
    if one.library in known:
        whole = known[one.library].endswith(".so") and one.simulator == "gazebo-classic"
        return known[one.library] if whole and one.filename != known[one.library] else None
    if one.any is not None:
        return None
    if one.library.rstrip("0123456789") in known:
        return None
    same = {folded(library): name for library, name in known.items()}.get(folded(one.library))
    return same or next((name for library, name in known.items() if is_slip(one.library, library)), None)
