"""What the doctor compares: each change of a sound recording with what is told, and its twin in which nothing is."""

from __future__ import annotations

import json
from collections.abc import Callable
from typing import Any

import pytest
from folder import Folder

from urdfctl.rules.running.samples import FILES, Recorded, controllers_in, end, manager_in, sound, topic

LOG = """[ros2_control_node-2] [ERROR] [1.0] [head]: Length of parameter 'joints' is '0' but must be greater than '0'
[ros2_control_node-2] [ERROR] [1.1] [controller_manager]: Could not initialize the controller named 'head'
"""


def findings(folder: Folder, change: Callable[[Recorded], object], files: dict[str, str], *words: str) -> list[Any]:
    recording = sound()
    change(recording)
    folder.write({**FILES, **files, "snapshot.json": json.dumps(recording)})
    found: list[Any] = json.loads(folder.run("doctor", "snapshot.json", "--format", "json", *words).stdout)["findings"]
    return found


def own_rate(recording: Recorded) -> None:
    recording["joint_states"]["/joint_states"]["rate_hz"] = 20.0
    recording["parameters"]["/joint_state_broadcaster"]["values"]["update_rate"] = 20


def other_joints(recording: Recorded) -> None:
    recording["topics"][0]["publishers"].append(end("/casters", "sensor_msgs/msg/JointState"))
    recording["joint_states"]["/joint_states"]["name_lists"].append(["caster"])
    recording["joint_states"]["/joint_states"]["publishers"] = {"writer_1": 100, "writer_2": 100}


def same_static_parent(recording: Recorded) -> None:
    recording["tf"]["/tf_static"] = [{"parent": "base", "child": "pan_link", "count": 1, "publishers": {"a": 1}}]


def late_spawner(recording: Recorded) -> None:
    recording["nodes"].append({"name": "spawner_head", "namespace": "/"})


def idle_hardware(recording: Recorded) -> None:
    manager_in(recording)["list_hardware_components"]["component"][0]["state"]["label"] = "inactive"


MEANT = {
    "controllers.yaml": FILES["controllers.yaml"].replace(
        "update_rate: 100\n",
        "update_rate: 100\n    hardware_components_initial_state: {inactive: [Arm]}\n",
    )
}
SOUND: list[tuple[Callable[[Recorded], object], dict[str, str]]] = [
    (own_rate, {}),
    (other_joints, {}),
    (same_static_parent, {}),
    (late_spawner, {}),
    (idle_hardware, MEANT),
]


@pytest.mark.parametrize(("change", "files"), SOUND, ids=[change.__name__ for change, _ in SOUND])
def test_what_is_meant_so_is_no_fault(
    folder: Folder, change: Callable[[Recorded], object], files: dict[str, str]
) -> None:
    assert findings(folder, change, files) == []


def chained(recording: Recorded) -> None:
    broadcaster, head = controllers_in(recording)
    head.update(state="inactive", claimed_interfaces=[], required_command_interfaces=["zpid/position"])
    pid = {**broadcaster, "name": "zpid", "state": "inactive", "type": "pid_controller/PidController"}
    controllers_in(recording).append({**pid, "required_command_interfaces": ["pan/effort"]})


def test_the_end_of_a_chain_is_told_before_what_commands_it(folder: Folder) -> None:
    launch = FILES["launch/arm.launch.xml"].replace("joint_state_broadcaster head", "joint_state_broadcaster head zpid")
    declared = "    head: {"
    yaml = FILES["controllers.yaml"].replace(declared, "    zpid: {type: pid_controller/PidController}\n" + declared)
    first, second = findings(folder, chained, {"launch/arm.launch.xml": launch, "controllers.yaml": yaml})
    assert "'zpid' is inactive, not active: no hardware exports 'pan/effort'" in first["message"]
    assert "it commands 'zpid', which is not active" in second["message"]


def unloaded(recording: Recorded) -> None:
    del recording["parameters"]["/controller_manager"]["values"]["head.type"]
    del controllers_in(recording)[1]


def test_the_log_says_why_a_controller_is_not_loaded(folder: Folder) -> None:
    [found] = findings(folder, unloaded, {"run.log": LOG}, "--log", "run.log")
    assert found["message"].endswith(
        "line 1 of the log: Length of parameter 'joints' is '0' but must be greater than '0'"
    )


def test_a_manager_that_got_no_parameters_is_told(folder: Folder) -> None:
    [found] = findings(folder, unloaded, {})
    assert "the manager has no parameter 'head.type': it got other files" in found["message"]


def slow_manager(recording: Recorded) -> None:
    recording["parameters"]["/controller_manager"]["values"]["update_rate"] = 80


def test_a_parameter_of_the_manager_is_compared(folder: Folder) -> None:
    [found] = findings(folder, slow_manager, {})
    assert "/controller_manager runs with update_rate = 80, the files say 100" in found["message"]


def plain_twist(recording: Recorded) -> None:
    drive = topic("/head/reference", [], [end("/head", "geometry_msgs/msg/TwistStamped")])
    recording["topics"] += [drive, topic("/cmd/reference", [end("/teleop", "geometry_msgs/msg/Twist")], [])]


def test_a_twist_on_another_topic_is_told_with_both_types(folder: Folder) -> None:
    [found] = findings(folder, plain_twist, {})
    assert found["message"].endswith(
        "/head/reference (as geometry_msgs/msg/TwistStamped, not geometry_msgs/msg/Twist) is what a controller reads"
    )


def elsewhere(recording: Recorded) -> None:
    manager = recording["controller_managers"].pop("/controller_manager")
    recording["controller_managers"]["/cell/controller_manager"] = manager
    recording["nodes"][0] = {"name": "controller_manager", "namespace": "/cell"}


def test_a_manager_in_another_namespace_is_named(folder: Folder) -> None:
    first, *_ = findings(folder, elsewhere, {})
    assert (
        first["message"]
        == "controller manager '/controller_manager' is not running; /cell/controller_manager runs instead"
    )
