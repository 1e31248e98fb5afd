"""Record a running ROS 2 system: a script for the Python in which ROS is sourced. It needs nothing of urdfctl.

    python3 collector.py [--seconds S] [--all] > snapshot.json

It only reads: names, types and QoS of the graph, answers of list services, parameters, and messages of some topics.
Each question has a deadline. Values that may be private are left out without --all.
"""

from __future__ import annotations

import argparse
import json
import math
import re
import sys
import time
from collections.abc import Sequence
from typing import Any

LISTS = {
    "list_controllers": "ListControllers",
    "list_hardware_interfaces": "ListHardwareInterfaces",
    "list_hardware_components": "ListHardwareComponents",
    "list_controller_types": "ListControllerTypes",
}
"""The services of a controller manager that are asked, with their types in controller_manager_msgs."""
DISCOVERY = 1.5
"""Seconds in which the graph becomes known."""
ANSWER = 0.5
"""Seconds that one service has for its answer."""
ALL_ANSWERS = 15.0
"""Seconds that all services together have."""
PRIVATE = re.compile(r"(?i)serial|password|passwd|secret|token|(^|[._])(ip|host|user)(name|_?address)?($|[._])")
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


def full(node: str, namespace: str) -> str:
    """Return the full name of a node."""
    return f"{namespace.rstrip('/')}/{node}"


def stamp_of(header: Any) -> float:
    """Return the stamp of a header in s."""
    stamp = header.stamp
    return float(stamp.sec) + float(stamp.nanosec) * 1e-9


class Collector:
    """Asks one running system. seconds: for how long topics are listened to."""

    def __init__(self, rclpy: Any, node: Any, seconds: float, *, is_private: bool) -> None:
        self.rclpy, self.node, self.seconds, self.is_private = rclpy, node, seconds, is_private
        self.asks_until = time.monotonic() + DISCOVERY + ALL_ANSWERS

    def snapshot(self) -> dict[str, object]:
        """Return the recording of the system."""
        ends_at = time.monotonic() + DISCOVERY
        while time.monotonic() < ends_at:  # the graph becomes known little by little
            self.rclpy.spin_once(self.node, timeout_sec=0.1)
        nodes = [
            (name, space) for name, space in self.node.get_node_names_and_namespaces() if name != self.node.get_name()
        ]
        services = self.node.get_service_names_and_types()
        found: dict[str, object] = {
            "recorded": {"distro": distro(), "how": "rclpy"},
            "nodes": [{"name": name, "namespace": space} for name, space in nodes],
            "topics": self.topics(),
            "services": [{"name": name, "types": list(types)} for name, types in services],
            "controller_managers": self.managers(services),
            "parameters": {full(*node): self.parameters(full(*node)) for node in nodes},
        }
        return {**found, **self.messages()}

    # -- the graph -----------------------------------------------------------------------------------------------------

    def topics(self) -> list[dict[str, object]]:
        """Return the topics with their ends."""
        found = []
        for name, types in self.node.get_topic_names_and_types():
            publishers = [self.end(one) for one in self.node.get_publishers_info_by_topic(name)]
            subscriptions = [self.end(one) for one in self.node.get_subscriptions_info_by_topic(name)]
            subscriptions = [one for one in subscriptions if one["node"] != self.node.get_name()]
            found.append({"name": name, "types": list(types), "publishers": publishers, "subscriptions": subscriptions})
        return found

    @staticmethod
    def end(info: Any) -> dict[str, object]:
        """Return a publisher or a subscription."""
        qos = {name: getattr(info.qos_profile, name).name.lower() for name in ("reliability", "durability", "history")}
        return {"node": info.node_name, "namespace": info.node_namespace, "type": info.topic_type, "qos": qos}

    # -- services ------------------------------------------------------------------------------------------------------

    def ask(self, kind: Any, name: str, **fields: object) -> Any:
        """Return the response of a service. Raises TimeoutError if it does not answer in time."""
        client = self.node.create_client(kind, name)
        try:
            if time.monotonic() > self.asks_until or not client.wait_for_service(timeout_sec=ANSWER):
                raise TimeoutError("service not available")
            request = kind.Request()
            for field, value in fields.items():
                setattr(request, field, value)
            future = client.call_async(request)
            self.rclpy.spin_until_future_complete(self.node, future, timeout_sec=ANSWER)
            if not future.done():
                raise TimeoutError("no answer")
            return future.result()
        finally:
            self.node.destroy_client(client)

    def managers(self, services: Sequence[tuple[str, Sequence[str]]]) -> dict[str, object]:
        """Return what the controller managers list, by full name."""
        names = {name.rpartition("/")[0] for name, _ in services if name.endswith(tuple(f"/{each}" for each in LISTS))}
        names |= {full(*node) for node in self.node.get_node_names_and_namespaces() if node[0] == "controller_manager"}
        found: dict[str, object] = {}
        for name in sorted(names):
            answers: dict[str, object] = {}
            for service, kind in LISTS.items():
                try:
                    import controller_manager_msgs.srv

                    answers[service] = plain(self.ask(getattr(controller_manager_msgs.srv, kind), f"{name}/{service}"))
                except Exception as error:  # noqa: BLE001 (what does not answer is part of the recording)
                    answers[service] = {"error": str(error) or type(error).__name__}
                    break  # the others would wait as long
            found[name] = answers
        return found

    def parameters(self, node: str) -> dict[str, object]:
        """Return the parameters of a node."""
        try:
            from rcl_interfaces.srv import GetParameters, ListParameters

            names = list(self.ask(ListParameters, f"{node}/list_parameters").result.names)
            values = self.ask(GetParameters, f"{node}/get_parameters", names=names).values
        except Exception as error:  # noqa: BLE001 (see above)
            return {"error": str(error) or type(error).__name__}
        return {"values": {name: self.parameter(name, value) for name, value in zip(names, values)}}  # noqa: B905 (Python 3.8 of foxy)

    def parameter(self, name: str, value: Any) -> object:
        """Return the value of a parameter."""
        if PRIVATE.search(name) and not self.is_private:
            return LEFT_OUT
        known = (None, *OF_PARAMETERS, *OF_LISTS)
        field = known[value.type] if 0 < value.type < len(known) else None
        return plain(getattr(value, field)) if field else None

    # -- messages ------------------------------------------------------------------------------------------------------

    def messages(self) -> dict[str, object]:
        """Return what was received: descriptions, joint states, transforms, the clock and diagnostics."""
        received: dict[tuple[str, str], list[object]] = {}
        subscriptions = []
        for name, types in self.node.get_topic_names_and_types():
            part = part_of(name, types)
            if part is not None:
                kept = received.setdefault((part, name), [])
                subscriptions.append(self.listen(name, types[0], kept))
        ends_at = time.monotonic() + self.seconds
        while time.monotonic() < ends_at:
            self.rclpy.spin_once(self.node, timeout_sec=0.05)
        for subscription in subscriptions:
            self.node.destroy_subscription(subscription)
        found: dict[str, dict[str, object]] = {
            part: {} for part in ("robot_description", "joint_states", "tf", "diagnostics")
        }
        for (part, name), sent in received.items():
            if part in found:
                found[part][name] = SUMMARIES[part](sent, self.seconds)
        clock = next((sent for (part, _), sent in received.items() if part == "clock"), None)
        return {**found, "clock": {"count": len(clock)} if clock is not None else {"error": "no publisher"}}

    def listen(self, name: str, kind: str, kept: list[object]) -> Any:
        """Subscribe a topic with what each of its publishers offers."""
        from rclpy.qos import DurabilityPolicy, QoSProfile, ReliabilityPolicy
        from rosidl_runtime_py.utilities import get_message

        infos = self.node.get_publishers_info_by_topic(name)
        lasting = bool(infos) and all(one.qos_profile.durability == DurabilityPolicy.TRANSIENT_LOCAL for one in infos)
        durability = DurabilityPolicy.TRANSIENT_LOCAL if lasting else DurabilityPolicy.VOLATILE
        qos = QoSProfile(depth=1000, durability=durability, reliability=ReliabilityPolicy.BEST_EFFORT)
        return self.node.create_subscription(get_message(kind), name, kept.append, qos)


