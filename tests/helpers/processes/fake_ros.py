"""A stand-in for the Python of ROS 2: modules with the names and calls that the collector uses, which answer from a
recording."""

from __future__ import annotations

from pathlib import Path

_RCLPY = """
import json, os, time
from types import SimpleNamespace as S
R = json.load(open(os.environ["FAKE_SYSTEM"]))
MUTE = bool(os.environ.get("FAKE_MUTE"))
class Enum:
    def __init__(self, name): self.name = name.upper()
    def __eq__(self, other): return self.name == getattr(other, "name", None)
    def __hash__(self): return hash(self.name)
def ends(side, name):
    found = next((topic for topic in R["topics"] if topic["name"] == name), {})
    for end in found.get(side, []):
        qos = {"reliability": "reliable", "durability": "volatile", "history": "keep_last", **end.get("qos", {})}
        profile = S(**{key: Enum(qos[key]) for key in ("reliability", "durability", "history")})
        yield S(node_name=end["node"], node_namespace=end["namespace"], topic_type=end["type"], qos_profile=profile)
class Future:
    def __init__(self, value): self.value = value
    def done(self): return True
    def result(self): return self.value
class Client:
    def __init__(self, kind, name): self.kind, self.name = kind, name
    def service_is_ready(self): return not MUTE
    def call_async(self, request): return Future(self.kind.answer(self.name, request))
class Node:
    def __init__(self, name): self.name, self.queue = name, []
    def get_name(self): return self.name
    def destroy_node(self): print("destroyed", file=open(os.environ["FAKE_SYSTEM"] + ".end", "a"))
    def destroy_client(self, client): pass
    def create_publisher(self, kind, name, qos): return S(publish=lambda message: None)
    def destroy_subscription(self, subscription): pass
    def get_node_names_and_namespaces(self):
        return [(n["name"], n["namespace"]) for n in R["nodes"]] + [(self.name, "/")]
    def get_topic_names_and_types(self):
        return [(t["name"], sorted({e["type"] for e in t["publishers"] + t["subscriptions"]})) for t in R["topics"]]
    def get_service_names_and_types(self): return [(s["name"], ["any"]) for s in R["services"]]
    def get_publishers_info_by_topic(self, name): return list(ends("publishers", name))
    def get_subscriptions_info_by_topic(self, name): return list(ends("subscriptions", name))
    def create_client(self, kind, name): return Client(kind, name)
    def create_subscription(self, kind, name, callback, qos): self.queue += [(callback, m) for m in kind.messages(name)]
def init(): pass
def shutdown(): pass
def create_node(name, **options): return Node(name)
def spin_once(node, timeout_sec):
    time.sleep(min(timeout_sec, 0.02))
    while node.queue:
        callback, message = node.queue.pop(0)
        callback(message)
def spin_until_future_complete(node, future, timeout_sec): pass
"""
_QOS = """
from rclpy import Enum
class DurabilityPolicy: TRANSIENT_LOCAL, VOLATILE = Enum("transient_local"), Enum("volatile")
class ReliabilityPolicy: BEST_EFFORT = Enum("best_effort")
def QoSProfile(**qos): return qos
"""
_MESSAGE = """
from types import SimpleNamespace as S
from rclpy import R
class Message(S):
    def get_fields_and_field_types(self): return dict.fromkeys(vars(self))
def message(value):
    if isinstance(value, dict): return Message(**{key: message(each) for key, each in value.items()})
    return [message(each) for each in value] if isinstance(value, list) else value
"""
_SERVICES = """
from fake_message import R, message
class Request: pass
def service(question):
    class Service:
        Request = Request
        @staticmethod
        def answer(name, request): return message(R["controller_managers"][name.rpartition("/")[0]].get(question, {}))
    return Service
def lifecycle(stage):
    class Service:
        class Request: name, activate_controllers, strictness = "", [], 0
        @staticmethod
        def answer(name, request):
            controller = request.name or request.activate_controllers[0]
            return message({"ok": stage in R.get("passes", {}).get(controller, ["load", "configure", "activate"])})
    return Service
LoadController, ConfigureController, SwitchController = map(lifecycle, ("load", "configure", "activate"))
ListControllers, ListHardwareInterfaces, ListHardwareComponents, ListControllerTypes = map(
    service, ("list_controllers", "list_hardware_interfaces", "list_hardware_components", "list_controller_types"))
"""
_PARAMETERS = """
from types import SimpleNamespace as S
from rclpy import R
FIELDS = {bool: (1, "bool_value"), int: (2, "integer_value"), float: (3, "double_value"), str: (4, "string_value"),
          list: (9, "string_array_value")}
class Request: pass
def value(one):
    kind, field = FIELDS[type(one)]
    return S(type=kind, **{field: one})
class ListParameters:
    Request = Request
    @staticmethod
    def answer(name, request): return S(result=S(names=list(R["parameters"][name.rpartition("/")[0]]["values"])))
class GetParameters:
    Request = Request
    @staticmethod
    def answer(name, request):
        return S(values=[value(R["parameters"][name.rpartition("/")[0]]["values"][one]) for one in request.names])
"""
_UTILITIES = """
from types import SimpleNamespace as S
from rclpy import R
def header(number): return S(stamp=S(sec=1, nanosec=number), frame_id="")
class Description:
    def __init__(self, data): self.data = data
    @staticmethod
    def messages(name): return [S(**one) for one in R["robot_description"].get(name, [])]
class JointState:
    @staticmethod
    def messages(name):
        sent = R["joint_states"].get(name, {})
        values = {"velocity": [], "effort": [], **(sent.get("last") or {})}
        return [S(**{**values, "header": header(number)}) for number in range(sent.get("count", 0))]
class Others:
    @staticmethod
    def messages(name): return []
String, DynamicJointState, TFMessage, DiagnosticArray, Clock = Description, Others, Others, Others, Others
"""
_PACKAGES = ("std_msgs", "sensor_msgs", "control_msgs", "tf2_msgs", "diagnostic_msgs", "rosgraph_msgs")


def write_fake_ros(folder: Path) -> None:
    """Write the modules to a folder for PYTHONPATH; FAKE_SYSTEM names the recording that they answer from."""
    files = {
        "rclpy/__init__.py": _RCLPY,
        "rclpy/qos.py": _QOS,
        "fake_message.py": _MESSAGE,
        "controller_manager_msgs/__init__.py": "",
        "controller_manager_msgs/srv.py": _SERVICES,
        "rcl_interfaces/__init__.py": "",
        "rcl_interfaces/srv.py": _PARAMETERS,
        **{f"{package}/__init__.py": "" for package in _PACKAGES},
        **{f"{package}/msg.py": _UTILITIES for package in _PACKAGES},
    }
    for name, text in files.items():
        path = folder / name
        path.parent.mkdir(parents=True, exist_ok=True)
        path.write_text(text, encoding="utf-8")
