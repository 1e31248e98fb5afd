"""Record a running ROS 1 system: a script for the Python in which ROS is sourced. It needs nothing of urdfctl.

    python3 collector_ros1.py [--seconds S] [--all] > snapshot.json

It only reads: the graph and the parameters from the master, lists of controllers, and messages of some topics.
Each question has a deadline. Values that may be private are left out without --all.
"""

from __future__ import annotations

import argparse
import json
import math
import os
import re
import socket
import sys
import threading
import time
from collections.abc import Iterator, Mapping, Sequence
from typing import Any

ANSWER = 1.0
"""Seconds that the master or a service has for its answer."""
PRIVATE = re.compile(r"(?i)serial|password|passwd|secret|token|(^|[/_])(ip|host|user)(name|_?address)?($|[/_])")
XML_PARAMETER = re.compile(r"(<param\s+name=[\"']([^\"']+)[\"']\s*>)([^<]*)(</param>)")
OF_MASTER = ("/roslaunch/", "/run_id")
"""Parameters that roslaunch keeps for itself, with names of hosts."""
LEFT_OUT = "left out"
TYPES = {
    "sensor_msgs/JointState": "joint_states",
    "tf2_msgs/TFMessage": "tf",
    "tf/tfMessage": "tf",
    "rosgraph_msgs/Clock": "clock",
    "diagnostic_msgs/DiagnosticArray": "diagnostics",
}
"""The parts of the recording that messages belong to, by their types."""
LIST = "/list_controllers"


def plain(value: Any) -> Any:
    """Return a value of a message as JSON has it: NaN and infinity as texts."""
    if isinstance(value, float):
        return value if math.isfinite(value) else str(value)
    if isinstance(value, (str, int)) or value is None:
        return value
    fields = getattr(value, "__slots__", None)
    if fields is not None:
        return {name: plain(getattr(value, name)) for name in fields}
    return [plain(one) for one in value]


def public(text: str) -> str:
    """Return a description without what may be private in the parameters of its hardware."""
    return XML_PARAMETER.sub(
        lambda found: f"{found[1]}{LEFT_OUT if PRIVATE.search(found[2]) else found[3]}{found[4]}", text
    )


def flat(values: Any, name: str = "") -> Iterator[tuple[str, Any]]:
    """Yield the parameters below a name, by full name."""
    if isinstance(values, Mapping):
        for key, value in values.items():
            yield from flat(value, f"{name}/{key}")
    else:
        yield name, values


def seconds_of(stamp: Any) -> str:
    """Return a time in s, without rounding."""
    return f"{stamp.secs}.{stamp.nsecs:09d}"


class Ros1Collector:
    """Asks one running system. seconds: for how long topics are listened to."""

    def __init__(self, rospy: Any, master: Any, seconds: float, *, is_private: bool) -> None:
        self.rospy, self.master, self.seconds, self.is_private = rospy, master, seconds, is_private

    def snapshot(self) -> dict[str, object]:
        """Return the recording of the system."""
        own = self.rospy.get_name()
        publishers, subscribers, services = (
            {name: [node for node in nodes if node != own] for name, nodes in part}
            for part in self.master.getSystemState()
        )
        types = dict(self.master.getTopicTypes())
        nodes = sorted({node for part in (publishers, subscribers, services) for own in part.values() for node in own})
        parameters = self.parameters()
        names = sorted({*publishers, *subscribers})
        return {
            "recorded": {"distro": os.environ.get("ROS_DISTRO") or parameters.get("/rosdistro"), "how": "rospy"},
            "nodes": [self.node(name) for name in nodes],
            "topics": [self.topic(name, types, publishers, subscribers) for name in names],
            "services": [{"name": name, "types": []} for name in sorted(services) if services[name]],
            "controller_managers": self.managers(services),
            "parameters": {"/": {"values": parameters}},
            "robot_description": {
                name: [{"data": value}]
                for name, value in parameters.items()
                if name.endswith("robot_description") and isinstance(value, str)
            },
            **self.messages({name: types[name] for name in publishers if publishers[name] and name in types}),
        }

    @staticmethod
    def node(name: str) -> dict[str, str]:
        """Return a node."""
        namespace, _, own = name.rpartition("/")
        return {"name": own, "namespace": namespace or "/"}

    def topic(
        self,
        name: str,
        types: Mapping[str, str],
        publishers: Mapping[str, Sequence[str]],
        subscribers: Mapping[str, Sequence[str]],
    ) -> dict[str, object]:
        """Return a topic with its ends; ROS 1 knows one type for all of them."""

        def ends(nodes: Sequence[str]) -> list[dict[str, object]]:
            called = (self.node(node) for node in nodes)
            return [{"node": one["name"], "namespace": one["namespace"], "type": types.get(name, "")} for one in called]

        sides = {"publishers": ends(publishers.get(name, ())), "subscriptions": ends(subscribers.get(name, ()))}
        return {"name": name, "types": [types[name]] if name in types else [], **sides}

    def parameters(self) -> dict[str, object]:
        """Return all parameters by full name."""
        found: dict[str, object] = {}
        for name, value in flat(self.master.getParam("/")):
            if not self.is_private and name.startswith(OF_MASTER):
                continue
            if not self.is_private and PRIVATE.search(name):
                found[name] = LEFT_OUT
            elif isinstance(value, str):
                found[name] = value.strip() if self.is_private else public(value.strip())
            else:
                found[name] = plain(value)
        return found

    def managers(self, services: Mapping[str, Sequence[str]]) -> dict[str, object]:
        """Return what the controller managers list, by full name. A manager that hangs costs one deadline, not more."""
        names = [name[: -len(LIST)] for name in services if name.endswith(LIST)]
        found: dict[str, dict[str, object]] = {name: {} for name in sorted(names)}
        threads = [
            threading.Thread(target=self.ask, args=(name, answers), daemon=True) for name, answers in found.items()
        ]
        for thread in threads:
            thread.start()
        ends_at = time.monotonic() + ANSWER
        for thread in threads:
            thread.join(max(0.0, ends_at - time.monotonic()))
        return {name: dict(answers) or {"list_controllers": {"error": "no answer"}} for name, answers in found.items()}

    def ask(self, manager: str, answers: dict[str, object]) -> None:
        """Keep the list of a manager's controllers."""
        try:
            from controller_manager_msgs.srv import ListControllers

            self.rospy.wait_for_service(f"{manager}{LIST}", timeout=ANSWER)
            answers["list_controllers"] = plain(self.rospy.ServiceProxy(f"{manager}{LIST}", ListControllers)())
        except Exception as error:  # noqa: BLE001 (what does not answer is part of the recording)
            answers["list_controllers"] = {"error": str(error) or type(error).__name__}

    # -- messages ------------------------------------------------------------------------------------------------------

    def messages(self, types: Mapping[str, str]) -> dict[str, object]:
        """Return what was received: joint states, transforms, the clock and diagnostics. types: of topics by name."""
        from roslib.message import get_message_class

        received: dict[str, list[Any]] = {}
        subscribers = []
        for name, kind in types.items():
            message = get_message_class(kind) if kind in TYPES else None
            if message is not None:
                kept = received.setdefault(name, [])
                subscribers.append(self.rospy.Subscriber(name, message, kept.append, queue_size=1000))
        time.sleep(self.seconds)
        for subscriber in subscribers:
            subscriber.unregister()
        found: dict[str, dict[str, object]] = {"joint_states": {}, "tf": {}, "diagnostics": {}}
        for name, sent in received.items():
            part = TYPES[types[name]]
            if part == "joint_states":
                found[part][name] = states(list(sent), self.seconds)
            elif part == "tf":
                found[part][name] = transforms(list(sent))
            elif part == "diagnostics":
                found[part][name] = {one.name: {"message": one.message} for each in list(sent) for one in each.status}
        return {**found, "clock": clock_of(received.get("/clock"))}