def part_of(name: str, types: list[str]) -> str | None:
    """Return the part of the recording that the messages of a topic belong to."""
    if name.rpartition("/")[2] == "robot_description":
        return "robot_description"
    parts = {
        "sensor_msgs/msg/JointState": "joint_states",
        "tf2_msgs/msg/TFMessage": "tf",
        "diagnostic_msgs/msg/DiagnosticArray": "diagnostics",
        "rosgraph_msgs/msg/Clock": "clock",
    }
    return next((parts[kind] for kind in types if kind in parts), None)


def _descriptions(sent: list[Any], _seconds: float) -> object:
    return [{"data": message.data} for message in sent]


def _joint_states(sent: list[Any], seconds: float) -> object:
    lists = [list(names) for names in dict.fromkeys(tuple(message.name) for message in sent)]
    found: dict[str, object] = {"count": len(sent), "rate_hz": len(sent) / seconds, "name_lists": lists}
    if sent:
        found["last"] = {
            "name": list(sent[-1].name),
            "position": plain(sent[-1].position),
            "stamp": stamp_of(sent[-1].header),
        }
    return found


def _transforms(sent: list[Any], _seconds: float) -> object:
    pairs = [(one.header.frame_id, one.child_frame_id) for message in sent for one in message.transforms]
    return [
        {"parent": parent, "child": child, "count": pairs.count((parent, child))}
        for parent, child in dict.fromkeys(pairs)
    ]


def _diagnostics(sent: list[Any], _seconds: float) -> object:
    return {
        status.name: {"level": plain(status.level), "message": status.message} for one in sent for status in one.status
    }


SUMMARIES = {
    "robot_description": _descriptions,
    "joint_states": _joint_states,
    "tf": _transforms,
    "diagnostics": _diagnostics,
}


def distro() -> str | None:
    """Return the sourced distro."""
    import os

    return os.environ.get("ROS_DISTRO")


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
    node = rclpy.create_node("urdfctl_doctor")
    try:
        found = Collector(rclpy, node, options.seconds, is_private=options.all).snapshot()
    finally:
        node.destroy_node()
        rclpy.shutdown()
    json.dump(found, sys.stdout, allow_nan=False)
    return 0


if __name__ == "__main__":
    sys.exit(main())
