"""UC403."""

from __future__ import annotations

import re
from collections.abc import Iterator

from urdfctl.catalog.distros import ROS2
from urdfctl.control.parameters.readers import controllers_in
from urdfctl.model.controllers import FaultKind, Key
from urdfctl.rule import Finding, Project, Severity, Stage, rule
from urdfctl.rules.common import replaced
from urdfctl.rules.controllers.common import is_judged
from urdfctl.source.span import Place

_RIGHT = "ros__parameters"
_MEANT = ("rosparameters", "rosparameter", "rosparams", "rosparam", "parameters", "params")


@rule(
    "UC403",
    stage=Stage.PARAMETERS,
    severity=Severity.ERROR,
    runtime="refuses",
    distros=ROS2,
    authority="rcl rcl_yaml_param_parser/src/parse.c: 'Cannot have a value before ros__parameters at line 3'",
    options=["--distro=jazzy"],
    bad=[
        {
            "controllers.yaml": """
                controller_manager:
                  «ros_parameters»:
                    update_rate: 100
                    arm: {type: forward_command_controller/ForwardCommandController}
                arm:
                  ros__parameters:
                    joints: [shoulder, elbow]
                    interface_name: position
            """
        },
        {
            "controllers.yaml": """
                controller_manager:
                  «ros__parameter»:
                    update_rate: 100
            """,
        },
        {
            "controllers.yaml": """
                controller_manager:
                  «rosparameter»:
                    update_rate: 100
            """,
        },
        {
            "controllers.yaml": """
                controller_manager:
                  «rosparams»:
                    update_rate: 100
            """,
        },
        {
            "controllers.yaml": """
                controller_manager:
                  «ros_param»:
                    update_rate: 100
            """,
        },
        {
            "controllers.yaml": """
                controller_manager:
                  «parameters»:
                    update_rate: 100
            """,
        },
        {
            "controllers.yaml": """
                controller_manager:
                  «params»:
                    update_rate: 100
            """,
        },
        {
            "controllers.yaml": """
                «controller_manager»:
                  update_rate: 100
            """,
        },
    ],
    good=[
        {
            "controllers.yaml": """
                controller_manager:
                  ros__parameters:
                    update_rate: 100
                    arm: {type: forward_command_controller/ForwardCommandController}
                arm:
                  ros__parameters:
                    joints: [shoulder, elbow]
                    interface_name: position
            """
        },
    ],
)
def ros_parameters_missing(project: Project) -> Iterator[Finding]:
    """Missing or misspelt `ros__parameters` (two underscores).

    ROS 2 rejects the whole file. The node that gets it, usually the controller manager, exits at once. A key without a
    value, e.g. a section that is still empty, is rejected too.
    """
    controllers = controllers_in(project)
    of_ros1 = {file.path for file in controllers.files if file.form == 1}  # UC401 reports them
    reported: set[Place] = set()
    for fault in controllers.faults:
        if fault.kind is not FaultKind.OUTSIDE_PARAMETERS or fault.at.source.path in of_ros1:
            continue
        slip = next((key for key in fault.keys if _is_meant(key.text)), None)
        is_certain = is_judged(project, fault.at.source.path) or (slip is not None and "ros" in slip.text)
        key = slip or (fault.keys[0] if fault.keys else Key(fault.subject, fault.at))
        if key.at in reported or not is_certain:
            continue
        reported.add(key.at)
        if slip:
            message = f"'{slip.text}' should be '{_RIGHT}' (two underscores, plural); ROS 2 rejects the file"
            yield Finding(slip.at, message, fix=replaced(slip.at, slip.text, _RIGHT, safe=True))
        else:
            message = f"'{_RIGHT}:' is missing between '{key.text}' and its contents; ROS 2 rejects the file"
            yield Finding(key.at, message)


def _is_meant(text: str) -> bool:
    return re.sub("[^a-z]", "", text.lower()) in _MEANT