def clock_of(sent: Sequence[Any] | None) -> dict[str, object]:
    """Return what was received on /clock."""
    if sent is None:
        return {"error": "no publisher"}
    times = [seconds_of(one.clock) for one in sent]
    return {"count": len(times), **({"first": times[0], "last": times[-1]} if times else {})}


def sender_of(message: Any) -> str:
    """Return the node that published a message."""
    return str(getattr(message, "_connection_header", {}).get("callerid", "unknown"))


def counted(names: Sequence[str]) -> dict[str, int]:
    """Return how often each name occurs."""
    return {name: names.count(name) for name in dict.fromkeys(names)}


def states(sent: Sequence[Any], seconds: float) -> dict[str, object]:
    """Return what was received on a topic of joint states."""
    lists = [list(one) for one in dict.fromkeys(tuple(message.name) for message in sent)]
    found: dict[str, object] = {"count": len(sent), "rate_hz": len(sent) / seconds, "name_lists": lists}
    if sent:
        found["publishers"] = counted([sender_of(message) for message in sent])
        for which, message in (("first", sent[0]), ("last", sent[-1])):
            values = {name: plain(list(getattr(message, name))) for name in ("name", "position", "velocity", "effort")}
            found[which] = {**values, "stamp": seconds_of(message.header.stamp)}
        found["stamps"] = [seconds_of(message.header.stamp) for message in sent]
    return found


def transforms(sent: Sequence[Any]) -> list[dict[str, object]]:
    """Return the transforms that were received on a topic."""
    found: dict[tuple[str, str], list[tuple[str, str]]] = {}
    for message in sent:
        for one in message.transforms:
            pair = (one.header.frame_id.lstrip("/"), one.child_frame_id.lstrip("/"))
            found.setdefault(pair, []).append((seconds_of(one.header.stamp), sender_of(message)))
    return [
        {
            "parent": parent,
            "child": child,
            "count": len(own),
            "first_stamp": own[0][0],
            "last_stamp": own[-1][0],
            "publishers": counted([sender for _, sender in own]),
        }
        for (parent, child), own in found.items()
    ]


def main() -> int:
    """Print the recording, and return the exit status: 2 if ROS is not sourced, 3 if no master answers."""
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0] if __doc__ else None)
    parser.add_argument("--seconds", type=float, default=2.0)
    parser.add_argument("--all", action="store_true")
    options = parser.parse_args()
    try:
        import rosgraph
        import rospy
    except ImportError as error:
        sys.stderr.write(f"ROS 1 is not sourced in this Python ({sys.prefix}): {error}\n")
        return 2
    socket.setdefaulttimeout(ANSWER)
    try:
        master = rosgraph.Master("/urdfctl_doctor")
        master.getPid()
        rospy.init_node("urdfctl_doctor", anonymous=True, disable_signals=True, disable_rosout=True)
        found = Ros1Collector(rospy, master, options.seconds, is_private=options.all).snapshot()
    except (OSError, rosgraph.MasterException) as error:
        sys.stderr.write(f"no ROS master answers at ROS_MASTER_URI: {error}\n")
        return 3
    finally:
        rospy.signal_shutdown("recorded")
    json.dump(found, sys.stdout, allow_nan=False)
    sys.stdout.flush()
    return 0


if __name__ == "__main__":
    os._exit(main())  # a thread that waits for a service that hangs must not keep the process
