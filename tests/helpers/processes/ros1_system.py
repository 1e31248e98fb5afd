"""A small ROS 1 system that really runs: a master, and one node that publishes what a test wants."""

from __future__ import annotations

import json
import os
import socket
import subprocess
import time
from pathlib import Path
from types import TracebackType
from typing import TYPE_CHECKING, Any

if TYPE_CHECKING:
    from typing_extensions import Self

PYTHON = Path("/usr/bin/python3")
"""That of the Debian packages of ROS 1."""
_LONGEST = 30.0
_IMPORTS = "import rospy, rosgraph, roscpp.srv, roslib.message, sensor_msgs.msg, tf2_msgs.msg, std_msgs.msg"
_NODE = """
import json, sys
import rospy, roscpp.srv
from geometry_msgs.msg import TransformStamped
from sensor_msgs.msg import JointState
from std_msgs.msg import Float64MultiArray
from tf2_msgs.msg import TFMessage
wanted = json.load(open(sys.argv[1]))
for name, value in wanted["parameters"].items():
    rospy.set_param(name, value)
rospy.init_node("hardware")
service = rospy.Service("/controller_manager/list_controllers", roscpp.srv.Empty, lambda _: roscpp.srv.EmptyResponse())
states = rospy.Publisher("/joint_states", JointState, queue_size=10)
frames = rospy.Publisher("/tf", TFMessage, queue_size=10)
commands = rospy.Subscriber("/head/command", Float64MultiArray, lambda _: None)
others = [rospy.Publisher(name, Float64MultiArray, queue_size=1) for name in wanted["commands"]]
rate = rospy.Rate(50)
while not rospy.is_shutdown():
    now = rospy.Time.now()
    message = JointState(name=wanted["joints"], position=[float(one) for one in wanted["positions"]])
    message.header.stamp = now
    states.publish(message)
    for parent, child in wanted["frames"]:
        one = TransformStamped(child_frame_id=child)
        one.header.frame_id, one.header.stamp = parent, now
        frames.publish(TFMessage([one]))
    rate.sleep()
"""


def is_installed() -> bool:
    """Return whether the Debian packages of ROS 1 are there."""
    if not PYTHON.exists() or not Path("/usr/bin/rosmaster").exists():
        return False
    return subprocess.run([PYTHON, "-c", _IMPORTS], capture_output=True, check=False).returncode == 0


class Ros1System:
    """A master and a node, which end with the block. wanted: what the node publishes and sets."""

    def __init__(self, folder: Path, wanted: dict[str, Any]) -> None:
        self.folder, self.wanted = folder, wanted
        with socket.socket() as free:
            free.bind(("127.0.0.1", 0))
            self.port = free.getsockname()[1]
        self.processes: list[subprocess.Popen[bytes]] = []

    @property
    def environ(self) -> dict[str, str]:
        """The environment in which this system is the one that runs."""
        own = {"ROS_MASTER_URI": f"http://127.0.0.1:{self.port}", "ROS_IP": "127.0.0.1", "ROS_VERSION": "1"}
        return {**own, "ROS_HOME": str(self.folder / "home"), "PATH": f"/usr/bin:{os.environ['PATH']}"}

    def __enter__(self) -> Self:
        (self.folder / "node.py").write_text(_NODE)
        (self.folder / "wanted.json").write_text(json.dumps(self.wanted))
        self._start("/usr/bin/rosmaster", "--core", "-p", str(self.port))
        self._wait_for("getPid()", "")
        self._start("node.py", "wanted.json")
        self._wait_for("getSystemState()", "list_controllers")
        return self

    def __exit__(self, kind: type[BaseException] | None, _: BaseException | None, __: TracebackType | None) -> None:
        for process in reversed(self.processes):
            process.kill()
            process.wait()

    def _start(self, *words: str) -> None:
        environ = {**os.environ, **self.environ, "PYTHONPATH": ""}
        with (self.folder / "ros.log").open("ab") as log:
            self.processes.append(
                subprocess.Popen([PYTHON, *words], cwd=self.folder, env=environ, stdout=log, stderr=log)
            )

    def _wait_for(self, question: str, text: str) -> None:
        ends_at = time.monotonic() + _LONGEST
        while time.monotonic() < ends_at:
            answer = self.asked(question)
            if answer and text in answer:
                return
            time.sleep(0.2)

    def asked(self, question: str) -> str:
        """Return the answer of the master; empty if it does not answer yet."""
        code = f"import rosgraph; print(rosgraph.Master('/test').{question})"
        environ = {**os.environ, **self.environ, "PYTHONPATH": ""}
        ran = subprocess.run([PYTHON, "-c", code], env=environ, capture_output=True, text=True, check=False)
        return ran.stdout
