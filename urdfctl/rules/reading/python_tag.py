"""UC032."""

from __future__ import annotations

from collections.abc import Iterator

from urdfctl.catalog.distros import ROS1, since
from urdfctl.model.controllers import FaultKind
from urdfctl.rule import Finding, Project, Severity, rule
from urdfctl.source.problem import ProblemKind

_BY_PYTHON = since("jazzy")


@rule(
    "UC032",
    severity=Severity.WARNING,
    runtime="ignores",
    authority="rcl rcl_yaml_param_parser/src/parse.c ignores tags; ros2_control controller_manager/"
    "controller_manager_services.py, launch_yaml parser.py, moveit_configs_utils and roslaunch loader.py read with "
    "yaml.safe_load(): 'could not determine a constructor for the tag'",
    options=["--distro=jazzy"],
    bad=[
        {
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
                    joints: !!seq [shoulder, elbow]
                    interface_name: !!str position
            """
        },
    ],
)
def python_tag(project: Project) -> Iterator[Finding]:
    """Tag in a YAML file that makes a Python object.

    The nodes of ROS 2 ignore the tag and read the value as if it were not there. What is read with Python's safe reader
    is rejected as a whole, an error: files of ROS 1, launch files, MoveIt's files, and since jazzy the `--param-file` of
    a spawner. An unsafe reader, such as rosparam's until kinetic, runs whatever the tag names.
    """
    launch = project.launch
    spawners = launch.spawns if launch else ()
    by_python = {file.path for spawn in spawners for file in spawn.files if spawn.sure}
    is_new, is_ros1 = set(project.distros) <= set(_BY_PYTHON), set(project.distros) <= set(ROS1)
    told = set()
    for fault in project.controllers.faults if project.controllers else ():
        if fault.kind is not FaultKind.PYTHON_TAG:
            continue
        told.add((fault.at.source.path, fault.at.start))
        tag = fault.at.span.text.split(maxsplit=1)[0]
        is_read = is_ros1 or (is_new and fault.at.source.path in by_python)
        effect = "rosparam" if is_ros1 else "the spawner"
        effect = f"{effect} rejects the file" if is_read else "ROS 2 ignores it"
        message = f"'{tag}' makes a Python object; {effect}. Remove the tag"
        yield Finding(fault.at, message, severity=Severity.ERROR if is_read else None)
    for problem in project.of_kind(ProblemKind.PYTHON_TAG):
        if (problem.at.source.path, problem.at.start) not in told:
            yield Finding(problem.at, problem.message, severity=Severity.ERROR)
