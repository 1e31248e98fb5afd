"""UC101."""

from __future__ import annotations

from collections.abc import Iterator

from urdfctl.rule import Finding, Project, Severity, rule

_ROS2 = 2
_READS_SDF = "sdformat_urdf"


@rule(
    "UC101",
    severity=Severity.ERROR,
    runtime="refuses",
    authority="urdfdom urdf_parser/src/model.cpp parseURDF(): \"Could not find the 'robot' element in the xml file\"; "
    "sdformat_urdf: a plugin of urdf_parser_plugin, which urdf/src/model.cpp initString() asks in ROS 2",
    whole_robot=True,
    bad=[
        {
            "robot.urdf": """
                «<Robot name="arm">»
                  <link name="base"/>
                </Robot>
                <!-- <robot -->
            """,
        },
    ],
    good=[
        {
            "robot.urdf": """
                <robot name="arm">
                  <link name="base"/>
                </robot>
            """,
        },
    ],
)
def root_element_not_robot(project: Project) -> Iterator[Finding]:
    """Root element is not <robot>.

    urdfdom looks for exactly <robot>, and rejects a description with any other root element. In ROS 2,
    robot_state_publisher also reads SDF if package sdformat_urdf is installed: what a launch file gives it makes a
    warning. The controller manager does not.
    """
    robot = project.robot
    if robot is None or robot.element == "robot":
        return
    launch = project.launch
    if robot.element != "sdf" or project.ros != _ROS2 or launch is None or project.controllers is not None:
        yield Finding(robot.at, f"root element is <{robot.element}>; it must be <robot>")
    elif launch.package and launch.package.reaches(_READS_SDF):
        yield Finding(robot.at, "SDF is not checked", severity=Severity.INFO)
    else:
        message = f"the description is SDF: robot_state_publisher reads it only if package '{_READS_SDF}' is installed"
        yield Finding(robot.at, message, severity=Severity.WARNING)
