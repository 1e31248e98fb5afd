"""Launch files that look for packages of Gazebo Classic, which end because the target does not have these."""

from __future__ import annotations

import ast
import os
import re
from collections.abc import Iterator

from urdfctl.catalog.distros import since
from urdfctl.diagnostic import Edit
from urdfctl.migrate.edits.markup import attribute, elements, root_of
from urdfctl.migrate.edits.python_edits import PythonFile, called, text_of
from urdfctl.migrate.options import Part
from urdfctl.migrate.packages import MigratedPackages
from urdfctl.migrate.shared.hardware import goes_to_gz
from urdfctl.migrate.step import EntryKind, Proposal, ReportEntry, Row, Step
from urdfctl.migrate.todo import for_you
from urdfctl.model.launch.ros1 import is_of_ros2
from urdfctl.source.span import SourceSpan
from urdfctl.source.workspaces.packages import package_name

_GONE = frozenset("gazebo_ros gazebo_plugins gazebo_ros2_control gazebo_ros_pkgs gazebo_msgs gazebo_dev".split())
_PATHS = ("join", "PathJoinSubstitution", "PythonLaunchDescriptionSource", "AnyLaunchDescriptionSource", "Path", "str")
_LOOKUPS = ("get_package_share_directory", "get_package_share_path", "get_package_prefix", "FindPackageShare")
_AUTHORITY = (
    "rosdistro#41224: not in jazzy; ament_index_python get_package_share_directory() raises PackageNotFoundError"
)
_WORLDS = "gz-sim Server: 'Unable to find or download file'; gazebo worlds/: cafe.world, willowgarage.world and others"
_BRIDGED = "ros_gz_bridge README: config_file"
_SPAWNED, _OF_DESCRIPTIONS = b"spawn_entity.py", re.compile("description|urdf")
_XML = re.compile(r"\$\(find-pkg-(?:share|prefix)\s+(\w+)\s*\)")


def _gone_packages(packages: MigratedPackages) -> Iterator[Proposal]:
    if packages.options.target not in since("jazzy"):
        return
    yield from _described_elsewhere(packages) if goes_to_gz(packages) else ()
    for path in packages.files(".py"):
        source = packages.read(path)
        if b"gazebo_" in source.data and b"generate_launch_description" in source.data and packages.may_change(path):
            yield from _in_python(packages, PythonFile(source))
        if b"gz_args" in source.data and goes_to_gz(packages) and packages.may_change(path):
            yield from _worlds(packages, PythonFile(source))
    for path in packages.files(".launch.xml", "_launch.xml", ".launch"):
        source = packages.read(path)
        root = root_of(source) if b"find-pkg-" in source.data and packages.may_change(path) else None
        for element in elements(root) if root is not None and is_of_ros2(root) else ():
            texts = " ".join(attribute(element, name) for name in element.attrs)
            for name in dict.fromkeys(_XML.findall(texts)):
                yield from [for_you(element.at, _left(packages, name), authority=_AUTHORITY)] if name in _GONE else []


def _described_elsewhere(packages: MigratedPackages) -> Iterator[Proposal]:
    """Tell the robots that launch files spawned in Gazebo Classic, and whose description is in a package that is not
    here: nothing of it was migrated, and none of its topics is bridged."""
    own = {package_name(path) for path in packages.files("package.xml")}
    robots = (one for one in packages.loaded() if one.project.robot is not None and one.project.robot.links)
    known = {os.path.realpath(path) for one in robots for path in one.sources}
    for path in packages.files(".py"):
        is_spawning = _SPAWNED in packages.scratch.original(path) and os.path.realpath(path) not in known
        source = packages.read(path)
        if not is_spawning or not packages.may_change(path):
            continue
        given = (call.args[0] for call, _ in PythonFile(source).calls(*_LOOKUPS) if call.args)
        others = dict.fromkeys(name for one in given if (name := text_of(one)) and name not in own)
        if names := [f"'{name}'" for name in others if _OF_DESCRIPTIONS.search(name)]:
            what = f"the robot is described in {' or '.join(names)}, not here: migrate that too, and bridge its topics"
            yield Proposal(entries=(ReportEntry(EntryKind.FOR_YOU, what, file=source.path, authority=_BRIDGED),))


