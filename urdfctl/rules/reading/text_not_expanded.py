"""UC033."""

from __future__ import annotations

import re
from collections.abc import Iterator

from urdfctl.control.parameters.readers import controllers_in
from urdfctl.model.controllers import FaultKind
from urdfctl.rule import Finding, Note, Project, Severity, Stage, rule
from urdfctl.rules.launch_samples import ARM, BROADCASTER, CONTROLLERS, MANAGER, PUBLISHER, SOUND, launched

ROS_2 = 2
_BRACES = re.compile(r"\$\{[^{}]*\}")
_ANY_OF_ROS2 = re.compile(r"\$\((?:arg|var|env|eval|find|find-pkg-share|find-pkg-prefix|dirname|command)\b[^()]*\)")
_ANY_OF_ROS1 = re.compile(r"\$\((?:arg|find|env|optenv|eval|anon|dirname)\b[^()]*\)")
_EVALUATES = r"allow_substs|subst_value|RewrittenYaml|ReplaceString|IncludeLaunchDescription|<include|include:"
"""What says that a launch file may evaluate a parameter file, or include one that does."""
_NAMES = ("joint", "wheel", "interface")


@rule(
    "UC033",
    severity=Severity.WARNING,
    runtime="misbehaves",
    stage=Stage.ACTIVATE,
    authority="rcl rcl_yaml_param_parser/src/parse.c and rosparam load_file() read values as they are; roslaunch evaluates "
    '$(...) with subst_value="true", launch_ros with allow_substs, and nothing evaluates ${...}',
    bad=[
        launched(
            PUBLISHER,
            MANAGER,
            BROADCASTER,
            ARM,
            controllers=CONTROLLERS.replace("joints: [shoulder, elbow]", 'joints: [«"${prefix}shoulder"», elbow]'),
        ),
        {
            "robot.urdf": "",
            "controllers.yaml": """
                controller_manager:
                  ros__parameters:
                    update_rate: 100
                    arm: {type: position_controllers/JointGroupPositionController}
                    base: {type: diff_drive_controller/DiffDriveController}
                arm:
                  ros__parameters: {joints: [elbow], interface_name: «"${kind}"»}
                base:
                  ros__parameters: {left_wheel_names: [«"${side}wheel"»], right_wheel_names: [shoulder], base_frame_id: «"${side}base"»}
            """,
        },
        {
            "robot.urdf": "",
            "controllers.yaml": """
                controller_manager:
                  ros__parameters:
                    update_rate: 100
                    arm: {type: position_controllers/JointGroupPositionController}
                arm:
                  ros__parameters: {joints: [«"$(var prefix)elbow"»]}
            """,
            "options": "--distro=jazzy",
        },
    ],
    good=[
        SOUND,
        {
            **launched(
                PUBLISHER,
                MANAGER,
                BROADCASTER,
                ARM,
                controllers=CONTROLLERS.replace("joints: [shoulder, elbow]", 'joints: ["${prefix}shoulder", elbow]'),
            ),
            "write.sh": "sed 's/${prefix}/left_/' controllers.yaml > left.yaml\n",
        },
    ],
)
def text_not_expanded(project: Project) -> Iterator[Finding]:
    """Expression in a controller file that nothing expands.

    xacro does not read controller files, and `$(arg x)` is text in a YAML file unless the launch file asks for its
    evaluation. The node gets the text as it is. In a name of a joint, wheel or interface this is an error: the robot has
    none of that name.
    """
    launch = project.launch
    if launch is None:
        yield from _without_launch(project)
        return
    loads = launch.loads if launch else ()
    evaluated = {load.file.path for load in loads if load.substituted or load.rewriting.texts}
    loaded = {load.file.path: load.at for load in loads if load.sure}
    read = _read(project)
    for fault in controllers_in(project).faults:
        at = fault.at
        if (
            fault.kind is not FaultKind.UNEXPANDED
            or at.source.path not in loaded
            or (at.source.path, at.start) not in read
        ):
            continue
        text = fault.at.span.text
        found = _BRACES.search(text)
        if found is None and fault.at.source.path not in evaluated:
            found = (_ANY_OF_ROS1 if launch and launch.ros == 1 else _ANY_OF_ROS2).search(text)
        if found and not _is_replaced(project, found[0]):
            severity = Severity.ERROR if any(name in fault.subject for name in _NAMES) else None
            message = f"'{found[0]}' in '{fault.subject}' is not expanded: nothing evaluates it in a controller file"
            yield Finding(at, message, (Note("the file is loaded here", loaded[at.source.path]),), severity=severity)


def _without_launch(project: Project) -> Iterator[Finding]:
    """Yield the findings on `${...}`, which no launch file evaluates either. Without a robot, a script may fill it in.

    `$(...)` is told too, as a warning, if nothing in the workspace asks for its evaluation, nor includes what may.
    """
    read = _read(project)
    for fault in controllers_in(project).faults:
        if fault.kind is not FaultKind.UNEXPANDED:
            continue
        text = fault.at.span.text
        found = _BRACES.search(text)
        left = _ANY_OF_ROS2.search(text) if found is None and project.ros == ROS_2 else None
        if left and (fault.at.source.path, fault.at.start) in read and not project.may_mention(_EVALUATES):
            message = f"'{left[0]}' in '{fault.subject}' is not expanded unless a launch file loads the file with allow_substs"
            yield Finding(fault.at, message, severity=Severity.WARNING)
        if found and (fault.at.source.path, fault.at.start) in read and not _is_replaced(project, found[0]):
            message = f"'{found[0]}' in '{fault.subject}' is not expanded: nothing evaluates it in a controller file"
            is_name = project.robot is not None and any(name in fault.subject for name in _NAMES)
            yield Finding(fault.at, message, severity=Severity.ERROR if is_name else Severity.WARNING)


def _is_replaced(project: Project, expression: str) -> bool:
    """Whether a program or script of the workspace replaces an expression in a text: in what it writes a file from."""
    return project.mentioned(rf"(?:replace|sub|sed)\b[^\n]{{0,60}}{re.escape(expression)}") is True


def _read(project: Project) -> set[tuple[str, int]]:
    """The places of the values that the manager and the started controllers get; of all if it is unknown which start."""
    controllers, started = controllers_in(project), project.started
    names = None if started is None else {name.rpartition("/")[2] for name in started}
    owners = [one.own for one in controllers.controllers if names is None or one.name in names]
    owners += [one.own for one in controllers.managers]
    values = [item for own in owners for leaf in own.leaves for item in (leaf.value, *leaf.value.items)]
    return {(value.at.source.path, value.at.start) for value in values}
