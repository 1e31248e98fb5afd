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
    runtime="refuses",
    distros=JAZZY,
    authority="measured with jazzy's controller manager, which gives each component a node of that name: \"Couldn't "
    "parse remap rule: '-r __node:=my arm'\"",
    options=["--distro=jazzy"],
    bad=[
        {
            "robot.urdf": """
                <ros2_control name="«my arm»" type="system">
                  <hardware><plugin>mock_components/GenericSystem</plugin></hardware>
                  <joint name="elbow"><command_interface name="position"/><state_interface name="position"/></joint>
                </ros2_control>
            """,
        },
    ],
    good=[
        {
            "robot.urdf": """
                <ros2_control name="my_arm" type="system">
                  <hardware><plugin>mock_components/GenericSystem</plugin></hardware>
                  <joint name="elbow"><command_interface name="position"/><state_interface name="position"/></joint>
                </ros2_control>
            """,
        },
    ],
)
def component_name_unusable(project: Project) -> Iterator[Finding]:
    """Component name is not a valid node name.

    Since jazzy, each component has a node of the same name. A node name has ASCII letters, digits and underscores, at
    most 255 characters, and no leading digit. With any other name the component is not initialized, and the description
    is rejected.
    """
    for control in components(project):
        name = control.name
        if (
            name is None
            or not is_known(name)
            or (re.fullmatch(_NODE_NAME, name.strip()) and len(name.strip()) <= _LONGEST)
        ):
            continue
        at, valid = control.at["name"], _corrected(name)
        what = f"component name '{name}' is not a valid node name"
        if not name.strip() or len(name) > _LONGEST:
            what = "component name is empty" if not name.strip() else f"component name has {len(name)} characters"
        fix = replaced(at, name, valid) if valid else None
        message = f"{what}; use at most {_LONGEST} letters, digits and underscores, and no leading digit"
        yield Finding(at, message, fix=fix, severity=severity_where(project, JAZZY))


def _corrected(name: str) -> str | None:
    valid = re.sub(r"[^A-Za-z0-9_/]+", "_", name.strip()).strip("_")[:_LONGEST]
    return valid if re.fullmatch(_NODE_NAME, valid) and "$" not in name else None
