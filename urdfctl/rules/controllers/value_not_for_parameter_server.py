"""UC414."""

from __future__ import annotations

from collections.abc import Iterator

from urdfctl.catalog.distros import ROS1
from urdfctl.model.controllers import FaultKind, FileFault
from urdfctl.rule import Finding, Project, Severity, Stage, rule
from urdfctl.rules.controllers.common import faults


@rule(
    "UC414",
    stage=Stage.PARAMETERS,
    severity=Severity.ERROR,
    runtime="refuses",
    distros=ROS1,
    authority="ros_comm roslaunch over XML-RPC: 'int exceeds XML-RPC limits', 'dictionary key must be string', "
    "'cannot marshal <type 'datetime.date'> objects'",
    options=["--distro=noetic"],
    bad=[
        {
            "controllers.yaml": """
                arm:
                  type: position_controllers/JointGroupPositionController
                  joints: [shoulder, elbow]
                  serial_number: «20260101123456»
            """
        },
    ],
    good=[
        {
            "controllers.yaml": """
                arm:
                  type: position_controllers/JointGroupPositionController
                  joints: [shoulder, elbow]
                  serial_number: '20260101123456'
            """
        },
    ],
)
def value_not_for_parameter_server(project: Project) -> Iterator[Finding]:
    """Value or key that the ROS 1 parameter server does not support.

    It supports 32-bit integers, numbers, booleans, strings, lists, and maps with string keys. roslaunch exits with an
    error on other values: dates, larger integers, keys such as `1` or `on`.
    """
    for fault in faults(project, FaultKind.OVERFLOW, FaultKind.UNUSABLE, FaultKind.KEY):
        yield Finding(fault.at, _message(fault))


def _message(fault: FileFault) -> str:
    if fault.kind is FaultKind.OVERFLOW:
        return f"integer '{fault.at.span.text}' exceeds the 32 bits of a ROS 1 integer; quote it to make it a string"
    if fault.kind is FaultKind.KEY:
        return f"key '{fault.subject}' is not a string in YAML, but ROS 1 requires string keys; quote it"
    return f"ROS 1's parameter server cannot store '{fault.at.span.text}'; quote it to make it a string"
