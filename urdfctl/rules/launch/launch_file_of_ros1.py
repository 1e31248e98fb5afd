"""UC639."""

from __future__ import annotations

from collections.abc import Iterator

from urdfctl.rule import Finding, Note, Project, Severity, rule


def _files(node: str, build_type: str) -> dict[str, str]:
    return {
        "launch/arm.launch": f"""
            <launch>
              <param name="robot_description" textfile="$(find arm)/arm.urdf"/>
              {node}
            </launch>
        """,
        "arm.urdf": "",
        "package.xml": f"""
            <package format="3">
              <name>arm</name>
              <exec_depend>robot_state_publisher</exec_depend>
              {build_type}
            </package>
        """,
    }


_NODE = '<node name="publisher" pkg="robot_state_publisher" type="robot_state_publisher"/>'
_CATKIN = '<buildtool_depend condition="$ROS_VERSION == 1">catkin</buildtool_depend>'
_AMENT = "<export><build_type>ament_cmake</build_type></export>"


@rule(
    "UC639",
    severity=Severity.WARNING,
    runtime="refuses",
    because="it may be left over, and started by nobody",
    authority="launch_xml and launch_ros Node.parse(): \"Attribute 'exec' of type '<class 'str'>' not found in Entity 'node'\"",
    bad=[_files(f"«{_NODE}»", _AMENT)],
    good=[_files(_NODE, _CATKIN), _files(_NODE, _CATKIN + _AMENT)],
)
def launch_file_of_ros1(project: Project) -> Iterator[Finding]:
    """Launch file for ROS 1 in a package for ROS 2.

    `ros2 launch` refuses the file: in ROS 2, a `<node>` has `exec` and no `type`, and there is no `<rosparam>` and no
    `$(find ...)`. What exporters and older versions of the package leave behind is best removed. What else such a
    start shows is only worth knowing.
    """
    launch = project.launch
    if launch is None or not launch.is_leftover:
        return
    places = (*(node.at for node in launch.nodes), *(spawn.at for spawn in launch.spawns))
    at = next((at for at in places if at.source.path == launch.path), None)
    if at is not None and launch.package is not None:
        message = "launch file is written for ROS 1; 'ros2 launch' refuses it. Remove it, or migrate the package"
        yield Finding(at, message, (Note("the package is built for ROS 2", launch.package.at),))
