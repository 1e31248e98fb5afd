"""UC514."""

from __future__ import annotations

from collections.abc import Iterator

from urdfctl.catalog.hardware import PluginChild
from urdfctl.control.hardware.simulator_plugins import loaded_plugins
from urdfctl.model.robot import Tag
from urdfctl.rule import Finding, Project, Severity, rule
from urdfctl.rules.common import in_words, is_known
from urdfctl.rules.simulation.common import is_written_empty, number


@rule(
    "UC514",
    severity=Severity.WARNING,
    runtime="warns",
    authority="sdformat src/Param.cc: 'Invalid argument. Unable to set value', 'Unable to convert parameter[...] whose type is "
    "string, to type double'",
    bad=[
        {
            "robot.urdf": """
                <gazebo>
                  <plugin name="drive" filename="libgazebo_ros_diff_drive.so">
                    <leftJoint>shoulder</leftJoint>
                    <rightJoint>elbow</rightJoint>
                    <wheelSeparation>0.3</wheelSeparation>
                    <wheelDiameter>0.1</wheelDiameter>
                    «<updateRate>»fast</updateRate>
                  </plugin>
                </gazebo>
            """,
        },
        {
            "options": "--distro=humble",
            "robot.urdf": """
                <gazebo>
                  <plugin name="drive" filename="libgazebo_ros_diff_drive.so">
                    <left_joint>shoulder</left_joint>
                    <right_joint>elbow</right_joint>
                    «<wheel_separation>»</wheel_separation>
                    <wheel_diameter>0.1</wheel_diameter>
                    «<num_wheel_pairs>»one</num_wheel_pairs>
                    «<odometry_source>»2</odometry_source>
                    «<publish_odom>»yes</publish_odom>
                    «<publish_odom_tf>»</publish_odom_tf>
                  </plugin>
                </gazebo>
            """,
        },
    ],
    good=[
        {
            "robot.urdf": """
                <gazebo>
                  <plugin name="drive" filename="libgazebo_ros_diff_drive.so">
                    <leftJoint>shoulder</leftJoint>
                    <rightJoint>elbow</rightJoint>
                    <wheelSeparation>0.3</wheelSeparation>
                    <wheelDiameter>0.1</wheelDiameter>
                    <updateRate>50</updateRate>
                  </plugin>
                </gazebo>
            """,
        },
    ],
)
def plugin_setting_malformed(project: Project) -> Iterator[Finding]:
    """Malformed plugin setting.

    The value is not the number, boolean or choice that the plugin reads. Gazebo logs a single line, and the plugin uses
    0, false or its default instead.
    """
    for sim_plugin in loaded_plugins(project):
        children = sim_plugin.children
        for name, tag in sim_plugin.settings():
            child = children.get(name)
            problem = _problem(child, tag) if child and is_known(tag.text) else None
            if problem and (tag.text or is_written_empty(tag)):
                yield Finding(tag.at, f"<{name.removeprefix('ros/')}> of '{sim_plugin.filename}' {problem}")


def _problem(child: PluginChild, tag: Tag) -> str | None:
    text = tag.text
    if not text and child.type in ("double", "int", "bool"):
        return f"is empty; it must be {_WANTED[child.type]}"
    choices = child.validators.get("one_of")
    if isinstance(choices, list) and text not in [str(choice) for choice in choices]:
        return f"must be {in_words(str(choice) for choice in choices).replace(' and ', ' or ')}, not '{text}'"
    if child.type in ("double", "int") and number(text) is None:
        return f"must be {_WANTED[child.type]}, not '{text}'"
    if child.type == "bool" and text.lower() not in ("true", "false", "1", "0"):
        return f"must be {_WANTED['bool']}, not '{text}'"
    return None


_WANTED = {"double": "a number", "int": "an integer", "bool": "true or false"}
