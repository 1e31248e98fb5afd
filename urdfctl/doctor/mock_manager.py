"""Start the real ros2_control_node with mock hardware, and its controllers: a script for the Python in which ROS 2 is
sourced. It needs nothing of urdfctl.

    python3 mock_manager.py < plan.json > result.json

plan: {manager, description, files: [text], controllers: [{name, activate}]}
result: {answers, stages: {controller: the last stage that it passed, or ""}, log}

What runs is a system of its own: it has a domain and a temporary folder for itself, and ends with the script.
"""

from __future__ import annotations

import contextlib
import json
import os
import random
import signal
import subprocess
import sys
import tempfile
import time
from typing import Any

START = 20.0
"""Seconds in which the manager must offer its services."""
ANSWER = 10.0
"""Seconds that each service has for its answer; the manager itself gives up after 5 s."""
STRICT = 2
"""SwitchController: fail unless all controllers can be switched."""
OLD = ("foxy", "galactic", "humble", "iron")
"""Distros whose manager takes the description as a parameter, or can."""


class MockManager:
    """A manager that runs, and the questions to it."""

    def __init__(self, rclpy: Any, node: Any, name: str, process: subprocess.Popen[bytes]) -> None:
        self.rclpy, self.node, self.name, self.process = rclpy, node, name, process

    def ask(self, service: str, kind: str, longest: float, **fields: object) -> Any:
        """Return the response of a service. Raises TimeoutError if it does not answer in time, or has ended."""
        import controller_manager_msgs.srv

        service_type = getattr(controller_manager_msgs.srv, kind)
        client = self.node.create_client(service_type, f"{self.name}/{service}")
        request = service_type.Request()
        for field, value in fields.items():
            if hasattr(request, field):
                setattr(request, field, value)
        try:
            until, future = time.monotonic() + longest, None
            while time.monotonic() < until and self.process.poll() is None:
                if future is None and client.service_is_ready():
                    future = client.call_async(request)
                self.rclpy.spin_once(self.node, timeout_sec=0.05)
                if future is not None and future.done():
                    return future.result()
        finally:
            self.node.destroy_client(client)
        raise TimeoutError(f"{service} does not answer")

    def stage_of(self, controller: dict[str, Any]) -> str:
        """Take a controller through its lifecycle, and return the last stage that it passed."""
        name, passed = controller["name"], ""
        steps: list[tuple[str, str, str, dict[str, object]]] = [
            ("load", "load_controller", "LoadController", {"name": name}),
            ("configure", "configure_controller", "ConfigureController", {"name": name}),
        ]
        if controller["activate"]:
            one = {"activate_controllers": [name], "start_controllers": [name], "strictness": STRICT}
            steps.append(("activate", "switch_controller", "SwitchController", {**one}))
        for stage, service, kind, fields in steps:
            try:
                if not self.ask(service, kind, ANSWER, **fields).ok:
                    break
            except TimeoutError:
                break
            passed = stage
        return passed


def started(plan: dict[str, Any], folder: str) -> subprocess.Popen[bytes]:
    """Start the manager in a folder of its own."""
    namespace, _, name = plan["manager"].rpartition("/")
    words = ["ros2", "run", "controller_manager", "ros2_control_node", "--ros-args", "-r", f"__node:={name}"]
    if namespace:
        words += ["-r", f"__ns:={namespace}"]
    words += ["-r", f"{plan['manager']}/robot_description:={namespace}/robot_description"]
    texts = list(plan["files"])
    if os.environ.get("ROS_DISTRO") in OLD:
        texts.append(json.dumps({"/**": {"ros__parameters": {"robot_description": plan["description"]}}}))
    for number, text in enumerate(texts):
        path = os.path.join(folder, f"{number}.yaml")
        with open(path, "w", encoding="utf-8") as file:
            file.write(text)
        words += ["--params-file", path]
    words += ["-p", "use_sim_time:=false"]
    with open(os.path.join(folder, "log"), "wb") as log:
        return subprocess.Popen(  # noqa: S603 (ROS's own program, with files of ours)
            words, stdout=log, stderr=log, cwd=folder, start_new_session=True
        )


def result_of(plan: dict[str, Any], rclpy: Any, folder: str) -> dict[str, object]:
    """Return how far the manager and its controllers came."""
    from rclpy.qos import DurabilityPolicy, QoSProfile
    from std_msgs.msg import String

    process = started(plan, folder)
    rclpy.init()
    node = rclpy.create_node("urdfctl_smoke")
    found: dict[str, object] = {"answers": False, "stages": {}}
    try:
        topic = f"{plan['manager'].rpartition('/')[0]}/robot_description"
        qos = QoSProfile(depth=1, durability=DurabilityPolicy.TRANSIENT_LOCAL)
        node.create_publisher(String, topic, qos).publish(String(data=plan["description"]))
        manager = MockManager(rclpy, node, plan["manager"], process)
        try:
            manager.ask("list_controllers", "ListControllers", START)
        except TimeoutError:
            return found
        stages = {controller["name"]: manager.stage_of(controller) for controller in plan["controllers"]}
        return {"answers": True, "stages": stages}
    finally:
        with contextlib.suppress(ProcessLookupError):
            if sys.platform == "win32":
                process.kill()
            else:
                os.killpg(process.pid, signal.SIGKILL)
        process.wait()
        node.destroy_node()
        rclpy.shutdown()


def main() -> int:
    """Print the result, and return the exit status: 2 if ROS 2 is not sourced."""
    os.environ["ROS_DOMAIN_ID"] = str(random.randint(60, 100))  # noqa: S311 (to be alone, not secret)
    os.environ["ROS_LOCALHOST_ONLY"] = "1"
    os.environ["ROS_AUTOMATIC_DISCOVERY_RANGE"] = "LOCALHOST"
    try:
        import controller_manager_msgs.srv  # noqa: F401
        import rclpy
    except ImportError as error:
        sys.stderr.write(f"ROS 2 is not sourced in this Python ({sys.prefix}): {error}\n")
        return 2
    with tempfile.TemporaryDirectory(prefix="urdfctl-smoke-") as folder:
        try:
            found = result_of(json.load(sys.stdin), rclpy, folder)
        except OSError as error:
            sys.stderr.write(f"ros2_control_node cannot be started: {error}\n")
            return 1
        with open(os.path.join(folder, "log"), encoding="utf-8", errors="replace") as file:
            found["log"] = file.read()
    json.dump(found, sys.stdout)
    return 0


if __name__ == "__main__":
    sys.exit(main())
