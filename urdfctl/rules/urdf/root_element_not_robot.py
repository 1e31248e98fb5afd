"""UC101."""

from __future__ import annotations

from collections.abc import Iterator

from urdfctl.rule import Finding, Project, Severity, rule


@rule(
    "UC101",
    severity=Severity.ERROR,
    runtime="refuses",
    authority="urdfdom urdf_parser/src/model.cpp parseURDF(): \"Could not find the 'robot' element in the xml file\"",
    whole_robot=True,
    bad={
        "robot.urdf": """
            «<Robot name="arm">»
              <link name="base"/>
            </Robot>
            <!-- <robot -->
        """,
    },
    good={
        "robot.urdf": """
            <robot name="arm">
              <link name="base"/>
            </robot>
        """,
    },
)
def root_element_not_robot(project: Project) -> Iterator[Finding]:
    """Root element is not <robot>.

    urdfdom looks for exactly <robot>, and rejects a description with any other root element.
    """
    robot = project.robot
    if robot is not None and robot.element != "robot":
        yield Finding(robot.at, f"root element is <{robot.element}>; it must be <robot>")
