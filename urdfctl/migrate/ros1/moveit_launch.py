"""Launch files of a package of MoveIt's Setup Assistant, written anew as the assistant writes them for MoveIt 2."""

from __future__ import annotations

import os
from collections.abc import Iterator, Mapping

from urdfctl.diagnostic import Edit
from urdfctl.migrate.launch.actions import Text, plain
from urdfctl.migrate.options import Part
from urdfctl.migrate.packages import MigratedPackages
from urdfctl.migrate.ros1.moveit_package import MARK, MOVE_GROUP, MoveitPackage, moveit_packages
from urdfctl.migrate.step import EntryKind, Proposal, ReportEntry, Row, Step
from urdfctl.source.disk.gate import exists
from urdfctl.source.span import SourceSpan
from urdfctl.source.todo import MARK as TODO
from urdfctl.source.workspaces.packages import package_name

_AUTHORITY = "moveit2 moveit_configs_utils launches.py; moveit.picknik.ai, MoveIt Setup Assistant"
_NO_DESCRIPTION = "add .robot_description(file_path=...) with the robot's description"
_FAKE = "fake_moveit_controller_manager.launch.xml"
_WITHOUT_FAKE = (
    "MoveIt 2 has no fake controllers, which moved the robot of demo.launch: start ros2_control_node there with "
    "mock_components/GenericSystem, and spawn the controllers of moveit_controllers.yaml"
)
_EXECUTED = "moveit2 moveit_plugins: no fake controllers; moveit_configs_utils launches.py: generate_demo_launch"
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
PUBLISHER_FILE = "rsp.launch.py"
"""The launch file that MoveIt makes for robot_state_publisher, with the description."""
LOADED_BY_MOVEIT = (
    "planning_pipeline.launch.xml",
    "controller_manager.launch.xml",
    "sensor_manager.launch.xml",
    "trajectory_execution.launch.xml",
    "warehouse_settings.launch.xml",
    "default_warehouse_db.launch",
)
"""Launch files of ROS 1 that only load parameters, which MoveItConfigsBuilder reads from the files of the package."""


def is_loaded_by_moveit(made: str, given: Mapping[str, Text], defaults: Mapping[str, str | None]) -> bool:
    """Return whether a launch file of MoveIt only loaded parameters where another one includes it.

    made: its old path, or that of the one that takes its place.
    given: the arguments of the include.
    defaults: of the arguments of the file.
    """
    value = given.get("load_robot_description")
    loads = plain(value) if value is not None else defaults.get("load_robot_description")
    return made.endswith(LOADED_BY_MOVEIT) or (made.endswith(f"/{PUBLISHER_FILE}") and loads == "false")


def _launch_files(packages: MigratedPackages) -> Iterator[Proposal]:
    for package in moveit_packages(packages):
        launches = os.path.join(package.folder, "launch") + os.sep
        old = {
            os.path.basename(path): path
            for path in packages.files(".launch", ".launch.xml")
            if os.path.dirname(path) + os.sep == launches
        }
        if not package.robot or not old:
            continue
        made = dict(_made(launches, old))
        created = tuple((path, _text(package, maker)) for path, maker in made.items())
        deleted = tuple(path for file, path in old.items() if file in _MADE or file.endswith(LOADED_BY_MOVEIT))
        if deleted:
            what = "moveit_configs_utils makes the launch files of MoveIt, and loads the parameters of the others"
            manifest = os.path.join(package.folder, "package.xml")
            entries = [ReportEntry(EntryKind.DONE, what, file=manifest, authority=_AUTHORITY)]
            if _FAKE in old:
                entries.append(ReportEntry(EntryKind.FOR_YOU, _WITHOUT_FAKE, file=manifest, authority=_EXECUTED))
            if package.needs_description:
                entries += [ReportEntry(EntryKind.FOR_YOU, _NO_DESCRIPTION, file=path) for path in made]
            yield Proposal(_install(packages, package.folder), created, deleted, tuple(entries))


def _made(launches: str, old: Mapping[str, str]) -> Iterator[tuple[str, str]]:
    for file, (new, maker) in _MADE.items():
        path = f"{launches}{new}.launch.py"
        if file in old and not exists(path):
            yield path, maker


def _text(package: MoveitPackage, maker: str) -> str:
    builder = f'MoveItConfigsBuilder("{package.robot}", package_name="{package.name}")'
    uses_shares = any("get_package_share_directory(" in call for call in package.calls)
    head = ["from ament_index_python.packages import get_package_share_directory"] if uses_shares else []
    head.append("from moveit_configs_utils import MoveItConfigsBuilder")
    head += [f"from moveit_configs_utils.launches import {maker}", "", "", "def generate_launch_description():"]
    todo = [f"# {TODO} {_NO_DESCRIPTION}"] if package.needs_description else []
    calls = (f"    {line}" for line in (builder, *(f".{call}" for call in package.calls), ".to_moveit_configs()"))
    body = [*todo, "moveit_config = (", *calls, ")", f"return {maker}(moveit_config)"]
    return "\n".join([*head, *(f"    {line}" for line in body)]) + "\n"


def _install(packages: MigratedPackages, folder: str) -> tuple[Edit, ...]:
    """The edit that installs the file with the address of the description, which the builder reads."""
    source = packages.read(os.path.join(folder, "CMakeLists.txt"))
    is_found = exists(os.path.join(folder, MARK)) and MARK.encode() not in source.data
    if not source.data or not is_found:
        return ()
    end = len(source.data)
    rule = f"install(FILES {MARK} DESTINATION ${{CATKIN_PACKAGE_SHARE_DESTINATION}})\n"
    return (Edit(SourceSpan(source, end, end), f"\n{rule}"),)


def packages_of_moveit(packages: MigratedPackages) -> Iterator[str]:
    """Yield the names of the packages whose launch files were written anew."""
    for path in packages.files(f"{MOVE_GROUP}.py"):
        folder = os.path.dirname(os.path.dirname(path))
        if b"MoveItConfigsBuilder" in packages.read(path).data:
            yield package_name(os.path.join(folder, "package.xml")) or ""


MOVEIT_LAUNCH = Step(
    name="moveit-launch-files",
    part=Part.MOVEIT,
    summary="Launch files of MoveIt",
    propose=_launch_files,
    generation=1,
    is_needed=True,
    rows=tuple(Row(old, f"{new}.launch.py by {maker}()", "", _AUTHORITY) for old, (new, maker) in _MADE.items()),
    before=[
        {
            ".setup_assistant": """
                moveit_setup_assistant_config:
                  SRDF:
                    relative_path: config/arm.srdf
            """,
            "config/arm.srdf": '<robot name="arm"/>',
            "launch/move_group.launch": """
                <launch>
                  <node name="move_group" pkg="moveit_ros_move_group" type="move_group"/>
                </launch>
            """,
        },
    ],
    after=[
        {
            "launch/move_group.launch": "",
            "launch/move_group.launch.py": """
                from moveit_configs_utils import MoveItConfigsBuilder
                from moveit_configs_utils.launches import generate_move_group_launch


                def generate_launch_description():
                    moveit_config = (
                        MoveItConfigsBuilder("arm", package_name="arm")
                        .planning_pipelines(pipelines=["ompl"])
                        .to_moveit_configs()
                    )
                    return generate_move_group_launch(moveit_config)
            """,
        },
    ],
)
