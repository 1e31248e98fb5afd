"""Draw a random system from a seed: one or two small robots, and what runs them."""

from __future__ import annotations

from dataclasses import replace
from random import Random

from systems.faults import plant
from systems.system import (
    BROADCASTER,
    CLASSIC,
    DRIVE,
    FORWARD,
    GROUP,
    GZ,
    TRAJECTORY,
    Controller,
    Joint,
    Robot,
    Spawn,
    System,
)

MODELS = ("heron", "kestrel", "otter", "ibex", "marten", "finch", "lynx", "stoat", "wren", "puffin", "tern", "vole")
_ARM_JOINTS = (
    ("shoulder_pan", "shoulder_lift", "elbow", "wrist_1", "wrist_2"),
    ("waist", "upper_arm", "forearm", "wrist_pitch", "wrist_roll"),
    ("axis_a", "axis_b", "axis_c", "axis_d", "axis_e"),
    ("base_yaw", "lift", "bend", "twist", "flange"),
)
_ENDINGS = ("", "_joint", "_motor")
_ARM_CONTROLLERS = (
    "arm_controller",
    "joint_trajectory_controller",
    "manipulator_controller",
    "arm_trajectory_controller",
)
_OTHER_CONTROLLERS = ("arm_position_controller", "forward_position_controller", "position_controller")
_BASE_CONTROLLERS = ("base_controller", "diff_drive_controller", "wheel_controller", "drive_controller")
_HAND_CONTROLLERS = ("gripper_controller", "hand_controller", "finger_controller")
_FLEETS = (("left", "right"), ("robot1", "robot2"), ("red", "blue"), ("alpha", "beta"))
_NAMESPACES = ("bot", "robot", "unit1", "cell", "arm_cell", "r1")


def draw(seed: int, *, is_faulty: bool | None = None) -> System:
    """Return the system of a seed. is_faulty: whether an inconsistency is planted; drawn, too, if None."""
    random = Random(f"system {seed}")  # noqa: S311 (nothing secret)
    generation = 2 if random.random() < 0.7 else 1
    distro = "noetic" if generation == 1 else random.choice(("humble", "humble", "jazzy", "jazzy", "kilted"))
    simulator = _simulator(random, generation, distro)
    moveit = generation == 2 and not simulator and random.random() < 0.2
    robots = _robots(random, generation, simulator, moveit=moveit)
    if len(robots) > 1 and simulator and distro == "humble":
        simulator, distro = GZ, "jazzy"  # before, robots of one simulator have the parameters of the first
    system = System(seed, generation, distro, simulator, robots, moveit)
    faulty = random.random() < 0.6
    return plant(system, random) if (faulty if is_faulty is None else is_faulty) else system


def _simulator(random: Random, generation: int, distro: str) -> str:
    if generation == 1:
        return random.choice((CLASSIC, CLASSIC, CLASSIC, ""))
    return random.choice(("", "", GZ, CLASSIC if distro == "humble" else GZ))


def _robots(random: Random, generation: int, simulator: str, *, moveit: bool) -> tuple[Robot, ...]:
    models = random.sample(MODELS, 2)
    first = drawn_robot(random, models[0], generation, simulator, is_arm=moveit)
    if moveit:
        return (_for_moveit(first),)
    if random.random() < 0.25:
        names = random.choice(_FLEETS)
        same = random.random() < 0.6
        second = first if same else drawn_robot(random, models[1], generation, simulator)
        prefixed = same and random.random() < 0.6
        one, other = (_named(robot, name, prefixed) for robot, name in zip((first, second), names, strict=True))
        is_rooted = random.random() < 0.25 and (generation == 1 or not simulator)
        return (replace(one, namespace="", section="") if is_rooted else one), other
    namespace = random.choice(_NAMESPACES) if random.random() < 0.35 else ""
    prefix = random.choice(("", "", "left_", f"{first.model}_"))
    return (replace(first, namespace=namespace, section=namespace, prefix=prefix),)


def _for_moveit(robot: Robot) -> Robot:
    """With controllers that MoveIt's demo starts: of states and of trajectories."""
    states, main, *others = robot.controllers
    controllers = (states, replace(main, family=TRAJECTORY), *others)
    return replace(robot, controllers=controllers, spawned=(Spawn(states.name), Spawn(main.name)))


def _named(robot: Robot, name: str, prefixed: bool) -> Robot:
    return replace(robot, name=name, namespace=name, section=name, prefix=f"{name}_" if prefixed else "")


def drawn_robot(random: Random, model: str, generation: int, simulator: str, *, is_arm: bool = False) -> Robot:
    """Return a random robot without namespace and prefix. is_arm: whether it is an arm without anything else."""
    parts = "arm" if is_arm else random.choice(("arm", "arm", "base", "arm hand", "base arm"))
    ending = random.choice(_ENDINGS)
    joints: list[Joint] = []
    states = "joint_state_controller" if generation == 1 else "joint_state_broadcaster"
    controllers = [Controller(states, BROADCASTER)]
    if "base" in parts:
        joints += _wheels(ending)
        controllers.append(_base(random, joints))
    if "arm" in parts:
        arm = _arm(random, ending, rich=generation == 2 and not simulator)
        joints += arm
        controllers += _arm_controllers(random, arm)
    if "hand" in parts:
        finger = Joint(f"finger{ending}", "prismatic", ("position",), joints[-1].name)
        joints.append(finger)
        controllers.append(Controller(random.choice(_HAND_CONTROLLERS), FORWARD, (finger.name,), "position"))
    custom = simulator == GZ and random.random() < 0.2  # no other plugin lets its manager be renamed
    manager = "control_manager" if custom else "controller_manager"
    spawned = _spawned(random, controllers)
    return Robot(model, model, tuple(joints), tuple(controllers), spawned, manager=manager, asked=manager)


def _wheels(ending: str) -> list[Joint]:
    return [Joint(f"{side}_wheel{ending}", "continuous", ("velocity",)) for side in ("left", "right")]


def _base(random: Random, wheels: list[Joint]) -> Controller:
    family = DRIVE if random.random() < 0.6 else GROUP
    return Controller(random.choice(_BASE_CONTROLLERS), family, tuple(joint.name for joint in wheels), "velocity")


def _arm(random: Random, ending: str, *, rich: bool) -> list[Joint]:
    names = [f"{name}{ending}" for name in random.choice(_ARM_JOINTS)[: random.randint(2, 5)]]
    commands = ("position", "velocity") if rich and random.random() < 0.4 else ("position",)
    return [Joint(name, "revolute", commands, before) for before, name in zip(["", *names], names, strict=False)]


def _arm_controllers(random: Random, arm: list[Joint]) -> list[Controller]:
    """One for the whole arm, and maybe another one that takes turns with it."""
    names = tuple(joint.name for joint in arm)
    family = random.choice((TRAJECTORY, TRAJECTORY, GROUP))
    found = [Controller(random.choice(_ARM_CONTROLLERS), family, names, "position")]
    if random.random() < 0.4:
        found.append(Controller(random.choice(_OTHER_CONTROLLERS), GROUP, names, "position"))
    return found


def _spawned(random: Random, controllers: list[Controller]) -> tuple[Spawn, ...]:
    """All that claim different joints are active; one that shares its joints is inactive, or not spawned."""
    taken: set[str] = set()
    found = []
    for controller in controllers:
        free = not taken & set(controller.joints)
        taken |= set(controller.joints)
        if free or random.random() < 0.5:
            found.append(Spawn(controller.name, free))
    return tuple(found)
