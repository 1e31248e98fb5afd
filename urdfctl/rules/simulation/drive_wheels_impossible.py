"""UC518."""

from __future__ import annotations

from collections.abc import Iterator

from urdfctl.control.hardware.simulator_plugins import loaded_plugins
from urdfctl.rule import Finding, Project, Severity, rule
from urdfctl.rules.common import is_known
from urdfctl.rules.simulation.common import number, wheel_measures


@rule(
    "UC518",
    runtime="misbehaves",
    severity=Severity.WARNING,
    authority="gazebo_plugins gazebo_ros_diff_drive.cpp: wheel speeds are divided by wheelDiameter / 2; gz-sim DiffDrive.cc "
    "by wheel_radius",
    bad=[
        {
            "robot.urdf": """
                <gazebo>
                  <plugin name="drive" filename="libgazebo_ros_diff_drive.so">
                    <leftJoint>shoulder</leftJoint>
                    <rightJoint>elbow</rightJoint>
                    <wheelSeparation>0.3</wheelSeparation>
                    <wheelDiameter>«0»</wheelDiameter>
                  </plugin>
                </gazebo>
            """,
        },
        {
            "options": "--distro=jazzy",
            "robot.urdf": """
                <gazebo>
                  <plugin name="gz::sim::systems::MecanumDrive" filename="gz-sim-mecanum-drive-system">
                    <front_left_joint>shoulder</front_left_joint>
                    <front_right_joint>elbow</front_right_joint>
                    <back_left_joint>shoulder</back_left_joint>
                    <back_right_joint>elbow</back_right_joint>
                    <wheel_separation>«-0.3»</wheel_separation>
                    <wheelbase>«0»</wheelbase>
                    <wheel_radius>«-0.1»</wheel_radius>
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
                  </plugin>
                </gazebo>
            """,
        },
    ],
)
def drive_wheels_impossible(project: Project) -> Iterator[Finding]:
    """Wheel size or wheel separation of a drive is not positive.

    Speeds are divided by these values: the wheels turn infinitely fast, backwards or not at all.
    """
    for sim_plugin in loaded_plugins(project):
        measures = dict(wheel_measures(sim_plugin)) if sim_plugin.drives else {}
        for name, tag in sim_plugin.settings():
            value = number(tag.text) if name in measures and is_known(tag.text) else None
            if value is not None and not value > 0:
                yield Finding(
                    tag.at.content, f"<{name}> of '{sim_plugin.filename}' must be greater than 0 m, not {tag.text}"
                )
