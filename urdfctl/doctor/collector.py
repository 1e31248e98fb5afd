"""Record a running ROS 2 system: a script for the Python in which ROS is sourced. It needs nothing of urdfctl.

    python3 collector.py [--seconds S] [--all] > snapshot.json

It only reads: names, types and QoS of the graph, answers of list services, parameters, and messages of some topics.
All questions are open at once and share a deadline. Values that may be private are left out without --all.
"""

from __future__ import annotations

import argparse
import importlib
import json
import math
import os
import re
import sys
import time
from collections.abc import Callable, Sequence
from typing import Any

LISTS = {
    "list_controllers": "ListControllers",
    "list_hardware_interfaces": "ListHardwareInterfaces",
    "list_hardware_components": "ListHardwareComponents",
    "list_controller_types": "ListControllerTypes",
}
"""The services of a controller manager that are asked, with their types in controller_manager_msgs."""
PACKAGES = (
    "controller_manager",
    "hardware_interface",
    "ros2_controllers",
    "joint_trajectory_controller",
    "robot_state_publisher",
    "rclcpp",
    "tf2_ros",
    "gz_ros2_control",
    "ros_gz_bridge",
)
"""The packages whose versions are recorded."""
DISCOVERY = 1.0
"""Seconds in which the graph becomes known."""
ANSWERS = 1.8
"""Seconds after which a question has no answer."""
PRIVATE = re.compile(r"(?i)serial|password|passwd|secret|token|(^|[._])(ip|host|user)(name|_?address)?($|[._])")
XML_PARAMETER = re.compile(r"(<param\s+name=[\"']([^\"']+)[\"']\s*>)([^<]*)(</param>)")
LEFT_OUT = "left out"
OF_PARAMETERS = ("bool_value", "integer_value", "double_value", "string_value")
OF_LISTS = ("byte_array_value", "bool_array_value", "integer_array_value", "double_array_value", "string_array_value")


def plain(value: Any) -> Any:
    """Return a value of a message as JSON has it: NaN and infinity as texts."""
    if isinstance(value, float):
        return value if math.isfinite(value) else str(value)
    if isinstance(value, (str, int)) or value is None:
        return value
    if isinstance(value, bytes):
        return value[0] if len(value) == 1 else list(value)
    fields = getattr(value, "get_fields_and_field_types", None)
    if fields is not None:
        return {name: plain(getattr(value, name)) for name in fields()}
    return [plain(one) for one in value]


def public(text: str) -> str:
    """Return a description without what may be private in the parameters of its hardware."""
    return XML_PARAMETER.sub(
        lambda found: f"{found[1]}{LEFT_OUT if PRIVATE.search(found[2]) else found[3]}{found[4]}", text
    )


def full(node: str, namespace: str) -> str:
    """Return the full name of a node."""
    return f"{namespace.rstrip('/')}/{node}"


def stamp_of(header: Any) -> str:
    """Return the stamp of a header in s, without rounding."""
    return f"{header.stamp.sec}.{header.stamp.nanosec:09d}"


class ServiceQuestion:
    """A call of a service. done: gets the response, or an error."""

    def __init__(self, client: Any, request: Any, done: Callable[[Any], None]) -> None:
        self.client, self.request, self.done = client, request, done
        self.future: Any = None

    def advance(self) -> bool:
        """Ask when the service is there, and return whether it has answered."""
        if self.future is None and self.client.service_is_ready():
            self.future = self.client.call_async(self.request)
        if self.future is None or not self.future.done():
            return False
        self.done(self.future.result())
        return True

    def give_up(self) -> None:
        """Say what did not answer."""
        self.done({"error": "no answer" if self.future is not None else "service not available"})


