"""UC632."""

from __future__ import annotations

import re
from collections.abc import Iterator

from urdfctl.model.robot import Tag
from urdfctl.rule import Finding, Fix, Note, Project, Severity, rule
from urdfctl.rules.common import robot_in
from urdfctl.rules.launch.common import ROS_2, launch_of
from urdfctl.rules.launch_samples import ARM, BROADCASTER, MANAGER, ROBOT, launched
from urdfctl.source.span import Place

_COMMAND = "$(command 'xacro $(find-pkg-share arm)/arm.urdf')"
_PUBLISHER = f"""
      <node pkg="robot_state_publisher" exec="robot_state_publisher">
        <param name="robot_description" value="{_COMMAND}"/>
      </node>"""
_COMMENTED = ROBOT + "\n    <!-- note: tuned by hand -->"
_TYPED = _PUBLISHER.replace('"/>', '" type="str"/>')


@rule(
    "UC632",
    severity=Severity.ERROR,
    runtime="refuses",
    authority="launch_ros utilities/evaluate_parameters.py: a substitution without a type is passed to yaml.safe_load: "
    "'Unable to parse the value of parameter robot_description as yaml. If the parameter is meant to be a string, try "
    "wrapping it in launch_ros.parameter_descriptions.ParameterValue(value, value_type=str)'",
    bad=[launched(_PUBLISHER.replace(_COMMAND, f"«{_COMMAND}»"), MANAGER, BROADCASTER, ARM, robot=_COMMENTED)],
    good=[launched(_TYPED, MANAGER, BROADCASTER, ARM, robot=_COMMENTED)],
)
def description_read_as_yaml(project: Project) -> Iterator[Finding]:
    """Robot description is parsed as YAML, and is not valid YAML.

    Launch parses the output of a command as YAML unless its type is given. A colon followed by whitespace, in a comment
    or an attribute, then stops the launch. Without it, the same launch file works, so the fault appears with an edit of
    the description.
    """
    yield from _of_semantic(project)
    launch = launch_of(project, ROS_2)
    robot = robot_in(project)
    described = [each for each in launch.descriptions if each.as_yaml and each.sure] if launch else []
    own = [each for each in described if each.file.path == project.path]
    broken = _broken(robot.tag) if own and robot else None
    for place in dict.fromkeys(each.at for each in own) if broken else ():
        yield _finding(place, "robot description", broken)


def _of_semantic(project: Project) -> Iterator[Finding]:
    """Yield the finding on an SRDF that is passed without a type."""
    moveit = project.moveit
    files, semantic = (moveit.files, moveit.semantic) if moveit else (None, None)
    broken = _broken(semantic.tag) if files and files.sure and files.as_yaml and files.semantic and semantic else None
    if broken and files and files.semantic:
        yield _finding(files.semantic.at, "SRDF", broken)


def _finding(at: Place, what: str, broken: tuple[Place, str] | None) -> Finding:
    place, fault = broken or (at, "")
    is_python = at.source.path.endswith(".py")
    remedy = "wrap it in ParameterValue(..., value_type=str)" if is_python else 'add type="str"'
    message = f"launch parses this {what} as YAML and fails at {fault}; {remedy}"
    return Finding(at, message, (Note("the text is here", place),), Fix(remedy))


def _broken(root: Tag | None) -> tuple[Place, str] | None:
    """The first text that YAML does not accept in a description, and its name."""
    if root is None:
        return None
    for comment in root.comments():
        what = _of_text(comment.text)
        if what:
            return comment.at, f"{what} in a comment"
    pending = [root]
    while pending:
        tag = pending.pop()
        for name, value in tag.attributes.items():
            what = _of_text(value)
            if what:
                return tag.at[name], f"{what} in attribute '{name}'"
        pending += reversed(tag.children)
    return None


def _of_text(text: str) -> str:
    broken = re.search(r":(?:\s|\Z)|\s#", text)
    if broken is None:
        return ""
    return "a colon followed by whitespace" if ":" in broken.group() else "'#' after whitespace"
