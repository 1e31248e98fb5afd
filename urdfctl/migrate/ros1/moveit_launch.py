"""Launch files of a package of MoveIt's Setup Assistant, written anew as the assistant writes them for MoveIt 2."""

from __future__ import annotations

import os
from collections.abc import Iterator, Mapping

from urdfctl.diagnostic import Edit
from urdfctl.migrate.markup import root_of
from urdfctl.migrate.packages import Packages
from urdfctl.migrate.step import Entry, EntryKind, Proposal, Row, Step
from urdfctl.migrate.wishes import Part
from urdfctl.source.packages import package_name
from urdfctl.source.span import SourceSpan

_AUTHORITY = "moveit2 moveit_configs_utils launches.py; moveit.picknik.ai, MoveIt Setup Assistant"
_MARK = ".setup_assistant"
_MADE: Mapping[str, tuple[str, str]] = {
    "move_group.launch": ("move_group", "generate_move_group_launch"),
    "moveit_rviz.launch": ("moveit_rviz", "generate_moveit_rviz_launch"),
    "planning_context.launch": ("rsp", "generate_rsp_launch"),
    "setup_assistant.launch": ("setup_assistant", "generate_setup_assistant_launch"),
    "warehouse.launch": ("warehouse_db", "generate_warehouse_db_launch"),
}
"""By launch file of ROS 1: the one of ROS 2 without its ending, and the function that makes it."""
MADE_BY_MOVEIT: Mapping[str, str] = {
    **{old: new for old, (new, _) in _MADE.items()},
    "default_warehouse_db.launch": "warehouse_db",
}
"""By launch file of ROS 1: the one of ROS 2 that other launch files include, without its ending."""
LOADED_BY_MOVEIT = (
    "planning_pipeline.launch.xml",
    "controller_manager.launch.xml",
    "sensor_manager.launch.xml",
    "trajectory_execution.launch.xml",
    "warehouse_settings.launch.xml",
    "default_warehouse_db.launch",
)
"""Launch files of ROS 1 that only load parameters, which MoveItConfigsBuilder reads from the files of the package."""


def _launch_files(packages: Packages) -> Iterator[Proposal]:
    for mark in packages.files(_MARK):
        folder = os.path.dirname(mark)
        robot, name = _robot(packages, folder), package_name(os.path.join(folder, "package.xml"))
        launches = os.path.join(folder, "launch") + os.sep
        old = {
            os.path.basename(path): path
            for path in packages.files(".launch", ".launch.xml")
            if path.startswith(launches)
        }
        if not robot or not name or not old:
            continue
        made = dict(_made(launches, old))
        created = tuple((path, _text(robot, name, maker)) for path, maker in made.items())
        deleted = tuple(path for file, path in old.items() if file in _MADE or file.endswith(LOADED_BY_MOVEIT))
        if deleted:
            what = "moveit_configs_utils makes the launch files of MoveIt, and loads the parameters of the others"
            entry = Entry(EntryKind.DONE, what, file=os.path.join(folder, "package.xml"), authority=_AUTHORITY)
            yield Proposal(_install(packages, folder), created, deleted, (entry,))


def _made(launches: str, old: Mapping[str, str]) -> Iterator[tuple[str, str]]:
    for file, (new, maker) in _MADE.items():
        path = f"{launches}{new}.launch.py"
        if file in old and not os.path.exists(path):
            yield path, maker


def _robot(packages: Packages, folder: str) -> str:
    """The name of the robot in the package's only semantic description; empty if there is none, or several."""
    found = [path for path in packages.files(".srdf") if path.startswith(os.path.join(folder, "config") + os.sep)]
    root = root_of(packages.read(found[0])) if len(found) == 1 else None
    return root.attrs.get("name", "") if root is not None else ""


def _text(robot: str, package: str, maker: str) -> str:
    return f'''\
from moveit_configs_utils import MoveItConfigsBuilder
from moveit_configs_utils.launches import {maker}


def generate_launch_description():
    moveit_config = MoveItConfigsBuilder("{robot}", package_name="{package}").to_moveit_configs()
    return {maker}(moveit_config)
'''


def _install(packages: Packages, folder: str) -> tuple[Edit, ...]:
    """The edit that installs the file with the address of the description, which the builder reads."""
    source = packages.read(os.path.join(folder, "CMakeLists.txt"))
    if not source.data or _MARK.encode() in source.data:
        return ()
    end = len(source.data)
    rule = f"install(FILES {_MARK} DESTINATION ${{CATKIN_PACKAGE_SHARE_DESTINATION}})\n"
    return (Edit(SourceSpan(source, end, end), f"\n{rule}"),)


def packages_of_moveit(packages: Packages) -> Iterator[str]:
    """Yield the names of the packages whose launch files were written anew."""
    for mark in packages.files(_MARK):
        folder = os.path.dirname(mark)
        if os.path.exists(os.path.join(folder, "launch", "move_group.launch.py")):
            yield package_name(os.path.join(folder, "package.xml")) or ""


MOVEIT_LAUNCH = Step(
    name="moveit-launch-files",
    part=Part.MOVEIT,
    summary="Launch files of MoveIt",
    propose=_launch_files,
    generation=1,
    rows=tuple(Row(old, f"{new}.launch.py by {maker}()", "", _AUTHORITY) for old, (new, maker) in _MADE.items()),
)
