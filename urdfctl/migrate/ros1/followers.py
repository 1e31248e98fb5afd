"""The joints that mimic another one, by URDF or by a simulator plugin: their states are read, nothing commands them."""

from __future__ import annotations

from collections.abc import Iterator

from urdfctl.migrate.packages import MigratedPackages
from urdfctl.migrate.shared.hardware import system
from urdfctl.model.project import Project
from urdfctl.model.robot import Plugin, Robot

MIMIC_PLUGINS = (
    "roboticsgroup_gazebo_mimic_joint_plugin",
    "roboticsgroup_upatras_gazebo_mimic_joint_plugin",
    "gazebo_mimic_joint_plugin",
    "mimic_joint_gazebo_plugin",
)
"""The libraries that make a joint follow another one in Gazebo Classic, because it does not read <mimic>."""


def is_mimic_plugin(filename: str | None) -> bool:
    """Return whether a simulator plugin makes a joint follow another one."""
    return (filename or "").removeprefix("lib").removesuffix(".so") in MIMIC_PLUGINS


def mimic_plugins(robot: Robot) -> Iterator[tuple[Plugin, str, str]]:
    """Yield the plugins for mimicking joints, each with the joint and the one that it follows."""
    for plugin in robot.plugins:
        leader, follower = plugin.setting("joint"), plugin.setting("mimicJoint")
        if is_mimic_plugin(plugin.filename) and leader is not None and follower is not None:
            yield plugin, follower.text, leader.text


def followers_of(packages: MigratedPackages, project: Project) -> dict[str, str]:
    """Return the joints that mimic another one, each with the parameters that the hardware plugin needs to know it."""
    robot = project.robot
    if robot is None:
        return {}
    found = {
        joint.name: joint.mimic.joint for joint in robot.joints if joint.name and joint.mimic and joint.mimic.joint
    }
    values = {joint.name: joint.mimic.multiplier for joint in robot.joints if joint.name and joint.mimic}
    found.update({follower: leader for _, follower, leader in mimic_plugins(robot)})
    named = system(packages).joint_parameters or {}
    texts = {}
    for follower, leader in found.items():
        multiplier = values.get(follower)
        given = {"mimic": leader, "multiplier": multiplier.text if multiplier else "1"}
        lines = (f'<param name="{name}">{value}</param>' for name, value in given.items() if name in named)
        texts[follower] = "\n".join(lines)
    return texts
