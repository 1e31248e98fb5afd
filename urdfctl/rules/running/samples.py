"""A small system for the examples of this family: its files, and what a recording of it shows when it runs."""

from __future__ import annotations

import json
from collections.abc import Callable
from typing import Any

Recorded = dict[str, Any]

_JOINT = """
  <link name="{0}_link"/>
  <joint name="{0}" type="revolute">
    <parent link="base"/><child link="{0}_link"/><axis xyz="0 0 1"/>
    <limit lower="-1" upper="1" effort="5" velocity="2"/>
  </joint>"""
_PART = '<joint name="{0}"><command_interface name="position"/><state_interface name="position"/></joint>'
DESCRIPTION = f"""<robot name="arm">
  <link name="base"/>{_JOINT.format("pan")}{_JOINT.format("tilt")}
  <ros2_control name="Arm" type="system">
    <hardware><plugin>arm_driver/ArmSystem</plugin></hardware>
    {_PART.format("pan")}{_PART.format("tilt")}
  </ros2_control>
</robot>
"""
_LAUNCH = """<launch>
  <let name="model" value="$(command 'cat $(find-pkg-share arm)/arm.urdf')"/>
  <node pkg="robot_state_publisher" exec="robot_state_publisher" name="robot_state_publisher">
    <param name="robot_description" type="str" value="$(command 'xacro $(find-pkg-share arm)/arm.urdf')"/>
  </node>
  <node pkg="controller_manager" exec="ros2_control_node" name="controller_manager">
    <param from="$(find-pkg-share arm)/controllers.yaml"/>
    <remap from="~/robot_description" to="/robot_description"/>
  </node>
  <node pkg="controller_manager" exec="spawner" args="joint_state_broadcaster head"/>
</launch>
""".replace('  <let name="model" value="$(command \'cat $(find-pkg-share arm)/arm.urdf\')"/>\n', "")
_CONTROLLERS = """controller_manager:
  ros__parameters:
    update_rate: 100
    joint_state_broadcaster: {type: joint_state_broadcaster/JointStateBroadcaster}
    head: {type: forward_command_controller/ForwardCommandController}
head:
  ros__parameters:
    joints: [pan, tilt]
    interface_name: position
"""
FILES = {
    "launch/arm.launch.xml": _LAUNCH,
    "arm.urdf": DESCRIPTION,
    "controllers.yaml": _CONTROLLERS,
    "package.xml": '<package format="3"><name>arm</name><export><build_type>ament_cmake</build_type></export></package>',
}
_STATES = "sensor_msgs/msg/JointState"
_COMMANDS = "std_msgs/msg/Float64MultiArray"


def end(node: str, kind: str, durability: str = "volatile", reliability: str = "reliable") -> Recorded:
    """Return a publisher or a subscription of a topic."""
    namespace, _, name = node.rpartition("/")
    qos = {"durability": durability, "reliability": reliability}
    return {"node": name, "namespace": namespace or "/", "type": kind, "qos": qos}


def topic(name: str, publishers: list[Recorded], subscriptions: list[Recorded]) -> Recorded:
    """Return a topic."""
    return {"name": name, "publishers": publishers, "subscriptions": subscriptions}


def controller(name: str, state: str, kind: str, commands: list[str]) -> Recorded:
    """Return a controller as a manager lists it."""
    claimed = commands if state == "active" else []
    return {
        "name": name,
        "state": state,
        "type": kind,
        "claimed_interfaces": claimed,
        "required_command_interfaces": commands,
        "required_state_interfaces": [],
    }


def sound() -> Recorded:
    """Return the recording of the system as the files say."""
    interfaces = [{"name": f"{joint}/position"} for joint in ("pan", "tilt")]
    commands = ["pan/position", "tilt/position"]
    broadcaster = controller("joint_state_broadcaster", "active", "joint_state_broadcaster/JointStateBroadcaster", [])
    broadcaster["required_state_interfaces"] = commands
    manager: Recorded = {
        "list_controllers": {
            "controller": [
                broadcaster,
                controller("head", "active", "forward_command_controller/ForwardCommandController", commands),
            ]
        },
        "list_hardware_components": {
            "component": [
                {
                    "name": "Arm",
                    "plugin_name": "arm_driver/ArmSystem",
                    "state": {"label": "active"},
                    "command_interfaces": interfaces,
                    "state_interfaces": interfaces,
                }
            ]
        },
        "list_hardware_interfaces": {"command_interfaces": interfaces, "state_interfaces": interfaces},
        "list_controller_types": {
            "types": [
                "joint_state_broadcaster/JointStateBroadcaster",
                "forward_command_controller/ForwardCommandController",
            ]
        },
    }
    nodes = ("controller_manager", "head", "joint_state_broadcaster", "robot_state_publisher")
    types = {f"{one['name']}.type": one["type"] for one in manager["list_controllers"]["controller"]}
    return {
        "recorded": {"distro": "jazzy"},
        "nodes": [{"name": name, "namespace": "/"} for name in nodes],
        "topics": [
            topic(
                "/joint_states", [end("/joint_state_broadcaster", _STATES)], [end("/robot_state_publisher", _STATES)]
            ),
            topic("/head/commands", [], [end("/head", _COMMANDS)]),
            topic(
                "/robot_description",
                [end("/robot_state_publisher", "std_msgs/msg/String", "transient_local")],
                [end("/controller_manager", "std_msgs/msg/String", "transient_local")],
            ),
        ],
        "services": [{"name": "/controller_manager/list_controllers"}],
        "controller_managers": {"/controller_manager": manager},
        "parameters": {
            "/head": {"values": {"joints": ["pan", "tilt"], "interface_name": "position", "use_sim_time": False}},
            "/controller_manager": {"values": {"update_rate": 100, "use_sim_time": False, **types}},
            "/joint_state_broadcaster": {"values": {"joints": [], "use_sim_time": False}},
            "/robot_state_publisher": {"values": {"use_sim_time": False}},
        },
        "robot_description": {"/robot_description": [{"data": DESCRIPTION}]},
        "joint_states": {
            "/joint_states": {
                "count": 200,
                "rate_hz": 100.0,
                "name_lists": [["pan", "tilt"]],
                "publishers": {"/joint_state_broadcaster": 200},
                "stamps": ["100.0", "101.0", "102.0"],
                "last": {"name": ["pan", "tilt"], "position": [0.1, 0.2], "stamp": "102.0"},
            }
        },
        "clock": {"error": "no publisher"},
        "tf": {"/tf": [{"parent": "base", "child": "pan_link"}, {"parent": "base", "child": "tilt_link"}]},
    }


def example(change: Callable[[Recorded], object] = lambda _: None) -> dict[str, str]:
    """Return the files of the system with its recording, in which something is changed."""
    recording = sound()
    change(recording)
    return {"snapshot.json": json.dumps(recording), **FILES}


def manager_in(recording: Recorded) -> Recorded:
    """Return the answers of the controller manager of a recording."""
    answers: Recorded = recording["controller_managers"]["/controller_manager"]
    return answers


def controllers_in(recording: Recorded) -> list[Recorded]:
    """Return the controllers that the manager of a recording lists: the broadcaster, then the other one."""
    listed: list[Recorded] = manager_in(recording)["list_controllers"]["controller"]
    return listed


def silent_manager(recording: Recorded) -> None:
    """Let the manager answer nothing."""
    recording["controller_managers"]["/controller_manager"] = {"list_controllers": {"error": "service not available"}}


def without_node(recording: Recorded, name: str) -> None:
    """Take a node out of a recording."""
    recording["nodes"] = [node for node in recording["nodes"] if node["name"] != name]
