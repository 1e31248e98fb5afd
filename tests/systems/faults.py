"""Inconsistencies that are planted in a system: what is changed, and which findings tell it."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import replace
from random import Random
from typing import NamedTuple

from systems.system import BROADCASTER, DRIVE, GROUP, Controller, Fault, Robot, Spawn, System

_GHOSTS = ("ghost_controller", "tool_controller", "head_controller")


def plant(system: System, random: Random) -> System:
    """Return a system with one random inconsistency in one of its robots."""
    kind = random.choice([kind for kind, found in FAULTS.items() if found.is_possible(system)])
    which = random.randrange(len(system.robots))
    sound = system.robots[which]
    robot, names = FAULTS[kind].planted(sound, random)
    robots = (*system.robots[:which], robot, *system.robots[which + 1 :])
    return replace(system, robots=robots, fault=Fault(kind, names, _touched(sound, robot)))


def _touched(sound: Robot, robot: Robot) -> tuple[str, ...]:
    """The controllers that are changed, with their joints before."""
    changed = [one for one in sound.controllers if one not in robot.controllers]
    return tuple(name for one in changed for name in (one.name, *(f"{sound.prefix}{each}" for each in one.joints)))


Planted = tuple[Robot, tuple[str, ...]]


class FaultKind(NamedTuple):
    """A kind of inconsistency.

    codes: of the findings that tell it.
    planted: returns a robot with it, and the names one of which a finding has to have.
    is_possible: whether it is a fault in a system: one that ROS refuses.
    is_sure: whether it is known to be one, so that it has to be an error.
    """

    codes: frozenset[str]
    planted: Callable[[Robot, Random], Planted]
    is_possible: Callable[[System], bool] = lambda _: True
    is_sure: Callable[[System], bool] = lambda _: True


def _with(robot: Robot, old: Controller, new: Controller) -> Robot:
    return replace(robot, controllers=tuple(new if one is old else one for one in robot.controllers))


def _claiming(robot: Robot) -> list[Controller]:
    return [one for one in robot.active if one.family != BROADCASTER]


def _unknown_joint(robot: Robot, random: Random) -> Planted:
    controller = random.choice(_claiming(robot))
    index = random.randrange(len(controller.joints))
    old = controller.joints[index]
    wrong = random.choice((f"{old[:-2]}{old[-1]}", f"{old}_2", f"spare_{index}"))
    joints = (*controller.joints[:index], wrong, *controller.joints[index + 1 :])
    return _with(robot, controller, replace(controller, joints=joints)), (f"{robot.prefix}{wrong}",)


def _missing_interface(robot: Robot, random: Random) -> Planted:
    controller = random.choice(_claiming(robot))
    if controller.family == DRIVE:  # its interface is always velocity: the wheels offer another one
        wheels = set(controller.joints)
        joints = tuple(
            replace(joint, commands=("position",)) if joint.name in wheels else joint for joint in robot.joints
        )
        # a description of its own: another robot may share the sound one
        return replace(robot, joints=joints, model=f"{robot.model}_mk2"), (
            controller.name,
            *(f"{robot.prefix}{name}" for name in wheels),
        )
    changed = replace(controller, interface="effort")
    names = (controller.name, *(f"{robot.prefix}{name}" for name in controller.joints))
    return _with(robot, controller, changed), names


def _undeclared(robot: Robot, random: Random) -> Planted:
    spawn = random.choice([one for one in robot.spawned if one.active][1:])
    if random.random() < 0.5:
        name = f"{spawn.name[:-2]}{spawn.name[-1]}"
        spawned = tuple(replace(one, name=name) if one is spawn else one for one in robot.spawned)
    else:
        name = random.choice(_GHOSTS)
        spawned = (*robot.spawned, Spawn(name))
    return replace(robot, spawned=spawned), (name,)


def _untyped(robot: Robot, random: Random) -> Planted:
    controller = random.choice(robot.active)
    return _with(robot, controller, replace(controller, typed=False)), (controller.name,)


def _conflict(robot: Robot, random: Random) -> Planted:
    controller = random.choice(_claiming(robot))
    rival = Controller("rival_controller", GROUP, controller.joints[-1:], controller.interface)
    controllers = (*robot.controllers, rival)
    return replace(robot, controllers=controllers, spawned=(*robot.spawned, Spawn(rival.name))), (
        rival.name,
        controller.name,
    )


def _other_manager(robot: Robot, random: Random) -> Planted:
    wrong = random.choice(("motion_manager", "controllers_manager", "robot_manager"))
    return replace(robot, asked=wrong), (wrong,)


def _other_section(robot: Robot, random: Random) -> Planted:
    wrong = random.choice(("other", "cart", "second"))
    names = (wrong, robot.manager, *(one.name for one in robot.controllers))
    return replace(robot, section=wrong), names


def _is_known_hardware(system: System) -> bool:
    """Whether it is known which interfaces there are: a driver of ROS 1 is a program of its own."""
    return system.generation == 2 or system.is_simulated


FAULTS = {
    "unknown joint": FaultKind(
        frozenset({"UC440", "UC450", "UC451", "UC462"}), _unknown_joint, is_sure=_is_known_hardware
    ),
    "missing interface": FaultKind(frozenset({"UC450", "UC461", "UC462"}), _missing_interface, _is_known_hardware),
    "undeclared controller": FaultKind(frozenset({"UC601"}), _undeclared),
    "missing type": FaultKind(frozenset({"UC420", "UC601"}), _untyped),
    "conflict": FaultKind(frozenset({"UC456"}), _conflict, lambda one: _is_known_hardware(one) and not one.moveit),
    "other manager": FaultKind(
        frozenset({"UC525", "UC601", "UC605", "UC606"}), _other_manager, lambda one: not one.moveit
    ),
    "other section": FaultKind(
        frozenset({"UC416", "UC420", "UC429", "UC431", "UC523", "UC524", "UC601"}), _other_section
    ),
}
"""The kinds of inconsistencies, by name."""
