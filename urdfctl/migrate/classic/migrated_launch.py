"""Launch files that a migration from ROS 1 wrote: they become what it would have written for a later distro."""

from __future__ import annotations

from collections.abc import Callable, Iterator

from urdfctl.diagnostic import Edit
from urdfctl.migrate.classic.launch_actions import gz_for, is_spawner, starts_classic
from urdfctl.migrate.launch.actions import all_actions
from urdfctl.migrate.launch.parameter_files import with_parameter_files
from urdfctl.migrate.launch.python_reading import read_python
from urdfctl.migrate.launch.written import WrittenLaunch, as_python, as_xml
from urdfctl.migrate.launch.xml_reading import read_xml
from urdfctl.migrate.options import Part
from urdfctl.migrate.packages import MigratedPackages
from urdfctl.migrate.shared.hardware import goes_to_gz, leaves_classic
from urdfctl.migrate.step import EntryKind, Proposal, ReportEntry, Step
from urdfctl.migrate.todo import todo_line
from urdfctl.source.span import Place, SourceSpan, SourceText

_AUTHORITY = "ros_gz_sim README; ros2_control#1694: spawners pass the parameters of their controllers on"
_MARK = b"Migrated from "


def _launch(packages: MigratedPackages) -> Iterator[Proposal]:
    if not packages.crosses("jazzy"):
        return
    forms: tuple[tuple[str, Callable[[SourceText], WrittenLaunch | None], Callable[[WrittenLaunch], str]], ...] = (
        (".launch.py", read_python, as_python),
        (".launch.xml", read_xml, as_xml),
    )
    for ending, read, write in forms:
        for path in packages.files(ending):
            source = packages.read(path)
            written = read(source) if _MARK in source.data[:4096] and packages.may_change(path) else None
            if written is not None:
                yield from _proposed(packages, source, written, write)


def _proposed(
    packages: MigratedPackages, source: SourceText, written: WrittenLaunch, write: Callable[[WrittenLaunch], str]
) -> Iterator[Proposal]:
    actions, todos = list(written.actions), written.todos
    entries = []
    at = Place(source, 0)
    is_classic = any(starts_classic(one) or is_spawner(one) for one in all_actions(written.actions))
    if is_classic and leaves_classic(packages) and goes_to_gz(packages):
        gz = gz_for(packages, source.path)
        left = gz.left(actions)
        todos = tuple(dict.fromkeys((*todos, *(todo_line(source.path, what) for what in left))))
        actions = list(gz.started(actions))
        entries = [ReportEntry(EntryKind.DONE, "the launch file starts gz", at, authority=_AUTHORITY)]
        entries += [ReportEntry(EntryKind.FOR_YOU, what, file=source.path) for what in left]
    elif is_classic and leaves_classic(packages):
        return
    passing = with_parameter_files(packages, source, actions)
    if passing != actions:
        what = "the spawners give their controllers their parameters: --param-file"
        entries.append(ReportEntry(EntryKind.DONE, what, at, authority=_AUTHORITY))
    if entries:
        new = write(WrittenLaunch(written.about, todos, tuple(passing)))
        yield Proposal((Edit(SourceSpan(source, 0, len(source.data)), new),), entries=tuple(entries))


MIGRATED_LAUNCH = Step(
    name="migrated-launch-files",
    part=Part.LAUNCH,
    summary="Launch files that a migration from ROS 1 wrote",
    propose=_launch,
    before=[
        {
            "options": "--from=humble --to=jazzy --simulator=gz",
            "launch/arm.launch.xml": """
                <?xml version="1.0"?>
                <!-- Migrated from arm.launch. -->
                <launch>
                  <include file="$(find-pkg-share gazebo_ros)/launch/gazebo.launch.py"/>
                  <node pkg="gazebo_ros" exec="spawn_entity.py" args="-topic robot_description -entity arm"/>
                </launch>
            """,
        },
    ],
    after=[
        {
            "launch/arm.launch.xml": """
                <?xml version="1.0"?>
                <!-- Migrated from arm.launch. -->
                <launch>
                  <include file="$(find-pkg-share ros_gz_sim)/launch/gz_sim.launch.py">
                    <arg name="gz_args" value="-r empty.sdf"/>
                  </include>
                  <node pkg="ros_gz_bridge" exec="parameter_bridge" args="/clock@rosgraph_msgs/msg/Clock[gz.msgs.Clock"/>
                  <node pkg="ros_gz_sim" exec="create" args="-topic robot_description -name arm"/>
                </launch>
            """,
        },
    ],
)
