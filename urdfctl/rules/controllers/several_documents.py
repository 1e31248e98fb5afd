"""UC413."""

from __future__ import annotations

from collections.abc import Iterator

from urdfctl.catalog.distros import ROS1
from urdfctl.model.controllers import FaultKind
from urdfctl.rule import Finding, Project, Severity, Stage, rule
from urdfctl.rules.controllers.common import faults


@rule(
    "UC413",
    stage=Stage.PARAMETERS,
    severity=Severity.ERROR,
    runtime="refuses",
    distros=ROS1,
    authority="ros_comm roslaunch/src/roslaunch/loader.py: yaml.safe_load, 'expected a single document in the stream'",
    options=["--distro=noetic"],
    bad=[
        {
            "controllers.yaml": """
                joint_states:
                  type: joint_state_controller/JointStateController
                  publish_rate: 50
                ---
                «arm:
                  type: position_controllers/JointGroupPositionController
                  joints: [shoulder, elbow]»
            """
        },
    ],
    good=[
        {
            "controllers.yaml": """
                joint_states:
                  type: joint_state_controller/JointStateController
                  publish_rate: 50
                arm:
                  type: position_controllers/JointGroupPositionController
                  joints: [shoulder, elbow]
            """
        },
    ],
)
def several_documents(project: Project) -> Iterator[Finding]:
    """Several YAML documents in a ROS 1 file.

    roslaunch reads only one document and rejects a file with more: remove the line `---`.
    """
    for fault in faults(project, FaultKind.DOCUMENTS):
        yield Finding(fault.at, "second YAML document in a file; roslaunch rejects it. Remove the '---' before it")
