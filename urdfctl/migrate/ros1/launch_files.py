"""Launch files of ROS 1 become new launch files of ROS 2, in Python or XML."""

from __future__ import annotations

import glob
import os
import re
from collections.abc import Callable, Iterator

from urdfctl.catalog.distros import since
from urdfctl.migrate.classic.launch_actions import gz_for
from urdfctl.migrate.edits.markup import elements
from urdfctl.migrate.launch.parameter_files import with_parameter_files
from urdfctl.migrate.launch.written import WrittenLaunch, as_python, as_xml
from urdfctl.migrate.options import Part
from urdfctl.migrate.packages import OF_XML, MigratedPackages
from urdfctl.migrate.ros1.described import description_names, idle_publishers, spaces_by_file
from urdfctl.migrate.ros1.included import IncludedFile, descriptions_in, included_file, split_arguments
from urdfctl.migrate.ros1.launch_target import LaunchTarget
from urdfctl.migrate.ros1.launches import doubled_names, launch_roots, new_name
from urdfctl.migrate.ros1.left_over import addressed_files, renamed_includes
from urdfctl.migrate.ros1.moveit_launch import LOADED_BY_MOVEIT, MADE_BY_MOVEIT, PUBLISHER_FILE, packages_of_moveit
from urdfctl.migrate.ros1.roslaunch import LaunchReading
from urdfctl.migrate.ros1.simulated_time import commanding_programs, may_be_real
from urdfctl.migrate.ros1.spawned_names import spawned_names
from urdfctl.migrate.ros1.waiting_spawns import waits_for_publisher
from urdfctl.migrate.shared.controller_files import installed_path, sections, type_names
from urdfctl.migrate.shared.hardware import described_elsewhere, simulated_by, started_by_launch_files
from urdfctl.migrate.step import EntryKind, Proposal, ReportEntry, Row, Step
from urdfctl.migrate.todo import todo_line
from urdfctl.source.disk.files import is_yaml
from urdfctl.source.disk.gate import exists, matching
from urdfctl.source.workspaces.packages import package_around, package_name
from urdfctl.source.xml.dom import Element

_AUTHORITY = "docs.ros.org, Migrating launch files from ROS 1 to ROS 2"
_MOVEIT = "moveit.picknik.ai, moveit_configs_utils: launch files are made by MoveItConfigsBuilder"
_TYPE = re.compile(rb"\btype[\"']?:\s*[\"']?\w+_(?:controllers?|broadcaster)/")
_PARAMETERS = re.compile(rb"<parameters>([^<]*)</parameters>")
_ENDINGS = (".launch", ".launch.xml", ".test")
_OF_MOVEIT = ("moveit_ros_move_group", "moveit_ros_planning", "moveit_setup_assistant", "moveit_ros_benchmarks")


def _launch_files(packages: MigratedPackages) -> Iterator[Proposal]:
    left: dict[tuple[str, str], str] = {}
    wanted = []
    for path, root in _of_ros1(packages):
        own = _package(path)
        if _is_of_moveit(path, root) and own not in set(packages_of_moveit(packages)):
            left[own, os.path.basename(path)] = path
            text = "write the launch files of MoveIt anew with MoveItConfigsBuilder, or its Setup Assistant"
            manifest = os.path.join(os.path.dirname(os.path.dirname(path)), "package.xml")
            yield Proposal(entries=(ReportEntry(EntryKind.FOR_YOU, text, file=manifest, authority=_MOVEIT),))
        else:
            wanted.append((path, root))
    if edits := tuple(renamed_includes(packages, left.values(), f".launch.{packages.options.launch}")):
        yield Proposal(edits)
    for path, root in wanted:
        target = _target(packages)._replace(left=frozenset(left), own_package=_package(path))
        published = descriptions_in(packages, root, os.path.dirname(path), own=False)
        split = frozenset(packages.found(split_arguments).get(path, ()))
        spaces = packages.found(spaces_by_file).get(path, frozenset())
        target = target._replace(
            included=_included_by(packages, path),
            published=published,
            split=split,
            described_in=spaces,
            publisher=packages.found(idle_publishers).get(path),
            undeclared=_undeclared_by(packages, os.path.dirname(path)),
            makes_publisher=exists(os.path.join(os.path.dirname(path), PUBLISHER_FILE)),
        )
        yield from _migrated(packages, path, root, target)


def _included_by(packages: MigratedPackages, path: str) -> Callable[[str], IncludedFile]:
    return lambda written: included_file(packages, written, os.path.dirname(path))


