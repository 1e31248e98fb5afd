"""UC701."""

from __future__ import annotations

from collections.abc import Iterator

from urdfctl.catalog.distros import since
from urdfctl.rule import Finding, Fix, Note, Project, Severity, rule
from urdfctl.rules.migration.facts import IN_GZ
from urdfctl.rules.simulation.common import Loaded, loaded, of_sensors

_WITHOUT = since("jazzy")


@rule(
    "UC701",
    severity=Severity.WARNING,
    distros=_WITHOUT,
    authority="gazebo_ros2_control README: Gazebo Classic is not released for Ubuntu Noble, and gazebo_ros_pkgs and "
    "gazebo_ros2_control not for jazzy and later; gz-sim src/SystemLoader.cc: 'couldn't find shared library'",
    options=["--distro=jazzy"],
    bad={
        "robot.urdf": """
            <gazebo>
              <plugin name="drive" filename="«libgazebo_ros_diff_drive.so»">
                <left_joint>shoulder</left_joint>
                <right_joint>elbow</right_joint>
              </plugin>
            </gazebo>
        """,
    },
    good={
        "robot.urdf": """
            <gazebo>
              <plugin filename="gz-sim-diff-drive-system" name="gz::sim::systems::DiffDrive">
                <left_joint>shoulder</left_joint>
                <right_joint>elbow</right_joint>
                <wheel_separation>0.3</wheel_separation>
                <wheel_radius>0.05</wheel_radius>
              </plugin>
            </gazebo>
        """,
    },
)
def gazebo_classic_gone(project: Project) -> Iterator[Finding]:
    """A plugin is one of Gazebo Classic, which this distro does not have.

    Gazebo Classic ended in January 2025, and has no release for jazzy and later. gz does not find its plugins: a robot
    whose controllers run in one is not controlled in the simulation.
    """
    if not set(project.distros) <= set(_WITHOUT):
        return
    everywhere = (*loaded(project), *of_sensors(project))
    classic = [one for one in everywhere if one.simulator == "gazebo-classic" and not one.known]
    both = any(one.hosts_control and one.simulator == "gz" for one in everywhere)
    first: dict[str, Loaded] = {}
    for one in classic:
        first.setdefault(one.library, one)
    for library, one in first.items():
        more = sum(other.library == library for other in classic) - 1
        message = f"'{one.filename}' is a plugin of Gazebo Classic, which there is not in {project.distros[0]} or later"
        notes = (Note(f"{more} more of it in this robot"),) if more else ()
        instead = IN_GZ.get(library)
        fix = Fix(f"in gz it is {instead}") if instead else None
        severity = Severity.INFO if both else Severity.ERROR if one.hosts_control else None
        yield Finding(one.plugin.at["filename"], message, notes, fix, severity)