class Collector:
    """Asks one running system. seconds: for how long topics are listened to."""

    def __init__(self, rclpy: Any, node: Any, seconds: float, *, is_private: bool) -> None:
        self.rclpy, self.node, self.seconds, self.is_private = rclpy, node, seconds, is_private
        self.open: list[ServiceQuestion] = []

    def snapshot(self) -> dict[str, object]:
        """Return the recording of the system."""
        self.spin(DISCOVERY, lambda: True)
        known = self.node.get_node_names_and_namespaces()
        nodes = [(name, space) for name, space in known if name != self.node.get_name()]
        own = f"{full(self.node.get_name(), '/')}/"
        services = [one for one in self.node.get_service_names_and_types() if not one[0].startswith(own)]
        found: dict[str, object] = {
            "recorded": {"distro": os.environ.get("ROS_DISTRO"), "how": "rclpy", "versions": versions()},
            "nodes": [{"name": name, "namespace": space} for name, space in nodes],
            "topics": self.topics(),
            "services": [{"name": name, "types": list(types)} for name, types in services],
            "controller_managers": self.managers(services, [full(*node) for node in nodes]),
            "parameters": {full(*node): self.parameters(full(*node)) for node in nodes},
        }
        return {**found, **self.messages()}

    def spin(self, seconds: float, is_open: Callable[[], bool], at_least: float = 0.0) -> None:
        """Let messages and answers come in for some time, or until nothing is open."""
        began = time.monotonic()
        while time.monotonic() - began < seconds and (is_open() or time.monotonic() - began < at_least):
            self.rclpy.spin_once(self.node, timeout_sec=0.05)
            self.open = [one for one in self.open if not one.advance()]

    # -- the graph -----------------------------------------------------------------------------------------------------

    def topics(self) -> list[dict[str, object]]:
        """Return the topics with their ends."""
        found = []
        for name, types in self.node.get_topic_names_and_types():
            publishers = [self.end(one) for one in self.node.get_publishers_info_by_topic(name)]
            subscriptions = [self.end(one) for one in self.node.get_subscriptions_info_by_topic(name)]
            publishers, subscriptions = (
                [one for one in ends if one["node"] != self.node.get_name()] for ends in (publishers, subscriptions)
            )
            found.append({"name": name, "types": list(types), "publishers": publishers, "subscriptions": subscriptions})
        return found

    @staticmethod
    def end(info: Any) -> dict[str, object]:
        """Return a publisher or a subscription."""
        qos = {name: getattr(info.qos_profile, name).name.lower() for name in ("reliability", "durability", "history")}
        return {"node": info.node_name, "namespace": info.node_namespace, "type": info.topic_type, "qos": qos}

    # -- services ------------------------------------------------------------------------------------------------------

    def ask(self, kind: Any, name: str, done: Callable[[Any], None], **fields: object) -> None:
        """Ask a service that reads. done: gets its response, or what went wrong."""
        request = kind.Request()
        for field, value in fields.items():
            setattr(request, field, value)
        self.open.append(ServiceQuestion(self.node.create_client(kind, name), request, done))

    def managers(self, services: Sequence[tuple[str, Sequence[str]]], nodes: Sequence[str]) -> dict[str, object]:
        """Return what the controller managers list, by full name; the answers come in later."""
        names = {name.rpartition("/")[0] for name, _ in services if name.endswith(tuple(f"/{each}" for each in LISTS))}
        names |= {node for node in nodes if node.endswith("/controller_manager")}
        found: dict[str, dict[str, object]] = {name: {} for name in sorted(names)}
        for name, answers in found.items():
            for service, kind in LISTS.items():
                try:
                    import controller_manager_msgs.srv

                    keep = keeper(answers, service)
                    self.ask(getattr(controller_manager_msgs.srv, kind), f"{name}/{service}", keep)
                except (ImportError, AttributeError) as error:
                    answers[service] = {"error": str(error)}
        return {**found}

    def parameters(self, node: str) -> dict[str, object]:
        """Return the parameters of a node; they come in later."""
        from rcl_interfaces.srv import GetParameters, ListParameters

        found: dict[str, object] = {}

        def listed(response: Any) -> None:
            if isinstance(response, dict):
                found.update(response)
                return
            names = list(response.result.names)

            def given(answer: Any) -> None:
                if isinstance(answer, dict):
                    found.update(answer)
                else:
                    pairs = zip(names, answer.values)  # noqa: B905 (Python 3.8 of foxy)
                    found["values"] = {name: self.parameter(name, value) for name, value in pairs}

            self.ask(GetParameters, f"{node}/get_parameters", given, names=names)

        self.ask(ListParameters, f"{node}/list_parameters", listed)
        return found

    def parameter(self, name: str, value: Any) -> object:
        """Return the value of a parameter."""
        if PRIVATE.search(name) and not self.is_private:
            return LEFT_OUT
        known = (None, *OF_PARAMETERS, *OF_LISTS)
        field = known[value.type] if 0 < value.type < len(known) else None
        found = plain(getattr(value, field)) if field else None
        return public(found) if isinstance(found, str) and not self.is_private else found

    # -- messages ------------------------------------------------------------------------------------------------------

    def messages(self) -> dict[str, object]:
        """Return what was received: descriptions, joint states, transforms, the clock and diagnostics."""
        received: dict[tuple[str, str], list[object]] = {}
        for name, types in self.node.get_topic_names_and_types():
            part = PARTS.get(types[0])
            if part is not None and (part != "robot_description" or name.endswith("/robot_description")):
                self.listen(name, types[0], received.setdefault((part, name), []))
        self.spin(max(self.seconds, ANSWERS), lambda: bool(self.open), self.seconds)
        for question in self.open:
            question.give_up()
        found: dict[str, dict[str, object]] = {part: {} for part in SUMMARIES}
        for (part, name), sent in received.items():
            if part in found:
                found[part][name] = SUMMARIES[part](sent, self.seconds)
                self.add_publisher(part, name, found[part][name])
        for texts in found["robot_description"].values() if not self.is_private else ():
            for one in texts:  # type: ignore[attr-defined]
                one["data"] = public(one["data"])
        clock = next((sent for (part, _), sent in received.items() if part == "clock"), None)
        return {**found, "clock": clock_of(clock)}

    def add_publisher(self, part: str, topic: str, summary: Any) -> None:
        """Name the publisher of what was received, if there is only one."""
        senders = self.node.get_publishers_info_by_topic(topic)
        if len(senders) == 1 and part in ("joint_states", "dynamic_joint_states"):
            summary["publishers"] = {full(senders[0].node_name, senders[0].node_namespace): summary["count"]}

    def listen(self, name: str, kind: str, kept: list[object]) -> None:
        """Subscribe a topic with what each of its publishers offers."""
        from rclpy.qos import DurabilityPolicy, QoSProfile, ReliabilityPolicy

        package, _, message = kind.partition("/msg/")
        infos = self.node.get_publishers_info_by_topic(name)
        lasting = bool(infos) and all(one.qos_profile.durability == DurabilityPolicy.TRANSIENT_LOCAL for one in infos)
        durability = DurabilityPolicy.TRANSIENT_LOCAL if lasting else DurabilityPolicy.VOLATILE
        qos = QoSProfile(depth=1000, durability=durability, reliability=ReliabilityPolicy.BEST_EFFORT)
        message_type = getattr(importlib.import_module(f"{package}.msg"), message)
        self.node.create_subscription(message_type, name, kept.append, qos)


