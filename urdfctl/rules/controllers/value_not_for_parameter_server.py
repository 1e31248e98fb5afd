"""UC414."""

from __future__ import annotations

from collections.abc import Iterator

from urdfctl.catalog.distros import ROS1
from urdfctl.model.controllers import Fault, FaultKind
from urdfctl.rule import Finding, Project, Severity, rule
from urdfctl.rules.controllers.common import faults


@rule(
    "UC414",
    severity=Severity.ERROR,
    distros=ROS1,
    authority="ros_comm roslaunch over XML-RPC: 'int exceeds XML-RPC limits', 'dictionary key must be string', "
    "'cannot marshal <type 'datetime.date'> objects'",
    options=["--distro=noetic"],
    bad={
        "controllers.yaml": """
            arm:
              type: position_controllers/JointGroupPositionController
              joints: [shoulder, elbow]
              serial_number: «20260101123456»
        """
    },
    good={
        "controllers.yaml": """
            arm:
              type: position_controllers/JointGroupPositionController
              joints: [shoulder, elbow]
              serial_number: '20260101123456'
        """
    },
)
def value_not_for_parameter_server(project: Project) -> Iterator[Finding]:
    """ROS 1's parameter server cannot hold a value or a key.

    It takes integers of 32 bits, numbers, booleans, texts, lists, and maps whose keys are texts. roslaunch ends with an
    error at others: dates, larger integers, keys such as `1` or `on`.
    """
    for fault in faults(project, FaultKind.OVERFLOW, FaultKind.UNUSABLE, FaultKind.KEY):
        yield Finding(fault.at, _message(fault))


def _message(fault: Fault) -> str:
    if fault.kind is FaultKind.OVERFLOW:
        return f"'{fault.at.span.text}' does not fit into 32 bits, which is all that ROS 1's integers have; quote it"
    if fault.kind is FaultKind.KEY:
        return f"the key '{fault.subject}' is no text to YAML, and ROS 1 takes no other keys; quote it"
    return f"'{fault.at.span.text}' is nothing that ROS 1's parameter server can hold; quote it to make it a text"
