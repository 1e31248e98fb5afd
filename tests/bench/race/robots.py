"""The robots: those of the corpus by their names, and those made of as many links as are asked for."""

from __future__ import annotations

from functools import cached_property
from pathlib import Path
from typing import Any, NamedTuple

import yaml

from race.packages import Packages
from race.process import NotMeasured, environment

SAMPLES = Path(__file__).resolve().parents[3] / "samples"
PATHS = {
    "UR5e": "UniversalRobots__Universal_Robots_ROS2_Description/urdf/ur.urdf.xacro",
    "PR2": "PR2__pr2_common/pr2_description/robots/pr2.urdf.xacro",
}
CONTROLLERS = {"UR5e": "UniversalRobots__Universal_Robots_ROS2_Driver/ur_robot_driver/config/ur_controllers.yaml"}
CHAIN = 30
HEADER = """<?xml version="1.0"?>
<robot name="many" xmlns:xacro="http://www.ros.org/wiki/xacro">
  <xacro:property name="length" value="0.1"/>
  <xacro:property name="mass" value="0.5"/>
  <xacro:macro name="segment" params="n parent">
    <link name="link_${n}">
      <inertial>
        <origin xyz="0 0 ${length / 2}" rpy="0 0 0"/>
        <mass value="${mass}"/>
        <inertia ixx="${mass * length * length / 12}" ixy="0" ixz="0"
                 iyy="${mass * length * length / 12}" iyz="0" izz="${mass * 0.02 * 0.02 / 2}"/>
      </inertial>
      <visual>
        <origin xyz="0 0 ${length / 2}" rpy="0 0 0"/>
        <geometry><cylinder radius="0.02" length="${length}"/></geometry>
      </visual>
      <collision>
        <origin xyz="0 0 ${length / 2}" rpy="0 0 0"/>
        <geometry><cylinder radius="0.02" length="${length}"/></geometry>
      </collision>
    </link>
    <joint name="joint_${n}" type="revolute">
      <parent link="${parent}"/>
      <child link="link_${n}"/>
      <origin xyz="0 0 ${length}" rpy="0 0 0"/>
      <axis xyz="0 1 0"/>
      <limit lower="${-pi / 2}" upper="${pi / 2}" effort="10" velocity="2"/>
    </joint>
    <transmission name="transmission_${n}">
      <type>transmission_interface/SimpleTransmission</type>
      <joint name="joint_${n}">
        <hardwareInterface>hardware_interface/EffortJointInterface</hardwareInterface>
      </joint>
      <actuator name="motor_${n}">
        <mechanicalReduction>1</mechanicalReduction>
      </actuator>
    </transmission>
  </xacro:macro>
  <link name="base"/>
"""


class Robot(NamedTuple):
    """A description in its folder, with xacro's arguments and what else belongs to it."""

    folder: Path
    file: str
    arguments: tuple[str, ...] = ()
    controllers: tuple[str, ...] = ()

    @property
    def words(self) -> tuple[str, ...]:
        return self.file, *self.arguments


class Robots:
    """Looks robots up in the corpus, and makes others."""

    def __init__(self, corpus: Path, temp: Path) -> None:
        self.corpus, self.temp = corpus, temp

    @cached_property
    def index(self) -> list[dict[str, Any]]:
        file = self.corpus / "index.yaml"
        if not file.is_file():
            raise NotMeasured(f"{file} not found: name the corpus of public robots with --corpus")
        loader = getattr(yaml, "CSafeLoader", yaml.SafeLoader)
        roots: list[dict[str, Any]] = yaml.load(file.read_text(encoding="utf-8"), loader)["roots"]  # noqa: S506 (safe)
        return roots

    @cached_property
    def packages(self) -> Packages:
        return Packages(self.corpus, self.temp)

    def named(self, name: str) -> Robot:
        """UR5e, UR5e controllers, PR2, PR2 launched, or 1200 links.

        PR2 is linted in its own repository, where no launch file starts it. PR2 launched is linted among all
        repositories: five launch files start it there, and it is checked as each of them does.
        """
        first, _, second = name.partition(" ")
        if second == "links":
            return self.made(int(first))
        entry = next((e for e in self.index if e["path"] == PATHS[first]), None)
        if entry is None:
            raise NotMeasured(f"{PATHS[first]} is not in the corpus's index")
        arguments = tuple(f"{key}:={value}" for key, value in entry["args"].items())
        if first == "PR2" and not second:
            repository, _, file = PATHS[first].partition("/")
            return Robot(self.corpus / repository, file, arguments)
        controllers = (CONTROLLERS[first],) if second == "controllers" else ()
        return Robot(self.corpus, entry["path"], arguments, controllers)

    def made(self, links: int) -> Robot:
        folder = self.temp / f"made{links}"
        folder.mkdir(exist_ok=True)
        calls = (f'  <xacro:segment n="{n}" parent="{parent_of(n)}"/>\n' for n in range(links))
        (folder / "made.xacro").write_text(HEADER + "".join(calls) + "</robot>\n")
        return Robot(folder, "made.xacro")

    def of_corpus(self) -> list[Robot]:
        """All that expand, and need no arguments to do so."""
        return [Robot(self.corpus, e["path"]) for e in self.index if e["expands"] and not e["args"]]

    def environment(self, robot: Robot) -> dict[str, str]:
        """In which xacro finds what the robot includes."""
        file = robot.folder / robot.file
        return self.packages.environment(file) if self.corpus in file.parents else environment()


def parent_of(n: int) -> str:
    """Chains of CHAIN links, each out of the middle of the one before: branched, and not too deep for check_urdf."""
    if n == 0:
        return "base"
    return f"link_{n - 1}" if n % CHAIN else f"link_{n - CHAIN // 2}"
