"""The measures of a steered vehicle, which Gazebo Classic's plugin measures itself and gz wants written."""

from __future__ import annotations

from collections.abc import Iterator, Mapping

from urdfctl.generate.robot.facts import JointFacts
from urdfctl.generate.robot.survey import facts_of
from urdfctl.generate.robot.wheels import across, along, radius
from urdfctl.generate.text.scalars import yaml_float
from urdfctl.migrate.edits.places import key_of, key_of_element
from urdfctl.migrate.packages import MigratedPackages
from urdfctl.migrate.todo import todo_line
from urdfctl.model.robot import Plugin
from urdfctl.source.xml.dom import Element

_REAR = ("rear_left_joint", "rear_right_joint")
_STEERING = ("left_steering_joint", "right_steering_joint")


def axles(packages: MigratedPackages, element: Element) -> Iterator[str]:
    """Yield the lines of gz's steering system with the measures of the vehicle, from a robot with the plugin.

    A measure that cannot be determined is a TODO.
    """
    joints = _joints(packages, element)
    rear, steering = [[joints[name]] if name in joints else [] for name in _REAR], _pair(joints)
    measures = {
        "wheel_separation": across(*rear),
        "kingpin_width": across(*steering),
        "wheel_base": along([*rear[0], *rear[1]], [*steering[0], *steering[1]]),
        "wheel_radius": radius([*rear[0], *rear[1]]),
    }
    for name, measure in measures.items():
        if measure.value is None:
            yield todo_line(element.source.path, f"measure the vehicle and write <{name}>, in m")
        else:
            yield f"<{name}>{yaml_float(measure.value)}</{name}>"


def _pair(joints: Mapping[str, JointFacts]) -> list[list[JointFacts]]:
    return [[joints[name]] if name in joints else [] for name in _STEERING]


def _joints(packages: MigratedPackages, element: Element) -> dict[str, JointFacts]:
    """The joints of a robot with the plugin, by the plugin's settings that name them."""
    for loaded in packages.loaded():
        robot = loaded.project.robot
        for plugin in robot.plugins if robot else ():
            if robot and key_of(plugin.at) == key_of_element(element):
                facts = {joint.name: joint for joint in facts_of(robot).joints}
                return dict(_named(plugin, facts))
    return {}


def _named(plugin: Plugin, facts: Mapping[str, JointFacts]) -> Iterator[tuple[str, JointFacts]]:
    for name in (*_REAR, *_STEERING):
        setting = plugin.setting(name)
        if setting is not None and setting.text in facts:
            yield name, facts[setting.text]
