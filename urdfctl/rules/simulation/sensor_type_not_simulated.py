"""UC532."""

from __future__ import annotations

from collections.abc import Iterator

from urdfctl.rule import Finding, Project, Severity, rule
from urdfctl.rules.common import replaced

_ON_THE_CPU = ("ray", "lidar")
"""The types that sdformat reads as a lidar on the CPU."""
_DISTROS = ("humble", "iron", "jazzy", "kilted")
"""Those whose gz, from Fortress to Ionic, has no lidar on the CPU; Jetty has one (gz-sim systems/cpu_lidar)."""


def _robot(kind: str, simulator: str = "gz") -> dict[str, str]:
    return {
        "robot.urdf": f'<gazebo reference="fore"><sensor name="scan" type="{kind}"><topic>scan</topic></sensor></gazebo>',
        "options": f"--simulator={simulator}",
    }


@rule(
    "UC532",
    severity=Severity.WARNING,
    runtime="ignores",
    distros=_DISTROS,
    authority="gz-sim src/SdfEntityCreator.cc CreateEntities(const sdf::Sensor *): 'Sensor type LIDAR not supported yet. Try "
    "using a GPU LIDAR instead.' (Fortress to Ionic)",
    bad=[_robot("«ray»"), _robot("«lidar»")],
    good=[_robot("gpu_lidar"), _robot("camera"), _robot("ray", "gazebo-classic")],
)
def sensor_type_not_simulated(project: Project) -> Iterator[Finding]:
    """Sensor of a type that gz does not simulate.

    gz prints one line and makes no sensor: its topic is there, and nothing is ever published on it. Gazebo Classic measured
    lidars on the processor; gz renders them.
    """
    if project.robot is None or project.simulator != "gz":
        return
    for gazebo in project.robot.gazebos:
        for sensor in gazebo.tag.named("sensor"):
            kind, name = (sensor.attributes.get(key, "").strip() for key in ("type", "name"))
            if kind in _ON_THE_CPU:
                message = f"gz simulates no lidar of type '{kind}': sensor '{name}' publishes nothing"
                yield Finding(sensor.at["type"], message, fix=replaced(sensor.at["type"], kind, "gpu_lidar", safe=True))