def keeper(answers: dict[str, object], service: str) -> Callable[[Any], None]:
    """Return what keeps a response under the name of its service."""

    def keep(response: Any) -> None:
        answers[service] = response if isinstance(response, dict) else plain(response)

    return keep


PARTS = {
    "std_msgs/msg/String": "robot_description",
    "sensor_msgs/msg/JointState": "joint_states",
    "control_msgs/msg/DynamicJointState": "dynamic_joint_states",
    "tf2_msgs/msg/TFMessage": "tf",
    "diagnostic_msgs/msg/DiagnosticArray": "diagnostics",
    "rosgraph_msgs/msg/Clock": "clock",
}
"""The parts of the recording that messages belong to, by their types."""


def clock_of(sent: Sequence[Any] | None) -> dict[str, object]:
    """Return what was received on /clock."""
    if sent is None:
        return {"error": "no publisher"}
    times = [f"{one.clock.sec}.{one.clock.nanosec:09d}" for one in sent]
    return {"count": len(times), **({"first": times[0], "last": times[-1]} if times else {})}


def _descriptions(sent: Sequence[Any], _seconds: float) -> object:
    return [{"data": message.data} for message in sent]


def _states(sent: Sequence[Any], seconds: float, names: str, **fields: str) -> dict[str, object]:
    lists = [list(one) for one in dict.fromkeys(tuple(getattr(message, names)) for message in sent)]
    found: dict[str, object] = {"count": len(sent), "rate_hz": len(sent) / seconds, "name_lists": lists}
    if sent:
        for which, message in (("first", sent[0]), ("last", sent[-1])):
            values = {name: plain(getattr(message, field)) for name, field in fields.items()}
            found[which] = {**values, "stamp": stamp_of(message.header)}
        found["stamps"] = [stamp_of(message.header) for message in sent]
    return found