def _worlds(packages: MigratedPackages, file: PythonFile) -> Iterator[Proposal]:
    """Leave the worlds that Gazebo Classic came with to a person: 'worlds/NAME.world' without a folder before it."""
    own = {os.path.basename(path) for path in packages.files(".world", ".sdf")}
    pairs = [
        pair
        for node in ast.walk(file.tree or ast.Module([], []))
        for pair in (zip(node.keys, node.values, strict=True) if isinstance(node, ast.Dict) else ())
    ]
    for key, value in pairs:
        parts = value.elts if isinstance(value, ast.List) else [value]
        if key is None or text_of(key) != "gz_args":
            continue
        for before, part in zip((None, *parts), parts, strict=False):
            words = text_of(part).split(" ") if isinstance(part, ast.Constant) else [""]
            begins = before is None or len(words) > 1 or "PythonExpression" in ast.dump(before)
            if begins and words[-1].startswith("worlds/") and os.path.basename(words[-1]) not in own:
                what = "gz has none of the worlds that Gazebo Classic came with, and ends: name the path of a world"
                yield for_you(file.at(part), what, authority=_WORLDS)


def _left(packages: MigratedPackages, name: str) -> str:
    return f"{packages.options.target} has no package '{name}', at which the launch file ends: name what replaces it"


def _in_python(packages: MigratedPackages, file: PythonFile) -> Iterator[Proposal]:
    """Remove what is looked up and not used; all else is left to a person."""
    for call, scope in file.calls(*_LOOKUPS):
        name = text_of(call.args[0]) if call.args else ""
        if name not in _GONE:
            continue
        unused = _unused(call, scope)
        if unused is None:
            yield for_you(file.at(call), _left(packages, name), authority=_AUTHORITY)
            continue
        what = f"the launch file no longer looks for package '{name}': nothing used its folder"
        entry = ReportEntry(EntryKind.DONE, what, file.at(unused), authority=_AUTHORITY)
        edits = [_line_of(file, unused), *_unused_import(file, called(call))]
        yield Proposal(tuple(edits), entries=(entry,))
        return


def _unused(call: ast.Call, scope: ast.AST) -> ast.Assign | None:
    """The assignment of a call, or of a path with it, to a name that nothing reads; None for any other form."""
    for statement in ast.walk(scope):
        if isinstance(statement, ast.Assign) and _is_path(statement.value, call) and len(statement.targets) == 1:
            target = statement.targets[0]
            block = next((each for each in _blocks(scope) if statement in each), [])
            if not isinstance(target, ast.Name) or len(block) == 1:
                return None
            loads = (node for node in ast.walk(scope) if isinstance(node, ast.Name) and node.id == target.id)
            return statement if all(isinstance(node.ctx, ast.Store) for node in loads) else None
    return None


def _is_path(value: ast.expr, call: ast.Call) -> bool:
    """Whether a value is a call, or a path that it begins."""
    calls = [node for node in ast.walk(value) if isinstance(node, ast.Call)]
    return call in calls and all(called(one) in (*_LOOKUPS, *_PATHS) for one in calls)


def _blocks(scope: ast.AST) -> Iterator[list[ast.stmt]]:
    for node in ast.walk(scope):
        for name in ("body", "orelse", "finalbody"):
            block = getattr(node, name, None)
            if isinstance(block, list):
                yield block


def _unused_import(file: PythonFile, name: str) -> Iterator[Edit]:
    """The edit that drops the import of a function whose only call goes, if the statement imports nothing else."""
    tree = file.tree or ast.Module([], [])
    uses = [node for node in ast.walk(tree) if isinstance(node, ast.Name) and node.id == name]
    for statement in tree.body:
        is_its = isinstance(statement, ast.ImportFrom) and [alias.name for alias in statement.names] == [name]
        if is_its and len(uses) == 1:
            yield _line_of(file, statement)


def _line_of(file: PythonFile, statement: ast.stmt) -> Edit:
    """The edit that removes a statement with its line."""
    span, data = file.span(statement), file.source.data
    start, end = data.rfind(b"\n", 0, span.start) + 1, data.find(b"\n", span.end) + 1
    is_alone = not data[start : span.start].strip() and not data[span.end : end].strip()
    return Edit(SourceSpan(file.source, start, end) if is_alone else span, "")


GONE_PACKAGES = Step(
    name="gone-packages",
    part=Part.LAUNCH,
    summary="Packages of Gazebo Classic that launch files look for",
    propose=_gone_packages,
    rows=(Row("get_package_share_directory('gazebo_ros') that nothing uses", "", "jazzy", _AUTHORITY),),
    before=[
        {
            "options": "--from=humble --to=jazzy --simulator=gz",
            "launch/arm.launch.py": """
                from ament_index_python.packages import get_package_share_directory
                from launch import LaunchDescription
                from launch_ros.actions import Node


                def generate_launch_description():
                    classic = get_package_share_directory("gazebo_ros")
                    return LaunchDescription([Node(package="arm", executable="arm")])
            """,
        },
    ],
    after=[
        {
            "launch/arm.launch.py": """
                from launch import LaunchDescription
                from launch_ros.actions import Node


                def generate_launch_description():
                    return LaunchDescription([Node(package="arm", executable="arm")])
            """,
        },
    ],
)
