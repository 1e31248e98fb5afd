"""Spawners that wait for an event: found by UC628 only if it never comes."""

from __future__ import annotations

import pytest
from folder import Folder
from launched_packages import found

from urdfctl.rules.launch_samples import launched

LAUNCH = """
from ament_index_python.packages import get_package_share_directory
from launch import LaunchDescription
from launch.actions import ExecuteProcess, OpaqueFunction, RegisterEventHandler
from launch.conditions import IfCondition
from launch.event_handlers import OnProcessExit, OnProcessStart, OnShutdown
from launch_ros.actions import Node

def later(context):
    return [home]

def generate_launch_description():
    share = get_package_share_directory("arm")
    states = Node(package="controller_manager", executable="spawner", arguments=["joint_state_broadcaster"])
    home = ExecuteProcess(cmd=["arm_home"])
    other = Node(package="arm", executable="other"{keyword})
    ld = LaunchDescription([
        Node(package="controller_manager", executable="ros2_control_node", parameters=[share + "/controllers.yaml"]),
        RegisterEventHandler({event}(target_action=home, {on}=[states])),
        other{entry}])
    {added}
    return ld
"""
WAITS = ("UC628", "error", "the spawner of 'joint_state_broadcaster' waits for a process, which nothing starts")


@pytest.mark.parametrize("event", [("OnProcessExit", "on_exit"), ("OnProcessStart", "on_start")])
@pytest.mark.parametrize(
    ("part", "is_found"),
    [
        ({}, True),
        ({"entry": ", home"}, False),
        ({"added": "ld.add_action(home)"}, False),
        ({"keyword": ", on_exit=[home]"}, False),
        ({"entry": ", RegisterEventHandler(OnShutdown(on_shutdown=[home]))"}, False),
        ({"entry": ", RegisterEventHandler(OnShutdown(on_shutdown=later))"}, False),
        ({"entry": ", RegisterEventHandler(OnProcessExit(target_action=other, on_exit=[home]))"}, False),
        ({"entry": ", OpaqueFunction(function=unknown)"}, False),
    ],
    ids=["nowhere", "listed", "added", "keyword", "rare event", "callback", "other handler", "unknown"],
)
def test_a_spawner_waits_in_vain_for_what_nothing_starts(
    part: dict[str, str], event: tuple[str, str], is_found: bool, folder: Folder
) -> None:
    places = {"keyword": "", "entry": "", "added": "", **part}
    files = {name: text for name, text in launched().items() if name != "arm.launch.xml"}
    launch = LAUNCH.format(event=event[0], on=event[1], **places)
    told = found(folder, {"arm.launch.py": launch, **files}, "UC628", distro="jazzy")
    assert [(*one[:2], one[2].partition(";")[0]) for one in told] == ([WAITS] if is_found else [])


def test_a_program_that_never_starts_is_no_second_controller_manager(folder: Folder) -> None:
    manager = 'Node(package="controller_manager", executable="ros2_control_node", namespace="b")'
    entry = f", RegisterEventHandler(OnProcessExit(target_action=home, on_exit=[{manager}, {manager}]))"
    launch = LAUNCH.format(event="OnProcessStart", on="on_start", keyword="", entry=entry, added="")
    files = {name: text for name, text in launched().items() if name != "arm.launch.xml"}
    waiting = found(folder, {"arm.launch.py": launch, **files}, "UC607", distro="jazzy")
    started = launch.replace(", RegisterEventHandler(OnProcessExit(", ", home, RegisterEventHandler(OnProcessExit(")
    assert (waiting, [one[1] for one in found(folder, {"arm.launch.py": started, **files}, "UC607")]) == ([], ["error"])
