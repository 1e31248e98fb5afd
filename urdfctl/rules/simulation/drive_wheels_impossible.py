"""UC518."""

from __future__ import annotations

from collections.abc import Iterator

from urdfctl.rule import Finding, Project, Severity, rule
from urdfctl.rules.common import is_known
from urdfctl.rules.simulation.common import loaded, number, wheel_measures


@rule(
    "UC518",
    severity=Severity.WARNING,
    authority="gazebo_plugins gazebo_ros_diff_drive.cpp: wheel speeds are divided by wheelDiameter / 2; gz-sim DiffDrive.cc "
    "by wheel_radius",
    bad={
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
    good={
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
)
def drive_wheels_impossible(project: Project) -> Iterator[Finding]:
    """The wheels of a drive, or the distance between them, measure 0 or less.

    Speeds are divided by them: the wheels turn infinitely fast, backwards or not at all.
    """
    for one in loaded(project):
        measures = dict(wheel_measures(one)) if one.drives else {}
        for name, tag in one.settings():
            value = number(tag.text) if name in measures and is_known(tag.text) else None
            if value is not None and not value > 0:
                yield Finding(tag.at.content, f"<{name}> of '{one.filename}' is {tag.text} m, and must be more than 0")