def _undeclared_by(packages: MigratedPackages, folder: str) -> Callable[[str], list[str]]:
    """What tells the controllers of a file, by its address in a folder, that no file of the simulator's plugin has."""

    def undeclared(written: str) -> list[str]:
        known = packages.found(type_names)
        names = packages.found(_files_of_plugins)
        own = addressed_files(packages, written, folder)
        given = {(one.controller, one.value.text) for one in known if os.path.basename(one.path) in names}
        declared = {one.controller: one.value.text for one in known if one.path in own}
        return [name for name, kind in declared.items() if given and (name, kind) not in given]

    return undeclared


def _files_of_plugins(packages: MigratedPackages) -> frozenset[str]:
    """The names of the files that the simulator's plugins load."""
    texts = (packages.read(path).data for path in packages.files(*OF_XML))
    written = (found for text in texts for found in _PARAMETERS.findall(text))
    return frozenset(os.path.basename(one.decode("utf-8", "replace").strip()) for one in written)


def _of_ros1(packages: MigratedPackages) -> Iterator[tuple[str, Element]]:
    """The launch files of ROS 1, with their root elements."""
    for path, root in packages.found(launch_roots).items():
        if "/.ros" not in path:
            yield path, root


def _package(path: str) -> str:
    """The name of the package of a file; empty if it is in none."""
    folder = package_around(os.path.dirname(path))
    return (package_name(os.path.join(folder, "package.xml")) if folder else None) or ""


def _migrated(packages: MigratedPackages, path: str, root: Element, target: LaunchTarget) -> Iterator[Proposal]:
    new = new_name(path, target.ending, target.doubled)
    if exists(new):
        return
    reading = LaunchReading(target)
    actions = reading.actions(root)
    left = list(reading.left)
    described = sorted(descriptions_in(packages, root, os.path.dirname(path)))
    if len(described) > 1:
        shown = ", ".join(f"'{one}'" for one in described)
        left.append(f"each of {shown} has a robot_state_publisher now: keep one, in ROS 1 the last of them counted")
    left += waits_for_publisher(actions)
    if target.started == "gz":
        gz = gz_for(packages, path)
        left += gz.left(actions)
        actions = list(gz.started(actions))
    actions = with_parameter_files(packages, packages.read(path), actions)
    left = list(dict.fromkeys(left))
    name = os.path.basename(path)
    written = WrittenLaunch(f"Migrated from {name}.", tuple(todo_line(new, what) for what in left), tuple(actions))
    text = (as_xml if packages.options.launch == "xml" else as_python)(written)
    entries = [ReportEntry(EntryKind.DONE, f"{name} became {os.path.basename(new)}", file=new, authority=_AUTHORITY)]
    entries += [ReportEntry(EntryKind.DECIDED, what, file=new) for what in reading.decided]
    entries += [ReportEntry(EntryKind.FOR_YOU, what, file=new) for what in left]
    yield Proposal(created=((new, text),), deleted=(path,), entries=tuple(entries))


def _is_of_moveit(path: str, root: Element) -> bool:
    nodes = {element.attrs.get("pkg") for element in elements(root)}
    folder, name = os.path.dirname(os.path.dirname(path)), os.path.basename(path)
    has_its_name = name in MADE_BY_MOVEIT or name.endswith(LOADED_BY_MOVEIT)
    is_configured = has_its_name and bool(matching(os.path.join(glob.escape(folder), "config", "*.srdf")))
    return bool(nodes & {*_OF_MOVEIT}) or is_configured or exists(os.path.join(folder, ".setup_assistant"))


def _target(packages: MigratedPackages) -> LaunchTarget:
    options = packages.options
    controllers = _controller_files(packages)
    return LaunchTarget(
        distro=options.target,
        simulator=simulated_by(packages),
        started=started_by_launch_files(packages),
        own=frozenset(own_packages(packages)),
        renamed=frozenset(options.successors),
        ending=f".launch.{options.launch}",
        is_controllers_file=lambda written: os.path.basename(written) in controllers,
        controllers_in=lambda written: _controllers_in(packages, written),
        remaps_description=options.target not in since("jazzy"),
        moveit=frozenset(packages_of_moveit(packages)),
        spawned=packages.found(spawned_names),
        files_of=lambda node: _files_of(packages, node),
        is_expanded=lambda written: _is_expanded(packages, written),
        descriptions=packages.found(description_names),
        elsewhere=packages.found(described_elsewhere),
        doubled=packages.found(doubled_names),
        has_controllers=bool(controllers),
        commands=lambda package, program: (package, program) in packages.found(commanding_programs),
        may_be_real=packages.found(may_be_real),
    )


def own_packages(packages: MigratedPackages) -> Iterator[str]:
    """Yield the names of the packages that are migrated."""
    for path in packages.files("package.xml"):
        name = package_name(path)
        if name:
            yield name


