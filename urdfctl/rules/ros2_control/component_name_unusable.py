"""UC311."""

from __future__ import annotations

import re
from collections.abc import Iterator

from urdfctl.rule import Finding, Project, Severity, rule
from urdfctl.rules.common import is_known, replaced, severity_where
from urdfctl.rules.ros2_control.common import JAZZY, components

_NODE_NAME = r"[A-Za-z_/][A-Za-z0-9_/]*"
_LONGEST = 255


@rule(
    "UC311",
    severity=Severity.ERROR,
    distros=JAZZY,
    authority="measured with jazzy's controller manager, which gives each component a node of that name: \"Couldn't "
    "parse remap rule: '-r __node:=my arm'\"",
    options=["--distro=jazzy"],
    bad={
        "robot.urdf": """
            <ros2_control name="«my arm»" type="system">
              <hardware><plugin>mock_components/GenericSystem</plugin></hardware>
              <joint name="elbow"><command_interface name="position"/><state_interface name="position"/></joint>
            </ros2_control>
        """,
    },
    good={
        "robot.urdf": """
            <ros2_control name="my_arm" type="system">
              <hardware><plugin>mock_components/GenericSystem</plugin></hardware>
              <joint name="elbow"><command_interface name="position"/><state_interface name="position"/></joint>
            </ros2_control>
        """,
    },
)
def component_name_unusable(project: Project) -> Iterator[Finding]:
    """A component's name is none that a node can have.

    From jazzy on each component has a node of its own, called like it: letters, digits and underscores of ASCII, no
    digit in front, 255 at most. With any other name the component is not initialized, and the description is refused.
    """
    for control in components(project):
        name = control.name
        if (
            name is None
            or not is_known(name)
            or (re.fullmatch(_NODE_NAME, name.strip()) and len(name.strip()) <= _LONGEST)
        ):
            continue
        at, right = control.at["name"], _mended(name)
        what = f"'{name}' cannot name a component"
        if not name.strip() or len(name) > _LONGEST:
            what = (
                "the name of a component is empty"
                if not name.strip()
                else f"a component's name has {len(name)} characters"
            )
        fix = replaced(at, name, right) if right else None
        message = f"{what}: it becomes a node's, of letters, digits and underscores, {_LONGEST} at most"
        yield Finding(at, message, fix=fix, severity=severity_where(project, JAZZY))


def _mended(name: str) -> str | None:
    right = re.sub(r"[^A-Za-z0-9_/]+", "_", name.strip()).strip("_")[:_LONGEST]
    return right if re.fullmatch(_NODE_NAME, right) and "$" not in name else None
