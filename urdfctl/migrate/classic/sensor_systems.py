"""The systems that make the sensors of a robot work in gz: a world without plugins of its own does not load them."""

from __future__ import annotations

import os
import re
from collections.abc import Iterator, Mapping

from urdfctl.diagnostic import Edit
from urdfctl.load.loader import LoadedTarget
from urdfctl.migrate.classic.choice import CHOICE
from urdfctl.migrate.edits.markup import MACRO, ancestors, elements, root_of, step_of
from urdfctl.migrate.edits.tokens import XML
from urdfctl.migrate.options import Part
from urdfctl.migrate.packages import MigratedPackages
from urdfctl.migrate.shared.hardware import goes_to_gz
from urdfctl.migrate.step import EntryKind, Proposal, ReportEntry, Row, Step
from urdfctl.migrate.todo import for_you
from urdfctl.model.robot import Robot
from urdfctl.source.span import SourceSpan

AUTHORITY = "gz-sim server.config: sensors, IMU, contact and force-torque systems are not loaded by default"
_SENSORS = ("gz-sim-sensors-system", "gz::sim::systems::Sensors")
SYSTEMS: Mapping[str, tuple[str, str]] = {
    "imu": ("gz-sim-imu-system", "gz::sim::systems::Imu"),
    "gpu_lidar": _SENSORS,
    "camera": _SENSORS,
    "depth_camera": _SENSORS,
    "rgbd_camera": _SENSORS,
    "contact": ("gz-sim-contact-system", "gz::sim::systems::Contact"),
    "force_torque": ("gz-sim-forcetorque-system", "gz::sim::systems::ForceTorque"),
    "navsat": ("gz-sim-navsat-system", "gz::sim::systems::NavSat"),
}
"""By type of sensor: the library and the class of its system."""
_UNKNOWN = (
    "load it in the world for the sensors of this robot, unless a file of another package does, which is not here"
)


def is_loaded_in(text: bytes, system: tuple[str, str]) -> bool:
    """Return whether a text names the library of a system of gz, by its name in Ignition too: later steps rename it."""
    own = re.escape(system[0].removeprefix("gz-sim-").encode())
    return re.search(rb"\b(?:lib)?(?:gz-sim|ignition-gazebo)\d*-" + own, text) is not None


def _systems(packages: MigratedPackages) -> Iterator[Proposal]:
    if not goes_to_gz(packages):
        return
    if packages.was_in_gz:
        yield from _of_variants(packages)
        return
    worlds = b"".join(packages.read(path).data for path in packages.files(".sdf", ".world"))
    done: set[str] = set()
    known = sorted(packages.loaded(), key=lambda one: not one.project.complete)  # with the arguments of a launch file
    whole = {os.path.realpath(each) for one in known if one.project.complete for each in one.sources}
    for loaded in known:
        robot, path = loaded.project.robot, os.path.realpath(loaded.project.path)
        if robot is None or path in done or not packages.may_change(path):
            continue
        texts = b"".join([worlds, *(packages.read(each).data for each in loaded.sources if each.endswith(XML))])
        absent = (system for system in _needed(packages, loaded, robot) if not is_loaded_in(texts, system))
        missing = [system for system in absent if not _has(robot, system[0])]
        root = root_of(packages.read(path))
        is_robot = root is not None and root.tagName == "robot"
        if not missing or root is None or not is_robot or root.close is None or CHOICE.encode() in root.source.data:
            continue
        done.add(path)
        if not loaded.project.complete and path not in whole and robot.links:
            names = ", ".join(file for file, _ in missing)
            yield for_you(root.at, f"{names}: {_UNKNOWN}", authority=AUTHORITY)
        if not loaded.project.complete:
            continue
        step = step_of(root.source)
        lines = "".join(f'{step * 2}<plugin filename="{file}" name="{name}"/>\n' for file, name in missing)
        start = root.source.data.rfind(b"\n", 0, root.close) + 1
        edit = Edit(SourceSpan(root.source, start, start), f"{step}<gazebo>\n{lines}{step}</gazebo>\n")
        names = ", ".join(file for file, _ in missing)
        message = f"the robot loads {names} for its sensors: no world of the packages does"
        entry = ReportEntry(EntryKind.DECIDED, message, root.at, authority=AUTHORITY, option="load them in the world")
        yield Proposal((edit,), entries=(entry,))


