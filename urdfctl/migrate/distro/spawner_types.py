"""Types that spawners give to their controllers, which belong into the parameters of the controller manager."""

from __future__ import annotations

from collections.abc import Iterator, Sequence

from urdfctl.catalog.distros import since
from urdfctl.catalog.moves import MANAGER
from urdfctl.diagnostic import Edit
from urdfctl.migrate.edits.python_edits import PythonFile, keyword, text_of
from urdfctl.migrate.edits.xml_edits import elements_of
from urdfctl.migrate.edits.yaml_edits import MapEdits
from urdfctl.migrate.options import Part
from urdfctl.migrate.packages import MigratedPackages
from urdfctl.migrate.shared.controller_files import FileSection, sections, type_names
from urdfctl.migrate.step import EntryKind, Proposal, ReportEntry, Row, Step
from urdfctl.migrate.todo import for_you
from urdfctl.source.span import Place, SourceSpan
from urdfctl.source.workspaces.packages import package_around

_OPTIONS = ("--controller-type", "-t")
_AUTHORITY = "ros2_control jazzy controller_manager/controller_manager/spawner.py: no option --controller-type"
_XML = (".launch.xml", "_launch.xml", ".launch")


def _spawner_types(packages: MigratedPackages) -> Iterator[Proposal]:
    if packages.options.target not in since("jazzy"):
        return
    for path in packages.files(".py"):
        source = packages.read(path)
        if b"controller_manager" in source.data and packages.may_change(path):
            yield from _in_python(packages, PythonFile(source))
    for path in packages.files(*_XML):
        source = packages.read(path)
        if b"controller_manager" in source.data and packages.may_change(path):
            yield from _in_xml(packages, path)


def _in_python(packages: MigratedPackages, file: PythonFile) -> Iterator[Proposal]:
    for call, _ in file.calls("Node"):
        named = {name: text_of(getattr(keyword(call, name), "value", None)) for name in ("package", "executable")}
        given = keyword(call, "arguments")
        is_spawner = named["package"] == MANAGER and named["executable"].startswith("spawner")
        items = given.value.elts if is_spawner and given and hasattr(given.value, "elts") else []
        words = [text_of(item) for item in items]
        index = next((number for number, word in enumerate(words) if _is_option(word)), None)
        if index is None:
            continue
        length = 1 if "=" in words[index] else 2
        kind = words[index].partition("=")[2] or next(iter(words[index + 1 : index + 2]), "")
        edits = tuple(file.without_all(items, items[index : index + length]))
        yield _moved(packages, file.at(items[index]), _names(words[:index] + words[index + length :]), kind, edits)


def _in_xml(packages: MigratedPackages, path: str) -> Iterator[Proposal]:
    for node in elements_of(packages.read(path)):
        is_spawner = node.attrs.get("pkg") == MANAGER and node.attrs.get("exec", "").startswith("spawner")
        words = node.attrs.get("args", "").split() if is_spawner else []
        index = next((number for number, word in enumerate(words) if _is_option(word)), None)
        if index is None:
            continue
        span = node.at["args"].span
        written = span.text.split()
        length = 1 if "=" in written[index] else 2
        kind = words[index].partition("=")[2] or next(iter(words[index + 1 : index + 2]), "")
        rest = written[:index] + written[index + length :]
        edit = Edit(SourceSpan(span.source, span.start, span.end), " ".join(rest))
        yield _moved(packages, node.at, _names(words[:index] + words[index + length :]), kind, (edit,))


def _is_option(word: str) -> bool:
    return word.partition("=")[0] in _OPTIONS


def _names(words: Sequence[str]) -> list[str]:
    """The controllers that a spawner starts; an empty text for one that is not known."""
    names: list[str] = []
    is_value = False
    for word in words:
        if is_value:
            is_value = False
        elif word.startswith("-"):
            is_value = word in ("-c", "--controller-manager", "-p", "--param-file", "-n", "--namespace")
        else:
            names.append(word)
    return names


