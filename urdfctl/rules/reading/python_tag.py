"""UC032."""

from __future__ import annotations

from collections.abc import Iterator

from urdfctl.catalog.distros import ROS2, since
from urdfctl.control.readers import controllers_in
from urdfctl.model.controllers import FaultKind
from urdfctl.rule import Finding, Project, Severity, rule

_BY_PYTHON = since("jazzy")


@rule(
    "UC032",
    severity=Severity.WARNING,
    runtime="ignores",
    distros=ROS2,
    authority="rcl rcl_yaml_param_parser/src/parse.c ignores tags; ros2_control controller_manager/"
    "controller_manager_services.py reads --param-file with yaml.safe_load(): 'could not determine a constructor for the "
    "tag'",
    options=["--distro=jazzy"],
    bad={
        "controllers.yaml": """
            controller_manager:
              ros__parameters:
                update_rate: 100
                arm: {type: forward_command_controller/ForwardCommandController}
            arm:
              ros__parameters:
                joints: «!!python/tuple [shoulder, elbow]»
                interface_name: position
        """
    },
    good={
        "controllers.yaml": """
            controller_manager:
              ros__parameters:
                update_rate: 100
                arm: {type: forward_command_controller/ForwardCommandController}
            arm:
              ros__parameters:
                joints: !!seq [shoulder, elbow]
                interface_name: !!str position
        """
    },
)
def python_tag(project: Project) -> Iterator[Finding]:
    """Tag in a controller file that makes a Python object.

    The nodes of ROS 2 ignore the tag and read the value as if it were not there. Since jazzy the spawner reads its
    `--param-file` with Python's safe reader, which rejects the whole file; then this is an error.
    """
    launch = project.launch
    spawners = launch.spawns if launch else ()
    by_python = {file.path for spawn in spawners for file in spawn.files if spawn.sure}
    is_new = set(project.distros) <= set(_BY_PYTHON)
    for fault in controllers_in(project).faults:
        if fault.kind is not FaultKind.PYTHON_TAG:
            continue
        tag = fault.at.span.text.split(maxsplit=1)[0]
        is_read = is_new and fault.at.source.path in by_python
        effect = "the spawner rejects the file" if is_read else "ROS 2 ignores it"
        message = f"'{tag}' makes a Python object; {effect}. Remove the tag"
        yield Finding(fault.at, message, severity=Severity.ERROR if is_read else None)