def _joint_states(sent: Sequence[Any], seconds: float) -> object:
    fields = {name: name for name in ("name", "position", "velocity", "effort")}
    return _states(sent, seconds, "name", **fields)


def _dynamic_joint_states(sent: Sequence[Any], seconds: float) -> object:
    return _states(sent, seconds, "joint_names", joint_names="joint_names", interface_values="interface_values")


def _transforms(sent: Sequence[Any], _seconds: float) -> object:
    stamps: dict[tuple[str, str], list[str]] = {}
    for one in (each for message in sent for each in message.transforms):
        stamps.setdefault((one.header.frame_id, one.child_frame_id), []).append(stamp_of(one.header))
    return [
        {"parent": parent, "child": child, "count": len(own), "first_stamp": own[0], "last_stamp": own[-1]}
        for (parent, child), own in stamps.items()
    ]


def _diagnostics(sent: Sequence[Any], _seconds: float) -> object:
    return {
        status.name: {"level": plain(status.level), "message": status.message} for one in sent for status in one.status
    }


SUMMARIES: dict[str, Callable[[Sequence[Any], float], object]] = {
    "robot_description": _descriptions,
    "joint_states": _joint_states,
    "dynamic_joint_states": _dynamic_joint_states,
    "tf": _transforms,
    "diagnostics": _diagnostics,
}


def versions() -> dict[str, str]:
    """Return the versions of the packages that matter, as their package.xml says."""
    found: dict[str, str] = {}
    for package in PACKAGES:
        for prefix in os.environ.get("AMENT_PREFIX_PATH", "").split(os.pathsep):
            try:
                with open(os.path.join(prefix, "share", package, "package.xml"), encoding="utf-8") as file:
                    version = re.search(r"<version[^>]*>\s*([^<\s]+)", file.read())
            except OSError:
                continue
            if version:
                found.setdefault(package, version[1])
    return found


def main() -> int:
    """Print the recording, and return the exit status: 2 if ROS is not sourced."""
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0] if __doc__ else None)
    parser.add_argument("--seconds", type=float, default=2.0)
    parser.add_argument("--all", action="store_true")
    options = parser.parse_args()
    try:
        import rclpy
    except ImportError as error:
        sys.stderr.write(f"ROS 2 is not sourced in this Python ({sys.prefix}): {error}\n")
        return 2
    rclpy.init()
    node = rclpy.create_node("urdfctl_doctor", enable_rosout=False, start_parameter_services=False)
    try:
        found = Collector(rclpy, node, options.seconds, is_private=options.all).snapshot()
    finally:
        node.destroy_node()
        rclpy.shutdown()
    json.dump(found, sys.stdout, allow_nan=False)
    return 0


if __name__ == "__main__":
    sys.exit(main())