def _moved(packages: MigratedPackages, at: Place, names: Sequence[str], kind: str, edits: tuple[Edit, ...]) -> Proposal:
    """The proposal to drop the option of a spawner, and to write the type that it named into a parameter file."""
    known = {one.controller for one in packages.found(type_names)}
    missing = [name for name in names if name not in known]
    manager = _manager(packages, at.source.path, missing)
    if "/" not in kind or "" in names or not names or (missing and manager is None):
        return for_you(
            at,
            "give the controllers their type in the parameters of the controller manager: the spawner "
            "has no option --controller-type",
            authority=_AUTHORITY,
        )
    done = f"the type of {' and '.join(names)} is a parameter of the controller manager, not an option of the spawner"
    entries = (ReportEntry(EntryKind.DONE, done, at, authority=_AUTHORITY),)
    if manager is None or not missing:
        return Proposal(edits, entries=entries)
    changes = MapEdits(packages.read(manager.path))
    is_flow = manager.parameters.source.data[manager.parameters.start : manager.parameters.start + 1] == b"{"
    for name in missing:
        changes.insert(manager.parameters, f"{name}: {{type: {kind}}}" if is_flow else _block(manager, name, kind))
    return Proposal((*edits, *changes.edits()), entries=entries)


def _block(manager: FileSection, name: str, kind: str) -> str:
    first = manager.parameters.entries[0].key
    data = first.source.data
    indent = " " * (first.start - data.rfind(b"\n", 0, first.start) - 1)
    return f"{name}:\n{indent}  type: {kind}"


def _manager(packages: MigratedPackages, path: str, names: Sequence[str]) -> FileSection | None:
    """The section of the controller manager in the file that has the controllers' parameters, or the only one of the
    package, or of all."""
    found = packages.found(sections)
    own = {one.path for one in found if one.node in names}
    managers = [
        one for one in found if one.type == MANAGER and one.parameters.entries and packages.may_change(one.path)
    ]
    beside = [one for one in managers if package_around(one.path) == package_around(path)]
    choices = ([one for one in managers if one.path in own], beside, managers)
    return next((each[0] for each in choices if len(each) == 1), None)


SPAWNER_TYPES = Step(
    name="spawner-types",
    part=Part.LAUNCH,
    summary="Types of controllers in spawners' arguments",
    propose=_spawner_types,
    rows=(Row("spawner NAME --controller-type TYPE", "controller_manager: NAME: type: TYPE", "jazzy", _AUTHORITY),),
    before=[
        {
            "options": "--from=humble --to=jazzy",
            "config/controllers.yaml": """
                controller_manager:
                  ros__parameters:
                    update_rate: 100
            """,
            "launch/arm.launch.py": """
                from launch import LaunchDescription
                from launch_ros.actions import Node


                def generate_launch_description():
                    spawner = Node(
                        package="controller_manager",
                        executable="spawner",
                        arguments=["state", "-t", "joint_state_broadcaster/JointStateBroadcaster", "--inactive"],
                    )
                    return LaunchDescription([spawner])
            """,
        },
        {
            "options": "--from=humble --to=jazzy",
            "config/controllers.yaml": """
                controller_manager:
                  ros__parameters: {update_rate: 100}
            """,
            "launch/arm.launch.xml": """
                <launch>
                  <node pkg="controller_manager" exec="spawner" args="a --controller-type=imu_sensor_broadcaster/IMUSensorBroadcaster"/>
                </launch>
            """,
        },
    ],
    after=[
        {
            "config/controllers.yaml": """
                controller_manager:
                  ros__parameters:
                    update_rate: 100
                    state:
                      type: joint_state_broadcaster/JointStateBroadcaster
            """,
            "launch/arm.launch.py": """
                from launch import LaunchDescription
                from launch_ros.actions import Node


                def generate_launch_description():
                    spawner = Node(
                        package="controller_manager",
                        executable="spawner",
                        arguments=["state", "--inactive"],
                    )
                    return LaunchDescription([spawner])
            """,
        },
        {
            "config/controllers.yaml": """
                controller_manager:
                  ros__parameters: {update_rate: 100, a: {type: imu_sensor_broadcaster/IMUSensorBroadcaster}}
            """,
            "launch/arm.launch.xml": """
                <launch>
                  <node pkg="controller_manager" exec="spawner" args="a"/>
                </launch>
            """,
        },
    ],
)