def _of_variants(packages: MigratedPackages) -> Iterator[Proposal]:
    """Leave the systems to a person where gz already simulates a robot with other arguments: what its file loads, all
    of its variants load."""
    worlds = b"".join(packages.read(path).data for path in packages.files(".sdf", ".world"))
    for loaded in packages.loaded():
        robot, root = loaded.project.robot, root_of(packages.read(os.path.realpath(loaded.project.path)))
        if robot is None or root is None or not packages.is_of_classic(loaded):
            continue
        kinds = (s.attributes.get("type", "") for gazebo in robot.gazebos for s in gazebo.tag.named("sensor"))
        needed = dict.fromkeys(SYSTEMS[kind] for kind in kinds if kind in SYSTEMS)
        missing = [one[0] for one in needed if not _has(robot, one[0]) and not is_loaded_in(worlds, one)]
        if missing and packages.may_change(root.source.path):
            given = " ".join(f"{name}:={value}" for name, value in loaded.arguments)
            what = f"{', '.join(missing)}: load it for the sensors of the robot with {given or 'its defaults'}"
            yield Proposal(entries=(ReportEntry(EntryKind.FOR_YOU, what, root.at, authority=AUTHORITY),))


def _needed(packages: MigratedPackages, loaded: LoadedTarget, robot: Robot) -> list[tuple[str, str]]:
    """The systems for the sensors that a robot has, and for those that it has with other arguments."""
    types = [s.attributes.get("type", "") for gazebo in robot.gazebos for s in gazebo.tag.named("sensor")]
    found = [*types, *_written(packages, loaded)]
    return list(dict.fromkeys(SYSTEMS[kind] for kind in found if kind in SYSTEMS))


def _written(packages: MigratedPackages, loaded: LoadedTarget) -> Iterator[str]:
    """The types of the sensors in the files of a robot, without those in macros that the files do not call."""
    roots = [root_of(packages.read(path)) for path in loaded.sources if path.endswith(XML)]
    written = [element for root in roots if root is not None for element in elements(root)]
    called = {element.tagName for element in written}
    for element in written:
        macros = (above for above in ancestors(element) if above.tagName == MACRO)
        is_used = all(f"xacro:{macro.attrs.get('name', '').removeprefix('xacro:')}" in called for macro in macros)
        if element.tagName == "sensor" and is_used:
            yield element.attrs.get("type", "")


def _has(robot: Robot, filename: str) -> bool:
    return any(filename.removeprefix("gz-sim-") in (plugin.filename or "") for plugin in robot.plugins)


SENSOR_SYSTEMS = Step(
    name="sensor-systems",
    part=Part.URDF,
    summary="Systems for sensors in gz",
    propose=_systems,
    rows=tuple(Row(f'<sensor type="{kind}">', f"{one[0]} too", "jazzy", AUTHORITY) for kind, one in SYSTEMS.items()),
    before=[
        {
            "options": "--to=jazzy --simulator=gz",
            "robot.urdf": """
                <gazebo reference="fore">
                  <sensor name="imu" type="imu"/>
                </gazebo>
            """,
        },
    ],
    after=[
        {
            "robot.urdf": """
                <gazebo reference="fore">
                  <sensor name="imu" type="imu"/>
                </gazebo>
                <gazebo>
                  <plugin filename="gz-sim-imu-system" name="gz::sim::systems::Imu"/>
                </gazebo>
            """,
        },
    ],
)
