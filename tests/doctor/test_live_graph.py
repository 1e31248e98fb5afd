"""`urdfctl graph --live`: what is wired in a recording, with the differences to the files."""

from __future__ import annotations

import json
from collections.abc import Callable

import jsonschema
import pytest
from folder import Folder
from graph_schema import SCHEMA

from urdfctl.rules.running.samples import FILES, Recorded, controllers_in, manager_in, silent_manager, sound


def differences(folder: Folder, change: Callable[[Recorded], object]) -> dict[str, list[str]]:
    recording = sound()
    change(recording)
    folder.write({**FILES, "snapshot.json": json.dumps(recording)})
    ran = folder.run("graph", "launch/arm.launch.xml", "--live", "snapshot.json", "--format", "json")
    assert ran.returncode == 0, ran.stderr
    graph = json.loads(ran.stdout)
    jsonschema.validate(graph, SCHEMA)
    nodes = {node["id"]: node["rules"] for node in graph["nodes"] if node["rules"]}
    return nodes | {f"{edge['source']} -> {edge['target']}": edge["rules"] for edge in graph["edges"] if edge["rules"]}


def test_what_is_wired_as_in_the_files_has_no_difference(folder: Folder) -> None:
    assert differences(folder, lambda _: None) == {}


def inactive(recording: Recorded) -> None:
    controllers_in(recording)[1].update(state="inactive", claimed_interfaces=[])


def unloaded(recording: Recorded) -> None:
    del controllers_in(recording)[1]


def another_type(recording: Recorded) -> None:
    controllers_in(recording)[1]["type"] = "position_controllers/JointGroupPositionController"


def stranger(recording: Recorded) -> None:
    listed = controllers_in(recording)
    listed.append({**listed[1], "name": "old", "claimed_interfaces": [], "required_command_interfaces": []})


def idle(recording: Recorded) -> None:
    manager_in(recording)["list_hardware_components"]["component"][0]["state"]["label"] = "inactive"


def mock(recording: Recorded) -> None:
    manager_in(recording)["list_hardware_components"]["component"][0]["plugin_name"] = "mock_components/GenericSystem"


def fewer_joints(recording: Recorded) -> None:
    controllers_in(recording)[1].update(required_command_interfaces=["pan/position"])


def another_interface(recording: Recorded) -> None:
    commands = ["pan/position", "tilt/velocity"]
    controllers_in(recording)[1].update(required_command_interfaces=commands, claimed_interfaces=[])


HEAD = "controller:/head"
CLAIM = f"{HEAD} -> command:tilt/position"
CHANGES: list[tuple[Callable[[Recorded], object], dict[str, list[str]]]] = [
    (inactive, {HEAD: ["UC832"]}),
    (unloaded, {HEAD: ["UC830"]}),
    (another_type, {HEAD: ["UC835"]}),
    (stranger, {"broadcaster:old": ["UC833"]}),
    (idle, {"hardware:Arm": ["UC820"]}),
    (mock, {"hardware:Arm": ["UC811"]}),
    (fewer_joints, {CLAIM: ["UC834"]}),
    (another_interface, {CLAIM: ["UC834"], "command:tilt/velocity": ["UC810"]}),
    (silent_manager, {HEAD: ["UC830"], "broadcaster:/joint_state_broadcaster": ["UC830"]}),
]


@pytest.mark.parametrize(("change", "expected"), CHANGES, ids=[change.__name__ for change, _ in CHANGES])
def test_a_difference_to_the_files_is_red(
    folder: Folder, change: Callable[[Recorded], object], expected: dict[str, list[str]]
) -> None:
    assert differences(folder, change) == expected


def test_a_drawing_of_a_recording_has_the_difference_in_red(folder: Folder) -> None:
    recording = sound()
    inactive(recording)
    folder.write({**FILES, "snapshot.json": json.dumps(recording)})
    drawn = folder.run("graph", "launch/arm.launch.xml", "--live", "snapshot.json").stdout
    assert "UC832" in drawn
    assert "classDef broken stroke:#c22a2f" in drawn