def _controller_files(packages: MigratedPackages) -> set[str]:
    """The names of the controller files, before or after their own migration."""
    texts = ((path, packages.read(path).data) for path in packages.files(".yaml", ".yml"))
    return {os.path.basename(path) for path, text in texts if b"controller_manager" in text or _TYPE.search(text)}


def _controllers_in(packages: MigratedPackages, written: str) -> list[str]:
    """The controllers of a file of the packages, after its own migration."""
    paths = addressed_files(packages, written) if is_yaml(written) else set()
    return [one.controller for one in packages.found(type_names) if one.path in paths] if paths else []


def _is_expanded(packages: MigratedPackages, written: str) -> bool:
    """Whether a robot's file gets the plugin for ros2_control, which names a controller file by `$(find)`."""
    paths = addressed_files(packages, written) if written.endswith((".urdf", ".xacro")) else set()
    return any(re.search(rb"gazebo_ros_control|ros2_control-system", packages.read(path).data) for path in paths)


def _files_of(packages: MigratedPackages, node: str) -> list[str]:
    """The addresses of the controller files that have a section for a node."""
    known = packages.found(sections)
    paths = dict.fromkeys(one.path for one in known if one.node == node and not one.type)
    chosen = [path for path in paths if any(one.type for one in known if one.path == path)]
    addresses = (installed_path(packages, path) for path in chosen)
    return [f"$(find {package})/{'/'.join(parts)}" for package, parts in addresses]


LAUNCH_FILES = Step(
    name="roslaunch",
    part=Part.LAUNCH,
    summary="Launch files",
    propose=_launch_files,
    generation=1,
    is_needed=True,
    rows=(
        Row(
            '<param name="robot_description" command="xacro ...">', "parameter of robot_state_publisher", "", _AUTHORITY
        ),
        Row(
            "<rosparam> of a controller file",
            "the simulator's plugin, ros2_control_node or --param-file",
            "",
            _AUTHORITY,
        ),
        Row(
            "controller_manager spawner --stopped --timeout T",
            "spawner --inactive --controller-manager-timeout T",
            "",
            _AUTHORITY,
        ),
        Row(
            "gazebo_ros spawn_model -urdf -param -model M",
            "ros_gz_sim create -topic -name M, or spawn_entity.py",
            "",
            _AUTHORITY,
        ),
        Row(
            "gazebo_ros empty_world.launch",
            "ros_gz_sim gz_sim.launch.py, or gazebo_ros gazebo.launch.py",
            "",
            _AUTHORITY,
        ),
        Row("tf static_transform_publisher", "tf2_ros static_transform_publisher --x ...", "", _AUTHORITY),
        Row("rviz", "rviz2", "", _AUTHORITY),
    ),
    before=[
        {
            "launch/arm.launch": """
                <launch>
                  <param name="robot_description" command="$(find xacro)/xacro $(find arm)/robot.urdf"/>
                  <node pkg="robot_state_publisher" type="robot_state_publisher" name="robot_state_publisher"/>
                </launch>
            """,
        },
        {
            "options": "--from=noetic --to=jazzy --launch=xml",
            "launch/arm.launch": """
                <launch>
                  <param name="robot_description" command="$(find xacro)/xacro $(find arm)/robot.urdf"/>
                  <node pkg="robot_state_publisher" type="robot_state_publisher" name="robot_state_publisher"/>
                </launch>
            """,
        },
    ],
    after=[
        {
            "launch/arm.launch": "",
            "launch/arm.launch.py": '''
                """Migrated from arm.launch."""

                from launch import LaunchDescription
                from launch.substitutions import Command
                from launch_ros.actions import Node
                from launch_ros.parameter_descriptions import ParameterValue
                from launch_ros.substitutions import FindPackageShare


                def generate_launch_description():
                    """Return the actions, in order."""
                    return LaunchDescription(
                        [
                            Node(
                                package="robot_state_publisher",
                                executable="robot_state_publisher",
                                name="robot_state_publisher",
                                parameters=[
                                    {"robot_description": ParameterValue(Command(["xacro ", FindPackageShare("arm"), "/robot.urdf"], on_stderr="warn"), value_type=str)},
                                ],
                            ),
                        ]
                    )
            ''',
        },
        {
            "launch/arm.launch": "",
            "launch/arm.launch.xml": """
                <?xml version="1.0"?>
                <!-- Migrated from arm.launch. -->
                <launch>
                  <node pkg="robot_state_publisher" exec="robot_state_publisher" name="robot_state_publisher">
                    <param name="robot_description" value="$(command 'xacro $(find-pkg-share arm)/robot.urdf' 'warn')" type="str"/>
                  </node>
                </launch>
            """,
        },
    ],
)
